//! `strip --levels`: strips that stay in repair from level to level, written and reported.

use serde_json::Value;
use striata::mesh::canonical_triangles;

use crate::workbench::{Workbench, assert_keys};

const KEYS: [&str; 7] = ["algorithm", "seed", "frames", "repair", "step_count", "levels", "secs"];
const LEVEL_KEYS: [&str; 15] = [
    "level",
    "split_count",
    "triangle_count",
    "strip_count",
    "swap_count",
    "index_count",
    "indices_per_triangle",
    "step_count",
    "tunnel_count",
    "frame_count",
    "strip_secs",
    "buffer_secs",
    "changed_range_count",
    "changed_index_count",
    "drawn_index_count",
];

fn count(report: &Value, key: &str) -> u64 {
    report[key].as_u64().unwrap_or_else(|| panic!("{key} of {report}"))
}

fn levels(report: &Value) -> &[Value] {
    report["levels"].as_array().expect("a list")
}

#[test]
fn levels_are_followed_in_the_given_order() {
    let bench = Workbench::with_ball();
    let report = bench.json("strip ball.striata --levels 100%,50%,10%,100% --frames 5 --strips greedy");
    assert_keys(&report, &KEYS);
    assert_eq!((&report["frames"], &report["repair"]), (&5.into(), &"indices".into()));
    for level in levels(&report) {
        assert_keys(level, &LEVEL_KEYS);
        let (triangles, strips) = (count(level, "triangle_count"), count(level, "strip_count"));
        assert_eq!(count(level, "index_count"), triangles + 3 * strips - 1 + count(level, "swap_count"));
        assert!(count(level, "drawn_index_count") >= count(level, "index_count"), "{level}");
    }
    let [full, half, tenth, back] = levels(&report) else { panic!("four levels: {report}") };
    assert_eq!((count(full, "triangle_count"), count(back, "triangle_count")), (512, 512));
    assert!(count(half, "triangle_count") <= 256 && count(tenth, "triangle_count") <= 51);
    assert_eq!([full, half, tenth, back].map(|level| count(level, "frame_count")), [0, 5, 5, 5]);
    assert_eq!((count(full, "changed_index_count"), count(full, "step_count")), (0, 0));
    assert_eq!(count(back, "step_count"), count(back, "split_count") - count(tenth, "split_count"));
    for level in [half, tenth, back] {
        assert!(count(level, "changed_range_count") >= 5 && count(level, "changed_index_count") > 0);
    }
    // The strips of the first level are those of the stripifier.
    let alone = bench.json("strip ball.striata --strips greedy");
    assert_eq!(full["index_count"], alone["index_count"]);
    let text = bench.run("strip ball.striata --levels 100%,50%").success();
    let text = String::from_utf8_lossy(&text.get_output().stdout).into_owned();
    assert!(text.contains("ranges per move") && text.contains("repaired in 60 moves"), "{text}");
}

#[test]
fn each_level_is_written_with_its_strips() {
    let bench = Workbench::with_ball();
    // A mesh is simplified first, as `build` does it.
    let report = bench.json("strip sphere.obj --levels 40%,100%,8% -o s-{}.glb --repair strips");
    assert_eq!(report["repair"], "strips");
    for level in levels(&report) {
        let name = level["path"].as_str().expect("a path");
        let written = striata_io::read(bench.path(name)).expect("the output is readable");
        assert_eq!(written.triangle_count() as u64, count(level, "triangle_count"), "{name}");
        let document = gltf_of(&bench, name);
        assert_eq!(document["meshes"][0]["primitives"][0]["mode"], 5, "{name} has a strip");
    }
    bench.run("extract ball.striata -o level.ply --triangles 40% --quiet").success();
    let [a, b] = ["s-40.glb", "level.ply"].map(|name| {
        let mesh = striata_io::read(bench.path(name)).expect("readable");
        canonical_triangles(&mesh.triangles).len()
    });
    assert_eq!(a, b);
}

fn gltf_of(bench: &Workbench, name: &str) -> Value {
    let bytes = bench.read(name);
    let length = u32::from_le_bytes(bytes[12..16].try_into().expect("four bytes")) as usize;
    serde_json::from_slice(&bytes[20..20 + length]).expect("JSON")
}

#[test]
fn wrong_levels_are_refused_with_a_hint() {
    let bench = Workbench::with_ball();
    bench
        .run("build sphere.obj -o free.striata --models patterns --order hausdorff --retriangulation free")
        .success();
    for (arguments, message) in [
        ("strip ball.striata --levels half", "is not a level"),
        ("strip ball.striata --levels 50% -o s.glb", "-o 's-{}.glb'"),
        ("strip ball.striata --levels 50%,50% -o s-{}.glb", "several levels"),
        ("strip ball.striata --levels 50% -o s-{}.obj", "cannot contain strips"),
        ("strip ball.striata --frames 5", "--levels"),
        ("strip ball.striata --levels 50% --frames 0", "1..=100000"),
        ("strip ball.striata --levels 50% --repair none", "strips"),
        ("strip free.striata --levels 50%", "hint: build the file again without --retriangulation free"),
        ("strip none.ply --levels 50%", "none.ply"),
    ] {
        let found = bench.refused(arguments);
        assert!(found.contains(message), "{arguments}: {found}");
    }
    assert!(!bench.names().iter().any(|name| name.starts_with("s-")));
}
