//! The page of a run, `report.html`: one file that asks the network for nothing.
//!
//! How the claims came out, what was missed, the figures with the forest plot first, what an
//! experiment adds (a replay, schemas), all claims and all tables, which sort by a click on a head.

use serde_json::Value;

use super::claims::{Claim, Verdict};
use super::figure::Picture;
use super::summary::{Summary, Table};
use super::table::{cell, ours_text, reference};

/// A part that an experiment adds to its page.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Section {
    /// Its head, as text.
    pub title: String,
    /// What stands below it, as HTML; names of classes and ids are its own.
    pub html: String,
}

/// The page: what is said first, the record, the pictures with the names of their files, the rest.
pub(super) fn page(
    headline: &str,
    summary: &Summary,
    pictures: &[(String, Picture)],
    sections: &[Section],
) -> String {
    let mut body = format!(
        "<header><h1>{}</h1><p class=\"lead\">{}</p><p>{}. Status: {}.</p>\
         <p class=\"command\"><code>{}</code></p></header>\n",
        escaped(&summary.experiment),
        escaped(headline),
        escaped(&summary.sample()),
        summary.status,
        escaped(&summary.command),
    );
    if !summary.claims.is_empty() {
        body.push_str(&verdicts(summary));
    }
    // The forest plot sums up what the other figures show.
    let forest = |(name, _): &&(String, Picture)| name.starts_with("forest");
    let first = pictures.iter().filter(forest);
    let rest = pictures.iter().filter(|it| !forest(it));
    let figures: String = first.chain(rest).map(figure).collect();
    if !figures.is_empty() {
        body.push_str(&format!("<section><h2>Figures</h2>{figures}</section>\n"));
    }
    for Section { title, html } in sections {
        let title = escaped(title);
        body.push_str(&format!("<section><h2>{title}</h2>{html}</section>\n"));
    }
    if !summary.claims.is_empty() {
        body.push_str(&format!(
            "<section><h2>All claims</h2>{}</section>\n",
            claims(&summary.claims)
        ));
    }
    for (title, table) in &summary.tables {
        let title = escaped(
            title
                .trim_start_matches(|it: char| it.is_ascii_digit())
                .trim(),
        );
        body.push_str(&format!(
            "<section><h2>{title}</h2>{}</section>\n",
            rows(table)
        ));
    }
    if !summary.parameters.is_empty() {
        body.push_str(&parameters(summary));
    }
    whole(&summary.experiment, &body)
}

/// A page that is of no run: what is said first, and its parts.
///
/// ```
/// use host_sim::report::{Section, leaf};
/// let section = Section { title: "Items".to_owned(), html: "<p>s1</p>".to_owned() };
/// let page = leaf("a brain", "it has lived", &[section]);
/// assert!(page.contains("<h1>a brain</h1>") && page.contains("<h2>Items</h2><p>s1</p>"));
/// ```
#[must_use]
pub fn leaf(title: &str, lead: &str, sections: &[Section]) -> String {
    let mut body = format!(
        "<header><h1>{}</h1><p class=\"lead\">{}</p></header>\n",
        escaped(title),
        escaped(lead)
    );
    for Section { title, html } in sections {
        let title = escaped(title);
        body.push_str(&format!("<section><h2>{title}</h2>{html}</section>\n"));
    }
    whole(title, &body)
}

/// The page around its body.
fn whole(title: &str, body: &str) -> String {
    let template = include_str!("page.html");
    let parts = [
        ("__TITLE__", escaped(title)),
        ("__STYLE__", include_str!("page.css").to_owned()),
        ("__SCRIPT__", include_str!("page.js").to_owned()),
    ];
    let page = parts
        .iter()
        .fold(template.to_owned(), |page, (mark, part)| {
            page.replacen(mark, part, 1)
        });
    // Last, so that nothing in it is taken for a mark.
    page.replacen("__BODY__", body, 1)
}

/// Text as HTML, fit for attributes too.
#[must_use]
pub fn escaped(text: &str) -> String {
    let mut safe = String::with_capacity(text.len());
    for letter in text.chars() {
        match letter {
            '&' => safe.push_str("&amp;"),
            '<' => safe.push_str("&lt;"),
            '>' => safe.push_str("&gt;"),
            '"' => safe.push_str("&quot;"),
            other => safe.push(other),
        }
    }
    safe
}

