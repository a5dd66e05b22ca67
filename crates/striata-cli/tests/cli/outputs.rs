//! Outputs: `-o` wherever something is written, names that are chosen, and flags that only fit some of them.

use crate::workbench::{Workbench, assert_keys, asset};

#[test]
fn every_output_may_be_named_by_a_flag() {
    let bench = Workbench::with_ball();
    bench.run("convert sphere.obj a.ply --quiet").success();
    bench.run("convert sphere.obj -o b.ply --quiet").success();
    assert_eq!(bench.read("a.ply"), bench.read("b.ply"));
    let twice = bench.refused("convert sphere.obj a.ply -o b.ply");
    assert!(twice.contains("cannot be used with"), "{twice}");
    assert!(bench.refused("convert sphere.obj").contains("required"));
}

#[test]
fn an_output_lies_next_to_the_input_unless_it_is_named() {
    let bench = Workbench::with_ball();
    bench.run("convert sphere.obj scan.ply.gz --quiet").success();
    std::fs::create_dir(bench.path("in")).expect("the folder is ours");
    bench.run("convert sphere.obj in/scan.v2.ply --quiet").success();
    for (input, output) in [("scan.ply.gz", "scan"), ("in/scan.v2.ply", "in/scan.v2"), ("shape:cube", "cube")]
    {
        for (verb, extension) in [("build", "striata"), ("encode", "stri")] {
            let output = format!("{output}.{extension}");
            let assert = bench.run(&format!("{verb} {input}")).success();
            let said = String::from_utf8_lossy(&assert.get_output().stderr).into_owned();
            assert!(said.contains(&output) && said.contains("-o names another"), "{said}");
            assert!(!bench.read(&output).is_empty());
            assert_eq!(bench.json(&format!("{verb} {input}"))["path"], output);
        }
    }
    for (line, what) in [
        ("build ball.striata", "the output would take the place of the input"),
        ("encode scan.stri", "the output would take the place of the input"),
        ("build -", "stdin has no name"),
    ] {
        let said = bench.refused(line);
        assert!(said.contains(what) && said.contains("hint: name the output: -o OUT."), "{said}");
    }
}

#[test]
fn strips_go_to_stdout() {
    let bench = Workbench::with_ball();
    bench.run("strip sphere.obj -o strips.glb --quiet").success();
    let assert = bench.run("strip sphere.obj -o - --quiet").success();
    assert_eq!(assert.get_output().stdout, bench.read("strips.glb"));
    let json = bench.run("strip sphere.obj -o - --to gltf --quiet").success();
    assert!(json.get_output().stdout.starts_with(b"{"));
}

#[test]
fn figures_are_those_of_the_cache_that_is_named() {
    let bench = Workbench::with_ball();
    let strip = |size: u32| bench.json(&format!("strip sphere.obj --cache-size {size}"));
    let [small, usual, large] = [4, 16, 64].map(strip);
    assert_keys(&usual, &["cache_size", "acmr", "atvr", "acmr_lru", "atvr_lru", "acmr_16", "atvr_16"]);
    assert_eq!((&usual["acmr"], &usual["cache_size"]), (&usual["acmr_16"], &16.into()));
    let misses = |report: &serde_json::Value| report["acmr"].as_f64().expect("a number");
    assert!(misses(&small) > misses(&usual) && misses(&usual) > misses(&large));
    assert_eq!(small["acmr_16"], usual["acmr_16"], "the same strips");
    let text = bench.run("strip sphere.obj --cache-size 4").success();
    let text = String::from_utf8_lossy(&text.get_output().stdout).into_owned();
    assert!(text.contains("FIFO 4 ") && !text.contains("FIFO 16"), "{text}");
    let built = bench.json("build sphere.obj -o x.striata --cache-size 4");
    assert_eq!(built["strips"]["cache_size"], 4);
}

#[test]
fn formats_and_flags_that_do_not_fit_are_refused() {
    let bench = Workbench::with_ball();
    for format in ["obj", "stl", "off"] {
        let said = bench.refused(&format!("strip sphere.obj -o x --to {format}"));
        assert!(said.contains("invalid value"), "{said}");
    }
    assert!(bench.refused("strip sphere.obj -o x.ply").contains("--block-triangles"));
    assert!(bench.refused("completions bash --json").contains("nothing to report"));
    assert!(bench.refused("convert sphere.obj x.obj --ascii").contains("--ascii is for PLY"));
    assert!(bench.refused("simplify sphere.obj -o x.ply --eye 0,0,3").contains("unexpected argument"));
    assert!(bench.refused("build sphere.obj -o x.striata.gz").contains("not compressed any further"));
    assert!(bench.refused("encode sphere.obj -o x.stri.zst").contains("not compressed any further"));
    let strips = bench.refused("build sphere.obj -o x.striata --models fans --strips greedy");
    assert!(strips.contains("--strips is for strips"), "{strips}");
    assert_eq!(bench.names(), ["ball.striata", "sphere.obj"]);
    // A format that is named is compressed as the extension says.
    bench.run("convert sphere.obj x.gz --to ply --quiet").success();
    assert!(bench.read("x.gz").starts_with(&[0x1f, 0x8b]));
    assert_eq!(bench.json("info x.gz")["triangle_count"], 512);
}

#[test]
fn layers_of_streams_have_as_many_bits_as_asked() {
    let bench = Workbench::new();
    let spot = asset("spot.obj.zst");
    let attribute_bits = |flags: &str| {
        let assert = bench.command(&format!("encode -o x.stri --json {flags}")).arg(&spot).assert().success();
        let report: serde_json::Value =
            serde_json::from_slice(&assert.get_output().stdout).expect("one JSON object");
        report["attribute_bits_per_vertex"].as_f64().expect("a number")
    };
    let [few, usual, many] = ["--uv-bits 6", "", "--uv-bits 16"].map(attribute_bits);
    assert!(few < usual && usual < many, "{few}, {usual}, {many}");
    assert_eq!(attribute_bits("--uv-bits 12 --normal-bits 10 --color-bits 8"), usual, "the defaults");
    let normals = |bits: u32| {
        let line = format!("build shape:cylinder -o x.striata --models progressive --normal-bits {bits}");
        bench.json(&line)["output_bytes"].as_u64().expect("a size")
    };
    assert!(normals(6) < normals(14));
    for wrong in ["--normal-bits 1", "--normal-bits 17", "--uv-bits 0", "--color-bits 25", "--uv-bits x"] {
        assert!(bench.refused(&format!("encode shape:cube -o x.stri {wrong}")).contains("invalid value"));
    }
    assert!(
        bench.refused("encode shape:cube -o x.stri --uv-bits 9 --lossless").contains("cannot be used with")
    );
    assert!(bench.refused("build shape:cube -o x.striata --uv-bits 9").contains("--uv-bits is for streams"));
}
