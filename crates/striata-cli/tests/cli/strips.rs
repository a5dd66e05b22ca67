//! `strip`, and the strips of `build`: each triangle is in one strip, and reported costs are consistent.

use serde_json::Value;
use striata::mesh::{IndexedMesh, canonical_triangles};

use crate::workbench::{Workbench, assert_keys, asset};

const KEYS: [&str; 20] = [
    "algorithm",
    "triangle_count",
    "degenerate_triangle_count",
    "component_count",
    "strip_count",
    "strip_count_bound",
    "swap_count",
    "restart_count",
    "index_count",
    "indices_per_triangle",
    "longest_strip",
    "acmr_16",
    "acmr_lru_16",
    "atvr_lru_16",
    "atvr_16",
    "stripify_secs",
    "seed",
    "budget_secs",
    "stitched_index_count",
    "secs",
];

/// Two materials on the two halves of a square, and a triangle that repeats a vertex.
const TWO_GROUPS: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nv 2 1 0\nusemtl red\nf 1 2 3\nf 1 3 \
    4\n\
                          usemtl blue\nf 2 5 6\nf 2 6 3\nf 5 5 6\n";

fn count(report: &Value, key: &str) -> u64 {
    report[key].as_u64().unwrap_or_else(|| panic!("{key} of {report}"))
}

/// Panics if the costs in a report are inconsistent.
fn assert_adds_up(report: &Value) {
    assert_keys(report, &KEYS);
    let (triangles, strips) = (count(report, "triangle_count"), count(report, "strip_count"));
    let indices = triangles + 2 * strips + count(report, "swap_count") + count(report, "restart_count");
    assert_eq!(count(report, "index_count"), indices, "{report}");
    let ratio = report["indices_per_triangle"].as_f64().expect("a number");
    assert!((ratio * triangles as f64 - indices as f64).abs() < 1e-6, "{report}");
    assert!(count(report, "longest_strip") <= indices && strips >= count(report, "component_count").min(1));
}

fn triangles_of(bench: &Workbench, name: &str) -> Vec<[[u32; 3]; 3]> {
    let mesh = striata_io::read(bench.path(name)).expect("the output is readable");
    corners_of(&mesh)
}

/// Returns triangles as the bits of their corner positions, independent of vertex order.
fn corners_of(mesh: &IndexedMesh) -> Vec<[[u32; 3]; 3]> {
    let corner = |v: u32| mesh.positions[v as usize].map(|x| (x + 0.0).to_bits());
    let mut list: Vec<[[u32; 3]; 3]> = canonical_triangles(&mesh.triangles)
        .into_iter()
        .map(|t| {
            let mut corners = t.map(corner);
            let least = (0..3).min_by_key(|&k| corners[k]).unwrap_or(0);
            corners.rotate_left(least);
            corners
        })
        .collect();
    list.sort_unstable();
    list
}

#[test]
fn strips_are_reported_and_written() {
    let bench = Workbench::with_ball();
    let report = bench.json("strip sphere.obj -o strips.glb");
    assert_adds_up(&report);
    assert_eq!((count(&report, "triangle_count"), count(&report, "component_count")), (512, 1));
    assert_eq!(triangles_of(&bench, "strips.glb"), triangles_of(&bench, "sphere.obj"));
    let report_only = bench.json("strip sphere.obj");
    for key in KEYS.iter().filter(|key| !key.contains("secs") && !key.starts_with("stitched")) {
        assert_eq!(report_only[key], report[key], "{key}");
    }
    // The file contains these strips: its accessor has as many indices, in mode 5, in 16 bits.
    let glb = bench.read("strips.glb");
    let json_length = u32::from_le_bytes([glb[12], glb[13], glb[14], glb[15]]) as usize;
    let document: Value = serde_json::from_slice(&glb[20..20 + json_length]).expect("a glTF document");
    let primitive = &document["meshes"][0]["primitives"][0];
    assert_eq!(primitive["mode"], 5);
    let accessor = &document["accessors"][primitive["indices"].as_u64().expect("an accessor") as usize];
    assert_eq!(accessor["count"], report["stitched_index_count"]);
    assert_eq!(accessor["componentType"], 5123);
}

