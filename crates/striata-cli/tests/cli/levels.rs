//! Requested levels: percentages of the full mesh, several in one run, and levels that cannot be reached.

use std::collections::BTreeSet;

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use serde_json::Value;
use striata::strip::fifo_cache_cost;

use crate::workbench::{Workbench, asset, sphere};

/// Returns the value of a key for each level.
fn of_levels<'a>(report: &'a Value, key: &str) -> Vec<&'a Value> {
    report["levels"].as_array().expect("a list").iter().map(|level| &level[key]).collect()
}

#[test]
fn levels_are_in_cache_order_and_converted_meshes_in_their_own() {
    let bench = Workbench::new();
    let sphere = sphere(24, 48);
    // The last triangle comes first.
    let (mut faces, others): (Vec<&str>, Vec<&str>) = sphere.lines().partition(|line| line.starts_with("f "));
    faces.reverse();
    bench.write("ball.obj", [others, faces].concat().join("\n"));
    bench.run("convert ball.obj ball.ply --quiet").success();
    bench.run("build ball.obj -o ball.striata --quiet").success();
    let read = |name: &str| striata_io::read(bench.path(name)).expect("a mesh");
    assert_eq!(read("ball.ply").triangles, read("ball.obj").triangles);
    for (number, verb) in
        ["simplify ball.obj --ratio 0.5", "extract ball.striata --ratio 0.5", "convert ball.striata"]
            .into_iter()
            .enumerate()
    {
        for extension in ["ply", "glb", "off"] {
            let name = format!("{number}.{extension}");
            bench.run(&format!("{verb} -o {name} --quiet")).success();
            let mesh = read(&name);
            let cost = fifo_cache_cost(mesh.triangles.as_flattened(), mesh.triangle_count(), 16);
            assert!(cost.acmr < 0.8, "{verb} to {extension}: {}", cost.acmr);
            let mut next = 0;
            for &v in mesh.triangles.iter().flatten() {
                assert!(v <= next, "{verb} to {extension}");
                next = next.max(v + 1);
            }
        }
    }
}

#[test]
fn counts_may_be_percentages_of_the_full_mesh() {
    let bench = Workbench::with_ball();
    for verb in ["extract ball.striata", "simplify sphere.obj"] {
        let level = |flags: &str| {
            bench.json(&format!("{verb} -o level.ply {flags}"));
            bench.read("level.ply")
        };
        // The ball has 512 triangles and 258 vertices.
        let quarter = level("--triangles 128");
        assert_eq!(level("--triangles 25%"), quarter, "{verb}");
        assert_eq!(level("--ratio 0.25"), quarter, "{verb}");
        assert_eq!(level("--vertices 25%"), level("--vertices 64"), "{verb}");
    }
    bench.json("build sphere.obj -o share.striata --base 20%");
    bench.json("build sphere.obj -o number.striata --base 102");
    assert_eq!(bench.read("share.striata"), bench.read("number.striata"));
    let [ratio, detail] = ["--ratio 0.25", "--detail 0.25"].map(|level| {
        bench.json(&format!("extract share.striata -o level.ply {level}"));
        bench.read("level.ply")
    });
    assert_ne!(ratio, detail, "detail 0 is the base mesh, and not nothing");
    let view = |flags: &str| {
        let report =
            bench.json(&format!("extract ball.striata -o view.ply --eye -0.4,0.3,-3 --pixels 0 {flags}"));
        report["triangle_count"].as_u64().expect("a count")
    };
    assert_eq!(view("--triangles 12.5%"), view("--triangles 64"));
    assert_eq!(view("--ratio 0.125"), view("--triangles 64"));
    for wrong in ["--triangles 101%", "--triangles ten", "--vertices -1%", "--ratio 1.5", "--ratio -1"] {
        assert!(bench.refused(&format!("extract ball.striata -o x.ply {wrong}")).contains("invalid value"));
    }
    assert!(bench.refused("build sphere.obj -o x.striata --base 200%").contains("the full mesh is 100%"));
    let both = bench.refused("extract ball.striata -o x.ply --triangles 5 --ratio 0.5");
    assert!(both.contains("cannot be used with"), "{both}");
}

#[test]
fn a_percentage_of_a_triangle_soup_refers_to_the_welded_mesh() {
    let bench = Workbench::with_ball();
    bench.run("convert sphere.obj soup.stl --quiet").success();
    let report = bench.json("simplify soup.stl -o level.ply --vertices 25%");
    assert!(report["vertex_count"].as_u64().is_some_and(|n| (60..=64).contains(&n)), "{report}");
}

