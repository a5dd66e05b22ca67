//! The window: events in, frames out, and only when there is something new to see.

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

use super::screen::{Paint, Painted, Screen};
use super::stage::Stage;
use super::viewer::Viewer;
use super::{panel, screenshot};
use striata_command::failure::Failure;
use striata_command::output::Output;

/// Something has come from another thread.
#[derive(Clone, Copy, Debug)]
pub(super) struct Wake;

/// How the window begins.
#[derive(Clone, Debug)]
pub(super) struct WindowPlan {
    /// Pixels.
    pub(super) size: [u32; 2],
    pub(super) theme: Option<egui::Theme>,
    /// Where a picture of the window goes, which is closed then.
    pub(super) screenshot: Option<PathBuf>,
}

/// Frames at rest before a screenshot: numbers in the panel follow a frame behind.
const FRAMES_AT_REST: u32 = 3;

/// The program.
pub(super) struct App {
    viewer: Viewer,
    plan: WindowPlan,
    output: Output,
    ctx: egui::Context,
    live: Option<Live>,
    frames_at_rest: u32,
    /// Why it ends, where that is no wish of the user.
    failure: Option<Failure>,
}

/// What there is while there is a window.
struct Live {
    screen: Screen,
    input: egui_winit::State,
    stage: Stage,
    /// The picture as the user interface knows it.
    picture: Option<TextureId>,
    title: String,
}

impl App {
    /// A program that has not begun.
    pub(super) fn new(viewer: Viewer, plan: WindowPlan, output: Output) -> Self {
        let ctx = egui::Context::default();
        ctx.options_mut(|options| {
            // A second pass would hear every key twice.
            options.max_passes = std::num::NonZeroUsize::MIN;
            if let Some(theme) = plan.theme {
                options.theme_preference = theme.into();
            }
        });
        Self { viewer, plan, output, ctx, live: None, frames_at_rest: 0, failure: None }
    }

    /// How it ended.
    ///
    /// # Errors
    /// Why it ended before the user wished.
    pub(super) fn into_result(self) -> Result<(), Failure> {
        self.failure.map_or(Ok(()), Err)
    }