#[test]
fn equal_seeds_give_equal_strips() {
    let bench = Workbench::with_ball();
    bench.run("strip sphere.obj -o a.glb --seed 7 --quiet").success();
    bench.run("strip sphere.obj -o b.glb --seed 7 --quiet").success();
    bench.run("strip sphere.obj -o c.glb --seed 8 --quiet").success();
    assert_eq!(bench.read("a.glb"), bench.read("b.glb"));
    assert_ne!(bench.read("a.glb"), bench.read("c.glb"), "the seed has no effect");
}

#[test]
fn a_chain_starts_from_the_strips_before() {
    let bench = Workbench::with_ball();
    let alone = bench.json("strip sphere.obj --strips greedy");
    let again = bench.json("strip sphere.obj --strips greedy+greedy --budget 0");
    assert_eq!(again["algorithm"], "greedy+greedy");
    assert_eq!(again["strip_count"], alone["strip_count"]);
    assert_eq!(again["index_count"], alone["index_count"]);
}

#[test]
fn searching_saves_indices_and_respects_its_budget() {
    let bench = Workbench::with_ball();
    let greedy = bench.json("strip sphere.obj --strips greedy");
    let searched = bench.json("strip sphere.obj");
    assert_eq!(searched["algorithm"], "cheapest");
    assert!(count(&searched, "index_count") < count(&greedy, "index_count"), "{searched}");
    let nothing = bench.json("strip sphere.obj --budget 0");
    assert!(count(&nothing, "index_count") <= count(&greedy, "index_count"), "{nothing}");
    let budget = bench.json("strip sphere.obj --budget 0.25");
    assert_adds_up(&budget);
    assert_eq!(budget["budget_secs"], 0.25);
    let secs = budget["stripify_secs"].as_f64().expect("a number");
    assert!((0.25..5.0).contains(&secs), "{secs} s of 0.25");
}

#[test]
fn fewest_strips_are_reported_with_a_lower_bound() {
    let bench = Workbench::with_ball();
    let fewest = bench.json("strip sphere.obj --strips fewest");
    assert_adds_up(&fewest);
    assert_eq!((count(&fewest, "strip_count"), count(&fewest, "strip_count_bound")), (1, 1));
    assert!(bench.json("strip sphere.obj --strips greedy")["strip_count_bound"].is_null());
    let text = bench.run("strip sphere.obj --strips greedy+fewest").success();
    assert!(String::from_utf8_lossy(&text.get_output().stdout).contains("strips, lower bound"));
}

#[test]
fn strips_of_a_textured_mesh_are_read_back() {
    let bench = Workbench::new();
    let mesh = striata_io::read(asset("spot.obj.zst")).expect("an asset");
    bench.command("strip -o spot.gltf --quiet").arg(asset("spot.obj.zst")).assert().success();
    let back = striata_io::read(bench.path("spot.gltf")).expect("the output is readable");
    assert_eq!(back.layers.len(), mesh.layers.len());
    assert_eq!(corners_of(&back), corners_of(&mesh));
}

#[test]
fn groups_keep_their_strips_and_materials() {
    let bench = Workbench::new();
    bench.write("two.obj", TWO_GROUPS);
    let report = bench.json("strip two.obj -o two.glb");
    assert_adds_up(&report);
    assert_eq!((count(&report, "triangle_count"), count(&report, "degenerate_triangle_count")), (4, 1));
    assert!(count(&report, "strip_count") >= 2, "no strip crosses a material: {report}");
    let back = striata_io::read(bench.path("two.glb")).expect("the output is readable");
    assert_eq!(back.groups.iter().map(|group| group.count).collect::<Vec<_>>(), [2, 2]);
    assert_eq!(back.appearance.materials.len(), 2);
}

