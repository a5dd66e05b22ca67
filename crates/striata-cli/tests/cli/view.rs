//! `view`, on the available display or a virtual one (Xvfb).

use std::path::Path;
use std::process::{Command, Output};
use std::time::Duration;

use crate::workbench::{NO_DRIVERS, Workbench};

/// Runs the command with a display, and kills it if it does not end.
pub(crate) fn run_on_display(bench: &Workbench, arguments: &[&str]) -> Output {
    run_with(bench, arguments, &[])
}

/// Runs the command with environment variables, on the available display or on Xvfb.
fn run_with(bench: &Workbench, arguments: &[&str], environment: &[(&str, &str)]) -> Output {
    let striata = assert_cmd::cargo::cargo_bin("striata");
    let has_display = ["DISPLAY", "WAYLAND_DISPLAY"].iter().any(|name| std::env::var_os(name).is_some());
    let mut command = if has_display {
        Command::new(&striata)
    } else {
        assert!(
            is_in_path("xvfb-run"),
            "the window is tested on a display: set DISPLAY, or install xvfb, xauth and mesa-vulkan-drivers"
        );
        let mut command = Command::new("xvfb-run");
        command.args(["-a", "-s", "-screen 0 1600x1200x24", "sh", "-c", KEEPS_RESULT]).arg(&striata);
        command
    };
    let kept = tempfile::tempdir().expect("a temporary folder");
    command.arg("view").args(arguments).current_dir(bench.path(".")).envs(environment.iter().copied());
    command.env("KEPT", kept.path());
    let mut output =
        assert_cmd::Command::from_std(command).timeout(Duration::from_secs(600)).output().expect("it starts");
    if let Ok(status) = std::fs::read_to_string(kept.path().join("status")) {
        output.status = exit_status(status.trim().parse().expect("a number"));
        output.stderr = std::fs::read(kept.path().join("stderr")).expect("it was kept");
    }
    output
}

/// Saves the exit code and the messages of the command, since xvfb-run sometimes fails to clean up and then
/// ends with a code and a message of its own.
const KEEPS_RESULT: &str = r#""$0" "$@" 2> "$KEPT/stderr"; echo $? > "$KEPT/status""#;

#[cfg(unix)]
fn exit_status(code: i32) -> std::process::ExitStatus {
    std::os::unix::process::ExitStatusExt::from_raw(code << 8)
}

#[cfg(windows)]
fn exit_status(code: i32) -> std::process::ExitStatus {
    std::os::windows::process::ExitStatusExt::from_raw(code as u32)
}

fn is_in_path(program: &str) -> bool {
    let path = std::env::var_os("PATH").unwrap_or_default();
    std::env::split_paths(&path).any(|folder| folder.join(program).is_file())
}

/// Reads the width, the height and the pixels (three bytes each) of a PNG file.
fn png(path: &Path) -> (usize, usize, Vec<u8>) {
    let file = std::io::BufReader::new(std::fs::File::open(path).expect("the screenshot is there"));
    let mut reader = png::Decoder::new(file).read_info().expect("a PNG header");
    let mut pixels = vec![0; reader.output_buffer_size().expect("a small picture")];
    let info = reader.next_frame(&mut pixels).expect("a picture");
    assert_eq!(info.color_type, png::ColorType::Rgb);
    (info.width as usize, info.height as usize, pixels)
}

/// Takes a screenshot of the window.
fn shot(bench: &Workbench, arguments: &[&str]) -> (usize, usize, Vec<u8>) {
    let name = "shot.png";
    let output = run_on_display(bench, &[arguments, &["--size", "640x480", "--screenshot", name]].concat());
    let stderr = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{arguments:?}: {stderr}");
    assert!(output.stdout.is_empty(), "stdout is for data");
    png(&bench.path(name))
}

