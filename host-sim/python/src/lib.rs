//! The native half of the Python package `cla`: worlds, the learner and maps, for Python to wrap.
//!
//! It knows the host's worlds and the core's learner and decides nothing; what Python sees is in
//! `python/cla`, which checks what comes in and says what it means.
//! The crate has no unsafe line of its own: what PyO3's macros write is theirs.

mod agent;
mod being;
mod guard;
mod percept;
mod profile;
mod som;
mod stage;
mod world;

/// The module.
#[pyo3::pymodule]
mod _native {
    #[pymodule_export]
    use super::agent::Agent;
    #[pymodule_export]
    use super::som::{
        som_binary_distances, som_binary_fold, som_binary_train, som_distances, som_train,
    };
    #[pymodule_export]
    use super::world::World;

    /// The seeds of the rooms of a life in the experiments: two of its childhood, that of the test.
    #[pyo3::pyfunction]
    fn rooms(seed: u64) -> (u64, u64, u64) {
        host_sim::world::setting::rooms(seed).into()
    }

    /// The profiles: names and what each is for.
    #[pyo3::pyfunction]
    fn profiles() -> Vec<(&'static str, &'static str)> {
        super::profile::PROFILES.to_vec()
    }
}
