//! Paged files: built within little memory, in tasks, resumed after a kill, and read in parts.

use std::fs;
use std::process::Stdio;
use std::time::Duration;

use serde_json::Value;
use striata::mesh::IndexedMesh;

use crate::workbench::Workbench;

const BUILD: &str = "build shape:terrain:260 --cell 4000 --threads 2";

fn mesh(bench: &Workbench, name: &str) -> IndexedMesh {
    striata_io::read(bench.path(name)).expect("the output is readable")
}

fn json(bench: &Workbench, arguments: &str) -> Value {
    let output = bench.run(&format!("{arguments} --json")).success();
    serde_json::from_slice(&output.get_output().stdout).expect("a report")
}

fn stderr(assert: &assert_cmd::assert::Assert) -> String {
    String::from_utf8_lossy(&assert.get_output().stderr).into_owned()
}

#[test]
fn levels_views_and_boxes_read_only_some_pages() {
    let bench = Workbench::new();
    let built = json(&bench, &format!("{BUILD} -o t.striata --memory 500MB"));
    assert_eq!(built["triangles"], 2 * 259 * 259);
    assert!(!bench.path("t.striata.work").exists());
    let info = json(&bench, "info t.striata");
    assert_eq!((&info["kind"], &info["triangle_count"]), (&"paged".into(), &(2 * 259 * 259).into()));
    assert_eq!(
        info["page_count"],
        info["levels"].as_array().unwrap().iter().map(|l| l["pages"].as_u64().unwrap()).sum::<u64>()
    );
    let pages = info["page_count"].as_u64().unwrap();
    let level = json(&bench, "extract t.striata -o level.ply --triangles 1000");
    assert!(level["pages"]["read"].as_u64().unwrap() < pages / 2, "{level}");
    assert!((990..=1000).contains(&mesh(&bench, "level.ply").triangle_count()));
    let arguments = "--eye 20,20,60 --look-at 30,30,0 --up 0,0,1 --pixels 2 --viewport 640x480";
    let view = json(&bench, &format!("extract t.striata -o view.ply {arguments}"));
    let (read, shown) = (view["pages"]["read"].as_f64().unwrap(), view["pages"]["shown"].as_f64().unwrap());
    assert!(read < pages as f64 && read <= 2.0 * shown, "{view}");
    let limited = json(&bench, &format!("extract t.striata -o limited.ply {arguments} --triangles 500"));
    assert!(limited["triangle_count"].as_u64().unwrap() <= 500, "{limited}");
    json(&bench, "extract t.striata -o box.ply --detail-box 0,0,-1000,20,20,1000");
    let detailed = mesh(&bench, "box.ply");
    let inside = |t: &&[u32; 3]| {
        t.iter()
            .all(|&v| detailed.positions[v as usize][0] <= 20.0 && detailed.positions[v as usize][1] <= 20.0)
    };
    assert_eq!(detailed.triangles.iter().filter(inside).count(), 2 * 20 * 20);
    bench.run("extract t.striata -o level-{}.ply --levels 10%,1%").success();
    bench.run("convert t.striata full.ply").success();
    assert_eq!(mesh(&bench, "full.ply").triangle_count(), 2 * 259 * 259);
    // Two triangles per pixel are enough; percentages are those of the whole mesh, however much is read.
    let triangles = |line: &str| {
        let report = bench.json(&format!("render t.striata -o t.png --software --size 200x200 {line}"));
        let shown = report["levels"].as_array().unwrap().iter();
        shown.map(|level| level["triangle_count"].as_u64().unwrap()).collect::<Vec<_>>()
    };
    assert!((79_990..=80_000).contains(&triangles("")[0]));
    let shares = triangles("--levels 100%,10%,1%");
    assert!((79_990..=80_000).contains(&shares[0]), "{shares:?}");
    assert!((13_410..=13_416).contains(&shares[1]) && (1_335..=1_341).contains(&shares[2]), "{shares:?}");
    assert!((66_000..70_000).contains(&triangles("--detail 0.5")[0]));
    bench
        .run(&format!("render t.striata -o v.png --software --size 200x200 {}", "--eye 20,20,60 --up 0,0,1"))
        .success();
    assert!(bench.path("t.png").exists() && bench.path("v.png").exists());
}

