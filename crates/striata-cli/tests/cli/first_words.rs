//! The words that people try first, and outputs that would replace an input.

use std::fs;

use crate::workbench::{Workbench, sphere};

fn stdout(arguments: &str) -> String {
    let assert = Workbench::new().command(arguments).assert().success();
    String::from_utf8_lossy(&assert.get_output().stdout).into_owned()
}

#[test]
fn help_and_version_are_words_too() {
    assert_eq!(stdout("help"), stdout("--help"));
    assert_eq!(stdout("help simplify"), stdout("simplify --help"));
    assert!(stdout("version").starts_with("striata "));
    assert_eq!(stdout("-v"), stdout("-V"));
}

#[test]
#[cfg(any(feature = "window", feature = "serve"))]
fn a_file_alone_is_viewed() {
    let bench = Workbench::new();
    fs::write(bench.path("ball.obj"), sphere(8, 8)).unwrap();
    assert!(bench.refused("ball.obj --json").contains("`view` has no JSON report"));
    assert!(bench.refused("no-ball.obj").contains("hint: there is no file of this name either"));
}

#[test]
fn words_of_other_tools_have_hints() {
    let bench = Workbench::new();
    for (word, verb) in [("decimate", "simplify"), ("optimize", "convert"), ("inspect", "info")] {
        let message = bench.refused(&format!("{word} ball.obj"));
        assert!(message.contains(&format!("hint: use `striata {verb}`")), "{message}");
    }
    assert!(!bench.refused("gibberish").contains("hint"));
}

#[test]
fn levels_that_are_missing_or_too_large_have_hints() {
    let bench = Workbench::new();
    fs::write(bench.path("ball.obj"), sphere(8, 8)).unwrap();
    assert!(bench.refused("simplify ball.obj -o x.ply").contains("hint: say how small: --ratio 0.1"));
    assert!(!bench.refused("simplify --ratio 0.1 -o x.ply").contains("hint"));
    assert!(bench.refused("simplify ball.obj -o x.ply --ratio 10").contains("10 percent is 10%"));
    assert!(bench.refused("simplify ball.obj -o x.ply --triangles 150%").contains("150% is too large"));
    assert_eq!(bench.json("simplify ball.obj -o x.ply --ratio 10%")["triangle_count"], 12);
}

#[test]
fn no_output_replaces_an_input_unless_the_user_insists() {
    let bench = Workbench::new();
    let text = sphere(8, 8);
    let ball = bench.path("ball.obj");
    fs::write(&ball, &text).unwrap();
    fs::create_dir(bench.path("folder")).unwrap();
    for arguments in [
        "convert ball.obj ball.obj",
        "convert ball.obj folder/../ball.obj",
        "simplify ball.obj -o ./ball.obj --ratio 0.5",
        "encode ball.obj -o ball.obj",
        "build ball.obj -o ball.obj",
    ] {
        let message = bench.refused(arguments);
        assert!(message.contains("the output would overwrite the input"), "{arguments}: {message}");
        assert!(message.contains("--force"), "{arguments}: {message}");
        assert_eq!(fs::read_to_string(&ball).unwrap(), text, "{arguments}");
    }
    bench.json("simplify ball.obj -o ball.obj --ratio 0.5 --force");
    assert_ne!(fs::read_to_string(&ball).unwrap(), text);
    // Another file may be replaced.
    bench.json("convert ball.obj other.obj");
    bench.json("convert ball.obj other.obj");
}

#[test]
fn outputs_may_follow_the_input() {
    let bench = Workbench::new();
    fs::write(bench.path("ball.obj"), sphere(8, 8)).unwrap();
    let same = |first: &str, second: &str| {
        assert_eq!(fs::read(bench.path(first)).unwrap(), fs::read(bench.path(second)).unwrap(), "{first}");
    };
    bench.json("simplify ball.obj a.ply --ratio 0.5");
    bench.json("simplify ball.obj -o b.ply --ratio 0.5");
    same("a.ply", "b.ply");
    bench.json("encode ball.obj a.stri");
    bench.json("encode ball.obj -o b.stri");
    same("a.stri", "b.stri");
    bench.json("decode a.stri a.obj");
    bench.json("extract a.stri --detail 1 b.obj");
    same("a.obj", "b.obj");
    assert!(bench.refused("simplify ball.obj a.ply -o b.ply --ratio 0.5").contains("cannot be used with"));
    assert!(bench.refused("simplify ball.obj --ratio 0.5").contains("<OUT>"));
}
