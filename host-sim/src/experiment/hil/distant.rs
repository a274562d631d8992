//! A brain in an emulated controller, asked over the wire: the host's end of it.
//!
//! Every order waits for its answer; what is asked again, and when a session begins anew, is decided
//! by [`Caller`].
//! A controller that dies is noticed at once, with how it ended and its last words.

use std::hash::{BuildHasher, RandomState};
use std::io::{Read, Write};
use std::path::Path;
use std::process::{Child, ChildStdin, Stdio};
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::thread;
use std::time::Duration;

use cla_core::forager::pioneer::ITEMS;
use cla_core::word::ItemSet;
use firmware_example::link::{
    self, ATTEMPTS, Answer, Call, Caller, FRAME, Life, News, Order, Outcome, Reply, Seal, encode,
};
use firmware_example::trace::to_bits;

use crate::device::target::Target;
use crate::failure::{Failure, Impossible};
use crate::learner::Learner;
use crate::learner::native::narrowed;
use crate::world::Percept;

/// How long an answer may stay away before it is asked for again.
const PATIENCE: Duration = Duration::from_secs(5);

/// A controller in the emulator.
pub struct Distant {
    child: Child,
    to: Option<ChildStdin>,
    from: Receiver<Vec<u8>>,
    receiver: link::Receiver,
    waiting: Vec<u8>,
    caller: Caller,
    sent: Vec<u8>,
    asked: u32,
    value: u32,
}

impl Distant {
    /// Starts a program on a board and lets its brain be born.
    ///
    /// # Errors
    /// [`Failure`] when there is no emulator, or the firmware does not answer.
    pub fn start(target: Target, program: &Path, seed: u64) -> Result<Self, Failure> {
        let mut it = Self::connect(target, program, Path::new("."), Seal::Checksum)?;
        let (ends, name) = (Life::UNBORN, Life(1));
        match it.ask(Order::Begin { seed, ends, name })? {
            Answer::Done => Ok(it),
            other => Err(unexpected(other)),
        }
    }

