//! Behavior of each verb, and the keys of its report.

use crate::workbench::{Workbench, assert_keys, asset};

#[test]
fn build_reports_its_result() {
    let bench = Workbench::with_ball();
    let report = bench.json("build sphere.obj -o again.striata");
    assert_keys(
        &report,
        &[
            "input.vertex_count",
            "input.triangle_count",
            "input.position_count",
            "step_count",
            "base.vertex_count",
            "base.triangle_count",
            "error_max",
            "models.lodstrips.bytes",
            "models.lodstrips.bytes_per_vertex",
            "strips.algorithm",
            "strips.triangle_count",
            "strips.component_count",
            "strips.acmr_16",
            "strips.atvr_16",
            "strips.secs",
            "strips.strip_count",
            "strips.swap_count",
            "strips.index_count",
            "strips.indices_per_triangle",
            "strips.longest_strip",
            "output_bytes",
            "phases.read",
            "phases.weld",
            "phases.simplify",
            "phases.strip",
            "phases.models",
            "phases.write",
            "cpu_phases.simplify",
            "secs",
            "peak_rss_bytes",
        ],
    );
    assert_eq!(report["input"]["triangle_count"], 512);
    assert_eq!(report["input"]["vertex_count"], 258);
    assert_eq!(report["output_bytes"], bench.read("again.striata").len());
    assert_eq!(
        bench.read("again.striata"),
        bench.read("ball.striata"),
        "the same input gives the same bytes"
    );
}

#[test]
fn build_shows_the_times_of_its_stages() {
    let bench = Workbench::with_ball();
    let arm = asset("arm.glb");
    for (line, stages) in [
        ("build sphere.obj -o out.striata", &["read", "weld", "simplify", "strip", "models", "write"][..]),
        (&format!("build {} -o out.striata", arm.display()), &["read", "simplify", "write"]),
        ("build shape:terrain:60 -o out.striata --paged", &["plan", "tasks", "finish"]),
    ] {
        let shown = bench.run(&format!("{line} --timings")).success();
        let text = String::from_utf8_lossy(&shown.get_output().stderr).into_owned();
        let (_, table) = text.split_once("CPU s").unwrap_or_else(|| panic!("no table: {text}"));
        let first_words = |text: &str| -> Vec<String> {
            text.lines().filter_map(|line| line.split_whitespace().next().map(str::to_owned)).collect()
        };
        assert_eq!(first_words(table), [stages, &["total"]].concat(), "{line}");
        let report = bench.json(line);
        for member in ["phases", "cpu_phases"] {
            assert_keys(&report[member], stages);
        }
        let quiet = bench.run(line).success();
        assert!(!String::from_utf8_lossy(&quiet.get_output().stderr).contains("CPU s"), "{line}");
    }
}

#[test]
fn results_do_not_depend_on_the_number_of_threads() {
    let bench = Workbench::new();
    let (spot, arm) = (asset("spot.obj.zst"), asset("arm.glb"));
    for (name, line) in [
        ("spot.ply", format!("simplify {} --ratio .3 -o", spot.display())),
        ("arm.glb", format!("simplify {} --ratio .3 -o", arm.display())),
        ("arm.stri", format!("encode {} -o", arm.display())),
        ("spot.striata", format!("build {} --models lodstrips,fans -o", spot.display())),
    ] {
        let made = [1, 3].map(|count| {
            bench.run(&format!("{line} {count}-{name} --threads {count}")).success();
            bench.read(&format!("{count}-{name}"))
        });
        assert!(made[0] == made[1], "{name}");
    }
    let refused = bench.refused(&format!("info {} --threads 2", spot.display()));
    assert!(refused.contains("--threads"), "{refused}");
    let refused = bench.refused(&format!("build {} -o out.striata --threads 0", spot.display()));
    assert!(refused.contains("1..=1024"), "{refused}");
}

#[test]
fn build_respects_its_limits() {
    let bench = Workbench::with_ball();
    let report = bench.json("build sphere.obj -o small.striata --base 100");
    let base = report["base"]["triangle_count"].as_u64().expect("a count");
    assert!((90..=100).contains(&base), "{report}");
    let report = bench.json("build sphere.obj -o small.striata --max-error 1%");
    let error = report["error_max"].as_f64().expect("a number");
    assert!(error > 0.0 && error <= 0.01 * 12f64.sqrt(), "{report}");
    for cost in ["accumulated", "tracked"] {
        let report = bench.json(&format!("build sphere.obj -o small.striata --cost {cost}"));
        assert!(report["step_count"].as_u64().is_some_and(|n| n > 200), "{report}");
    }
}