#[test]
fn several_levels_of_a_file_equal_separate_ones() {
    let bench = Workbench::with_ball();
    for model in ["lodstrips", "mts", "fans", "patterns", "progressive"] {
        bench.run(&format!("build sphere.obj -o {model}.striata --models {model} --quiet")).success();
        let report = bench.json(&format!("extract {model}.striata -o {model}-{{}}.glb --levels 10%,50%,77"));
        assert_eq!(of_levels(&report, "level"), ["10%", "50%", "77"], "{model}");
        let paths = ["10", "50", "77"].map(|name| format!("{model}-{name}.glb"));
        assert_eq!(of_levels(&report, "path"), paths.each_ref().map(String::as_str), "{model}");
        for (i, (path, triangles)) in paths.iter().zip(["51", "50%", "77"]).enumerate() {
            let one = bench.json(&format!("extract {model}.striata -o one.glb --triangles {triangles}"));
            assert_eq!(bench.read(path), bench.read("one.glb"), "{path}");
            for key in ["triangle_count", "vertex_count", "split_count", "error", "stop_reason", "model"] {
                assert_eq!(report["levels"][i][key], one[key], "{path}: {key}");
            }
        }
    }
    let report = bench.run("extract lodstrips.striata -o x-{}.glb --levels 50%,10% --as strips").success();
    let text = String::from_utf8_lossy(&report.get_output().stderr).into_owned();
    assert!(text.contains("x-50.glb") && text.contains("x-10.glb"), "{text}");
}

#[test]
fn several_levels_of_a_mesh_come_from_one_simplification() {
    let bench = Workbench::with_ball();
    for flags in ["", "--certify", "--order hausdorff", "--placement optimal"] {
        let report = bench.json(&format!("simplify sphere.obj -o s-{{}}.ply --levels 50%,100 {flags}"));
        for (i, (path, triangles)) in [("s-50.ply", "50%"), ("s-100.ply", "100")].into_iter().enumerate() {
            let one = bench.json(&format!("simplify sphere.obj -o one.ply --triangles {triangles} {flags}"));
            let level = &report["levels"][i];
            assert_eq!((&level["path"], &level["stop_reason"]), (&path.into(), &one["stop_reason"]));
            for key in ["triangle_count", "vertex_count"] {
                assert_eq!(level[key], one[key], "{flags}: {path}: {key}");
            }
            // Guaranteed errors depend on all levels that are simplified in the run.
            if flags.is_empty() || flags == "--placement optimal" {
                let [several, alone] = [level, &one].map(|level| level["error"].as_f64().expect("an error"));
                assert!((several - alone).abs() <= 1e-6 * alone, "{flags}: {path}");
            }
            let area = |path: &str| bench.json(&format!("info {path}"))["area"].as_f64().expect("an area");
            assert!((area(path) - area("one.ply")).abs() < 1e-6, "{flags}: {path}");
        }
    }
}

#[test]
fn each_level_has_its_own_file() {
    let bench = Workbench::with_ball();
    let message = bench.refused("extract ball.striata -o out/bunny.glb --levels 50%,10%");
    assert!(message.contains("hint: ") && message.contains("-o 'out/bunny-{}.glb'"), "{message}");
    assert!(bench.refused("simplify sphere.obj -o - --levels 50%").contains("--levels needs {}"));
    let twice = bench.refused("simplify sphere.obj -o a-{}.ply --levels 50%,50");
    assert!(twice.contains("a-50.ply: several levels"), "{twice}");
    assert!(bench.refused("extract ball.striata -o a-{}.ply --levels 50%,x").contains("not a level"));
    assert!(bench.refused("extract ball.striata -o a-{}.ply --eye 0,0,3").contains("{} stands for a level"));
    assert!(bench.refused("extract ball.striata -o a-{}.docx --levels 50%").contains("--to"));
    assert!(
        bench.refused("extract ball.striata -o a-{}.ply --levels 5% --detail 1").contains("cannot be used")
    );
    assert_eq!(bench.names(), ["ball.striata", "sphere.obj"]);
    // A single level also replaces the placeholder.
    bench.json("extract ball.striata -o a-{}.ply --levels 12.5%");
    bench.json("extract ball.striata -o b-{}.ply --triangles 100");
    bench.json("simplify sphere.obj -o c-{}.ply --error 1%");
    assert_eq!(bench.names(), ["a-12.5.ply", "b-100.ply", "ball.striata", "c-1.ply", "sphere.obj"]);
}

