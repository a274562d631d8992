//! Frames: exact to the last byte, sealed, apart from each other.

use firmware_example::link::{
    Answer, Call, Dropped, Fault, Key, Life, Order, Receiver, Refusal, Reply, Seal, Session, Turn,
    VERSION,
};

use super::{frame, heard, sealed};

const OBSERVE: Call = Call::Order {
    turn: Turn {
        session: Session(0x0102_0304_0506_0708),
        number: 77,
    },
    order: Order::Observe {
        before: 3,
        action: 2,
        after: 9,
    },
};

#[test]
fn any_cut_and_any_flipped_bit_of_a_frame_is_noticed() {
    for seal in [Seal::Checksum, Seal::Keyed(Key::PUBLISHED)] {
        let good = sealed(&OBSERVE, &seal);
        for bit in 8..8 * (good.len() - 1) {
            let mut damaged = good.clone();
            damaged[bit / 8] ^= 1 << (bit % 8);
            let heard = heard::<Call>(&damaged, seal);
            assert!(heard.iter().all(Result::is_err), "bit {bit}");
        }
        for length in 2..good.len() - 1 {
            let cut = [&good[..length], &[0]].concat();
            assert_eq!(heard::<Call>(&cut, seal), [Err(Fault::Broken)], "{length}");
        }
        assert_eq!(heard::<Call>(&good, seal), [Ok(OBSERVE)]);
    }
}

#[test]
fn a_frame_is_exact_to_its_last_byte() {
    // A message with a byte behind it, and a number written with a byte too many, under right seals.
    let crc = crc::Crc::<u32>::new(&crc::CRC_32_ISCSI);
    let framed = |message: &[u8]| {
        let mut digest = crc.digest();
        digest.update(b">");
        digest.update(message);
        let plain = [message, &digest.finalize().to_le_bytes()].concat();
        [&[0], &*cobs::encode_vec(&plain), &[0]].concat()
    };
    let exact = [1, 8, 7, 6, 5, 4, 3, 2, 1, 77, 3, 3, 2, 9];
    assert_eq!(heard(&framed(&exact), Seal::Checksum), [Ok(OBSERVE)]);
    let behind = [&exact[..], &[0]].concat();
    let long = [&exact[..9], &[77 | 0x80, 0], &exact[10..]].concat();
    for message in [&behind, &long] {
        let heard = heard::<Call>(&framed(message), Seal::Checksum);
        assert_eq!(heard, [Err(Fault::Broken)], "{message:?}");
    }
}

#[test]
fn half_a_frame_spoils_no_other_and_an_echo_is_no_voice() {
    let good = frame(&OBSERVE);
    let both = [&good[..good.len() / 2], &good].concat();
    assert_eq!(
        heard::<Call>(&both, Seal::Checksum),
        [Err(Fault::Broken), Ok(OBSERVE)]
    );
    let mut receiver = Receiver::new(Seal::Checksum);
    for &byte in &good[..6] {
        assert_eq!(receiver.take::<Call>(byte), None);
    }
    assert_eq!(receiver.pause(), Some(Fault::Broken));
    assert_eq!(receiver.pause(), None);
    assert_eq!(heard::<Reply>(&good, Seal::Checksum), [Err(Fault::Broken)]);
}

#[test]
fn a_key_shuts_out_who_has_none_and_who_has_another() {
    let seals = [
        Seal::Checksum,
        Seal::Keyed(Key::PUBLISHED),
        Seal::Keyed(Key([9; 16])),
    ];
    for seal in seals {
        for other in seals.into_iter().filter(|it| *it != seal) {
            let heard = heard::<Call>(&sealed(&OBSERVE, &seal), other);
            assert_eq!(heard, [Err(Fault::Broken)], "{seal:?}");
        }
    }
    assert!(!format!("{:?}", seals[1]).contains("published"));
}

/// All orders, and all replies.
fn everything() -> (Vec<Call>, Vec<Reply>) {
    let turn = Turn {
        session: Session(5),
        number: 300,
    };
    let (version, nonce, session) = (VERSION, 6, Session(5));
    let orders = [
        Order::Begin {
            seed: 1,
            ends: Life(2),
            name: Life(3),
        },
        Order::Choose { now: 1 },
        Order::Learn { now: 2 },
        Order::Observe {
            before: 3,
            action: 4,
            after: 5,
        },
        Order::SecondLevel,
        Order::Act,
        Order::Report,
        Order::Stop,
        Order::Save,
    ];
    let answers = [
        Answer::Done,
        Answer::Chosen {
            action: 1,
            value: 200,
        },
        Answer::Refused(Refusal::Brain),
        Answer::Refused(Refusal::NothingChosen),
        Answer::Refused(Refusal::OtherLife),
        Answer::Refused(Refusal::NotSaved),
        Answer::Report {
            dropped: Dropped {
                broken: 1,
                oversized: 2,
                out_of_turn: 3,
                repeated: 4,
                strange: 5,
            },
            expired: 6,
            schemas: 7,
            knowledge: 8,
        },
        Answer::Saved(9),
    ];
    let hello = Call::Hello {
        version,
        nonce,
        after: session,
    };
    let calls = orders.map(|order| Call::Order { turn, order });
    let others = [
        Reply::OtherVersion { version, nonce },
        Reply::Welcome {
            nonce,
            session,
            life: Life(2),
            last: turn,
        },
        Reply::Closed { turn },
    ];
    let replies = answers.map(|answer| Reply::Answer { turn, answer });
    (
        [hello].into_iter().chain(calls).collect(),
        others.into_iter().chain(replies).collect(),
    )
}

#[test]
fn frames_that_change_are_a_new_version() {
    let (calls, replies) = everything();
    let frames: Vec<u8> = calls
        .iter()
        .map(frame)
        .chain(replies.iter().map(frame))
        .flatten()
        .collect();
    let sum = crc::Crc::<u32>::new(&crc::CRC_32_ISCSI).checksum(&frames);
    assert_eq!((VERSION, frames.len(), sum), (3, 451, 401_196_109));
}
