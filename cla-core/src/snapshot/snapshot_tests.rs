//! What stands where in an image, and what is refused although its bytes came through.

use super::{
    Flip, Limits, LoadError, Mender, Names, Profile, Reader, Snapshot, Stored, Writer, load, save,
};
use super::{SaveError, SinkFull, SliceSink, SourceEnd};
use crate::num::Schedule;
use crate::word::{ActionId, ItemId, ItemSet, ItemStates};
use std::vec::Vec;

/// A brain of four numbers in two sections.
#[derive(Clone, Debug, PartialEq)]
struct Tiny {
    born: bool,
    share: f32,
    table: heapless::Vec<ActionId, 3, u16>,
    rebuilt: u32,
}

const TINY: Tiny = Tiny {
    born: true,
    share: 0.5,
    table: heapless::Vec::new(),
    rebuilt: 0,
};

impl Snapshot for Tiny {
    const PROFILE: Profile = Profile {
        kind: 9,
        weights: 0,
        capacities: &[("numbers", 4)],
    };
    const SECTIONS: &'static [&'static str] = &["share", "table"];

    fn is_born(&self) -> bool {
        self.born
    }

    fn limits() -> Limits {
        Limits::of(6)
    }

    fn store_section(&self, number: usize, to: &mut Writer<'_>) {
        match number {
            0 => self.share.store(to),
            _ => self.table.store(to),
        }
    }

    fn check_section(number: usize, from: &mut Reader<'_>) {
        match number {
            0 => f32::check(from),
            _ => heapless::Vec::<ActionId, 3, u16>::check(from),
        }
    }

    fn restore_section(&mut self, number: usize, from: &mut Reader<'_>) {
        match number {
            0 => self.share.restore(from),
            _ => self.table.restore(from),
        }
    }

    fn mend_section(&mut self, number: usize, by: &mut Mender) {
        match number {
            0 => self.share.mend(by),
            _ => self.table.mend(by),
        }
    }

    fn flip_section(&mut self, number: usize, by: &mut Flip) {
        match number {
            0 => self.share.flip(by),
            _ => self.table.flip(by),
        }
    }

    fn rebuild(&mut self) {
        self.rebuilt += 1;
    }

    fn forsake(&mut self) {
        self.born = false;
    }
}

fn image(brain: &Tiny) -> Vec<u8> {
    let mut image = std::vec![0; 200];
    let mut sink = SliceSink::new(&mut image);
    let length = save(brain, Names::UNKNOWN, &mut sink).unwrap() as usize;
    assert_eq!(sink.written(), length);
    image.truncate(length);
    image
}

/// The image with its checksums made right.
fn sealed(mut image: Vec<u8>) -> Vec<u8> {
    let of_sections = crc::Crc::<u32>::new(&crc::CRC_32_ISCSI);
    let of_images = crc::Crc::<u32>::new(&crc::CRC_32_ISO_HDLC);
    let seal = |image: &mut Vec<u8>, from: usize, to: usize| {
        let sum = of_sections.checksum(&image[from..to]);
        image[to..to + 4].copy_from_slice(&sum.to_le_bytes());
    };
    seal(&mut image, 0, 76);
    let (mut at, end) = (80, image.len() - 4);
    while at + 10 <= end {
        let length = u32::from_le_bytes(image[at + 2..at + 6].try_into().unwrap());
        let to = at + 6 + length as usize;
        if to + 4 > end {
            break;
        }
        seal(&mut image, at, to);
        at = to + 4;
    }
    let sum = of_images.checksum(&image[..end]);
    image[end..].copy_from_slice(&sum.to_le_bytes());
    image
}

fn read(image: &[u8]) -> Result<Tiny, LoadError<SourceEnd>> {
    let mut brain = Tiny {
        share: 7.0,
        ..TINY.clone()
    };
    let before = brain.clone();
    let loaded = load(&mut brain, Names::UNKNOWN, &mut &*image);
    if loaded.is_err() {
        assert_eq!(brain, before, "a refused image changes nothing");
    }
    loaded.map(|_| brain)
}