#[test]
fn either_all_levels_are_written_or_none() {
    let bench = Workbench::with_ball();
    bench.write("a-50.ply", "precious");
    std::fs::create_dir(bench.path("a-10.ply")).expect("the folder is ours");
    let before = bench.names();
    for verb in ["extract ball.striata", "simplify sphere.obj"] {
        for levels in ["50%,25%,10%", "50%,25%,0 --strict"] {
            let message = bench.refused(&format!("{verb} -o a-{{}}.ply --levels {levels}"));
            assert!(message.starts_with("error: "), "{message}");
            assert_eq!(
                (bench.names(), bench.read("a-50.ply")),
                (before.clone(), b"precious".to_vec()),
                "{verb}"
            );
        }
    }
}

#[test]
fn a_shortfall_gives_the_reason() {
    let bench = Workbench::with_ball();
    let shortfall_of = |line: &str| {
        let report = bench.json(line);
        assert_eq!(report["stop_reason"], "base_reached", "{line}");
        let text = bench.run(line).success();
        let text = String::from_utf8_lossy(&text.get_output().stderr).into_owned();
        let shortfall = report["shortfall"].as_str().unwrap_or_else(|| panic!("{line}: {report}"));
        assert!(text.contains(shortfall), "{text}");
        shortfall.to_owned()
    };
    let message = shortfall_of("simplify sphere.obj -o x.ply --triangles 0");
    assert!(message.starts_with("requested at most 0 triangles, but "), "{message}");
    assert!(
        message.ends_with(
            "no more edges can be collapsed without removing the last \
        triangles"
        ),
        "{message}"
    );
    let message = shortfall_of("extract ball.striata -o x.ply --vertices 1");
    assert!(message.ends_with("the file has no coarser level"), "{message}");
    assert!(shortfall_of("extract ball.striata -o x.ply --eye 0,0,3 --triangles 1").contains("coarser"));
    let message = shortfall_of("build sphere.obj -o x.striata --base 1");
    assert!(message.contains("at most 1 triangle,"), "{message}");
    // The reason names locks and limits.
    bench.write("open.off", grid(12));
    let message = shortfall_of("simplify open.off -o x.ply --triangles 4 --lock-boundary");
    assert!(message.ends_with("or changing what --lock-boundary protects"), "{message}");
    let limited = bench.json("simplify sphere.obj -o x.ply --triangles 50 --max-error 1%");
    assert_eq!(limited["stop_reason"], "error_limit");
    assert!(
        limited["shortfall"].as_str().is_some_and(|s| s.ends_with("exceed the error limit")),
        "{limited}"
    );
    // A level that meets its target has no shortfall.
    for line in [
        "extract ball.striata -o x.ply --triangles 10000",
        "extract ball.striata -o x.ply --error 50%",
        "simplify sphere.obj -o x.ply --triangles 100 --strict",
        "build sphere.obj -o x.striata --base 100 --strict",
        "build sphere.obj -o x.striata",
    ] {
        assert!(bench.json(line)["shortfall"].is_null(), "{line}");
    }
}

#[test]
fn strict_writes_nothing_if_a_level_is_not_reached() {
    let bench = Workbench::with_ball();
    bench.run("encode sphere.obj -o ball.stri --quiet").success();
    let stream = bench.read("ball.stri");
    bench.write("cut.stri", &stream[..stream.len() * 2 / 3]);
    let before = bench.names();
    for line in [
        "extract ball.striata -o x.ply --triangles 0",
        "extract ball.striata -o x.ply --split-count 100000",
        "extract ball.striata -o x.ply --eye 0,0,3 --triangles 0",
        "extract ball.striata -o - --triangles 0",
        "extract cut.stri -o x.ply --triangles 500",
        "simplify sphere.obj -o x.ply --vertices 1",
        "simplify sphere.obj -o x.ply --triangles 0 --placement optimal",
        "simplify sphere.obj -o x.ply --triangles 50 --max-error 1%",
        "simplify sphere.obj -o x-{}.ply --levels 50%,0",
        "build sphere.obj -o x.striata --base 0",
        "render sphere.obj -o x.png --triangles 0 --software",
        "render ball.striata -o x.png --levels 50%,0 --software",
    ] {
        let message = bench.refused(&format!("{line} --strict"));
        assert!(
            message.contains("was not reached") && message.contains("hint: remove --strict"),
            "{line}: {message}"
        );
        assert_eq!(bench.names(), before, "{line}");
    }
}

