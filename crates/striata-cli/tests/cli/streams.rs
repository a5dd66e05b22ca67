//! Streams: encoded and decoded by every verb, cut off, damaged, and through pipes.

use serde_json::Value;

use crate::workbench::{Workbench, assert_keys, asset, sphere};

/// Creates a folder with `sphere.obj`, a ball of 2,240 triangles, and its stream `ball.stri`.
fn with_stream() -> Workbench {
    let bench = Workbench::new();
    bench.write("sphere.obj", sphere(35, 32));
    bench.run("encode sphere.obj -o ball.stri --quiet").success();
    bench
}

fn number(report: &Value, key: &str) -> f64 {
    report[key].as_f64().unwrap_or_else(|| panic!("no number {key} in {report}"))
}

fn distance(bench: &Workbench, a: &str, b: &str) -> f64 {
    number(&bench.json(&format!("distance {a} {b} --samples 20000")), "max")
}

#[test]
fn encode_and_decode_report_their_results() {
    let bench = with_stream();
    let report = bench.json("encode sphere.obj -o ball.stri");
    assert_keys(
        &report,
        &[
            "vertex_count",
            "triangle_count",
            "position_count",
            "step_count",
            "batch_count",
            "base.triangle_count",
            "error_max",
            "effort",
            "stream.grid_bits",
            "stream.grid_step",
            "stream.chunk_count",
            "stream.base_bytes",
            "bits_per_vertex",
            "connectivity_bits_per_vertex",
            "position_bits_per_vertex",
            "attribute_bits_per_vertex",
            "other_bits_per_vertex",
            "output_bytes",
            "phases.simplify",
            "phases.encode",
            "secs",
        ],
    );
    let bytes = bench.read("ball.stri").len();
    let vertex_count = number(&report, "vertex_count");
    assert_eq!(report["output_bytes"], bytes);
    assert_eq!(report["effort"], "fast");
    assert_eq!(report["stream"]["grid_bits"], 14);
    let bits = number(&report, "bits_per_vertex");
    assert!((bits - 8.0 * bytes as f64 / vertex_count).abs() < 1e-9, "{report}");
    let parts = ["connectivity", "position", "attribute", "other"];
    let sum: f64 = parts.iter().map(|part| number(&report, &format!("{part}_bits_per_vertex"))).sum();
    assert!((sum - bits).abs() < 1e-6, "{report}");
    let decoded = bench.json("decode ball.stri -o back.ply");
    assert_keys(
        &decoded,
        &["split_count", "error", "secs", "decode_secs", "triangles_per_sec", "stream_bytes"],
    );
    assert_eq!(decoded["vertex_count"], report["vertex_count"]);
    assert_eq!(decoded["triangle_count"], 2240);
    assert_eq!(decoded["step_count"], report["step_count"]);
    assert_eq!(decoded["split_count"], report["step_count"]);
    assert_eq!(decoded["is_complete"], true);
    assert_eq!(decoded["read_bytes"], bytes);
    assert_eq!(decoded["error"], 0.0);
    // The grid step is 2 / 16383.
    assert!(distance(&bench, "sphere.obj", "back.ply") < 3e-4);
}

