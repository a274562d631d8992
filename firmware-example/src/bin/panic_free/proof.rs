//! How an entry is linked, and the panic handler that does not link.

use core::panic::PanicInfo;

// Never linked, so never called.
#[allow(unsafe_code)]
unsafe extern "C" {
    safe fn a_panic_path_is_left() -> !;
}

#[panic_handler]
fn panic(_: &PanicInfo<'_>) -> ! {
    a_panic_path_is_left()
}

/// Each entry is a function of values that the compiler does not know, and `_start` takes its
/// address, so that it is linked whole; `sets` name several entries at once.
macro_rules! entries {
    (
        sets { $($set:literal = [$($member:literal),+ $(,)?]),+ $(,)? }
        $($name:literal ($($argument:ident: $of:ty),* $(,)?) $(-> $out:ty)? $body:block)+
    ) => {
        const WANTED: &str = match option_env!("ENTRY") {
            Some(name) => name,
            None => "all",
        };

        const fn same(a: &str, b: &str) -> bool {
            let (mut a, mut b) = (a.as_bytes(), b.as_bytes());
            while let ([first, rest @ ..], [other, others @ ..]) = (a, b) {
                if *first != *other {
                    return false;
                }
                (a, b) = (rest, others);
            }
            a.is_empty() && b.is_empty()
        }

        const fn wanted(name: &str) -> bool {
            // "control" panics on purpose.
            (same(WANTED, "all") && !same(name, "control"))
                || same(WANTED, name)
                $(|| same(WANTED, $set) && (false $(|| same(name, $member))+))+
        }

        const KNOWN: bool = same(WANTED, "all")
            $(|| same(WANTED, $set))+ $(|| same(WANTED, $name))+;

        #[unsafe(no_mangle)]
        #[allow(unsafe_code)]
        extern "C" fn _start() {
            const { assert!(KNOWN, "ENTRY names no entry") };
            $(if const { wanted($name) } {
                #[inline(never)]
                fn entry($($argument: $of),*) $(-> $out)? $body
                black_box(entry as fn($($of),*) $(-> $out)?);
            })+
        }
    };
}
