//! A mind that is saved, loaded and gone on with lives the life that was never interrupted.

mod fixtures;

use cla_core::forest::{Mind, MindConfig};
use cla_core::num::Rng;
use cla_core::reason::{Pursuit, Reason, Reasoning};
use cla_core::snapshot::{self, LoadError, Names, SliceSink, Snapshot};
use cla_core::word::SignedItems;
use cla_core::{ActionId, ItemId, Percept};

type Small = Mind<1, 6, 3, 16, 12, 32, 48, 160>;
type Thinking = Mind<1, 6, 3, 16, 12, 32, 48, 160, Reason<1, 6, 3, 16, 32, 32>>;

/// A corridor of five places with a lamp at one end; `closed`, the way to it is blocked.
#[derive(Clone)]
struct Corridor {
    rng: Rng,
    place: u16,
    closed: bool,
}

impl Corridor {
    fn sense(&self) -> Percept<1> {
        let mut now = Percept::<1>::all_off(6);
        now.set(ItemId(self.place), Some(true)).unwrap();
        now.set(ItemId(5), Some(self.place == 4)).unwrap();
        now
    }

    /// Lives for so many actions; a fingerprint of all that was chosen and earned.
    fn live<R: Reasoning<1, 6, 3>>(
        &mut self,
        mind: &mut Mind<1, 6, 3, 16, 12, 32, 48, 160, R>,
        actions: u32,
    ) -> u64 {
        let mut hash = 0xcbf2_9ce4_8422_2325_u64;
        for step in 0..actions {
            let choice = mind.choose(&self.sense()).unwrap();
            let last = if self.closed { 3 } else { 4 };
            self.place = match choice.action.0 {
                _ if self.place == 4 || self.rng.chance(0.05) => self.rng.below(4) as u16,
                0 => self.place.saturating_sub(1),
                2 => (self.place + 1).min(last),
                _ => self.place,
            };
            let taught = mind.learn(&self.sense()).unwrap();
            if step % 41 == 7 {
                let before = self.sense();
                mind.observe(&before, ActionId(1), &self.sense()).unwrap();
            }
            for number in [
                u32::from(choice.action.0),
                choice.value.to_bits(),
                taught.reward.to_bits(),
            ] {
                hash = (hash ^ u64::from(number)).wrapping_mul(0x0000_0100_0000_01b3);
            }
        }
        hash
    }
}

fn image<B: Snapshot>(mind: &B) -> Vec<u8> {
    let mut image = vec![0; 1 << 18];
    let mut sink = SliceSink::new(&mut image);
    let length = snapshot::save(mind, Names::UNKNOWN, &mut sink).unwrap();
    image.truncate(length as usize);
    image
}

fn load<B: Snapshot>(mind: &mut B, image: &[u8]) -> Result<u32, LoadError<snapshot::SourceEnd>> {
    snapshot::load(mind, Names::UNKNOWN, &mut &*image)
}

fn born(seed: u64) -> (Box<Small>, Corridor) {
    let mut mind = Box::new(Small::new());
    let values = [0.0, 0.0, 0.0, 0.0, 0.0, 1.0];
    mind.be_born(MindConfig::DEFAULT, values, seed).unwrap();
    let corridor = Corridor {
        rng: Rng::new(seed + 10),
        place: 0,
        closed: false,
    };
    (mind, corridor)
}

#[test]
fn a_mind_goes_on_to_the_bit_from_training_from_acting_and_from_a_doubt() {
    let mut doubted = 0;
    for actions in [1, 57, 640, 3000, 4200, 4500] {
        let (mut mind, mut world) = born(3);
        world.live(&mut mind, actions.min(2000));
        if actions > 2000 {
            mind.act().unwrap();
            world.live(&mut mind, 2000);
            world.closed = true;
            world.live(&mut mind, actions - 2000);
            doubted += u32::from(mind.doubts());
        }
        let saved = image(&*mind);
        let (mut other, mut elsewhere) = born(77);
        elsewhere.live(&mut other, 900);
        assert_ne!(image(&*other), saved);
        assert_eq!(load(&mut *other, &saved), Ok(saved.len() as u32));
        assert_eq!(image(&*other), saved);
        let mut there = world.clone();
        for hundred in 0..20 {
            let (here, away) = (world.live(&mut mind, 100), there.live(&mut other, 100));
            assert_eq!(here, away, "{actions} and {hundred} hundred");
        }
        assert_eq!(image(&*mind), image(&*other));
    }
    assert!(doubted > 0);
}