#[test]
fn streams_of_any_removal_are_read_by_every_verb() {
    let bench = with_stream();
    for flags in ["--order hausdorff", "--order hausdorff-strict", "--new-vertices edge"] {
        let report = bench.json(&format!("encode sphere.obj -o any.stri --lossless {flags}"));
        assert!(report["batch_count"].is_null(), "{report}");
        assert!((4.0..44.0).contains(&number(&report, "connectivity_bits_per_vertex")), "{flags}: {report}");
        let whole = bench.json("decode any.stri -o whole.ply");
        assert_eq!(whole["triangle_count"], 2240, "{flags}");
        assert!(distance(&bench, "sphere.obj", "whole.ply") < 1e-12, "{flags}");
        let level = bench.json("decode any.stri -o level.ply --triangles 400");
        assert!((380.0..=400.0).contains(&number(&level, "triangle_count")), "{flags}: {level}");
        let measured = distance(&bench, "sphere.obj", "level.ply");
        assert!(measured <= 1.02 * number(&level, "error"), "{flags}: {measured}, {level}");
        assert!(number(&level, "read_bytes") < number(&whole, "read_bytes"));
        let several = bench.json("extract any.stri --levels 100%,25% -o level-{}.ply");
        assert_eq!(several["levels"].as_array().map(Vec::len), Some(2), "{several}");
        let view = bench.json("extract any.stri --eye 0,0,3 --pixels 2 -o view.ply");
        assert!(number(&view, "triangle_count") < 2240.0, "{flags}: {view}");
        let facts = bench.json("info any.stri");
        assert_eq!(facts["stream"]["has_collapses"], false, "{facts}");
        bench.run(&format!("encode sphere.obj -o any.striata {flags} --quiet")).success();
        assert_eq!(bench.json("decode any.striata -o file.ply")["triangle_count"], 2240, "{flags}");
    }
    let refused = bench.refused("encode sphere.obj -o any.glb --order hausdorff");
    assert!(refused.contains("--order hausdorff is for one mesh"), "{refused}");
}

#[test]
fn flags_control_precision_and_size() {
    let bench = with_stream();
    let encode = |flags: &str| {
        let report = bench.json(&format!("encode sphere.obj -o x.stri {flags}"));
        let decoded = bench.json("decode x.stri -o x.ply");
        assert_eq!(decoded["triangle_count"], 2240, "{flags}");
        (report, distance(&bench, "sphere.obj", "x.ply"))
    };
    let (rough, far) = encode("--bits 8");
    let (fine, near) = encode("--bits 18");
    assert!(number(&rough, "output_bytes") < number(&fine, "output_bytes"));
    assert!(far > 10.0 * near && far < 0.02, "{far} {near}");
    let (_, off) = encode("--tolerance 0.01");
    assert!(off <= 0.01, "{off}");
    let (_, off) = encode("--tolerance 0.1%");
    assert!(off <= 0.001 * 12f64.sqrt(), "{off}");
    let (exact, off) = encode("--lossless");
    assert_eq!(exact["stream"]["is_lossless"], true);
    assert!(off < 1e-12, "{off}");
    for effort in ["fast", "compact"] {
        assert_eq!(encode(&format!("--effort {effort}")).0["effort"], effort);
    }
    let [few, many] = ["0.1", "1"].map(|share| {
        encode(&format!(
            "--batch-share \
        {share}"
        ))
        .0["batch_count"]
            .clone()
    });
    assert!(many.as_u64() < few.as_u64(), "{many} {few}");
}

#[test]
fn every_verb_reads_streams() {
    let bench = with_stream();
    bench.run("encode sphere.obj -o ball.striata --quiet").success();
    for file in ["ball.stri", "ball.striata"] {
        let info = bench.json(&format!("info {file}"));
        assert_eq!(info["triangle_count"], 2240);
        assert_eq!(info["is_closed"], true);
        assert_keys(
            &info,
            &["step_count", "base.triangle_count", "models.progressive.bytes", "stream.effort"],
        );
        assert_eq!(info["stream"]["is_complete"], true);
        assert_eq!(info["stream"]["split_count"], info["step_count"]);
        bench.run(&format!("convert {file} x.glb")).success();
        assert_eq!(bench.json(&format!("simplify {file} -o y.ply --triangles 500"))["triangle_count"], 500);
        assert_eq!(bench.json(&format!("strip {file}"))["triangle_count"], 2240);
        assert_eq!(bench.json(&format!("build {file} -o z.striata"))["input"]["triangle_count"], 2240);
        assert!(distance(&bench, file, "sphere.obj") < 3e-4);
        let seen = bench.json(&format!("extract {file} -o seen.ply --eye 0,0,4 --pixels 4"));
        assert!(number(&seen, "triangle_count") < 2240.0);
        bench.run(&format!("encode {file} -o again.stri")).success();
    }
    assert_eq!(bench.json("info ball.stri")["kind"], "stri");
    let text = bench.run("info ball.stri").success();
    let text = String::from_utf8_lossy(&text.get_output().stdout).into_owned();
    assert!(text.contains("fast effort, 14 bits") && text.contains("stream read"), "{text}");
    // The container has only the stream, and no mesh.
    let sections = bench.json("info ball.striata")["sections"].to_string();
    assert!(sections.contains("STRM") && !sections.contains("POSN"), "{sections}");
    bench.run("build sphere.obj -o alone.striata --stream").success();
    assert!(bench.json("info alone.striata")["sections"].as_array().is_some_and(|s| s.len() == 3));
}