#[test]
fn several_files_are_one_mesh_and_a_folder_has_one_object_per_page() {
    let bench = Workbench::with_ball();
    bench.run("build shape:terrain:130 -o a.striata --paged --cell 4000").success();
    bench.run("convert a.striata a.ply").success();
    // A second tile, which shares no vertex with the first.
    let mut tile = mesh(&bench, "a.ply");
    tile.positions.iter_mut().for_each(|p| p[0] += 129.0);
    striata_io::write(bench.path("b.ply"), &tile, &striata_io::WriteOptions::default()).unwrap();
    bench.run("build a.ply b.ply -o both --cell 4000").success();
    assert!(bench.path("both/head.striata").is_file());
    let info = json(&bench, "info both");
    assert_eq!(info["triangle_count"], 2 * 2 * 129 * 129);
    bench.run("extract both -o both.ply --triangles 2000").success();
}

#[test]
fn a_killed_build_goes_on_with_the_same_bytes() {
    let bench = Workbench::new();
    bench.run("build shape:terrain:700 --cell 4000 -o whole.striata").success();
    let expected = fs::read(bench.path("whole.striata")).unwrap();
    let arguments = "build shape:terrain:700 --cell 4000 -o killed.striata --threads 1";
    for millis in [150, 300, 450] {
        let mut command = bench.command(arguments);
        let program = command.get_program().to_owned();
        let mut process = std::process::Command::new(program)
            .args(command.get_args())
            .current_dir(bench.path("."))
            .stderr(Stdio::null())
            .stdout(Stdio::null())
            .spawn()
            .unwrap();
        command.env("COLUMNS", "80");
        std::thread::sleep(Duration::from_millis(millis));
        // On Unix this is the signal that cannot be caught.
        process.kill().unwrap();
        process.wait().unwrap();
        if !bench.path("killed.striata").exists() {
            assert!(bench.path("killed.striata.work").exists());
        }
    }
    let report = json(&bench, arguments);
    assert!(fs::read(bench.path("killed.striata")).unwrap() == expected, "{report}");
}

#[test]
fn tasks_run_one_by_one() {
    let bench = Workbench::new();
    bench.run(&format!("{BUILD} -o whole.striata")).success();
    let plan = json(&bench, "plan shape:terrain:260 --cell 4000 -o tasks.striata");
    let count = plan["tasks"].as_u64().unwrap();
    let early = bench.run(&format!("run tasks.striata.work --task {}", count - 1)).failure();
    assert!(stderr(&early).contains("needs the result of task 0"), "{}", stderr(&early));
    let unknown = bench.run(&format!("run tasks.striata.work --task {count}")).failure();
    assert!(stderr(&unknown).contains("does not exist"), "{}", stderr(&unknown));
    for task in 0..count {
        bench.run(&format!("run tasks.striata.work/plan.json --task {task}")).success();
    }
    let bytes = |name: &str| fs::read(bench.path(name)).unwrap();
    assert!(bytes("tasks.striata") == bytes("whole.striata"));
    // All tasks are done, so nothing is left to do.
    bench.run("run tasks.striata.work").success();
}

#[test]
fn mistakes_have_messages() {
    let bench = Workbench::new();
    let cases = [
        ("build shape:terrain:one -o a.striata", "not a generated input"),
        ("build shape:terrain:100 -o a.striata --cell 10", "--cell is 10"),
        ("build shape:terrain:100 -o a.striata --memory 4", "less than 1 MB"),
        ("build shape:terrain:100 -o a.striata --memory lots", "is not a size"),
        ("build missing.ply -o a.striata --paged", "missing.ply"),
        ("build shape:terrain:100 -o missing/a.striata", "does not exist"),
        ("run missing.work", "missing.work"),
        ("plan broken.ply -o a.striata", "broken.ply: line 1"),
    ];
    bench.write("broken.ply", "x");
    for (arguments, expected) in cases {
        let message = stderr(&bench.run(arguments).failure());
        assert!(message.contains(expected), "{arguments}: {message}");
    }
    assert!(!bench.path("a.striata.work").exists());
    bench.run("build shape:terrain:100 -o a.striata --cell 4000").success();
    let model = bench.run("extract a.striata -o a.ply --triangles 100 --model mts").failure();
    assert!(stderr(&model).contains("no models"));
    bench.run("plan shape:terrain:100 -o b.striata --cell 4000").success();
    let other = bench.run("build shape:terrain:101 -o b.striata --cell 4000").failure();
    assert!(stderr(&other).contains("--restart"), "{}", stderr(&other));
    bench.run("build shape:terrain:101 -o b.striata --cell 4000 --restart").success();
    let mut bytes = fs::read(bench.path("a.striata")).unwrap();
    let last = bytes.len() - 10;
    bytes[last] ^= 1;
    fs::write(bench.path("damaged.striata"), &bytes).unwrap();
    let damaged = bench.run("convert damaged.striata a.ply").failure();
    assert!(stderr(&damaged).contains("checksum"), "{}", stderr(&damaged));
    fs::write(bench.path("short.striata"), &bytes[..40]).unwrap();
    assert!(stderr(&bench.run("info short.striata").failure()).contains("cut off"));
}

