//! Who draws: a GPU that has proved that it can, or the software rasterizer.
//!
//! A picture is never a reason to fail. If no adapter passes its trial, or one fails later, the rasterizer draws, and one line on
//! stderr says why.

use std::time::Instant;

#[cfg(feature = "gpu")]
use striata_gpu::{GpuError, GpuOptions, RejectedAdapter};

use super::{Camera, Drawn, Shot, raster};
#[cfg(feature = "gpu")]
use striata_command::failure::Failure;
use striata_command::output::Output;

#[cfg(feature = "gpu")]
use super::GpuArtist;

/// The name of the rasterizer.
const RASTERIZER: &str = "the software rasterizer";

/// Who draws.
#[derive(Debug)]
pub struct Artist {
    /// The GPU, as long as it works.
    #[cfg(feature = "gpu")]
    gpu: Option<Box<GpuArtist>>,
    #[cfg_attr(not(feature = "gpu"), expect(dead_code, reason = "only a GPU that fails is reported"))]
    output: Output,
}

impl Artist {
    /// The best adapter that works, or else the rasterizer; `output` hears why.
    #[cfg(feature = "gpu")]
    pub fn best(output: &Output) -> Self {
        match GpuArtist::open(&GpuOptions::default(), output) {
            Ok((artist, rejected)) => {
                note_rejected(&rejected, &artist.name(), output);
                Self { gpu: Some(Box::new(artist)), output: *output }
            }
            Err(error) => {
                output.say(&format!("note: {error}; {RASTERIZER} draws instead"));
                Self::software(output)
            }
        }
    }

    /// The rasterizer, since this build has no GPU support.
    #[cfg(not(feature = "gpu"))]
    pub fn best(output: &Output) -> Self {
        Self::software(output)
    }

    /// The adapter whose name contains `name`; the rasterizer if it cannot draw.
    ///
    /// # Errors
    /// If there is no such adapter.
    #[cfg(feature = "gpu")]
    pub fn named(name: &str, output: &Output) -> Result<Self, Failure> {
        let options = GpuOptions::default().with_adapter_name(Some(name.to_owned()));
        match GpuArtist::open(&options, output) {
            Ok((artist, _)) => Ok(Self { gpu: Some(Box::new(artist)), output: *output }),
            Err(error @ GpuError::NoSuchAdapter { .. }) => Err(error.into()),
            Err(error) => {
                output.say(&format!("note: {error}; {RASTERIZER} draws instead"));
                Ok(Self::software(output))
            }
        }
    }

    /// The rasterizer.
    pub fn software(output: &Output) -> Self {
        Self {
            #[cfg(feature = "gpu")]
            gpu: None,
            output: *output,
        }
    }

    /// Who it is.
    pub fn name(&self) -> String {
        #[cfg(feature = "gpu")]
        if let Some(artist) = &self.gpu {
            return artist.name();
        }
        RASTERIZER.to_owned()
    }

    /// Draws a shot with `[width, height]` pixels. If the GPU fails, the rasterizer draws this shot and all later ones.
    pub fn draw(&mut self, shot: &Shot<'_>, camera: &Camera, size: [usize; 2]) -> Drawn {
        #[cfg(feature = "gpu")]
        if let Some(artist) = &mut self.gpu {
            match artist.draw(shot, camera, size) {
                Ok(drawn) => return drawn,
                Err(error) => {
                    let name = artist.name();
                    self.output.say(&format!("note: {name}: {error}; {RASTERIZER} draws instead"));
                    self.gpu = None;
                }
            }
        }
        let started = Instant::now();
        let canvas = raster::draw(shot, camera, size);
        Drawn { canvas, secs: started.elapsed().as_secs_f64() }
    }
}

#[cfg(feature = "gpu")]
fn note_rejected(rejected: &[RejectedAdapter], chosen: &str, output: &Output) {
    for adapter in rejected {
        output.say(&format!("note: {adapter}; {chosen} draws instead"));
    }
}

#[cfg(all(test, feature = "gpu"))]
mod tests {
    use std::borrow::Cow;

    use striata::mesh::{IndexedMesh, shapes};

