//! How fast each part of the learner learns, as configured, in a doubt and without.

use super::config::MindConfig;
use super::model::ModelRates;
use super::sarsa::{Rates, Replaying};

impl MindConfig {
    pub(super) const fn habit_rates(&self, doubting: bool) -> Rates {
        Rates {
            rate: if doubting {
                self.habit_rate_doubting
            } else {
                self.habit_rate
            },
            replacing: doubting,
            discount: self.habit_discount,
            lambda: self.habit_lambda,
        }
    }

    pub(super) const fn replaying(&self, doubting: bool) -> Replaying {
        Replaying {
            rate: if doubting {
                self.replay_rate_doubting
            } else {
                self.replay_rate
            },
            discount: self.habit_discount,
            lambda: self.habit_lambda,
        }
    }

    pub(super) const fn model_rates(&self, doubting: bool) -> ModelRates {
        ModelRates {
            discount: self.model_discount,
            remembered: if doubting {
                self.remembered_doubting
            } else {
                self.remembered
            },
            prior: self.prior,
            felt: self.felt,
        }
    }
}
