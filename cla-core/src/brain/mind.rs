//! The module that [`brain!`](crate::brain!) makes for the one learner: the robot's own types about a
//! [`Mind`](crate::forest::Mind).

#[doc(hidden)]
#[macro_export]
macro_rules! brain_with_a_mind {
    // A percept that no brain of another robot takes.
    (@percept) => {
        /// What the robot's sensors report; no other robot's brain takes it.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub struct Percept($crate::word::ItemStates<WORDS>);

        impl Percept {
            /// Nothing is known.
            pub const UNKNOWN: Self = Self($crate::word::ItemStates::UNKNOWN);

            /// These items are on and all others off.
            #[must_use]
            pub fn of(on: &[Item]) -> Self {
                percept(|item| on.contains(&item))
            }

            /// The state of an item; `None` when it is unknown.
            #[must_use]
            pub fn get(&self, item: Item) -> Option<bool> {
                self.0.get(item.id())
            }

            /// The same with an item on, off, or unknown.
            #[must_use]
            pub fn with(mut self, item: Item, state: Option<bool>) -> Self {
                // An item of the robot fits its percept.
                let _ = self.0.set(item.id(), state);
                self
            }

            /// As the learner takes it, without the robot's names.
            #[must_use]
            pub const fn states(&self) -> &$crate::word::ItemStates<WORDS> {
                &self.0
            }
        }

        impl From<$crate::word::ItemStates<WORDS>> for Percept {
            fn from(states: $crate::word::ItemStates<WORDS>) -> Self {
                Self(states)
            }
        }

        /// What the sensors report: each item is asked for, and is on, off, or unknown (`None`).
        #[must_use]
        pub fn percept<S: Into<Option<bool>>>(mut sense: impl FnMut(Item) -> S) -> Percept {
            let mut now = Percept::UNKNOWN;
            for &item in ITEMS {
                now = now.with(item, sense(item).into());
            }
            now
        }
    };
    // The learner, spoken to in the robot's own words.
    (@brain) => {
        /// The brain: a [`Mind`] that takes this robot's percepts and answers with its actions.
        ///
        /// What is not said in names, it says as the mind that it is (`Deref`).
        #[derive(Clone, Debug)]
        pub struct Brain(Mind);

        /// An action of the robot, and why.
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct Choice {
            /// What to do.
            pub action: Action,
            /// What the leading voice holds it to be worth, in discounted rewards.
            pub value: f32,
            /// Who decided.
            pub motive: $crate::forest::Motive,
        }

        impl Brain {
            fn named(choice: $crate::forest::Deliberation) -> Choice {
                const FIRST: Action = ACTIONS[0];
                Choice {
                    // A mind of so many actions chooses one of them.
                    action: Action::of(choice.action).unwrap_or(FIRST),
                    value: choice.value,
                    motive: choice.motive,
                }
            }

            /// What to do now.
            ///
            /// # Errors
            /// `MindError::Unborn`.
            pub fn choose(&mut self, now: &Percept) -> Result<Choice, $crate::forest::MindError> {
                self.0.choose(&now.0).map(Self::named)
            }

            /// What to do now, of the actions that are allowed.
            ///
            /// # Errors
            /// `MindError::Unborn`, or `MindError::NothingAllowed`.
            pub fn choose_among(
                &mut self,
                now: &Percept,
                allowed: &[Action],
            ) -> Result<Choice, $crate::forest::MindError> {
                let allowed = allowed
                    .iter()
                    .fold($crate::forest::Actions::NONE, |set, action| set.with(action.id()));
                self.0.choose_among(&now.0, allowed).map(Self::named)
            }

            /// The action that was chosen last has led to `now`.
            ///
            /// # Errors
            /// `MindError::Unborn`, or `MindError::NothingChosen`.
            pub fn learn(
                &mut self,
                now: &Percept,
            ) -> Result<$crate::forest::Taught, $crate::forest::MindError> {
                self.0.learn(&now.0)
            }

            /// The same, and it brought a reward, or harm, beside that of the valued items.
            ///
            /// # Errors
            /// As `learn`, and `MindError::Reward`.
            pub fn learn_with(
                &mut self,
                now: &Percept,
                reward: f32,
            ) -> Result<$crate::forest::Taught, $crate::forest::MindError> {
                self.0.learn_with(&now.0, reward)
            }

            /// From now on it is worth so much when an item is on after an action, negative for harm.
            ///
            /// # Errors
            /// `MindError::Unborn`, or `MindError::Reward`.
            pub fn revalue(&mut self, item: Item, value: f32) -> Result<(), $crate::forest::MindError> {
                self.0.revalue(item.id(), value)
            }

            /// Somebody else's action, a reflex or a teacher, has led from `before` to `after`.
            ///
            /// # Errors
            /// `MindError::Unborn`.
            pub fn observe(
                &mut self,
                before: &Percept,
                action: Action,
                after: &Percept,
            ) -> Result<$crate::forest::Taught, $crate::forest::MindError> {
                self.0.observe(&before.0, action.id(), &after.0)
            }
        }

        impl core::ops::Deref for Brain {
            type Target = Mind;

            fn deref(&self) -> &Mind {
                &self.0
            }
        }

        impl core::ops::DerefMut for Brain {
            fn deref_mut(&mut self) -> &mut Mind {
                &mut self.0
            }
        }
    };
    (@safely) => {};
    (@safely $safe:ident) => {
        impl Brain {
            /// What to do now, whatever happens: [`SAFE`] when the brain cannot choose.
            pub fn choose_or_safe(&mut self, now: &Percept) -> Action {
                self.choose(now).map_or(SAFE, |choice| choice.action)
            }
        }
    };
    (@goals) => {};
    (@goals $imagines:expr) => {
        impl Brain {
            /// Pursues a goal, these items on and those off, for at most so many actions.
            ///
            /// # Errors
            /// `MindError::Unborn`.
            pub fn pursue(
                &mut self,
                on: &[Item],
                off: &[Item],
                most: u16,
                now: &Percept,
            ) -> Result<$crate::reason::Pursuit, $crate::forest::MindError> {
                self.0.pursue(goal(on, off), most, &now.0)
            }

            /// How far the goal is from here.
            #[must_use]
            pub fn way(&self, now: &Percept) -> $crate::reason::Way {
                self.0.way(&now.0)
            }
        }
    };
    (
        { $(#[$meta:meta])* $visibility:vis mod $name:ident } [$($seen:ident)*]
        { $($item:ident)+ } { $($action:ident)+ } { $($valued:ident = $value:expr,)+ }
        { $ram:expr } { $samples:expr } { $($imagines:expr)? } { $($safe:ident)? } { $($states:expr)? }
    ) => {
        $(#[$meta])*
        $visibility mod $name {
            $crate::brain_words! { @words [$($item)+] [$($action)+] }
            $crate::brain_words! { @safe $($safe)? }
            $crate::brain_with_a_mind! { @percept }

            /// What it is worth when an item is on after an action, negative for harm.
            pub const VALUES: [f32; ITEMS.len()] = {
                let mut values = [0.0; ITEMS.len()];
                $(values[Item::$valued as usize] = $value;)+
                values
            };

            // What stands twice is pointed at by the compiler, and so is a value that is no value.
            const _: () = {
                #[allow(dead_code, non_camel_case_types)]
                enum Keys { $($seen),+ }
                #[allow(dead_code, non_camel_case_types)]
                enum Valued { $($valued),+ }
                $(
                    let value: f32 = $value;
                    assert!(
                        value >= -$crate::forest::MOST_REWARD && value <= $crate::forest::MOST_REWARD,
                        concat!("the value of `", stringify!($valued), "` is not within ten thousand")
                    );
                )+
            };

            const CAPACITIES: $crate::forest::Capacities =
                $crate::forest::Capacities::of($samples, ACTIONS.len())$(.with_states($states))?;

            /// The learner under these names.
            pub type Mind = $crate::forest::Mind<
                WORDS,
                { ITEMS.len() },
                { ACTIONS.len() },
                { CAPACITIES.stretches },
                { CAPACITIES.leaves },
                { CAPACITIES.rows },
                { CAPACITIES.states },
                { CAPACITIES.links },
                $crate::brain_words!(@reason $($imagines)?),
            >;

            $crate::brain_with_a_mind! { @brain }
            $crate::brain_with_a_mind! { @safely $($safe)? }
            $crate::brain_with_a_mind! { @goals $($imagines)? }
            $crate::brain_words! { @ram $ram }

            /// A brain before its birth: all memory zero.
            #[must_use]
            pub const fn brain() -> Brain {
                Brain(Mind::unborn())
            }

            /// A brain's birth: what is in `VALUES` is worth having, or harm, from now on.
            ///
            /// # Errors
            /// `MindError` for a configuration that cannot work; the brain is as it was.
            pub fn be_born(
                brain: &mut Brain,
                config: $crate::forest::MindConfig,
                seed: u64,
            ) -> Result<(), $crate::forest::MindError> {
                brain.0.be_born(config, VALUES, seed)
            }
        }
    };
}