/// A bumpy grid of `n` by `n` points as PLY with doubles.
fn terrain(n: usize, place: impl Fn(usize, usize) -> [f64; 3]) -> Vec<u8> {
    let mut text = format!(
        "ply\nformat ascii 1.0\nelement vertex {}\nproperty double x\nproperty double y\nproperty double z\n\
         element face {}\nproperty list uchar int vertex_indices\nend_header\n",
        n * n,
        2 * (n - 1) * (n - 1)
    );
    for i in 0..n * n {
        let [x, y, z] = place(i % n, i / n);
        text += &format!("{x} {y} {z}\n");
    }
    for i in (0..n * (n - 1)).filter(|i| i % n < n - 1) {
        text += &format!("3 {i} {} {}\n3 {} {} {}\n", i + 1, i + n, i + 1, i + n + 1, i + n);
    }
    text.into_bytes()
}

fn bump(x: usize, y: usize) -> f64 {
    40.0 * (x as f64 / 9.0).sin() * (y as f64 / 13.0).cos() + ((x * 7 + y * 13) % 11) as f64
}

/// Number of edges that one triangle has.
fn border_edge_count(mesh: &IndexedMesh) -> usize {
    let mut edges = std::collections::BTreeMap::<[u32; 2], u32>::new();
    for t in &mesh.triangles {
        for i in 0..3 {
            let (a, b) = (t[i], t[(i + 1) % 3]);
            *edges.entry([a.min(b), a.max(b)]).or_default() += 1;
        }
    }
    edges.values().filter(|&&count| count == 1).count()
}

#[test]
fn borders_that_differ_a_little_are_joined() {
    let bench = Workbench::new();
    // Two exports of one survey differ by up to 0.0002 along their common border.
    let noise = |seed: usize| ((seed * 7919 + 13) % 401) as f64 * 1e-6 - 2e-4;
    let tile = |west: usize, seed: usize| {
        terrain(50, move |x, y| {
            let is_common = west + x == 49;
            let off = |axis: usize| if is_common { noise(seed + 3 * y + axis) } else { 0.0 };
            [(west + x) as f64 + off(0), y as f64 + off(1), bump(west + x, y) + off(2)]
        })
    };
    bench.write("a.ply", tile(0, 1));
    bench.write("b.ply", tile(49, 1000));
    let joined = |flags: &str| {
        bench.run(&format!("build a.ply b.ply -o ab.striata --quiet {flags}")).success();
        bench.run("extract ab.striata -o ab.ply --ratio 1 --quiet").success();
        border_edge_count(&mesh(&bench, "ab.ply"))
    };
    assert_eq!(joined("--exact"), 8 * 49);
    assert!(joined("") > 6 * 49, "rounding joins only some");
    for distance in ["0.0008", "0.001", "0.05"] {
        assert_eq!(joined(&format!("--weld-distance {distance}")), 6 * 49, "{distance}");
    }
    assert_eq!(joined("--weld-distance 0.001 --exact"), 6 * 49);
    let near = bench.run("build a.ply b.ply -o ab.striata --weld-distance 0.001").success();
    assert!(!stderr(&near).contains("the median edge"), "{}", stderr(&near));
    let far = bench.run("build a.ply b.ply -o ab.striata --weld-distance 30").success();
    assert!(stderr(&far).contains("triangles vanish"), "{}", stderr(&far));
}