#[test]
fn models_stored_with_a_stream_have_the_same_levels() {
    let bench = Workbench::new();
    bench.write("sphere.obj", sphere(35, 32));
    let report = bench.json("build sphere.obj -o all.striata --models lodstrips,fans,progressive --bits 16");
    assert_keys(
        &report,
        &["models.progressive.bytes_per_vertex", "models.lodstrips.bytes", "stream.chunk_count"],
    );
    let step_count = report["step_count"].as_u64().expect("a number");
    for at in [0, step_count / 7, step_count / 2, step_count] {
        let extract = |model: &str| {
            let to = format!("{model}.ply");
            let line = format!("extract all.striata -o {to} --split-count {at} --model {model}");
            let report = bench.json(&line);
            assert_eq!(report["model"], model);
            report
        };
        let [strips, fans, stream] = ["lodstrips", "fans", "progressive"].map(extract);
        for key in ["triangle_count", "vertex_count", "split_count"] {
            assert_eq!(strips[key], stream[key], "{key} at {at}");
            assert_eq!(strips[key], fans[key], "{key} at {at}");
        }
        assert!(distance(&bench, "lodstrips.ply", "progressive.ply") < 1e-4);
    }
    // The mesh stored with a stream is exact.
    assert!(distance(&bench, "sphere.obj", "all.striata") < 1e-12);
    // Other models still work if the stream is damaged or cut off.
    let mut bytes = bench.read("all.striata");
    let whole = bytes.clone();
    let at = bytes.len() - 50;
    bytes[at] ^= 1;
    bench.write("hurt.striata", &bytes);
    bench.run("extract hurt.striata -o x.ply --detail 0.5").success();
    assert!(
        bench.refused("extract hurt.striata -o x.ply --detail 0.5 --model progressive").contains("damaged")
    );
    bench.write("cut.striata", &whole[..whole.len() - 50]);
    bench
        .run("extract cut.striata -o x.ply --detail 1")
        .success()
        .stderr(predicates::str::contains("cut off"));
    let report = bench.json("extract cut.striata -o x.ply --detail 1 --model progressive");
    assert_eq!(report["is_complete"], false);
    assert_eq!(report["stop_reason"], "input_ended");
    let info = bench.json("info cut.striata");
    assert_eq!(info["stream"]["is_complete"], false);
    assert!(info["stream"]["split_count"].as_u64() < Some(step_count));
}

#[test]
fn levels_of_a_stream_meet_their_targets() {
    let bench = with_stream();
    let extract = |target: &str| {
        let report = bench.json(&format!("extract ball.stri -o x.ply {target}"));
        assert_eq!(report["model"], "progressive");
        assert_keys(
            &report,
            &["is_complete", "read_bytes", "file_bytes", "level_bytes", "error", "seek_secs"],
        );
        let info = bench.json("info x.ply");
        assert_eq!(info["triangle_count"], report["triangle_count"], "{target}");
        report
    };
    let step_count = extract("--detail 1")["step_count"].as_u64().expect("a number");
    let report = extract("--triangles 700");
    let count = number(&report, "triangle_count");
    assert!((698.0..=700.0).contains(&count), "{report}");
    assert_eq!(report["stop_reason"], "target_reached");
    assert!(number(&report, "level_bytes") <= number(&report, "read_bytes"));
    assert!(number(&report, "read_bytes") < number(&report, "file_bytes"), "{report}");
    assert_eq!(extract("--vertices 300")["vertex_count"], 300);
    assert_eq!(extract("--split-count 100")["split_count"], 100);
    assert_eq!(extract("--detail 0.5")["split_count"], step_count / 2);
    assert_eq!(extract("--detail 0")["split_count"], 0);
    assert_eq!(extract("--triangles 99999")["stop_reason"], "full_mesh");
    assert_eq!(extract("--triangles 2")["stop_reason"], "base_reached");
    let report = extract("--error 1%");
    assert!(number(&report, "error") <= 0.01 * 12f64.sqrt(), "{report}");
    assert!(number(&report, "split_count") < step_count as f64);
    bench.run("extract ball.stri -o x.glb --triangles 700 --as strips").success();
    bench.run("extract ball.stri -o x.glb --triangles 700 --as fans").success();
    assert!(bench.refused("extract ball.stri -o x.ply --detail 1 --model mts").contains("no model mts"));
    assert!(bench.refused("extract ball.stri -o x.ply --eye 0,0,3 --model progressive").contains(
        "does not \
            support views"
    ));
}

