//! Meshes with flat shading, seams, materials and many parts, reach every target unless flags prevent it.

use std::collections::BTreeSet;
use std::fmt::Write as _;

use serde_json::Value;

use crate::workbench::{Workbench, sphere};

/// Formats that levels are written in.
const FORMATS: [&str; 6] = ["ply", "obj", "stl", "off", "gltf", "glb"];

/// Creates a folder with a flat-shaded ball, boxes with hard edges, and separate cards.
fn bench_of_assets() -> Workbench {
    let bench = Workbench::new();
    bench.write("flat.obj", flat(&sphere(12, 12)));
    bench.write("boxes.obj", boxes(24, 3));
    bench.write("cards.obj", cards(90));
    bench
}

const ASSETS: [&str; 3] = ["flat.obj", "boxes.obj", "cards.obj"];

fn count(report: &Value, key: &str) -> usize {
    let value = key.split('.').fold(report, |value, part| &value[part]);
    value.as_u64().unwrap_or_else(|| panic!("no count {key} in {report}")) as usize
}

fn stderr_of(bench: &Workbench, line: &str) -> String {
    let output = bench.run(line).success();
    String::from_utf8_lossy(&output.get_output().stderr).into_owned()
}

#[test]
fn every_percentage_is_reached_by_default() {
    let bench = bench_of_assets();
    // Three triangles at one edge, a separate one, a duplicate, and one without area.
    bench.write(
        "soup.off",
        "OFF\n10 7 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n0 -1 0.5\n5 5 5\n6 5 5\n5 6 5\n9 9 9\n0.5 0 0\n\
         3 0 1 2\n3 0 1 3\n3 0 1 4\n3 5 6 7\n3 5 6 7\n3 0 9 1\n3 5 7 5\n",
    );
    let shares = "90%,75%,50%,30%,25%,10%,5%,2%,1%,0.1%,0.001%";
    let inputs =
        ["soup.off", "shape:two-materials", "shape:cylinder", "shape:cube", "shape:moebius", "shape:grid"];
    for input in inputs.into_iter().chain(ASSETS) {
        bench.json(&format!("simplify {input} -o level-{{}}.ply --levels {shares} --strict"));
        for target in ["--ratio 0.0001", "--triangles 2", "--vertices 6", "--vertices 0.1%", "--detail 0"] {
            bench.json(&format!("simplify {input} -o level.ply {target} --strict"));
        }
        bench.json(&format!(
            "build {input} -o all.striata --models lodstrips,mts,fans,patterns --base 1% --strict"
        ));
        bench.json(
            "build {} -o all.striata --models lodstrips,mts,fans,patterns".replace("{}", input).as_str(),
        );
        for model in ["lodstrips", "mts", "fans", "patterns"] {
            let line =
                format!("extract all.striata -o level-{{}}.glb --levels {shares} --strict --model {model}");
            bench.json(&line);
        }
    }
}

#[test]
fn keep_seams_keeps_seams() {
    let bench = bench_of_assets();
    // Every edge of the flat ball is a seam, so no vertex can move along one.
    let free = bench.json("simplify flat.obj -o free.ply --triangles 10%");
    assert!(free["shortfall"].is_null(), "{free}");
    let kept = bench.json("simplify flat.obj -o kept.ply --triangles 10% --keep-seams");
    assert_eq!(kept["stop_reason"], "base_reached");
    let all = count(&bench.json("info flat.obj"), "triangle_count");
    assert!(count(&kept, "triangle_count") > all / 2, "{kept}");
    let why = kept["shortfall"].as_str().expect("a reason");
    assert!(why.ends_with("or changing what --keep-seams protects"), "{why}");
    let strict = bench.refused("simplify flat.obj -o x.ply --triangles 10% --keep-seams --strict");
    assert!(
        strict.contains("--strict: the level was not reached") && strict.contains("--keep-seams"),
        "{strict}"
    );
    // The sides of the boxes keep their borders, normals and materials, so each keeps at least two triangles.
    let sides = 24 * 6;
    let kept = bench.json("simplify boxes.obj -o kept.ply --triangles 1% --keep-seams --keep-parts");
    assert_eq!(count(&kept, "triangle_count"), 2 * sides, "{kept}");
    let info = bench.json("info kept.ply");
    assert_eq!(count(&info, "seams.seam_edge_count"), 24 * 12);
    let area = |name: &str| bench.json(&format!("info {name}"))["area"].as_f64().expect("an area");
    assert!((area("kept.ply") - area("boxes.obj")).abs() < 1e-4 * area("boxes.obj"), "no side changes");
    // The same applies to files.
    let built = bench.json("build boxes.obj -o kept.striata --keep-seams --keep-parts");
    assert_eq!(count(&built, "base.triangle_count"), 2 * sides);
    assert_eq!(count(&bench.json("info kept.striata"), "steps.crossing_count"), 0);
    bench.json("build boxes.obj -o free.striata");
    assert!(count(&bench.json("info free.striata"), "steps.crossing_count") > 0);
}

