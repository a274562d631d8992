//! What is said over the wire: calls of the body's side, and the replies of the brain's.

use serde::{Deserialize, Serialize};

use super::frame::Said;

/// The version of what is said; both sides must speak the same.
///
/// 1 had frames and orders and no handshake, 2 had no [`Order::Save`].
pub const VERSION: u16 = 3;

/// The name of a session: drawn anew by the brain's side at every handshake, so that what was said
/// in one session means nothing in another.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub struct Session(#[serde(with = "postcard::fixint::le")] pub u64);

impl Session {
    /// No session: nobody draws it.
    pub const NONE: Self = Self(0);
}

/// Which order: its session, and its number in it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub struct Turn {
    /// The session.
    pub session: Session,
    /// One more than that of the order before; the first is 1, and opens the session.
    pub number: u32,
}

impl Turn {
    /// No order yet.
    pub const NONE: Self = Self {
        session: Session::NONE,
        number: 0,
    };
}

/// The name of a life, given by whoever lets it begin.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Life(#[serde(with = "postcard::fixint::le")] pub u32);

impl Life {
    /// No life yet.
    pub const UNBORN: Self = Self(0);
}

/// What the body's side says.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Call {
    /// Asks for a session; keeps this form in every version.
    Hello {
        /// [`VERSION`] of who says it.
        version: u16,
        /// A number that the reply repeats; another one for each handshake.
        #[serde(with = "postcard::fixint::le")]
        nonce: u64,
        /// The session that is given up, [`Session::NONE`] where there was none: nothing is followed
        /// in it any more.
        after: Session,
    },
    /// An order in a session.
    Order {
        /// Which.
        turn: Turn,
        /// What is asked for.
        order: Order,
    },
}

/// What the brain's side says.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Reply {
    /// To a hello of another version; keeps this form in every version.
    OtherVersion {
        /// The version that is spoken here.
        version: u16,
        /// The number of the hello.
        #[serde(with = "postcard::fixint::le")]
        nonce: u64,
    },
    /// To a hello: a session may begin.
    Welcome {
        /// The number of the hello.
        #[serde(with = "postcard::fixint::le")]
        nonce: u64,
        /// The session that the first order opens.
        session: Session,
        /// Who lives here.
        life: Life,
        /// The order that was followed last, reports left out: whether one whose answer got lost was
        /// followed can be told by it.
        last: Turn,
    },
    /// To an order.
    Answer {
        /// Which order.
        turn: Turn,
        /// What came of it.
        answer: Answer,
    },
    /// To an order of a session that is over or never was: it was not followed.
    Closed {
        /// Which order.
        turn: Turn,
    },
}

// The first byte that goes into the seal: who hears its own voice does not take it for the other's.
impl Said for Call {
    const WAY: u8 = b'>';
}

impl Said for Reply {
    const WAY: u8 = b'<';
}

/// What is asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Order {
    /// Be born.
    Begin {
        /// Decides the whole life.
        seed: u64,
        /// The life that this ends, [`Life::UNBORN`] where there is none; any other is refused.
        ends: Life,
        /// What the new life is called: neither the name of the one that ends, nor `UNBORN`.
        name: Life,
    },
    /// Choose an action for this percept (one bit an item).
    Choose {
        /// What the sensors say.
        now: u8,
    },
    /// Learn what the action led to that was chosen before, in the order's own session.
    Learn {
        /// What the sensors say.
        now: u8,
    },
    /// Learn from a reflex.
    Observe {
        /// What the sensors said before it.
        before: u8,
        /// The action that it ends with.
        action: u8,
        /// What they say after it.
        after: u8,
    },
    /// Begin the second level.
    SecondLevel,
    /// Training is over: choose by value, and let reliabilities adapt.
    Act,
    /// Say what you counted and what you know. Keeps no robot moving.
    Report,
    /// Stop the robot and end the program.
    Stop,
    /// Stop the robot and keep the brain in flash: what was chosen before is not learned from. The
    /// session goes on.
    Save,
}

/// What came of an order.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Answer {
    /// It is done.
    Done,
    /// Do this.
    Chosen {
        /// Id of the action.
        action: u8,
        /// The bits of the value that decided.
        value: u32,
    },
    /// It was not followed, and nothing has changed.
    Refused(Refusal),
    /// What was asked for with [`Order::Report`].
    Report {
        /// Frames that were dropped.
        dropped: Dropped,
        /// Times that the robot was stopped because no order was followed in time.
        expired: u32,
        /// Schemas known.
        schemas: u16,
        /// A hash of all schemas with their counts and of all beliefs.
        knowledge: u64,
    },
    /// The brain is kept, as this generation.
    Saved(u32),
}

/// Why an order was not followed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Refusal {
    /// The brain cannot do that: it is not born, or there is no such action.
    Brain,
    /// Nothing was chosen in the order's session that could be learned from: a stop came between.
    NothingChosen,
    /// Another life would end than the one that was named, or the new name is none.
    OtherLife,
    /// The brain could not be kept: there is no flash, it refuses, what lies in it is of another
    /// program, or nobody is born. Where something of it was lost in memory, it is now as it was last
    /// kept.
    NotSaved,
}

/// Frames that were not followed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Dropped {
    /// Cut short, damaged, not sealed as agreed, or no message to its last byte.
    pub broken: u32,
    /// Longer than any frame.
    pub oversized: u32,
    /// Old numbers, or numbers from the future.
    pub out_of_turn: u32,
    /// The last order once more: answered as before, but not done again.
    pub repeated: u32,
    /// Orders of sessions that are over or never were.
    pub strange: u32,
}
