//! Bad input: clear errors with file, position and reason; no partially written output.

use crate::workbench::{Workbench, sphere};

#[test]
fn a_missing_file_is_named() {
    let bench = Workbench::new();
    let message = bench.refused("info nowhere.ply");
    assert!(message.starts_with("error: nowhere.ply: ") && message.contains("hint:"), "{message}");
    assert!(bench.refused("build nowhere.ply -o out.striata").contains("nowhere.ply"));
    assert_eq!(bench.names(), Vec::<String>::new());
}

#[test]
fn a_folder_is_not_a_mesh() {
    let bench = Workbench::new();
    assert!(bench.refused("info .").contains("hint:"));
}

#[test]
fn text_with_extension_ply_is_refused() {
    let bench = Workbench::new();
    bench.write("notes.ply", "Dear diary, today I looked at meshes.\n");
    let message = bench.refused("convert notes.ply out.obj");
    assert!(message.contains("notes.ply") && message.contains("line 1"), "{message}");
    assert_eq!(bench.names(), ["notes.ply"]);
}

#[test]
fn an_unknown_format_is_refused() {
    let bench = Workbench::new();
    bench.write("picture.png", b"\x89PNG\r\n\x1a\n0000");
    bench.write("empty", b"");
    assert!(bench.refused("info picture.png").contains("picture.png"));
    assert!(bench.refused("info empty").contains("empty"));
}

#[test]
fn a_file_without_triangles_says_what_could_not_be_read() {
    let bench = Workbench::new();
    bench.write("bad.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 x\n");
    let message = bench.refused("info bad.obj");
    assert!(
        message.contains("3 points (1 polygon left out, line 4: ") && message.contains("no triangles"),
        "{message}"
    );
}

#[test]
fn the_offending_line_is_shown() {
    let bench = Workbench::new();
    bench.write("bad.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n");
    let message = bench.refused("info bad.obj");
    assert!(message.contains("line 4") && message.contains("4 | f 1 2 9"), "{message}");
}

#[test]
fn an_index_out_of_range_is_named() {
    let bench = Workbench::new();
    bench.write("bad.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n");
    let message = bench.refused("build bad.off -o out.striata");
    assert!(message.contains("bad.off") && message.contains('7'), "{message}");
    bench.write("bad.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n");
    assert!(bench.refused("info bad.obj").contains('9'));
}

#[test]
fn a_file_of_which_nothing_is_left_is_refused() {
    let bench = Workbench::new();
    bench.write("nan.off", "OFF\n4 2 0\n0 0 0\n1 0 0\n0 nan 0\n1 1 0\n3 0 1 2\n3 1 3 2\n");
    for arguments in
        ["build nan.off -o out.striata", "simplify nan.off -o out.ply --triangles 1", "info nan.off"]
    {
        let message = bench.refused(arguments);
        assert!(
            message.starts_with("error: nan.off: ")
                && message.contains(
                    "vertex \
                2"
                )
                && message.contains("NaN"),
            "{message}"
        );
    }
    assert_eq!(bench.names(), ["nan.off"]);
    bench.write("half.off", "OFF\n4 2 0\n0 0 0\n1 0 0\n0 nan 0\n1 1 0\n3 0 1 2\n3 0 1 3\n");
    let info = bench.json("info half.off");
    assert_eq!(info["triangle_count"], 1);
    assert!(info["warnings"].to_string().contains("1 triangle left out"), "{info}");
    assert!(info["warnings"].to_string().contains("NaN"), "{info}");
}

#[test]
fn empty_and_tiny_meshes_are_accepted() {
    let bench = Workbench::new();
    bench.write("none.off", "OFF\n0 0 0\n");
    bench.write("one.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    for name in ["none", "one"] {
        bench.run(&format!("info {name}.off")).success();
        let built = bench.json(&format!("build {name}.off -o {name}.striata"));
        let full = bench.json(&format!("extract {name}.striata -o {name}.ply --detail 1"));
        assert_eq!(full["triangle_count"], built["input"]["triangle_count"], "{name}");
    }
    let message = bench.refused("distance none.off one.off");
    assert!(message.starts_with("error: none.off: ") && message.contains("hint:"), "{message}");
    let message = bench.refused("distance one.off none.off");
    assert!(message.starts_with("error: none.off: "), "{message}");
}

#[test]
fn a_missing_output_folder_is_reported() {
    let bench = Workbench::with_ball();
    let message = bench.refused("extract ball.striata -o no/out.ply --detail 1");
    assert!(
        message.contains("no/out.ply") && message.contains("hint:") && !message.contains(".part"),
        "{message}"
    );
}

#[test]
fn a_negative_target_is_an_invalid_value_and_not_a_flag() {
    let bench = Workbench::with_ball();
    for target in ["--triangles -5", "--detail -0.5", "--error -1"] {
        let message = bench.refused(&format!("extract ball.striata -o out.ply {target}"));
        assert!(message.contains("invalid value"), "{message}");
    }
}

