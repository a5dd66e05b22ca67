//! Outputs: the `-o` flag, default names, and flags that only apply to some outputs.

use crate::workbench::{Workbench, assert_keys, asset};

#[test]
fn the_output_of_convert_may_be_given_by_a_flag() {
    let bench = Workbench::with_ball();
    bench.run("convert sphere.obj a.ply --quiet").success();
    bench.run("convert sphere.obj -o b.ply --quiet").success();
    assert_eq!(bench.read("a.ply"), bench.read("b.ply"));
    let twice = bench.refused("convert sphere.obj a.ply -o b.ply");
    assert!(twice.contains("cannot be used with"), "{twice}");
    assert!(bench.refused("convert sphere.obj").contains("required"));
}

#[test]
fn the_default_output_is_next_to_the_input() {
    let bench = Workbench::with_ball();
    bench.run("convert sphere.obj scan.ply.gz --quiet").success();
    std::fs::create_dir(bench.path("in")).expect("the folder is ours");
    bench.run("convert sphere.obj in/scan.v2.ply --quiet").success();
    for (input, output) in [("scan.ply.gz", "scan"), ("in/scan.v2.ply", "in/scan.v2"), ("shape:cube", "cube")]
    {
        for (verb, extension) in [("build", "striata"), ("encode", "stri")] {
            let output = format!("{output}.{extension}");
            let assert = bench.run(&format!("{verb} {input}")).success();
            let message = String::from_utf8_lossy(&assert.get_output().stderr).into_owned();
            assert!(
                message.contains(&output)
                    && message.contains(
                        "use -o to choose another \
                name"
                    ),
                "{message}"
            );
            assert!(!bench.read(&output).is_empty());
            assert_eq!(bench.json(&format!("{verb} {input}"))["path"], output);
        }
    }
    for (line, what) in [
        ("build ball.striata", "the output would overwrite the input"),
        ("encode scan.stri", "the output would overwrite the input"),
        ("build -", "the input is stdin"),
    ] {
        let message = bench.refused(line);
        assert!(message.contains(what) && message.contains("hint: name the output: -o OUT."), "{message}");
    }
}

#[test]
fn strips_can_be_written_to_stdout() {
    let bench = Workbench::with_ball();
    bench.run("strip sphere.obj -o strips.glb --quiet").success();
    let assert = bench.run("strip sphere.obj -o - --quiet").success();
    assert_eq!(assert.get_output().stdout, bench.read("strips.glb"));
    let json = bench.run("strip sphere.obj -o - --to gltf --quiet").success();
    assert!(json.get_output().stdout.starts_with(b"{"));
}

#[test]
fn misses_are_reported_for_the_given_cache_size() {
    let bench = Workbench::with_ball();
    let strip = |size: u32| bench.json(&format!("strip sphere.obj --cache-size {size}"));
    let [small, usual, large] = [4, 16, 64].map(strip);
    assert_keys(&usual, &["cache_size", "acmr", "atvr", "acmr_lru", "atvr_lru", "acmr_16", "atvr_16"]);
    assert_eq!((&usual["acmr"], &usual["cache_size"]), (&usual["acmr_16"], &16.into()));
    let misses = |report: &serde_json::Value| report["acmr"].as_f64().expect("a number");
    assert!(misses(&small) > misses(&usual) && misses(&usual) > misses(&large));
    assert_eq!(small["acmr_16"], usual["acmr_16"], "the strips are the same");
    let text = bench.run("strip sphere.obj --cache-size 4").success();
    let text = String::from_utf8_lossy(&text.get_output().stdout).into_owned();
    assert!(text.contains("FIFO 4 ") && !text.contains("FIFO 16"), "{text}");
    let built = bench.json("build sphere.obj -o x.striata --cache-size 4");
    assert_eq!(built["strips"]["cache_size"], 4);
}

#[test]
fn flags_that_do_not_apply_are_refused() {
    let bench = Workbench::with_ball();
    for format in ["obj", "stl", "off"] {
        let message = bench.refused(&format!("strip sphere.obj -o x --to {format}"));
        assert!(message.contains("invalid value"), "{message}");
    }
    assert!(bench.refused("strip sphere.obj -o x.ply").contains("--block-triangles"));
    assert!(bench.refused("completions bash --json").contains("no JSON report"));
    assert!(bench.refused("convert sphere.obj x.obj --ascii").contains("--ascii is for PLY"));
    assert!(bench.refused("simplify sphere.obj -o x.ply --eye 0,0,3").contains("unexpected argument"));
    assert!(bench.refused("build sphere.obj -o x.striata.gz").contains("already compressed"));
    assert!(bench.refused("encode sphere.obj -o x.stri.zst").contains("already compressed"));
    let strips = bench.refused("build sphere.obj -o x.striata --models fans --strips greedy");
    assert!(strips.contains("--strips has no effect without a model"), "{strips}");
    assert_eq!(bench.names(), ["ball.striata", "sphere.obj"]);
    // With an explicit format, the extension still selects the compression.
    bench.run("convert sphere.obj x.gz --to ply --quiet").success();
    assert!(bench.read("x.gz").starts_with(&[0x1f, 0x8b]));
    assert_eq!(bench.json("info x.gz")["triangle_count"], 512);
}