#[test]
fn every_model_of_a_file_shows_the_same_levels() {
    let bench = Workbench::with_ball();
    let report = bench.json("build sphere.obj -o both.striata --models lodstrips,mts");
    assert_keys(&report, &["models.lodstrips.bytes", "models.mts.bytes", "models.mts.bytes_per_vertex"]);
    let info = bench.json("info both.striata");
    assert_keys(&info, &["models.lodstrips.parts", "models.mts.parts.lifetimes", "models.mts.strip_count"]);
    for detail in ["0", "0.3", "1"] {
        for form in ["list", "strips"] {
            let extract = |model: &str| {
                let to = format!("{model}.glb");
                let line =
                    format!("extract both.striata -o {to} --detail {detail} --as {form} --model {model}");
                assert_eq!(bench.json(&line)["model"], model);
                bench.json(&format!("info {to}"))["area"].as_f64().expect("a number")
            };
            let [a, b] = [extract("lodstrips"), extract("mts")];
            assert!((a - b).abs() <= 1e-9 * a, "{a} and {b} at {detail} as {form}");
        }
    }
    // Either model alone is enough.
    bench.json("build sphere.obj -o mts.striata --models mts");
    assert_eq!(bench.json("extract mts.striata -o x.ply --detail 0.5")["model"], "mts");
    assert_eq!(bench.json("info mts.striata")["triangle_count"], 512);
    // Names may have spaces after commas.
    bench.command("build sphere.obj -o blank.striata --models").arg("lodstrips, mts").assert().success();
    assert_eq!(bench.read("blank.striata"), bench.read("both.striata"));
}

#[test]
fn lod_strips_have_new_strips_for_coarse_levels() {
    let bench = Workbench::with_ball();
    let later_strips = |flags: &str| {
        let built = bench.json(&format!("build sphere.obj -o staged.striata {flags}"));
        let parts = &bench.json("info staged.striata")["models"]["lodstrips"]["parts"];
        let area = |detail: &str| {
            bench.json(&format!("extract staged.striata -o x.glb --as strips --detail {detail}"));
            bench.json("info x.glb")["area"].as_f64().expect("a number")
        };
        let bytes = built["models"]["lodstrips"]["bytes"].as_u64().expect("a number");
        (parts["walks of later stages"].as_u64().expect("a number"), bytes, [area("0.6"), area("0.1")])
    };
    let [single, staged] = ["--max-strip-indices none", ""].map(later_strips);
    assert_eq!(single.0, 0);
    assert!(staged.0 > 0 && staged.1 < single.1, "{staged:?} {single:?}");
    assert!(std::iter::zip(single.2, staged.2).all(|(a, b)| (a - b).abs() <= 1e-9 * a));
    bench.refused("build sphere.obj -o x.striata --max-strip-indices 1.1");
    let text = bench.refused("build sphere.obj -o x.striata --models fans --max-strip-indices 1.5");
    assert!(text.contains("hint: add --models lodstrips"), "{text}");
}

#[test]
fn strips_of_other_tools_are_taken_over() {
    let bench = Workbench::with_ball();
    let built =
        |flags: &str| bench.json(&format!("build sphere.obj -o own.striata --models lodstrips,mts {flags}"));
    bench.run("strip sphere.obj -o strips.glb --strips stripe").success();
    let stripe = bench.json("strip sphere.obj --strips stripe");
    let taken = built("--strips-from strips.glb");
    assert_eq!(taken["strips"]["algorithm"], "strips.glb");
    // A strip that ends next to the beginning of the next one goes on there.
    assert!(taken["strips"]["strip_count"].as_u64() <= stripe["strip_count"].as_u64(), "{taken}");
    let searched = built("--strips-from strips.glb --strips cheapest");
    assert!(searched["strips"]["index_count"].as_u64() < taken["strips"]["index_count"].as_u64());
    // Lists of vertices: the first strip of a band, and the same as STRIPE writes it.
    bench.write("square.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 0 2 0\nf 1 2 3\nf 3 2 4\nf 3 4 5\n");
    for list in ["0 1 2 3 4\n", "# strips\nt 1 2 3\nq 4 5\n", "0 1 2 3\n2,3,4\n"] {
        bench.write("list.txt", list);
        let built = bench.json("build square.obj -o square.striata --strips-from list.txt");
        assert_eq!(built["strips"]["strip_count"], 1, "{list}: {built}");
    }
    let refused = |list: &str| {
        bench.write("list.txt", list);
        bench.refused("build square.obj -o refused.striata --strips-from list.txt")
    };
    assert!(refused("0 1 2\n0 1 5\n").contains("line 2: no vertex 5"));
    assert!(refused("t 0 1 2\n").contains("vertices are 1 to 5"));
    assert!(refused("2 1 0\n").contains("none of its triangles"));
    bench.write("nothing.off", "OFF\n0 0 0\n");
    let nothing = bench.refused("build nothing.off -o refused.striata --strips-from list.txt");
    assert!(nothing.contains("the input has no vertices"), "{nothing}");
    bench.refused("build square.obj -o refused.striata --strips-from missing.txt");
    bench.refused("build square.obj -o refused.striata --models fans --strips-from list.txt");
    assert!(!bench.path("refused.striata").exists());
}

