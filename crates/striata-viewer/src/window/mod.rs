//! `view`: a window with a mesh at any level, by any model, from anywhere.
//!
//! `viewer` is all of it but the window: what is loaded, what is wanted, and when the picture has to be drawn again. A model's
//! triangles come from `shown` and go to the GPU by `stage`; `app` turns a window's events into frames. Nothing is drawn
//! while nothing changes.

mod app;
mod args;
mod frustum;
mod help;
mod loader;
mod orbit;
mod panel;
mod plots;
mod screen;
mod screenshot;
mod shown;
mod stage;
mod state;
mod subject;
mod system_error;
mod viewer;

#[cfg(feature = "serve")]
use std::path::PathBuf;
use std::sync::Arc;

use winit::event_loop::EventLoop;

use self::app::{App, Wake, WindowPlan};
pub use self::args::{FirstArgs, ShownModel, ThemeArg, WindowArgs};
use self::orbit::Up;
use self::state::{Colors, GoalKind, ViewerState};
use self::system_error::without_place;
use self::viewer::Viewer;
#[cfg(feature = "serve")]
use crate::serve;
use striata_command::args::Coloring;
use striata_command::failure::Failure;
use striata_command::input::Input;
use striata_command::output::Output;

/// Opens the window, and closes it when the user does.
///
/// # Errors
/// Where there is no display or no device, a file is not there, or the screenshot cannot be made.
pub fn run(args: &WindowArgs, output: &Output) -> Result<(), Failure> {
    args.files.iter().try_for_each(|path| Input::check_exists(path))?;
    #[cfg(feature = "serve")]
    if args.browser {
        return show_in_browser(&args.files, output);
    }
    let size = args.size()?;
    let event_loop = EventLoop::<Wake>::with_user_event().build().map_err(|error| no_display(&error))?;
    let proxy = event_loop.create_proxy();
    // A window that is closed hears nothing any more.
    let waker = Arc::new(move || {
        let _ = proxy.send_event(Wake);
    });
    let mut viewer = Viewer::new(args.files.clone(), first_state(&args.first), (*output, waker));
    if args.first.z_up {
        viewer.orbit.set_up(Up::Z);
    }
    let theme = args.theme.map(|theme| match theme {
        ThemeArg::Dark => egui::Theme::Dark,
        ThemeArg::Light => egui::Theme::Light,
    });
    let plan = WindowPlan { size, theme, screenshot: args.screenshot.clone() };
    let mut app = App::new(viewer, plan, *output);
    event_loop.run_app(&mut app).map_err(|error| no_display(&error))?;
    app.into_result()
}

/// What the command line wants to see first; a view is followed by a model that can.
fn first_state(args: &FirstArgs) -> ViewerState {
    let mut state = ViewerState::default();
    if let Some(model) = args.model {
        state.model = model;
    }
    let goal = if let Some(triangles) = args.triangles {
        state.ask_for(triangles);
        GoalKind::Triangles
    } else if let Some(pixels) = args.pixels {
        state.pixels = pixels as f32;
        GoalKind::Pixels
    } else if let Some(budget) = args.budget {
        state.ask_for(budget);
        GoalKind::Budget
    } else {
        state.detail = args.detail.unwrap_or(state.detail);
        GoalKind::Detail
    };
    match args.model {
        Some(_) => state.goal = goal,
        None => state.set_goal(goal, true),
    }
    state.colors = match args.colors {
        Coloring::Surface => Colors::Surface,
        Coloring::Strips | Coloring::Fans => Colors::Pieces,
        Coloring::Triangles => Colors::Triangles,
        Coloring::Groups => Colors::Groups,
    };
    (state.wireframe, state.is_flat) = (args.wireframe, args.flat);
    state
}

/// # Errors
/// If there is not one file, or it cannot be served.
#[cfg(feature = "serve")]
fn show_in_browser(files: &[PathBuf], output: &Output) -> Result<(), Failure> {
    let [file] = files else {
        let message = format!("--browser shows one file, and {} are named", files.len());
        return Err(Failure::user(message).with_hint("`striata serve FOLDER` shows all of a folder"));
    };
    serve::show_in_browser(file, output)
}

fn no_display(error: &winit::error::EventLoopError) -> Failure {
    let reason = without_place(&error.to_string());
    Failure::user(format!("there is no display to open a window on: {reason}")).with_hint(
        "`striata render` draws a picture without one; `striata view --browser` needs only a browser",
    )
}