#[test]
fn gltf_can_be_quantized_and_compressed() {
    let bench = Workbench::with_ball();
    let size = |command: &str, name: &str| {
        bench.run(&format!("{command} {name} --quiet")).success();
        assert_eq!(bench.json(&format!("info {name}"))["triangle_count"], 512, "{command}");
        bench.read(name).len()
    };
    let plain = size("convert sphere.obj", "plain.glb");
    let lossless = size("convert sphere.obj --meshopt --lossless", "lossless.glb");
    let quantized = size("convert sphere.obj --quantize", "quantized.glb");
    let meshopt = size("convert sphere.obj --meshopt", "meshopt.glb");
    let draco = size("convert sphere.obj --draco --bits 11", "draco.glb");
    assert!(lossless < plain && quantized < plain && meshopt < quantized && draco < meshopt);
    let coarse = size("convert sphere.obj --meshopt --bits 8 --normal-bits 6", "coarse.glb");
    assert!(coarse < meshopt);
    bench.run("extract ball.striata -o level.gltf --triangles 100 --draco --quiet").success();
    bench.run("simplify sphere.obj -o level.glb --triangles 100 --meshopt --quiet").success();
    for (command, reason) in [
        ("convert sphere.obj x.ply --meshopt", "--meshopt is for glTF, but x.ply is written as PLY"),
        ("extract ball.striata -o x.obj --triangles 100 --draco", "--draco is for glTF"),
        ("convert sphere.obj x.glb --meshopt --draco", "cannot be used with"),
        ("convert sphere.obj x.glb --bits 12", "required"),
        ("convert sphere.obj x.glb --lossless", "required"),
        ("convert sphere.obj x.glb --quantize --bits 17", "17 is not in 1..=16"),
        ("convert sphere.obj x.glb --quantize --lossless", "cannot be used with"),
    ] {
        let message = bench.refused(command);
        assert!(message.contains(reason), "{command}: {message}");
    }
}

#[test]
fn attribute_bits_of_streams_can_be_chosen() {
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
    assert!(bench.refused("build shape:cube -o x.striata --uv-bits 9").contains(
        "--uv-bits has no effect \
        without a stream"
    ));
}

#[test]
fn colors_mean_the_same_in_every_kind_of_file() {
    let bench = Workbench::new();
    let mut text = "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\n\
                    property float z\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n\
                    element face 6\nproperty list uchar int vertex_indices\nend_header\n"
        .to_owned();
    for corner in ["0 0 0", "1 0 0", "1 1 0", "0 1 0", "0.5 0.5 1"] {
        text += &format!("{corner} 128 64 200\n");
    }
    text += "3 0 1 4\n3 1 2 4\n3 2 3 4\n3 3 0 4\n3 0 2 1\n3 0 3 2\n";
    bench.write("srgb.ply", text);
    bench.run("convert srgb.ply linear.glb --quiet").success();
    let color = |name: &str| {
        let mesh = striata_io::read(bench.path(name)).unwrap();
        let layer = mesh.layer(&striata::mesh::Semantic::Color(0)).unwrap().clone();
        [0, 1, 2].map(|channel| (layer.get(0, channel) * 255.0).round())
    };
    let (shown, light) = ([128.0, 64.0, 200.0], [55.0, 13.0, 147.0]);
    assert_eq!((color("srgb.ply"), color("linear.glb")), (shown, light));
    for input in ["srgb.ply", "linear.glb"] {
        for (verb, name) in [
            ("build --flat", "levels.striata"),
            ("build --paged --flat", "pages.striata"),
            ("encode --flat --lossless", "stream.stri"),
            ("build", "scene.striata"),
        ] {
            bench.run(&format!("{verb} {input} -o {name} --quiet")).success();
            for (output, expected) in [("out.ply", shown), ("out.obj", shown), ("out.glb", light)] {
                bench.run(&format!("extract {name} -o {output} --ratio 1 --quiet")).success();
                assert_eq!(color(output), expected, "{input}: {verb}, {output}");
            }
        }
    }
}