#[test]
fn keep_parts_keeps_parts() {
    let bench = bench_of_assets();
    let parts = |name: &str| count(&bench.json(&format!("info {name}")), "component_count");
    let least = count(&bench.json("info boxes.obj"), "parts.least_triangle_count");
    assert_eq!((parts("boxes.obj"), least), (24, 2 * 24), "closed parts have at least two triangles");
    let free = bench.json("simplify boxes.obj -o free.ply --triangles 20");
    assert!(free["shortfall"].is_null() && parts("free.ply") < 24, "{free}");
    let kept = bench.json("simplify boxes.obj -o kept.ply --triangles 20 --keep-parts");
    assert_eq!(parts("kept.ply"), 24);
    assert!((least..=2 * least).contains(&count(&kept, "triangle_count")), "{kept}");
    let why = kept["shortfall"].as_str().expect("a reason");
    assert!(why.ends_with("or changing what --keep-parts protects"), "{why}");
    let strict = bench.refused("simplify boxes.obj -o x.ply --triangles 20 --keep-parts --strict");
    assert!(strict.contains("--keep-parts protects"), "{strict}");
    // A target that leaves triangles for every part is reached.
    bench.json("simplify boxes.obj -o kept.ply --triangles 200 --keep-parts --strict");
    assert_eq!(parts("kept.ply"), 24);
    // The same applies to vertex removal and optimal placement.
    for way in ["--order hausdorff", "--placement optimal"] {
        bench.json(&format!("simplify boxes.obj -o free.ply --triangles 20 {way} --strict"));
        assert!(parts("free.ply") < 24, "{way}");
        let kept = bench.json(&format!("simplify boxes.obj -o kept.ply --triangles 20 {way} --keep-parts"));
        assert_eq!(parts("kept.ply"), 24, "{way}");
        let why = kept["shortfall"].as_str().expect("a reason");
        assert!(why.ends_with("or changing what --keep-parts protects"), "{way}: {why}");
    }
    // Each card is a part that can lose one of its two triangles.
    let cards = bench.json("simplify cards.obj -o cards.ply --triangles 1 --keep-parts");
    assert_eq!((count(&cards, "triangle_count"), parts("cards.ply")), (90, 90));
    let built = bench.json("build boxes.obj -o kept.striata --keep-parts --base 20");
    assert!(built["shortfall"].is_string(), "{built}");
    assert_eq!(count(&bench.json("info kept.striata"), "steps.vanished_part_count"), 0);
    let both = stderr_of(
        &bench,
        "simplify boxes.obj -o x.ply --triangles 1 --keep-parts --keep-seams \
            --lock-boundary",
    );
    assert!(both.contains("what --lock-boundary, --keep-seams and --keep-parts protect"), "{both}");
}

/// Returns the primitive modes of a glTF; panics if it has an empty mesh, primitive, accessor or buffer view.
fn check_gltf(name: &str, bytes: &[u8]) -> BTreeSet<u64> {
    let root: Value = serde_json::from_slice(bytes).unwrap_or_else(|error| panic!("{name}: {error}"));
    let list = |value: &Value| value.as_array().cloned().unwrap_or_default();
    let mut modes = BTreeSet::new();
    let accessors = list(&root["accessors"]);
    for mesh in list(&root["meshes"]) {
        let primitives = list(&mesh["primitives"]);
        assert!(!primitives.is_empty(), "{name}: a mesh without primitives");
        for primitive in primitives {
            let accessor = &accessors[count(&primitive, "indices")];
            assert!(count(accessor, "count") >= 3, "{name}: an empty primitive");
            modes.insert(primitive["mode"].as_u64().expect("a mode"));
        }
    }
    assert!(accessors.iter().all(|accessor| count(accessor, "count") > 0), "{name}: an empty accessor");
    assert!(
        list(&root["bufferViews"]).iter().all(|view| count(view, "byteLength") > 0),
        "{name}: an empty view"
    );
    let nodes = list(&root["nodes"]);
    assert_eq!(nodes.len(), list(&root["meshes"]).len(), "{name}: a node without a mesh");
    modes
}