#[test]
fn a_view_is_finer_where_the_eye_looks() {
    let bench = Workbench::with_ball();
    let view = |flags: &str| bench.json(&format!("extract ball.striata -o view.glb {flags}"));
    let report = view("--eye -0.4,0.3,-3 --pixels 2");
    assert_eq!(report["model"], "fans");
    let count = |report: &serde_json::Value| report["triangle_count"].as_u64().expect("a count");
    let seen = count(&report);
    assert!(seen > 20 && seen < 512, "half of a ball is turned away: {report}");
    assert_eq!(bench.json("info view.glb")["triangle_count"], seen);
    // A smaller tolerance gives more triangles; distance, looking elsewhere and a smaller screen give fewer.
    assert!(count(&view("--eye -0.4,0.3,-3 --pixels 0.5")) > seen);
    assert!(count(&view("--eye -4,3,-30 --pixels 2")) < seen);
    assert!(count(&view("--eye -0.4,0.3,-3 --look-at -0.4,0.3,-9 --pixels 2")) < seen);
    assert!(count(&view("--eye -0.4,0.3,-3 --pixels 2 --viewport 64x48")) < seen);
    // Seen from inside, triangles face away; the count is the same for strips as for a list.
    let within = count(&view("--eye 0,0,0.1 --look-at 0,0,1 --fov 170 --pixels 0"));
    assert!(within < 512);
    assert_eq!(count(&view("--eye 0,0,0.1 --look-at 0,0,1 --fov 170 --pixels 0 --as strips")), within);
    assert_eq!(view("--eye 0,0,3 --model fans")["stop_reason"], "target_reached");
    let refused = |flags: &str| bench.refused(&format!("extract ball.striata -o x.ply {flags}"));
    assert!(refused("--eye 0,0,3 --model mts").contains("hint: use --model fans"));
    assert!(refused("--eye 0,0,3 --look-at 0,0,3").contains("do not define a view direction"));
    assert!(refused("--detail 1 --pixels 3").contains("hint: use --eye"));
    assert!(bench.refused("simplify sphere.obj -o x.ply --eye 0,0,3").contains("unexpected argument"));
}

#[test]
fn stored_fans_and_built_fans_give_the_same_view() {
    let bench = Workbench::with_ball();
    let report = bench.json("build sphere.obj -o fans.striata --models fans");
    assert_keys(&report, &["models.fans.bytes", "models.fans.bytes_per_vertex"]);
    assert!(report["strips"].is_null() && report["models"].get("lodstrips").is_none(), "{report}");
    assert_keys(&bench.json("info fans.striata"), &["models.fans.parts.bounds", "models.fans.parts.entries"]);
    let view = "--eye -0.4,0.3,-3 --pixels 2";
    let seen = bench.json(&format!("extract fans.striata -o stored.glb {view}"));
    assert_eq!(
        (&seen["model"], &seen["fans"], &seen["pixels"]),
        (&"fans".into(), &"stored".into(), &2.0.into())
    );
    let built = bench.json(&format!("extract ball.striata -o built.glb {view}"));
    assert_eq!((&built["fans"], &built["triangle_count"]), (&"built".into(), &seen["triangle_count"]));
    // Triangles have the order of the fans in both cases.
    assert_eq!(bench.read("stored.glb"), bench.read("built.glb"));
    // Uniform levels equal those of the other models, whether or not the file contains those models.
    bench.run("build sphere.obj -o all.striata --models fans,mts,lodstrips --quiet").success();
    assert_eq!(bench.json("extract all.striata -o x.ply --detail 0.5")["model"], "lodstrips");
    for (file, detail) in [("fans", 0.0), ("all", 0.4), ("fans", 0.4), ("all", 1.0)] {
        let level = |model: &str, file: &str| {
            let line = format!("extract {file}.striata -o {model}.ply --detail {detail} --model {model}");
            assert_eq!(bench.json(&line)["model"], model);
            let info = bench.json(&format!("info {model}.ply"));
            (info["triangle_count"].clone(), info["area"].as_f64().expect("a number"))
        };
        let (found, expected) = (level("fans", file), level("mts", "all"));
        assert_eq!(found.0, expected.0, "{file} at {detail}");
        assert!((found.1 - expected.1).abs() <= 1e-9 * expected.1, "{file} at {detail}");
    }
    let whole = bench.json("extract fans.striata -o x.ply --triangles 300");
    assert_eq!(whole["model"], "fans");
    assert!(whole.get("fans").is_none() && whole.get("pixels").is_none(), "only views report these: {whole}");
}

