//! The numerics of the maps, pinned: every distance and every weight of a long training as one hash.
//!
//! A faster kernel must leave these numbers alone; a change of them is another numerics, and every
//! committed result has to be made again.

use cla_core::num::{Neighbourhood, Rng};
use cla_core::som::{BinarySom, ByteSom, Grid, NodeId, Prototypes, SparseStimulus, best_match};

/// A running FNV-1a hash of floats' bits.
fn add(hash: &mut u64, value: f32) {
    for byte in value.to_bits().to_le_bytes() {
        *hash = (*hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3);
    }
}

/// Trains a map on 600 random stimuli, `kind` of them with features at −1 and unknown ones.
fn trained<M: Prototypes<W, H>, const W: usize, const H: usize>(features: u16, kind: u32) -> u64 {
    let mut map = M::ZERO;
    let mut rng = Rng::new(11);
    map.randomize(&mut rng);
    let mut hash = 0xcbf2_9ce4_8422_2325;
    let mut scratch = Grid::filled(0.0);
    for t in 0..600_u32 {
        let mut words = [[0_u32; 5]; 3];
        for j in 0..features {
            let set = match rng.below(40) {
                0..6 => 0,
                6 if kind == 2 => 1,
                7 if kind == 2 || t % 50 == 0 => 2,
                _ => continue,
            };
            words[set][usize::from(j / 32)] |= 1 << (j % 32);
        }
        let [on, minus, unknown] = &words;
        let x = SparseStimulus { on, minus, unknown };
        let mut distances = Grid::filled(0.0);
        map.add_squared_distances(&x, 1.0, &mut scratch, &mut distances);
        map.add_squared_distances(&x, 0.5, &mut scratch, &mut distances);
        let winner = best_match(&distances).node;
        distances.as_slice().iter().for_each(|&d| add(&mut hash, d));
        let sigma = 4.0 - t as f32 / 150.0;
        let near = Neighbourhood::gaussian(sigma, 0.01).unwrap();
        let alpha = if t % 90 == 7 { 1.0 } else { 0.3 };
        map.train(&x, winner, alpha, &near, |node| node.0 % 7 != 3);
        if t % 40 == 5 {
            map.imprint(&x, NodeId((t % 23) as u16));
        }
    }
    for node in 0..(W * H) as u16 {
        (0..features).for_each(|j| add(&mut hash, map.weight(NodeId(node), j)));
    }
    hash
}

#[test]
fn the_reference_numerics_is_what_it_was() {
    let hashes = [
        trained::<BinarySom<20, 20, 7>, 20, 20>(7, 1),
        trained::<BinarySom<10, 10, 142>, 10, 10>(142, 1),
        trained::<BinarySom<9, 7, 40>, 9, 7>(40, 2),
    ];
    assert_eq!(
        hashes,
        [
            0xc19b_96fb_8f7e_658b,
            0xc0a9_c014_62ba_037b,
            0x2401_99de_ae53_e2b6
        ],
        "{hashes:#x?}"
    );
}

#[test]
fn the_numerics_of_bytes_is_what_it_was() {
    let hashes = [
        trained::<ByteSom<20, 20, 7>, 20, 20>(7, 1),
        trained::<ByteSom<10, 10, 142>, 10, 10>(142, 1),
        trained::<ByteSom<9, 7, 40>, 9, 7>(40, 2),
    ];
    assert_eq!(
        hashes,
        [
            0xcaeb_10a1_a6e8_8884,
            0x656f_2902_5284_dba1,
            0x27d3_d7ce_3577_6c4a
        ],
        "{hashes:#x?}"
    );
}
