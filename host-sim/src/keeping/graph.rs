//! From sensors to reward: what is perceived, what is done then, what is expected of it and what that
//! is worth, as one SVG.

use core::fmt::Write as _;

use super::portrait::{Portrait, Schema, Sign};
use crate::report::escaped;

/// Schemas that are drawn.
const MOST: usize = 16;
/// The picture's width, and where its columns begin and end.
const WIDTH: f64 = 360.0;
const SENSORS: f64 = 84.0;
const BOX: (f64, f64) = (128.0, 238.0);
const RESULTS: f64 = 284.0;
/// From one schema to the next, and what a row of text needs at least.
const ROW: f64 = 25.0;
const LINE: f64 = 16.0;
/// The colours of the actions: Okabe and Ito, but for the yellow, which is no line on white.
const COLOURS: [&str; 6] = [
    "#0072b2", "#d55e00", "#009e73", "#cc79a7", "#56b4e9", "#7a4f00",
];

/// Where something stands, top to bottom.
struct Column<'a> {
    names: Vec<&'a str>,
    height: f64,
}

impl<'a> Column<'a> {
    fn of(signs: impl Iterator<Item = &'a Sign>, height: f64) -> Self {
        let mut names = Vec::new();
        for sign in signs {
            if !names.contains(&sign.item.as_str()) {
                names.push(&sign.item);
            }
        }
        Self { names, height }
    }

    /// As the portrait has its items, the others behind them.
    fn sorted(mut self, portrait: &Portrait) -> Self {
        let place = |name: &&str| {
            let found = portrait.items.iter().position(|it| it.name == **name);
            found.unwrap_or(usize::MAX)
        };
        self.names.sort_by_key(place);
        self
    }

    fn y(&self, name: &str) -> f64 {
        let place = self.names.iter().position(|it| *it == name).unwrap_or(0);
        (place as f64 + 0.5) * self.height / self.names.len().max(1) as f64
    }
}

/// What a schema brings by itself: its reliability times the largest inherent value in its result.
fn reward(schema: &Schema, portrait: &Portrait) -> f64 {
    let on = schema.result.iter().filter(|it| it.on);
    let inherent = on.filter_map(|sign| portrait.items.iter().find(|it| it.name == sign.item));
    let most = inherent.map(|it| it.inherent).fold(0.0, f64::max);
    most * schema.reliability.unwrap_or(1.0)
}

/// Whether something is on afterwards that was not asked for before.
fn leads_on(schema: &Schema) -> bool {
    let mut on = schema.result.iter().filter(|it| it.on);
    schema.result.is_empty() || on.any(|it| !schema.context.contains(it))
}

/// The schemas that bring most by themselves, then those of which something follows that are worth
/// most; of each kind half.
fn chosen(portrait: &Portrait) -> Vec<&Schema> {
    let mut direct: Vec<&Schema> = portrait.schemas.iter().collect();
    direct.retain(|it| reward(it, portrait) > 0.0 && leads_on(it));
    direct.sort_by(|a, b| reward(b, portrait).total_cmp(&reward(a, portrait)));
    let mut chosen: Vec<&Schema> = Vec::new();
    for it in &direct {
        add(it, MOST / 2, &mut chosen);
    }
    for it in portrait
        .schemas
        .iter()
        .filter(|it| it.worth() > 0.0 && leads_on(it))
    {
        add(&it, MOST, &mut chosen);
    }
    chosen
}

/// Adds one that is not there yet, while there are not too many.
fn add<'a>(schema: &&'a Schema, most: usize, chosen: &mut Vec<&'a Schema>) {
    if chosen.len() < most && !chosen.iter().any(|it| it.brief == schema.brief) {
        chosen.push(schema);
    }
}