#[test]
fn a_view_respects_a_triangle_limit() {
    let bench = Workbench::with_ball();
    let view =
        |flags: &str| bench.json(&format!("extract ball.striata -o view.ply --eye -0.4,0.3,-3 {flags}"));
    let pixels = |report: &serde_json::Value| report["pixels"].as_f64().expect("a number");
    let count = |report: &serde_json::Value| report["triangle_count"].as_u64().expect("a count");
    let free = view("--pixels 0.5");
    let enough = view("--pixels 0.5 --triangles 512");
    assert_eq!((count(&enough), pixels(&enough)), (count(&free), 0.5));
    let few = view("--pixels 0.5 --triangles 100");
    assert!((90..=100).contains(&count(&few)) && pixels(&few) > 0.5, "{few}");
    let fewer = view("--pixels 0 --triangles 60");
    assert!((50..=60).contains(&count(&fewer)) && pixels(&fewer) > pixels(&few), "{fewer}");
    // The reported tolerance gives the same level again.
    let again = view(&format!("--pixels {}", pixels(&few) * 1.0001));
    assert!(count(&again).abs_diff(count(&few)) <= 2, "{again}");
    let least = view("--triangles 0");
    assert_eq!((&least["stop_reason"], &least["split_count"]), (&"base_reached".into(), &0.into()));
    // Silhouettes may be finer than the rest.
    let outlined = view("--pixels 8 --silhouette-pixels 1");
    assert!(count(&outlined) > count(&view("--pixels 8")), "{outlined}");
    assert!(count(&outlined) <= count(&view("--pixels 1")), "{outlined}");
}

#[test]
fn a_view_is_finer_in_a_region_and_coarser_away_from_the_gaze() {
    let bench = Workbench::with_ball();
    let count = |flags: &str| {
        let report = bench.json(&format!("extract ball.striata -o view.ply --eye -0.4,0.3,-3 {flags}"));
        report["triangle_count"].as_u64().expect("a count")
    };
    let [coarse, fine] = ["--pixels 30", "--pixels 0.3"].map(count);
    let here = count("--pixels 30 --region 0,0,-1,0.5 --region-pixels 0.3");
    assert!(coarse < here && here < fine, "{coarse}, {here} in the region, {fine}");
    assert_eq!(count("--pixels 30 --region 0,0,-1,0.5 --region-pixels 30"), coarse);
    assert!(count("--pixels 30 --region 0,0,-1,0.5") <= here, "a tenth is more than a hundredth");
    assert_eq!(count("--pixels 30 --region 50,0,0,0.5"), coarse);
    let gazed = count("--pixels 0.3 --gaze 0.9,0.9 --gaze-falloff 400");
    assert!(gazed < fine, "{gazed} with the gaze, {fine} without");
    assert_eq!(count("--pixels 0.3 --gaze 0.9,0.9 --gaze-falloff 0"), fine);
    for wrong in ["--region 1,2,3", "--gaze 0,2", "--region-pixels 1", "--gaze-falloff 1"] {
        bench.run(&format!("extract ball.striata -o x.ply --eye 0,0,3 {wrong}")).code(2);
    }
}