#[test]
fn levels_have_no_unused_vertices_or_groups() {
    let bench = bench_of_assets();
    for asset in ASSETS {
        bench.json(&format!("build {asset} -o all.striata --models lodstrips,mts,fans,patterns"));
        bench.json(&format!("encode {asset} -o all.stri"));
        let sources = ["lodstrips", "mts", "fans", "patterns"]
            .map(|model| format!("extract all.striata --model {model}"))
            .into_iter()
            .chain([format!("simplify {asset}"), "extract all.stri".to_owned()]);
        for source in sources {
            for format in FORMATS {
                // Normals would divide vertices.
                let raw = if ["gltf", "glb"].contains(&format) { " --raw" } else { "" };
                let report =
                    bench.json(&format!("{source} -o level-{{}}.{format} --levels 60%,30%,9%,3%{raw}"));
                for (level, name) in
                    report["levels"].as_array().expect("levels").iter().zip(["60", "30", "9", "3"])
                {
                    let name = format!("level-{name}.{format}");
                    let info = bench.json(&format!("info {name}"));
                    let at = format!("{asset}: {source}: {name}: {info}");
                    assert_eq!(info["triangle_count"], level["triangle_count"], "{at}");
                    assert_eq!(info["unused_vertex_count"], 0, "{at}");
                    // Readers of STL and OBJ create their own vertices.
                    if !["stl", "obj"].contains(&format) {
                        assert_eq!(info["vertex_count"], level["vertex_count"], "{at}");
                    }
                    if format == "gltf" {
                        check_gltf(&at, &bench.read(&name));
                    }
                }
            }
        }
    }
}

#[test]
fn groups_without_triangles_are_omitted() {
    let bench = bench_of_assets();
    bench.json("build boxes.obj -o all.striata --models lodstrips,fans");
    let groups = |name: &str| bench.json(&format!("info {name}"))["groups"].as_array().expect("groups").len();
    bench.json("convert boxes.obj full.gltf");
    let full = groups("full.gltf");
    for model in ["lodstrips", "fans"] {
        for form in ["list", "strips", "fans"] {
            let line = format!("extract all.striata -o level.gltf --model {model} --as {form} --triangles 9");
            let level = bench.json(&line);
            let modes = check_gltf(&line, &bench.read("level.gltf"));
            let expected: &[u64] = match form {
                "list" => &[4],
                "strips" => &[4, 5],
                _ => &[6],
            };
            assert!(modes.iter().all(|mode| expected.contains(mode)), "{line}: {modes:?}");
            let info = bench.json("info level.gltf");
            assert_eq!(info["triangle_count"], level["triangle_count"], "{line}");
            assert_eq!(info["unused_vertex_count"], 0, "{line}");
            assert!(groups("level.gltf") < full, "{line}");
        }
    }
    // OBJ files do not mention groups without triangles either.
    bench.json("extract all.striata -o level.obj --triangles 9");
    let text = String::from_utf8(bench.read("level.obj")).expect("text");
    let lines: Vec<&str> = text.lines().collect();
    let is_head = |line: &str| line.starts_with("g ") || line.starts_with("usemtl");
    let ends_empty =
        |at: usize| lines[at + 1..].iter().find(|line| !is_head(line)).is_none_or(|l| !l.starts_with('f'));
    assert!(!(0..lines.len()).any(|at| is_head(lines[at]) && ends_empty(at)), "{text}");
}

#[test]
fn groups_of_single_triangles_are_written_as_lists() {
    let bench = bench_of_assets();
    let report = bench.json("strip flat.obj -o flat.gltf");
    let triangles = count(&report, "triangle_count");
    assert_eq!(
        (count(&report, "plain_group_count"), count(&report, "stitched_index_count")),
        (1, 3 * triangles)
    );
    assert_eq!(check_gltf("flat.gltf", &bench.read("flat.gltf")), BTreeSet::from([4]));
    assert_eq!(count(&bench.json("info flat.gltf"), "triangle_count"), triangles);
    let text = stderr_of(&bench, "strip flat.obj -o flat.glb");
    assert!(text.contains("1 group as triangle lists") && text.contains("hint: "), "{text}");
    // Boxes have real strips, which are kept.
    let report = bench.json("strip boxes.obj -o boxes.gltf");
    assert!(count(&report, "stitched_index_count") < 3 * count(&report, "triangle_count"), "{report}");
    assert_eq!(count(&report, "plain_group_count"), 0);
    assert_eq!(check_gltf("boxes.gltf", &bench.read("boxes.gltf")), BTreeSet::from([5]));
}