#[test]
fn render_accepts_the_same_levels() {
    let bench = Workbench::with_ball();
    let count = |flags: &str| {
        let report = bench.json(&format!("render sphere.obj -o x.png --size 64x48 --software {flags}"));
        report["triangle_count"].as_u64().expect("a count")
    };
    assert_eq!(count("--triangles 25%"), count("--triangles 128"));
    assert_eq!(count("--ratio 0.25"), count("--triangles 128"));
    assert_eq!(count("--vertices 25%"), count("--vertices 64"));
    let few = bench.json("render ball.striata -o x.png --size 64x48 --software --levels 50%,0");
    assert!(of_levels(&few, "shortfall")[0].is_null() && few["levels"][1]["shortfall"].is_string(), "{few}");
}

#[test]
fn lock_groups_keeps_borders_between_groups() {
    let bench = Workbench::new();
    // A ball of two halves that meet at x = 0: at both poles and sixteen vertices on either side.
    let ball = sphere(16, 16);
    let (vertices, faces) = ball.split_at(ball.find("f ").expect("faces"));
    let faces: Vec<&str> = faces.lines().collect();
    let (left, right) = faces.split_at(faces.len() / 2);
    let halves = format!("{vertices}usemtl left\n{}\nusemtl right\n{}\n", left.join("\n"), right.join("\n"));
    bench.write("ball.obj", halves);
    let on_border = |line: &str| {
        bench.run(&format!("{line} -o level.obj --quiet")).success();
        let text = String::from_utf8(bench.read("level.obj")).expect("text");
        let is_on_it = |line: &&str| {
            let x = line.split(' ').next().map(str::parse::<f64>);
            x.is_some_and(|x| x.is_ok_and(|x| x.abs() < 1e-5))
        };
        let places: BTreeSet<&str> =
            text.lines().filter_map(|l| l.strip_prefix("v ")).filter(is_on_it).collect();
        places.len()
    };
    let level = |flags: &str| on_border(&format!("simplify ball.obj --triangles 20% {flags}"));
    assert_eq!(on_border("convert ball.obj"), 34);
    assert!(level("") < 20, "{} of them are left", level(""));
    for flags in ["", "--placement optimal", "--order hausdorff"] {
        assert_eq!(level(&format!("--lock-groups {flags}")), 34, "{flags}");
    }
    let remark = bench.run("simplify shape:cube -o x.ply --triangles 4 --lock-groups").success();
    assert!(String::from_utf8_lossy(&remark.get_output().stderr).contains("only one group"));
}

#[test]
fn attribute_weights_change_levels() {
    let bench = Workbench::new();
    let spot = asset("spot.obj.zst");
    let level = |flags: &str| {
        let line = format!("simplify -o level.ply --triangles 500 --json {flags}");
        bench.command(&line).arg(&spot).assert().success();
        bench.read("level.ply")
    };
    let usual = level("");
    assert_eq!(level("--uv-weight 0.02"), usual, "the default");
    assert_ne!(level("--uv-weight 1"), usual);
    assert_eq!(level("--color-weight 5"), usual, "there are no colors");
    for (flag, wrong) in [("--uv-weight", "-1"), ("--normal-weight", "nan"), ("--color-weight", "inf")] {
        let message = bench.refused(&format!("simplify x.ply -o y.ply --triangles 5 {flag} {wrong}"));
        assert!(message.contains("must lie between 0"), "{message}");
    }
    let order = bench.refused("simplify shape:cube -o y.ply --triangles 5 --order hausdorff --uv-weight 1");
    assert!(order.contains("--uv-weight has no meaning in hausdorff order"), "{order}");
}