#[test]
fn every_level_can_be_written_as_fans() {
    let bench = Workbench::with_ball();
    bench.run("build sphere.obj -o fans.striata --models fans --quiet").success();
    let info = |level: &str| {
        bench.json(&format!("extract {level}"));
        let info = bench.json("info x.glb");
        (
            info["triangle_count"].clone(),
            info["boundary_edge_count"].clone(),
            info["area"].as_f64().expect("an area"),
        )
    };
    for file in ["ball", "fans"] {
        for level in ["--triangles 300", "--eye -0.4,0.3,-3 --pixels 0.5"] {
            let list = info(&format!("{file}.striata -o x.glb {level}"));
            for form in ["fans", "strips"] {
                let drawn = info(&format!("{file}.striata -o x.glb {level} --as {form}"));
                assert_eq!((&drawn.0, &drawn.1), (&list.0, &list.1), "{file} {level} as {form}");
                assert!((drawn.2 - list.2).abs() < 1e-5 * list.2, "{file} {level} as {form}");
            }
        }
    }
    bench.run("extract fans.striata -o x.gltf --triangles 300 --as fans --quiet").success();
    let root: serde_json::Value = serde_json::from_slice(&bench.read("x.gltf")).expect("JSON");
    let primitives = root["meshes"][0]["primitives"].as_array().expect("a list");
    assert!(primitives.iter().all(|primitive| primitive["mode"] == 6), "{root}");
    assert!((40..120).contains(&primitives.len()), "{} fans", primitives.len());
}

#[test]
fn info_reports_on_meshes_and_containers() {
    let bench = Workbench::with_ball();
    let keys = [
        "kind",
        "format_version",
        "vertex_count",
        "triangle_count",
        "position_count",
        "component_count",
        "boundary_edge_count",
        "non_manifold_edge_count",
        "attributes",
        "materials",
        "bounds.min",
        "bounds.max",
        "diagonal",
        "models",
        "step_count",
        "base",
        "error_max",
    ];
    let mesh = bench.json("info sphere.obj");
    assert_keys(&mesh, &keys);
    assert_eq!(mesh["kind"], "obj");
    assert_eq!(mesh["component_count"], 1);
    assert_eq!(mesh["boundary_edge_count"], 0);
    let container = bench.json("info ball.striata");
    assert_keys(&container, &keys);
    assert_eq!(container["kind"], "striata");
    assert_eq!(container["format_version"], 2);
    assert_eq!(container["triangle_count"], 512);
    assert_keys(&container, &["models.lodstrips", "base.triangle_count"]);
    let text = bench.run("info ball.striata").success();
    assert!(String::from_utf8_lossy(&text.get_output().stdout).contains("512"));
}

#[test]
fn extract_writes_the_requested_level() {
    let bench = Workbench::with_ball();
    let level = bench.json("extract ball.striata -o level.ply --triangles 200");
    assert_keys(
        &level,
        &[
            "model",
            "split_count",
            "vertex_count",
            "triangle_count",
            "error",
            "seek_secs",
            "secs",
            "stop_reason",
        ],
    );
    let count = level["triangle_count"].as_u64().expect("a count");
    assert!((198..=200).contains(&count), "{level}");
    assert_eq!(bench.json("info level.ply")["triangle_count"], count);
    assert_eq!(bench.json("info level.ply")["boundary_edge_count"], 0, "the ball stays closed");
    let vertices = bench.json("extract ball.striata -o level.ply --vertices 100");
    assert_eq!(vertices["vertex_count"], 100);
    let full = bench.json("extract ball.striata -o level.ply --detail 1");
    assert_eq!((&full["triangle_count"], &full["error"]), (&512.into(), &0.0.into()));
    let base = bench.json("extract ball.striata -o level.ply --detail 0");
    assert_eq!(base["split_count"], 0);
    let near = bench.json("extract ball.striata -o level.ply --error 1%");
    assert!(near["error"].as_f64().is_some_and(|e| e <= 0.01 * 12f64.sqrt()), "{near}");
    let exact = bench.json("extract ball.striata -o level.ply --split-count 17");
    assert_eq!(exact["split_count"], 17);
}

#[test]
fn targets_out_of_reach_are_reported() {
    let bench = Workbench::with_ball();
    let over = bench.json("extract ball.striata -o level.ply --triangles 9999");
    assert_eq!((&over["triangle_count"], &over["stop_reason"]), (&512.into(), &"full_mesh".into()));
    let under = bench.json("extract ball.striata -o level.ply --triangles 0");
    assert_eq!((&under["split_count"], &under["stop_reason"]), (&0.into(), &"base_reached".into()));
}

