//! `view`: a window that shows a scene or a mesh at any level of detail, from any viewpoint.
//!
//! A scene is shown as it is, with its materials, lights and animations (`scene`); one mesh in any model.
//! `viewer` is the application without its window: what is loaded, which level is requested, and when the
//! picture must be redrawn. The triangles of a model come from `instance` and are uploaded and drawn by
//! `scene_renderer`; `app` turns window events into frames. Nothing is drawn while nothing changes.

mod app;
mod args;
mod frustum;
mod help;
mod instance;
mod loader;
mod mesh_subject;
mod open_scene;
mod orbit;
mod panel;
mod plots;
mod scene;
mod scene_renderer;
mod screen;
mod screenshot;
mod state;
mod subject;
mod system_error;
mod viewer;

#[cfg(feature = "serve")]
use std::path::PathBuf;
use std::sync::Arc;

use winit::event_loop::EventLoop;

use self::app::{App, Wake, WindowOptions};
pub use self::args::{FirstArgs, ShownModel, ThemeArg, WindowArgs};
use self::orbit::Up;
use self::state::{Colors, GoalKind, ViewerState};
use self::system_error::without_location;
use self::viewer::Viewer;
#[cfg(feature = "serve")]
use crate::serve;
use striata_command::args::Coloring;
use striata_command::failure::Failure;
use striata_command::input::Input;
use striata_command::output::Output;

/// Opens the window and runs until the user closes it.
///
/// # Errors
/// If there is no display or no device, a file does not exist, or the screenshot cannot be saved.
pub fn run(args: &WindowArgs, output: &Output) -> Result<(), Failure> {
    args.files.iter().try_for_each(|path| Input::check_exists(path))?;
    #[cfg(feature = "serve")]
    if args.browser {
        return show_in_browser(&args.files, output);
    }
    let size = args.size()?;
    let event_loop = EventLoop::<Wake>::with_user_event().build().map_err(|error| no_display(&error))?;
    let proxy = event_loop.create_proxy();
    // Sending fails only after the window was closed.
    let waker = Arc::new(move || {
        let _ = proxy.send_event(Wake);
    });
    let mut viewer = Viewer::new(args.files.clone(), initial_state(&args.first), *output, waker);
    viewer.first_pose = Some(args.first.pose.clone());
    if args.first.z_up {
        viewer.orbit.set_up(Up::Z);
    }
    let theme = args.theme.map(|theme| match theme {
        ThemeArg::Dark => egui::Theme::Dark,
        ThemeArg::Light => egui::Theme::Light,
    });
    let options = WindowOptions { size, theme, screenshot: args.screenshot.clone() };
    let mut app = App::new(viewer, options, *output);
    event_loop.run_app(&mut app).map_err(|error| no_display(&error))?;
    app.into_result()
}

/// Initial state for the command line's arguments; a view-dependent level selects a model that supports it.
fn initial_state(args: &FirstArgs) -> ViewerState {
    let mut state = ViewerState::default();
    if let Some(model) = args.model {
        state.model = model;
    }
    let goal = if let Some(triangles) = args.triangles {
        state.set_triangle_count(triangles);
        GoalKind::Triangles
    } else if let Some(pixels) = args.pixels {
        state.pixels = pixels as f32;
        GoalKind::Pixels
    } else if let Some(budget) = args.budget {
        state.set_triangle_count(budget);
        GoalKind::Budget
    } else {
        state.detail = args.detail.unwrap_or(state.detail);
        GoalKind::Detail
    };
    match args.model {
        Some(_) => state.goal = goal,
        None => state.set_goal(goal),
    }
    state.colors = match args.colors {
        Coloring::Surface => Colors::Surface,
        Coloring::Strips | Coloring::Fans => Colors::StripsOrFans,
        Coloring::Triangles | Coloring::Fragments => Colors::Triangles,
        Coloring::Groups => Colors::Groups,
    };
    (state.wireframe, state.is_flat) = (args.wireframe, args.flat);
    // These are for one mesh.
    let is_of_mesh = args.model.is_some() || args.flat || state.colors == Colors::StripsOrFans;
    state.as_scene = !is_of_mesh;
    state
}

/// Shows a file in the web viewer.
///
/// # Errors
/// If there is not one file, or it cannot be served.
#[cfg(feature = "serve")]
fn show_in_browser(files: &[PathBuf], output: &Output) -> Result<(), Failure> {
    let [file] = files else {
        let message = format!("--browser takes one file, but {} were given", files.len());
        return Err(
            Failure::usage(message).with_hint("use `striata serve FOLDER` to show all models of a folder")
        );
    };
    serve::show_in_browser(file, output)
}

fn no_display(error: &winit::error::EventLoopError) -> Failure {
    let reason = without_location(&error.to_string());
    Failure::user(format!("cannot open a window without a display: {reason}"))
        .with_hint("use `striata render` to draw a picture, or `striata view --browser` to use a browser")
}
