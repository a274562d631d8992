//! Lists of calls, as a fuzzer writes them: percepts with unknown items, and configurations whose
//! numbers are anything.

use arbitrary::{Arbitrary, Result, Unstructured};
use cla_core::word::{ItemId, ItemStates};

/// The most calls of one list.
pub(super) const MOST: usize = 160;

/// On, off or unknown, for each item.
#[derive(Clone, Copy, Debug, Arbitrary)]
pub(super) struct Percept {
    on: u8,
    /// Mostly everything is known.
    blind: u8,
    half_blind: bool,
}

impl Percept {
    /// For a robot of so many items.
    pub(super) fn states<const WORDS: usize>(&self, items: u16) -> ItemStates<WORDS> {
        let mut states = ItemStates::all_off(items);
        let unknown = if self.half_blind { self.blind } else { 0 };
        for item in 0..items {
            let bit = |byte: u8| byte >> (item % 8) & 1 == 1;
            let state = (!bit(unknown)).then(|| bit(self.on));
            states
                .set(ItemId(item), state)
                .expect("the robot has the item");
        }
        states
    }
}

/// A number: often a plain one, sometimes any bits.
#[derive(Clone, Copy, Debug)]
pub(super) struct Number(pub(super) f32);

impl<'a> Arbitrary<'a> for Number {
    fn arbitrary(bytes: &mut Unstructured<'a>) -> Result<Self> {
        const PLAIN: [f32; 15] = [
            0.0,
            1.0,
            -1.0,
            0.5,
            1e-6,
            0.999_999,
            10.0,
            1e3,
            1e9,
            1e20,
            3e38,
            f32::MAX,
            f32::MIN_POSITIVE,
            f32::NAN,
            f32::INFINITY,
        ];
        Ok(Self(match bytes.int_in_range(0..=17)? {
            it @ 0..=14 => PLAIN[it],
            15 => f32::from(bytes.arbitrary::<u8>()?) / 255.0,
            16 => f32::from(bytes.arbitrary::<i16>()?) / 16.0,
            _ => f32::from_bits(bytes.arbitrary()?),
        }))
    }
}

/// At most [`MOST`] calls.
pub(super) fn list<'a, T: Arbitrary<'a>>(bytes: &'a [u8]) -> Vec<T> {
    let mut bytes = Unstructured::new(bytes);
    let mut all = Vec::new();
    while all.len() < MOST && !bytes.is_empty() {
        match bytes.arbitrary() {
            Ok(one) => all.push(one),
            Err(_) => break,
        }
    }
    all
}