#[test]
fn strips_draw_the_same_level() {
    let bench = Workbench::with_ball();
    let strips = bench.json("extract ball.striata -o strips.glb --triangles 300 --as strips");
    let list = bench.json("extract ball.striata -o list.glb --triangles 300");
    assert_eq!(strips["triangle_count"], list["triangle_count"]);
    let read_back = bench.json("info strips.glb");
    assert_eq!(read_back["triangle_count"], list["triangle_count"]);
    assert_eq!(read_back["boundary_edge_count"], 0);
    let distance = bench.json("distance strips.glb list.glb");
    assert!(distance["max"].as_f64().is_some_and(|d| d < 1e-6), "{distance}");
}

#[test]
fn simplify_meets_its_target_and_reports_the_error() {
    let bench = Workbench::with_ball();
    for placement in ["subset", "optimal"] {
        let arguments = format!("simplify sphere.obj -o small.off --triangles 200 --placement {placement}");
        let report = bench.json(&arguments);
        assert_keys(
            &report,
            &["vertex_count", "triangle_count", "error", "stop_reason", "simplify_secs", "secs"],
        );
        assert!(report["triangle_count"].as_u64().is_some_and(|n| (190..=200).contains(&n)), "{report}");
        assert_eq!(report["stop_reason"], "target_reached");
    }
    let distance = bench.json("distance sphere.obj small.off");
    assert!(distance["max"].as_f64().is_some_and(|d| d < 0.2), "{distance}");
}

#[test]
fn distance_is_measured_both_ways() {
    let bench = Workbench::with_ball();
    let report = bench.json("distance sphere.obj sphere.obj --samples 1000");
    assert_keys(
        &report,
        &[
            "max",
            "rms",
            "mean",
            "a_to_b.max",
            "a_to_b.rms",
            "a_to_b.mean",
            "b_to_a.max",
            "b_to_a.rms",
            "b_to_a.mean",
            "diagonal",
            "sample_count",
        ],
    );
    assert!(report["max"].as_f64().is_some_and(|d| d < 1e-6), "{report}");
    let container = bench.json("distance sphere.obj ball.striata");
    assert!(container["max"].as_f64().is_some_and(|d| d < 1e-6), "a container stands for its full mesh");
}

#[test]
fn convert_supports_every_format() {
    let bench = Workbench::with_ball();
    let mut from = "sphere.obj".to_owned();
    for to in ["a.ply", "b.off", "c.stl", "d.glb", "e.gltf", "f.obj", "g.ply.gz", "h.ply.zst"] {
        let report = bench.json(&format!("convert {from} {to}"));
        assert_eq!(report["triangle_count"], 512, "{from} to {to}");
        from = to.to_owned();
    }
    let last = bench.json(&format!("distance sphere.obj {from}"));
    assert!(last["max"].as_f64().is_some_and(|d| d < 1e-5), "{last}");
}

#[test]
fn textures_come_along_and_missing_ones_are_warnings() {
    let bench = Workbench::new();
    bench.write("a.mtl", "newmtl m\nmap_Kd a.jpg\nmap_Ke lost.png\n");
    bench.write("a.jpg", b"\xff\xd8\xff a picture");
    bench.write("a.obj", "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nusemtl m\nf 1/1 2/1 3/1\n");
    let converted = bench.run("convert a.obj a.glb").success();
    let stderr = String::from_utf8_lossy(&converted.get_output().stderr).into_owned();
    assert!(
        stderr.starts_with("warning: ") && stderr.contains("a.mtl: line 3: texture `lost.png`"),
        "{stderr}"
    );
    let glb = bench.read("a.glb");
    assert!(glb.windows(9).any(|bytes| bytes == b"a picture"));
    let quiet = bench.run("convert a.obj a.glb --quiet").success();
    assert!(quiet.get_output().stderr.is_empty());
}

#[test]
fn colors_are_linear_in_gltf_only() {
    let bench = Workbench::new();
    let mesh = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n\
        property uchar red\nproperty uchar green\nproperty uchar blue\nelement face 1\n\
        property list uchar int vertex_indices\nend_header\n\
        0 0 0 255 128 0\n1 0 0 1 2 3\n0 1 0 64 32 16\n3 0 1 2\n";
    bench.write("a.ply", mesh);
    for verb in ["convert {} {}", "strip {} -o {}", "simplify {} -o {} --detail 1"] {
        let run = |from: &str, to: &str| {
            let arguments = verb.replacen("{}", from, 1).replacen("{}", to, 1);
            let raw = if verb.starts_with("strip") { "" } else { "--raw" };
            bench.run(&format!("{arguments} {raw} --quiet")).success();
        };
        run("a.ply", "a.glb");
        // 128 of 255 in sRGB, as linear light in 16 bits.
        let glb = bench.read("a.glb");
        assert!(glb.windows(4).any(|bytes| bytes == [255, 255, 0x42, 0x37]), "{verb}");
        run("a.glb", "b.gltf");
        bench.run("convert b.gltf b.ply --ascii --quiet").success();
        let text = String::from_utf8(bench.read("b.ply")).unwrap();
        for row in ["0 0 0 255 128 0\n", "1 0 0 1 2 3\n", "0 1 0 64 32 16\n"] {
            assert!(text.contains(row), "{verb}: {text}");
        }
    }
}

