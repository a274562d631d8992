//! `docs/summary.schema.json` describes every committed claims file, and refuses what is none.
//!
//! The few keywords of JSON Schema that it uses are evaluated here; one that is not known fails, so
//! that the schema cannot say what nobody checks.

use std::fs;

use cla_tests::claims::files;
use cla_tests::root;
use serde_json::{Value, json};

fn schema() -> Value {
    let path = root().join("docs/summary.schema.json");
    let text = fs::read_to_string(path).expect("the schema can be read");
    serde_json::from_str(&text).expect("the schema is JSON")
}

/// What is wrong with a value, with its path; empty when nothing is.
fn faults(schema: &Value, root: &Value, value: &Value, path: &str) -> Vec<String> {
    let mut found = Vec::new();
    for (keyword, asked) in schema.as_object().expect("a schema is an object") {
        match keyword.as_str() {
            "$schema" | "title" | "description" | "$defs" => {}
            "$ref" => {
                let name = asked.as_str().expect("a reference is text");
                let target = root.pointer(name.trim_start_matches('#'));
                let target = target.expect("a reference leads somewhere");
                found.extend(faults(target, root, value, path));
            }
            "const" if value == asked => {}
            "enum" if asked.as_array().is_some_and(|it| it.contains(value)) => {}
            "type" if types(asked).any(|it| is_of(value, it)) => {}
            "const" | "enum" | "type" => found.push(format!("{path}: {keyword} {asked}")),
            "minimum" => {
                if value
                    .as_f64()
                    .is_some_and(|it| it < asked.as_f64().unwrap_or(f64::NAN))
                {
                    found.push(format!("{path}: below {asked}"));
                }
            }
            "required" => {
                for name in asked.as_array().expect("a list") {
                    let name = name.as_str().expect("a name");
                    if value.is_object() && value.get(name).is_none() {
                        found.push(format!("{path}: no {name}"));
                    }
                }
            }
            "items" => {
                for (index, item) in value.as_array().into_iter().flatten().enumerate() {
                    found.extend(faults(asked, root, item, &format!("{path}/{index}")));
                }
            }
            "properties" => {
                for (name, inner) in asked.as_object().expect("an object") {
                    if let Some(value) = value.get(name) {
                        found.extend(faults(inner, root, value, &format!("{path}/{name}")));
                    }
                }
            }
            "additionalProperties" => {
                for (name, inner) in value.as_object().into_iter().flatten() {
                    if schema.pointer(&format!("/properties/{name}")).is_some() {
                        continue;
                    }
                    if asked == &Value::Bool(false) {
                        found.push(format!("{path}: {name} is not known"));
                    } else {
                        found.extend(faults(asked, root, inner, &format!("{path}/{name}")));
                    }
                }
            }
            other => panic!("the keyword {other} is not evaluated here"),
        }
    }
    found
}

fn types(asked: &Value) -> impl Iterator<Item = &str> {
    let one = asked.as_str().into_iter();
    one.chain(
        asked
            .as_array()
            .into_iter()
            .flatten()
            .filter_map(Value::as_str),
    )
}

fn is_of(value: &Value, name: &str) -> bool {
    match name {
        "null" => value.is_null(),
        "boolean" => value.is_boolean(),
        "number" => value.is_number(),
        "integer" => value.is_i64() || value.is_u64(),
        "string" => value.is_string(),
        "array" => value.is_array(),
        "object" => value.is_object(),
        other => panic!("{other} is no type"),
    }
}

#[test]
fn every_claims_file_keeps_the_schema() {
    let schema = schema();
    for file in files() {
        let value = serde_json::from_str(&file.text).expect("a claims file is JSON");
        let faults = faults(&schema, &schema, &value, "");
        assert!(faults.is_empty(), "{}: {faults:?}", file.name);
    }
}

#[test]
fn the_schema_refuses_what_is_no_claims_file() {
    let schema = schema();
    let file = files().remove(0);
    let whole: Value = serde_json::from_str(&file.text).expect("a claims file is JSON");
    let spoil: [(&str, Value); 9] = [
        ("/format", json!(1)),
        ("/status", json!("splendid")),
        ("/seeds/0", json!(-1)),
        ("/seeds/0", json!(0.5)),
        ("/verdicts", json!([])),
        ("/claims/0/verdict", json!("reproduced beautifully")),
        ("/claims/0/per_seed/0", json!("1")),
        ("/claims/0/ours", json!({"mean": 1.0})),
        ("/claims/0/tested", json!({"p": 0.5})),
    ];
    for (place, value) in spoil {
        let mut spoiled = whole.clone();
        *spoiled.pointer_mut(place).expect("the place is there") = value;
        assert!(
            !faults(&schema, &schema, &spoiled, "").is_empty(),
            "{place}"
        );
    }
    let mut more = whole.clone();
    more["claims"][0]["opinion"] = json!("good");
    assert!(!faults(&schema, &schema, &more, "").is_empty());
}