    use super::*;
    use crate::picture::{Angles, Line, Paint, Style, triangle_colors, with_normals};

    fn on_gpu() -> Artist {
        let output = Output::quiet();
        let (artist, _) = GpuArtist::open(&GpuOptions::default(), &output)
            .expect("an adapter; apt-get install mesa-vulkan-drivers");
        Artist { gpu: Some(Box::new(artist)), output }
    }

    fn torus() -> (IndexedMesh, Camera) {
        let mesh = with_normals(shapes::torus(48, 24, 1.0, 0.4));
        let angles = Angles { turn: 0.5, rise: 0.7, up: [0.0, 1.0, 0.0], fov: 0.5 };
        let camera = Camera::around(&mesh.positions, &angles, 1.5);
        (mesh, camera)
    }

    /// Panics if the GPU's picture differs from the rasterizer's by more than rounding and samples.
    fn both_draw_the_same(shot: &Shot<'_>, camera: &Camera, least_drawn: usize) {
        let pictures = [on_gpu(), Artist::software(&Output::quiet())]
            .map(|mut artist| artist.draw(shot, camera, [150, 100]).canvas);
        let pairs = pictures[0].pixels().iter().zip(pictures[1].pixels());
        let distances: Vec<f32> =
            pairs.map(|(a, b)| a.iter().zip(b).map(|(x, y)| (x - y).abs()).fold(0.0, f32::max)).collect();
        let drawn = pictures[1].pixels().iter().filter(|pixel| pixel[3] > 0.5).count();
        let far = distances.iter().filter(|&&d| d > 0.08).count();
        let mean = distances.iter().sum::<f32>() / drawn as f32;
        assert!(drawn > least_drawn, "{drawn} pixels were drawn");
        assert!(far < drawn / 12 && mean < 0.03, "{:?}: {far} of {drawn} pixels, mean {mean}", shot.paint);
    }

    #[test]
    fn a_gpu_and_the_rasterizer_draw_the_same() {
        let (mesh, camera) = torus();
        let (_, colors) = triangle_colors(&mesh.triangles);
        let by_height = |p: &[f32; 3]| [(127.0 * (1.0 + p[1])) as u8, 40, 200, 255];
        let heights = Paint::Vertices(mesh.positions.iter().map(by_height).collect());
        let line = Line { ends: [[-2.0, 0.1, -1.0], [2.0, 0.3, 1.0]], color: [255, 80, 0, 255], width: 12.0 };
        for (paint, has_edges, is_flat) in [
            (Paint::Surface, false, false),
            (Paint::Triangles(colors), false, true),
            (heights, false, false),
            (Paint::Surface, true, true),
        ] {
            let (triangles, lines) = (Cow::Borrowed(&mesh.triangles[..]), vec![line]);
            let shot = Shot { vertices: &mesh, triangles, strips: None, paint, has_edges, is_flat, lines };
            both_draw_the_same(&shot, &camera, 4000);
        }
    }

    #[test]
    fn both_cut_off_what_reaches_behind_the_eye() {
        let (mesh, _) = torus();
        // Inside the tube, along the ring: triangles all around, many of them across the plane of the eye.
        let camera =
            Camera { eye: [1.0, 0.0, 0.05], look_at: [0.8, 0.05, 0.6], up: [0.0, 1.0, 0.0], fov: 1.2 };
        for style in [Style::SMOOTH, Style::FACETED] {
            both_draw_the_same(&Shot::of(&mesh, Paint::Surface, style), &camera, 14_000);
        }
    }

    #[test]
    fn a_picture_is_drawn_again_if_the_device_is_lost() {
        let (mesh, camera) = torus();
        let shot = Shot::of(&mesh, Paint::Surface, Style::SMOOTH);
        let mut artist = on_gpu();
        let expected = Artist::software(&Output::quiet()).draw(&shot, &camera, [60, 40]).canvas;
        artist.gpu.as_ref().expect("a GPU").destroy();
        assert_eq!(artist.draw(&shot, &camera, [60, 40]).canvas, expected);
        assert_eq!(artist.name(), RASTERIZER);
    }
}
