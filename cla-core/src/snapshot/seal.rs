//! Sums over the fields of a brain, chunk by chunk.

/// Fields under one sum.
pub(super) const CHUNK: u32 = 512;

/// What a brain's fields are added up by: a sum over the two-element field, so that what a turned bit
/// changes does not hang on the rest.
pub(super) struct Seal<'a> {
    each: &'a mut dyn FnMut(u32),
    sum: u32,
    fields: u32,
}

impl<'a> Seal<'a> {
    pub(super) const fn of(each: &'a mut dyn FnMut(u32)) -> Self {
        Self {
            each,
            sum: 0,
            fields: 0,
        }
    }

    /// A field of up to four bytes.
    #[inline]
    pub(super) fn add(&mut self, bytes: &[u8]) {
        let mut field = 0;
        for byte in bytes.iter().rev() {
            field = field << 8 | u32::from(*byte);
        }
        self.sum = step(self.sum) ^ field;
        self.fields = self.fields.wrapping_add(1);
        if self.fields.is_multiple_of(CHUNK) {
            (self.each)(self.sum);
            self.sum = 0;
        }
    }

    pub(super) fn end(&mut self) -> u32 {
        if !self.fields.is_multiple_of(CHUNK) {
            (self.each)(self.sum);
        }
        self.fields
    }
}

/// A generator of period 2³² − 1 (Marsaglia 2003): each bit of each field of a chunk changes the sum in
/// its own way.
pub(super) const fn step(sum: u32) -> u32 {
    let sum = sum ^ sum << 13;
    let sum = sum ^ sum >> 17;
    sum ^ sum << 5
}
