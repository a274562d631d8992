//! PNG files (ISO/IEC 15948): eight bits a colour, one compressed block, nothing optional.

use crc::{CRC_32_ISO_HDLC, Crc};
use miniz_oxide::deflate::compress_to_vec_zlib;

use super::raster::Raster;

const SIGNATURE: &[u8] = b"\x89PNG\r\n\x1a\n";
const CHECK: Crc<u32> = Crc::<u32>::new(&CRC_32_ISO_HDLC);
/// Eight bits, red, green and blue; deflate, filters by row, no interlace.
const FORMAT: [u8; 5] = [8, 2, 0, 0, 0];
/// A row says how it differs from the one above: in figures most do not.
const UP: u8 = 2;
/// Between 0 (fast) and 10 (small).
const EFFORT: u8 = 6;

/// The bytes of a PNG file.
pub(super) fn encode(image: &Raster) -> Vec<u8> {
    let mut header = Vec::new();
    header.extend((image.width() as u32).to_be_bytes());
    header.extend((image.height() as u32).to_be_bytes());
    header.extend(FORMAT);
    let mut rows = Vec::new();
    let mut above = vec![0; 3 * image.width()];
    for row in image.rgb().chunks_exact(above.len().max(1)) {
        rows.push(UP);
        rows.extend(
            row.iter()
                .zip(&above)
                .map(|(now, up)| now.wrapping_sub(*up)),
        );
        above.copy_from_slice(row);
    }
    let mut file = SIGNATURE.to_vec();
    chunk(&mut file, *b"IHDR", &header);
    chunk(&mut file, *b"IDAT", &compress_to_vec_zlib(&rows, EFFORT));
    chunk(&mut file, *b"IEND", &[]);
    file
}

fn chunk(file: &mut Vec<u8>, kind: [u8; 4], data: &[u8]) {
    file.extend((data.len() as u32).to_be_bytes());
    let start = file.len();
    file.extend(kind);
    file.extend(data);
    let check = CHECK.checksum(&file[start..]);
    file.extend(check.to_be_bytes());
}

#[cfg(test)]
mod tests {
    use std::io::Cursor;

    use plotters_backend::BackendColor;

    use super::super::outline::Outline;
    use super::super::raster::Raster;
    use super::encode;

    #[test]
    fn another_decoder_reads_every_pixel_back() {
        let mut image = Raster::white(37, 11);
        let colour = BackendColor {
            alpha: 0.7,
            rgb: (200, 30, 90),
        };
        image.fill(&Outline::circle((12.3, 5.1), 4.7), colour);
        image.fill(&Outline::stroke(&[(0.0, 0.0), (37.0, 11.0)], 2.0), colour);
        let mut reader = png::Decoder::new(Cursor::new(encode(&image)))
            .read_info()
            .unwrap();
        let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
        let frame = reader.next_frame(&mut pixels).unwrap();
        assert_eq!((frame.width, frame.height), (37, 11));
        assert_eq!(frame.color_type, png::ColorType::Rgb);
        assert_eq!(pixels, image.rgb());
    }
}