#[test]
fn a_damaged_image_of_a_mind_is_refused_and_the_living_one_stays() {
    let (mut learned, mut world) = born(3);
    world.live(&mut learned, 2000);
    let whole = image(&*learned);
    let (mut mind, mut world) = born(4);
    world.live(&mut mind, 100);
    let before = image(&*mind);
    let mut rng = Rng::new(6);
    for _ in 0..2000 {
        let mut damaged = whole.clone();
        for _ in 0..1 + rng.below(6) {
            let bit = rng.below(whole.len() as u32 * 8) as usize;
            damaged[bit / 8] ^= 1 << (bit % 8);
        }
        if damaged != whole {
            assert!(load(&mut *mind, &damaged).is_err());
        }
    }
    for _ in 0..500 {
        let length = rng.below(whole.len() as u32) as usize;
        assert_eq!(
            load(&mut *mind, &whole[..length]),
            Err(LoadError::Truncated)
        );
    }
    assert_eq!(image(&*mind), before);
}

fn thinking(seed: u64) -> (Box<Thinking>, Corridor) {
    let (_, corridor) = born(seed);
    let mut mind = Box::new(Thinking::unborn());
    let values = [0.0, 0.0, 0.0, 0.0, 0.0, 1.0];
    mind.be_born(MindConfig::DEFAULT, values, seed).unwrap();
    (mind, corridor)
}

/// The goal of standing at one place.
fn place(item: u16) -> SignedItems<1> {
    let mut goal = SignedItems::EMPTY;
    goal.insert(ItemId(item), true).unwrap();
    goal
}

#[test]
fn a_mind_that_reasons_goes_on_to_the_bit_also_with_a_goal_before_it() {
    let mut underway = 0;
    for actions in [1, 30, 57, 300, 640, 1500] {
        let (mut mind, mut world) = thinking(3);
        world.live(&mut mind, actions);
        if actions % 2 == 0 {
            mind.pursue(place(actions as u16 / 10 % 4), 200, &world.sense())
                .unwrap();
        }
        underway += u32::from(mind.pursuit().is_underway());
        let saved = image(&*mind);
        let (mut other, mut elsewhere) = thinking(77);
        elsewhere.live(&mut other, 900);
        assert_ne!(image(&*other), saved);
        assert_eq!(load(&mut *other, &saved), Ok(saved.len() as u32));
        assert_eq!(image(&*other), saved);
        assert_eq!(other.pursuit(), mind.pursuit());
        let mut there = world.clone();
        for hundred in 0..15 {
            let (here, away) = (world.live(&mut mind, 100), there.live(&mut other, 100));
            assert_eq!(here, away, "{actions} and {hundred} hundred");
            assert_eq!(other.pursuit(), mind.pursuit());
        }
        assert_eq!(image(&*mind), image(&*other));
        assert_ne!(mind.pursuit(), Pursuit::Underway { left: 0 });
    }
    assert!(underway > 0);
    // One without a reason is another brain, and says what differs.
    let (mind, _) = thinking(3);
    let (mut plain, _) = born(3);
    let refused = load(&mut *plain, &image(&*mind)).unwrap_err().to_string();
    let sentence =
        "the image is of a brain with 16 remembered samples of an action, and this one has 0";
    assert_eq!(refused, sentence);
}

/// Written when version 1 was new, after 700 actions with a goal before it; it is never written again.
#[test]
fn the_image_of_a_reasoning_mind_of_every_version_is_read_for_ever() {
    let taken = |golden: &[u8]| {
        let (mut mind, world) = thinking(77);
        assert_eq!(load(&mut *mind, golden), Ok(golden.len() as u32));
        (mind, world)
    };
    for golden in fixtures::versions("corridor-v?.image", |golden| image(&*taken(golden).0)) {
        let (mut mind, mut world) = taken(&golden);
        assert_eq!(mind.pursuit(), Pursuit::Underway { left: 200 });
        assert_eq!((mind.size().0, mind.reason().schemas().len()), (256, 31));
        world.live(&mut mind, 500);
    }
}

/// Written with 0.2.0, after 700 actions; it is never written again.
#[test]
fn the_image_of_a_mind_without_a_reason_of_every_version_is_read_for_ever() {
    let taken = |golden: &[u8]| {
        let (mut mind, world) = born(77);
        assert_eq!(load(&mut *mind, golden), Ok(golden.len() as u32));
        (mind, world)
    };
    for golden in fixtures::versions("corridor-plain-v?.image", |it| image(&*taken(it).0)) {
        let (mut mind, mut world) = taken(&golden);
        assert_eq!((mind.size().0, mind.value(ItemId(5))), (256, 1.0));
        world.live(&mut mind, 500);
    }
}
