//! A section of fields from several places: named once in a list, stored, checked and restored by it.

macro_rules! store_fields {
    (($it:expr, $to:expr); $($($part:ident).+ $(if $test:expr)? $(=> $bound:ident $most:expr)?),* $(,)?) => {{
        $(
            $($to.limits.$bound($most);)?
            $crate::snapshot::store_fields!(@ $it, $to, ($($part).+) $($test)?);
            $to.limits.within($crate::snapshot::LARGEST);
        )*
    }};
    (@ $it:expr, $to:expr, ($($part:ident).+) $($test:expr)?) => {
        let part = &$it.$($part).+;
        part.store($to);
        $($to.require($test(part));)?
    };
}

macro_rules! restore_fields {
    (($it:expr, $from:expr); $($($part:ident).+ $(if $test:expr)? $(=> $bound:ident $most:expr)?),* $(,)?) => {{
        $(
            $($from.limits.$bound($most);)?
            $crate::snapshot::restore_fields!(@ $it, $from, ($($part).+) $($test)?);
            $from.limits.within($crate::snapshot::LARGEST);
        )*
    }};
    (@ $it:expr, $from:expr, ($($part:ident).+) $($test:expr)?) => {
        let part = &mut $it.$($part).+;
        part.restore($from);
        $($from.require($test(part));)?
    };
}

macro_rules! check_fields {
    ($from:expr; $($($part:ident).+ $(if $test:expr)? $(=> $bound:ident $most:expr)?),* $(,)?) => {{
        $(
            $($from.limits.$bound($most);)?
            $crate::snapshot::check_fields!(@ $from, ($($part).+) $($test)?);
            $from.limits.within($crate::snapshot::LARGEST);
        )*
    }};
    (@ $from:expr, ($($part:ident).+)) => {
        $crate::snapshot::check_field(|it: &Self| &it.$($part).+, $from)
    };
    (@ $from:expr, ($($part:ident).+) $test:expr) => {
        $crate::snapshot::check_that(|it: &Self| &it.$($part).+, $test, $from)
    };
}

macro_rules! mend_fields {
    (($it:expr, $by:expr); $($($part:ident).+ $(if $test:expr)? $(=> $bound:ident $most:expr)?),* $(,)?) => {{
        $(
            $($by.limits.$bound($most);)?
            $it.$($part).+.mend($by);
            $by.limits.within($crate::snapshot::LARGEST);
        )*
    }};
}

macro_rules! flip_fields {
    (($it:expr, $by:expr); $($($part:ident).+ $(if $test:expr)? $(=> $bound:ident $most:expr)?),* $(,)?) => {{
        $($it.$($part).+.flip($by);)*
    }};
}

pub(crate) use {check_fields, restore_fields, store_fields};
pub(crate) use {flip_fields, mend_fields};