#[test]
fn textures_change_levels() {
    let bench = Workbench::new();
    let mut png = Vec::new();
    let mut encoder = png::Encoder::new(&mut png, 16, 16);
    encoder.set_color(png::ColorType::Grayscale);
    let mut writer = encoder.write_header().expect("writing to memory succeeds");
    writer.write_image_data(&[120; 256]).expect("writing to memory succeeds");
    writer.finish().expect("writing to memory succeeds");
    bench.write("gray.gltf", textured_hill(Some(&png)));
    bench.write("broken.gltf", textured_hill(Some(&png[..50])));
    bench.write("plain.gltf", textured_hill(None));
    let level = |line: &str| {
        bench.run(&format!("{line} -o level.ply --triangles 60 --quiet")).success();
        // The header names the image.
        let bytes = bench.read("level.ply");
        let body = bytes.windows(10).position(|window| window == b"end_header").expect("a PLY file");
        bytes[body..].to_vec()
    };
    for flags in ["", "--flat"] {
        let usual = level(&format!("simplify plain.gltf {flags}"));
        assert!(level(&format!("simplify gray.gltf {flags}")) != usual, "sliding is not seen");
        assert!(level(&format!("simplify broken.gltf {flags}")) == usual, "the image cannot be decoded");
        let ignored = |input: &str| level(&format!("simplify {input} --uv-weight 0 {flags}"));
        assert!(ignored("gray.gltf") == ignored("plain.gltf"));
    }
    for input in ["gray", "plain"] {
        bench.run(&format!("build {input}.gltf -o {input}.striata --quiet")).success();
    }
    assert!(level("extract gray.striata") != level("extract plain.striata"));
}

/// Returns a bumpy square with distorted texture coordinates as glTF, with an embedded base color texture.
fn textured_hill(png: Option<&[u8]>) -> String {
    const SIDE: u16 = 16;
    let n = SIDE + 1;
    let places = || (0..n * n).map(|i| [i % n, i / n].map(|step| f32::from(step) / f32::from(SIDE)));
    let positions = places().flat_map(|[x, y]| [x, y, 0.1 * (5.0 * x).sin() * (4.0 * y).cos()]);
    let uvs = places().flat_map(|[x, y]| [x + 0.2 * (6.0 * y).sin(), y * y]);
    let mut bytes: Vec<u8> = positions.chain(uvs).flat_map(f32::to_le_bytes).collect();
    let vertex_count = usize::from(n * n);
    for i in (0..SIDE * SIDE).map(|i| i / SIDE * n + i % SIDE) {
        for corner in [i, i + 1, i + n + 1, i, i + n + 1, i + n] {
            bytes.extend(corner.to_le_bytes());
        }
    }
    let index_count = 6 * usize::from(SIDE * SIDE);
    let uri = |kind: &str, bytes: &[u8]| format!("data:{kind};base64,{}", STANDARD.encode(bytes));
    let mut gltf = serde_json::json!({
        "asset": { "version": "2.0" },
        "meshes": [{ "primitives": [
            { "attributes": { "POSITION": 0, "TEXCOORD_0": 1 }, "indices": 2, "material": 0 }
        ] }],
        "nodes": [{ "mesh": 0 }],
        "scenes": [{ "nodes": [0] }],
        "scene": 0,
        "materials": [{}],
        "accessors": [
            { "bufferView": 0, "componentType": 5126, "count": vertex_count, "type": "VEC3",
              "min": [0, 0, -1], "max": [1, 1, 1] },
            { "bufferView": 1, "componentType": 5126, "count": vertex_count, "type": "VEC2" },
            { "bufferView": 2, "componentType": 5123, "count": index_count, "type": "SCALAR" },
        ],
        "bufferViews": [
            { "buffer": 0, "byteOffset": 0, "byteLength": 12 * vertex_count },
            { "buffer": 0, "byteOffset": 12 * vertex_count, "byteLength": 8 * vertex_count },
            { "buffer": 0, "byteOffset": 20 * vertex_count, "byteLength": 2 * index_count },
        ],
        "buffers": [{ "byteLength": bytes.len(), "uri": uri("application/octet-stream", &bytes) }],
    });
    if let Some(png) = png {
        gltf["materials"] =
            serde_json::json!([{ "pbrMetallicRoughness": { "baseColorTexture": { "index": 0 } } }]);
        gltf["textures"] = serde_json::json!([{ "source": 0 }]);
        gltf["images"] = serde_json::json!([{ "uri": uri("image/png", png) }]);
    }
    gltf.to_string()
}

/// Returns a flat square of `side` by `side` quads as OFF.
fn grid(side: usize) -> String {
    let n = side + 1;
    let mut text = format!("OFF\n{} {} 0\n", n * n, 2 * side * side);
    for i in 0..n * n {
        text.push_str(&format!("{} {} 0\n", i % n, i / n));
    }
    for i in (0..side * side).map(|i| i / side * n + i % side) {
        text.push_str(&format!("3 {i} {} {}\n3 {i} {} {}\n", i + 1, i + n + 1, i + n + 1, i + n));
    }
    text
}