#[test]
fn a_truncated_stream_gives_the_levels_that_it_contains() {
    let bench = with_stream();
    bench.run("encode sphere.obj -o ball.striata --quiet").success();
    for (whole, part) in [("ball.stri", "part.stri"), ("ball.striata", "part.striata")] {
        let bytes = bench.read(whole);
        let facts = bench.json(&format!("info {whole}"));
        let step_count = number(&facts, "step_count");
        let before = bytes.len() - number(&facts["stream"], "bytes") as usize;
        let base = before + number(&facts["stream"], "base_bytes") as usize;
        let mut last = -1.0;
        for i in 0..12 {
            let length = base + (bytes.len() - base) * i / 12;
            bench.write(part, &bytes[..length]);
            let report = bench.json(&format!("decode {part} -o x.ply"));
            assert_eq!(report["is_complete"], false);
            assert_eq!(report["read_bytes"], length - before);
            let split_count = number(&report, "split_count");
            assert!(split_count >= last && split_count < step_count, "{report}");
            last = split_count;
            let info = bench.json("info x.ply");
            assert_eq!(info["triangle_count"], report["triangle_count"]);
            assert_eq!(info["is_closed"], true, "{length}");
            let level = bench.json(&format!("extract {part} -o x.ply --detail 1"));
            assert_eq!(level["split_count"], report["split_count"]);
            assert_eq!(level["stop_reason"], "input_ended");
            assert_eq!(level["is_complete"], false);
            assert_eq!(level["error"], report["error"]);
            assert_eq!(
                bench.json(&format!("extract {part} -o x.ply --detail 0"))["stop_reason"],
                "target_reached"
            );
            let info = bench.json(&format!("info {part}"));
            assert_eq!(info["stream"]["split_count"], report["split_count"]);
            assert_eq!(info["stream"]["is_complete"], false);
        }
        assert!(last > 0.5 * step_count, "11/12 of the bytes gave {last} of {step_count} steps");
        // Verbs that read meshes use the finest level that is present, and warn.
        for line in
            ["convert {} x.ply", "strip {}", "simplify {} -o x.ply --detail 1", "distance {} sphere.obj"]
        {
            let assert = bench.run(&line.replace("{}", part)).success();
            let stderr = String::from_utf8_lossy(&assert.get_output().stderr).into_owned();
            assert!(stderr.contains("cut off after"), "{line}: {stderr}");
        }
        for length in [base - 1, before + 20, before + 3] {
            bench.write(part, &bytes[..length]);
            for verb in
                ["decode {} -o y.ply", "info {}", "extract {} -o y.ply --detail 1", "convert {} y.ply"]
            {
                let message = bench.refused(&verb.replace("{}", part));
                assert!(
                    message.contains(part) && message.contains("hint: "),
                    "{verb} of {length} bytes: \
                    {message}"
                );
            }
        }
    }
    assert!(!bench.names().contains(&"y.ply".to_owned()), "nothing may be written");
}