#[test]
fn identifiers_in_floats_survive_streams() {
    let bench = Workbench::new();
    let size = 20;
    let mut mesh = format!(
        "ply\nformat ascii 1.0\nelement vertex {}\nproperty float x\nproperty float y\nproperty float z\n\
         property float feature_id\nelement face {}\nproperty list uchar int vertex_indices\nend_header\n",
        size * size,
        (size - 1) * (size - 1)
    );
    let mut expected: Vec<i64> = (0..size * size).map(|v| v * 197_197 % 300_001 - 100).collect();
    for (v, id) in (0..).zip(&expected) {
        mesh += &format!("{} {} {} {id}\n", v % size, v / size, v % 7);
    }
    for cell in (0..(size - 1) * size).filter(|cell| cell % size < size - 1) {
        mesh += &format!("4 {cell} {} {} {}\n", cell + 1, cell + size + 1, cell + size);
    }
    expected.sort_unstable();
    bench.write("a.ply", mesh);
    for encode in ["encode a.ply -o a.stri", "encode a.ply -o a.stri --lossless", "encode a.ply -o a.striata"]
    {
        bench.json(encode);
        let file = encode.split(' ').nth(3).unwrap_or_default();
        bench.json(&format!("decode {file} -o a.glb --raw"));
        bench.run("convert a.glb b.ply --ascii --quiet").success();
        let text = String::from_utf8(bench.read("b.ply")).unwrap();
        let columns: Vec<&str> = text.lines().filter(|line| line.starts_with("property float")).collect();
        let column = columns.iter().position(|line| line.ends_with("feature_id")).unwrap();
        let rows = text.lines().skip_while(|line| *line != "end_header").skip(1).take(expected.len());
        let mut ids: Vec<i64> =
            rows.map(|row| row.split(' ').nth(column).unwrap().parse().unwrap()).collect();
        ids.sort_unstable();
        assert_eq!(ids, expected, "{encode}");
    }
}

#[test]
fn meshes_can_be_piped() {
    let bench = Workbench::with_ball();
    let mesh = bench.read("sphere.obj");
    let converted = bench.command("convert - - --to off").write_stdin(mesh.clone()).assert().success();
    assert!(converted.get_output().stdout.starts_with(b"OFF"));
    let ply = bench.command("simplify - -o - --triangles 100").write_stdin(mesh).assert().success();
    let ply = ply.get_output().stdout.clone();
    assert!(ply.starts_with(b"ply\nformat binary"));
    let info = bench.command("info - --json").write_stdin(ply).assert().success();
    assert!(String::from_utf8_lossy(&info.get_output().stdout).contains("\"kind\":\"ply\""));
    let both = bench.command("convert sphere.obj - --json").assert().code(2);
    assert!(String::from_utf8_lossy(&both.get_output().stderr).contains("hint:"));
}

#[test]
fn levels_preserve_seams_and_uvs() {
    let bench = Workbench::new();
    let spot = asset("spot.obj.zst");
    bench.command("build -o spot.striata").arg(&spot).assert().success();
    let level = bench.json("extract spot.striata -o level.glb --triangles 1000");
    assert!(level["triangle_count"].as_u64().is_some_and(|n| (900..=1000).contains(&n)), "{level}");
    let info = bench.json("info level.glb");
    assert_eq!(info["boundary_edge_count"], 0, "seams are not holes: {info}");
    assert!(info["attributes"].to_string().contains("texcoord_0"), "{info}");
    let positions = info["position_count"].as_u64().expect("a count");
    assert!(info["vertex_count"].as_u64().is_some_and(|n| n > positions), "seams have two wedges: {info}");
}

