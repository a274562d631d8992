//! The table of damages on the page of the one learner: its first 3000 damaged actions beside two kinds
//! of Sarsa(λ), as claimed, and beside both levels of the book's agent on the same seeds.

use std::fmt::Write;

use host_sim::report::{AHEAD, Summary, mean, paired_t};

use super::{arm, claim, damages};

fn seeds(seeds: &[Option<f64>]) -> Vec<f64> {
    seeds.iter().flatten().copied().collect()
}

/// What a rival captured, Holm's p, and whether the one learner is ahead by its mean and for sure.
struct Beside {
    cells: String,
    mean: bool,
    sure: bool,
}

fn beside(one: &Summary, id: &str, rival: &str) -> Beside {
    let name = format!("one.recover.{id}.over_sarsa{rival}_3000");
    let found = one.find(&name).unwrap_or_else(|| panic!("{name}"));
    let (ours, theirs) = (
        arm(&found.per_seed),
        arm(found.against.as_ref().expect("pairs")),
    );
    let holm = found.tested.as_ref().and_then(|it| it.holm);
    let written = holm.map_or("–".to_owned(), |it| format!("{it:.2e}"));
    Beside {
        cells: format!("{theirs:.0} | {written}"),
        mean: ours > theirs,
        sure: ours > theirs && holm.is_some_and(|it| it <= AHEAD),
    }
}

/// Each damage, with t paired by seed beside both levels; nothing corrects that for its number.
pub(crate) fn by_damage(one: &Summary, recover: &Summary) -> String {
    let mut text = String::from(
        "| first 3000 actions after | the one learner | Sarsa(λ) | p, Holm | with history | p, Holm | \
         both levels | t |\n|---|---:|---:|---:|---:|---:|---:|---:|\n",
    );
    let (mut rows, mut ahead) = (0, [[0; 2]; 2]);
    for (damage, id) in damages(recover) {
        let name = format!("one.recover.{id}.over_sarsa_3000");
        let mind = one.find(&name).unwrap_or_else(|| panic!("{name}"));
        let mind = seeds(&mind.per_seed);
        let both = seeds(&claim(recover, id, "relearn_3000").per_seed);
        let rivals = ["", "_history"].map(|rival| beside(one, id, rival));
        for (rival, counts) in rivals.iter().zip(&mut ahead) {
            counts[0] += usize::from(rival.mean);
            counts[1] += usize::from(rival.sure);
        }
        rows += 1;
        writeln!(
            text,
            "| `{damage}` | {:.0} | {} | {} | {:.0} | {} |",
            mean(&mind),
            rivals[0].cells,
            rivals[1].cells,
            mean(&both),
            signed(paired_t(&mind, &both).statistic),
        )
        .expect("a text grows");
    }
    let [percepts, history] = ahead;
    writeln!(
        text,
        "\nOf {rows} damages it is ahead of Sarsa(λ) on percepts in {} by means and in {} after Holm's \
         correction over both columns, of Sarsa(λ) on two-step histories in {} and {}.",
        percepts[0], percepts[1], history[0], history[1],
    )
    .expect("a text grows");
    text
}

/// With a minus as it is printed.
pub(crate) fn signed(value: f64) -> String {
    format!("{value:.1}").replace('-', "−")
}
