//! One robot's life to watch: a part of the run's page that replays it.
//!
//! Drawn once as SVG (room, specimens, robot, the five sectors of its camera) and moved by a script
//! from the recorded frames: pose, items that are on, chosen schema and value, captures.
//! The moment of the damage is marked.

use serde_json::{Value, json};

use super::film::Film;
use super::options::RecoverOptions;
use crate::report::escaped;
use crate::world::body::SPECIMEN_RADIUS;
use crate::world::camera::{FIELD_OF_VIEW, SECTORS};
use crate::world::damage::Damage;
use crate::world::pioneer::{ACTIONS, ITEMS};

/// What a film does not show of itself.
#[derive(Clone, Debug, PartialEq)]
pub struct Scene {
    /// Radius of the room, metres.
    pub radius: f64,
    /// How far the camera sees, metres.
    pub camera_range: f64,
    /// By how much the damage turns the camera, degrees.
    pub camera: f64,
    /// What broke when [`Film::knocked`] says; empty for nothing.
    pub damage: String,
    /// What happened.
    pub title: String,
    /// Who lives there, and how long.
    pub subtitle: String,
}

impl Scene {
    /// Of a seed's robot with both levels.
    pub(super) fn of(film: &Film, options: &RecoverOptions, damage: Damage, seed: u64) -> Self {
        let config = &options.world.config;
        Self {
            radius: config.radius,
            camera_range: config.camera_range,
            camera: match damage {
                Damage::Camera(degrees) => degrees,
                _ => 0.0,
            },
            damage: damage.to_string(),
            title: title(film, damage),
            subtitle: format!(
                "Seed {seed}, both levels with habits and surprise: {} undamaged actions, then {} \
                 with the damage {damage}, of which the robot was not told.",
                film.knocked,
                film.captures.len().saturating_sub(film.knocked)
            ),
        }
    }
}

/// The replay of a film, as HTML.
#[must_use]
pub fn replay(film: &Film, scene: &Scene) -> String {
    let room = room(scene.radius, scene.camera_range, &film.first, &film.poses);
    let start = film.captures.first().copied().unwrap_or(0);
    let captures: Vec<u32> = film.captures.iter().map(|count| count - start).collect();
    let moved: Vec<Vec<Value>> = film
        .moved
        .iter()
        .map(|all| all.iter().map(flat).collect())
        .collect();
    let data = json!({
        "items": ITEMS, "actions": ACTIONS, "pose": film.poses, "on": film.on,
        "action": film.actions, "value": film.values, "captures": captures,
        "thought": film.thoughts, "thoughts": film.spoken, "first": film.first,
        "moved": moved, "doubts": film.doubts, "damage": film.knocked, "camera": scene.camera,
        "name": scene.damage,
    });
    let edge = scene.radius + 0.25;
    let view = format!("{} {} {} {}", -edge, -edge, 2.0 * edge, 2.0 * edge);
    // `</` cannot end the script from inside a string.
    let data = data.to_string().replace("</", "<\\/");
    include_str!("replay.html")
        .replace("__TITLE__", &escaped(&scene.title))
        .replace("__SUBTITLE__", &escaped(&scene.subtitle))
        .replace("__VIEW__", &view)
        .replace("__ROOM__", &room)
        .replace("__DATA__", &data)
}

/// What happened in a film, in numbers; whether that is to have recovered, the claims say.
fn title(film: &Film, damage: Damage) -> String {
    let at = |frame: usize| f64::from(film.captures.get(frame).copied().unwrap_or(0));
    let last = film.captures.len().saturating_sub(1);
    // Captures in a thousand actions between two frames.
    let rate = |from: usize, to: usize| 1000.0 * (at(to) - at(from)) / to.abs_diff(from) as f64;
    let before = rate(0, film.knocked);
    let first = rate(film.knocked, last.min(film.knocked + 1000));
    let end = rate(last.saturating_sub(1000).max(film.knocked), last);
    format!(
        "A robot with the damage {damage}: captures in 1000 actions {before:.0} before it, \
         {first:.0} at first, {end:.0} in the last thousand shown"
    )
}

/// The schemas that the robot acted on most, before and after the damage.
pub(super) fn spoken(film: &Film) -> String {
    let mut counts = vec![[0_usize; 2]; film.spoken.len()];
    for (frame, &thought) in film.thoughts.iter().enumerate() {
        if let Some(counts) = counts.get_mut(thought) {
            counts[usize::from(frame >= film.knocked)] += 1;
        }
    }
    let mut order: Vec<usize> = (0..counts.len()).collect();
    order.sort_by_key(|&it| std::cmp::Reverse(counts[it][0] + counts[it][1]));
    let rows: String = order
        .iter()
        .filter(|&&it| !film.spoken[it].is_empty())
        .take(LISTED)
        .map(|&it| {
            let [before, after] = counts[it];
            format!(
                "<tr><td><code>{}</code></td><td class=\"n\">{before}</td>\
                 <td class=\"n\">{after}</td></tr>\n",
                escaped(&film.spoken[it])
            )
        })
        .collect();
    let after = film.thoughts.len().saturating_sub(film.knocked);
    format!(
        "<div class=\"scroll\"><table><thead><tr><th>schema</th><th>chosen in {} actions before the \
         damage</th><th>in {after} after it</th></tr></thead><tbody>\n{rows}</tbody></table></div>",
        film.knocked
    )
}

/// Schemas in the list.
const LISTED: usize = 16;

/// As the script wants it: which specimen, and where it is now.
fn flat(&(index, place): &(usize, Option<[f64; 2]>)) -> Value {
    match place {
        Some([x, y]) => json!([index, x, y]),
        None => json!([index, null, null]),
    }
}

/// The room with everything in it at the first frame, in metres, y upwards.
fn room(radius: f64, range: f64, specimens: &[Option<[f64; 2]>], poses: &[[f64; 3]]) -> String {
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
    let number = |index: usize| poses.first().map_or(0.0, |pose| pose[index]);
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
    use super::super::film::Film;
    use super::super::life::Protocol;
    use super::super::options::RecoverOptions;
    use super::{Scene, replay, spoken, title};
    use crate::world::config::PioneerConfig;
    use crate::world::damage::Damage;
    use crate::world::setting::WorldOptions;

    #[test]
    fn the_replay_asks_the_network_for_nothing_and_says_what_happened() {
        let options = RecoverOptions {
            seeds: vec![3],
            world: WorldOptions {
                config: PioneerConfig::NOISY,
                layout: None,
                path: None,
            },
            damages: vec![Damage::Camera(12.0)],
            protocol: Protocol {
                training: 300,
                before: 20,
                after: 30,
            },
        };
        let RecoverOptions {
            world, protocol, ..
        } = &options;
        let film = Film::shot(world, protocol, Damage::Camera(12.0), 3).unwrap();
        let page = replay(&film, &Scene::of(&film, &options, Damage::Camera(12.0), 3));
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
        assert!(spoken(&film).contains("<code>"));
        // One capture in four actions, then none, then one in four again.
        let mut film = Film {
            knocked: 400,
            captures: (0..400).map(|it| it / 4).chain([100; 1000]).collect(),
            ..Film::default()
        };
        let damage = Damage::Camera(12.0);
        let numbers = "1000 actions 250 before it, 0 at first, 0 in the last thousand shown";
        assert!(title(&film, damage).contains(numbers));
        film.captures.extend((0..1200).map(|it| 100 + it / 4));
        let numbers = "1000 actions 250 before it, 0 at first, 250 in the last thousand shown";
        assert!(title(&film, damage).contains(numbers));
    }
}
