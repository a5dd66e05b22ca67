//! The words that people try first, and outputs that would replace an input.

use std::fs;

use serde_json::Value;

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
#[cfg(feature = "serve")]
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

#[test]
fn exit_codes_tell_words_from_files() {
    let bench = Workbench::new();
    bench.write("ball.obj", sphere(8, 8));
    bench.write("broken.obj", "v 0 0\n");
    for words in [
        "decimate ball.obj",
        "simplify ball.obj x.ply",
        "simplify ball.obj x.ply --ratio 10",
        "simplify ball.obj x.docx --ratio 0.1",
        "simplify ball.obj x.ply --levels 50%,10%",
        "simplify ball.obj x.ply --ratio 0.1 --order hausdorff --cost tracked",
        "convert ball.obj ball.obj",
        "convert ball.obj - --json",
        "build ball.obj -o x.striata --models pm",
        "info shape:teapot",
    ] {
        bench.run(words).code(2);
    }
    for files in ["info no-ball.obj", "info broken.obj", "convert ball.obj no/x.ply"] {
        bench.run(files).code(1);
    }
}

#[test]
fn errors_are_json_if_the_report_would_be() {
    let bench = Workbench::new();
    let error = |arguments: &str| {
        let assert = bench.run(arguments).failure();
        let printed: Value = serde_json::from_slice(&assert.get_output().stdout).expect("one JSON object");
        assert_eq!(printed.as_object().map(serde_json::Map::len), Some(1), "{printed}");
        let text = |key: &str| printed["error"][key].as_str().unwrap_or_default().to_owned();
        (text("kind"), text("message"), text("hint"))
    };
    let (kind, message, hint) = error("info no-ball.obj --json");
    assert_eq!(kind, "failed");
    assert!(message.starts_with("no-ball.obj: ") && hint.starts_with("check the path"), "{message}; {hint}");
    let (kind, message, hint) = error("simplify shape:torus x.ply --json");
    assert_eq!(kind, "usage");
    assert!(message.contains("--ratio") && hint.starts_with("say how small"), "{message}; {hint}");
    let (_, message, hint) = error("simplify --json shape:torus x.ply --rato 0.5");
    assert!(
        message.contains("unexpected argument '--rato'") && hint.contains("--ratio"),
        "{message}; {hint}"
    );
}

#[test]
fn a_large_error_limit_is_questioned() {
    let bench = Workbench::new();
    for level in ["--error 1", "--max-error 1", "--error 30%"] {
        let report = bench.json(&format!("simplify shape:torus small.ply {level}"));
        let warning = report["warning"].as_str().unwrap_or_default();
        assert!(warning.contains("of the diagonal") && warning.contains("of 36,864 triangles"), "{report}");
        let assert = bench.run(&format!("simplify shape:torus small.ply {level}")).success();
        assert!(String::from_utf8_lossy(&assert.get_output().stderr).contains(warning), "{level}");
    }
    for level in ["--error 1%", "--ratio 0.001"] {
        assert!(
            bench.json(&format!("simplify shape:torus small.ply {level}"))["warning"].is_null(),
            "{level}"
        );
    }
}

#[test]
fn outputs_are_checked_before_inputs_are_read() {
    let bench = Workbench::new();
    bench.write("broken.obj", "v 0 0\n");
    fs::create_dir(bench.path("folder.glb")).unwrap();
    for words in [
        "simplify broken.obj OUT --ratio 0.5",
        "convert broken.obj OUT",
        "encode broken.obj OUT",
        "strip broken.obj -o OUT",
    ] {
        let message = bench.refused(&words.replace("OUT", "no/out.glb"));
        assert!(message.contains("no/out.glb: the folder no does not exist"), "{words}: {message}");
        let message = bench.refused(&words.replace("OUT", "folder.glb"));
        assert!(message.contains("folder.glb: is a directory"), "{words}: {message}");
    }
    for words in ["build broken.obj -o no/out.striata", "render broken.obj -o no/out.png"] {
        assert!(bench.refused(words).contains("the folder no does not exist"), "{words}");
    }
    assert_eq!(bench.names(), ["broken.obj", "folder.glb"]);
}

#[test]
#[cfg(unix)]
fn folders_that_cannot_be_written_to_are_refused_before_inputs_are_read() {
    let bench = Workbench::new();
    // Nobody can create files there, not even the superuser.
    let message = bench.refused("convert no-ball.obj /proc/out.ply");
    assert!(message.contains("/proc/out.ply: cannot write to the folder"), "{message}");
}

#[test]
fn files_of_other_versions_are_not_called_damaged() {
    let bench = Workbench::new();
    bench.json("build shape:sphere -o ball.striata");
    bench.json("encode shape:sphere ball.stri");
    for (name, place) in [("ball.striata", 8), ("ball.stri", 4)] {
        for (version, maker) in [(1, "an older version"), (99, "a newer version")] {
            let mut bytes = bench.read(name);
            bytes[place] = version;
            bench.write("other", bytes);
            let message = bench.refused("info other");
            assert!(message.contains(&format!("hint: it was made by {maker} of striata")), "{message}");
        }
    }
}
