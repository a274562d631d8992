//! A section of fields from several places: named once in a list, stored, checked and restored by it.

macro_rules! store_fields {
    (($it:expr, $to:expr); $($($part:ident).+ $(if $test:expr)?),* $(,)?) => {{
        $($crate::snapshot::store_fields!(@ $it, $to, ($($part).+) $($test)?);)*
    }};
    (@ $it:expr, $to:expr, ($($part:ident).+) $($test:expr)?) => {
        let part = &$it.$($part).+;
        part.store($to);
        $($to.require($test(part));)?
    };
}

macro_rules! restore_fields {
    (($it:expr, $from:expr); $($($part:ident).+ $(if $test:expr)?),* $(,)?) => {{
        $($crate::snapshot::restore_fields!(@ $it, $from, ($($part).+) $($test)?);)*
    }};
    (@ $it:expr, $from:expr, ($($part:ident).+) $($test:expr)?) => {
        let part = &mut $it.$($part).+;
        part.restore($from);
        $($from.require($test(part));)?
    };
}

macro_rules! check_fields {
    ($from:expr; $($($part:ident).+ $(if $test:expr)?),* $(,)?) => {{
        $($crate::snapshot::check_fields!(@ $from, ($($part).+) $($test)?);)*
    }};
    (@ $from:expr, ($($part:ident).+)) => {
        $crate::snapshot::check_field(|it: &Self| &it.$($part).+, $from)
    };
    (@ $from:expr, ($($part:ident).+) $test:expr) => {
        $crate::snapshot::check_that(|it: &Self| &it.$($part).+, $test, $from)
    };
}

macro_rules! mend_fields {
    (($it:expr, $by:expr); $($($part:ident).+ $(if $test:expr)?),* $(,)?) => {{
        $($it.$($part).+.mend($by);)*
    }};
}

macro_rules! flip_fields {
    (($it:expr, $by:expr); $($($part:ident).+ $(if $test:expr)?),* $(,)?) => {{
        $($it.$($part).+.flip($by);)*
    }};
}

pub(crate) use {check_fields, restore_fields, store_fields};
pub(crate) use {flip_fields, mend_fields};