    /// Starts a program on a board, in a folder that its flash is a file of, to speak with it in frames
    /// of this seal.
    ///
    /// # Errors
    /// [`Failure`] when there is no emulator.
    pub fn connect(
        target: Target,
        program: &Path,
        folder: &Path,
        seal: Seal,
    ) -> Result<Self, Failure> {
        let mut emulator = target.emulator(program);
        emulator
            .current_dir(folder)
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped());
        let name = emulator.get_program().to_string_lossy().into_owned();
        let mut child = emulator
            .spawn()
            .map_err(|error| Impossible::new(format!("{name} cannot be run: {error}")))?;
        let to = child.stdin.take();
        let mut stream = child.stdout.take().ok_or("a child without output")?;
        let (sender, from) = channel();
        thread::spawn(move || {
            let mut bytes = [0; FRAME];
            while let Ok(count @ 1..) = stream.read(&mut bytes) {
                if sender.send(bytes[..count].to_vec()).is_err() {
                    return;
                }
            }
        });
        Ok(Self {
            child,
            to,
            from,
            receiver: link::Receiver::new(seal),
            waiting: Vec::new(),
            // Names of handshakes, which no result hangs on.
            caller: Caller::new(RandomState::new().hash_one(0)),
            sent: Vec::new(),
            asked: 0,
            value: 0,
        })
    }

    /// Asks, and waits for the answer.
    ///
    /// Where the firmware has stopped the robot meanwhile, an order that was not followed is given
    /// once more: the simulated world stands still, and what was sensed is still so.
    ///
    /// # Errors
    /// [`Failure`] when the firmware died, does not answer, or is not the one it was.
    pub fn ask(&mut self, order: Order) -> Result<Answer, Failure> {
        self.asked += 1;
        let mut call = self.caller.ask(order);
        let mut again = ATTEMPTS;
        loop {
            self.say(call)?;
            call = loop {
                let news = match self.hear()? {
                    Some(reply) => self.caller.hear(reply),
                    None => self.caller.wait(),
                };
                match news {
                    News::Nothing => {}
                    News::Send(call) => break call,
                    News::Answered(answer) => return Ok(answer),
                    News::Interrupted(Outcome::Followed) if is_told(order) => {
                        return Ok(Answer::Done);
                    }
                    News::Interrupted(Outcome::Followed | Outcome::NotFollowed) if again > 0 => {
                        again -= 1;
                        break self.caller.ask(order);
                    }
                    News::Interrupted(_) => {
                        return Err("the firmware was reset, or obeys somebody else".into());
                    }
                    News::OtherVersion(version) => {
                        return Err(format!("the firmware speaks version {version}").into());
                    }
                    News::Silent => {
                        let seconds = (PATIENCE * ATTEMPTS).as_secs();
                        let sentence =
                            format!("the firmware has not answered for {seconds} seconds");
                        return Err(sentence.into());
                    }
                }
            };
        }
    }

    fn say(&mut self, call: Call) -> Result<(), Failure> {
        let mut frame = [0; FRAME];
        let frame = encode(&call, self.receiver.seal(), &mut frame);
        let frame = frame.ok_or("a call that does not fit a frame")?;
        self.sent = frame.to_vec();
        self.send(frame)
    }

    /// Sends bytes as they are: what a noisy wire would deliver.
    ///
    /// # Errors
    /// [`Failure`] when the firmware died.
    pub fn send(&mut self, bytes: &[u8]) -> Result<(), Failure> {
        let sent = match &mut self.to {
            Some(to) => to.write_all(bytes).and_then(|()| to.flush()),
            None => return Err("the wire was cut".into()),
        };
        sent.map_err(|_| self.obituary())
    }

    /// The frame that was sent last.
    #[must_use]
    pub fn last_frame(&self) -> &[u8] {
        &self.sent
    }

    /// The next reply; `None` when it stays away. What is broken is passed over.
    fn hear(&mut self) -> Result<Option<Reply>, Failure> {
        loop {
            while let Some(byte) = self.waiting.pop() {
                if let Some(Ok(reply)) = self.receiver.take::<Reply>(byte) {
                    return Ok(Some(reply));
                }
            }
            match self.from.recv_timeout(PATIENCE) {
                Ok(mut bytes) => {
                    bytes.reverse();
                    self.waiting = bytes;
                }
                Err(RecvTimeoutError::Timeout) => return Ok(None),
                Err(RecvTimeoutError::Disconnected) => return Err(self.obituary()),
            }
        }
    }

    /// How the firmware ended, in one sentence.
    fn obituary(&mut self) -> Failure {
        self.to = None;
        let (status, words) = self.last_words();
        format!(
            "the firmware died after {} orders: {status}; its last words: {words:?}",
            self.asked
        )
        .into()
    }

    /// Waits for the end of the emulator; how it ended and what it complained of.
    fn last_words(&mut self) -> (String, String) {
        let status = match self.child.wait() {
            Ok(status) => status.to_string(),
            Err(error) => error.to_string(),
        };
        let mut words = String::new();
        if let Some(mut stream) = self.child.stderr.take() {
            // What cannot be read was not said.
            let _ = stream.read_to_string(&mut words);
        }
        (status, words.trim().to_owned())
    }

    /// Cuts the wire, as a host does that vanishes, and waits for what the firmware does then.
    #[must_use]
    pub fn vanish(mut self) -> (String, String) {
        self.to = None;
        self.last_words()
    }

    /// The process id of the emulator.
    #[must_use]
    pub fn id(&self) -> u32 {
        self.child.id()
    }

    /// Who lives in the controller, as far as is known.
    #[must_use]
    pub const fn life(&self) -> Life {
        self.caller.life()
    }

    /// Orders given so far, each answered.
    #[must_use]
    pub const fn round_trips(&self) -> u32 {
        self.asked
    }

    /// The bits of the value that decided the last choice.
    #[must_use]
    pub const fn last_value(&self) -> u32 {
        self.value
    }

    fn tell(&mut self, order: Order) -> Result<(), Failure> {
        match self.ask(order)? {
            Answer::Done => Ok(()),
            other => Err(unexpected(other)),
        }
    }

    /// Begins the second level.
    ///
    /// # Errors
    /// As [`ask`](Self::ask).
    pub fn begin_second_level(&mut self) -> Result<(), Failure> {
        self.tell(Order::SecondLevel)
    }
}

impl Drop for Distant {
    fn drop(&mut self) {
        // An emulator that is still there has nobody to serve; one that is gone has nothing to lose.
        self.to = None;
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

impl Learner for Distant {
    fn choose(&mut self, now: &Percept) -> Result<usize, Failure> {
        let now = bits(now)?;
        match self.ask(Order::Choose { now })? {
            Answer::Chosen { action, value } => {
                self.value = value;
                Ok(action.into())
            }
            other => Err(unexpected(other)),
        }
    }

    fn learn(&mut self, now: &Percept) -> Result<(), Failure> {
        let now = bits(now)?;
        self.tell(Order::Learn { now })
    }

    fn observe(&mut self, before: &Percept, action: usize, after: &Percept) -> Result<(), Failure> {
        self.tell(Order::Observe {
            before: bits(before)?,
            action: action as u8,
            after: bits(after)?,
        })
    }

    /// Ends training.
    fn act(&mut self) -> Result<(), Failure> {
        self.tell(Order::Act)
    }
}

/// A percept as the wire carries it: one bit an item, so every item must be known.
fn bits(now: &Percept) -> Result<u8, Failure> {
    let now = narrowed(now);
    if now.known() == ItemSet::first(ITEMS.len() as u16) {
        Ok(to_bits(&now))
    } else {
        // A sensor that says nothing must not reach the brain as one that says off.
        Err("a percept with unknown items does not go over the wire".into())
    }
}

/// Whether the answer to an order says nothing but that it was followed.
fn is_told(order: Order) -> bool {
    !matches!(
        order,
        Order::Choose { .. } | Order::Report | Order::Save | Order::Stop
    )
}

fn unexpected(answer: Answer) -> Failure {
    format!("the firmware answered {answer:?}").into()
}
