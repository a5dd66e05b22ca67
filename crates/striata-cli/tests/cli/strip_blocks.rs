//! `strip --block-triangles`: the same mesh as in memory, complete files or none, and errors with hints.

use serde_json::Value;
use striata::mesh::{IndexedMesh, canonical_triangles};

use crate::workbench::{Workbench, assert_keys};

const KEYS: [&str; 22] = [
    "algorithm",
    "seed",
    "vertex_count",
    "triangle_count",
    "degenerate_triangle_count",
    "strip_count",
    "swap_count",
    "restart_count",
    "index_count",
    "indices_per_triangle",
    "longest_strip",
    "block_triangles",
    "block_count",
    "peak_block_triangles",
    "peak_window_triangles",
    "peak_held_triangles",
    "carried_count",
    "written_index_count",
    "read_secs",
    "stripify_secs",
    "secs",
    "peak_rss_bytes",
];

fn count(report: &Value, key: &str) -> u64 {
    report[key].as_u64().unwrap_or_else(|| panic!("{key} of {report}"))
}

/// Creates a workbench with a sphere as binary PLY.
fn with_sphere() -> Workbench {
    let bench = Workbench::with_ball();
    bench.run("convert sphere.obj sphere.ply --quiet").success();
    bench
}

fn mesh(bench: &Workbench, name: &str) -> IndexedMesh {
    striata_io::read(bench.path(name)).expect("the output is readable")
}

#[test]
fn blocks_write_the_mesh_that_they_read() {
    let bench = with_sphere();
    let sphere = mesh(&bench, "sphere.ply");
    let before = bench.names();
    for (out, parted_by) in [("strips.ply", 1), ("strips.glb", 3)] {
        let report = bench.json(&format!("strip sphere.ply --block-triangles 200 -o {out}"));
        assert_keys(&report, &KEYS);
        let strips = count(&report, "strip_count");
        let indices = count(&report, "triangle_count") + 3 * strips - 1 + count(&report, "swap_count");
        assert_eq!(count(&report, "index_count"), indices, "{report}");
        assert!(count(&report, "block_count") > 1 && count(&report, "peak_block_triangles") <= 200);
        let unparted = indices - (strips - 1);
        let written = count(&report, "written_index_count");
        assert!((unparted..=unparted + parted_by * (strips - 1)).contains(&written), "{report}");
        let back = mesh(&bench, out);
        assert_eq!(back.positions, sphere.positions, "{out}");
        assert_eq!(canonical_triangles(&back.triangles), canonical_triangles(&sphere.triangles), "{out}");
    }
    let mut after = before;
    after.extend(["strips.glb".to_owned(), "strips.ply".to_owned()]);
    after.sort();
    let mut names = bench.names();
    names.sort();
    assert_eq!(names, after, "temporary files are gone");
}

#[test]
fn blocks_of_every_streamed_format_are_the_same_mesh() {
    let bench = with_sphere();
    let plain = bench.json("strip sphere.ply --block-triangles 200");
    bench.run("convert sphere.ply text.ply --ascii --quiet").success();
    bench.run("convert sphere.ply ball.stl --quiet").success();
    for output in ["ball.ply.zst", "ball.off", "ball.glb", "ball.gltf"] {
        bench.run(&format!("convert sphere.ply {output} --quiet")).success();
    }
    for input in ["text.ply", "sphere.obj", "ball.stl", "ball.ply.zst", "ball.off", "ball.glb", "ball.gltf"] {
        let report = bench.json(&format!("strip {input} --block-triangles 200 -o strips.ply"));
        for key in ["triangle_count", "block_count", "vertex_count"] {
            assert_eq!(count(&report, key), count(&plain, key), "{input}: {key}");
        }
        let back = mesh(&bench, "strips.ply");
        assert_eq!(back.triangle_count(), mesh(&bench, "sphere.ply").triangle_count(), "{input}");
    }
    let report = bench.json("strip shape:terrain:300 --block-triangles 20000");
    assert_eq!((count(&report, "vertex_count"), count(&report, "triangle_count")), (90_000, 2 * 299 * 299));
}

#[test]
fn without_an_output_blocks_are_only_reported() {
    let bench = with_sphere();
    let before = bench.names();
    let report = bench.json("strip sphere.ply --block-triangles 200 --strips greedy");
    assert_eq!(report["written_index_count"], Value::Null);
    assert_eq!(bench.names(), before);
    let text = bench.run("strip sphere.ply --block-triangles 200").success();
    let text = String::from_utf8_lossy(&text.get_output().stdout).into_owned();
    assert!(text.contains("peak triangles per window"), "{text}");
}

#[test]
fn unsupported_options_of_blocks_are_refused_with_a_hint() {
    let bench = with_sphere();
    bench.write("ball.striata", b"STRIATA\0 and more");
    for (arguments, message) in [
        ("strip ball.striata --block-triangles 500", "cannot be read block by block"),
        ("strip ball.striata --block-triangles 500", "`striata convert IN OUT.ply`"),
        ("strip shape:torus --block-triangles 500", "hint: use shape:terrain:N, or write a file first"),
        ("strip shape:terrain:x --block-triangles 500", "shape:terrain:SAMPLES_PER_SIDE"),
        ("strip sphere.ply --block-triangles 500 --levels 50%", "cannot be used with"),
        ("strip sphere.ply --block-triangles 500 -o s.obj", "hint: write .glb or .ply"),
        ("strip sphere.ply --block-triangles 500 -o -", "hint: name an output file"),
        ("strip - --block-triangles 500", "hint: name a .ply, .stl, .obj, .off or .glb file"),
        ("strip sphere.ply --block-triangles 500 --weld", "hint: remove --weld"),
        ("strip sphere.ply --block-triangles 500 --budget 1", "hint: remove --budget"),
        (
            "strip sphere.ply --block-triangles 500 --strips greedy+greedy",
            "--block-triangles takes a single stripifier",
        ),
        ("strip sphere.ply --block-triangles 5", "must be a number from 100"),
        ("strip none.ply --block-triangles 500", "none.ply"),
        ("strip sphere.ply --block-triangles 500 -o no/such/folder.glb", "no/such"),
    ] {
        let found = bench.refused(arguments);
        assert!(found.contains(message), "{arguments}: {found}");
    }
    bench.write("cut.ply", &bench.read("sphere.ply")[..3000]);
    assert!(bench.refused("strip cut.ply --block-triangles 500 -o cut.glb").contains("cut.ply: byte "));
    assert!(!bench.names().contains(&"cut.glb".to_owned()));
}
