//! What is asked of the parameters of rivals that learn, as the core asks it of a brain's.

use cla_core::check::{Config, ConfigError, Range};

use super::linear::LinearConfig;
use super::tabular::TabularConfig;

/// A step size, which learns something.
fn check_step(field: &'static str, alpha: f64) -> Result<(), ConfigError> {
    Range::SHARE.check(field, alpha as f32)?;
    Range::ABOVE_ZERO.check(field, alpha as f32)
}

impl Config for TabularConfig {
    fn check(&self) -> Result<(), ConfigError> {
        check_step("TabularConfig::alpha", self.alpha)?;
        Range::BELOW_ONE.check("TabularConfig::discount", self.discount as f32)?;
        Range::SHARE.check("TabularConfig::lambda", self.lambda as f32)?;
        Range::SHARE.check("TabularConfig::explore", self.explore as f32)?;
        Range::SHARE.check("TabularConfig::explore_acting", self.explore_acting as f32)?;
        Range::NOT_NEGATIVE.check("TabularConfig::optimism", self.optimism as f32)?;
        self.escape.map_or(Ok(()), |escape| escape.check())
    }
}

impl Config for LinearConfig {
    fn check(&self) -> Result<(), ConfigError> {
        check_step("LinearConfig::alpha", self.alpha)?;
        Range::BELOW_ONE.check("LinearConfig::discount", self.discount as f32)?;
        Range::SHARE.check("LinearConfig::lambda", self.lambda as f32)?;
        Range::SHARE.check("LinearConfig::explore", self.explore as f32)?;
        Range::SHARE.check("LinearConfig::explore_acting", self.explore_acting as f32)?;
        self.escape.map_or(Ok(()), |escape| escape.check())
    }
}

#[cfg(test)]
mod tests {
    use cla_core::check::Config;

    use super::{LinearConfig, TabularConfig};

    #[test]
    fn the_named_parameters_can_be_and_what_cannot_is_named() {
        for config in [
            TabularConfig::Q,
            TabularConfig::Q_HISTORY,
            TabularConfig::SARSA,
            TabularConfig::SARSA_HISTORY,
        ] {
            assert!(config.check().is_ok());
        }
        assert!(LinearConfig::DEFAULT.check().is_ok());
        type Spoil = fn(&mut TabularConfig);
        let spoil: [(Spoil, &str); 5] = [
            (|it| it.alpha = 0.0, "alpha"),
            (|it| it.alpha = f64::NAN, "alpha"),
            (|it| it.discount = 1.0, "discount"),
            (|it| it.lambda = -0.1, "lambda"),
            (|it| it.optimism = f64::INFINITY, "optimism"),
        ];
        for (spoil, field) in spoil {
            let mut config = TabularConfig::SARSA;
            spoil(&mut config);
            let error = config.check().unwrap_err().to_string();
            assert!(error.contains(field), "{error}");
        }
        let config = LinearConfig {
            explore: 2.0,
            ..LinearConfig::DEFAULT
        };
        assert!(config.check().is_err());
    }
}
