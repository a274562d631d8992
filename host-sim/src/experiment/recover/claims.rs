//! What is concluded from the lives: the claims of the recovery experiment.

use super::life::Course;
use super::options::RecoverOptions;
use super::rivals::Rival;
use super::tables;
use super::trial::{Entrant, Lived, Trial, before, entrants};
use crate::report::{Better, Bound, Claim, Expectation, Reference, Rule, Statistic, Summary, mean};
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
    for rival in Rival::ALL {
        summary.parameter(&format!("{rival:?}"), format!("{:?}", rival.tuned()));
    }
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
        summary.claims.extend(ahead(options, trials));
    }
    if options.is_varied() {
        summary.vary();
    }
    summary
}

/// What is asked of every damage.
fn recovery(of: &Lived<'_>, id: &str) -> Vec<Claim> {
    let claim = |name: &str, unit: &str| {
        Expectation::new(format!("recover.{id}.{name}"), "7.1.1", unit).extension()
    };
    let late = of.captures(Entrant::Both, 10, 13);
    let random = of.captures(Entrant::Random, 10, 13);
    // What a damaged life brings over what its twin brings meanwhile.
    let share = |name: &str, who: Entrant, from: u32| {
        let when = match from {
            0 => "the first 3000 damaged actions",
            3 => "damaged actions 3000 to 6000",
            _ => "damaged actions 10,000 to 13,000",
        };
        let note = format!("{}, {when}, over its undamaged twin", who.name());
        let rule = if name == "relearn_10000@2" {
            Rule::mean(Bound::AtLeast(0.9))
        } else {
            Rule::Measured
        };
        let (ours, twins) = (
            of.captures(who, from, from + 3),
            of.of_twins(who, from, from + 3),
        );
        let it = claim(name, "share of the twin").note(note).rule(rule);
        it.family(&format!("recover.{}", name.trim_end_matches("@2")))
            .judge_ratio(&ours, &twins)
    };
    let rival = Entrant::of(Rival::BEST);
    vec![
        share("relearn_3000@2", Entrant::Both, 0),
        share("relearn_6000", Entrant::Both, 3),
        share("relearn_10000@2", Entrant::Both, 10),
        share("plain_3000@2", Entrant::BothPlain, 0),
        share("no_habits_3000@2", Entrant::BothNoHabits, 0),
        share("no_level2_3000", Entrant::NoLevel2, 0),
        share("level1_3000@2", Entrant::Surprise, 0),
        share("level1_10000@2", Entrant::Surprise, 10),
        claim("time_to_recover", "actions")
            .rule(Rule::median(Bound::AtMost(4000.0)))
            .note("both levels; until captures stay at .9 of the twin's, within the twin's error")
            .judge_time(&of.times(Entrant::Both)),
        claim("over_sarsa_3000@2", "ratio")
            .family(OVER_SARSA)
            .rule(Rule::All(vec![
                Rule::mean(Bound::AtLeast(1.4)),
                Rule::t(Bound::AtLeast(3.0)),
                Rule::Keeps(Statistic::Holm, Bound::AtMost(0.05)),
            ]))
            .note(format!(
                "captures of both levels over those of {}, the best tuned of six rivals, first 3000 \
                 damaged actions",
                rival.name()
            ))
            .judge_ratio(
                &of.captures(Entrant::Both, 0, 3),
                &of.captures(rival, 0, 3),
            ),
        claim("level2_over_level1", "ratio")
            .family("recover.level2_over_level1")
            .rule(Rule::mean(Bound::AtLeast(1.08)))
            .note("captures of both levels over level 1, with surprise, 13,000 damaged actions")
            .judge_ratio(
                &of.captures(Entrant::Both, 0, 13),
                &of.captures(Entrant::Surprise, 0, 13),
            ),
        claim("over_random@2", "captures in 3000 actions")
            .family("recover.over_random")
            .rule(Rule::All(vec![
                Rule::mean(Bound::Above(0.0)),
                Rule::Keeps(Statistic::Holm, Bound::AtMost(0.05)),
            ]))
            .note("both levels less random, damaged actions 10,000 to 13,000")
            .judge_difference(&late, &random),
    ]
}

/// The family of what is asked of both levels beside the best rival, damage by damage.
const OVER_SARSA: &str = "recover.over_sarsa_3000@2";

