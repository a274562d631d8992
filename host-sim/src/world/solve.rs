//! Value iteration on worlds of which everything is known: what the best possible policy earns.
//!
//! [`Mdp`] is a table of states, actions, chances and rewards; [`Mdp::within`] plans for a number of
//! steps, [`Mdp::forever`] for a discounted future, [`Mdp::rate`] for the mean reward of a step.
//! Source: Puterman (1994), chapters 4, 6 and 8.

/// One thing that may come of an action: the next state and its probability.
pub type Outcome = (usize, f64);

/// States, actions, what they lead to and what that earns.
///
/// ```
/// use host_sim::world::solve::Mdp;
/// // In state 0 the first action stays and earns 1, the second leads to state 1, where all earn 3.
/// let mdp = Mdp::new(2, 2, |state, action| match (state, action) {
///     (0, 0) => (vec![(0, 1.0)], 1.0),
///     (0, _) => (vec![(1, 1.0)], 0.0),
///     _ => (vec![(1, 1.0)], 3.0),
/// });
/// assert_eq!(mdp.within(1).value(0), 1.0);
/// assert_eq!(mdp.within(3).value(0), 6.0);
/// assert!((mdp.rate(1e-9).gain - 3.0).abs() < 1e-6);
/// ```
#[derive(Clone, Debug)]
pub struct Mdp {
    states: usize,
    actions: usize,
    /// By state, then action.
    table: Vec<(Vec<Outcome>, f64)>,
}

/// What to do in each state when so many steps are left, and what that earns.
#[derive(Clone, Debug)]
pub struct Horizon {
    states: usize,
    /// By steps left, then state.
    policy: Vec<usize>,
    values: Vec<f64>,
}

impl Horizon {
    /// The best action in `state` with `left` steps to go, this one included; the most steps that
    /// were planned when there are more.
    #[must_use]
    pub fn action(&self, state: usize, left: usize) -> usize {
        let most = self.policy.len() / self.states.max(1);
        let row = left.clamp(1, most.max(1)) - 1;
        self.policy
            .get(row * self.states + state)
            .map_or(0, |&it| it)
    }

    /// What the best policy earns from `state` on in all the steps.
    #[must_use]
    pub fn value(&self, state: usize) -> f64 {
        self.values.get(state).map_or(0.0, |&it| it)
    }
}

/// A policy for a discounted future, and what it earns.
#[derive(Clone, Debug)]
pub struct Plan {
    /// The best action in each state.
    pub policy: Vec<usize>,
    /// Expected discounted reward from each state on.
    pub values: Vec<f64>,
}

/// A policy for ever, by the mean reward of a step.
#[derive(Clone, Debug)]
pub struct Rate {
    /// The best action in each state.
    pub policy: Vec<usize>,
    /// What it earns in a step, in the long run.
    pub gain: f64,
}

/// Sweeps after which value iteration gives up on its tolerance.
const MOST_SWEEPS: usize = 200_000;

impl Mdp {
    /// Asks `of` for the outcomes and the expected reward of every state and action.
    #[must_use]
    pub fn new(
        states: usize,
        actions: usize,
        mut of: impl FnMut(usize, usize) -> (Vec<Outcome>, f64),
    ) -> Self {
        let pairs = (0..states).flat_map(|state| (0..actions).map(move |action| (state, action)));
        let table = pairs.map(|(state, action)| of(state, action)).collect();
        Self {
            states,
            actions,
            table,
        }
    }

    /// States.
    #[must_use]
    pub const fn states(&self) -> usize {
        self.states
    }

    /// What an action may lead to in a state.
    #[must_use]
    pub fn outcomes(&self, state: usize, action: usize) -> &[Outcome] {
        &self.table[state * self.actions + action].0
    }

    /// Expected reward of an action in a state.
    #[must_use]
    pub fn reward(&self, state: usize, action: usize) -> f64 {
        self.table[state * self.actions + action].1
    }

    /// What an action is worth when its outcomes are worth `values`.
    #[must_use]
    pub fn worth(&self, state: usize, action: usize, discount: f64, values: &[f64]) -> f64 {
        let outcomes = self.outcomes(state, action).iter();
        outcomes.fold(self.reward(state, action), |sum, &(next, chance)| {
            sum + discount * chance * values[next]
        })
    }

