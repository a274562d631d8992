//! Colours: categories by Okabe and Ito, quantities by a ramp of one hue; both read in grey.

use plotters::style::RGBColor;

/// Okabe and Ito's colours, darkest contrasts first, grey and brown; black is kept for axes and
/// references.
const CATEGORIES: [RGBColor; 8] = [
    RGBColor(0x00, 0x72, 0xB2),
    RGBColor(0xD5, 0x5E, 0x00),
    RGBColor(0x00, 0x9E, 0x73),
    RGBColor(0xCC, 0x79, 0xA7),
    RGBColor(0xE6, 0x9F, 0x00),
    RGBColor(0x56, 0xB4, 0xE9),
    RGBColor(0x77, 0x77, 0x77),
    RGBColor(0x6B, 0x3F, 0x1D),
];

/// From paper to ink, in steps that look equal.
const RAMP: [RGBColor; 6] = [
    RGBColor(0xF7, 0xFB, 0xFF),
    RGBColor(0xC6, 0xDB, 0xEF),
    RGBColor(0x85, 0xBC, 0xDB),
    RGBColor(0x3C, 0x88, 0xBE),
    RGBColor(0x0B, 0x54, 0x9A),
    RGBColor(0x04, 0x20, 0x48),
];

/// The colour of the category with this index; they repeat after eight.
pub(super) fn category(index: usize) -> RGBColor {
    CATEGORIES[index % CATEGORIES.len()]
}

/// The colour of a share between 0 (paper) and 1 (ink); grey when there is no value.
pub(super) fn ramp(share: f64) -> RGBColor {
    if !share.is_finite() {
        return RGBColor(0xDD, 0xDD, 0xDD);
    }
    let place = share.clamp(0.0, 1.0) * (RAMP.len() - 1) as f64;
    let below = (place.floor() as usize).min(RAMP.len() - 2);
    let part = place - below as f64;
    let (from, to) = (RAMP[below], RAMP[below + 1]);
    let mix = |a: u8, b: u8| (f64::from(a) + part * (f64::from(b) - f64::from(a))).round() as u8;
    RGBColor(mix(from.0, to.0), mix(from.1, to.1), mix(from.2, to.2))
}

#[cfg(test)]
mod tests {
    use super::{RAMP, ramp};

    #[test]
    fn the_ramp_grows_darker_all_the_way() {
        let brightness = |share: f64| {
            let colour = ramp(share);
            0.2126 * f64::from(colour.0)
                + 0.7152 * f64::from(colour.1)
                + 0.0722 * f64::from(colour.2)
        };
        for step in 0..50 {
            let share = f64::from(step) / 50.0;
            assert!(brightness(share) > brightness(share + 0.02), "{share}");
        }
        assert_eq!((ramp(-1.0), ramp(2.0)), (RAMP[0], RAMP[5]));
    }
}
