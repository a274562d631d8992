//! The sizes of mind that there are: three profiles, each for robots of several forms.
//!
//! A mind has its capacities in its type, so that it needs no heap and fits a controller; what Python
//! chooses at run time is one of the types below.
//! Work is counted by the items and actions of the type, so a life depends on them.
//! That is why every world of the project has a form of exactly its size, in which a life in Python is
//! the life in Rust, and why other robots get the smallest form that holds them.

use cla_core::forest::{Capacities, Mind, MindConfig, MindError};
use cla_core::reason::Reason;

use crate::being::{Being, Life};

/// The names of the profiles, and what each is for.
pub(crate) const PROFILES: [(&str, &str); 3] = [
    (
        "standard",
        "7168 samples: the learner with which everything was measured",
    ),
    (
        "small",
        "1024 samples: what a controller with 64 KiB has room for",
    ),
    (
        "planner",
        "768 samples, and 1500 schemas with 1700 imagined states that plan and pursue goals",
    ),
];

/// Items and actions of the forms of each profile; those that hold any smaller robot come last.
const STANDARD: [(usize, usize); 9] = [
    (7, 6),
    (16, 4),
    (5, 3),
    (15, 5),
    (48, 6),
    (76, 10),
    (32, 8),
    (64, 12),
    (112, 24),
];
const SMALL: [(usize, usize); 4] = [(7, 6), (32, 8), (64, 12), (112, 24)];
const PLANNER: [(usize, usize); 5] = [(7, 6), (76, 10), (32, 8), (64, 12), (112, 24)];
/// Forms of each profile into which any smaller robot may go.
const ROOMY: usize = 3;

/// Why there is no such mind.
#[derive(Debug)]
pub(crate) enum Unfit {
    /// No profile has this name.
    Profile(String),
    /// The robot has more than any form.
    Robot(usize, usize),
    /// A configuration or a value cannot work.
    Mind(MindError),
}

impl std::fmt::Display for Unfit {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Profile(name) => {
                let known = PROFILES.map(|(name, _)| name).join(", ");
                write!(f, "there is no profile {name:?}: there are {known}")
            }
            Self::Robot(items, actions) => write!(
                f,
                "a robot has 1 to 112 items and 1 to 24 actions, not {items} and {actions}"
            ),
            Self::Mind(error) => error.fmt(f),
        }
    }
}

/// The form of a profile that is just as large, or the smallest that holds such a robot.
pub(crate) fn form(profile: &str, items: usize, actions: usize) -> Result<(usize, usize), Unfit> {
    let forms: &[(usize, usize)] = match profile {
        "standard" => &STANDARD,
        "small" => &SMALL,
        "planner" => &PLANNER,
        _ => return Err(Unfit::Profile(profile.to_owned())),
    };
    if items == 0 || actions == 0 {
        return Err(Unfit::Robot(items, actions));
    }
    let exact = forms.iter().find(|&&form| form == (items, actions));
    let roomy = forms.iter().skip(forms.len() - ROOMY);
    let mut large = roomy.filter(|form| form.0 >= items && form.1 >= actions);
    let found = exact.or_else(|| large.next());
    found.copied().ok_or(Unfit::Robot(items, actions))
}

/// 7168 samples, as in `host_sim::learner::mind`.
type Standard<const W: usize, const I: usize, const A: usize> =
    Mind<W, I, A, 448, 200, 512, 512, 2048>;
/// As the example `microworld` of host-sim.
type Planner<const W: usize, const I: usize, const A: usize> =
    Mind<W, I, A, 48, 64, 256, 64, 64, Reason<W, I, A, 150, 1500, 1700>>;
/// The capacities that go with 1024 samples.
const FEW: Capacities = Capacities::of(1024, 24);
type Small<const W: usize, const I: usize, const A: usize> =
    Mind<W, I, A, { FEW.stretches }, { FEW.leaves }, { FEW.rows }, { FEW.states }, { FEW.links }>;

/// A newborn mind of a profile; `values` has a number for every item.
///
/// # Errors
/// [`Unfit`].
pub(crate) fn born(
    profile: &str,
    config: MindConfig,
    values: &[f32],
    actions: usize,
    seed: u64,
) -> Result<Box<dyn Being>, Unfit> {
    macro_rules! one_of {
        ($(($name:literal, $items:literal, $actions:literal) => $mind:ty),* $(,)?) => {
            match (profile, form(profile, values.len(), actions)?) {
                $(($name, ($items, $actions)) => Life::<$mind>::born(config, values, actions, seed),)*
                _ => return Err(Unfit::Robot(values.len(), actions)),
            }
        };
    }
    one_of! {
        ("standard", 7, 6) => Standard<1, 7, 6>,
        ("standard", 16, 4) => Standard<1, 16, 4>,
        ("standard", 5, 3) => Standard<1, 5, 3>,
        ("standard", 15, 5) => Standard<1, 15, 5>,
        ("standard", 48, 6) => Standard<2, 48, 6>,
        ("standard", 76, 10) => Standard<3, 76, 10>,
        ("standard", 32, 8) => Standard<1, 32, 8>,
        ("standard", 64, 12) => Standard<2, 64, 12>,
        ("standard", 112, 24) => Standard<4, 112, 24>,
        ("small", 7, 6) => Small<1, 7, 6>,
        ("small", 32, 8) => Small<1, 32, 8>,
        ("small", 64, 12) => Small<2, 64, 12>,
        ("small", 112, 24) => Small<4, 112, 24>,
        ("planner", 7, 6) => Planner<1, 7, 6>,
        ("planner", 76, 10) => Planner<3, 76, 10>,
        ("planner", 32, 8) => Planner<1, 32, 8>,
        ("planner", 64, 12) => Planner<2, 64, 12>,
        ("planner", 112, 24) => Planner<4, 112, 24>,
    }
    .map_err(Unfit::Mind)
}

#[cfg(test)]
mod tests {
    use super::{MindConfig, PLANNER, PROFILES, SMALL, STANDARD, born, form};

    #[test]
    fn every_form_of_every_profile_is_born() {
        let all = [
            ("standard", &STANDARD[..]),
            ("small", &SMALL),
            ("planner", &PLANNER),
        ];
        assert_eq!(all.map(|(name, _)| name), PROFILES.map(|(name, _)| name));
        for (profile, forms) in all {
            for &(items, actions) in forms {
                let values = vec![1.0; items];
                assert!(born(profile, MindConfig::DEFAULT, &values, actions, 1).is_ok());
            }
        }
    }

    #[test]
    fn a_robot_gets_its_own_form_or_the_smallest_that_holds_it() {
        assert_eq!(form("standard", 7, 6).unwrap(), (7, 6));
        assert_eq!(form("standard", 7, 7).unwrap(), (32, 8));
        assert_eq!(form("small", 16, 4).unwrap(), (32, 8));
        assert_eq!(form("planner", 40, 3).unwrap(), (64, 12));
        assert_eq!(form("standard", 3, 24).unwrap(), (112, 24));
        for (items, actions) in [(113, 3), (7, 25), (0, 3), (7, 0)] {
            let sentence = form("small", items, actions).unwrap_err().to_string();
            assert!(
                sentence.contains("112 items and 1 to 24 actions"),
                "{sentence}"
            );
        }
        let sentence = form("huge", 7, 6).unwrap_err().to_string();
        assert!(sentence.contains("standard, small, planner"), "{sentence}");
    }
}
