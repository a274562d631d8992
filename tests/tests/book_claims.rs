//! The committed results of the studies of chapter 7 are what the program measures: seeds that the
//! commit chooses are lived again, and every number must be the same to the last bit.

mod lived;

use cla_tests::claims::two_of;
use host_sim::experiment::aliased::{Aliased, AliasedOptions, Place, Trial};
use host_sim::experiment::modules::{Modules, ModulesOptions};
use host_sim::experiment::neighbours::{Neighbours, NeighboursOptions};
use host_sim::experiment::plan::{Experiment, trials};
use host_sim::experiment::record::judged_again;
use host_sim::experiment::words::{Words, WordsOptions};
use host_sim::progress::Progress;
use host_sim::report::{Estimator, Summary};
use lived::{assert_same_measurements, committed};

const ALIASED: &str = include_str!("../claims/aliased.json");
const MODULES: &str = include_str!("../claims/modules.json");
const NEIGHBOURS: &str = include_str!("../claims/neighbours.json");
const WORDS: &str = include_str!("../claims/words.json");

/// The room and two worlds of files, seconds a seed; the others and the hallway's plan take longer.
const WORLDS: [Place; 3] = [Place::Barriers, Place::Shuttle, Place::Cheese];

/// Claims against a rival, and those of whom it is the one with the best mean of all seeds.
const RIVALS: [(&str, &[&str]); 3] = [
    ("over_sarsa", &["sarsa", "sarsa_2", "sarsa_4"]),
    ("over_memoryless", &["q", "sarsa"]),
    ("over_history", &["q_2", "sarsa_2", "q_4", "sarsa_4"]),
];

#[test]
fn two_infants_hear_the_same_words_again() {
    let committed = committed(WORDS);
    // As many as in the study.
    assert_eq!(committed.seeds.len(), 24);
    let seeds = two_of(committed.seeds.len(), WORDS).map(|place| committed.seeds[place]);
    let again = judged_again::<Words>(&WordsOptions::standard(seeds.to_vec()));
    let mut again = again.expect("the study runs").summary;
    assert_eq!(again.parameters, committed.parameters);
    // An effect is one of all infants together.
    again.claims.retain(|it| it.estimator != Estimator::Count);
    let compared = assert_same_measurements(&again, &committed);
    assert_eq!(compared, again.claims.len());
    assert_eq!(compared, 5);
}

#[test]
fn two_seeds_ask_the_same_neighbours_again() {
    let committed = committed(NEIGHBOURS);
    assert_eq!(committed.seeds.len(), 20);
    let seeds = two_of(committed.seeds.len(), NEIGHBOURS).map(|place| committed.seeds[place]);
    let options = NeighboursOptions::new(seeds.to_vec(), None).expect("what was kept");
    let again = judged_again::<Neighbours>(&options);
    let again = again.expect("the study runs").summary;
    assert_eq!(again.parameters, committed.parameters);
    let compared = assert_same_measurements(&again, &committed);
    assert_eq!(compared, again.claims.len());
    assert_eq!(compared, 10);
}

#[test]
fn a_seed_has_the_same_modules_again() {
    let committed = committed(MODULES);
    assert_eq!(committed.seeds.len(), 20);
    let [_, place] = two_of(committed.seeds.len(), MODULES);
    let seeds = vec![committed.seeds[place]];
    let options = ModulesOptions::new(seeds, None).expect("what was kept");
    let again = judged_again::<Modules>(&options);
    let mut again = again.expect("the study runs").summary;
    assert_eq!(again.parameters, committed.parameters);
    // Of all seeds together, which one seed does not have.
    again.claims.retain(|it| it.estimator != Estimator::Count);
    let compared = assert_same_measurements(&again, &committed);
    assert_eq!(compared, again.claims.len());
    assert!(compared > 40, "{compared}");
}

#[test]
fn two_seeds_live_the_same_lives_again_where_places_look_alike() {
    let committed = committed(ALIASED);
    assert_eq!(committed.seeds.len(), 20);
    let places = two_of(committed.seeds.len(), ALIASED);
    let seeds = places.map(|place| committed.seeds[place]);
    let options = AliasedOptions {
        places: WORLDS.to_vec(),
        ..AliasedOptions::standard(seeds.to_vec())
    };
    let trials = trials::<Aliased>(&options, &Progress::hidden()).expect("lives are lived");
    let again = Aliased::judge(&options, &trials).expect("lives are judged");
    let mut again = again.summary;
    let lengths = "lives shorter by";
    assert_eq!(again.parameters[lengths], committed.parameters[lengths]);
    assert_eq!(assert_same_rivals(&trials, places, &committed), 10);
    let mut alone = committed.clone();
    for summary in [&mut again, &mut alone] {
        for claim in &mut summary.claims {
            if claim.id.contains(".over_") {
                claim.against = None;
            }
        }
    }
    let compared = assert_same_measurements(&again, &alone);
    assert_eq!(compared, again.claims.len());
    assert_eq!(compared, 18);
}

/// Which rival is best is said by all seeds and not by two, but these two must be lives of the same one;
/// answers how many claims were compared.
fn assert_same_rivals(trials: &[Trial], places: [usize; 2], committed: &Summary) -> usize {
    let mut compared = 0;
    for world in WORLDS {
        for (name, rivals) in RIVALS {
            for who in ["", "level2."] {
                let id = format!("aliased.{}.{who}{name}", world.name());
                let claim = committed.find(&id);
                let Some(against) = claim.and_then(|it| it.against.as_ref()) else {
                    continue;
                };
                compared += 1;
                let is = |rival: &&str| {
                    let mut lives = places.iter().zip(trials);
                    lives.all(|(&place, trial)| against[place] == Some(trial.last(world, rival)))
                };
                assert!(rivals.iter().any(is), "{id}");
            }
        }
    }
    compared
}
