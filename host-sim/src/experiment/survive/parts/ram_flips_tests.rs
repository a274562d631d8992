//! When the life of a learner whose memory is hit is over.

use super::*;
use crate::learner::Thought;

/// A brain that refuses to learn once it acts, and is found so when it is looked through, but for the
/// first time, when there is no image yet.
#[derive(Clone)]
struct Refusing {
    within: Native<small::Brain>,
    found: Audit,
    looks: u32,
    acts: bool,
}

impl Exposed for Refusing {
    type Memory = small::Brain;

    fn memory(&mut self) -> &mut small::Brain {
        self.within.memory()
    }

    fn look_through(&mut self) -> Audit {
        self.looks += 1;
        if self.looks > 1 {
            self.found
        } else {
            Audit::Sound
        }
    }
}

impl Learner for Refusing {
    fn choose(&mut self, now: &Percept) -> Result<usize, Failure> {
        self.within.choose(now)
    }

    fn learn(&mut self, now: &Percept) -> Result<(), Failure> {
        if self.acts {
            return Err("it learns no more".into());
        }
        self.within.learn(now)
    }

    fn observe(&mut self, before: &Percept, action: usize, after: &Percept) -> Result<(), Failure> {
        self.within.observe(before, action, after)
    }

    fn act(&mut self) -> Result<(), Failure> {
        self.acts = true;
        self.within.act()
    }

    fn reason(&self) -> Thought {
        self.within.reason()
    }

    fn image(&self, names: Names) -> Result<Option<Vec<u8>>, Failure> {
        self.within.image(names)
    }

    fn go_on_from(&mut self, names: Names, image: &[u8]) -> Result<u32, Failure> {
        self.within.go_on_from(names, image)
    }
}

#[test]
fn a_brain_that_cannot_be_saved_is_damaged() {
    let mut brain = Box::new(small::brain());
    small::be_born(&mut brain, AgentConfig::RESILIENT_LEVEL2, 3).unwrap();
    let mut hit = Hit {
        learner: Native::new(brain, Adaptation::Relearning),
        care: Care::Nobody,
        hits: UNDISTURBED,
        lost: false,
        actions: 0,
        rng: Rng::stream(3, 75),
        scrub: Scrub::new(),
        image: Vec::new(),
        counts: Counts::default(),
    };
    assert!(!hit.is_damaged());
    // So many that a number becomes none.
    for bit in 0..faults::bits(hit.learner.memory()) {
        if hit.is_damaged() {
            break;
        }
        faults::flip(hit.learner.memory(), bit);
    }
    assert!(hit.is_damaged());
}

/// How many lives ended, of a learner that is found so when it looks itself through.
fn ended(found: Audit, care: &str, hits: &str) -> f64 {
    let mut brain = Box::new(small::brain());
    small::be_born(&mut brain, AgentConfig::RESILIENT_LEVEL2, 3).unwrap();
    let learner = Refusing {
        within: Native::new(brain, Adaptation::Relearning),
        found,
        looks: 0,
        acts: false,
    };
    let mut trial = Trial::default();
    lives("refusing", learner, Scale(200), 3, &mut trial).unwrap();
    trial.measured[&format!("ram_flips.refusing.{care}.{hits}.ended")][0]
}

#[test]
fn a_learner_that_is_refused_ends_its_life() {
    for care in ["unguarded", "audited", "scrubbed"] {
        assert_eq!(ended(Audit::Sound, care, "100"), LIVES as f64, "{care}");
    }
}

#[test]
fn a_learner_whose_brain_was_lost_has_nothing_to_learn_from_and_goes_on() {
    assert_eq!(ended(Audit::Lost("all of it"), "audited", "100"), 0.0);
    assert_eq!(
        ended(Audit::Lost("all of it"), "unguarded", "100"),
        LIVES as f64
    );
}
