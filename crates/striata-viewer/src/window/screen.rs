//! The window's surface: chooses a device, follows the size, recovers from loss, and paints the user
//! interface.

use std::sync::{Arc, Mutex, PoisonError};

use egui::{ClippedPrimitive, TexturesDelta};
use egui_wgpu::{Renderer, RendererOptions, ScreenDescriptor};
use striata_gpu::{ChosenAdapter, Gpu, GpuError, GpuOptions, Picture, choose_from, wgpu};
use winit::event_loop::ActiveEventLoop;
use winit::window::Window;

use striata_command::driver_messages::without_driver_messages;
use striata_command::failure::{Failure, catch_panic};
use striata_command::output::Output;

/// A window and the device that draws into it.
pub(super) struct Screen {
    pub window: Arc<Window>,
    pub gpu: Gpu,
    pub renderer: Renderer,
    instance: wgpu::Instance,
    surface: wgpu::Surface<'static>,
    config: wgpu::SurfaceConfiguration,
    /// Last error that the device has reported asynchronously.
    reported: Arc<Mutex<Option<String>>>,
}

/// Output of the user interface for one frame.
pub(super) struct UiFrame {
    pub primitives: Vec<ClippedPrimitive>,
    pub textures: TexturesDelta,
    pub pixels_per_point: f32,
}

/// Outcome of painting a frame.
#[derive(Debug)]
pub(super) enum PaintOutcome {
    /// The frame is on the screen; with the picture, if requested.
    Shown(Option<Picture>),
    /// The window is not visible; the system will send an event when it is.
    Hidden,
    /// The surface has changed: paint again.
    Retry,
}

impl Screen {
    /// Opens the best device that can draw into the window, and reports the rejected ones to `output`.
    ///
    /// # Errors
    /// If no device can.
    pub(super) fn new(
        window: Arc<Window>,
        event_loop: &ActiveEventLoop,
        output: &Output,
    ) -> Result<Self, Failure> {
        let display = Box::new(event_loop.owned_display_handle());
        let found = without_driver_messages(output, || catch_panic(|| set_up_graphics(&window, display)));
        let GraphicsSetup { instance, surface, chosen } =
            found.unwrap_or_else(|panic| Err(no_device(&panic)))?;
        let ChosenAdapter { gpu, made: mut config, rejected } = chosen;
        for adapter in rejected {
            output.say(&format!("note: {adapter}; using {} instead", gpu.name()));
        }
        let reported: Arc<Mutex<Option<String>>> = Arc::default();
        let report = Arc::clone(&reported);
        gpu.device().on_uncaptured_error(Arc::new(move |error: wgpu::Error| {
            *report.lock().unwrap_or_else(PoisonError::into_inner) = Some(error.to_string());
        }));
        let (size, limit) = (window.inner_size(), gpu.device().limits().max_texture_dimension_2d);
        let [width, height] = [size.width, size.height].map(|side| side.clamp(1, limit));
        (config.width, config.height) = (width, height);
        surface.configure(gpu.device(), &config);
        let renderer = Renderer::new(gpu.device(), config.format, RendererOptions::default());
        Ok(Self { window, gpu, renderer, instance, surface, config, reported })
    }

    /// Adapts to the window's size. A minimized window has size 0 and keeps its surface.
    pub(super) fn resize(&mut self, width: u32, height: u32) {
        if width == 0 || height == 0 {
            return;
        }
        let limit = self.gpu.device().limits().max_texture_dimension_2d;
        (self.config.width, self.config.height) = (width.min(limit), height.min(limit));
        self.surface.configure(self.gpu.device(), &self.config);
    }

    /// Maximum side of a texture, pixels.
    pub(super) fn max_side(&self) -> u32 {
        self.gpu.device().limits().max_texture_dimension_2d
    }

    /// Takes the error that the device has reported since the last call.
    pub(super) fn take_report(&self) -> Option<String> {
        self.reported.lock().unwrap_or_else(PoisonError::into_inner).take()
    }

    /// Paints the window, and returns the picture if `takes_screenshot`.
    ///
    /// # Errors
    /// If the surface cannot be recreated, or the picture cannot be read.
    pub(super) fn paint(&mut self, frame: UiFrame, takes_screenshot: bool) -> Result<PaintOutcome, Failure> {
        let UiFrame { primitives, mut textures, pixels_per_point } = frame;
        let (device, queue) = (self.gpu.device(), self.gpu.queue());
        // Texture updates are delivered only once, whether or not there is a frame to draw them in.
        let mut set: Vec<_> = textures.set.drain().collect();
        set.sort_unstable_by_key(|&(id, _)| id);
        for (id, deltas) in set {
            deltas.iter().for_each(|delta| self.renderer.update_texture(device, queue, id, delta));
        }
        let result = self.paint_frame(&primitives, pixels_per_point, takes_screenshot);
        textures.free.drain().for_each(|id| self.renderer.free_texture(&id));
        result
    }