#[test]
fn info_explains_what_limits_simplification() {
    let bench = bench_of_assets();
    let notes = |info: &Value| info["notes"].to_string();
    let flat = bench.json("info flat.obj");
    // The two triangles of a quad share a normal.
    let [seams, inner] =
        ["seam_edge_count", "inner_edge_count"].map(|key| count(&flat, &format!("seams.{key}")));
    assert!(2 * inner < 3 * seams && seams < inner, "{seams} of {inner}");
    assert_eq!(flat["seams"]["split_by"]["normal"], flat["position_count"]);
    assert!(
        notes(&flat).contains("The normals are split at 100 % of the positions: the mesh is flat shaded."),
        "{flat}"
    );
    assert_eq!((count(&flat, "parts.count"), count(&flat, "parts.least_triangle_count")), (1, 2));
    let boxes = bench.json("info boxes.obj");
    assert_eq!((count(&boxes, "parts.count"), count(&boxes, "parts.median_triangle_count")), (24, 6 * 2 * 9));
    assert_eq!(count(&boxes, "parts.tiny_count"), 0);
    // All edges of a box separate different normals, but only some separate materials.
    let split = |cause: &str| count(&boxes, &format!("seams.split_by.{cause}"));
    assert_eq!(split("normal"), count(&boxes, "seams.split_position_count"));
    assert!(split("material") > 0 && split("texcoord_0") > 0, "{boxes}");
    let sentences = notes(&boxes);
    assert!(
        sentences.contains("The mesh has 24 disconnected parts. A level with fewer than 48 triangles"),
        "{sentences}"
    );
    assert!(sentences.contains("Seams (normals, UVs and materials) run along "), "{sentences}");
    let text = bench.run("info boxes.obj").success();
    let text = String::from_utf8_lossy(&text.get_output().stdout).into_owned();
    for row in
        ["connected parts", "seam edges", "split positions", "vertices per position", "With --keep-parts"]
    {
        assert!(text.contains(row), "{text}");
    }
    let cards = bench.json("info cards.obj");
    assert_eq!((count(&cards, "parts.tiny_count"), count(&cards, "parts.least_triangle_count")), (90, 90));
    let plain = bench.json("info shape:torus");
    assert_eq!((count(&plain, "seams.seam_edge_count"), notes(&plain)), (0, "[]".to_owned()));
    bench.write(
        "odd.off",
        "OFF\n6 5 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n0 -1 0.5\n0.5 0 0\n3 0 1 2\n3 0 1 2\n3 \
        0 1 3\n3 0 1 4\n3 0 5 1\n",
    );
    let odd = notes(&bench.json("info odd.off"));
    for part in ["1 edge has more than two triangles", "1 triangle repeats", "1 triangle has no area"] {
        assert!(odd.contains(part), "{part}: {odd}");
    }
    bench.write("nan.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 nan 0\n3 0 1 2\n");
    assert!(bench.refused("info nan.off").contains("none of the triangles can be used"));
}

#[test]
fn info_reports_special_steps_of_a_file() {
    let bench = bench_of_assets();
    bench.json("build boxes.obj -o boxes.striata");
    let info = bench.json("info boxes.striata");
    let [crossing, empty, parts, vanished] =
        ["crossing_count", "empty_count", "part_count", "vanished_part_count"]
            .map(|key| count(&info, &format!("steps.{key}")));
    assert!(crossing > 0 && empty > 0 && crossing + empty < count(&info, "step_count"), "{info}");
    assert!(parts == 24 && (1..24).contains(&vanished), "{info}");
    // The reported level shows all parts, and the next coarser one does not.
    let from = count(&info, "steps.all_parts_split_count");
    let parts_at = |split_count: usize| {
        let level = bench.json(&format!("extract boxes.striata -o level.ply --split-count {split_count}"));
        (count(&bench.json("info level.ply"), "component_count"), level["triangle_count"].clone())
    };
    assert_eq!(parts_at(from), (24, info["steps"]["all_parts_triangle_count"].clone()));
    assert_eq!(parts_at(from - 1).0, 23);
    let text = bench.run("info boxes.striata").success();
    let text = String::from_utf8_lossy(&text.get_output().stdout).into_owned();
    for row in ["steps across seams", "steps that remove no triangle", "parts in the base"] {
        assert!(text.contains(row), "{text}");
    }
    // Patterns of free retriangulation have no collapses.
    let line = "build shape:cube -o cube.striata --order hausdorff --retriangulation free --models patterns";
    bench.json(line);
    assert!(bench.json("info cube.striata").get("steps").is_none());
}

