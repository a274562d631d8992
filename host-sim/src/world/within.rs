//! Methods of a [`World`](super::World) that are those of another one inside it.

/// Writes the named methods of a world, which hand on to the world at a place:
/// `around!(self => self.world; items actions)`.
macro_rules! around {
    ($this:ident => $place:expr; $($method:ident)+) => {
        $(around!(@ $method $this $place);)+
    };
    (@ items $this:ident $place:expr) => {
        fn items(&$this) -> &'static [&'static str] {
            $place.items()
        }
    };
    (@ actions $this:ident $place:expr) => {
        fn actions(&$this) -> &'static [&'static str] {
            $place.actions()
        }
    };
    (@ sense $this:ident $place:expr) => {
        fn sense(&$this) -> crate::world::Percept {
            $place.sense()
        }
    };
    (@ act $this:ident $place:expr) => {
        fn act(&mut $this, action: usize) {
            $place.act(action);
        }
    };
    (@ reflex $this:ident $place:expr) => {
        fn reflex(&mut $this) -> Option<usize> {
            $place.reflex()
        }
    };
    (@ obtained $this:ident $place:expr) => {
        fn obtained(&$this) -> u32 {
            $place.obtained()
        }
    };
    (@ finished $this:ident $place:expr) => {
        fn finished(&$this) -> bool {
            $place.finished()
        }
    };
    (@ earned $this:ident $place:expr) => {
        fn earned(&$this) -> f64 {
            $place.earned()
        }
    };
    (@ episode_ended $this:ident $place:expr) => {
        fn episode_ended(&$this) -> bool {
            $place.episode_ended()
        }
    };
    (@ begin_episode $this:ident $place:expr) => {
        fn begin_episode(&mut $this) {
            $place.begin_episode();
        }
    };
    (@ suffer $this:ident $place:expr) => {
        fn suffer(
            &mut $this,
            fault: &crate::world::fault::Fault,
        ) -> Result<(), crate::world::fault::Unbreakable> {
            $place.suffer(fault)
        }
    };
}
