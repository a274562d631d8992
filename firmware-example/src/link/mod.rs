//! The wire between a brain and a body: what is said, how it is framed, and who may order what.
//!
//! `message` is what is said, `frame` how it goes over a wire, `desk` the brain's side as a machine
//! without input or output, `caller` the body's side likewise.
//! A session begins with a handshake and ends with a safe stop; its states are drawn in
//! `docs/decisions/wire.md`.
//! Nothing here panics, whatever comes over the wire.

mod caller;
mod desk;
mod frame;
mod message;

pub use caller::{ATTEMPTS, Caller, News, Outcome};
pub use desk::{Desk, Robot};
#[cfg(feature = "authentic")]
pub use frame::Key;
pub use frame::{FRAME, Fault, Receiver, Said, Seal, encode};
pub use message::{Answer, Call, Dropped, Life, Order, Refusal, Reply, Session, Turn, VERSION};
