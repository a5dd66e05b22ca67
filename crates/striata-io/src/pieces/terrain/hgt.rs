//! SRTM tiles: one degree square, 16-bit heights from the north-west corner, named by the south-west corner.

use std::fs::File;
use std::io::{Read, Seek, SeekFrom};
use std::path::{Path, PathBuf};

use super::raster::{Raster, RasterPlacement, malformed};
use crate::ReadError;

/// The height of samples without a height.
const VOID: i16 = i16::MIN;

/// An SRTM tile.
pub(super) struct Hgt {
    path: PathBuf,
    name: String,
    side: u64,
    placement: RasterPlacement,
}

impl Hgt {
    pub(super) fn open(path: &Path) -> Result<Self, ReadError> {
        let name = path.display().to_string();
        let bytes =
            std::fs::metadata(path).map_err(|source| ReadError::Io { file: name.clone(), source })?.len();
        let side = (bytes / 2).isqrt();
        if side < 2 || 2 * side * side != bytes {
            let reason = format!("{bytes} bytes are not a square of 16-bit heights (1201 or 3601 per side)");
            return Err(malformed(&name, reason));
        }
        let stem = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        let Some((south, west)) = corner_of(&stem) else {
            return Err(malformed(&name, "the name is not that of an SRTM tile, such as N35E138.hgt"));
        };
        let step = 1.0 / (side - 1) as f64;
        let placement = RasterPlacement {
            west,
            north: south + 1.0,
            step: [step; 2],
            is_geographic: true,
            epsg: Some(4326),
        };
        Ok(Self { path: path.to_owned(), name, side, placement })
    }
}

/// Latitude and longitude of the south-west corner in a name such as `N35E138`.
fn corner_of(stem: &str) -> Option<(f64, f64)> {
    let number = |text: &str, limit: f64| text.parse::<f64>().ok().filter(|&x| (0.0..=limit).contains(&x));
    let latitude = number(stem.get(1..3)?, 90.0)?;
    let longitude = number(stem.get(4..7)?, 180.0)?;
    let sign = |letter: Option<&str>, positive: &str, negative: &str| match letter {
        Some(l) if l.eq_ignore_ascii_case(positive) => Some(1.0),
        Some(l) if l.eq_ignore_ascii_case(negative) => Some(-1.0),
        _ => None,
    };
    Some((latitude * sign(stem.get(0..1), "N", "S")?, longitude * sign(stem.get(3..4), "E", "W")?))
}

impl Raster for Hgt {
    fn name(&self) -> &str {
        &self.name
    }

    fn size(&self) -> [u64; 2] {
        [self.side; 2]
    }

    fn placement(&self) -> &RasterPlacement {
        &self.placement
    }

    fn read(&self, at: [u64; 2], [width, height]: [u64; 2]) -> Result<Vec<f32>, ReadError> {
        let failed = |source| ReadError::Io { file: self.name.clone(), source };
        let mut file = File::open(&self.path).map_err(failed)?;
        let mut heights = Vec::with_capacity((width * height) as usize);
        let mut row = vec![0; 2 * width as usize];
        for y in at[1]..at[1] + height {
            file.seek(SeekFrom::Start(2 * (y * self.side + at[0]))).map_err(failed)?;
            file.read_exact(&mut row).map_err(failed)?;
            let height = |bytes: &[u8]| i16::from_be_bytes([bytes[0], bytes[1]]);
            heights
                .extend(row.chunks_exact(2).map(height).map(|h| if h == VOID { f32::NAN } else { h.into() }));
        }
        Ok(heights)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_say_where_tiles_are() {
        assert_eq!(corner_of("N35E138"), Some((35.0, 138.0)));
        assert_eq!(corner_of("s01w072"), Some((-1.0, -72.0)));
        for name in ["", "N35", "X35E138", "N95E138", "fuji", "N35\u{e9}E13"] {
            assert_eq!(corner_of(name), None, "{name}");
        }
    }
}
