//! Trials written down, one line of JSON each, and read back to the same bits.
//!
//! JSON has no NaN and no infinity; a field that may hold one says `#[serde(with = "floats")]`, which
//! writes it as a word.
//! A trial that would not come back as it was is refused, so nothing is lost in a file.

use std::fmt;

use serde::de::DeserializeOwned;
use serde::{Serialize, Serializer};

use super::plan::{self, Experiment};
use crate::failure::Failure;
use crate::progress::Progress;
use crate::report::Results;

/// A trial as a line.
///
/// # Errors
/// [`Failure`] for a trial that would not come back as it was.
///
/// ```
/// use host_sim::experiment::record::{line, read};
/// let trial = (100_u64, vec![0.1, 1.0 / 3.0]);
/// assert_eq!(read::<(u64, Vec<f64>)>(&line(&trial)?)?, trial);
/// // JSON would turn it into null, which is no number.
/// assert!(line(&f64::NAN).is_err());
/// # Ok::<(), host_sim::failure::Failure>(())
/// ```
pub fn line<T: Serialize + DeserializeOwned>(trial: &T) -> Result<String, Failure> {
    let text = serde_json::to_string(trial)?;
    let back: T = serde_json::from_str(&text)
        .map_err(|error| format!("a trial cannot be read back: {error}"))?;
    if serde_json::to_string(&back)? == text {
        Ok(text)
    } else {
        Err("a trial does not come back as it was written".into())
    }
}

/// The trial of a line.
///
/// # Errors
/// [`Failure`] for a line that is no such trial.
pub fn read<T: DeserializeOwned>(line: &str) -> Result<T, Failure> {
    Ok(serde_json::from_str(line)?)
}

/// Makes all trials, writes each down, reads it back, and judges both; they must say the same.
///
/// # Errors
/// [`Failure`] of the experiment, of a trial that cannot be written, or of two judgements that
/// differ.
pub fn judged_again<E: Experiment>(options: &E::Options) -> Result<Results, Failure> {
    let trials = plan::trials::<E>(options, &Progress::hidden())?;
    let written = trials.iter().map(line).collect::<Result<Vec<_>, _>>()?;
    let read_back = written.iter().map(|it| read(it));
    let read_back = read_back.collect::<Result<Vec<E::Trial>, _>>()?;
    let (first, again) = (E::judge(options, &trials)?, E::judge(options, &read_back)?);
    if first == again {
        Ok(again)
    } else {
        Err("trials that were written down are judged otherwise".into())
    }
}

/// Writes what has no form of its own as it is shown for debugging: options are told apart, not read.
///
/// # Errors
/// Those of the serializer.
pub fn in_words<T: fmt::Debug, S: Serializer>(it: &T, to: S) -> Result<S::Ok, S::Error> {
    to.collect_str(&format_args!("{it:?}"))
}

/// Floats that need not be finite: `"NaN"`, `"inf"` and `"-inf"` stand for those that are not.
pub mod floats {
    use serde::de::Error;
    use serde::{Deserialize, Deserializer, Serialize, Serializer};

    /// A number, a word for one, or a list of such.
    #[derive(Serialize, Deserialize)]
    #[serde(untagged)]
    pub enum Wire {
        /// A finite number.
        Number(f64),
        /// `NaN`, `inf` or `-inf`.
        Word(String),
        /// Several.
        List(Vec<Self>),
    }

    /// What [`floats`](self) can write.
    pub trait Floats: Sized {
        /// As it is written.
        fn to_wire(&self) -> Wire;
        /// As it was; `None` for what is written otherwise.
        fn from_wire(wire: Wire) -> Option<Self>;
    }

    impl Floats for f64 {
        fn to_wire(&self) -> Wire {
            if self.is_finite() {
                Wire::Number(*self)
            } else {
                Wire::Word(self.to_string())
            }
        }

        fn from_wire(wire: Wire) -> Option<Self> {
            match wire {
                Wire::Number(number) => Some(number),
                Wire::Word(word) => word.parse().ok().filter(|it: &Self| !it.is_finite()),
                Wire::List(_) => None,
            }
        }
    }

    impl Floats for f32 {
        fn to_wire(&self) -> Wire {
            f64::from(*self).to_wire()
        }