#[test]
fn decode_reads_only_what_a_level_needs() {
    let bench = with_stream();
    let whole = bench.json("decode ball.stri -o whole.ply");
    assert_eq!((&whole["shortfall"], &whole["read_bytes"]), (&Value::Null, &whole["stream_bytes"]));
    for level in
        ["--triangles 500", "--ratio 0.1", "--vertices 10%", "--detail 0.2", "--error 1%", "--split-count 40"]
    {
        let decoded = bench.json(&format!("decode ball.stri -o decoded.ply {level}"));
        let extracted = bench.json(&format!("extract ball.stri -o extracted.ply {level}"));
        for key in ["split_count", "triangle_count", "vertex_count", "error", "read_bytes", "shortfall"] {
            assert_eq!(decoded[key], extracted[key], "{key} of {level}");
        }
        assert_eq!(bench.read("decoded.ply"), bench.read("extracted.ply"), "{level}");
        assert!(
            number(&decoded, "read_bytes") < 0.8 * number(&decoded, "stream_bytes"),
            "{level}: {decoded}"
        );
    }
    // A stream that is cut off after the level does not matter.
    let bytes = bench.read("ball.stri");
    let needed = number(&bench.json("decode ball.stri -o x.ply --triangles 500"), "read_bytes") as usize;
    bench.write("part.stri", &bytes[..needed]);
    let from_part = bench.json("decode part.stri -o x.ply --triangles 500");
    assert_eq!(from_part["shortfall"], Value::Null);
    let short = bench.json("decode part.stri -o x.ply --detail 1");
    assert_eq!(short["shortfall"], "the input ends before this level");
    assert!(
        bench.refused("decode ball.stri -o x.ply --detail 0.5 --ratio 0.1").contains("cannot be used with")
    );
}

#[test]
fn damaged_streams_are_refused() {
    let bench = with_stream();
    let bytes = bench.read("ball.stri");
    for i in 0..40 {
        let at = bytes.len() * i / 40;
        let mut hurt = bytes.clone();
        hurt[at] ^= 0x10;
        bench.write("hurt.stri", &hurt);
        let message = bench.refused("decode hurt.stri -o y.ply");
        assert!(message.contains("hurt.stri"), "{at}: {message}");
    }
    let mut long = bytes.clone();
    long.push(0);
    bench.write("long.stri", &long);
    assert!(bench.refused("decode long.stri -o y.ply").contains("bytes, expected"));
    bench.write("empty.stri", "");
    assert!(bench.refused("decode empty.stri -o y.ply").contains("empty.stri"));
    assert!(!bench.names().contains(&"y.ply".to_owned()), "nothing may be written");
}

#[test]
fn streams_can_be_piped() {
    let bench = with_stream();
    let stream = bench.run("encode sphere.obj -o - --quiet").success().get_output().stdout.clone();
    assert_eq!(stream, bench.read("ball.stri"));
    let mesh = bench.command("decode - -o - --quiet").write_stdin(stream.clone()).assert().success();
    bench.run("decode ball.stri -o x.ply").success();
    assert_eq!(mesh.get_output().stdout, bench.read("x.ply"));
    let half = &stream[..stream.len() / 2];
    let mesh = bench.command("decode - -o half.ply").write_stdin(half).assert().success();
    assert!(String::from_utf8_lossy(&mesh.get_output().stderr).contains("stdin: cut off after"));
    let mesh = bench.command("extract - -o some.ply --triangles 500").write_stdin(half).assert().success();
    assert!(String::from_utf8_lossy(&mesh.get_output().stderr).contains("target reached"));
    assert!(bench.refused("encode sphere.obj -o - --json").contains("cannot both go to stdout"));
}

