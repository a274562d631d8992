//! The book's equations 5.4–5.32, repaired where enumeration shows an error, and whether a brain
//! has found them.
//!
//! "Exact": the same positive context and the same result (negative context items are not compared:
//! eleven items are never on, so a literal harvest can not leave them out).
//! "Refined": what the equation says is said by schemas that are truly reliable, in other contexts.
//! Level-2 equations (5.33–5.36) are judged where level 2 is (see `level2`).

use cla_core::word::SchemaText;
use serde::{Deserialize, Serialize};

use crate::world::microworld::{Oracle, VOCABULARY, WORDS};

/// A schema of the Microworld, spelled out.
pub type Schema = SchemaText<WORDS>;

/// From this true reliability on a schema counts as valid knowledge.
pub const VALID: f64 = 0.9;

/// One equation of chapter 5.
///
/// ```
/// use host_sim::experiment::microworld::catalogue::equations;
/// let all = equations();
/// assert_eq!(all.len(), 23);
/// assert_eq!(all[1].number, "5.5");
/// assert!(all[1].repair.is_some());
/// ```
#[derive(Clone, Debug)]
pub struct Equation {
    /// Its number in the book.
    pub number: &'static str,
    /// What it says, repaired.
    pub schema: Schema,
    /// What was wrong as printed.
    pub repair: Option<&'static str>,
}

impl Equation {
    /// Its claim id.
    #[must_use]
    pub fn id(&self) -> String {
        format!("micro.eq.{}", self.number.replace('.', "_"))
    }
}

/// The 23 schemas of level 1, in the book's order.
///
/// # Panics
/// Never: the texts are checked by a test.
#[must_use]
pub fn equations() -> Vec<Equation> {
    const SWAP: Option<&str> =
        Some("eyel and eyer stand the wrong way round: 5.6 and 5.7 contradict");
    #[rustfmt::skip]
    let texts: [(&str, &str, Option<&str>); 23] = [
        ("5.4", "/grasp/+hcl", None),
        ("5.5", "+text1+text3/grasp/+hcl+hgr", Some("the ball has details 1 and 3; 0 and 2 are never on")),
        ("5.6", "+vf21/eyer/+vf11-vf21", None),
        ("5.7", "+vf30/eyer/+vf20-vf30", None),
        ("5.8", "+vf34/eyel/-vf34+vf44", SWAP),
        ("5.9", "+vf44/eyer/-vf44+vf34", SWAP),
        ("5.10", "+vf44/eyef/+vf43-vf44", None),
        ("5.11", "+vf43/eyeb/+vf44-vf43", None),
        ("5.12", "+vp23+vf21+fovb1/eyeb/+vp22-vp23-fovb1+fovx1", Some("the body is never in the centre, and vf22 is the centre, not behind it")),
        ("5.13", "+vp23/eyer/-vp23+vp33", None),
        ("5.14", "+vp33/eyel/-vp33+vp23", None),
        ("5.15", "+vp33/eyeb/-vp33+vp32", None),
        ("5.16", "+vp32/eyef/+vp33-vp32", None),
        ("5.17", "+hp23/handr/-hp23+hp33", None),
        ("5.18", "+hp33/handl/+hp23-hp33", None),
        ("5.19", "+hp22/handf/-hp22+hp23", None),
        ("5.20", "+hp33/handb/-hp33+hp32", None),
        ("5.21", "+vp32+vf10/eyef/+vp33-vp32-vf10", Some("nothing can be at vf10 of vp31")),
        ("5.22", "+vp21/eyel/+vp11-vp21", None),
        ("5.23", "+hp13+vf24/handb/+hp12-hp13", None),
        ("5.30", "+hp22+vp22+text1+text3+hcl+hgr+vf22+fovx1+fovx2/handb/+hp21-hp22+bodyf+taste1+taste3+vf21-vf22+fovb1+fovb2-fovx1-fovx2", None),
        ("5.31", "+vf11/handl/+vf01-vf11", None),
        ("5.32", "+hp22+vp32+vf12+fovl2/handr/-hp22+hp32-vf12+vf22-fovl2+fovx2", Some("the left of the fovea is vf12, its centre vf22")),
    ];
    texts
        .into_iter()
        .map(|(number, text, repair)| Equation {
            number,
            schema: SchemaText::parse(text, &VOCABULARY).expect("the equations are schemas"),
            repair,
        })
        .collect()
}