/// The graph of the schemas that are worth most; nothing where nothing is worth anything.
pub(super) fn graph(portrait: &Portrait) -> String {
    let mut chosen = chosen(portrait);
    if chosen.is_empty() {
        return String::new();
    }
    let first = |it: &Schema| {
        let on = it.context.iter().find(|sign| sign.on);
        let name = on.map(|it| it.item.as_str());
        portrait
            .items
            .iter()
            .position(|it| Some(it.name.as_str()) == name)
    };
    // Ways that begin alike lie beside each other.
    chosen.sort_by_key(|it| first(it).unwrap_or(usize::MAX));
    // An agent's contexts name every item; those that are off say little.
    let shown = |sign: &&Sign| sign.on || portrait.kind == "mind";
    let contexts = || chosen.iter().flat_map(|it| it.context.iter()).filter(shown);
    let results = || {
        chosen
            .iter()
            .flat_map(|it| it.result.iter().filter(|it| it.on))
    };
    let (sensors, after) = (Column::of(contexts(), 0.0), Column::of(results(), 0.0));
    let texts = sensors.names.len().max(after.names.len()) as f64 * LINE;
    let height = (chosen.len() as f64 * ROW).max(texts);
    let sensors = Column { height, ..sensors }.sorted(portrait);
    let after = Column { height, ..after }.sorted(portrait);
    let most = chosen.iter().map(|it| it.worth()).fold(0.0, f64::max);
    let (mut lines, mut boxes) = (String::new(), String::new());
    for (place, schema) in chosen.iter().enumerate() {
        let y = (place as f64 + 0.5) * height / chosen.len() as f64;
        let action = portrait.actions.iter().position(|it| *it == schema.action);
        let colour = COLOURS[action.unwrap_or(0) % COLOURS.len()];
        let share = schema.worth() / most;
        for sign in schema.context.iter().filter(shown) {
            line(
                &mut lines,
                (SENSORS + 4.0, sensors.y(&sign.item)),
                (BOX.0, y),
                colour,
                sign.on,
                share,
            );
        }
        for sign in schema.result.iter().filter(|it| it.on) {
            line(
                &mut lines,
                (BOX.1, y),
                (RESULTS - 4.0, after.y(&sign.item)),
                colour,
                true,
                share,
            );
        }
        boxes.push_str(&schema_box(schema, y, colour));
        if schema.result.is_empty() {
            let _ = write!(
                boxes,
                "<rect x=\"{:.1}\" y=\"{:.1}\" width=\"{:.1}\" height=\"8\" fill=\"{colour}\"/>",
                BOX.1 + 6.0,
                y - 4.0,
                share * (WIDTH - BOX.1 - 12.0),
            );
        }
    }
    let mut names = String::new();
    for name in &sensors.names {
        text(&mut names, SENSORS, sensors.y(name), "end", "", name);
    }
    for name in &after.names {
        let inherent = portrait.items.iter().find(|it| it.name == *name);
        let inherent = inherent.map_or(0.0, |it| it.inherent);
        let (class, said) = if inherent == 0.0 {
            ("", (*name).to_owned())
        } else {
            ("worth", format!("{name} = {inherent}"))
        };
        text(&mut names, RESULTS, after.y(name), "start", class, &said);
    }
    let third = if after.names.is_empty() {
        "worth"
    } else {
        "expected"
    };
    let mut heads = String::new();
    text(&mut heads, SENSORS, -14.0, "end", "head", "perceived");
    text(
        &mut heads,
        (BOX.0 + BOX.1) / 2.0,
        -14.0,
        "middle",
        "head",
        "done",
    );
    text(&mut heads, RESULTS, -14.0, "start", "head", third);
    format!(
        "<svg class=\"graph\" viewBox=\"0 -26 {WIDTH} {:.0}\" role=\"img\" \
         aria-label=\"From what is perceived over actions to what is worth having\">\
         {lines}{boxes}{names}{heads}</svg>",
        height + 32.0
    )
}

fn line(to: &mut String, from: (f64, f64), end: (f64, f64), colour: &str, on: bool, share: f64) {
    let middle = (from.0 + end.0) / 2.0;
    let dashes = if on { "" } else { " stroke-dasharray=\"2 3\"" };
    let _ = write!(
        to,
        "<path d=\"M{:.1} {:.1}C{middle:.1} {:.1} {middle:.1} {:.1} {:.1} {:.1}\" fill=\"none\" \
         stroke=\"{colour}\" stroke-width=\"{:.1}\" opacity=\"{}\"{dashes}/>",
        from.0,
        from.1,
        from.1,
        end.1,
        end.0,
        end.1,
        if on { 0.8 + 2.2 * share } else { 0.7 },
        if on { "0.85" } else { "0.4" },
    );
}

fn schema_box(schema: &Schema, y: f64, colour: &str) -> String {
    let mut drawn = format!(
        "<g><title>{}</title><rect x=\"{:.1}\" y=\"{:.1}\" width=\"{:.1}\" height=\"20\" rx=\"4\" \
         fill=\"#fff\" stroke=\"{colour}\"/>",
        escaped(&schema.text),
        BOX.0,
        y - 10.0,
        BOX.1 - BOX.0,
    );
    text(&mut drawn, BOX.0 + 5.0, y, "start", "", &schema.action);
    let worth = format!("{:.1}", schema.worth());
    text(&mut drawn, BOX.1 - 5.0, y, "end", "", &worth);
    drawn.push_str("</g>");
    drawn
}

fn text(to: &mut String, x: f64, y: f64, anchor: &str, class: &str, words: &str) {
    let _ = write!(
        to,
        "<text x=\"{x:.1}\" y=\"{:.1}\" text-anchor=\"{anchor}\" class=\"{class}\">{}</text>",
        y + 4.0,
        escaped(words)
    );
}
