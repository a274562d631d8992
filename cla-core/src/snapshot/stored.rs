//! How a value is stored: one list of fields for writing, checking and reading.

use super::limits::Limits;
use super::{Flip, Mender, Reader, Writer};

/// What an image keeps of a value, and in which order.
///
/// Implemented for what brains are made of, by listing fields once; tables are read in place, an
/// entry at a time, so that no brain ever lies on the stack.
///
/// ```
/// use cla_core::snapshot::Stored;
/// fn is_stored<T: Stored>() {}
/// is_stored::<[Option<f32>; 3]>();
/// ```
pub trait Stored: Sized {
    /// What stands in its place until it is read.
    const BLANK: Self;

    /// Writes it, and refuses what cannot be so in a sound brain.
    fn store(&self, to: &mut Writer<'_>);

    /// Reads it over what is there, and refuses what cannot be so in a sound brain.
    fn restore(&mut self, from: &mut Reader<'_>);

    /// Reads past it, and refuses the same; what is large does so piece by piece.
    fn check(from: &mut Reader<'_>) {
        let mut it = Self::BLANK;
        it.restore(from);
    }

    /// Notes how many of them a table holds, if others point at them.
    fn count(_limits: &mut Limits, _length: u16) {}

    /// Makes it blank when it cannot be so in a sound brain; what is large does so piece by piece.
    fn mend(&mut self, by: &mut Mender) {
        if refuses(self, by) {
            *self = Self::BLANK;
            by.count();
        }
    }

    /// Turns one bit of it, if that bit is in it.
    fn flip(&mut self, by: &mut Flip);
}

/// Whether an image would refuse a value that is small enough for the stack.
pub(crate) fn refuses<T: Stored>(it: &T, by: &mut Mender) -> bool {
    let mut look = Writer::counting(by.limits);
    it.store(&mut look);
    by.limits = look.limits;
    look.is_unsound()
}

/// Implements [`Stored`] for a struct by its fields.
///
/// Fields behind `;` are not stored and begin with the given value.
/// `if` says what one field may be, `within` how far from 0 its numbers may be, `up_to` the same of
/// numbers that are not negative, `sound` what the whole, small enough for the stack, may be.
macro_rules! stored {
    (
        impl[$($generics:tt)*] $type:ty {
            $($field:ident $(if $test:expr)? $(=> $bound:ident $most:expr)?),* $(,)?
            $(; $($derived:ident: $value:expr),* $(,)?)?
        }
        $(counted $counted:ident)?
    ) => {
        impl<$($generics)*> $crate::snapshot::Stored for $type {
            const BLANK: Self = Self {
                $($field: $crate::snapshot::Stored::BLANK,)*
                $($($derived: $value,)*)?
            };

            fn store(&self, to: &mut $crate::snapshot::Writer<'_>) {
                $(
                    $(to.limits.$bound($most);)?
                    $crate::snapshot::Stored::store(&self.$field, to);
                    to.limits.within($crate::snapshot::LARGEST);
                    $(to.require($test(&self.$field));)?
                )*
            }

            fn restore(&mut self, from: &mut $crate::snapshot::Reader<'_>) {
                $(
                    $(from.limits.$bound($most);)?
                    $crate::snapshot::Stored::restore(&mut self.$field, from);
                    from.limits.within($crate::snapshot::LARGEST);
                    $(from.require($test(&self.$field));)?
                )*
            }

            fn check(from: &mut $crate::snapshot::Reader<'_>) {
                $(
                    $(from.limits.$bound($most);)?
                    $crate::snapshot::stored!(@check from, $field $(, $test)?);
                    from.limits.within($crate::snapshot::LARGEST);
                )*
            }

            fn mend(&mut self, by: &mut $crate::snapshot::Mender) {
                $(
                    $(by.limits.$bound($most);)?
                    $crate::snapshot::Stored::mend(&mut self.$field, by);
                    by.limits.within($crate::snapshot::LARGEST);
                    $(
                        if !$test(&self.$field) {
                            self.$field = $crate::snapshot::Stored::BLANK;
                            by.count();
                        }
                    )?
                )*
            }

            $crate::snapshot::stored!(@flip ($($field),*) ($($($derived),*)?));

            $(fn count(limits: &mut $crate::snapshot::Limits, length: u16) {
                limits.$counted = length;
            })?
        }
    };
    (
        impl[$($generics:tt)*] $type:ty {
            $($field:ident),* $(,)?
            $(; $($derived:ident: $value:expr),* $(,)?)?
        }
        sound |$it:ident, $limits:ident| $sound:expr
        $(, counted $counted:ident)?
    ) => {
        impl<$($generics)*> $crate::snapshot::Stored for $type {
            const BLANK: Self = Self {
                $($field: $crate::snapshot::Stored::BLANK,)*
                $($($derived: $value,)*)?
            };

            fn store(&self, to: &mut $crate::snapshot::Writer<'_>) {
                $($crate::snapshot::Stored::store(&self.$field, to);)*
                let ($it, $limits) = (self, &mut to.limits);
                let sound = $sound;
                to.require(sound);
            }

            fn restore(&mut self, from: &mut $crate::snapshot::Reader<'_>) {
                $($crate::snapshot::Stored::restore(&mut self.$field, from);)*
                let ($it, $limits) = (&*self, &mut from.limits);
                let sound = $sound;
                from.require(sound);
            }

            $crate::snapshot::stored!(@flip ($($field),*) ($($($derived),*)?));

            $(fn count(limits: &mut $crate::snapshot::Limits, length: u16) {
                limits.$counted = length;
            })?
        }
    };
    (@flip ($($field:ident),*) ($($derived:ident),*)) => {
        fn flip(&mut self, by: &mut $crate::snapshot::Flip) {
            $($crate::snapshot::Stored::flip(&mut self.$field, by);)*
            if by.sees_derived() {
                $($crate::snapshot::Stored::flip(&mut self.$derived, by);)*
            }
        }
    };
    (@check $from:ident, $field:ident) => {
        $crate::snapshot::check_field(|it: &Self| &it.$field, $from)
    };
    (@check $from:ident, $field:ident, $test:expr) => {
        $crate::snapshot::check_that(|it: &Self| &it.$field, $test, $from)
    };
}

/// Checks a field whose type is known by where it stands.
pub(crate) fn check_field<S, T: Stored>(_: impl Fn(&S) -> &T, from: &mut Reader<'_>) {
    T::check(from);
}

/// Checks a small field, and what it may be.
pub(crate) fn check_that<S, T: Stored>(
    _: impl Fn(&S) -> &T,
    test: impl Fn(&T) -> bool,
    from: &mut Reader<'_>,
) {
    let mut it = T::BLANK;
    it.restore(from);
    from.require(test(&it));
}

/// Implements [`Stored`] for a newtype as what is in it; `below` is the limit of an index.
macro_rules! stored_as {
    (impl[$($generics:tt)*] $type:ty $(, below $limit:ident)?) => {
        impl<$($generics)*> $crate::snapshot::Stored for $type {
            const BLANK: Self = Self($crate::snapshot::Stored::BLANK);

            fn store(&self, to: &mut $crate::snapshot::Writer<'_>) {
                $crate::snapshot::Stored::store(&self.0, to);
                $(to.require(self.0 < to.limits.$limit);)?
            }

            fn restore(&mut self, from: &mut $crate::snapshot::Reader<'_>) {
                $crate::snapshot::Stored::restore(&mut self.0, from);
                $(from.require(self.0 < from.limits.$limit);)?
            }

            fn flip(&mut self, by: &mut $crate::snapshot::Flip) {
                $crate::snapshot::Stored::flip(&mut self.0, by);
            }
        }
    };
}

/// An enum without fields, or with few, that has a code for each of its values.
pub(crate) trait Codes: Copy {
    /// The value that stands for what is not read yet.
    const FIRST: Self;
    /// Its code.
    fn code(self) -> u8;
    /// The value of a code.
    fn of(code: u8) -> Option<Self>;
}

/// Implements [`Stored`] for an enum by a code for each of its values.
macro_rules! stored_codes {
    ($type:ty { $first:literal: ($($blank:tt)+) $(, $code:literal: ($($value:tt)+))* $(,)? }) => {
        impl $crate::snapshot::Codes for $type {
            const FIRST: Self = $($blank)+;

            fn code(self) -> u8 {
                match self {
                    $($blank)+ => $first,
                    $($($value)+ => $code,)*
                }
            }

            fn of(code: u8) -> Option<Self> {
                match code {
                    $first => Some($($blank)+),
                    $($code => Some($($value)+),)*
                    _ => None,
                }
            }
        }

        impl $crate::snapshot::Stored for $type {
            const BLANK: Self = <Self as $crate::snapshot::Codes>::FIRST;

            fn store(&self, to: &mut $crate::snapshot::Writer<'_>) {
                to.bytes(&[$crate::snapshot::Codes::code(*self)]);
            }

            fn restore(&mut self, from: &mut $crate::snapshot::Reader<'_>) {
                let [code] = from.bytes();
                match <Self as $crate::snapshot::Codes>::of(code) {
                    Some(value) => *self = value,
                    None => from.refuse(),
                }
            }

            fn mend(&mut self, _: &mut $crate::snapshot::Mender) {}

            // A code that means nothing cannot be held.
            fn flip(&mut self, by: &mut $crate::snapshot::Flip) {
                if let Some(bit) = by.field(8) {
                    let code = $crate::snapshot::Codes::code(*self) ^ 1_u8.wrapping_shl(bit);
                    if let Some(value) = <Self as $crate::snapshot::Codes>::of(code) {
                        *self = value;
                    }
                }
            }
        }
    };
}

pub(crate) use {stored, stored_as, stored_codes};

macro_rules! stored_number {
    ($($type:ty),+) => { $(
        impl Stored for $type {
            const BLANK: Self = 0;

            fn store(&self, to: &mut Writer<'_>) {
                to.bytes(&self.to_le_bytes());
            }

            fn restore(&mut self, from: &mut Reader<'_>) {
                *self = Self::from_le_bytes(from.bytes());
            }

            fn mend(&mut self, _: &mut Mender) {}

            fn flip(&mut self, by: &mut Flip) {
                if let Some(bit) = by.field(Self::BITS) {
                    *self ^= (1 as Self).wrapping_shl(bit);
                }
            }
        }
    )+ };
}

stored_number!(u8, i8, u16, u32, i32);

impl Stored for f32 {
    const BLANK: Self = 0.0;

    fn store(&self, to: &mut Writer<'_>) {
        to.require(to.limits.hold(*self));
        to.bytes(&self.to_bits().to_le_bytes());
    }

    fn restore(&mut self, from: &mut Reader<'_>) {
        *self = Self::from_bits(u32::from_le_bytes(from.bytes()));
        from.require(from.limits.hold(*self));
    }

    fn mend(&mut self, by: &mut Mender) {
        if !by.limits.hold(*self) {
            *self = 0.0;
            by.count();
        }
    }

    fn flip(&mut self, by: &mut Flip) {
        let mut bits = self.to_bits();
        bits.flip(by);
        *self = Self::from_bits(bits);
    }
}

stored_codes!(bool {
    0: (false),
    1: (true)
});

/// A byte that says whether there is one, and what there is.
impl<T: Stored> Stored for Option<T> {
    const BLANK: Self = None;

    fn store(&self, to: &mut Writer<'_>) {
        to.bytes(&[u8::from(self.is_some())]);
        if let Some(it) = self {
            it.store(to);
        }
    }

    fn restore(&mut self, from: &mut Reader<'_>) {
        match from.bytes() {
            [0] => *self = None,
            [1] => {
                let mut it = T::BLANK;
                it.restore(from);
                *self = Some(it);
            }
            _ => from.refuse(),
        }
    }

    fn check(from: &mut Reader<'_>) {
        match from.bytes() {
            [0] => {}
            [1] => T::check(from),
            _ => from.refuse(),
        }
    }

    /// What cannot be so is not there.
    fn mend(&mut self, by: &mut Mender) {
        let before = by.mended();
        if let Some(it) = self {
            it.mend(by);
        }
        if by.mended() > before {
            *self = None;
        }
    }

    fn flip(&mut self, by: &mut Flip) {
        if by.field(8) == Some(0) {
            *self = match self {
                Some(_) => None,
                None => Some(T::BLANK),
            };
        } else if let Some(it) = self {
            it.flip(by);
        }
    }
}

/// Nothing takes no bytes.
impl Stored for () {
    const BLANK: Self = ();

    fn store(&self, _: &mut Writer<'_>) {}

    fn restore(&mut self, _: &mut Reader<'_>) {}

    fn flip(&mut self, _: &mut Flip) {}
}

impl<A: Stored, B: Stored> Stored for (A, B) {
    const BLANK: Self = (A::BLANK, B::BLANK);

    fn store(&self, to: &mut Writer<'_>) {
        self.0.store(to);
        self.1.store(to);
    }

    fn restore(&mut self, from: &mut Reader<'_>) {
        self.0.restore(from);
        self.1.restore(from);
    }

    fn mend(&mut self, by: &mut Mender) {
        self.0.mend(by);
        self.1.mend(by);
    }

    fn flip(&mut self, by: &mut Flip) {
        self.0.flip(by);
        self.1.flip(by);
    }
}

impl<T: Stored, const N: usize> Stored for [T; N] {
    const BLANK: Self = [const { T::BLANK }; N];

    fn store(&self, to: &mut Writer<'_>) {
        for it in self {
            it.store(to);
        }
    }

    fn restore(&mut self, from: &mut Reader<'_>) {
        for it in self {
            it.restore(from);
        }
    }

    fn check(from: &mut Reader<'_>) {
        for _ in 0..N {
            if from.is_wrong() {
                return;
            }
            T::check(from);
        }
    }

    fn mend(&mut self, by: &mut Mender) {
        for it in self {
            it.mend(by);
        }
    }

    fn flip(&mut self, by: &mut Flip) {
        for it in self {
            it.flip(by);
        }
    }
}

/// How many there are, and then each of them.
impl<T: Stored, const N: usize> Stored for heapless::Vec<T, N, u16> {
    const BLANK: Self = Self::new();

    fn store(&self, to: &mut Writer<'_>) {
        let length = self.len() as u16;
        length.store(to);
        T::count(&mut to.limits, length);
        for it in self {
            it.store(to);
        }
    }

    fn restore(&mut self, from: &mut Reader<'_>) {
        self.clear();
        let length = u16::from_le_bytes(from.bytes());
        T::count(&mut from.limits, length);
        for _ in 0..length {
            if from.is_wrong() {
                return;
            }
            let mut it = T::BLANK;
            it.restore(from);
            if self.push(it).is_err() {
                from.refuse();
            }
        }
    }

    fn check(from: &mut Reader<'_>) {
        let length = u16::from_le_bytes(from.bytes());
        T::count(&mut from.limits, length);
        from.require(usize::from(length) <= N);
        for _ in 0..length {
            if from.is_wrong() {
                return;
            }
            T::check(from);
        }
    }

    fn mend(&mut self, by: &mut Mender) {
        T::count(&mut by.limits, self.len() as u16);
        for it in self {
            it.mend(by);
        }
    }

    /// A length that is turned loses entries, or gets blank ones as far as there is room.
    fn flip(&mut self, by: &mut Flip) {
        if let Some(bit) = by.field(u16::BITS) {
            let length = self.len() ^ 1_usize.wrapping_shl(bit);
            self.truncate(length);
            while length <= N && self.len() < length {
                if self.push(T::BLANK).is_err() {
                    break;
                }
            }
        }
        for it in self {
            it.flip(by);
        }
    }
}