#[test]
fn rounding_keeps_vertices_apart_or_is_refused() {
    let bench = Workbench::new();
    let count = |name: &str| {
        bench.run(&format!("build {name} --paged -o t.striata --quiet")).success();
        bench.run("extract t.striata -o full.ply --ratio 1 --quiet").success();
        mesh(&bench, "full.ply").vertex_count()
    };
    // Degrees, with heights in meters.
    bench.write(
        "degrees.ply",
        terrain(60, |x, y| [138.0 + x as f64 / 1200.0, 35.0 + y as f64 / 1200.0, 9.0 * bump(x, y)]),
    );
    assert_eq!(count("degrees.ply"), 3600);
    // One vertex far away.
    let stray = |x, y| if (x, y) == (30, 30) { 1e12 } else { bump(x, y) };
    bench.write("stray.ply", terrain(60, |x, y| [x as f64 * 30.0, y as f64 * 30.0, stray(x, y)]));
    assert_eq!(count("stray.ply"), 3600);
    // A part that is a thousand times finer than the rest.
    let fine = |x: usize| if x < 6 { x as f64 * 1e-4 } else { x as f64 * 10.0 };
    bench.write("fine.ply", terrain(60, |x, y| [fine(x), y as f64 * 10.0, 0.0]));
    let message = stderr(&bench.run("build fine.ply --paged -o fine.striata").failure());
    assert!(message.contains("merges 300 of 3600 vertices that are apart"), "{message}");
    assert!(message.contains("hint: ") && message.contains("--exact"), "{message}");
    assert!(!bench.path("fine.striata").exists() && !bench.path("fine.striata.work").exists());
    bench.run("build fine.ply --paged -o fine.striata --allow-merging --quiet").success();
    bench.run("build fine.ply --exact -o fine.striata --quiet").success();
}

#[test]
fn options_hold_for_paged_files_or_are_refused() {
    let bench = Workbench::new();
    bench.write("grid.ply", terrain(90, |x, y| [x as f64, y as f64, bump(x, y)]));
    let border = |flags: &str| {
        bench.run(&format!("build grid.ply --cell 2000 {flags} -o t.striata --quiet")).success();
        bench.run("extract t.striata -o level.ply --triangles 1500 --quiet").success();
        border_edge_count(&mesh(&bench, "level.ply"))
    };
    assert_eq!(border("--lock-boundary"), 4 * 89);
    assert!(border("") < 300);
    for flag in [
        "--certify",
        "--order hausdorff",
        "--cost accumulated",
        "--models fans",
        "--stream",
        "--strips cheapest",
        "--pair-distance 1",
    ] {
        let name = flag.split(' ').next().unwrap().replace("--stream", "--models");
        let message = stderr(&bench.run(&format!("build grid.ply --paged {flag} -o no.striata")).failure());
        assert!(message.contains(&format!("a paged file does not support {name}")), "{flag}: {message}");
        assert!(!bench.path("no.striata").exists(), "{flag}");
    }
}

#[test]
fn the_base_mesh_of_a_paged_file_is_limited() {
    let bench = Workbench::new();
    bench.write("grid.ply", terrain(90, |x, y| [x as f64, y as f64, bump(x, y)]));
    let built = |flags: &str| {
        let built = json(&bench, &format!("build grid.ply --cell 2000 {flags} -o t.striata"));
        let base = json(&bench, "extract t.striata -o base.ply --triangles 1");
        assert_eq!(base["triangle_count"], built["base_triangles"], "{flags}");
        (
            built["base_triangles"].as_u64().unwrap(),
            base["error"].as_f64().unwrap(),
            built["shortfall"].clone(),
        )
    };
    let full = 2 * 89 * 89;
    for (flags, most) in [("--base 3000", 3000), ("--base 700", 700), ("--base 10%", full / 10)] {
        let (count, _, shortfall) = built(flags);
        assert!((most - 2..=most).contains(&count) && shortfall.is_null(), "{flags}: {count} {shortfall}");
    }
    let (count, error, _) = built("--max-error 2");
    assert!(error <= 2.0 && error > 1.0 && count < full, "{count} {error}");
    let (_, error, _) = built("--max-error 1%");
    assert!(error <= 1.55 && error > 1.0, "{error}");
    let (count, _, shortfall) = built("--max-error 2 --base 10");
    assert!(
        count > 10 && shortfall.as_str().unwrap().contains("would exceed the error limit"),
        "{shortfall}"
    );
    let strict = "build grid.ply --paged --base 10 --lock-boundary --strict -o no.striata";
    let message = stderr(&bench.run(strict).failure());
    assert!(message.contains("--strict: the base mesh has") && message.contains("at most 10"), "{message}");
    assert!(!bench.path("no.striata").exists() && !bench.path("no.striata.work").exists());
}

