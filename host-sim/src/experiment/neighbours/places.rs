//! The map of places: with topology, with the same prototypes in an order by chance, and trained without a
//! neighbourhood.

use std::fmt;

use cla_core::num::{Neighbourhood, Rng, Schedule};
use cla_core::som::DenseSom;
use serde::{Deserialize, Serialize};

use super::room::{FEATURES, Place, anywhere, sensed};
use crate::failure::Failure;
use crate::world::shuffle;

/// Nodes on each side.
const SIDE: usize = 8;
/// Nodes of a map.
pub(super) const NODES: usize = SIDE * SIDE;
/// Places that a map is trained on.
const SAMPLES: u32 = 6000;
/// The learning rate at the first and the last of them.
const ALPHA: (f32, f32) = (0.5, 0.04);
/// The neighbourhood, in nodes.
const NEAR: (f32, f32) = (4.0, 0.5);
/// A neighbour whose factor is below this stays.
const CUT: f32 = 0.01;

/// How the nodes of a map lie.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Topology {
    /// As the neighbourhood of training has ordered them.
    Ordered,
    /// The same nodes, each somewhere on the grid by chance.
    Shuffled,
    /// As they began, at places by chance: the neighbourhood of training was 0 wide.
    WinnerOnly,
}

impl Topology {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Ordered, Self::Shuffled, Self::WinnerOnly];

    /// The word that claim ids use.
    #[must_use]
    pub const fn id(self) -> &'static str {
        match self {
            Self::Ordered => "ordered",
            Self::Shuffled => "shuffled",
            Self::WinnerOnly => "winner_only",
        }
    }
}

impl fmt::Display for Topology {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::Ordered => "topology",
            Self::Shuffled => "the same nodes, shuffled",
            Self::WinnerOnly => "neighbourhood 0",
        })
    }
}

/// A trained map of the room.
pub(super) struct Places {
    som: Box<DenseSom<SIDE, SIDE, FEATURES>>,
}

impl Places {
    /// Trains a map on places by chance.
    pub(super) fn learned(topology: Topology, seed: u64) -> Result<Self, Failure> {
        let mut rng = Rng::stream(seed, 0);
        let mut som = Box::new(DenseSom::new());
        // Where only winners move, nodes must begin where stimuli are: others would never win.
        for node in som.prototypes_mut().as_mut_slice() {
            *node = sensed(anywhere(&mut rng));
        }
        let alpha = Schedule::geometric(ALPHA.0, ALPHA.1, SAMPLES)?;
        let width = Schedule::geometric(NEAR.0, NEAR.1, SAMPLES)?;
        for t in 0..SAMPLES {
            let near = match topology {
                Topology::WinnerOnly => Neighbourhood::winner_only(),
                _ => Neighbourhood::gaussian(width.at(t), CUT)?,
            };
            let stimulus = sensed(anywhere(&mut rng));
            let winner = som.best_matching_unit(&stimulus)?.node;
            som.train(&stimulus, winner, alpha.at(t), &near);
        }
        if topology == Topology::Shuffled {
            shuffle(som.prototypes_mut().as_mut_slice(), &mut rng);
        }
        Ok(Self { som })
    }

    /// The node of a place.
    pub(super) fn node(&self, place: Place) -> Result<usize, Failure> {
        Ok(usize::from(
            self.som.best_matching_unit(&sensed(place))?.node.0,
        ))
    }

    /// The nodes beside one on the grid: two to four.
    pub(super) fn neighbours(node: usize) -> impl Iterator<Item = usize> {
        let (column, row) = (node % SIDE, node / SIDE);
        let all = [
            (column > 0).then(|| node - 1),
            (column + 1 < SIDE).then(|| node + 1),
            (row > 0).then(|| node - SIDE),
            (row + 1 < SIDE).then(|| node + SIDE),
        ];
        all.into_iter().flatten()
    }

    /// How far a node's prototype lies from those of its neighbours, a mean over the map.
    pub(super) fn spread(&self) -> f64 {
        let nodes = self.som.prototypes().as_slice();
        let mut distances = Vec::new();
        for (at, node) in nodes.iter().enumerate() {
            for other in Self::neighbours(at) {
                let squares = node.iter().zip(&nodes[other]).map(|(a, b)| (a - b).powi(2));
                distances.push(f64::from(squares.sum::<f32>()).sqrt());
            }
        }
        distances.iter().sum::<f64>() / distances.len() as f64
    }
}

#[cfg(test)]
mod tests {
    use super::{Places, Topology};

    #[test]
    fn neighbours_of_a_corner_are_two_and_of_the_middle_four() {
        assert_eq!(Places::neighbours(0).collect::<Vec<_>>(), [1, 8]);
        assert_eq!(Places::neighbours(9).collect::<Vec<_>>(), [8, 10, 1, 17]);
    }

    #[test]
    fn neighbours_are_alike_only_where_training_had_a_neighbourhood() {
        let spread = |it| Places::learned(it, 3).unwrap().spread();
        let ordered = spread(Topology::Ordered);
        assert!(ordered < 0.6 * spread(Topology::Shuffled));
        assert!(ordered < 0.6 * spread(Topology::WinnerOnly));
    }
}
