//! What is concluded from the lives: the claims of the recovery experiment.

use super::life::Course;
use super::options::RecoverOptions;
use super::tables;
use super::trial::{Entrant, Lived, NEVER, Trial, before, entrants};
use crate::report::{Bound, Claim, Expectation, Rule, Summary, Verdict, mean, welch_t};
use crate::world::damage::Damage;

pub(super) fn summary(options: &RecoverOptions, trials: &[Trial]) -> Summary {
    let mut summary = Summary::new("recover", &options.seeds);
    let damages: Vec<String> = options.damages.iter().map(Damage::to_string).collect();
    summary.parameter("damages", damages.join(" "));
    summary.parameter("training", options.protocol.training);
    summary.parameter("before", options.protocol.before);
    summary.parameter("after", options.protocol.after);
    let brain = cla_core::agent::AgentConfig::RESILIENT_LEVEL2;
    summary.parameter("brain", format!("{brain:?}"));
    for (index, damage) in options.damages.iter().enumerate() {
        let of = Lived { trials, index };
        summary.claims.extend(match damage {
            Damage::None => none(&of),
            _ => recovery(&of, &damage.id()),
        });
        if *damage == Damage::Camera(12.0) {
            summary.claims.extend(camera(&of));
        }
        summary.table(
            &format!("{:02} {damage}: captures", index + 1),
            tables::captures(&of, entrants(damage)),
        );
    }
    if options.damages.len() > 2 {
        let ahead = ahead(options, trials);
        summary.claims.push(ahead);
    }
    if options.is_varied() {
        // Numbers of another world or another length say nothing of the book's.
        let claims = summary.claims.iter_mut();
        claims.for_each(|claim| claim.verdict = Verdict::Extension);
    }
    summary
}

/// What is asked of every damage.
fn recovery(of: &Lived<'_>, id: &str) -> Vec<Claim> {
    let claim = |name: &str, unit: &str| {
        Expectation::new(format!("recover.{id}.{name}"), "7.1.1", unit).extension()
    };
    let ours = of.captures(Entrant::Both, 0, 3);
    let sarsa = of.captures(Entrant::Sarsa, 0, 3);
    let welch = welch_t(&ours, &sarsa);
    let ratio = mean(&ours) / mean(&sarsa);
    let late = of.captures(Entrant::Both, 10, 13);
    let random = of.captures(Entrant::Random, 10, 13);
    let share = |name: &str, who: Entrant, from: u32| {
        let when = if from == 0 {
            "the first 3000 damaged actions"
        } else {
            "damaged actions 10,000 to 13,000"
        };
        let note = format!("{}, {when}", who.name());
        let seeds = of.of(who, |it| it.share(from, from + 3));
        (claim(name, "share of before").note(note), seeds)
    };
    let told = |(claim, seeds): (Expectation, Vec<f64>)| claim.judge(&seeds);
    let (late_claim, late_shares) = share("relearn_10000", Entrant::Both, 10);
    vec![
        told(share("relearn_3000", Entrant::Both, 0)),
        late_claim
            .rule(Rule::mean(Bound::AtLeast(0.9)))
            .judge(&late_shares),
        told(share("plain_3000", Entrant::BothPlain, 0)),
        told(share("no_habits_3000", Entrant::BothNoHabits, 0)),
        told(share("level1_3000", Entrant::Surprise, 0)),
        told(share("level1_10000", Entrant::Surprise, 10)),
        claim("vs_sarsa_3000", "ratio")
            .rule(Rule::Judged {
                text: format!(
                    "ratio >= 1.4 and Welch t >= 3 (t = {:.2}, p = {:.1e})",
                    welch.t, welch.p
                ),
                met: ratio >= 1.4 && welch.t >= 3.0,
            })
            .note("captures of both levels over those of Sarsa(λ), first 3000 damaged actions")
            .judge_ratio(&ours, &sarsa),
        claim("level2_over_level1", "ratio")
            .rule(Rule::mean(Bound::AtLeast(1.08)))
            .note("captures of both levels over level 1, with surprise, 13,000 damaged actions")
            .judge_ratio(
                &of.captures(Entrant::Both, 0, 13),
                &of.captures(Entrant::Surprise, 0, 13),
            ),
        claim("over_random", "captures in 3000 actions")
            .rule(Rule::mean(Bound::AtLeast(0.0)))
            .note("both levels less random, damaged actions 10,000 to 13,000")
            .judge(
                &late
                    .iter()
                    .zip(&random)
                    .map(|(a, b)| a - b)
                    .collect::<Vec<_>>(),
            ),
    ]
}