/// Whether a verdict is good news, bad news or none, as a class of the style.
const fn tone(verdict: Verdict) -> &'static str {
    match verdict {
        Verdict::Reproduced | Verdict::Exceeded | Verdict::Met => "good",
        Verdict::NotReproduced | Verdict::Missed => "bad",
        Verdict::ContradictsItself => "odd",
        Verdict::Compared | Verdict::TooSmall | Verdict::Measured => "plain",
    }
}

/// How many claims came out how, and those that were missed.
fn verdicts(summary: &Summary) -> String {
    let mut chips = String::new();
    for verdict in Verdict::ALL {
        let same = summary.claims.iter().filter(|it| it.verdict == verdict);
        let count = same.count();
        if count > 0 {
            let tone = tone(verdict);
            chips.push_str(&format!(
                "<li class=\"{tone}\"><b>{count}</b> {verdict}</li>"
            ));
        }
    }
    let missed: Vec<&Claim> = summary.missed().collect();
    let below = if missed.is_empty() {
        String::new()
    } else {
        format!("<h3>Missed</h3>{}", claim_rows(missed.into_iter()))
    };
    format!("<section><h2>Verdicts</h2><ul class=\"chips\">{chips}</ul>{below}</section>\n")
}

fn figure((name, picture): &(String, Picture)) -> String {
    let title = escaped(&picture.title);
    let caption = escaped(&picture.caption);
    format!(
        "<figure id=\"figure-{}\"><img alt=\"{title}. {caption}\" src=\"data:image/svg+xml,{}\">\
         <figcaption><b>{title}</b> {caption}</figcaption></figure>\n",
        escaped(name),
        in_an_address(&picture.svg),
    )
}

/// A text as it may stand in an address between double quotes.
fn in_an_address(text: &str) -> String {
    let mut safe = String::with_capacity(text.len() + text.len() / 4);
    for letter in text.chars() {
        match letter {
            '%' => safe.push_str("%25"),
            '#' => safe.push_str("%23"),
            '"' => safe.push('\''),
            '\'' => safe.push_str("%27"),
            '<' => safe.push_str("%3C"),
            '>' => safe.push_str("%3E"),
            '&' => safe.push_str("%26"),
            '\n' => safe.push(' '),
            other => safe.push(other),
        }
    }
    safe
}

fn claims(claims: &[Claim]) -> String {
    let input = "<p class=\"find\"><label>Only those with <input type=\"search\" \
                 data-find=\"claims\"></label></p>";
    format!("{input}{}", claim_rows(claims.iter()))
}

fn claim_rows<'a>(claims: impl Iterator<Item = &'a Claim>) -> String {
    let mut rows = String::new();
    for claim in claims {
        let note = claim.note.as_deref().unwrap_or_default();
        let number = |value: Option<f64>| value.map_or_else(String::new, |it| it.to_string());
        let printed = claim.reference.as_ref();
        rows.push_str(&format!(
            "<tr><td><code>{}</code> <small>{}</small>{}</td><td>{}</td>\
             <td class=\"n\" data-v=\"{}\">{}</td><td class=\"n\" data-v=\"{}\">{}</td>\
             <td>{}</td><td class=\"{}\">{}</td></tr>\n",
            escaped(&claim.id),
            escaped(&claim.section),
            if note.is_empty() {
                String::new()
            } else {
                format!("<small class=\"note\">{}</small>", escaped(note))
            },
            escaped(&claim.unit),
            number(claim.ours.value),
            escaped(&ours_text(&claim.ours)),
            number(printed.map(|it| it.mean)),
            printed.map_or_else(|| "–".to_owned(), |it| escaped(&reference(it))),
            escaped(&claim.rule.to_string()),
            tone(claim.verdict),
            claim.verdict,
        ));
    }
    let heads = ["claim", "unit", "ours", "printed", "rule", "verdict"];
    sortable(&heads.map(str::to_owned), &rows, "claims")
}

