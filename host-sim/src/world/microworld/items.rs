//! What the agent perceives of the Microworld: the 76 primitive items of Table 5.2 (book, 5.4).
//!
//! Touch, taste, sight and the sense of its own hand and eye, each a function of the state alone.

use cla_core::word::{ActionId, ItemId, ItemSet, Vocabulary};
use serde::{Deserialize, Serialize};

use super::state::{Body, Cell, Hand, REACH, State};

/// The ten primitive actions of Table 5.1.
pub const ACTIONS: &[&str] = &[
    "handf", "handb", "handr", "handl", "eyef", "eyeb", "eyer", "eyel", "grasp", "ungrasp",
];

/// The 76 primitive items of Table 5.2.
#[rustfmt::skip]
pub const ITEMS: &[&str] = &[
    "hp11", "hp12", "hp13", "hp21", "hp22", "hp23", "hp31", "hp32", "hp33",
    "vp11", "vp12", "vp13", "vp21", "vp22", "vp23", "vp31", "vp32", "vp33",
    "tactf", "tactb", "tactr", "tactl",
    "text0", "text1", "text2", "text3",
    "bodyf", "bodyb", "bodyr", "bodyl",
    "taste0", "taste1", "taste2", "taste3",
    "hcl", "hgr",
    "vf00", "vf01", "vf02", "vf03", "vf04", "vf10", "vf11", "vf12", "vf13", "vf14",
    "vf20", "vf21", "vf22", "vf23", "vf24", "vf30", "vf31", "vf32", "vf33", "vf34",
    "vf40", "vf41", "vf42", "vf43", "vf44",
    "fovf0", "fovf1", "fovf2", "fovb0", "fovb1", "fovb2", "fovr0", "fovr1", "fovr2",
    "fovl0", "fovl1", "fovl2", "fovx0", "fovx1", "fovx2",
];

/// Words of an item set that has room for all items.
pub const WORDS: usize = ITEMS.len().div_ceil(32);

/// A set of the Microworld's items.
pub type Items = ItemSet<WORDS>;

/// The names, to print and to parse schemas.
pub static VOCABULARY: Vocabulary = Vocabulary {
    items: ITEMS,
    actions: ACTIONS,
};

const HP: u16 = 0;
const VP: u16 = 9;
const TACT: u16 = 18;
const TEXT: u16 = 22;
const BODY: u16 = 26;
const TASTE: u16 = 30;
const HCL: u16 = 34;
const HGR: u16 = 35;
const VF: u16 = 36;
const FOV: u16 = 61;

/// The body, one cell behind the mouth: just outside the reach.
const BODY_CELL: (i8, i8) = (1, -1);
/// Front, back, right, left, in the order of Table 5.2.
const SIDES: [(i8, i8); 4] = [(0, 1), (0, -1), (1, 0), (-1, 0)];

/// The index of a primitive action of that name.
#[must_use]
pub fn action(name: &str) -> Option<usize> {
    ACTIONS.iter().position(|&other| other == name)
}

/// The item of that name; `None` when there is none.
#[must_use]
pub fn item(name: &str) -> Option<ItemId> {
    VOCABULARY.item(name)
}

/// The set of the items whose names begin with one of `prefixes`.
#[must_use]
pub fn set_of(prefixes: &[&str]) -> Items {
    let mut set = Items::EMPTY;
    for (index, name) in ITEMS.iter().enumerate() {
        if prefixes.iter().any(|prefix| name.starts_with(prefix)) {
            insert(&mut set, index as u16);
        }
    }
    set
}

/// What an item change is about; recall is reported for each.
///
/// ```
/// use host_sim::world::microworld::{Family, action, item};
/// use cla_core::word::ActionId;
/// let eyer = ActionId(action("eyer").unwrap() as u16);
/// assert_eq!(Family::of(eyer, item("vf21").unwrap()), Family::EyeShifts);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub enum Family {
    /// Where the eye looks.
    EyeProprioception,
    /// Where the hand is.
    HandProprioception,
    /// The visual field while the eye moves.
    EyeShifts,
    /// The visual field while the hand moves.
    HandShifts,
    /// Details in the fovea, whatever moves.
    FovealRelations,
    /// What the hand and the body feel.
    Touch,
    /// What the mouth tastes.
    Taste,
    /// The hand closed, the hand gripping.
    Grasp,
}

impl Family {
    /// All families, in the order of the reports.
    pub const ALL: [Self; 8] = [
        Self::EyeProprioception,
        Self::HandProprioception,
        Self::EyeShifts,
        Self::HandShifts,
        Self::FovealRelations,
        Self::Touch,
        Self::Taste,
        Self::Grasp,
    ];

    /// The family of a change of `item` by `action`.
    #[must_use]
    pub fn of(action: ActionId, item: ItemId) -> Self {
        match item.0 {
            HP..VP => Self::HandProprioception,
            VP..TACT => Self::EyeProprioception,
            TACT..TASTE => Self::Touch,
            TASTE..HCL => Self::Taste,
            HCL..VF => Self::Grasp,
            VF..FOV if (4..8).contains(&action.0) => Self::EyeShifts,
            VF..FOV => Self::HandShifts,
            _ => Self::FovealRelations,
        }
    }