fn some() -> Tiny {
    let mut it = TINY.clone();
    it.table.push(ActionId(5)).unwrap();
    it.table.push(ActionId(2)).unwrap();
    it
}

#[test]
fn an_image_is_what_the_table_of_the_module_says() {
    let image = image(&some());
    assert_eq!(&image[..8], b"CLABRAIN");
    assert_eq!(
        image[8..16],
        [2, 0, 80, 0, super::header::NUMERICS as u8, 0, 9, 0]
    );
    assert_eq!(image[16..24], [4, 0, 0, 0, 0, 0, 0, 0]);
    assert_eq!(image[64..72], [0; 8]);
    assert_eq!(image[72..76], (image.len() as u32).to_le_bytes());
    assert_eq!(image[80..86], [0, 0, 4, 0, 0, 0]);
    assert_eq!(image[86..90], 0.5_f32.to_le_bytes());
    assert_eq!(image[94..100], [1, 0, 6, 0, 0, 0]);
    assert_eq!(image[100..106], [2, 0, 5, 0, 2, 0]);
    assert_eq!(image.len(), 114);
    assert_eq!(sealed(image.clone()), image);
    let read = read(&image).unwrap();
    assert_eq!(
        read,
        Tiny {
            rebuilt: 1,
            ..some()
        }
    );
}

#[test]
fn what_cannot_be_so_is_refused_under_a_right_checksum() {
    let whole = image(&some());
    let damaged = |at: usize, bytes: &[u8]| {
        let mut image = whole.clone();
        image[at..at + bytes.len()].copy_from_slice(bytes);
        read(&sealed(image))
    };
    assert_eq!(damaged(0, b"CLABRAIM"), Err(LoadError::NotAnImage));
    assert_eq!(damaged(8, &[0]), Err(LoadError::Version { image: 0 }));
    assert_eq!(damaged(8, &[3]), Err(LoadError::Version { image: 3 }));
    assert_eq!(damaged(10, &[81]), Err(LoadError::Damaged("header")));
    assert_eq!(damaged(72, &[79]), Err(LoadError::Damaged("header")));
    assert_eq!(damaged(12, &[7]), Err(LoadError::Numerics));
    let unknown = "a brain that this program does not know";
    let kind = |image| LoadError::Kind {
        image,
        here: unknown,
    };
    assert_eq!(damaged(14, &[1]), Err(kind("an agent")));
    assert_eq!(damaged(14, &[130]), Err(kind("a mind's knowledge")));
    assert_eq!(damaged(15, &[1]), Err(LoadError::Weights));
    let capacity = |name, image, here| LoadError::Capacity { name, image, here };
    assert_eq!(damaged(16, &[3]), Err(capacity("numbers", 3, 4)));
    assert_eq!(damaged(24, &[3]), Err(capacity("capacities", 3, 0)));
    assert_eq!(damaged(72, &[115]), Err(LoadError::Truncated));
    assert_eq!(damaged(72, &[113]), Err(LoadError::Damaged("end")));
    assert_eq!(damaged(80, &[1]), Err(LoadError::Damaged("share")));
    for length in [3, 5, 255] {
        assert_eq!(damaged(82, &[length]), Err(LoadError::Damaged("share")));
    }
    for float in [f32::NAN, f32::INFINITY] {
        let refused = damaged(86, &float.to_le_bytes());
        assert_eq!(refused, Err(LoadError::Damaged("share")));
    }
    // Four entries do not fit, one leaves bytes over, and there is no seventh action.
    for (at, byte) in [(100, 4), (100, 1), (100, 3), (101, 1), (102, 6), (105, 1)] {
        assert_eq!(damaged(at, &[byte]), Err(LoadError::Damaged("table")));
    }
    assert!(damaged(102, &[4]).is_ok());
}

