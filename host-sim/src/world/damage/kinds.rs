//! What can happen to a robot: each [`Damage`] is one line of text (`camera:+12`, `dead:s3`,
//! `swap:s2,s4`, `lost:turnl` …), written and read here.

use core::fmt;

use serde::{Serialize, Serializer};

/// An item or an action of a world, by name and index.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Part {
    /// Its name.
    pub name: &'static str,
    /// Its index among the items or among the actions.
    pub index: usize,
}

/// One thing that broke.
///
/// ```
/// use host_sim::world::damage::Damage;
/// use host_sim::world::pioneer::{ACTIONS, ITEMS};
/// let damage = Damage::parse("camera:+12", &ITEMS, &ACTIONS)?;
/// assert_eq!(damage, Damage::Camera(12.0));
/// assert_eq!(damage.to_string(), "camera:+12");
/// assert!(Damage::parse("dead:s9", &ITEMS, &ACTIONS).is_err());
/// # Ok::<(), host_sim::world::damage::DamageError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Damage {
    /// `none`: nothing broke; what a false alarm costs is measured with it.
    None,
    /// `camera:DEGREES`: the camera is turned on its mount, to the left when positive; −180 to 180.
    Camera(f64),
    /// `shift:N`: every item `s1` … reports what the one `N` places before it did; any world.
    ///
    /// The form of a turned camera for worlds that have sectors but no camera.
    Shift(i32),
    /// `dead:ITEM`: the item is off for ever.
    Dead(Part),
    /// `stuck:ITEM`: the item is on for ever.
    Stuck(Part),
    /// `swap:ITEM,ITEM`: two sensors are plugged in the wrong way round.
    SwapItems(Part, Part),
    /// `swap:ACTION,ACTION`: two motors are.
    SwapActions(Part, Part),
    /// `pull:DEGREES`: driving forward one step turns the robot to the left.
    Pull(f64),
    /// `weak:ACTION`: half of the motion is left.
    Weak(Part),
    /// `slip:SHARE`: in this share of the motions the wheels spin on the spot.
    Slip(f64),
    /// `lost:ACTION`: nothing is left of it.
    Lost(Part),
    /// `beam`: the gripper's beam is blocked and reports something for ever.
    Beam,
}

/// As its line of text.
impl Serialize for Damage {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        to.collect_str(self)
    }
}

/// A text that names no damage.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct DamageError(String);

impl fmt::Display for DamageError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl core::error::Error for DamageError {}

impl Damage {
    /// The damages of the report: the book's, its mirror, and what users meet.
    pub const REPORTED: [&'static str; 13] = [
        "camera:+12",
        "camera:-12",
        "camera:+30",
        "dead:s3",
        "dead:s2",
        "stuck:s3",
        "swap:s2,s4",
        "swap:turnl,turnr",
        "pull:8",
        "weak:turnl",
        "slip:0.2",
        "lost:turnl",
        "beam",
    ];

    /// Reads a damage for a world with these items and actions.
    ///
    /// # Errors
    /// [`DamageError`] names the kind, the part or the number that does not exist, or changes nothing.
    pub fn parse(
        text: &str,
        items: &'static [&'static str],
        actions: &'static [&'static str],
    ) -> Result<Self, DamageError> {
        let text = text.trim();
        let (kind, what) = text.split_once(':').unwrap_or((text, ""));
        let part = |names: &'static [&'static str], kind: &str, name: &str| {
            let found = names.iter().position(|&other| other == name);
            let part = found.map(|index| Part {
                name: names[index],
                index,
            });
            part.ok_or_else(|| {
                let known = names.join(", ");
                DamageError(format!("{name:?} is no {kind}: there are {known}"))
            })
        };
        let number = |least: f64, most: f64| {
            let value = what.parse::<f64>().ok();
            let value = value
                .filter(|value| (least..=most).contains(value))
                .ok_or_else(|| {
                    let range = format!("a number from {least} to {most}");
                    DamageError(format!("{kind} takes {range}, not {what:?}"))
                })?;
            if value == 0.0 {
                let sentence = format!("{text} is no damage: say none for a life without one");
                return Err(DamageError(sentence));
            }
            Ok(value)
        };
        let nothing_else = |damage| {
            if text == kind {
                Ok(damage)
            } else {
                Err(DamageError(format!("{kind} stands alone, not {text:?}")))
            }
        };
        match kind {
            "none" => nothing_else(Self::None),
            "beam" => nothing_else(Self::Beam),
            "camera" => Ok(Self::Camera(number(-180.0, 180.0)?)),
            "pull" => Ok(Self::Pull(number(-90.0, 90.0)?)),
            "slip" => Ok(Self::Slip(number(0.0, 1.0)?)),
            "shift" => {
                let places = number(-4.0, 4.0)?;
                if places.fract() == 0.0 {
                    return Ok(Self::Shift(places as i32));
                }
                Err(DamageError(format!(
                    "shift takes whole places, not {what:?}"
                )))
            }
            "dead" => Ok(Self::Dead(part(items, "item", what)?)),
            "stuck" => Ok(Self::Stuck(part(items, "item", what)?)),
            "weak" => Ok(Self::Weak(part(actions, "action", what)?)),
            "lost" => Ok(Self::Lost(part(actions, "action", what)?)),
            "swap" => {
                let two = "swap takes two items or two actions with a comma between them";
                let names = what.split_once(',');
                let (a, b) = names.ok_or_else(|| DamageError(two.to_owned()))?;
                if a == b {
                    return Err(DamageError(format!("{two}, not {a:?} twice")));
                }
                if actions.contains(&a) {
                    let kind = "action";
                    return Ok(Self::SwapActions(
                        part(actions, kind, a)?,
                        part(actions, kind, b)?,
                    ));
                }
                Ok(Self::SwapItems(
                    part(items, "item", a)?,
                    part(items, "item", b)?,
                ))
            }
            other => Err(DamageError(format!(
                "{other:?} is no damage: there are none, camera:DEGREES, shift:N, dead:ITEM, \
                 stuck:ITEM, swap:A,B, pull:DEGREES, weak:ACTION, slip:SHARE, lost:ACTION and beam"
            ))),
        }
    }

    /// The damage as part of a claim's id: `dead_s3`, `swap_s2_s4`, `camera_right12`, and `camera`
    /// for the book's own, 12° to the left.
    #[must_use]
    pub fn id(&self) -> String {
        let text = match *self {
            Self::Camera(12.0) => "camera".to_owned(),
            Self::Camera(degrees) if degrees >= 0.0 => format!("camera_left{degrees}"),
            Self::Camera(degrees) => format!("camera_right{}", -degrees),
            _ => self.to_string(),
        };
        text.replace([':', ',', '.'], "_").replace(['+', '-'], "")
    }
}