    /// Its name in reports.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::EyeProprioception => "eye proprioception",
            Self::HandProprioception => "hand proprioception",
            Self::EyeShifts => "eye shifts",
            Self::HandShifts => "hand shifts",
            Self::FovealRelations => "foveal relations",
            Self::Touch => "touch",
            Self::Taste => "taste",
            Self::Grasp => "grasp",
        }
    }
}

/// The items that are on in a state.
pub(super) fn perceive(state: &State, body: Body) -> Items {
    let mut on = Items::EMPTY;
    proprioception(state, &mut on);
    touch(state, &mut on);
    sight(state, body, &mut on);
    on
}

fn proprioception(state: &State, on: &mut Items) {
    let index = |cell: Cell| u16::from(cell.x * REACH + cell.y);
    insert(on, HP + index(state.hand_at));
    insert(on, VP + index(state.eye_at));
    if state.hand != Hand::Open {
        insert(on, HCL);
    }
    if state.hand == Hand::Gripping {
        insert(on, HGR);
    }
}

fn touch(state: &State, on: &mut Items) {
    let (hand, ball) = (at(state.hand_at), at(state.ball_at));
    for (side, (dx, dy)) in (0_u16..).zip(SIDES) {
        let beside_hand = (hand.0 + dx, hand.1 + dy);
        if beside_hand == ball || beside_hand == BODY_CELL {
            insert(on, TACT + side);
        }
        let beside_body = (BODY_CELL.0 + dx, BODY_CELL.1 + dy);
        if beside_body == ball || beside_body == hand {
            insert(on, BODY + side);
        }
    }
    if hand == ball {
        insert(on, TEXT + 1);
        insert(on, TEXT + 3);
    }
    // "Objects that are directly in front of the agent and grasped can also be tasted" (5.4.1).
    if state.hand == Hand::Gripping && state.ball_at == Cell::MOUTH {
        insert(on, TASTE + 1);
        insert(on, TASTE + 3);
    }
}

fn sight(state: &State, body: Body, on: &mut Items) {
    // Front, back, right, left and centre of the fovea.
    const FOVEA: [(i8, i8); 5] = [(0, 1), (0, -1), (1, 0), (-1, 0), (0, 0)];
    let eye = at(state.eye_at);
    let objects = [
        (body == Body::Visible).then_some(BODY_CELL),
        Some(at(state.ball_at)),
        Some(at(state.hand_at)),
    ];
    for (detail, object) in (0_u16..).zip(objects) {
        let Some((x, y)) = object else { continue };
        let (dx, dy) = (x - eye.0, y - eye.1);
        if dx.abs() <= 2 && dy.abs() <= 2 {
            insert(on, VF + ((dx + 2) * 5 + dy + 2) as u16);
        }
        for (region, place) in (0_u16..).zip(FOVEA) {
            if place == (dx, dy) {
                insert(on, FOV + region * 3 + detail);
            }
        }
    }
}

fn at(cell: Cell) -> (i8, i8) {
    (cell.x as i8, cell.y as i8)
}

fn insert(set: &mut Items, index: u16) {
    set.insert(ItemId(index))
        .expect("every item has a bit in WORDS words");
}

#[cfg(test)]
mod tests {
    use super::{Body, Cell, Hand, ITEMS, State, item, perceive};

    fn names(state: &State, body: Body) -> Vec<&'static str> {
        perceive(state, body)
            .iter()
            .map(|item| ITEMS[usize::from(item.0)])
            .collect()
    }

    #[test]
    fn the_last_step_to_the_mouth_is_perceived_as_equation_5_30_says() {
        let middle = Cell { x: 1, y: 1 };
        let mouth = State {
            hand_at: Cell::MOUTH,
            eye_at: middle,
            ball_at: Cell::MOUTH,
            hand: Hand::Gripping,
        };
        let on = names(&mouth, Body::Visible);
        for expected in [
            "hp21", "vp22", "bodyf", "taste1", "taste3", "vf21", "fovb1", "fovb2",
        ] {
            assert!(on.contains(&expected), "{expected} is missing in {on:?}");
        }
        assert!(!on.contains(&"vf22") && !on.contains(&"fovx1"));
    }

    #[test]
    fn the_body_is_seen_only_on_request_but_always_felt() {
        let state = State {
            hand_at: Cell::MOUTH,
            eye_at: Cell::MOUTH,
            ball_at: Cell { x: 0, y: 2 },
            hand: Hand::Open,
        };
        let seen = names(&state, Body::Visible);
        let hidden = names(&state, Body::Hidden);
        assert!(seen.contains(&"fovb0") && seen.contains(&"vf21"));
        assert!(!hidden.contains(&"fovb0") && !hidden.contains(&"vf21"));
        assert!(hidden.contains(&"tactb") && hidden.contains(&"bodyf"));
    }

    #[test]
    fn the_item_names_are_those_of_table_5_2() {
        assert_eq!(ITEMS.len(), 76);
        assert_eq!(item("hgr"), Some(super::ItemId(super::HGR)));
        assert_eq!(item("vf44"), Some(super::ItemId(super::FOV - 1)));
        assert_eq!(item("fovx2"), Some(super::ItemId(75)));
    }
}