#[test]
fn wrong_inputs_and_flags_are_refused() {
    let bench = with_stream();
    let refuses = |line: &str, expected: &str| {
        let message = bench.refused(line);
        assert!(message.contains(expected), "{line}: {message}");
    };
    refuses("decode sphere.obj -o x.ply", "not a .striata file");
    refuses("encode sphere.obj -o x.ply", "`encode` writes streams");
    refuses("convert sphere.obj x.stri", "striata encode");
    refuses("encode sphere.obj -o x.stri --bits 25", "--bits");
    refuses("encode sphere.obj -o x.stri --bits 12 --lossless", "--lossless");
    refuses("encode sphere.obj -o x.stri --batch-share 0", "greater than 0");
    refuses("build sphere.obj -o x.striata --bits 12", "--models progressive");
    refuses("build sphere.obj -o x.striata --stream --order hausdorff", "quadric");
    refuses("build sphere.obj -o x.striata --stream --models mts", "--models");
    bench.run("build sphere.obj -o strips.striata --quiet").success();
    refuses("decode strips.striata -o x.ply", "no progressive stream");
}

#[test]
fn attributes_and_boundaries_are_preserved() {
    let bench = Workbench::new();
    let spot = asset("spot.obj.zst");
    let Some(spot) = spot.to_str().filter(|_| spot.exists()) else { panic!("assets/spot.obj.zst is there") };
    let full = bench.json(&format!("info {spot}"));
    let report = bench.json(&format!("build {spot} -o spot.striata --stream --max-error 2%"));
    assert_eq!(report["error_is_guaranteed"], true);
    let info = bench.json("info spot.striata");
    assert_eq!(info["triangle_count"], full["triangle_count"]);
    assert_eq!(info["boundary_edge_count"], full["boundary_edge_count"]);
    assert_eq!(info["error_is_guaranteed"], true);
    let level = bench.json("extract spot.striata -o x.ply --error 1%");
    assert_eq!(level["error_is_guaranteed"], true);
    let off = bench.json(&format!("distance {spot} x.ply --samples 100000"));
    let allowed = number(&level, "error") + 2e-4 * number(&full, "diagonal");
    let found = off["a_to_b"]["max"].as_f64().expect("a number");
    assert!(found <= allowed, "{found} exceeds {allowed}");
}

/// A red pixel.
const PNG: &[u8] = b"\x89PNG\x0d\x0a\x1a\x0a\x00\x00\x00\x0dIHDR\x00\x00\x00\x01\x00\x00\x00\x01\x08\x02\x00\x00\x00\x90wS\xde\x00\x00\x00\x0cIDATx\x9cc\xf8\xcf\xc0\x00\x00\x03\x01\x01\x00\xc9\xfe\x92\xef\x00\x00\x00\x00IEND\xaeB`\x82";