impl fmt::Display for Damage {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::None => f.write_str("none"),
            Self::Camera(degrees) => write!(f, "camera:{degrees:+}"),
            Self::Shift(places) => write!(f, "shift:{places:+}"),
            Self::Dead(item) => write!(f, "dead:{}", item.name),
            Self::Stuck(item) => write!(f, "stuck:{}", item.name),
            Self::SwapItems(a, b) | Self::SwapActions(a, b) => {
                write!(f, "swap:{},{}", a.name, b.name)
            }
            Self::Pull(degrees) => write!(f, "pull:{degrees}"),
            Self::Weak(action) => write!(f, "weak:{}", action.name),
            Self::Slip(share) => write!(f, "slip:{share}"),
            Self::Lost(action) => write!(f, "lost:{}", action.name),
            Self::Beam => f.write_str("beam"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Damage;
    use crate::world::pioneer::{ACTIONS, ITEMS};

    #[test]
    fn every_damage_is_read_as_it_is_written() {
        for text in Damage::REPORTED.iter().chain(&[
            "none",
            "shift:-1",
            "stuck:bump",
            "camera:-7.5",
            "dead:ingrip",
        ]) {
            let damage = Damage::parse(text, &ITEMS, &ACTIONS).unwrap();
            assert_eq!(&damage.to_string(), text);
        }
    }

    #[test]
    fn what_names_no_damage_is_refused_in_one_sentence_that_says_why() {
        for (wrong, word) in [
            ("", "no damage"),
            ("flood", "no damage"),
            ("camera", "from -180 to 180"),
            ("camera:NaN", "from -180 to 180"),
            ("camera:200", "from -180 to 180"),
            ("camera:left", "\"left\""),
            ("shift:0.5", "whole places"),
            ("shift:9", "from -4 to 4"),
            ("dead:s9", "no item"),
            ("dead:forward", "no item"),
            ("lost:s3", "no action"),
            ("weak:", "no action"),
            ("swap:s2", "two items"),
            ("swap:s2,s2", "twice"),
            ("swap:s2,forward", "no item"),
            ("swap:forward,s2", "no action"),
            ("slip:-0.1", "from 0 to 1"),
            ("slip:inf", "from 0 to 1"),
            ("camera:0", "say none"),
            ("camera:-0.0", "say none"),
            ("shift:0", "say none"),
            ("pull:0", "say none"),
            ("slip:0", "say none"),
            ("beam:blocked", "alone"),
            ("none:1", "alone"),
        ] {
            let sentence = Damage::parse(wrong, &ITEMS, &ACTIONS)
                .unwrap_err()
                .to_string();
            assert!(sentence.contains(word), "{wrong}: {sentence}");
            assert!(!sentence.contains('\n'), "{wrong}");
        }
    }

    #[test]
    fn ids_of_different_damages_differ_and_are_words() {
        let id = |text| Damage::parse(text, &ITEMS, &ACTIONS).unwrap().id();
        let ids: Vec<String> = Damage::REPORTED.iter().map(|text| id(text)).collect();
        for (index, id) in ids.iter().enumerate() {
            assert!(id.chars().all(|c| c.is_alphanumeric() || c == '_'), "{id}");
            assert!(!ids[..index].contains(id), "{id}");
        }
    }
}