#[test]
fn strip_reads_containers_and_pipes() {
    let bench = Workbench::with_ball();
    let report = bench.json("strip ball.striata -o ball.glb");
    assert_adds_up(&report);
    assert_eq!(triangles_of(&bench, "ball.glb"), triangles_of(&bench, "sphere.obj"));
    let piped =
        bench.command("strip - -o - --to glb").write_stdin(bench.read("sphere.obj")).assert().success();
    assert!(piped.get_output().stdout.starts_with(b"glTF"));
    let stderr = String::from_utf8_lossy(&piped.get_output().stderr).into_owned();
    assert!(stderr.contains("indices per triangle"), "{stderr}");
}

#[test]
fn equal_vertices_are_merged_only_with_weld() {
    let bench = Workbench::new();
    // Two triangles of a square that share an edge but no vertex.
    bench.write("loose.off", "OFF\n6 2 0\n0 0 0\n1 0 0\n1 1 0\n0 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 3 4 5\n");
    assert_eq!(bench.json("strip loose.off")["strip_count"], 2);
    let assert = bench.run("strip loose.off").success();
    assert!(String::from_utf8_lossy(&assert.get_output().stderr).contains("hint: "), "no word about --weld");
    assert!(bench.run("strip loose.off --weld").success().get_output().stderr.is_empty());
    let welded = bench.json("strip loose.off --weld");
    assert_eq!((&welded["strip_count"], &welded["component_count"]), (&1.into(), &1.into()));
}

#[test]
fn empty_meshes_have_no_strips() {
    let bench = Workbench::new();
    bench.write("none.off", "OFF\n0 0 0\n");
    bench.write("cloud.off", "OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n");
    let report = bench.json("strip none.off -o none.glb");
    assert_adds_up(&report);
    assert_eq!((count(&report, "strip_count"), count(&report, "index_count")), (0, 0), "{report}");
    assert_eq!(report["indices_per_triangle"], 0.0);
    bench.run("info none.glb").success();
    assert!(bench.refused("strip cloud.off -o cloud.glb").contains("3 points and no triangles"));
}

#[test]
fn impossible_strips_are_refused() {
    let bench = Workbench::with_ball();
    for (arguments, named) in [
        ("strip sphere.obj -o strips.ply", "strips.ply: PLY files cannot contain strips"),
        ("strip sphere.obj -o strips.obj", "hint: write .glb or .gltf"),
        ("strip sphere.obj -o - --to ply", "--to glb"),
        ("strip sphere.obj -o strips.striata", "striata build"),
        ("strip sphere.obj --strips zigzag", "greedy"),
        ("strip sphere.obj --strips greedy+", "greedy"),
        ("strip sphere.obj --strips tunnel:0", "tunnel:0"),
        ("strip sphere.obj --strips greedy:3", "greedy:3"),
        ("strip sphere.obj --budget -1", "0 or more"),
        ("strip sphere.obj --budget nan", "0 or more"),
        ("strip sphere.obj --cache-weight inf", "0 or more"),
        ("strip sphere.obj --cache-size 0", "1..=4096"),
        ("strip nowhere.ply", "nowhere.ply"),
        ("build sphere.obj -o again.striata --strips zigzag", "greedy"),
    ] {
        let message = bench.refused(arguments);
        assert!(message.contains(named), "{arguments}: {message}");
    }
    bench.write("notes.ply", "Dear diary, today I looked at strips.\n");
    assert!(bench.refused("strip notes.ply -o strips.glb").contains("line 1"));
    bench.write("nan.off", "OFF\n4 2 0\n0 0 0\n1 0 0\n0 nan 0\n1 1 0\n3 0 1 2\n3 1 3 2\n");
    let message = bench.refused("strip nan.off -o strips.glb");
    assert!(message.starts_with("error: nan.off: ") && message.contains("vertex 2"), "{message}");
    assert_eq!(bench.names(), ["ball.striata", "nan.off", "notes.ply", "sphere.obj"]);
}

#[test]
fn build_accepts_the_same_stripifiers() {
    let bench = Workbench::with_ball();
    let built = bench.json("build sphere.obj -o again.striata --strips greedy+greedy");
    assert_eq!(built["strips"]["algorithm"], "greedy+greedy");
    assert_eq!(built["strips"]["triangle_count"], 512);
}
