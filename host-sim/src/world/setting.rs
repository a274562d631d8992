//! The setting of a life: the Pioneer's world as it can be built for any seed.

use cla_core::num::Rng;
use serde::Serialize;
use std::path::{Path, PathBuf};

use super::config::PioneerConfig;
use super::layout::Layout;
use super::pioneer::Pioneer;
use crate::failure::Impossible;
use crate::whole::read_text;

/// Most actions that one part of a life may have.
pub const MOST_ACTIONS: u32 = 10_000_000;
/// Most bytes of a file with a layout.
const MOST_BYTES: u64 = 1 << 20;

/// The rooms of a life with this seed, as seeds: two of its childhood, and the third, in which it is
/// tested and something breaks.
///
/// The later ones are far from every seed that a person names, so that no test repeats a childhood.
///
/// ```
/// use host_sim::world::setting::rooms;
/// assert_eq!(rooms(7), [7, 4_603_104_468_681_784_384, 3_141_236_514_677_479_789]);
/// ```
#[must_use]
pub fn rooms(seed: u64) -> [u64; 3] {
    let other = |stream| Rng::stream(seed, stream).next_seed();
    [seed, other(4), other(1)]
}

/// A world that can be built for any seed.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct WorldOptions {
    /// Its parameters.
    pub config: PioneerConfig,
    /// The places of the specimens, when a file gives them.
    pub layout: Option<Layout>,
    /// That file.
    #[serde(skip)]
    pub path: Option<PathBuf>,
}

impl WorldOptions {
    /// Checks the parameters, and builds the world once to see that it can be.
    ///
    /// # Errors
    /// [`Impossible`] for the first thing that cannot be.
    pub fn new(config: PioneerConfig, layout: Option<Layout>) -> Result<Self, Impossible> {
        config.validate().map_err(Impossible::new)?;
        let options = Self {
            config,
            layout,
            path: None,
        };
        options.build(0)?;
        Ok(options)
    }

    /// The world in a few words, for the caption of a figure.
    #[must_use]
    pub fn words(&self) -> String {
        let PioneerConfig {
            radius,
            specimens,
            forward,
            turn,
            drop_out,
            step_noise,
            turn_noise,
            ..
        } = self.config;
        let specimens = match &self.layout {
            Some(_) => "specimens where a file puts them".to_owned(),
            None if specimens == 1 => "one specimen".to_owned(),
            None => format!("{specimens} specimens"),
        };
        format!(
            "Room of {radius} m radius, {specimens}, steps of {forward} m ± {:.0} %, turns of {turn}° ± \
             {turn_noise}°, {:.0} % of blobs missed",
            100.0 * step_noise,
            100.0 * drop_out
        )
    }

    /// The same places with other parameters, which are checked when it is built.
    #[must_use]
    pub fn with(&self, config: PioneerConfig) -> Self {
        Self {
            config,
            layout: self.layout.clone(),
            path: self.path.clone(),
        }
    }

    /// The world of a seed.
    ///
    /// # Errors
    /// [`Impossible`] when the specimens do not fit the room.
    pub fn build(&self, seed: u64) -> Result<Pioneer, Impossible> {
        match &self.layout {
            Some(layout) => Pioneer::with_layout(self.config, layout, seed),
            None => Pioneer::new(self.config, seed),
        }
        .map_err(Impossible::new)
    }
}

/// Reads the places of the specimens in a room of so many metres from a file.
///
/// # Errors
/// [`Impossible`] when the file cannot be read or its places do not fit the room.
pub fn read_layout(path: &Path, radius: f64) -> Result<Layout, Impossible> {
    let name = path.display();
    let text = read_text(path, MOST_BYTES)
        .map_err(|why| Impossible::new(format!("cannot read the layout {name}: {why}")))?;
    Layout::parse(&text, radius)
        .map_err(|error| Impossible::new(format!("the layout {name} is wrong: {error}")))
}