/// What the book and we say of its own damage.
fn camera(of: &Lived<'_>) -> Vec<Claim> {
    let claim = |name: &str, section: &str, unit: &str| {
        Expectation::new(format!("recover.camera.{name}"), section, unit)
    };
    let (share, of_28) = ("share of before", "captures of 28");
    let to_90 = |who: Entrant| {
        of.of(who, |course| {
            let actions = course.actions_to(0.9);
            if actions.is_finite() { actions } else { NEVER }
        })
    };
    let removed = |place: usize| -> Vec<f64> {
        of.trials
            .iter()
            .map(|it| f64::from(it.removed[place]))
            .collect()
    };
    let ours = of.captures(Entrant::Both, 0, 3);
    let told = of.captures(Entrant::Told, 0, 3);
    let mut all = vec![
        claim("after", "6.3", share)
            .book(1.6 / 22.9)
            .rule(Rule::mean(Bound::AtMost(0.15)))
            .note(
                "frozen from the damage on, first 3000 actions; a robot that aims 12° beside its \
                 target reaches it in a spiral",
            )
            .judge(&of.of(Entrant::Frozen, |it| it.share(0, 3))),
        claim("after_removed", "6.3", of_28)
            .book((1.6, 0.84, 10))
            .rule(Rule::mean(Bound::AtMost(3.4)))
            .note("the same robot, counted as the book counts: specimens that are taken are gone")
            .judge(&removed(0)),
        claim("reliabilities_only", "6.3", of_28)
            .book((17.4, 3.37, 10))
            .rule(Rule::mean(Bound::AtLeast(17.4)))
            .note("after 13,000 damaged actions in which only reliabilities and values adapted")
            .judge(&removed(1)),
        claim("reliabilities_only_late", "6.3", share)
            .extension()
            .note("the same robot with replacement, damaged actions 10,000 to 13,000")
            .judge(&of.of(Entrant::Reliabilities, |it| it.share(10, 13))),
        claim("actions_to_90", "7.1.1", "actions")
            .extension()
            .rule(Rule::median(Bound::AtMost(4000.0)))
            .note("until a thousand actions brought 90 % of before; 99999 is never")
            .judge(&to_90(Entrant::Both)),
        claim("plain_actions_to_90", "7.1.1", "actions")
            .extension()
            .note("both levels, re-learning without surprise")
            .judge(&to_90(Entrant::BothPlain)),
        claim("level1_actions_to_90", "7.1.1", "actions")
            .extension()
            .note("level 1 with surprise, of its own before")
            .judge(&to_90(Entrant::Surprise)),
        claim("sarsa_actions_to_90", "–", "actions")
            .extension()
            .note("Sarsa(λ), of its own before")
            .judge(&to_90(Entrant::Sarsa)),
        claim("vs_told_3000", "7.1.1", "ratio")
            .extension()
            .rule(Rule::mean(Bound::AtLeast(0.9)))
            .note("captures of both levels over those of a servo that is told of the damage")
            .judge_ratio(&ours, &told),
    ];
    for (place, when, book) in [(0, "before", 0.405), (1, "after", 0.348)] {
        all.push(
            claim(
                &format!("mean_reliability_{when}"),
                "6.3",
                "mean reliability",
            )
            .book(book)
            .rule(Rule::mean(Bound::Between(book - 0.1, book + 0.1)))
            .note("level 1, reliabilities only; ours keeps rare alternatives, see forage")
            .judge(&of.of(Entrant::Reliabilities, |it| mean(&it.reliabilities[place]))),
        );
    }
    for (place, when, book) in [(0, "before", 0.721), (1, "after", 0.446)] {
        all.push(
            claim(
                &format!("level2_predictions_{when}"),
                "6.3",
                "share of predictions that came true",
            )
            .extension()
            .note(format!(
                "both levels with surprise, said before each action; the book has {book}, counted in \
                 hindsight and with reliabilities only"
            ))
            .judge(&of.of(Entrant::Both, |it| it.predictions[place])),
        );
    }
    let baselines = [
        ("q", Entrant::Q),
        ("q_history", Entrant::QHistory),
        ("sarsa_lambda", Entrant::Sarsa),
        ("sarsa_lambda_history", Entrant::SarsaHistory),
        ("told", Entrant::Told),
        ("sector", Entrant::Sector),
        ("random", Entrant::Random),
    ];
    for (name, who) in baselines {
        for (part, number) in [
            ("", before as fn(&Course) -> f64),
            ("_damaged", |course| course.captures(0, 3)),
        ] {
            let when = if part.is_empty() {
                "undamaged"
            } else {
                "first damaged"
            };
            all.push(
                Expectation::new(
                    format!("baseline.{name}{part}"),
                    "–",
                    "captures in 3000 actions",
                )
                .extension()
                .note(format!("{}, {when}", who.name()))
                .judge(&of.of(who, number)),
            );
        }
    }
    all
}