/// Scenes hold less than meshes: a textured mesh with more data is encoded as one mesh, and GLB files say what they
/// lack.
#[test]
fn data_of_textured_meshes_are_kept_or_named() {
    let bench = Workbench::new();
    bench.write("pixel.png", PNG);
    let mut text =
        "ply\nformat ascii 1.0\ncomment TextureFile pixel.png\ncomment georeference {\"epsg\":32632}\n\
         element vertex 100\nproperty double x\nproperty double y\nproperty double z\nproperty float s\n\
         property float t\nproperty int label\nproperty double time\nelement face 162\n\
         property list uchar int vertex_indices\nproperty int id\nend_header\n"
            .to_owned();
    for i in 0..100 {
        let (x, y) = (i % 10, i / 10);
        let (label, time) = (i - 7 + 123_456_789, 1.6e9 + f64::from(i) / 1000.0);
        text += &format!("{x}.25 {y} {} 0.{x} 0.{y} {label} {time}\n", x * y % 4);
    }
    for i in (0..90).filter(|i| i % 10 < 9) {
        text += &format!(
            "3 {i} {} {} {}\n3 {} {} {} {}\n",
            i + 1,
            i + 10,
            -i,
            i + 1,
            i + 11,
            i + 10,
            i + 16_777_217
        );
    }
    bench.write("scan.ply", text);
    let stderr = |line: &str| {
        let assert = bench.run(line).success();
        String::from_utf8_lossy(&assert.get_output().stderr).into_owned()
    };
    let full = striata_io::read(bench.path("scan.ply")).unwrap();
    let note = stderr("encode scan.ply -o scan.stri --lossless");
    assert!(note.contains("encoded as one mesh"), "{note}");
    bench.run("decode scan.stri -o back.ply").success();
    let back = striata_io::read(bench.path("back.ply")).unwrap();
    assert_eq!((back.vertex_count(), back.triangle_count()), (100, 162));
    let kinds = |mesh: &striata::mesh::IndexedMesh| {
        let layers = mesh.layers.iter().chain(&mesh.triangle_layers);
        layers.map(|l| (l.semantic.to_string(), l.data.empty_like())).collect::<Vec<_>>()
    };
    assert_eq!(kinds(&back), kinds(&full));
    assert_eq!(back.appearance.georeference, full.appearance.georeference);
    assert_eq!(back.appearance.images.len(), 1);
    for line in ["encode scan.ply -o scan.glb", "build scan.ply -o ordered.glb", "convert scan.ply plain.glb"]
    {
        let warnings = stderr(line);
        for lost in ["the property `label` of vertices is left out", "the property `id` of faces is left out"]
        {
            assert!(warnings.contains(lost), "{line}: {warnings}");
        }
    }
    for name in ["scan.glb", "ordered.glb", "plain.glb"] {
        assert_eq!(bench.json(&format!("info {name}"))["georeference"]["epsg"], 32632, "{name}");
    }
    bench.write("named.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\ng left\nf 1 2 3\ng right\nf 2 4 3\n");
    for line in ["encode named.obj -o named.glb", "build named.obj -o named.glb"] {
        let warnings = stderr(line);
        assert!(
            warnings.contains("the names of 2 groups, such as `left`, are left out"),
            "{line}: {warnings}"
        );
    }
    // Without such data it is a scene, which sends previews of its textures first.
    bench.run("convert plain.glb less.obj").success();
    assert!(bench.json("encode less.obj -o less.stri")["image_count"] == 1);
}

/// One triangle far away makes the grid coarser than all of the ball.
#[test]
fn rounding_that_merges_vertices_is_pointed_out() {
    let bench = Workbench::new();
    let mut mesh = striata::mesh::shapes::icosphere(3, 1.0);
    let first = mesh.positions.len() as u32;
    mesh.positions.extend([[1e8, 0.0, 0.0], [1e8, 8.0, 0.0], [1e8, 0.0, 8.0]]);
    mesh.triangles.push([first, first + 1, first + 2]);
    striata_io::write(bench.path("far.ply"), &mesh, &striata_io::WriteOptions::default()).unwrap();
    let said = |line: &str| {
        let run = bench.run(line).success();
        String::from_utf8_lossy(&run.get_output().stderr).into_owned()
    };
    assert!(said("encode far.ply -o far.stri").contains("vertices fall on others"));
    assert!(!said("encode far.ply -o exact.stri --lossless").contains("vertices fall on others"));
    assert!(!said("convert far.ply -o far.glb").contains("vertices fall on others"));
    for options in ["--quantize", "--meshopt", "--draco"] {
        let remark = said(&format!("convert far.ply -o far.glb {options}"));
        assert_eq!(remark.matches("vertices fall on others").count(), 1, "{options}: {remark}");
    }
}

/// A mesh has no clips and no skin, which are named when a scene becomes one.
#[test]
fn motion_that_a_mesh_cannot_have_is_named() {
    let bench = Workbench::new();
    std::fs::copy(asset("arm.glb"), bench.path("arm.glb")).expect("the folder is ours");
    let said = |line: &str| {
        let run = bench.run(line).success();
        String::from_utf8_lossy(&run.get_output().stderr).into_owned()
    };
    for line in
        ["simplify arm.glb -o arm.ply --ratio 0.5", "convert arm.glb -o arm.ply", "strip arm.glb -o s.glb"]
    {
        let of_mesh = said(line);
        assert_eq!(of_mesh.matches("left out: the mesh keeps its rest pose").count(), 2, "{of_mesh}");
    }
    let of_scene = said("simplify arm.glb -o other.glb --ratio 0.5");
    assert!(!of_scene.contains("rest pose"), "{of_scene}");
}
