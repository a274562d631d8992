//! Methods of a [`Learner`](super::Learner) that are those of another one inside it.

/// Writes the named methods of a learner, which hand on to the learner at a place:
/// `within!(self => self.learner; act cost)`.
macro_rules! within {
    ($this:ident => $place:expr; $($method:ident)+) => {
        $(within!(@ $method $this $place);)+
    };
    (@ learn $this:ident $place:expr) => {
        fn learn(&mut $this, now: &crate::world::Percept) -> Result<(), crate::failure::Failure> {
            $crate::learner::Learner::learn(&mut $place, now)
        }
    };
    (@ learn_with $this:ident $place:expr) => {
        fn learn_with(
            &mut $this,
            now: &crate::world::Percept,
            reward: f32,
        ) -> Result<(), crate::failure::Failure> {
            $crate::learner::Learner::learn_with(&mut $place, now, reward)
        }
    };
    (@ interrupt $this:ident $place:expr) => {
        fn interrupt(&mut $this) -> Result<(), crate::failure::Failure> {
            $crate::learner::Learner::interrupt(&mut $place)
        }
    };
    (@ observe $this:ident $place:expr) => {
        fn observe(
            &mut $this,
            before: &crate::world::Percept,
            action: usize,
            after: &crate::world::Percept,
        ) -> Result<(), crate::failure::Failure> {
            $crate::learner::Learner::observe(&mut $place, before, action, after)
        }
    };
    (@ act $this:ident $place:expr) => {
        fn act(&mut $this) -> Result<(), crate::failure::Failure> {
            $crate::learner::Learner::act(&mut $place)
        }
    };
    (@ cost $this:ident $place:expr) => {
        fn cost(&$this) -> Option<cla_core::word::Cost> {
            $crate::learner::Learner::cost(&$place)
        }
    };
    (@ hear $this:ident $place:expr) => {
        fn hear(&mut $this, damage: &crate::world::damage::Damage) {
            $crate::learner::Learner::hear(&mut $place, damage);
        }
    };
    (@ reliabilities $this:ident $place:expr) => {
        fn reliabilities(&$this) -> Vec<f64> {
            $crate::learner::Learner::reliabilities(&$place)
        }
    };
    (@ predictions $this:ident $place:expr) => {
        fn predictions(&$this) -> (u32, u32) {
            $crate::learner::Learner::predictions(&$place)
        }
    };
    (@ alarms $this:ident $place:expr) => {
        fn alarms(&$this) -> u32 {
            $crate::learner::Learner::alarms(&$place)
        }
    };
    (@ worth $this:ident $place:expr) => {
        fn worth(&$this, now: &crate::world::Percept) -> $crate::learner::Worth {
            $crate::learner::Learner::worth(&$place, now)
        }
    };
    (@ image $this:ident $place:expr) => {
        fn image(
            &$this,
            names: cla_core::snapshot::Names,
        ) -> Result<Option<Vec<u8>>, crate::failure::Failure> {
            $crate::learner::Learner::image(&$place, names)
        }
    };
    (@ go_on_from $this:ident $place:expr) => {
        fn go_on_from(
            &mut $this,
            names: cla_core::snapshot::Names,
            image: &[u8],
        ) -> Result<u32, crate::failure::Failure> {
            $crate::learner::Learner::go_on_from(&mut $place, names, image)
        }
    };
    (@ reason $this:ident $place:expr) => {
        fn reason(&$this) -> $crate::learner::Thought {
            $crate::learner::Learner::reason(&$place)
        }
    };
}