/// Converts an OBJ so that each triangle has its own normals.
fn flat(text: &str) -> String {
    let places: Vec<[f64; 3]> = text
        .lines()
        .filter_map(|line| line.strip_prefix("v "))
        .map(|line| {
            let numbers: Vec<f64> = line.split(' ').map(|x| x.parse().expect("a number")).collect();
            [numbers[0], numbers[1], numbers[2]]
        })
        .collect();
    let (mut normals, mut faces) = (String::new(), String::new());
    let mut number = 0;
    for corners in text.lines().filter_map(|line| line.strip_prefix("f ")) {
        let corners: Vec<usize> = corners.split(' ').map(|v| v.parse().expect("a vertex")).collect();
        for k in 2..corners.len() {
            let triangle = [corners[0], corners[k - 1], corners[k]];
            let [a, b, c] = triangle.map(|v| places[v - 1]);
            let minus = |p: [f64; 3], q: [f64; 3]| [p[0] - q[0], p[1] - q[1], p[2] - q[2]];
            let (p, q) = (minus(b, a), minus(c, a));
            let n = [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]];
            let length = n.iter().map(|x| x * x).sum::<f64>().sqrt();
            number += 1;
            writeln!(normals, "vn {} {} {}", n[0] / length, n[1] / length, n[2] / length)
                .expect("writing to memory succeeds");
            writeln!(
                faces,
                "f {0}//{number} {1}//{number} {2}//{number}",
                triangle[0], triangle[1], triangle[2]
            )
            .expect("writing to memory succeeds");
        }
    }
    let places: Vec<&str> = text.lines().filter(|line| line.starts_with("v ")).collect();
    format!("{}\n{normals}{faces}", places.join("\n"))
}

/// Returns an OBJ of boxes of several sizes, each side a grid with its own normal, UV chart and one of three
/// materials.
fn boxes(box_count: usize, cells: usize) -> String {
    let mut text = String::new();
    let mut first = 1;
    for side in 0..6 * box_count {
        let (number, axis, is_back) = (side / 6, side % 3, side % 6 >= 3);
        let size = [0.2, 0.5, 1.0][number % 3];
        let sign = if is_back { -1.0 } else { 1.0 };
        let mut normal = [0.0; 3];
        normal[axis] = sign;
        writeln!(text, "vn {} {} {}", normal[0], normal[1], normal[2]).expect("writing to memory succeeds");
        for i in 0..(cells + 1) * (cells + 1) {
            let [u, w] = [i % (cells + 1), i / (cells + 1)].map(|i| i as f64 / cells as f64);
            let mut place = [0.0; 3];
            place[axis] = 0.5 * sign;
            place[(axis + 1) % 3] = u - 0.5;
            place[(axis + 2) % 3] = (w - 0.5) * sign;
            let [x, y, z] = place.map(|x| size * x);
            writeln!(
                text,
                "v {} {y} {z}\nvt {} {}",
                x + 2.0 * number as f64,
                u / 6.0 + (side % 6) as f64 / 6.0,
                w
            )
            .expect("writing to memory succeeds");
        }
        writeln!(text, "g box{number}\nusemtl m{}", side % 3).expect("writing to memory succeeds");
        for cell in 0..cells * cells {
            let a = first + cell / cells * (cells + 1) + cell % cells;
            let [b, c, d] = [a + 1, a + cells + 2, a + cells + 1];
            let corner = |v: usize| format!("{v}/{v}/{}", side + 1);
            writeln!(
                text,
                "f {} {} {}\nf {} {} {}",
                corner(a),
                corner(b),
                corner(c),
                corner(a),
                corner(c),
                corner(d)
            )
            .expect("writing to memory succeeds");
        }
        first += (cells + 1) * (cells + 1);
    }
    text
}

/// Returns an OBJ of separate squares of two triangles each, as used for leaves.
fn cards(card_count: usize) -> String {
    let mut text = String::new();
    for card in 0..card_count {
        let (x, y, z) = (1.5 * (card % 9) as f64, 1.3 * (card / 9 % 5) as f64, 0.7 * (card / 45) as f64);
        let first = 4 * card + 1;
        for (u, w) in [(0, 0), (1, 0), (1, 1), (0, 1)] {
            let tilt = 0.1 * (card % 4) as f64 * f64::from(w);
            writeln!(text, "v {} {} {}\nvt {u} {w}", x + f64::from(u), y + f64::from(w), z + tilt)
                .expect("writing to memory succeeds");
        }
        let corner = |k: usize| format!("{0}/{0}", first + k);
        writeln!(
            text,
            "f {} {} {}\nf {} {} {}",
            corner(0),
            corner(1),
            corner(2),
            corner(0),
            corner(2),
            corner(3)
        )
        .expect("writing to memory succeeds");
    }
    text
}
