//! The functions of the module that work on a map's arrays in place.

use numpy::{
    PyArray1, PyReadonlyArray1, PyReadonlyArray2, PyReadwriteArray1, PyReadwriteArray2,
    PyUntypedArrayMethods,
};
use pulp::Arch;
use pyo3::prelude::*;

use super::binary::{Binary, Scratch, Sparse};
use super::dense::{nearest, squared_distances, train};
use super::rates::{Lattice, Rates, Shape};
use crate::guard::{guarded, refused};

/// Steps of training after which Python may interrupt it.
const BLOCK: usize = 4096;

type Weights<'py> = PyReadwriteArray2<'py, f32>;
type Data<'py> = PyReadonlyArray2<'py, f32>;
type PerStep<'py> = (
    PyReadonlyArray1<'py, i64>,
    PyReadonlyArray1<'py, f32>,
    PyReadonlyArray1<'py, f32>,
    PyReadonlyArray1<'py, i64>,
);

fn not_in_order(_: impl std::fmt::Display) -> PyErr {
    refused("arrays of a map are contiguous in memory")
}

fn lattice(x: usize, y: usize, hexagonal: bool, shape: &str) -> PyResult<Lattice> {
    let shape = Shape::parse(shape)
        .ok_or_else(|| refused(format_args!("there is no neighbourhood {shape:?}")))?;
    Ok(Lattice {
        x,
        y,
        hexagonal,
        shape,
    })
}

/// Does so many steps with the widest vectors of the machine; Python may interrupt them.
///
/// What is inlined here is compiled for each kind of machine.
#[inline(always)]
fn in_blocks(
    py: Python<'_>,
    steps: usize,
    mut step: impl FnMut(usize) -> PyResult<()>,
) -> PyResult<()> {
    let arch = Arch::new();
    guarded(|| {
        for first in (0..steps).step_by(BLOCK) {
            let block = first..steps.min(first + BLOCK);
            arch.dispatch(
                #[inline(always)]
                || {
                    for number in block {
                        step(number)?;
                    }
                    Ok::<(), PyErr>(())
                },
            )?;
            py.check_signals()?;
        }
        Ok(())
    })
}

/// What is to be done in what order, checked once.
struct Plan<'a> {
    data: &'a [f32],
    features: usize,
    order: &'a [i64],
    alphas: &'a [f32],
    sigmas: &'a [f32],
    /// The winner of each step, −1 for the best matching unit.
    winners: &'a [i64],
}

impl<'a> Plan<'a> {
    fn new(
        data: &'a Data<'_>,
        steps: &'a PerStep<'_>,
        features: usize,
        nodes: usize,
    ) -> PyResult<Self> {
        let [samples, width] = [data.shape()[0], data.shape()[1]];
        let it = Self {
            data: data.as_slice().map_err(not_in_order)?,
            features,
            order: steps.0.as_slice().map_err(not_in_order)?,
            alphas: steps.1.as_slice().map_err(not_in_order)?,
            sigmas: steps.2.as_slice().map_err(not_in_order)?,
            winners: steps.3.as_slice().map_err(not_in_order)?,
        };
        let lengths = [it.alphas.len(), it.sigmas.len(), it.winners.len()];
        let fits = width == features && lengths.iter().all(|&length| length == it.order.len());
        let within = |&at: &i64, most: usize| usize::try_from(at).is_ok_and(|at| at < most);
        let ordered = it.order.iter().all(|at| within(at, samples));
        let won = it.winners.iter().all(|at| *at == -1 || within(at, nodes));
        if fits && ordered && won {
            Ok(it)
        } else {
            Err(refused("data, order, rates and winners do not fit the map"))
        }
    }

    fn stimulus(&self, step: usize) -> &'a [f32] {
        &self.data[self.order[step] as usize * self.features..][..self.features]
    }

    /// The winner of a step, which has these distances.
    fn winner(&self, step: usize, distances: &[f32]) -> usize {
        usize::try_from(self.winners[step]).unwrap_or_else(|_| nearest(distances))
    }
}

/// Trains a dense map; `steps` are the samples in order, the rates, the widths and the winners.
#[pyfunction]
pub(crate) fn som_train(
    py: Python<'_>,
    mut weights: Weights<'_>,
    map: (usize, usize, bool, String),
    data: Data<'_>,
    steps: PerStep<'_>,
) -> PyResult<()> {
    let mut rates = Rates::new(lattice(map.0, map.1, map.2, &map.3)?);
    let nodes = map.0 * map.1;
    let features = shaped(weights.shape(), nodes)?;
    let plan = Plan::new(&data, &steps, features, nodes)?;
    let weights = weights.as_slice_mut().map_err(not_in_order)?;
    let mut distances = vec![0.0; nodes];
    in_blocks(
        py,
        plan.order.len(),
        #[inline(always)]
        |step| {
            let stimulus = plan.stimulus(step);
            if plan.winners[step] < 0 {
                squared_distances(weights, stimulus, &mut distances);
            }
            let winner = plan.winner(step, &distances);
            rates.around(winner, plan.sigmas[step], plan.alphas[step]);
            train(weights, stimulus, &rates.of, rates.moving.clone());
            Ok(())
        },
    )
}