    fn open_window(&self, event_loop: &ActiveEventLoop) -> Result<Live, Failure> {
        let [width, height] = self.plan.size;
        let attributes = Window::default_attributes()
            .with_title("striata")
            .with_inner_size(PhysicalSize::new(width, height))
            .with_min_inner_size(PhysicalSize::new(320, 240));
        let window = event_loop.create_window(attributes);
        let window = window.map_err(|error| {
            Failure::user(format!(
                "no window could be opened: {}",
                super::system_error::without_place(&error.to_string())
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
        let stage = Stage::new(screen.gpu.clone());
        Ok(Live { screen, input, stage, picture: None, title: String::new() })
    }

    fn frame(&mut self, event_loop: &ActiveEventLoop) -> Result<(), Failure> {
        let started = Instant::now();
        let Self { viewer, live: Some(live), ctx, plan, .. } = self else { return Ok(()) };
        let size = live.screen.window.inner_size();
        if size.width == 0 || size.height == 0 {
            return Ok(());
        }
        if let Some(subject) = viewer.poll() {
            match live.stage.enter(&subject) {
                Ok(()) => viewer.meet(subject),
                Err(error) => viewer.complain(Failure::user(format!("{}: {error}", subject.name))),
            }
        }
        let raw = live.input.take_egui_input(&live.screen.window);
        let picture = live.picture;
        let output = ctx.run_ui(raw, |ui| panel::show(viewer, ui, picture));
        live.input.handle_platform_output(&live.screen.window, output.platform_output);
        viewer.follow();
        let frame = match viewer.draw(&mut live.stage, started) {
            Ok(frame) => frame,
            Err(error) => {
                viewer.complain(Failure::user(error.to_string()));
                Default::default()
            }
        };
        if frame.is_resized {
            live.show_picture();
        }
        let is_at_rest = viewer.is_at_rest() && !frame.is_drawn;
        self.frames_at_rest = if is_at_rest { self.frames_at_rest + 1 } else { 0 };
        let keeps_picture = plan.screenshot.is_some() && self.frames_at_rest >= FRAMES_AT_REST;
        let paint = Paint {
            primitives: ctx.tessellate(output.shapes, output.pixels_per_point),
            textures: output.textures_delta,
            pixels_per_point: output.pixels_per_point,
        };
        let painted = live.screen.paint(paint, keeps_picture)?;
        if let Some(report) = live.screen.take_report() {
            viewer.complain(Failure::user(format!("the graphics device reports: {report}")));
        }
        live.set_title(viewer);
        let delay = output.viewport_output.get(&ViewportId::ROOT).map(|viewport| viewport.repaint_delay);
        let at = delay.and_then(|delay| started.checked_add(delay));
        event_loop.set_control_flow(at.map_or(ControlFlow::Wait, ControlFlow::WaitUntil));
        let waits_for_screenshot = plan.screenshot.is_some() && is_at_rest;
        let is_again = matches!(painted, Painted::Again);
        // What the panel says of a picture it says a frame later.
        if frame.goes_on || frame.is_drawn || is_again || waits_for_screenshot {
            live.screen.window.request_redraw();
        }
        if let Painted::Shown(Some(picture)) = painted {
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
    /// What went wrong in the window, or why the file cannot be written.
    fn save(&mut self, shown: &striata_gpu::Picture) -> Result<(), Failure> {
        if let Some(trouble) = self.viewer.trouble.take() {
            return Err(trouble);
        }
        let Some(path) = &self.plan.screenshot else { return Ok(()) };
        screenshot::save(shown, path)?;
        self.output.say(&format!("{}: {} x {} pixels", path.display(), shown.width, shown.height));
        Ok(())
    }

    fn end(&mut self, event_loop: &ActiveEventLoop, failure: Failure) {
        self.failure = Some(failure);
        event_loop.exit();
    }
}

impl Live {
    /// Tells the user interface of the stage's texture.
    fn show_picture(&mut self) {
        let Some(view) = self.stage.picture() else { return };
        let (device, filter) = (self.screen.gpu.device(), wgpu::FilterMode::Nearest);
        let renderer = &mut self.screen.renderer;
        match self.picture {
            Some(id) => renderer.update_egui_texture_from_wgpu_texture(device, view, filter, id),
            None => self.picture = Some(renderer.register_native_texture(device, view, filter)),
        }
    }

    fn set_title(&mut self, viewer: &Viewer) {
        let title =
            viewer.subject().map_or("striata".to_owned(), |subject| format!("{} – striata", subject.name));
        if title != self.title {
            self.screen.window.set_title(&title);
            self.title = title;
        }
    }
}

impl ApplicationHandler<Wake> for App {
    fn resumed(&mut self, event_loop: &ActiveEventLoop) {
        if self.live.is_some() {
            return;
        }
        match self.open_window(event_loop) {
            Ok(live) => {
                self.viewer.adapter = live.screen.gpu.name();
                live.screen.window.request_redraw();
                self.live = Some(live);
            }
            Err(failure) => self.end(event_loop, failure),
        }
    }

    fn new_events(&mut self, _: &ActiveEventLoop, cause: StartCause) {
        if let (StartCause::ResumeTimeReached { .. }, Some(live)) = (cause, &self.live) {
            live.screen.window.request_redraw();
        }
    }

    fn user_event(&mut self, _: &ActiveEventLoop, Wake: Wake) {
        if let Some(live) = &self.live {
            live.screen.window.request_redraw();
        }
    }

    fn window_event(&mut self, event_loop: &ActiveEventLoop, _: WindowId, event: WindowEvent) {
        let Some(live) = &mut self.live else { return };
        // A request to draw is no news to the user interface: told of it, it would ask for the next frame.
        let is_news = event != WindowEvent::RedrawRequested;
        if is_news && live.input.on_window_event(&live.screen.window, &event).repaint {
            live.screen.window.request_redraw();
        }
        match event {
            WindowEvent::CloseRequested => event_loop.exit(),
            WindowEvent::Resized(size) => {
                live.screen.resize(size.width, size.height);
                live.screen.window.request_redraw();
            }
            WindowEvent::Occluded(false) => live.screen.window.request_redraw(),
            WindowEvent::RedrawRequested => {
                if let Err(failure) = self.frame(event_loop) {
                    self.end(event_loop, failure);
                }
            }
            _ => {}
        }
    }
}