/// Whether a brain has an equation.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub enum Found {
    /// It says nothing of the kind, or only what is not reliable.
    Missed,
    /// Reliable schemas say it with more or with less context.
    Refined,
    /// A schema says just that.
    Exact,
}

impl Found {
    /// The word in reports.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Missed => "missed",
            Self::Refined => "refined",
            Self::Exact => "exact",
        }
    }
}

/// Looks for an equation among harvested schemas: one schema has to say all of it.
///
/// Refined is a reliable schema with the whole result (or more), and with the whole positive context
/// (or more).
#[must_use]
pub fn among_whole_schemas(equation: &Schema, schemas: &[Schema], oracle: &Oracle) -> Found {
    let mut found = Found::Missed;
    for schema in schemas.iter().filter(|it| it.action == equation.action) {
        if schema.context.positive() == equation.context.positive()
            && schema.result == equation.result
        {
            return Found::Exact;
        }
        let refines = equation
            .context
            .positive()
            .is_subset(schema.context.positive())
            && equation.result.follows_from(&schema.result);
        if refines && oracle.reliability(schema).is_some_and(|r| r >= VALID) {
            found = Found::Refined;
        }
    }
    found
}

/// Looks for an equation among simple schemas: each of its result items has to be said by one.
///
/// Exact is a reliable schema with the same positive context for every result item.
/// Refined is that the brain foresees the equation's whole result more often than not (see
/// [`Saying`]).
#[must_use]
pub fn among_simple_schemas(equation: &Schema, schemas: &[Schema], oracle: &Oracle) -> Found {
    let said = saying(equation, schemas, oracle);
    if said.exactly {
        Found::Exact
    } else if said.foreseen >= 0.5 {
        Found::Refined
    } else {
        Found::Missed
    }
}

/// How far simple schemas say what an equation says.
///
/// An equation is true of some of the states where it applies; knowing it is foreseeing its result
/// there.
/// By which contexts does not matter: `+hp22+vp33` says "the hand is at vf11" as well as
/// `+vf11+fovl2` does, and who keeps the simpler schemas has neither of the book's contexts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Saying {
    /// For every result item there is a reliable schema with just the equation's positive context.
    pub exactly: bool,
    /// Of the states where the equation applies and holds, the share in which truly reliable
    /// schemas foresee all its result items together, in `[0, 1]`.
    pub foreseen: f64,
}

/// Compares an equation with what simple schemas say.
#[must_use]
pub fn saying(equation: &Schema, schemas: &[Schema], oracle: &Oracle) -> Saying {
    let holds = oracle.where_succeeds(equation);
    let on = equation.result.positive().iter().map(|item| (item, true));
    let off = equation.result.negative().iter().map(|item| (item, false));
    let (mut all_exact, mut foreseen) = (true, holds.clone());
    for (item, sign) in on.chain(off) {
        let says = |schema: &&Schema| {
            let side = if sign {
                schema.result.positive()
            } else {
                schema.result.negative()
            };
            schema.action == equation.action && side.contains(item)
        };
        let (mut exact, mut said) = (false, oracle.nowhere());
        for schema in schemas.iter().filter(says) {
            if oracle.reliability(schema).is_some_and(|r| r >= VALID) {
                exact |= schema.context.positive() == equation.context.positive();
                said.add(&oracle.where_holds(&schema.context));
            }
        }
        all_exact &= exact;
        foreseen.keep(&said);
    }
    Saying {
        exactly: all_exact,
        foreseen: foreseen.len() as f64 / holds.len().max(1) as f64,
    }
}

