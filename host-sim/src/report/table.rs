//! Tables for the terminal: ours beside the book's number, with the verdict.
//!
//! Plain text in columns, numbers to the right; the same words as in the summary.

use serde_json::Value;

use super::claims::{Claim, Ours, Reference};
use super::summary::Table;

/// One line a claim: id, what the number counts, ours, the printed number, verdict.
///
/// ```
/// use host_sim::report::{Expectation, claims_text};
/// let claim = Expectation::new("forage.captures", "6.2.5", "captures")
///     .book((20.4, 1.53, 10))
///     .judge(&[27.0, 28.0]);
/// let text = claims_text(&[claim]);
/// assert!(text.contains("27.5 ± 0.707 (2)") && text.contains("20.4 ± 1.53 (10)"));
/// assert!(text.trim_end().ends_with("measured"));
/// ```
#[must_use]
pub fn claims_text(claims: &[Claim]) -> String {
    let head = ["claim", "unit", "ours", "printed", "verdict"];
    let mut lines = vec![head.map(str::to_owned).to_vec()];
    for claim in claims {
        lines.push(vec![
            format!("{} [{}]", claim.id, claim.section),
            claim.unit.clone(),
            ours_text(&claim.ours),
            claim
                .reference
                .as_ref()
                .map_or_else(|| "–".to_owned(), reference),
            claim.verdict.to_string(),
        ]);
    }
    columns(
        &lines,
        &[Side::Left, Side::Left, Side::Right, Side::Right, Side::Left],
    )
}

/// Digits in groups of three.
pub(crate) fn grouped(number: u64) -> String {
    let digits = number.to_string();
    let mut text = String::new();
    for (index, digit) in digits.chars().enumerate() {
        if index > 0 && (digits.len() - index).is_multiple_of(3) {
            text.push(',');
        }
        text.push(digit);
    }
    text
}

/// A table of a summary as text.
///
/// ```
/// use host_sim::report::{Table, table_text};
/// let mut table = Table::new(&["controller", "captures"]);
/// table.row(["sector".into(), 14.25.into()]);
/// assert_eq!(table_text(&table), "controller  captures\n────────────────────\nsector         14.25\n");
/// ```
#[must_use]
pub fn table_text(table: &Table) -> String {
    let mut lines = vec![table.columns.clone()];
    for row in &table.rows {
        lines.push(row.iter().map(cell).collect());
    }
    let sides: Vec<Side> = (0..table.columns.len())
        .map(|column| {
            let words = |row: &Vec<Value>| row.get(column).is_some_and(Value::is_string);
            if table.rows.iter().any(words) {
                Side::Left
            } else {
                Side::Right
            }
        })
        .collect();
    columns(&lines, &sides)
}

/// An estimate with its standard deviation or, where that is another estimator's, its interval; and
/// the number of seeds.
#[must_use]
pub fn ours_text(ours: &Ours) -> String {
    let never = ours.never.filter(|&never| never > 0);
    let never = never.map_or_else(String::new, |never| format!(", {never} never"));
    let n = format!("({}{never})", ours.n);
    let Some(value) = ours.value else {
        let word = if ours.never.is_some() {
            "never"
        } else {
            "not there"
        };
        return format!("{word} {n}");
    };
    let spread = match (ours.sd, &ours.interval) {
        (Some(sd), _) => format!(" ± {}", number(sd, 3)),
        (None, Some(range)) => {
            let high = range
                .high
                .map_or_else(|| "never".to_owned(), |it| number(it, 3));
            format!(" [{}, {high}]", number(range.low, 3))
        }
        (None, None) => String::new(),
    };
    format!("{}{spread} {n}", number(value, 4))
}

/// The printed number with its deviation and runs.
pub(super) fn reference(printed: &Reference) -> String {
    let sd = printed
        .sd
        .map_or_else(String::new, |sd| format!(" ± {}", number(sd, 3)));
    let n = printed.n.map_or_else(String::new, |n| format!(" ({n})"));
    format!("{}{sd}{n}", number(printed.mean, 4))
}

/// One cell of a table.
pub(super) fn cell(value: &Value) -> String {
    match value {
        Value::String(words) => words.clone(),
        Value::Null => "–".to_owned(),
        Value::Number(whole) if whole.is_i64() || whole.is_u64() => whole.to_string(),
        Value::Number(float) => number(float.as_f64().unwrap_or(f64::NAN), 4),
        other => other.to_string(),
    }
}

/// A number to so many significant digits, without trailing zeros.
pub(super) fn number(value: f64, digits: i32) -> String {
    if value == 0.0 || !value.is_finite() {
        return format!("{value}");
    }
    let magnitude = value.abs().log10().floor() as i32;
    if !(-4..9).contains(&magnitude) {
        return format!("{value:.*e}", digits as usize - 1);
    }
    let decimals = (digits - 1 - magnitude).max(0) as usize;
    let text = format!("{value:.decimals$}");
    if text.contains('.') {
        text.trim_end_matches('0').trim_end_matches('.').to_owned()
    } else {
        text
    }
}

#[derive(Clone, Copy, PartialEq)]
enum Side {
    Left,
    Right,
}

fn columns(lines: &[Vec<String>], sides: &[Side]) -> String {
    let width = |text: &str| text.chars().count();
    let widths: Vec<usize> = (0..sides.len())
        .map(|column| {
            let cells = lines.iter().filter_map(|line| line.get(column));
            cells.map(|cell| width(cell)).max().unwrap_or(0)
        })
        .collect();
    let mut text = String::new();
    for (index, line) in lines.iter().enumerate() {
        let mut row = String::new();
        for ((cell, &side), &wide) in line.iter().zip(sides).zip(&widths) {
            let pad = " ".repeat(wide - width(cell));
            match side {
                Side::Left => row.push_str(&format!("{cell}{pad}  ")),
                Side::Right => row.push_str(&format!("{pad}{cell}  ")),
            }
        }
        text.push_str(row.trim_end());
        text.push('\n');
        if index == 0 {
            let total = widths.iter().sum::<usize>() + 2 * widths.len().saturating_sub(1);
            text.push_str(&"─".repeat(total));
            text.push('\n');
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::{number, ours_text};
    use crate::report::Expectation;

    #[test]
    fn an_estimate_stands_beside_its_own_error() {
        let claim = || Expectation::new("a.b", "6.1", "captures");
        for (claim, text) in [
            (claim().judge(&[5.0]), "5 (1)"),
            (claim().judge(&[4.0, 6.0]), "5 ± 1.41 (2)"),
            (claim().judge(&[]), "not there (0)"),
            (
                claim().judge_ratio(&[2.0, 4.0], &[1.0, 2.0]),
                "2 [2, 2] (2)",
            ),
            (claim().judge_time(&[9.0, f64::NAN, 7.0]), "9 (3, 1 never)"),
            (claim().judge_time(&[f64::NAN]), "never (1, 1 never)"),
            (claim().judge_count(1516.0), "1516 (1)"),
        ] {
            assert_eq!(ours_text(&claim.ours), text);
        }
    }

    #[test]
    fn numbers_have_the_digits_that_matter() {
        for (value, text) in [
            (0.0, "0"),
            (9.5, "9.5"),
            (3000.0, "3000"),
            (12345.6, "12346"),
            (0.333_333, "0.3333"),
            (-2.5e-7, "-2.500e-7"),
        ] {
            assert_eq!(number(value, 4), text);
        }
    }
}
