//! A world whose robot is damaged: wires are cut and crossed here, what breaks in the body is asked
//! of the world.

use cla_core::num::Rng;
use cla_core::word::ItemId;

use super::kinds::Damage;
use crate::world::fault::{Beam, Fault, Unbreakable};
use crate::world::{Percept, World};

/// What is left of the motion of a weak motor.
const WEAK: f64 = 0.5;

/// Any world, seen and moved through damaged parts.
///
/// Items that are unknown stay unknown, unless the part that is dead or stuck is theirs.
///
/// ```
/// use host_sim::world::World;
/// use host_sim::world::config::PioneerConfig;
/// use host_sim::world::damage::{Damage, Damaged};
/// use host_sim::world::pioneer::{ACTIONS, ITEMS, Pioneer};
/// let world = Pioneer::new(PioneerConfig::NOISY, 1)?;
/// let damage = Damage::parse("stuck:s3", &ITEMS, &ACTIONS)?;
/// let damaged = Damaged::new(world, damage, 1)?;
/// assert_eq!(damaged.sense().get(cla_core::word::ItemId(2)), Some(true));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct Damaged<W> {
    world: W,
    damage: Damage,
    /// An action that the world could not lose by itself.
    lost: Option<usize>,
    /// The share of actions that never reach a world without wheels.
    slip: f32,
    chance: Rng,
}

impl<W: World> Damaged<W> {
    /// Damages a world; `seed` decides the chance that some damages need.
    ///
    /// # Errors
    /// [`Unbreakable`] when the world has no part that could break so.
    pub fn new(mut world: W, damage: Damage, seed: u64) -> Result<Self, Unbreakable> {
        let (mut lost, mut slip) = (None, 0.0);
        match damage {
            Damage::Camera(degrees) => world.suffer(&Fault::Camera(degrees))?,
            Damage::Pull(degrees) => world.suffer(&Fault::Pull(degrees))?,
            Damage::Beam => world.suffer(&Fault::Beam(Beam::Blocked))?,
            Damage::Weak(part) => world.suffer(&Fault::Weak {
                action: part.index,
                gain: WEAK,
            })?,
            // Worlds without motors lose the command instead of the motion.
            Damage::Lost(part) => {
                let fault = Fault::Weak {
                    action: part.index,
                    gain: 0.0,
                };
                if world.suffer(&fault).is_err() {
                    lost = Some(part.index);
                }
            }
            Damage::Slip(share) => {
                if world.suffer(&Fault::Slip(share)).is_err() {
                    slip = share as f32;
                }
            }
            Damage::None
            | Damage::Shift(_)
            | Damage::Dead(_)
            | Damage::Stuck(_)
            | Damage::SwapItems(..)
            | Damage::SwapActions(..) => {}
        }
        Ok(Self {
            world,
            damage,
            lost,
            slip,
            chance: Rng::stream(seed, 4),
        })
    }

    /// The world behind the damage.
    pub const fn world(&self) -> &W {
        &self.world
    }

    /// The world behind the damage; what broke in its body stays broken.
    pub fn into_world(self) -> W {
        self.world
    }

    /// The number of items `s1`, `s2` … that stand first.
    fn sectors(&self) -> usize {
        let named = |(index, name): (usize, &&str)| *name == format!("s{}", index + 1);
        self.world
            .items()
            .iter()
            .enumerate()
            .take_while(|&it| named(it))
            .count()
    }
}

fn set(percept: &mut Percept, index: usize, state: Option<bool>) {
    // Indices come from the world's own list of items, which fits its percept.
    let _ = percept.set(ItemId(index as u16), state);
}

impl<W: World> World for Damaged<W> {
    around!(self => self.world;
        items actions reflex obtained finished earned episode_ended begin_episode suffer);

    fn sense(&self) -> Percept {
        let whole = self.world.sense();
        let state = |index: usize| whole.get(ItemId(index as u16));
        let mut percept = whole;
        match self.damage {
            Damage::Dead(part) => set(&mut percept, part.index, Some(false)),
            Damage::Stuck(part) => set(&mut percept, part.index, Some(true)),
            Damage::SwapItems(a, b) => {
                set(&mut percept, a.index, state(b.index));
                set(&mut percept, b.index, state(a.index));
            }
            Damage::Shift(places) => {
                let sectors = self.sectors();
                for index in 0..sectors {
                    let from = usize::try_from(index as i32 - places).ok();
                    let from = from.filter(|&from| from < sectors);
                    set(&mut percept, index, from.map_or(Some(false), state));
                }
            }
            _ => {}
        }
        percept
    }

