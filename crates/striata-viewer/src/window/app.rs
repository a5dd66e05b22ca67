//! The window's event loop: turns events into frames, and draws only if something has changed.

use std::path::PathBuf;
use std::sync::Arc;
use std::time::Instant;

use egui::{TextureId, ViewportId};
use striata_gpu::wgpu;
use winit::application::ApplicationHandler;
use winit::dpi::PhysicalSize;
use winit::event::{StartCause, WindowEvent};
use winit::event_loop::{ActiveEventLoop, ControlFlow};
use winit::window::{Window, WindowId};

use super::scene_renderer::SceneRenderer;
use super::screen::{PaintOutcome, Screen, UiFrame};
use super::viewer::Viewer;
use super::{panel, screenshot};
use striata_command::failure::Failure;
use striata_command::output::Output;

/// Event from another thread: something has happened, so draw a frame.
#[derive(Clone, Copy, Debug)]
pub(super) struct Wake;

/// Options for opening the window.
#[derive(Clone, Debug)]
pub(super) struct WindowOptions {
    /// Initial size, pixels.
    pub size: [u32; 2],
    pub theme: Option<egui::Theme>,
    /// Path for a screenshot, after which the window closes.
    pub screenshot: Option<PathBuf>,
}

/// Unchanged frames to wait for before a screenshot: the panel's numbers lag one frame behind.
const SCREENSHOT_IDLE_FRAMES: u32 = 3;

/// The application: the viewer and, while it is open, its window.
pub(super) struct App {
    viewer: Viewer,
    options: WindowOptions,
    output: Output,
    ctx: egui::Context,
    window: Option<OpenWindow>,
    idle_frames: u32,
    /// Error that ended the application, if the user did not close it.
    failure: Option<Failure>,
}

/// State that exists only while the window is open.
struct OpenWindow {
    screen: Screen,
    input: egui_winit::State,
    renderer: SceneRenderer,
    /// The picture's texture in the user interface.
    picture: Option<TextureId>,
    title: String,
}

impl App {
    /// Creates an application whose window is not open yet.
    pub(super) fn new(viewer: Viewer, options: WindowOptions, output: Output) -> Self {
        let ctx = egui::Context::default();
        ctx.options_mut(|settings| {
            // A second pass would process every key press twice.
            settings.max_passes = std::num::NonZeroUsize::MIN;
            if let Some(theme) = options.theme {
                settings.theme_preference = theme.into();
            }
        });
        Self { viewer, options, output, ctx, window: None, idle_frames: 0, failure: None }
    }

    /// Result of the application.
    ///
    /// # Errors
    /// The error that ended it, if the user did not close it.
    pub(super) fn into_result(self) -> Result<(), Failure> {
        self.failure.map_or(Ok(()), Err)
    }

    fn open_window(&self, event_loop: &ActiveEventLoop) -> Result<OpenWindow, Failure> {
        let [width, height] = self.options.size;
        let attributes = Window::default_attributes()
            .with_title("striata")
            .with_inner_size(PhysicalSize::new(width, height))
            .with_min_inner_size(PhysicalSize::new(320, 240));
        let window = event_loop.create_window(attributes);
        let window = window.map_err(|error| {
            Failure::user(format!(
                "cannot open a window: {}",
                super::system_error::without_location(&error.to_string())
            ))
        })?;
        let screen = Screen::new(Arc::new(window), event_loop, &self.output)?;
        let input = egui_winit::State::new(
            self.ctx.clone(),
            ViewportId::ROOT,
            &screen.window,
            Some(screen.window.scale_factor() as f32),
            screen.window.theme(),
            Some(screen.max_side() as usize),
        );
        let renderer = SceneRenderer::new(screen.gpu.clone());
        Ok(OpenWindow { screen, input, renderer, picture: None, title: String::new() })
    }