#[test]
fn the_demo_writes_a_page_and_its_files() {
    let bench = Workbench::new();
    let report = bench.json("demo show");
    assert_keys(&report, &["dir", "files", "levels"]);
    let files = report["files"].as_array().expect("a list");
    assert!(files.len() >= 8, "{report}");
    for name in files {
        let path = bench.path("show").join(name.as_str().expect("a name"));
        assert!(path.metadata().is_ok_and(|m| m.len() > 100), "{} is missing", path.display());
    }
    let page = String::from_utf8(bench.read("show/index.html")).expect("text");
    assert!(!page.contains("{{"), "a placeholder is left");
    assert!(
        page.contains("href=\"viewer.html\"") && page.matches("<img ").count() == 5,
        "viewer and pictures"
    );
    let viewer = String::from_utf8(bench.read("show/viewer.html")).expect("text");
    assert!(viewer.contains("data-name=\"nefertiti.stri\""), "the viewer contains no stream");
    let scene = String::from_utf8(bench.read("show/amphora.html")).expect("text");
    assert!(scene.contains("data-name=\"amphora.stri\"") && page.contains("href=\"amphora.html\""));
    assert!(!page.contains("src=\"http") && !page.contains("href=\"http"), "the page refers to the network");
    let triangles: Vec<u64> = report["levels"]
        .as_array()
        .expect("a list")
        .iter()
        .map(|level| level["triangle_count"].as_u64().expect("a count"))
        .collect();
    assert_eq!(triangles[0], 99_938);
    assert!(triangles.is_sorted_by(|a, b| a > b), "{triangles:?}");
}

#[test]
fn completions_name_the_verbs() {
    let bench = Workbench::new();
    for shell in ["bash", "zsh", "fish", "elvish", "powershell"] {
        let script = bench.run(&format!("completions {shell}")).success();
        assert!(String::from_utf8_lossy(&script.get_output().stdout).contains("extract"), "{shell}");
    }
}

#[test]
fn shapes_are_meshes_for_every_verb() {
    let bench = Workbench::new();
    let info = bench.json("info shape:torus");
    assert_eq!((&info["kind"], &info["genus"]), (&"shape".into(), &1.into()));
    assert!(info["file_bytes"].is_null());
    let text = bench.run("info shape:cube").success();
    assert!(String::from_utf8_lossy(&text.get_output().stdout).contains("shape:cube (shape)"));
    bench.run("convert shape:cube cube.ply --quiet").success();
    bench.run("simplify shape:grid -o small.ply --triangles 100 --quiet").success();
    assert_eq!(bench.json("strip shape:tetrahedron")["triangle_count"], 4);
    assert_eq!(bench.json("distance shape:cube cube.ply --samples 100")["max"], 0.0);
    bench.run("build shape:grid -o grid.striata --quiet").success();
    assert_eq!(bench.json("info grid.striata")["triangle_count"], 2 * 64 * 64);
    for verb in ["info", "convert x.ply", "build -o x.striata"] {
        let (verb, rest) = verb.split_once(' ').unwrap_or((verb, ""));
        let message = bench.refused(&format!("{verb} shape:tourus {rest}"));
        assert!(message.contains("no shape \"tourus\"") && message.contains("torus, terrain"), "{message}");
    }
    assert!(bench.refused("extract shape:cube -o x.ply --detail 1").contains("striata build"));
    let message = bench.refused("strip shape:grid --block-triangles 1000");
    assert!(message.contains("or write a file first"), "{message}");
    assert_eq!(bench.names(), ["cube.ply", "grid.striata", "small.ply"]);
}

#[test]
fn plain_meshes_get_normals_and_a_material_in_gltf() {
    let bench = Workbench::with_ball();
    for verb in ["convert sphere.obj a.glb", "simplify sphere.obj -o a.glb --triangles 200"] {
        bench.json(verb);
        let shown = bench.json("info a.glb");
        let names: Vec<&str> =
            shown["attributes"].as_array().unwrap().iter().filter_map(|a| a["name"].as_str()).collect();
        assert!(names.contains(&"normal"), "{verb}: {names:?}");
        assert_eq!(shown["materials"].as_array().map(Vec::len), Some(1), "{verb}");
        bench.json(&format!("{verb} --raw"));
        let raw = bench.json("info a.glb");
        assert_eq!(raw["attributes"].as_array().map(Vec::len), Some(0), "{verb}");
        assert_eq!(raw["triangle_count"], shown["triangle_count"], "{verb}");
    }
    assert!(bench.refused("convert sphere.obj a.ply --raw").contains("--raw is for glTF"));
}