/// What the book and we say of its own damage.
fn camera(of: &Lived<'_>) -> Vec<Claim> {
    let claim = |name: &str, section: &str, unit: &str| {
        Expectation::new(format!("recover.camera.{name}"), section, unit)
    };
    let (share, of_28) = ("share of before", "captures of 28");
    let removed = |place: usize| -> Vec<f64> {
        of.trials
            .iter()
            .map(|it| f64::from(it.removed[place]))
            .collect()
    };
    let ours = of.captures(Entrant::Both, 0, 3);
    let told = of.captures(Entrant::Told, 0, 3);
    let mut all = vec![
        claim("after@2", "6.3", share)
            .book(1.6 / 22.9)
            .rule(Rule::Compared)
            .note(
                "frozen from the damage on, first 3000 actions; a robot that aims 12° beside its \
                 target reaches it in a spiral",
            )
            .judge(&of.of(Entrant::Frozen, |it| it.share(0, 3))),
        claim("after_removed@2", "6.3", of_28)
            .book((1.6, 0.84, 10))
            .rule(Rule::Book(Better::Neither))
            .note("the same robot, counted as the book counts: specimens that are taken are gone")
            .judge(&removed(0)),
        claim("reliabilities_only@2", "6.3", of_28)
            .book((17.4, 3.37, 10))
            .rule(Rule::Book(Better::Neither))
            .note("after 13,000 damaged actions in which only reliabilities and values adapted")
            .judge(&removed(1)),
        claim("regained", "6.3", of_28)
            .book((15.8, 3.47, 10))
            .rule(Rule::Book(Better::Higher))
            .note(
                "what adapting reliabilities brings over the frozen robot; in the book 17.4 ± 3.37 \
                 less 1.6 ± .84, its errors added in squares",
            )
            .judge_difference(&removed(1), &removed(0)),
        claim("reliabilities_only_late", "6.3", share)
            .extension()
            .note("the same robot with replacement, damaged actions 10,000 to 13,000")
            .judge(&of.of(Entrant::Reliabilities, |it| it.share(10, 13))),
        claim("vs_told_3000", "7.1.1", "ratio")
            .extension()
            .rule(Rule::mean(Bound::AtLeast(0.9)))
            .note("captures of both levels over those of a servo that is told of the damage")
            .judge_ratio(&ours, &told),
    ];
    for (name, who) in [
        ("no_habits", Entrant::BothNoHabits),
        ("plain", Entrant::BothPlain),
        ("no_level2", Entrant::NoLevel2),
        ("level1", Entrant::Surprise),
        ("sarsa", Entrant::of(Rival::BEST)),
        ("told", Entrant::Told),
        ("random", Entrant::Random),
    ] {
        all.push(
            claim(&format!("{name}_time_to_recover"), "7.1.1", "actions")
                .extension()
                .note(format!("{}, beside its own undamaged twin", who.name()))
                .judge_time(&of.times(who)),
        );
    }
    let never = of.times(Entrant::Random);
    let never: Vec<bool> = never.iter().map(|it| it.is_infinite()).collect();
    all.push(
        claim("random_never", "–", "share of seeds")
            .extension()
            .rule(Rule::mean(Bound::AtLeast(0.95)))
            .note("random actions do not recover: chance does not win by this measure")
            .judge_share(&never),
    );
    let printed: [(usize, &str, Reference, Rule); 2] = [
        (
            0,
            "before",
            (0.405, 0.010, 10).into(),
            Rule::Book(Better::Neither),
        ),
        (1, "after", 0.348.into(), Rule::Compared),
    ];
    for (place, when, book, rule) in printed {
        all.push(
            claim(
                &format!("mean_reliability_{when}@2"),
                "6.3",
                "mean reliability",
            )
            .book(book)
            .rule(rule)
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
    all.push(
        claim(
            "level2_reliability_drop",
            "6.3",
            "share of predictions lost",
        )
        .book(0.44)
        .rule(Rule::Compared)
        .note(
            "both levels with surprise, said before each action; the book counts in hindsight, with \
             reliabilities only, .886 - .446 as printed, .275 from the .721 that fits its t",
        )
        .judge_difference(
            &of.of(Entrant::Both, |it| it.predictions[0]),
            &of.of(Entrant::Both, |it| it.predictions[1]),
        ),
    );
    // The second of a name: tuned alike, and trained as long as is best.
    let baselines = [
        ("q", "@2", Entrant::Q),
        ("q_history", "@2", Entrant::QHistory),
        ("sarsa_lambda", "@2", Entrant::Sarsa),
        ("sarsa_lambda_history", "@2", Entrant::SarsaHistory),
        ("sarsa_lambda_linear", "", Entrant::Linear),
        ("sarsa_lambda_habits", "", Entrant::Habits),
        ("told", "", Entrant::Told),
        ("sector", "", Entrant::Sector),
        ("random", "", Entrant::Random),
    ];
    for (name, version, who) in baselines {
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
                    format!("baseline.{name}{part}{version}"),
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
        Expectation::new(format!("recover.none.{id}@2"), "7.1.1", "share kept")
            .extension()
            .rule(Rule::Equivalent(Statistic::Low, Bound::AtLeast(0.97)))
            .note(format!(
                "captures in 16,000 undamaged actions, {note}, with surprise over without"
            ))
            .judge_ratio(&ours, &plain)
    };
    let (both, level1) = (of.of(Entrant::Both, all), of.of(Entrant::Surprise, all));
    vec![
        cost("cost", "both levels", Entrant::Both, Entrant::BothPlain),
        cost("cost_level1", "level 1", Entrant::Surprise, Entrant::Plain),
        Expectation::new("recover.none.level2_over_level1", "7.1.1", "ratio")
            .extension()
            .rule(Rule::mean(Bound::AtLeast(1.08)))
            .note("captures in 16,000 undamaged actions, both with surprise")
            .judge_ratio(&both, &level1),
        Expectation::new("recover.none.alarms", "7.1.1", "alarms in 16,000 actions")
            .extension()
            .judge(&of.of(Entrant::Both, |it| f64::from(it.alarms[0] + it.alarms[1]))),
        Expectation::new("recover.none.time_to_recover", "–", "actions")
            .extension()
            .rule(Rule::median(Bound::AtMost(0.0)))
            .note(
                "both levels with other chance beside their twin: two undamaged lives differ no more \
                 than the measure allows",
            )
            .judge_time(&controls(of.trials, Course::recovered_after)),
        Expectation::new("recover.none.share", "–", "share of the twin")
            .extension()
            .note("captures of the same undamaged lives, 13,000 actions")
            .judge_ratio(
                &controls(of.trials, |it, _| it.captures(0, 13)),
                &of.of_twins(Entrant::Both, 0, 13),
            ),
    ]
}

/// A number of each seed's undamaged life with other chance, beside its twin.
fn controls(trials: &[Trial], number: impl Fn(&Course, &Course) -> f64) -> Vec<f64> {
    let of = |trial: &Trial| {
        let twin = trial.twin(Entrant::Both);
        twin.map_or(f64::NAN, |twin| number(&trial.control, twin))
    };
    trials.iter().map(of).collect()
}

/// In how many damages both levels are ahead of the best rival at first.
fn ahead(options: &RecoverOptions, trials: &[Trial]) -> [Claim; 2] {
    let mut wins = vec![0.0; trials.len()];
    for (index, damage) in options.damages.iter().enumerate() {
        if *damage == Damage::None {
            continue;
        }
        let of = Lived { trials, index };
        let ours = of.captures(Entrant::Both, 0, 3);
        let sarsa = of.captures(Entrant::of(Rival::BEST), 0, 3);
        for (wins, (a, b)) in wins.iter_mut().zip(ours.iter().zip(&sarsa)) {
            *wins += f64::from(u8::from(a > b));
        }
    }
    let note = format!(
        "captures of both levels against those of {}, first 3000 damaged actions",
        Rival::BEST.name()
    );
    let family = Expectation::new(
        "recover.family.ahead_after_holm@2",
        "7.1.1",
        "damages that both levels are ahead in",
    );
    let wins_of = Expectation::new(
        "recover.ahead_of_sarsa@3",
        "7.1.1",
        "damages a seed is ahead in",
    );
    [
        family
            .extension()
            .family(OVER_SARSA)
            .rule(Rule::mean(Bound::AtLeast(12.0)))
            .note(format!(
                "{note}; of thirteen, p <= .05 after Holm's correction"
            ))
            .judge_family(),
        wins_of.extension().note(note).judge(&wins),
    ]
}
