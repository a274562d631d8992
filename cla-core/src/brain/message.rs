//! The message for too little RAM.

/// A sentence that a constant can make.
pub struct Message {
    text: [u8; 96],
    length: usize,
}

// Evaluated at compile time only: no panic is left in the code.
#[allow(clippy::indexing_slicing)]
impl Message {
    /// How many bytes a brain takes, and how many it may take.
    #[must_use]
    pub const fn of_ram(takes: usize, may_take: usize) -> Self {
        let empty = Self {
            text: [0; 96],
            length: 0,
        };
        let takes = empty.add("the brain takes ").number(takes);
        let limit = takes.add(" bytes, and `ram` allows ").number(may_take);
        limit.add(": allow more, or give it less")
    }

    const fn add(mut self, words: &str) -> Self {
        let words = words.as_bytes();
        let mut at = 0;
        while at < words.len() {
            self.text[self.length] = words[at];
            self.length += 1;
            at += 1;
        }
        self
    }

    /// As it is written in Rust: `12_000`.
    const fn number(mut self, number: usize) -> Self {
        let mut place = 1;
        let mut digits = 1;
        while number / place >= 10 {
            place *= 10;
            digits += 1;
        }
        while place > 0 {
            self.text[self.length] = b'0' + (number / place % 10) as u8;
            self.length += 1;
            place /= 10;
            digits -= 1;
            if digits > 0 && digits % 3 == 0 {
                self.text[self.length] = b'_';
                self.length += 1;
            }
        }
        self
    }

    /// The sentence.
    #[must_use]
    pub const fn as_str(&self) -> &str {
        let (text, _) = self.text.split_at(self.length);
        match core::str::from_utf8(text) {
            Ok(text) => text,
            Err(_) => "the brain takes more bytes than `ram` allows",
        }
    }
}