    fn act(&mut self, action: usize) {
        let action = match self.damage {
            Damage::SwapActions(a, b) if action == a.index => b.index,
            Damage::SwapActions(a, b) if action == b.index => a.index,
            _ => action,
        };
        let slips = self.slip > 0.0 && self.chance.chance(self.slip);
        if self.lost != Some(action) && !slips {
            self.world.act(action);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Damage, Damaged, Percept, World};
    use crate::world::config::PioneerConfig;
    use crate::world::layout::Layout;
    use crate::world::microworld::{Body, Microworld};
    use crate::world::pioneer::{
        ACTIONS, BACKWARD, FORWARD, GRIP, INGRIP, ITEMS, Pioneer, TURN_LEFT, TURN_RIGHT,
    };
    use cla_core::word::ItemId;

    fn damage(text: &str) -> Damage {
        Damage::parse(text, &ITEMS, &ACTIONS).unwrap()
    }

    fn room(specimen: &str) -> Pioneer {
        let layout = Layout::parse(&format!("0\n{specimen}\n"), 5.0).unwrap();
        Pioneer::with_layout(PioneerConfig::NOISE_FREE, &layout, 1).unwrap()
    }

    fn damaged(specimen: &str, text: &str) -> Damaged<Pioneer> {
        Damaged::new(room(specimen), damage(text), 1).unwrap()
    }

    fn on(percept: &Percept) -> Vec<u16> {
        percept.on().iter().map(|item| item.0).collect()
    }

    /// Ahead, two metres off: s3 in a whole robot.
    const AHEAD: &str = "2 0";

    #[test]
    fn sensors_lie_as_they_were_told_to() {
        for (text, seen) in [
            ("none", vec![2]),
            ("dead:s3", vec![]),
            ("stuck:s1", vec![0, 2]),
            ("swap:s3,s5", vec![4]),
            ("shift:1", vec![3]),
            ("shift:-2", vec![0]),
            ("shift:3", vec![]),
            ("camera:+12", vec![3]),
            ("camera:-12", vec![1]),
            ("camera:+24", vec![4]),
            ("camera:+180", vec![]),
        ] {
            assert_eq!(on(&damaged(AHEAD, text).sense()), seen, "{text}");
        }
    }

    #[test]
    fn a_camera_turned_by_half_a_sector_is_no_permutation_of_items() {
        // 4° to the left of the heading is s3 for a whole robot and for one turned 6° alike; 8° is
        // s2 for the first and s3 for the second.
        for (specimen, whole, turned) in [("2 0.14", 2, 2), ("2 0.28", 1, 2)] {
            assert_eq!(on(&damaged(specimen, "none").sense()), [whole]);
            assert_eq!(on(&damaged(specimen, "camera:+6").sense()), [turned]);
        }
    }

    fn heading(world: &Damaged<Pioneer>) -> f64 {
        world.world().robot().heading().to_degrees()
    }

    #[test]
    fn motors_fail_in_the_body() {
        let after = |text: &str, action: usize| {
            let mut world = damaged("0 3", text);
            world.act(action);
            let position = world.world().robot().position;
            (position.x, position.y, heading(&world))
        };
        let near = |a: f64, b: f64| (a - b).abs() < 1e-9;
        assert!(near(after("none", TURN_LEFT).2, 5.0));
        assert!(near(after("weak:turnl", TURN_LEFT).2, 2.5));
        assert!(near(after("weak:turnl", TURN_RIGHT).2, -5.0));
        assert!(near(after("lost:turnl", TURN_LEFT).2, 0.0));
        assert!(near(after("swap:turnl,turnr", TURN_LEFT).2, -5.0));
        assert!(near(after("weak:forward", FORWARD).0, 0.25));
        let (x, y, turned) = after("pull:8", FORWARD);
        assert!(near(turned, 8.0) && y > 0.02 && y < 0.05 && x > 0.49 && x < 0.5);
        // Backing out undoes the turn.
        assert!(near(after("pull:8", BACKWARD).2, -8.0));
    }

    #[test]
    fn wheels_slip_in_the_share_that_was_said() {
        let mut world = damaged("0 3", "slip:0.2");
        let mut still = 0;
        for action in [TURN_LEFT, TURN_RIGHT].into_iter().cycle().take(2000) {
            let before = heading(&world);
            world.act(action);
            still += u32::from((heading(&world) - before).abs() < 1e-9);
        }
        // 400 expected, standard deviation 18.
        assert!((330..=470).contains(&still), "{still}");
    }

    #[test]
    fn a_robot_that_does_not_feel_what_it_grips_is_still_told_that_it_gripped() {
        let mut world = damaged("0.5 0", "dead:ingrip");
        world.act(FORWARD);
        assert_eq!(world.sense().get(ItemId(INGRIP)), Some(false));
        assert_eq!(world.reflex(), Some(GRIP));
        assert_eq!(world.obtained(), 1);
    }

    #[test]
    fn a_blocked_beam_reports_something_for_ever_and_its_reflex_ends() {
        let mut world = damaged(AHEAD, "beam");
        for _ in 0..20 {
            world.act(FORWARD);
            assert_eq!(world.sense().get(ItemId(INGRIP)), Some(true));
            let reflexes = (0..100).take_while(|_| world.reflex().is_some()).count();
            assert!((1..=3).contains(&reflexes), "{reflexes}");
        }
        // What stops at a broken beam hardly moves.
        assert!(world.world().robot().position.x < 0.5);
        assert_eq!(world.obtained(), 0);
    }

    #[test]
    fn worlds_without_a_body_lose_actions_too_but_have_no_camera() {
        let act = |text: &str, action: usize| {
            let world = Microworld::new(1, Body::Visible, 0.0);
            let (items, actions) = (world.items(), world.actions());
            let damage = Damage::parse(text, items, actions).unwrap();
            let mut world = Damaged::new(world, damage, 1).unwrap();
            let before = world.sense();
            world.act(action);
            before == world.sense()
        };
        let moves = (0..10).find(|&action| !act("none", action)).unwrap();
        let name = Microworld::new(1, Body::Visible, 0.0).actions()[moves];
        assert!(act(&format!("lost:{name}"), moves));
        assert!(act("slip:1", moves));
        let refused = Damaged::new(
            Microworld::new(1, Body::Visible, 0.0),
            Damage::Camera(12.0),
            1,
        );
        assert!(refused.is_err());
    }
}