/// A plan has the limits that `build` has.
#[test]
fn the_base_mesh_of_a_plan_is_limited() {
    let bench = Workbench::new();
    bench.write("grid.ply", terrain(90, |x, y| [x as f64, y as f64, bump(x, y)]));
    for (name, flags) in [("a", "--base 700"), ("b", "--max-error 2")] {
        json(&bench, &format!("plan grid.ply --cell 2000 {flags} -o {name}.striata"));
        bench.run(&format!("run {name}.striata.work")).success();
        json(&bench, &format!("build grid.ply --cell 2000 {flags} -o built.striata"));
        assert!(bench.read(&format!("{name}.striata")) == bench.read("built.striata"), "{flags}");
    }
    json(&bench, "plan grid.ply --base 1 --max-error 0.001 --strict -o c.striata");
    let message = stderr(&bench.run("run c.striata.work").failure());
    assert!(message.contains("at most 1"), "{message}");
}

/// Number of triangles that do not face up.
fn turned_count(mesh: &IndexedMesh) -> usize {
    let area = |t: &&[u32; 3]| {
        let [a, b, c] = t.map(|v| mesh.positions[v as usize].map(f64::from));
        (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
    };
    mesh.triangles.iter().filter(|t| area(t) <= 0.0).count()
}

#[test]
fn levels_of_terrain_are_height_fields() {
    let bench = Workbench::new();
    let steep = |x: usize, y: usize| (if (x / 9 + y / 7).is_multiple_of(2) { 300 } else { 0 }) + x * y % 97;
    let heights: Vec<u8> = (0..61 * 61).flat_map(|i| (steep(i % 61, i / 61) as i16).to_be_bytes()).collect();
    bench.write("N47E011.hgt", heights);
    let turned = |line: &str| {
        let shares = ["50%", "20%", "5%", "1%"];
        bench.run(&format!("{line} -o level-{{}}.ply --levels {}", shares.join(","))).success();
        shares.map(|share| turned_count(&mesh(&bench, &format!("level-{}.ply", &share[..share.len() - 1]))))
    };
    let count = |line: &str| turned(line).iter().sum::<usize>();
    assert_eq!(turned("simplify N47E011.hgt"), [0; 4]);
    assert_eq!(turned("simplify N47E011.hgt --order hausdorff"), [0; 4]);
    assert_eq!(turned("simplify N47E011.hgt --placement optimal"), [0; 4]);
    bench.run("build N47E011.hgt --cell 2000 -o t.striata --quiet").success();
    assert_eq!(turned("extract t.striata"), [0; 4]);
    // Any mesh may be one.
    bench.write("grid.ply", terrain(61, |x, y| [x as f64, y as f64, 0.1 * steep(x, y) as f64]));
    assert!(count("simplify grid.ply") > 0);
    assert_eq!(turned("simplify grid.ply --keep-height-field"), [0; 4]);
    bench.run("build grid.ply --paged --keep-height-field -o t.striata --quiet").success();
    assert_eq!(turned("extract t.striata"), [0; 4]);
}

#[test]
fn rasters_are_inputs_like_any_other() {
    let bench = Workbench::new();
    let heights: Vec<u8> =
        (0..61 * 61).flat_map(|i| (bump(i % 61, i / 61) as i16 * 20 + 900).to_be_bytes()).collect();
    bench.write("N47E011.hgt", heights);
    assert_eq!(json(&bench, "info N47E011.hgt")["triangle_count"], 7200);
    assert_eq!(json(&bench, "simplify N47E011.hgt -o tin.ply --ratio 0.1")["triangle_count"], 720);
    assert_eq!(mesh(&bench, "tin.ply").triangle_count(), 720);
    for line in [
        "convert N47E011.hgt full.glb",
        "encode N47E011.hgt -o terrain.stri",
        "render N47E011.hgt -o terrain.png --size 80x60 --flat",
        "strip N47E011.hgt",
    ] {
        bench.run(line).success();
    }
    assert_eq!(mesh(&bench, "full.glb").vertex_count(), 61 * 61);
    // HGT files have one sample for voids; the user may name another.
    let all = json(&bench, "info N47E011.hgt")["vertex_count"].as_u64().unwrap();
    let named = mesh(&bench, "full.glb").positions[0][2];
    for line in ["simplify N47E011.hgt -o holes.ply --detail 1", "convert N47E011.hgt holes.ply"] {
        let holes = json(&bench, &format!("{line} --nodata {named}"))["vertex_count"].as_u64().unwrap();
        assert!(holes < all, "{line}: {holes} of {all}");
    }
    let height = |line: &str| {
        bench.run(&format!("{line} --quiet")).success();
        mesh(&bench, "scaled.ply").positions.iter().map(|p| p[2]).fold(f32::MIN, f32::max)
    };
    let plain = height("convert N47E011.hgt scaled.ply");
    assert_eq!(height("convert N47E011.hgt scaled.ply --z-scale 3"), 3.0 * plain);
    assert_eq!(height("simplify N47E011.hgt -o scaled.ply --detail 1 --z-scale 3"), 3.0 * plain);
    bench.run("build N47E011.hgt -o pages.striata --quiet").success();
    for line in [
        "build N47E011.hgt -o other.striata",
        "plan N47E011.hgt -o third.striata",
        "extract pages.striata -o level.ply --triangles 500",
        "decode terrain.stri -o level.ply --ratio 0.5",
        "render N47E011.hgt -o terrain.png --size 80x60 --flat",
        "simplify pages.striata -o level.ply --ratio 0.5",
        "encode N47E011.hgt -o streams.glb",
        "distance N47E011.hgt full.glb --samples 1000",
        "strip N47E011.hgt",
        "strip N47E011.hgt --levels 100%,50%",
        "convert full.glb other.glb",
        "build full.glb -o scene.striata",
        "simplify full.glb -o level.glb --ratio 0.5",
        "extract scene.striata -o level.glb --ratio 0.5",
    ] {
        assert_eq!(json(&bench, line)["georeference"]["epsg"], 4326, "{line}");
    }
    // The triangles of such a file are a coarse level.
    bench.run("encode N47E011.hgt -o streams.glb").success();
    let message = stderr(&bench.run("build streams.glb --paged -o s.striata").failure());
    assert!(message.contains("streams of finer levels"), "{message}");
    let message = stderr(&bench.run("info full.glb --nodata -9999").failure());
    assert!(message.contains("--nodata is for rasters of heights"), "{message}");
    let message = stderr(&bench.run("info full.glb --z-scale 2").failure());
    assert!(message.contains("--z-scale is for rasters of heights"), "{message}");
    let message = stderr(&bench.run("info N47E011.hgt --z-scale 0").failure());
    assert!(message.contains("--z-scale must be a"), "{message}");
    let message = stderr(&bench.run("info none.tif").failure());
    assert!(message.contains("none.tif"), "{message}");
}

#[test]
fn a_changed_input_is_noticed() {
    let bench = Workbench::new();
    let grid = |height: f64| terrain(70, move |x, y| [x as f64, y as f64, height + bump(x, y)]);
    bench.write("grid.ply", grid(10.0));
    bench.run("plan grid.ply -o t.striata --cell 1000 --quiet").success();
    // A copy with another time is the same file.
    bench.write("grid.ply", grid(10.0));
    bench.run("run t.striata.work --quiet").success();
    bench.run("plan grid.ply -o u.striata --cell 1000 --quiet").success();
    bench.write("grid.ply", grid(11.0));
    let message = stderr(&bench.run("run u.striata.work").failure());
    assert!(message.contains("grid.ply: the file has changed since the build was planned"), "{message}");
    let message = stderr(&bench.run("build grid.ply --cell 1000 -o u.striata").failure());
    assert!(message.contains("has changed") && message.contains("--restart"), "{message}");
    assert!(!bench.path("u.striata").exists());
    bench.run("build grid.ply --cell 1000 -o u.striata --restart --quiet").success();
    assert!(!bench.path("u.striata.work").exists());
}

/// Neither the time of the file nor its size tell that it is another one.
#[test]
fn a_changed_input_of_the_same_time_is_noticed() {
    let bench = Workbench::new();
    let grid = |height: f64| terrain(70, move |x, y| [x as f64, y as f64, height + bump(x, y)]);
    bench.write("grid.ply", grid(10.0));
    let time = fs::metadata(bench.path("grid.ply")).unwrap().modified().unwrap();
    bench.run("plan grid.ply -o t.striata --cell 1000 --quiet").success();
    bench.write("grid.ply", grid(11.0));
    fs::File::options().write(true).open(bench.path("grid.ply")).unwrap().set_modified(time).unwrap();
    if cfg!(unix) {
        let message = stderr(&bench.run("run t.striata.work").failure());
        assert!(message.contains("grid.ply: the file has changed since the build was planned"), "{message}");
    }
    // So are the buffers of glTF.
    bench.run("convert grid.ply grid.gltf --quiet").success();
    bench.run("plan grid.gltf -o u.striata --cell 1000 --quiet").success();
    let mut bytes = bench.read("grid.bin");
    bytes[2] ^= 1;
    bench.write("grid.bin", bytes);
    let message = stderr(&bench.run("run u.striata.work").failure());
    assert!(message.contains("grid.bin: the file has changed since the build was planned"), "{message}");
}

/// Materials and images of an input are part of the result too.
#[test]
fn a_changed_image_or_library_is_noticed() {
    let bench = Workbench::new();
    let image = |gray: u8| {
        let mut bytes = Vec::new();
        let mut encoder = png::Encoder::new(&mut bytes, 1, 1);
        encoder.set_color(png::ColorType::Grayscale);
        encoder.write_header().unwrap().write_image_data(&[gray]).unwrap();
        bytes
    };
    bench.write(
        "box.obj",
        "mtllib box.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nusemtl a\nf 1/1 2/2 3/3\n",
    );
    bench.write("box.mtl", "newmtl a\nKd 1 1 1\nmap_Kd skin.png\n");
    bench.write("skin.png", image(1));
    bench.run("convert box.obj glued.gltf --quiet").success();
    bench.write(
        "named.ply",
        "ply\nformat ascii 1.0\ncomment TextureFile skin.png\nelement vertex 3\nproperty float x\n\
         property float y\nproperty float z\nproperty float s\nproperty float t\nelement face 1\n\
         property list uchar int vertex_indices\nend_header\n0 0 0 0 0\n1 0 0 1 0\n0 1 0 0 1\n3 0 1 2\n",
    );
    for (input, changed) in [
        ("box.obj", "skin.png"),
        ("box.obj", "box.mtl"),
        ("glued.gltf", "skin.png"),
        ("named.ply", "skin.png"),
    ] {
        bench.run(&format!("plan {input} -o t.striata")).success();
        let before = bench.read(changed);
        match changed {
            "box.mtl" => bench.write(changed, "newmtl a\nKd 1 1 0\nmap_Kd skin.png\n"),
            _ => bench.write(changed, image(2)),
        }
        let message = stderr(&bench.run("run t.striata.work").failure());
        let expected = format!("{changed}: the file has changed since the build was planned");
        assert!(message.contains(&expected), "{input}: {message}");
        bench.write(changed, before);
        bench.run("run t.striata.work --quiet").success();
    }
}

#[test]
fn two_builds_do_not_share_a_folder() {
    let bench = Workbench::new();
    fs::create_dir(bench.path("t.striata.work")).unwrap();
    let lock = fs::File::create(bench.path("t.striata.work/lock")).unwrap();
    lock.lock().unwrap();
    for flags in ["", "--restart"] {
        let message = stderr(&bench.run(&format!("{BUILD} -o t.striata {flags}")).failure());
        assert!(message.contains("another build is working in this folder"), "{message}");
    }
    drop(lock);
    bench.run(&format!("{BUILD} -o t.striata --quiet")).success();
    assert!(!bench.path("t.striata.work").exists());
}

#[test]
fn the_result_does_not_depend_on_the_folder() {
    let bench = Workbench::new();
    fs::create_dir(bench.path("sub")).unwrap();
    for name in ["grid.ply", "sub/grid.ply"] {
        bench.write(name, terrain(50, |x, y| [x as f64, y as f64, bump(x, y)]));
        bench.run(&format!("build {name} --paged -o {name}.striata --quiet")).success();
    }
    assert!(bench.read("grid.ply.striata") == bench.read("sub/grid.ply.striata"));
}
