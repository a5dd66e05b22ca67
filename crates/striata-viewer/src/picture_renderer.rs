//! Chooses what draws pictures: a GPU that has passed a test, or the software rasterizer, which is quicker than
//! drivers that draw on the CPU.
//!
//! Drawing never fails because of a GPU. If no adapter passes its trial, or one fails later, the rasterizer
//! draws instead, and one line on stderr gives the reason.

use std::time::Instant;

#[cfg(feature = "gpu")]
use striata_command::driver_messages::without_driver_messages;
#[cfg(feature = "gpu")]
use striata_command::failure::{Failure, catch_panic};
use striata_command::output::Output;
#[cfg(feature = "gpu")]
use striata_render::gpu::{AdapterKind, GpuError, GpuOptions, GpuRenderer, RejectedAdapter};
use striata_render::{Camera, Drawn, Shot, rasterize};

/// Name of the rasterizer in messages.
const RASTERIZER: &str = "the software rasterizer";

/// Draws shots with a GPU or the rasterizer.
#[derive(Debug)]
pub struct PictureRenderer {
    /// The GPU, until it fails.
    #[cfg(feature = "gpu")]
    gpu: Option<Box<GpuRenderer>>,
    #[cfg_attr(not(feature = "gpu"), expect(dead_code, reason = "only a GPU that fails is reported"))]
    output: Output,
}

impl PictureRenderer {
    /// Uses the best working GPU, or else the rasterizer; the reason is reported to `output`.
    #[cfg(feature = "gpu")]
    pub fn best(output: &Output) -> Self {
        match open(&GpuOptions { kind: AdapterKind::Gpu, ..GpuOptions::default() }, output) {
            Ok((renderer, rejected)) => {
                note_rejected(&rejected, &renderer.gpu().name(), output);
                Self { gpu: Some(Box::new(renderer)), output: *output }
            }
            Err(error) => {
                output.say(&format!("note: {error}; using {RASTERIZER} instead"));
                Self::software(output)
            }
        }
    }

    /// Uses the rasterizer, since this build has no GPU support.
    #[cfg(not(feature = "gpu"))]
    pub fn best(output: &Output) -> Self {
        Self::software(output)
    }

    /// Uses the adapter whose name contains `name`, or the rasterizer if that adapter cannot draw.
    ///
    /// # Errors
    /// If no adapter has this name.
    #[cfg(feature = "gpu")]
    pub fn named(name: &str, output: &Output) -> Result<Self, Failure> {
        let options = GpuOptions { adapter_name: Some(name.to_owned()), ..GpuOptions::default() };
        match open(&options, output) {
            Ok((renderer, _)) => Ok(Self { gpu: Some(Box::new(renderer)), output: *output }),
            Err(error @ GpuError::NoSuchAdapter { .. }) => Err(error.into()),
            Err(error) => {
                output.say(&format!("note: {error}; using {RASTERIZER} instead"));
                Ok(Self::software(output))
            }
        }
    }

    /// Uses the rasterizer.
    pub fn software(output: &Output) -> Self {
        Self {
            #[cfg(feature = "gpu")]
            gpu: None,
            output: *output,
        }
    }

    /// Name of the adapter, or of the rasterizer.
    pub fn name(&self) -> String {
        #[cfg(feature = "gpu")]
        if let Some(renderer) = &self.gpu {
            return renderer.gpu().name();
        }
        RASTERIZER.to_owned()
    }

    /// Draws a shot with `[width, height]` pixels. If the GPU fails, the rasterizer draws this shot and
    /// all later ones.
    pub fn draw(&mut self, shot: &Shot<'_>, camera: &Camera, size: [usize; 2]) -> Drawn {
        #[cfg(feature = "gpu")]
        if let Some(renderer) = &mut self.gpu {
            match attempt(|| renderer.draw(shot, camera, size)) {
                Ok(drawn) => return drawn,
                Err(error) => {
                    let name = renderer.gpu().name();
                    self.output.say(&format!("note: {name}: {error}; using {RASTERIZER} instead"));
                    self.gpu = None;
                }
            }
        }
        let started = Instant::now();
        let canvas = rasterize(shot, camera, size);
        Drawn { canvas, secs: started.elapsed().as_secs_f64() }
    }
}

/// Opens the best adapter that can draw, and returns the better ones that were rejected.
#[cfg(feature = "gpu")]
fn open(options: &GpuOptions, output: &Output) -> Result<(GpuRenderer, Vec<RejectedAdapter>), GpuError> {
    let opened = without_driver_messages(output, || attempt(|| GpuRenderer::open(options)))?;
    if output.is_verbose() {
        let (gpu, info) = (opened.0.gpu(), opened.0.gpu().info());
        output.say(&format!("drawing on {}, driver {} {}", gpu.name(), info.driver, info.driver_info));
    }
    Ok(opened)
}

/// Runs work on the GPU and turns panics of its driver into errors, so that the rasterizer can draw instead.
#[cfg(feature = "gpu")]
fn attempt<T>(work: impl FnOnce() -> Result<T, GpuError>) -> Result<T, GpuError> {
    catch_panic(work).unwrap_or_else(|panic| Err(GpuError::Failed(panic)))
}

#[cfg(feature = "gpu")]
fn note_rejected(rejected: &[RejectedAdapter], chosen: &str, output: &Output) {
    for adapter in rejected {
        output.say(&format!("note: {adapter}; using {chosen} instead"));
    }
}

#[cfg(all(test, feature = "gpu"))]
mod tests {
    use striata::mesh::shapes;
    use striata_render::{Paint, Style, ViewAngles, with_normals};

    use super::*;

    #[test]
    fn a_picture_is_drawn_again_if_the_device_is_lost() {
        let mesh = with_normals(shapes::torus(48, 24, 1.0, 0.4));
        let angles = ViewAngles { turn: 0.5, rise: 0.7, up: [0.0, 1.0, 0.0], fov: 0.5 };
        let camera = Camera::around(&mesh.positions, &angles, 1.5);
        let shot = Shot::of(&mesh, Paint::Surface, Style::SMOOTH);
        let output = Output::quiet();
        let (gpu, _) = open(&GpuOptions::default(), &output).expect("an adapter");
        let device = gpu.gpu().device().clone();
        let mut renderer = PictureRenderer { gpu: Some(Box::new(gpu)), output };
        let expected = PictureRenderer::software(&Output::quiet()).draw(&shot, &camera, [60, 40]).canvas;
        device.destroy();
        assert_eq!(renderer.draw(&shot, &camera, [60, 40]).canvas, expected);
        assert_eq!(renderer.name(), RASTERIZER);
    }
}
