//! One robot's life to watch: a page in one file that replays it, without any network.
//!
//! Drawn once as SVG (room, specimens, robot, the five sectors of its camera) and moved by a script
//! from the recorded frames: pose, items that are on, chosen schema and value, captures.
//! The last undamaged actions and the first damaged ones, with the moment of the damage marked.

use std::collections::BTreeMap;

use cla_core::agent::{Adaptation, AgentConfig};
use serde_json::{Value, json};

use super::life::{Protocol, watched_course};
use super::options::RecoverOptions;
use super::trial::grown;
use crate::device::meter::Load;
use crate::failure::Failure;
use crate::learner::Learner;
use crate::world::World;
use crate::world::body::SPECIMEN_RADIUS;
use crate::world::camera::{FIELD_OF_VIEW, SECTORS};
use crate::world::damage::{Damage, Damaged};
use crate::world::geometry::Point;
use crate::world::pioneer::{ACTIONS, ITEMS, Pioneer};

/// Undamaged actions that are shown.
const BEFORE: u32 = 600;
/// Damaged actions that are shown.
const AFTER: u32 = 3000;

/// What the script plays.
#[derive(Default)]
struct Film {
    poses: Vec<Value>,
    on: Vec<u32>,
    actions: Vec<usize>,
    values: Vec<f64>,
    captures: Vec<u32>,
    thoughts: Vec<usize>,
    words: BTreeMap<String, usize>,
    spoken: Vec<String>,
    first: Vec<Option<[f64; 2]>>,
    moved: Vec<Value>,
    doubts: Vec<[usize; 2]>,
}

/// Records the life of a seed's robot with both levels and surprise, and writes the page.
pub(super) fn page(options: &RecoverOptions, damage: Damage, seed: u64) -> Result<String, Failure> {
    let protocol = Protocol {
        after: AFTER.min(options.protocol.after),
        ..options.protocol
    };
    let both = AgentConfig::RESILIENT_LEVEL2;
    let mut load = Load::default();
    let forager = grown(both, &options.world, &protocol, seed, &mut load)?;
    let mut forager = forager.acting(Adaptation::Relearning, both.surprise)?;
    let mut film = Film::default();
    let (mut seen, skip) = (0, protocol.before.saturating_sub(BEFORE));
    let mut places = Vec::new();
    watched_course(
        &mut forager,
        &options.world,
        &protocol,
        damage,
        seed,
        &mut |learner, world| {
            if seen >= skip {
                film.shoot(learner, world, &mut places);
            }
            seen += 1;
        },
    )?;
    let knocked = protocol.before.min(BEFORE) as usize;
    Ok(film.cut(options, damage, seed, knocked))
}

/// A length in metres to a tenth of a millimetre.
fn short(metres: f64) -> f64 {
    libm::round(metres * 1e4) / 1e4
}

impl Film {
    fn shoot(
        &mut self,
        learner: &dyn Learner,
        world: &Damaged<Pioneer>,
        places: &mut Vec<Option<Point>>,
    ) {
        let robot = world.world().robot();
        let thought = learner.reason();
        let at = robot.position;
        let heading = short(robot.heading().to_degrees());
        self.poses.push(json!([short(at.x), short(at.y), heading]));
        let percept = world.sense();
        let on = percept.on().iter().filter(|item| item.0 < 32);
        self.on.push(on.fold(0, |bits, item| bits | 1 << item.0));
        self.actions.push(thought.action);
        self.values
            .push(f64::from(libm::roundf(thought.value * 100.0)) / 100.0);
        self.captures.push(world.obtained());
        let next = self.words.len();
        let index = *self.words.entry(thought.schema.clone()).or_insert(next);
        if index == self.spoken.len() {
            self.spoken.push(thought.schema);
        }
        self.thoughts.push(index);
        let frame = self.poses.len() - 1;
        match self.doubts.last_mut() {
            Some(doubt) if thought.alarmed && doubt[1] == frame => doubt[1] += 1,
            _ if thought.alarmed => self.doubts.push([frame, frame + 1]),
            _ => {}
        }
        let now = world.world().specimens();
        let pair = |at: &Option<Point>| at.map(|at| [short(at.x), short(at.y)]);
        if places.is_empty() {
            self.first = now.iter().map(pair).collect();
            *places = now.to_vec();
        }
        let mut moved = Vec::new();
        for (index, (new, old)) in now.iter().zip(places.iter_mut()).enumerate() {
            if new != old {
                moved.push(match pair(new) {
                    Some([x, y]) => json!([index, x, y]),
                    None => json!([index, null, null]),
                });
                *old = *new;
            }
        }
        self.moved.push(Value::from(moved));
    }

