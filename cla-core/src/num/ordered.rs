//! Insertion and removal in ordered tables without a panic path.
//!
//! heapless's own methods panic for an index that is too large; the proof by linking allows none.

/// Puts `new` at `index` and moves what stands there and behind it up; whether there was room.
pub(crate) fn insert<T, const N: usize>(
    table: &mut heapless::Vec<T, N, u16>,
    index: usize,
    new: T,
) -> bool
where
    T: Copy,
{
    let room = table.push(new).is_ok();
    if room {
        let mut carried = new;
        for place in table.iter_mut().skip(index) {
            core::mem::swap(place, &mut carried);
        }
    }
    room
}

/// Takes what stands at `index` out and moves what stands behind it down; an index behind the end
/// takes the last.
pub(crate) fn remove<T, const N: usize>(table: &mut heapless::Vec<T, N, u16>, index: usize) {
    if let Some(mut carried) = table.pop() {
        for place in table.iter_mut().skip(index).rev() {
            core::mem::swap(place, &mut carried);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{insert, remove};

    #[test]
    fn the_order_of_the_others_stays() {
        let mut table = heapless::Vec::<u8, 4, u16>::from_slice(&[1, 3, 4]).unwrap();
        assert!(insert(&mut table, 1, 2));
        assert_eq!(table.as_slice(), [1, 2, 3, 4]);
        assert!(!insert(&mut table, 0, 9));
        for (index, left) in [(1, &[1, 3, 4][..]), (2, &[1, 3]), (0, &[3]), (7, &[])] {
            remove(&mut table, index);
            assert_eq!(table.as_slice(), left);
        }
        remove(&mut table, 0);
    }
}
