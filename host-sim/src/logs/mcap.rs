//! A log as MCAP: a channel of JSON, with its schema, for each kind of message.

use std::collections::BTreeMap;
use std::io::Cursor;

use mcap::records::MessageHeader;
use mcap::{MessageStream, WriteOptions, Writer};
use serde::Serialize;
use serde::de::DeserializeOwned;
use serde_json::{Value, json};

use super::step::{Life, Moved, Step};
use crate::failure::Failure;

/// Nanoseconds of an action, which is taken for a second.
const ACTION: u64 = 1_000_000_000;

/// The channels in the order of their numbers here.
const TOPICS: [&str; 7] = [
    "/life",
    "/percept",
    "/choice",
    "/reward",
    "/alarm",
    "/pose",
    "/specimens",
];

/// A JSON schema with these properties.
fn schema(title: &str, properties: &Value) -> Value {
    json!({ "title": title, "type": "object", "properties": properties })
}

fn schemas() -> [Value; TOPICS.len()] {
    let (text, number) = (json!({"type": "string"}), json!({"type": "number"}));
    let (whole, yes) = (json!({"type": "integer"}), json!({"type": "boolean"}));
    let texts = json!({"type": "array", "items": text});
    let places = json!({"type": "array"});
    [
        schema(
            "life",
            &json!({"about": text, "items": texts, "actions": texts, "radius": number,
                    "camera_range": number, "specimens": places}),
        ),
        schema("percept", &json!({"on": texts})),
        schema(
            "choice",
            &json!({"action": text, "schema": text, "value": number}),
        ),
        schema("reward", &json!({"obtained": whole, "in_all": whole})),
        schema("alarm", &json!({"doubts": yes})),
        schema(
            "pose",
            &json!({"x": number, "y": number, "heading": number}),
        ),
        schema("specimens", &json!({"moved": places})),
    ]
}

/// The message of the specimens: JSON messages are objects.
#[derive(serde::Serialize, serde::Deserialize)]
struct Specimens {
    moved: Vec<Moved>,
}

struct Log {
    writer: Writer<Cursor<Vec<u8>>>,
    channels: Vec<u16>,
}

impl Log {
    fn new() -> Result<Self, Failure> {
        let options = WriteOptions::new().compression(None).profile("");
        let mut writer = options.create(Cursor::new(Vec::new()))?;
        let mut channels = Vec::new();
        for (topic, schema) in TOPICS.iter().zip(schemas()) {
            let name = topic.trim_start_matches('/');
            let id = writer.add_schema(name, "jsonschema", schema.to_string().as_bytes())?;
            channels.push(writer.add_channel(id, topic, "json", &BTreeMap::new())?);
        }
        Ok(Self { writer, channels })
    }

    fn say(&mut self, topic: usize, step: usize, message: &impl Serialize) -> Result<(), Failure> {
        let time = ACTION * step as u64;
        let header = MessageHeader {
            channel_id: self.channels[topic],
            sequence: step as u32,
            log_time: time,
            publish_time: time,
        };
        let message = serde_json::to_vec(message)?;
        self.writer.write_to_known_channel(&header, &message)?;
        Ok(())
    }
}

pub(super) fn bytes(life: &Life, steps: &[Step]) -> Result<Vec<u8>, Failure> {
    let mut log = Log::new()?;
    log.say(0, 0, life)?;
    for step in steps {
        log.say(1, step.step, &step.percept)?;
        if let Some(choice) = &step.choice {
            log.say(2, step.step, choice)?;
        }
        log.say(3, step.step, &step.reward)?;
        if let Some(alarm) = &step.alarm {
            log.say(4, step.step, alarm)?;
        }
        log.say(5, step.step, &step.pose)?;
        if !step.specimens.is_empty() {
            let moved = step.specimens.clone();
            log.say(6, step.step, &Specimens { moved })?;
        }
    }
    log.writer.finish()?;
    Ok(log.writer.into_inner().into_inner())
}

/// What has been read of a step so far.
#[derive(Default)]
struct Parts {
    messages: BTreeMap<usize, Vec<u8>>,
}

impl Parts {
    fn part<T: DeserializeOwned>(&self, step: usize, topic: usize) -> Result<Option<T>, String> {
        let Some(message) = self.messages.get(&topic) else {
            return Ok(None);
        };
        let wrong = |why| format!("action {step}, {}: {why}", TOPICS[topic]);
        serde_json::from_slice(message).map(Some).map_err(wrong)
    }

    fn must<T: DeserializeOwned>(&self, step: usize, topic: usize) -> Result<T, String> {
        let found = self.part(step, topic)?;
        found.ok_or_else(|| format!("action {step} has no {}", TOPICS[topic]))
    }

    fn step(&self, step: usize) -> Result<Step, String> {
        let moved: Option<Specimens> = self.part(step, 6)?;
        Ok(Step {
            step,
            percept: self.must(step, 1)?,
            choice: self.part(step, 2)?,
            reward: self.must(step, 3)?,
            alarm: self.part(step, 4)?,
            pose: self.must(step, 5)?,
            specimens: moved.map_or_else(Vec::new, |it| it.moved),
        })
    }
}

pub(super) fn read(bytes: &[u8]) -> Result<(Life, Vec<Step>), String> {
    let broken = |why: mcap::McapError| format!("the log is cut off or damaged: {why}");
    let mut all: BTreeMap<u64, Parts> = BTreeMap::new();
    for message in MessageStream::new(bytes).map_err(broken)? {
        let message = message.map_err(broken)?;
        let topic = TOPICS.iter().position(|it| *it == message.channel.topic);
        // What another program has added is its own.
        let Some(topic) = topic else { continue };
        let parts = all.entry(message.log_time / ACTION).or_default();
        if parts
            .messages
            .insert(topic, message.data.into_owned())
            .is_some()
        {
            let action = message.log_time / ACTION;
            return Err(format!("action {action} has {} twice", TOPICS[topic]));
        }
    }
    let first = all.get(&0).ok_or("the log is empty")?;
    let life = first.must(0, 0)?;
    let steps = all.iter();
    let steps = steps
        .filter(|(_, parts)| parts.messages.keys().any(|&it| it > 0))
        .map(|(time, parts)| parts.step(*time as usize))
        .collect::<Result<Vec<Step>, String>>()?;
    Ok((life, steps))
}