    fn paint_frame(
        &mut self,
        primitives: &[ClippedPrimitive],
        pixels_per_point: f32,
        takes_screenshot: bool,
    ) -> Result<PaintOutcome, Failure> {
        let frame = match self.surface.get_current_texture() {
            wgpu::CurrentSurfaceTexture::Success(frame) | wgpu::CurrentSurfaceTexture::Suboptimal(frame) => {
                frame
            }
            wgpu::CurrentSurfaceTexture::Timeout => return Ok(PaintOutcome::Retry),
            wgpu::CurrentSurfaceTexture::Occluded => return Ok(PaintOutcome::Hidden),
            wgpu::CurrentSurfaceTexture::Outdated | wgpu::CurrentSurfaceTexture::Validation => {
                self.surface.configure(self.gpu.device(), &self.config);
                return Ok(PaintOutcome::Retry);
            }
            wgpu::CurrentSurfaceTexture::Lost => {
                let surface = self.instance.create_surface(Arc::clone(&self.window));
                self.surface = surface.map_err(|e| no_device(&e.to_string()))?;
                self.surface.configure(self.gpu.device(), &self.config);
                return Ok(PaintOutcome::Retry);
            }
        };
        let screen =
            ScreenDescriptor { size_in_pixels: [self.config.width, self.config.height], pixels_per_point };
        self.fill(&frame.texture, primitives, &screen);
        let picture = takes_screenshot.then(|| self.copy(primitives, &screen)).transpose()?;
        self.window.pre_present_notify();
        self.gpu.queue().present(frame);
        Ok(PaintOutcome::Shown(picture))
    }

    /// Paints into a readable texture, since the window's own may not be readable.
    fn copy(
        &mut self,
        primitives: &[ClippedPrimitive],
        screen: &ScreenDescriptor,
    ) -> Result<Picture, Failure> {
        let [width, height] = screen.size_in_pixels;
        let texture = self.gpu.device().create_texture(&wgpu::TextureDescriptor {
            label: Some("screenshot"),
            size: wgpu::Extent3d { width, height, depth_or_array_layers: 1 },
            mip_level_count: 1,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format: self.config.format,
            usage: wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::COPY_SRC,
            view_formats: &[],
        });
        self.fill(&texture, primitives, screen);
        Picture::read(&self.gpu, &texture)
            .map_err(|e| Failure::internal(format!("cannot read the screenshot: {e}")))
    }

    fn fill(&mut self, texture: &wgpu::Texture, primitives: &[ClippedPrimitive], screen: &ScreenDescriptor) {
        let (device, queue) = (self.gpu.device(), self.gpu.queue());
        let mut encoder = device.create_command_encoder(&Default::default());
        let before = self.renderer.update_buffers(device, queue, &mut encoder, primitives, screen);
        let view = texture.create_view(&Default::default());
        let pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("window"),
            color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                view: &view,
                depth_slice: None,
                resolve_target: None,
                ops: wgpu::Operations {
                    load: wgpu::LoadOp::Clear(wgpu::Color::BLACK),
                    store: wgpu::StoreOp::Store,
                },
            })],
            ..Default::default()
        });
        self.renderer.render(&mut pass.forget_lifetime(), primitives, screen);
        queue.submit(before.into_iter().chain([encoder.finish()]));
    }
}

/// Graphics objects of a window.
struct GraphicsSetup {
    instance: wgpu::Instance,
    surface: wgpu::Surface<'static>,
    chosen: ChosenAdapter<wgpu::SurfaceConfiguration>,
}

/// Creates a surface for the window and chooses an adapter for it.
///
/// # Errors
/// If no adapter can draw into the window.
fn set_up_graphics(
    window: &Arc<Window>,
    display: Box<dyn wgpu::wgt::WgpuHasDisplayHandle>,
) -> Result<GraphicsSetup, Failure> {
    let instance = wgpu::Instance::new(wgpu::InstanceDescriptor::new_with_display_handle_from_env(display));
    let surface = instance.create_surface(Arc::clone(window)).map_err(|error| match error {
        // The error lists the backends with their reasons, but none if no driver was found at all.
        _ if pollster::block_on(instance.enumerate_adapters(wgpu::Backends::all())).is_empty() => {
            no_device("found no graphics adapter")
        }
        error => no_device(&error.to_string()),
    })?;
    let adapters = |backends| pollster::block_on(instance.enumerate_adapters(backends));
    let stages = [wgpu::Backends::PRIMARY, wgpu::Backends::all() - wgpu::Backends::PRIMARY];
    let found = stages.into_iter().map(adapters);
    let chosen = choose_from(found, &GpuOptions::default(), |gpu, adapter| {
        let config = config_for(&surface, adapter)?;
        gpu.probe()?;
        surface.configure(gpu.device(), &config);
        Ok(config)
    });
    let chosen = chosen.map_err(|error| no_device(&error.to_string()))?;
    Ok(GraphicsSetup { instance, surface, chosen })
}

/// Surface configuration for an adapter.
///
/// # Errors
/// If the adapter cannot draw into the window.
fn config_for(
    surface: &wgpu::Surface<'_>,
    adapter: &wgpu::Adapter,
) -> Result<wgpu::SurfaceConfiguration, GpuError> {
    let config = surface.get_default_config(adapter, 1, 1);
    let mut config = config.ok_or_else(|| GpuError::Failed("it cannot draw into this window".into()))?;
    let formats = surface.get_capabilities(adapter).formats;
    // The user interface blends encoded colors, so the hardware must not encode them again.
    let is_plain = |format: &wgpu::TextureFormat| {
        matches!(format, wgpu::TextureFormat::Bgra8Unorm | wgpu::TextureFormat::Rgba8Unorm)
    };
    config.format = formats.iter().copied().find(is_plain).unwrap_or(config.format);
    config.present_mode = wgpu::PresentMode::AutoVsync;
    Ok(config)
}

/// Error for a window that no device can draw into, with alternatives.
fn no_device(reason: &str) -> Failure {
    let browser =
        if cfg!(feature = "serve") { "use `striata view --browser`, which needs none; or " } else { "" };
    Failure::user(format!("a window needs a graphics driver: {reason}")).with_hint(format!(
        "install one (mesa-vulkan-drivers runs on any CPU); {browser}use `striata render` to draw a picture"
    ))
}