#[test]
fn a_truncated_container_is_refused_at_every_length() {
    let bench = Workbench::with_ball();
    let whole = bench.read("ball.striata");
    for length in [0, 1, 7, 8, 9, 40, 100, 500, whole.len() / 2, whole.len() - 1] {
        bench.write("half.striata", &whole[..length]);
        for arguments in ["info half.striata", "extract half.striata -o out.ply --detail 0.5"] {
            let message = bench.refused(arguments);
            assert!(message.contains("half.striata"), "{length} bytes: {message}");
        }
    }
    assert!(!bench.names().contains(&"out.ply".to_owned()));
}

#[test]
fn a_truncated_mesh_is_refused() {
    let bench = Workbench::with_ball();
    bench.run("convert sphere.obj sphere.ply --quiet").success();
    let whole = bench.read("sphere.ply");
    bench.write("half.ply", &whole[..whole.len() / 2]);
    let message = bench.refused("info half.ply");
    assert!(message.contains("half.ply") && message.contains("hint:"), "{message}");
}

#[test]
fn a_failure_leaves_an_existing_output_unchanged() {
    let bench = Workbench::new();
    bench.write("out.striata", "precious");
    bench.write("bad.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n");
    bench.refused("build bad.off -o out.striata");
    assert_eq!(bench.read("out.striata"), b"precious");
    assert_eq!(bench.names(), ["bad.off", "out.striata"]);
    bench.write("sphere.obj", sphere(4, 4));
    let message = bench.refused("build sphere.obj -o no/such/folder/out.striata");
    assert!(message.contains("no/such/folder"), "{message}");
}

#[test]
fn errors_about_unknown_names_list_the_known_ones() {
    let bench = Workbench::with_ball();
    assert!(
        bench
            .refused("build sphere.obj -o x.striata --models lodstrips,pm")
            .contains("hint: this version has: lodstrips, mts, fans, patterns")
    );
    let order = bench.refused("build sphere.obj -o x.striata --order random");
    assert!(order.contains("random") && order.contains("quadric, hausdorff"), "{order}");
    assert!(bench.refused("extract ball.striata -o x.ply --detail 1 --model pm").contains("lodstrips"));
    for model in ["mts", "fans"] {
        let absent = bench.refused(&format!("extract ball.striata -o x.ply --detail 1 --model {model}"));
        assert!(absent.contains(&format!("ball.striata: this file has no model {model}")), "{absent}");
        assert!(absent.contains(&format!("hint: build the file again with --models {model}")), "{absent}");
    }
}

#[test]
fn the_wrong_kind_of_file_is_explained() {
    let bench = Workbench::with_ball();
    assert!(bench.refused("extract sphere.obj -o x.ply --detail 1").contains("striata build"));
    assert!(bench.refused("build sphere.obj -o x.stl").contains("striata simplify"));
    assert!(bench.refused("convert sphere.obj x.striata").contains("striata build"));
    assert!(bench.refused("convert sphere.obj x.docx").contains("--to"));
    assert!(bench.refused("extract ball.striata -o x.ply --detail 1 --as strips").contains("strips"));
    assert!(bench.refused("extract ball.striata -o x.ply --detail 1 --as fans").contains(
        "PLY files cannot \
        contain fans"
    ));
    assert_eq!(bench.names(), ["ball.striata", "sphere.obj"]);
}

#[test]
fn stdout_cannot_take_both_json_and_output() {
    let bench = Workbench::with_ball();
    let message = bench.refused("extract ball.striata -o - --detail 1 --json");
    assert!(message.starts_with("error: --json and the output cannot both go to stdout"), "{message}");
}

#[test]
fn arguments_are_checked_with_suggestions() {
    let bench = Workbench::with_ball();
    assert!(bench.refused("extract ball.striata -o x.ply --triangels 10").contains("--triangles"));
    assert!(bench.refused("simplfy sphere.obj").contains("simplify"));
    let none = bench.refused("extract ball.striata -o x.ply");
    assert!(none.contains("--triangles") && none.contains("--detail"), "{none}");
    let targets = ["--triangles 10", "--vertices 10", "--detail 0.5", "--error 1", "--split-count 10"];
    for (i, first) in targets.iter().enumerate() {
        let with = |other: &str| bench.refused(&format!("extract ball.striata -o x.ply {first} {other}"));
        for other in &targets[i + 1..] {
            assert!(with(other).contains("cannot be used with"), "{first} {other}");
        }
        if i > 0 {
            assert!(with("--eye 0,0,3").contains("cannot be used with"), "{first}");
        }
    }
    assert!(bench.refused("extract ball.striata -o x.ply --detail 1.5").contains("between 0"));
    assert!(bench.refused("simplify sphere.obj -o x.ply --error 1m").contains("not a length"));
}
