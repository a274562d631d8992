//! What a brain may cost on a microcontroller, and whether it kept to that in a run.
//!
//! RAM is known before anything runs; the instructions of a control step are estimated while it does
//! (see [`meter`](super::meter)).

use super::target::Target;
use crate::failure::Impossible;
use crate::report::Results;
use crate::report::grouped;

/// The limits of a run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Budget {
    /// The processor that the estimate is for.
    target: Target,
    /// Most instructions of a control step.
    instructions: Option<u64>,
    /// Most bytes of a brain.
    ram: Option<u64>,
}

impl Budget {
    /// Reads limits, `instructions=N` and `ram=N`, each at most once, and the name of a processor.
    ///
    /// # Errors
    /// [`Impossible`] for anything else, and for an unknown processor.
    pub fn new(limits: &[String], processor: &str) -> Result<Self, Impossible> {
        let named = |target: &Target| target.name().eq_ignore_ascii_case(processor);
        let target = Target::ALL.into_iter().find(named).ok_or_else(|| {
            Impossible::new(format!(
                "--processor is cortex-m4f, cortex-m0+ or rv32imac, not {processor:?}"
            ))
        })?;
        let mut budget = Self {
            target,
            instructions: None,
            ram: None,
        };
        for limit in limits {
            let unknown = || {
                Impossible::new(format!(
                    "--budget takes instructions=N and ram=N, with N such as 60000, 60k or 256KiB, not {limit:?}"
                ))
            };
            let (name, text) = limit.split_once('=').ok_or_else(unknown)?;
            let slot = match name {
                "instructions" => &mut budget.instructions,
                "ram" => &mut budget.ram,
                _ => return Err(unknown()),
            };
            let number = number(text).ok_or_else(unknown)?;
            if slot.replace(number).is_some() {
                return Err(Impossible::new(format!("--budget has {name} twice")));
            }
        }
        Ok(budget)
    }

    /// Whether a brain of so many bytes may run at all.
    ///
    /// # Errors
    /// [`Impossible`] when it is larger than its budget.
    pub fn check_ram(&self, bytes: usize) -> Result<(), Impossible> {
        match self.ram {
            Some(most) if bytes as u64 > most => Err(Impossible::new(format!(
                "over budget: the brain takes {} bytes of RAM, {} more than ram={most} allows",
                grouped(bytes as u64),
                grouped(bytes as u64 - most)
            ))),
            _ => Ok(()),
        }
    }

    /// Says what the worst step of a run took; a run that took too much has failed.
    #[must_use]
    pub fn judge(&self, mut results: Results, bytes: usize) -> Results {
        let name = self.target.name();
        let mut ticks = results.worst_ticks.iter();
        let Some(&(_, worst)) = ticks.find(|(of, _)| *of == name) else {
            return results;
        };
        let of = |most: Option<String>| most.map_or(String::new(), |most| format!(" of {most}"));
        results.remark = Some(format!(
            "worst tick {} instructions{} ({name}, estimated; harvests apart), {}{} KiB",
            grouped(worst),
            of(self.instructions.map(grouped)),
            kibibytes(bytes as u64),
            of(self.ram.map(kibibytes)),
        ));
        if let Some(most) = self.instructions.filter(|&most| worst > most) {
            results.over_budget = Some(format!(
                "over budget: the worst tick takes {} instructions on a {name} (estimated), {} more than instructions={most} allows",
                grouped(worst),
                grouped(worst - most)
            ));
        }
        results
    }
}

/// A whole number, perhaps in thousands (`60k`) or units of 1024 (`256KiB`).
pub(crate) fn number(text: &str) -> Option<u64> {
    let (digits, unit) = match text {
        _ if text.ends_with("KiB") => (text.trim_end_matches("KiB"), 1024),
        _ if text.ends_with('k') => (text.trim_end_matches('k'), 1000),
        _ => (text, 1),
    };
    digits.parse::<u64>().ok()?.checked_mul(unit)
}

/// To one digit, rounded up.
fn kibibytes(bytes: u64) -> String {
    let tenths = (bytes * 10).div_ceil(1024);
    match tenths % 10 {
        0 => (tenths / 10).to_string(),
        rest => format!("{}.{rest}", tenths / 10),
    }
}

#[cfg(test)]
mod tests {
    use super::Budget;
    use crate::report::{Results, Summary};

    fn read(budget: &[&str], processor: &str) -> Result<Budget, String> {
        let limits: Vec<String> = budget.iter().map(|&it| it.to_owned()).collect();
        Budget::new(&limits, processor).map_err(|error| error.to_string())
    }

    fn results(worst: u64) -> Results {
        let mut results = Results::new(Summary::new("forage", &[0]));
        results.worst_ticks = vec![("Cortex-M4F", worst), ("Cortex-M0+", 5 * worst)];
        results
    }

    #[test]
    fn what_is_no_limit_is_refused_in_one_sentence() {
        for wrong in [
            "60000",
            "time=3",
            "ram=",
            "ram=-1",
            "ram=1MB",
            "instructions=1.5k",
            "ram=18446744073709551615KiB",
        ] {
            let sentence = read(&[wrong], "cortex-m4f").unwrap_err();
            assert!(!sentence.contains('\n') && sentence.contains("--budget"));
        }
        assert!(read(&["ram=1", "ram=2"], "cortex-m4f").is_err());
        assert!(read(&[], "z80").is_err());
    }

    #[test]
    fn the_worst_tick_is_held_against_the_limit_of_its_processor() {
        let budget = read(&["instructions=160k", "ram=264KiB"], "cortex-m4f").unwrap();
        let kept = budget.judge(results(160_000), 261_720);
        assert_eq!(
            kept.remark.as_deref(),
            Some(
                "worst tick 160,000 instructions of 160,000 (Cortex-M4F, estimated; harvests apart), 255.6 of 264 KiB"
            )
        );
        assert_eq!(kept.over_budget, None);
        let sentence = budget.judge(results(160_001), 1).over_budget.unwrap();
        assert!(sentence.contains("1 more than instructions=160000 allows"));
        let small = read(&["instructions=160k"], "Cortex-M0+").unwrap();
        assert!(small.judge(results(160_000), 1).over_budget.is_some());
    }

    #[test]
    fn a_brain_that_is_too_large_is_refused_before_it_lives() {
        let budget = read(&["ram=128KiB"], "cortex-m4f").unwrap();
        assert!(budget.check_ram(131_072).is_ok());
        let sentence = budget.check_ram(131_073).unwrap_err().to_string();
        assert!(
            sentence.contains("1 more than ram=131072 allows"),
            "{sentence}"
        );
    }
}