#[cfg(test)]
mod tests {
    use super::{Found, Schema, among_simple_schemas, among_whole_schemas, equations, saying};
    use crate::world::microworld::{Body, Oracle, VOCABULARY};

    fn parse(text: &str) -> Schema {
        Schema::parse(text, &VOCABULARY).unwrap()
    }

    #[test]
    fn every_equation_applies_somewhere_and_holds_in_some_of_it() {
        let oracle = Oracle::new(Body::Visible);
        for equation in equations() {
            let truth = oracle.reliability(&equation.schema);
            assert!(
                truth.is_some_and(|r| r > 0.1),
                "{}: {truth:?}",
                equation.number
            );
        }
    }

    #[test]
    fn as_printed_the_repaired_equations_never_hold() {
        let oracle = Oracle::new(Body::Visible);
        for text in [
            "+text0+text2/grasp/+hcl+hgr",
            "+vf34/eyer/-vf34+vf44",
            "+vp23+vf22+fovb0/eyeb/+vp22-vp23-fovb0+fovx0",
            "+vp31+vf10/eyel/+vp21-vp31-vf10",
        ] {
            let truth = oracle.reliability(&parse(text));
            assert!(truth.is_none_or(|r| r == 0.0), "{text}: {truth:?}");
        }
    }

    #[test]
    fn an_unreliable_schema_refines_nothing() {
        let oracle = Oracle::new(Body::Visible);
        let equation = parse("+vf21/eyer/+vf11-vf21");
        let whole = |text| among_whole_schemas(&equation, &[parse(text)], &oracle);
        assert_eq!(whole("+vf21-hcl/eyer/+vf11-vf21"), Found::Exact);
        assert_eq!(whole("+vf21+vp32/eyer/+vf11-vf21"), Found::Missed);
        assert_eq!(whole("+vf21+vf11+vp12/eyer/+vf11"), Found::Missed);
    }

    #[test]
    fn simple_schemas_have_to_say_every_result_item() {
        let oracle = Oracle::new(Body::Visible);
        let equation = parse("+vp23/eyer/-vp23+vp33");
        let simple = |texts: &[&str]| {
            let schemas: Vec<Schema> = texts.iter().map(|text| parse(text)).collect();
            among_simple_schemas(&equation, &schemas, &oracle)
        };
        assert_eq!(simple(&["+vp23/eyer/+vp33"]), Found::Missed);
        assert_eq!(
            simple(&["+vp23/eyer/+vp33", "+vp23/eyer/-vp23"]),
            Found::Exact
        );
        assert_eq!(
            simple(&["+vp23/eyer/+vp33", "-vp13/eyer/-vp23"]),
            Found::Refined
        );
    }

    #[test]
    fn what_is_foreseen_is_counted_in_states_where_the_equation_comes_true() {
        let oracle = Oracle::new(Body::Visible);
        let equation = parse("+vp23/eyer/-vp23+vp33");
        let share = |texts: &[&str]| {
            let schemas: Vec<Schema> = texts.iter().map(|text| parse(text)).collect();
            saying(&equation, &schemas, &oracle).foreseen
        };
        assert_eq!(share(&["+vp23/eyer/+vp33"]), 0.0, "one of two items");
        assert_eq!(share(&["+vp23/eyer/+vp33", "+vp23/eyer/-vp23"]), 1.0);
        let some = share(&["+vp23+hp11/eyer/+vp33", "+vp23/eyer/-vp23"]);
        assert!(
            (some - 1.0 / 9.0).abs() < 0.01,
            "the hand is at one of nine: {some}"
        );
        // Not reliable: it says that of every state.
        assert_eq!(share(&["/eyer/+vp33", "+vp23/eyer/-vp23"]), 0.0);
    }
}