    /// The best action of a state, the lowest among equals, and its worth.
    fn best(&self, state: usize, discount: f64, values: &[f64]) -> (usize, f64) {
        let mut best = (0, f64::NEG_INFINITY);
        for action in 0..self.actions {
            let worth = self.worth(state, action, discount, values);
            // A difference of rounding is none.
            if worth > best.1 + 1e-12 {
                best = (action, worth);
            }
        }
        best
    }

    /// The best policy for this number of steps, undiscounted.
    #[must_use]
    pub fn within(&self, steps: usize) -> Horizon {
        let (mut values, mut policy) = (vec![0.0; self.states], Vec::new());
        for _ in 0..steps {
            let best: Vec<_> = (0..self.states)
                .map(|state| self.best(state, 1.0, &values))
                .collect();
            policy.extend(best.iter().map(|it| it.0));
            values = best.iter().map(|it| it.1).collect();
        }
        Horizon {
            states: self.states,
            policy,
            values,
        }
    }

    /// The best policy for a future discounted by `discount`, in `[0, 1)`, until no value changes by
    /// more than `tolerance`.
    #[must_use]
    pub fn forever(&self, discount: f64, tolerance: f64) -> Plan {
        let mut values = vec![0.0; self.states];
        for _ in 0..MOST_SWEEPS {
            let mut change = 0.0_f64;
            for state in 0..self.states {
                let worth = self.best(state, discount, &values).1;
                change = change.max((worth - values[state]).abs());
                values[state] = worth;
            }
            if change <= tolerance {
                break;
            }
        }
        let best = |state| self.best(state, discount, &values).0;
        Plan {
            policy: (0..self.states).map(best).collect(),
            values,
        }
    }

    /// The best policy by the mean reward of a step, to within `tolerance`, where every state can be
    /// reached from every other by some policy.
    ///
    /// Relative value iteration; every action is done in half of the steps only, which changes
    /// neither the policy nor the order of gains, and ends cycles that would never settle.
    #[must_use]
    pub fn rate(&self, tolerance: f64) -> Rate {
        let mut values = vec![0.0; self.states];
        let mut gain = 0.0;
        for _ in 0..MOST_SWEEPS {
            let next: Vec<f64> = (0..self.states)
                .map(|state| {
                    let worth = self.best(state, 1.0, &values).1;
                    0.5 * (worth + values[state])
                })
                .collect();
            let changes = next.iter().zip(&values).map(|(new, old)| new - old);
            let (least, most) = changes.fold((f64::MAX, f64::MIN), |(least, most), it| {
                (least.min(it), most.max(it))
            });
            gain = least + most;
            let base = next.first().copied().unwrap_or(0.0);
            values = next.iter().map(|value| value - base).collect();
            if 2.0 * (most - least) <= tolerance {
                break;
            }
        }
        let best = |state| self.best(state, 1.0, &values).0;
        Rate {
            policy: (0..self.states).map(best).collect(),
            gain,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Mdp;

    /// A ring of five places; the first action stays, the second goes on; a whole round earns 1.
    fn ring() -> Mdp {
        Mdp::new(5, 2, |state, action| {
            if action == 0 {
                return (vec![(state, 1.0)], 0.0);
            }
            let whole = f64::from(u8::from(state == 4));
            (vec![((state + 1) % 5, 1.0)], whole)
        })
    }

    #[test]
    fn a_round_of_five_steps_earns_a_fifth_a_step_though_it_never_settles() {
        let rate = ring().rate(1e-9);
        assert!((rate.gain - 0.2).abs() < 1e-6, "{}", rate.gain);
        assert_eq!(rate.policy, [1; 5]);
    }

    #[test]
    fn a_discounted_round_is_worth_its_geometric_series() {
        let plan = ring().forever(0.9, 1e-12);
        let whole = 0.9_f64.powi(4) / (1.0 - 0.9_f64.powi(5));
        assert!((plan.values[0] - whole).abs() < 1e-9);
        assert_eq!(plan.policy, [1; 5]);
    }

    #[test]
    fn within_too_few_steps_nothing_is_worth_anything() {
        let plan = ring().within(4);
        assert_eq!((plan.value(0), plan.value(1)), (0.0, 1.0));
        assert_eq!((plan.action(0, 4), plan.action(4, 1)), (0, 1));
        // More steps than were planned are taken for the most that were.
        assert_eq!(plan.action(1, 99), plan.action(1, 4));
    }
}