/// What false alarms cost a robot to which nothing happens.
fn none(of: &Lived<'_>) -> Vec<Claim> {
    let all = |course: &Course| before(course) + course.captures(0, 13);
    let cost = |id: &str, note: &str, ours: Entrant, plain: Entrant| {
        let (ours, plain) = (of.of(ours, all), of.of(plain, all));
        let cost: Vec<f64> = ours.iter().zip(&plain).map(|(a, b)| 1.0 - a / b).collect();
        let ratio = 1.0 - mean(&ours) / mean(&plain);
        let welch = welch_t(&plain, &ours);
        Expectation::new(format!("recover.none.{id}"), "7.1.1", "share lost")
            .extension()
            .rule(Rule::Judged {
                text: format!(
                    "1 - ratio of the means <= 0.03: {ratio:.4} (Welch t = {:.2}, n = {})",
                    welch.t,
                    ours.len()
                ),
                met: ratio <= 0.03,
            })
            .note(format!(
                "captures in 16,000 undamaged actions, {note}, with surprise over without"
            ))
            .judge(&cost)
    };
    let (both, level1) = (of.of(Entrant::Both, all), of.of(Entrant::Surprise, all));
    let ratio = mean(&both) / mean(&level1);
    vec![
        cost("cost", "both levels", Entrant::Both, Entrant::BothPlain),
        cost("cost_level1", "level 1", Entrant::Surprise, Entrant::Plain),
        Expectation::new("recover.none.level2_over_level1", "7.1.1", "ratio")
            .extension()
            .rule(Rule::mean(Bound::AtLeast(1.08)))
            .note(format!(
                "captures in 16,000 undamaged actions, both with surprise: {ratio:.3}"
            ))
            .judge_ratio(&both, &level1),
        Expectation::new("recover.none.alarms", "7.1.1", "alarms in 16,000 actions")
            .extension()
            .judge(&of.of(Entrant::Both, |it| f64::from(it.alarms[0] + it.alarms[1]))),
    ]
}

/// In how many damages both levels are ahead of Sarsa(λ) at first.
fn ahead(options: &RecoverOptions, trials: &[Trial]) -> Claim {
    let mut behind = Vec::new();
    let mut wins = vec![0.0; trials.len()];
    for (index, damage) in options.damages.iter().enumerate() {
        if *damage == Damage::None {
            continue;
        }
        let of = Lived { trials, index };
        let ours = of.captures(Entrant::Both, 0, 3);
        let sarsa = of.captures(Entrant::Sarsa, 0, 3);
        for (wins, (a, b)) in wins.iter_mut().zip(ours.iter().zip(&sarsa)) {
            *wins += f64::from(u8::from(a > b));
        }
        if mean(&ours) <= mean(&sarsa) {
            behind.push(damage.to_string());
        }
    }
    Expectation::new(
        "recover.ahead_of_sarsa",
        "7.1.1",
        "damages a seed is ahead in",
    )
    .extension()
    .rule(Rule::Judged {
        text: format!("behind in at most one damage: {}", behind.join(" ")),
        met: behind.len() <= 1,
    })
    .note("captures of both levels against those of Sarsa(λ), first 3000 damaged actions")
    .judge(&wins)
}