#[test]
fn a_brain_that_is_not_sound_is_not_saved() {
    let mut nowhere = 0_u32;
    let mut saved = |brain: &Tiny| save(brain, Names::UNKNOWN, &mut nowhere);
    assert!(saved(&some()).is_ok());
    let unborn = Tiny {
        born: false,
        ..some()
    };
    assert_eq!(saved(&unborn), Err(SaveError::NotBorn));
    let mut brain = Tiny {
        share: f32::NAN,
        ..some()
    };
    assert_eq!(saved(&brain), Err(SaveError::Unsound("share")));
    brain.share = 0.0;
    brain.table[1] = ActionId(6);
    assert_eq!(saved(&brain), Err(SaveError::Unsound("table")));
    assert_eq!(nowhere, 114, "what was refused is not begun");
}

#[test]
fn a_sink_that_is_full_is_asked_no_more() {
    let mut asked = 0;
    struct Full<'a>(&'a mut u32);
    impl super::Sink for Full<'_> {
        type Error = SinkFull;
        fn write(&mut self, piece: &[u8]) -> Result<(), SinkFull> {
            *self.0 += 1;
            assert!(piece.len() <= 64);
            if *self.0 == 2 { Err(SinkFull) } else { Ok(()) }
        }
    }
    let saved = save(&some(), Names::UNKNOWN, &mut Full(&mut asked));
    assert_eq!((saved, asked), (Err(SaveError::Sink(SinkFull)), 2));
}

/// What a value becomes and comes back as; `None` when it is refused.
fn carried<T: Stored + PartialEq + core::fmt::Debug>(it: &T) -> Option<Vec<u8>> {
    let mut bytes = Vec::new();
    let mut out = |piece: &[u8]| {
        bytes.extend_from_slice(piece);
        true
    };
    let mut to = Writer::into(&mut out, Limits::of(3));
    it.store(&mut to);
    to.end_image();
    if to.is_unsound() {
        return None;
    }
    bytes.truncate(bytes.len() - 4);
    let mut source = |at: u32, piece: &mut [u8]| {
        piece.copy_from_slice(&bytes[at as usize..][..piece.len()]);
        true
    };
    let mut from = Reader::of(&mut source, Limits::of(3));
    from.allow(bytes.len() as u32);
    let mut back = T::BLANK;
    back.restore(&mut from);
    assert!(!from.is_wrong());
    assert_eq!(back, *it);
    Some(bytes)
}

#[test]
fn values_come_back_and_impossible_ones_are_refused() {
    assert_eq!(
        carried(&0x1234_5678_u32),
        Some(std::vec![0x78, 0x56, 0x34, 0x12])
    );
    assert_eq!(carried(&[Some(true), None]), Some(std::vec![1, 1, 0]));
    assert_eq!(carried(&-0.0_f32), Some(std::vec![0, 0, 0, 0x80]));
    assert!(carried(&f32::NEG_INFINITY).is_none());
    assert!(carried(&ActionId(2)).is_some() && carried(&ActionId(3)).is_none());
    assert!(carried(&ItemId(9)).is_some());
    let mut states = ItemStates::<2>::all_off(40);
    states.set(ItemId(33), Some(true)).unwrap();
    assert_eq!(carried(&states).map(|it| it.len()), Some(16));
    for schedule in [
        Schedule::linear(0.3, 0.1, 50),
        Schedule::geometric(8.0, 0.5, 9),
        Schedule::decay(1.0, 0.0, 600.0),
        Ok(Schedule::ZERO),
    ] {
        assert!(carried(&schedule.unwrap()).is_some());
    }
}

#[test]
fn names_are_told_apart_by_where_they_end() {
    let of = |items: &[&str]| Names::of(items, &["go"]);
    assert_eq!(of(&["ab", "c"]), of(&["ab", "c"]));
    assert_ne!(of(&["ab", "c"]), of(&["a", "bc"]));
    assert_ne!(of(&[]), Names::UNKNOWN);
    assert_eq!(ItemSet::<1>::BLANK, ItemSet::EMPTY);
}
