//! Robots learn at all, and trials are judged as they were.

use super::{Neighbours, NeighboursOptions, Topology, declared};
use crate::experiment::record::judged_again;

#[test]
fn robots_without_neighbours_learn_on_every_map_and_every_claim_is_made() {
    let options = NeighboursOptions {
        shorter: 5,
        ..NeighboursOptions::new(vec![1, 2, 3], None).unwrap()
    };
    let results = judged_again::<Neighbours>(&options).unwrap();
    let ids: Vec<_> = results.summary.claims.iter().map(|it| &it.id).collect();
    let known = declared();
    assert_eq!(ids, known.iter().map(|it| &it.id).collect::<Vec<_>>());
    for map in Topology::ALL {
        for seed in options.seeds.iter().copied() {
            let alone = super::trial::run(&options, seed).unwrap().on(map).alone;
            assert!(alone.learned < 0.7 * alone.learning, "{map} {alone:?}");
            // The wheels are swapped, which is felt.
            assert!(alone.recovery > alone.learned, "{map} {alone:?}");
        }
    }
}