/// A table as HTML, which sorts by a click on a head.
///
/// ```
/// use host_sim::report::{Table, rows};
/// let mut table = Table::new(&["who", "captures"]);
/// table.row(["a<b".into(), 3.into()]);
/// assert!(rows(&table).contains("<td>a&lt;b</td><td class=\"n\" data-v=\"3\">3</td>"));
/// ```
#[must_use]
pub fn rows(table: &Table) -> String {
    let mut rows = String::new();
    for row in &table.rows {
        rows.push_str("<tr>");
        for value in row {
            let text = escaped(&cell(value));
            match value {
                Value::Number(number) => {
                    rows.push_str(&format!("<td class=\"n\" data-v=\"{number}\">{text}</td>"));
                }
                Value::Null => rows.push_str("<td class=\"n\" data-v=\"\">–</td>"),
                _ => rows.push_str(&format!("<td>{text}</td>")),
            }
        }
        rows.push_str("</tr>\n");
    }
    sortable(&table.columns, &rows, "")
}

/// A table whose heads are buttons; it scrolls by itself where it is wider than the page.
fn sortable(heads: &[String], rows: &str, class: &str) -> String {
    let heads: String = heads
        .iter()
        .map(|head| {
            let head = escaped(head);
            format!("<th aria-sort=\"none\"><button type=\"button\">{head}</button></th>")
        })
        .collect();
    format!(
        "<div class=\"scroll\" tabindex=\"0\"><table class=\"sortable {class}\">\
         <thead><tr>{heads}</tr></thead>\n<tbody>\n{rows}</tbody></table></div>"
    )
}

fn parameters(summary: &Summary) -> String {
    let mut table = Table::new(&["parameter", "value"]);
    for (name, value) in &summary.parameters {
        table.row([name.clone().into(), value.clone()]);
    }
    let seeds: Vec<String> = summary.seeds.iter().map(u64::to_string).collect();
    format!(
        "<section><h2>Parameters</h2><p>Seeds: {}. Program: version {}.</p>{}</section>\n",
        escaped(&seeds.join(", ")),
        escaped(&summary.version),
        rows(&table)
    )
}

#[cfg(test)]
mod tests {
    use super::{Section, page};
    use crate::report::figure::{Axes, Bar, bar_chart};
    use crate::report::{Bound, Expectation, Rule, Summary, Table};

    #[test]
    fn the_page_shows_everything_and_asks_the_network_for_nothing() {
        let mut summary = Summary::new("a<b", &[1, 2]);
        summary.claim(Expectation::new("a.met", "6.1", "x & y").judge(&[1.0, 2.0]));
        let count = Expectation::new("a.missed", "6.1", "bytes").extension();
        let rule = Rule::mean(Bound::AtMost(5.0));
        summary.claim(count.rule(rule).judge_count(9.0));
        let mut table = Table::new(&["who", "captures"]);
        table.row(["__BODY__ </script>".into(), 3.5.into()]);
        summary.table("1 captures", table);
        let axes = Axes::new("50 % \"ours\" & theirs", "", "#").caption("n = 2");
        let picture = bar_chart(&axes, ["ours", ""], &[Bar::new("a", 1.0)]).unwrap();
        let pictures = [("bars".to_owned(), picture)];
        let sections = [Section {
            title: "Replay".to_owned(),
            html: "<p id=\"replay\">plays</p>".to_owned(),
        }];
        let page = page("first words", &summary.judged(), &pictures, &sections);
        for part in [
            "<title>a&lt;b</title>",
            "first words",
            "<b>1</b> extension: missed",
            "<h3>Missed</h3>",
            "x &amp; y",
            "<p id=\"replay\">plays</p>",
            "__BODY__ &lt;/script&gt;",
            "data-v=\"3.5\"",
            "data:image/svg+xml,%3Csvg",
            "<h2>captures</h2>",
        ] {
            assert!(page.contains(part), "{part}");
        }
        let outside = page.replace("http://www.w3.org/2000/svg", "");
        for word in [
            "http:",
            "https:",
            "src=\"//",
            "@import",
            "fetch(",
            "__STYLE__",
        ] {
            assert!(!outside.contains(word), "{word}");
        }
        assert_eq!(page.matches("<img ").count(), 1);
    }
}