        fn from_wire(wire: Wire) -> Option<Self> {
            let wide = f64::from_wire(wire)?;
            let narrow = wide as Self;
            (narrow.is_nan() || f64::from(narrow) == wide).then_some(narrow)
        }
    }

    impl<T: Floats> Floats for Vec<T> {
        fn to_wire(&self) -> Wire {
            Wire::List(self.iter().map(T::to_wire).collect())
        }

        fn from_wire(wire: Wire) -> Option<Self> {
            match wire {
                Wire::List(list) => list.into_iter().map(T::from_wire).collect(),
                _ => None,
            }
        }
    }

    impl<T: Floats, const N: usize> Floats for [T; N] {
        fn to_wire(&self) -> Wire {
            Wire::List(self.iter().map(T::to_wire).collect())
        }

        fn from_wire(wire: Wire) -> Option<Self> {
            Vec::from_wire(wire)?.try_into().ok()
        }
    }

    /// Writes floats.
    ///
    /// # Errors
    /// Those of the serializer.
    pub fn serialize<T: Floats, S: Serializer>(it: &T, to: S) -> Result<S::Ok, S::Error> {
        it.to_wire().serialize(to)
    }

    /// Reads floats.
    ///
    /// # Errors
    /// Those of the deserializer, and for what is no such number.
    pub fn deserialize<'a, T: Floats, D: Deserializer<'a>>(from: D) -> Result<T, D::Error> {
        let wire = Wire::deserialize(from)?;
        T::from_wire(wire).ok_or_else(|| D::Error::custom("no such number"))
    }
}

#[cfg(test)]
mod tests {
    use serde::{Deserialize, Serialize};

    use super::{floats, line, read};

    #[derive(Serialize, Deserialize)]
    struct Trial {
        whole: u64,
        plain: f64,
        narrow: f32,
        #[serde(with = "floats")]
        any: f64,
        #[serde(with = "floats")]
        several: [f32; 4],
        #[serde(with = "floats")]
        nested: Vec<Vec<f64>>,
    }

    #[test]
    fn every_number_comes_back_to_the_bit() {
        let mut rng = cla_core::num::Rng::new(7);
        let mut wide = || (u64::from(rng.next_u32()) << 32) | u64::from(rng.next_u32());
        for _ in 0..2000 {
            let finite = |bits: u64| {
                let it = f64::from_bits(bits);
                if it.is_finite() { it } else { -0.0 }
            };
            let narrow = |bits: u64| {
                let it = f32::from_bits(bits as u32);
                if it.is_finite() { it } else { -0.0 }
            };
            let trial = Trial {
                whole: wide(),
                plain: finite(wide()),
                narrow: narrow(wide()),
                any: f64::NEG_INFINITY,
                several: [narrow(wide()), f32::INFINITY, f32::MIN_POSITIVE, -0.0],
                nested: vec![vec![finite(wide()), f64::INFINITY, 3.0], vec![]],
            };
            let back: Trial = read(&line(&trial).unwrap()).unwrap();
            assert_eq!(back.whole, trial.whole);
            assert_eq!(back.plain.to_bits(), trial.plain.to_bits());
            assert_eq!(back.narrow.to_bits(), trial.narrow.to_bits());
            assert_eq!(back.any, trial.any);
            assert_eq!(
                back.several.map(f32::to_bits),
                trial.several.map(f32::to_bits)
            );
            let bits = |it: &Trial| -> Vec<u64> {
                let all = it.nested.iter().flatten();
                all.map(|it| it.to_bits()).collect()
            };
            assert_eq!(bits(&back), bits(&trial));
        }
    }

    #[test]
    fn what_is_no_number_comes_back_as_none_and_other_words_are_refused() {
        let trial = |any: f64| Trial {
            whole: 1,
            plain: 0.0,
            narrow: 0.0,
            any,
            several: [f32::NAN; 4],
            nested: vec![],
        };
        let text = line(&trial(f64::NAN)).unwrap();
        let back: Trial = read(&text).unwrap();
        assert!(back.any.is_nan() && back.several.iter().all(|it| it.is_nan()));
        assert!(read::<Trial>(&text.replacen("\"NaN\"", "\"7\"", 1)).is_err());
        assert!(read::<Trial>(&text.replacen("\"NaN\"", "\"much\"", 1)).is_err());
    }
}