    fn frame(&mut self, event_loop: &ActiveEventLoop) -> Result<(), Failure> {
        let started = Instant::now();
        let Self { viewer, window: Some(window), ctx, options, .. } = self else { return Ok(()) };
        let size = window.screen.window.inner_size();
        if size.width == 0 || size.height == 0 {
            return Ok(());
        }
        if let Some(subject) = viewer.poll() {
            match window.renderer.load(&subject) {
                Ok(()) => viewer.set_subject(subject),
                Err(error) => {
                    viewer.report_failure(Failure::user(format!("{}: {error}", subject.origin().name)))
                }
            }
        }
        let raw = window.input.take_egui_input(&window.screen.window);
        let picture = window.picture;
        let output = ctx.run_ui(raw, |ui| panel::show(viewer, ui, picture));
        window.input.handle_platform_output(&window.screen.window, output.platform_output);
        viewer.follow();
        let frame = match viewer.draw(&mut window.renderer, started) {
            Ok(frame) => frame,
            Err(error) => {
                viewer.report_failure(Failure::user(error.to_string()));
                Default::default()
            }
        };
        if frame.is_resized {
            window.register_picture();
        }
        let is_idle = viewer.is_idle() && !frame.is_drawn;
        self.idle_frames = if is_idle { self.idle_frames + 1 } else { 0 };
        let takes_screenshot = options.screenshot.is_some() && self.idle_frames >= SCREENSHOT_IDLE_FRAMES;
        let paint = UiFrame {
            primitives: ctx.tessellate(output.shapes, output.pixels_per_point),
            textures: output.textures_delta,
            pixels_per_point: output.pixels_per_point,
        };
        let painted = window.screen.paint(paint, takes_screenshot)?;
        if let Some(report) = window.screen.take_report() {
            viewer.report_failure(Failure::user(format!("the graphics device reported: {report}")));
        }
        window.set_title(viewer);
        let delay = output.viewport_output.get(&ViewportId::ROOT).map(|viewport| viewport.repaint_delay);
        let at = delay.and_then(|delay| started.checked_add(delay));
        event_loop.set_control_flow(at.map_or(ControlFlow::Wait, ControlFlow::WaitUntil));
        let awaits_screenshot = options.screenshot.is_some() && is_idle;
        let must_repeat = matches!(painted, PaintOutcome::Retry);
        // The panel shows figures about a picture one frame later.
        if frame.is_animated || frame.is_drawn || must_repeat || awaits_screenshot {
            window.screen.window.request_redraw();
        }
        if let PaintOutcome::Shown(Some(picture)) = painted {
            event_loop.exit();
            return self.save(&picture);
        }
        if viewer.quits {
            event_loop.exit();
        }
        Ok(())
    }

    /// Writes the screenshot.
    ///
    /// # Errors
    /// The failure that the viewer shows, or why the file cannot be written.
    fn save(&mut self, picture: &striata_gpu::Picture) -> Result<(), Failure> {
        if let Some(failure) = self.viewer.failure.take() {
            return Err(failure);
        }
        let Some(path) = &self.options.screenshot else { return Ok(()) };
        screenshot::save(picture, path)?;
        self.output.say(&format!("{}: {} x {} pixels", path.display(), picture.width, picture.height));
        Ok(())
    }

    fn end(&mut self, event_loop: &ActiveEventLoop, failure: Failure) {
        self.failure = Some(failure);
        event_loop.exit();
    }
}

impl OpenWindow {
    /// Registers the renderer's texture with the user interface.
    fn register_picture(&mut self) {
        let Some(view) = self.renderer.picture() else { return };
        let (device, filter) = (self.screen.gpu.device(), wgpu::FilterMode::Nearest);
        let renderer = &mut self.screen.renderer;
        match self.picture {
            Some(id) => renderer.update_egui_texture_from_wgpu_texture(device, view, filter, id),
            None => self.picture = Some(renderer.register_native_texture(device, view, filter)),
        }
    }

    fn set_title(&mut self, viewer: &Viewer) {
        let title = viewer
            .subject()
            .map_or("striata".to_owned(), |subject| format!("{} – striata", subject.origin().name));
        if title != self.title {
            self.screen.window.set_title(&title);
            self.title = title;
        }
    }
}

impl ApplicationHandler<Wake> for App {
    fn resumed(&mut self, event_loop: &ActiveEventLoop) {
        if self.window.is_some() {
            return;
        }
        match self.open_window(event_loop) {
            Ok(window) => {
                self.viewer.adapter = window.screen.gpu.name();
                window.screen.window.request_redraw();
                self.window = Some(window);
            }
            Err(failure) => self.end(event_loop, failure),
        }
    }

    fn new_events(&mut self, _: &ActiveEventLoop, cause: StartCause) {
        if let (StartCause::ResumeTimeReached { .. }, Some(window)) = (cause, &self.window) {
            window.screen.window.request_redraw();
        }
    }

    fn user_event(&mut self, _: &ActiveEventLoop, Wake: Wake) {
        if let Some(window) = &self.window {
            window.screen.window.request_redraw();
        }
    }

    fn window_event(&mut self, event_loop: &ActiveEventLoop, _: WindowId, event: WindowEvent) {
        let Some(window) = &mut self.window else { return };
        // Redraw requests are not passed to the user interface, which would respond by requesting another
        // frame.
        let is_input = event != WindowEvent::RedrawRequested;
        if is_input && window.input.on_window_event(&window.screen.window, &event).repaint {
            window.screen.window.request_redraw();
        }
        match event {
            WindowEvent::CloseRequested => event_loop.exit(),
            WindowEvent::Resized(size) => {
                window.screen.resize(size.width, size.height);
                window.screen.window.request_redraw();
            }
            WindowEvent::Occluded(false) => window.screen.window.request_redraw(),
            WindowEvent::RedrawRequested => {
                if let Err(failure) = self.frame(event_loop) {
                    self.end(event_loop, failure);
                }
            }
            _ => {}
        }
    }
}
