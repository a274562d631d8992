//! Some seeds of a committed run, lived again: what must be the same to the last bit.

use host_sim::report::{Claim, Summary};

/// A committed summary, as it stands.
pub(crate) fn committed(text: &str) -> Summary {
    Summary::from_json(text).expect("a committed claims file can be read")
}

/// Compares what the seeds of `again` measured with what they measured when `committed` was made;
/// answers how many claims were compared, which are those that both have.
pub(crate) fn assert_same_measurements(again: &Summary, committed: &Summary) -> usize {
    let mut compared = 0;
    for new in &again.claims {
        let Some(old) = committed.claims.iter().find(|it| it.id == new.id) else {
            continue;
        };
        compared += 1;
        for (place, seed) in again.seeds.iter().enumerate() {
            let there = committed.seeds.iter().position(|it| it == seed);
            let there = there.expect("a committed seed");
            let at = |claim: &Claim, place: usize| {
                let against = claim.against.as_ref().map(|it| it.get(place).copied());
                (claim.per_seed.get(place).copied(), against)
            };
            assert_eq!(at(new, place), at(old, there), "{} of seed {seed}", new.id);
        }
    }
    compared
}
