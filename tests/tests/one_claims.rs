//! The committed results of `one` are what the program measures: a seed that the commit chooses is
//! lived again, and every number must be the same to the last bit.

mod lived;

use cla_tests::claims::two_of;
use host_sim::experiment::one::{One, OneOptions};
use host_sim::experiment::record::judged_again;
use lived::{assert_same_measurements, committed};

const ONE: &str = include_str!("../claims/one.json");

/// Numbers of all seeds at once, which one seed does not have.
const OF_ALL_SEEDS: [&str; 5] = [
    "one.recover.family.size",
    "one.recover.family.ahead",
    "one.recover.family.behind",
    "one.recover.not_back",
    "one.recover.over_newborn",
];

#[test]
fn a_seed_that_the_commit_chooses_is_lived_the_same_again() {
    let committed = committed(ONE);
    let [place, _] = two_of(committed.seeds.len(), ONE);
    let options = OneOptions::standard(vec![committed.seeds[place]]);
    let mut again = judged_again::<One>(&options)
        .expect("the experiment runs")
        .summary;
    again
        .claims
        .retain(|it| it.against.is_some() || it.unit != "bytes");
    // The rival in worlds by chance is chosen by the mean of all seeds.
    let of_one = |id: &str| !OF_ALL_SEEDS.contains(&id) && id != "one.generated";
    again.claims.retain(|it| of_one(&it.id));
    let compared = assert_same_measurements(&again, &committed);
    assert_eq!(compared, again.claims.len());
    assert!(compared > 40, "{compared}");
}
