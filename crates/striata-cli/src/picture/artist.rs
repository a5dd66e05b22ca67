//! Who draws: a GPU, or the rasteriser.

use std::time::Instant;

use super::{Camera, Canvas, Shot, raster};
use crate::failure::Failure;

#[cfg(feature = "gpu")]
use super::GpuArtist;

/// Who draws.
#[derive(Debug)]
pub(crate) enum Artist {
    /// A GPU, or a driver that draws as one.
    #[cfg(feature = "gpu")]
    Gpu(Box<GpuArtist>),
    /// The rasteriser of the command.
    Software,
}

/// What was drawn; where there is nothing one can see through it.
#[derive(Clone, Debug)]
pub(crate) struct Drawn {
    /// The picture.
    pub(crate) canvas: Canvas,
    /// Seconds that one frame took, once all was in place.
    pub(crate) secs: f64,
}

impl Artist {
    /// A GPU where there is one, else the rasteriser.
    pub(crate) fn best() -> Self {
        #[cfg(feature = "gpu")]
        if let Ok(artist) = GpuArtist::open(&Default::default()) {
            return Self::Gpu(Box::new(artist));
        }
        Self::Software
    }

    /// Who it is.
    pub(crate) fn name(&self) -> String {
        match self {
            #[cfg(feature = "gpu")]
            Self::Gpu(artist) => artist.name(),
            Self::Software => "striata's rasteriser".to_owned(),
        }
    }

    /// Draws a shot on so many pixels across and down.
    ///
    /// # Errors
    /// Where a GPU has no room for it, or is lost.
    pub(crate) fn draw(
        &mut self,
        shot: &Shot<'_>,
        camera: &Camera,
        size: [usize; 2],
    ) -> Result<Drawn, Failure> {
        match self {
            #[cfg(feature = "gpu")]
            Self::Gpu(artist) => Ok(artist.draw(shot, camera, size)?),
            Self::Software => {
                let started = Instant::now();
                let canvas = raster::draw(shot, camera, size);
                Ok(Drawn { canvas, secs: started.elapsed().as_secs_f64() })
            }
        }
    }
}

#[cfg(all(test, feature = "gpu"))]
mod tests {
    use std::borrow::Cow;

    use striata::mesh::shapes;

    use super::*;
    use crate::picture::{Angles, Line, Paint, triangle_colours, with_normals};

    /// Both are to be told apart by nothing but rounding and samples.
    #[test]
    fn a_gpu_and_the_rasteriser_draw_the_same() {
        let artist =
            GpuArtist::open(&Default::default()).expect("an adapter; apt-get install mesa-vulkan-drivers");
        let mut gpu = Artist::Gpu(Box::new(artist));
        let mesh = with_normals(shapes::torus(48, 24, 1.0, 0.4));
        let angles = Angles { turn: 0.5, rise: 0.7, up: [0.0, 1.0, 0.0], fov: 0.5 };
        let camera = Camera::around(&mesh.positions, &angles, 1.5);
        let (_, colours) = triangle_colours(&mesh.triangles);
        let by_height = |p: &[f32; 3]| [(127.0 * (1.0 + p[1])) as u8, 40, 200, 255];
        let heights = Paint::Vertices(mesh.positions.iter().map(by_height).collect());
        let line =
            Line { ends: [[-2.0, 0.1, -1.0], [2.0, 0.3, 1.0]], colour: [255, 80, 0, 255], width: 12.0 };
        for (paint, has_edges, is_flat) in [
            (Paint::Surface, false, false),
            (Paint::Triangles(colours), false, true),
            (heights, false, false),
            (Paint::Surface, true, true),
        ] {
            let (triangles, lines) = (Cow::Borrowed(&mesh.triangles[..]), vec![line]);
            let shot = Shot { vertices: &mesh, triangles, strips: None, paint, has_edges, is_flat, lines };
            let pictures = [&mut gpu, &mut Artist::Software]
                .map(|artist| artist.draw(&shot, &camera, [150, 100]).expect("it can be drawn").canvas);
            let pairs = pictures[0].pixels().iter().zip(pictures[1].pixels());
            let distances: Vec<f32> =
                pairs.map(|(a, b)| a.iter().zip(b).map(|(x, y)| (x - y).abs()).fold(0.0, f32::max)).collect();
            let drawn = pictures[1].pixels().iter().filter(|pixel| pixel[3] > 0.5).count();
            let far = distances.iter().filter(|&&d| d > 0.08).count();
            let mean = distances.iter().sum::<f32>() / drawn as f32;
            assert!(drawn > 4000, "{drawn} pixels were drawn");
            assert!(
                far < drawn / 12 && mean < 0.03,
                "{:?}: {far} of {drawn} pixels, mean {mean}",
                shot.paint
            );
        }
    }
}