/// The squared distances of one sample from every node.
#[pyfunction]
pub(crate) fn som_distances<'py>(
    py: Python<'py>,
    weights: Data<'py>,
    stimulus: PyReadonlyArray1<'py, f32>,
) -> PyResult<Bound<'py, PyArray1<f32>>> {
    let nodes = weights.shape()[1];
    let features = shaped(weights.shape(), nodes)?;
    let stimulus = stimulus.as_slice().map_err(not_in_order)?;
    if stimulus.len() != features {
        return Err(refused("the sample does not fit the map"));
    }
    let weights = weights.as_slice().map_err(not_in_order)?;
    let mut distances = vec![0.0; nodes];
    guarded(|| {
        Arch::new().dispatch(
            #[inline(always)]
            || squared_distances(weights, stimulus, &mut distances),
        );
        Ok(PyArray1::from_vec(py, distances))
    })
}

type Three<'py> = (
    PyReadwriteArray2<'py, f32>,
    PyReadwriteArray1<'py, f32>,
    PyReadwriteArray1<'py, f32>,
);

fn opened<'a>(map: &'a mut Three<'_>, nodes: usize) -> PyResult<(Binary<'a>, usize)> {
    let features = shaped(map.0.shape(), nodes)?;
    let it = Binary {
        columns: map.0.as_slice_mut().map_err(not_in_order)?,
        scale: map.1.as_slice_mut().map_err(not_in_order)?,
        norm: map.2.as_slice_mut().map_err(not_in_order)?,
    };
    if it.scale.len() == nodes && it.norm.len() == nodes {
        Ok((it, features))
    } else {
        Err(refused("the arrays of the map do not fit each other"))
    }
}

fn sparse(stimulus: &[f32]) -> PyResult<Sparse> {
    Sparse::read(stimulus).map_err(|feature| {
        let value = stimulus.get(feature).copied().unwrap_or(0.0);
        refused(format_args!(
            "feature {feature} is 0, 1 or NaN for unknown on a binary map, not {value}"
        ))
    })
}

/// Trains a map of binary stimuli.
#[pyfunction]
pub(crate) fn som_binary_train(
    py: Python<'_>,
    mut arrays: Three<'_>,
    map: (usize, usize, bool, String),
    data: Data<'_>,
    steps: PerStep<'_>,
) -> PyResult<()> {
    let mut rates = Rates::new(lattice(map.0, map.1, map.2, &map.3)?);
    let nodes = map.0 * map.1;
    let (mut it, features) = opened(&mut arrays, nodes)?;
    let plan = Plan::new(&data, &steps, features, nodes)?;
    let (mut distances, mut scratch) = (vec![0.0; nodes], Scratch::new(nodes));
    // All of them before any is learned: one that is wrong changes nothing.
    let stimuli = plan.data.chunks_exact(features).map(sparse);
    let stimuli = stimuli.collect::<PyResult<Vec<Sparse>>>()?;
    in_blocks(
        py,
        plan.order.len(),
        #[inline(always)]
        |step| {
            let stimulus = &stimuli[plan.order[step] as usize];
            if plan.winners[step] < 0 {
                it.squared_distances(stimulus, &mut distances);
            }
            let winner = plan.winner(step, &distances);
            rates.around(winner, plan.sigmas[step], plan.alphas[step]);
            it.train(stimulus, &mut rates.of, rates.moving.clone(), &mut scratch);
            Ok(())
        },
    )
}

/// The squared distances of one binary sample from every node.
#[pyfunction]
pub(crate) fn som_binary_distances<'py>(
    py: Python<'py>,
    mut arrays: Three<'py>,
    stimulus: PyReadonlyArray1<'py, f32>,
) -> PyResult<Bound<'py, PyArray1<f32>>> {
    let nodes = arrays.0.shape()[1];
    let (it, features) = opened(&mut arrays, nodes)?;
    let stimulus = stimulus.as_slice().map_err(not_in_order)?;
    if stimulus.len() != features {
        return Err(refused("the sample does not fit the map"));
    }
    let known = sparse(stimulus)?;
    let mut distances = vec![0.0; nodes];
    guarded(|| {
        it.squared_distances(&known, &mut distances);
        Ok(PyArray1::from_vec(py, distances))
    })
}

/// Makes every factor 1, so that the first array is the weights.
#[pyfunction]
pub(crate) fn som_binary_fold(mut arrays: Three<'_>) -> PyResult<()> {
    let nodes = arrays.0.shape()[1];
    let (mut it, _) = opened(&mut arrays, nodes)?;
    guarded(|| {
        it.fold();
        Ok(())
    })
}

/// The features of an array of features × nodes.
fn shaped(shape: &[usize], nodes: usize) -> PyResult<usize> {
    match *shape {
        [features, all] if all == nodes && nodes > 0 && features > 0 => Ok(features),
        _ => Err(refused("the weights do not fit the map")),
    }
}