/// Counts different colors in the middle of the picture, to the left of the panel.
fn colors_in_the_middle((width, height, pixels): &(usize, usize, Vec<u8>)) -> usize {
    let mut colors = std::collections::BTreeSet::new();
    for y in height / 4..height * 3 / 4 {
        for x in width / 12..width * 5 / 12 {
            let at = 3 * (y * width + x);
            // Coarse steps, so that shading alone gives few colors.
            colors.insert([pixels[at] >> 5, pixels[at + 1] >> 5, pixels[at + 2] >> 5]);
        }
    }
    colors.len()
}

#[test]
fn a_screenshot_shows_the_model_and_the_panel() {
    let bench = Workbench::with_ball();
    let plain = shot(&bench, &["ball.striata"]);
    assert_eq!((plain.0, plain.1), (640, 480));
    let strips = shot(&bench, &["ball.striata", "--colors", "strips"]);
    let [few, many] = [&plain, &strips].map(colors_in_the_middle);
    assert!(few >= 3 && many > few, "{few} colors of light, {many} of strips");
    let fans = shot(&bench, &["sphere.obj", "--pixels", "3", "--theme", "light", "--wireframe"]);
    let corner = |shot: &(usize, usize, Vec<u8>)| shot.2[3 * (shot.1 - 1) * shot.0];
    assert!(corner(&fans) > 200 && corner(&plain) < 60, "light and dark backgrounds");
    assert!(!bench.names().iter().any(|name| name.contains("tmp")), "{:?}", bench.names());
}

#[test]
fn unreadable_files_are_reported_without_a_screenshot() {
    let bench = Workbench::with_ball();
    bench.write("broken.obj", "v 0 0 0\nf 1 2 3\n");
    let output = run_on_display(&bench, &["broken.obj", "--screenshot", "shot.png"]);
    let stderr = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(1), "{stderr}");
    assert!(stderr.contains("broken.obj") && !stderr.contains("panicked"), "{stderr}");
    assert!(!bench.names().contains(&"shot.png".to_owned()));
}

#[test]
fn a_missing_file_or_display_is_reported_with_a_hint() {
    let bench = Workbench::with_ball();
    let stderr = bench.refused("view nowhere.ply");
    assert!(stderr.contains("nowhere.ply") && stderr.contains("hint:"), "{stderr}");
    let stderr = bench.refused("view ball.striata --size 100000x100");
    assert!(stderr.contains("100000x100") && stderr.contains("8192"), "{stderr}");
    let mut command = bench.command("view ball.striata");
    let headless = command.env_remove("DISPLAY").env_remove("WAYLAND_DISPLAY").env_remove("WAYLAND_SOCKET");
    let assert = headless.assert().code(1).stdout("");
    let stderr = String::from_utf8_lossy(&assert.get_output().stderr).into_owned();
    assert!(stderr.contains("display") && stderr.contains("hint: use `striata render`"), "{stderr}");
    assert!(!stderr.contains(".rs:"), "the message names a source file: {stderr}");
}

#[test]
fn a_missing_driver_is_reported_with_a_hint() {
    let bench = Workbench::with_ball();
    let output = run_with(&bench, &["ball.striata", "--screenshot", "shot.png"], &NO_DRIVERS);
    let message = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(1), "{message}");
    assert!(message.contains("a window needs a graphics driver: "), "{message}");
    assert!(
        message.contains("mesa-vulkan-drivers")
            && message.contains(
                "`striata view \
        --browser`"
            ),
        "{message}"
    );
    assert_eq!(message.lines().count(), 2, "an error and a hint: {message}");
}

#[test]
fn a_window_needs_only_opengl() {
    let bench = Workbench::with_ball();
    let arguments = ["ball.striata", "--size", "640x480", "--screenshot", "gl.png"];
    let output = run_with(&bench, &arguments, &[("WGPU_BACKEND", "gl")]);
    let message = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(output.status.success(), "{message}");
    let usual = shot(&bench, &["ball.striata"]);
    let gl = png(&bench.path("gl.png"));
    let far = usual.2.iter().zip(&gl.2).filter(|(a, b)| a.abs_diff(**b) > 32).count();
    assert!(far < usual.2.len() / 50, "{far} of {} bytes differ", usual.2.len());
}
