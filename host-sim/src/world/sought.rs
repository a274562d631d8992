//! Worlds in which one item is what is sought: it is obtained whenever it comes on.

use cla_core::word::ItemId;

use super::World;

/// Any world, rewarded by one of its items and by nothing else.
///
/// ```
/// use host_sim::world::World;
/// use host_sim::world::microworld::{Body, Microworld, action};
/// use host_sim::world::sought::Sought;
/// let world = Microworld::new(1, Body::Visible, 0.0);
/// let hand_closed = world.items().iter().position(|&it| it == "hcl").unwrap();
/// let mut world = Sought::new(world, hand_closed);
/// let (grasp, ungrasp) = (action("grasp").unwrap(), action("ungrasp").unwrap());
/// for action in [ungrasp, grasp, grasp, ungrasp, grasp] {
///     world.act(action);
/// }
/// assert_eq!(world.obtained(), 2);
/// ```
#[derive(Clone, Debug)]
pub struct Sought<W> {
    world: W,
    item: ItemId,
    was_on: bool,
    obtained: u32,
}

impl<W: World> Sought<W> {
    /// Seeks the item with this index; one that the world does not have never comes on.
    #[must_use]
    pub fn new(world: W, item: usize) -> Self {
        let item = ItemId(u16::try_from(item).unwrap_or(u16::MAX));
        Self {
            was_on: world.sense().get(item) == Some(true),
            world,
            item,
            obtained: 0,
        }
    }

    fn look(&mut self) {
        let on = self.world.sense().get(self.item) == Some(true);
        self.obtained += u32::from(on && !self.was_on);
        self.was_on = on;
    }
}

impl<W: World> World for Sought<W> {
    around!(self => self.world; items actions sense finished episode_ended suffer);

    fn act(&mut self, action: usize) {
        self.world.act(action);
        self.look();
    }

    fn reflex(&mut self) -> Option<usize> {
        let fired = self.world.reflex();
        self.look();
        fired
    }

    fn obtained(&self) -> u32 {
        self.obtained
    }

    fn begin_episode(&mut self) {
        self.world.begin_episode();
        self.was_on = self.world.sense().get(self.item) == Some(true);
    }
}