    fn cut(self, options: &RecoverOptions, damage: Damage, seed: u64, knocked: usize) -> String {
        let radius = options.world.config.radius;
        let camera = match damage {
            Damage::Camera(degrees) => degrees,
            _ => 0.0,
        };
        let room = room(
            radius,
            options.world.config.camera_range,
            &self.first,
            &self.poses,
        );
        let start = self.captures.first().copied().unwrap_or(0);
        let captures: Vec<u32> = self.captures.iter().map(|count| count - start).collect();
        let data = json!({
            "items": ITEMS, "actions": ACTIONS, "pose": self.poses, "on": self.on,
            "action": self.actions, "value": self.values, "captures": captures,
            "thought": self.thoughts, "thoughts": self.spoken, "first": self.first,
            "moved": self.moved, "doubts": self.doubts, "damage": knocked, "camera": camera,
            "name": damage.to_string(),
        });
        let edge = radius + 0.25;
        let view = format!("{} {} {} {}", -edge, -edge, 2.0 * edge, 2.0 * edge);
        let subtitle = format!(
            "Seed {seed}: {knocked} undamaged actions, then {} with the damage {damage}, of which \
             the robot was not told. Yellow: it has noticed that its predictions fail.",
            captures.len().saturating_sub(knocked)
        );
        // `</` cannot end the script from inside a string.
        let data = data.to_string().replace("</", "<\\/");
        include_str!("page.html")
            .replace("__TITLE__", "A robot is damaged, and recovers")
            .replace("__SUBTITLE__", &subtitle)
            .replace("__VIEW__", &view)
            .replace("__ROOM__", &room)
            .replace("__DATA__", &data)
    }
}

/// The room with everything in it at the first frame, in metres, y upwards.
fn room(radius: f64, range: f64, specimens: &[Option<[f64; 2]>], poses: &[Value]) -> String {
    let mut svg = format!(
        "<style>.sector{{fill:#0072b2;opacity:.07}}.sector.lit{{opacity:.38}}</style>\n\
         <defs><clipPath id=\"walls\"><circle r=\"{radius}\"/></clipPath></defs>\n\
         <circle r=\"{radius}\" fill=\"#fbfcfd\" stroke=\"#1b2733\" stroke-width=\".06\"/>\n\
         <polyline id=\"trail\" points=\"0,0\" fill=\"none\" stroke=\"#0072b2\" \
         stroke-width=\".05\" stroke-linejoin=\"round\" opacity=\".55\"/>\n"
    );
    for place in specimens {
        let [x, y] = place.unwrap_or([0.0, 0.0]);
        // Twice as large as they are, to be seen.
        let r = 2.0 * SPECIMEN_RADIUS;
        svg.push_str(&format!(
            "<circle class=\"specimen\" cx=\"{x}\" cy=\"{}\" r=\"{r}\" fill=\"#d55e00\"/>\n",
            -y
        ));
    }
    let number = |index: usize| {
        let pose = poses.first().and_then(|pose| pose.get(index));
        pose.and_then(Value::as_f64).unwrap_or(0.0)
    };
    svg.push_str(&format!(
        "<g clip-path=\"url(#walls)\"><g id=\"robot\" transform=\"translate({} {}) rotate({})\">\
         <g id=\"camera\">\n",
        number(0),
        -number(1),
        -number(2)
    ));
    let width = FIELD_OF_VIEW / SECTORS as f64;
    for sector in 0..SECTORS {
        let edge = |degrees: f64| {
            let (sin, cos) = libm::sincos(degrees.to_radians());
            format!("{:.3},{:.3}", range * cos, -range * sin)
        };
        let left = 0.5 * FIELD_OF_VIEW - width * sector as f64;
        svg.push_str(&format!(
            "<path class=\"sector\" d=\"M0,0L{}A{range},{range} 0 0 1 {}Z\"/>\n",
            edge(left),
            edge(left - width)
        ));
    }
    // Body and gripper of the Pioneer, heading along x.
    svg.push_str(
        "</g><path id=\"knock\" visibility=\"hidden\" d=\"M-.12,-.1L.04,.1M.04,-.1L-.12,.1\" \
         stroke=\"#d55e00\" stroke-width=\".07\" transform=\"translate(-.45 0)\"/>\
         <rect x=\"-.26\" y=\"-.165\" width=\".44\" height=\".33\" rx=\".06\" fill=\"#1b2733\"/>\
         <path d=\"M.18,-.13h.16M.18,.13h.16\" stroke=\"#1b2733\" stroke-width=\".05\" \
         stroke-linecap=\"round\"/><circle cx=\".06\" r=\".07\" fill=\"#e69f00\"/></g></g>\n",
    );
    svg
}

#[cfg(test)]
mod tests {
    use super::super::RecoverOptions;
    use super::super::life::Protocol;
    use super::page;
    use crate::world::config::PioneerConfig;
    use crate::world::damage::Damage;
    use crate::world::setting::WorldOptions;

    #[test]
    fn the_page_is_one_file_that_asks_the_network_for_nothing() {
        let options = RecoverOptions {
            seeds: vec![3],
            world: WorldOptions {
                config: PioneerConfig::NOISY,
                layout: None,
            },
            damages: vec![Damage::Camera(12.0)],
            protocol: Protocol {
                training: 300,
                before: 20,
                after: 30,
            },
        };
        let page = page(&options, Damage::Camera(12.0), 3).unwrap();
        for word in ["http:", "https:", "src=", "import ", "url(//", "fetch("] {
            let found = page.replace("http://www.w3.org/2000/svg", "");
            assert!(!found.contains(word), "{word}");
        }
        assert!(page.contains("\"damage\":20") && page.contains("\"camera\":12.0"));
        assert!(!page.contains("__"), "every place is filled in");
        assert_eq!(page.matches("class=\"specimen\"").count(), 28);
        assert_eq!(page.matches("class=\"sector\"").count(), 5);
        let frames = page.split("\"captures\":[").nth(1).unwrap();
        let frames = frames.split(']').next().unwrap().split(',').count();
        assert_eq!(frames, 50);
    }
}
