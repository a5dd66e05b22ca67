//! Patterns in files: built from collapses or vertex removals, for uniform levels, views and boxes.

use serde_json::Value;

use crate::orders::{distance, number};
use crate::workbench::{Workbench, assert_keys, asset};

fn count(report: &Value) -> u64 {
    report["triangle_count"].as_u64().unwrap_or_else(|| panic!("no count in {report}"))
}

/// Creates a folder with `free.striata`, built from `sphere.obj` by removing vertices.
fn with_free_ball() -> Workbench {
    let bench = Workbench::with_ball();
    bench.run("build sphere.obj -o free.striata --order hausdorff --models patterns --quiet").success();
    bench
}

#[test]
fn patterns_have_the_same_levels_as_other_models() {
    let bench = Workbench::with_ball();
    let report = bench.json("build sphere.obj -o all.striata --models patterns,fans,lodstrips");
    assert_keys(&report, &["models.patterns.bytes", "models.patterns.bytes_per_vertex", "models.fans.bytes"]);
    let of_models = ["patterns", "fans"].map(|name| report["models"][name]["bytes"].as_u64().unwrap());
    assert!(of_models.iter().sum::<u64>() <= report["output_bytes"].as_u64().unwrap(), "{report}");
    let alone = bench.json("build sphere.obj -o alone.striata --models patterns");
    assert!(alone["strips"].is_null() && alone["models"].get("fans").is_none(), "{alone}");
    assert_eq!((&alone["order"], &alone["error_is_guaranteed"]), (&"quadric".into(), &false.into()));
    for file in ["all", "alone"] {
        let info = bench.json(&format!("info {file}.striata"));
        assert_keys(&info, &["models.patterns.parts.bounds", "models.patterns.parts.records"]);
        assert!(number(&info["models"]["patterns"], "rule_count") >= 1.0);
        assert!(number(&info["models"]["patterns"], "overlap_count") > 256.0);
        assert_eq!((&info["triangle_count"], &info["step_count"]), (&512.into(), &report["step_count"]));
        for detail in ["0", "0.3", "0.77", "1"] {
            let level = |model: &str, file: &str| {
                let line = format!("extract {file}.striata -o level.ply --detail {detail} --model {model}");
                let report = bench.json(&line);
                assert_eq!(report["model"], model);
                let info = bench.json("info level.ply");
                let counts = [
                    &report["split_count"],
                    &report["error"],
                    &info["triangle_count"],
                    &info["vertex_count"],
                ];
                (counts.map(Clone::clone), number(&info, "area"))
            };
            let (found, expected) = (level("patterns", file), level("lodstrips", "ball"));
            assert_eq!(found.0, expected.0, "{file} at {detail}");
            assert!((found.1 - expected.1).abs() <= 1e-9 * expected.1, "{file} at {detail}");
        }
    }
    assert_eq!(bench.json("extract alone.striata -o x.ply --triangles 200")["model"], "patterns");
    assert_eq!(bench.json("extract all.striata -o x.ply --triangles 200")["model"], "lodstrips");
}

#[test]
fn a_file_of_removed_vertices_needs_no_collapses() {
    let bench = with_free_ball();
    let report = bench.json("build sphere.obj -o again.striata --order hausdorff --models patterns");
    assert_eq!(
        bench.read("again.striata"),
        bench.read("free.striata"),
        "the same input gives the same bytes"
    );
    assert_eq!((&report["order"], &report["error_is_guaranteed"]), (&"hausdorff".into(), &true.into()));
    let assert = bench.run("build sphere.obj -o again.striata --order hausdorff --models patterns").success();
    assert!(!String::from_utf8_lossy(&assert.get_output().stderr).contains("collapses"));
    let info = bench.json("info free.striata");
    assert_eq!((&info["triangle_count"], &info["error_is_guaranteed"]), (&512.into(), &true.into()));
    assert_eq!((&info["step_count"], &info["error_max"]), (&report["step_count"], &report["error_max"]));
    for level in
        ["--triangles 100", "--detail 0", "--detail 0.4", "--error 2%", "--vertices 77", "--split-count 99"]
    {
        let report = bench.json(&format!("extract free.striata -o level.ply {level}"));
        assert_eq!((&report["model"], &report["error_is_guaranteed"]), (&"patterns".into(), &true.into()));
        let measured = distance(&bench, "sphere.obj", "level.ply");
        assert!(measured <= number(&report, "error") + 1e-9, "{level}: measured {measured}, {report}");
    }
    let whole = bench.json("extract free.striata -o whole.glb --detail 1 --as strips");
    assert_eq!((count(&whole), number(&whole, "error")), (512, 0.0));
    assert!(number(&bench.json("distance sphere.obj free.striata --samples 2000"), "max") < 1e-9);
    assert_eq!(bench.json("strip free.striata")["triangle_count"], 512);
    bench.run("convert free.striata out.obj --quiet").success();
    // A file built from the full mesh of this file has collapses again.
    bench.run("build free.striata -o strips.striata --quiet").success();
    assert_eq!(bench.json("info strips.striata")["triangle_count"], 512);
    for model in ["lodstrips", "mts", "fans"] {
        let message = bench.refused(&format!("extract free.striata -o x.ply --detail 1 --model {model}"));
        assert!(message.contains(&format!("this file has no model {model}")), "{message}");
    }
    // Fans can be built from patterns.
    let view = "--eye 0,0,3 --pixels 20 --model fans";
    assert_eq!(bench.json(&format!("extract free.striata -o x.ply {view}"))["fans"], "built");
    let both =
        bench.run("build sphere.obj -o both.striata --order hausdorff --models patterns,fans").success();
    assert!(!String::from_utf8_lossy(&both.get_output().stderr).contains("requires"));
    let stored = bench.json(&format!("extract both.striata -o y.ply {view}"));
    assert_eq!(stored["fans"], "stored");
    assert!((1..512).contains(&count(&stored)), "{stored}");
    let message = bench.refused(
        "build sphere.obj -o x.striata --order hausdorff --retriangulation free --models patterns,mts",
    );
    assert!(message.contains("model mts does not support free retriangulation"), "{message}");
    bench.json("build sphere.obj -o x.striata --order hausdorff --retriangulation free --models patterns");
    bench
        .json("build sphere.obj -o x.striata --order hausdorff --retriangulation collapse --models patterns");
    assert_eq!(bench.json("extract x.striata -o x.ply --eye 0,0,3 --model fans")["fans"], "built");
}

/// Files with fans of removals that are not collapses, without patterns.
#[test]
fn fans_of_removals_are_levels_and_views() {
    let bench = Workbench::with_ball();
    let assert = bench.run("build sphere.obj -o free.striata --order hausdorff --models fans").success();
    assert!(!String::from_utf8_lossy(&assert.get_output().stderr).contains("collapse"));
    let info = bench.json("info free.striata");
    assert_eq!(info["triangle_count"], 512);
    bench.run("build sphere.obj -o patterns.striata --order hausdorff --models patterns --quiet").success();
    for level in ["--triangles 100", "--detail 0", "--error 2%", "--split-count 99"] {
        let [fans, patterns] = ["free", "patterns"]
            .map(|name| bench.json(&format!("extract {name}.striata -o {name}.ply {level}")));
        for key in ["triangle_count", "error", "split_count"] {
            assert_eq!(fans[key], patterns[key], "{key} at {level}");
        }
        assert!(distance(&bench, "patterns.ply", "free.ply") < 1e-9, "{level}");
    }
    let view = bench.json("extract free.striata -o seen.ply --eye 0,0,3 --pixels 20");
    assert_eq!((&view["model"], &view["fans"]), (&"fans".into(), &"stored".into()));
    let whole = bench.json("extract free.striata -o whole.ply --detail 1");
    assert!(count(&view) > 0 && count(&view) < count(&whole));
    bench.run("render free.striata -o view.png --eye 0,0,3 --pixels 20 --size 200x200 --quiet").success();
    bench.run("build free.striata -o strips.striata --quiet").success();
    let message = bench.refused("extract free.striata -o x.ply --detail 1 --model lodstrips");
    assert!(message.contains("this file has no model lodstrips"), "{message}");
}

#[test]
fn pictures_show_patterns_and_their_fragments() {
    let bench = with_free_ball();
    let render = |flags: &str| bench.json(&format!("render free.striata -o a.png --size 160x120 {flags}"));
    let report = render("--levels 100%,20% --colors fragments,surface");
    assert_eq!(report["levels"][1]["model"], "patterns", "the only one that the file has: {report}");
    assert_eq!(
        report["levels"][1]["triangle_count"],
        bench.json("extract free.striata -o level.ply --triangles 20%")["triangle_count"]
    );
    let view = render("--eye 0,0,3 --model patterns --pixels 2");
    assert_eq!(view["levels"][0]["model"], "patterns", "{view}");
    let of_collapses = "render ball.striata -o a.png --size 160x120 --eye 0,0,3 --pixels 2 --model patterns";
    assert_eq!(bench.json(of_collapses)["levels"][0]["model"], "patterns");
    bench
        .run("render shape:torus -o a.png --size 160x120 --levels 10% --model patterns --colors fragments")
        .success();
}

#[test]
fn patterns_follow_a_view() {
    let bench = with_free_ball();
    bench.run("build sphere.obj -o quadric.striata --models patterns --quiet").success();
    let view = |file: &str, flags: &str| {
        bench.json(&format!("extract {file}.striata -o {file}.glb --eye -0.4,0.3,-3 {flags}"))
    };
    for file in ["free", "quadric"] {
        let seen = view(file, "--pixels 2");
        assert_eq!((&seen["model"], &seen["patterns"]), (&"patterns".into(), &"stored".into()));
        assert!(seen.get("fans").is_none() && number(&seen, "pixels") == 2.0, "{seen}");
        assert!(count(&seen) > 20 && count(&seen) < 512, "half of a ball is turned away: {seen}");
        assert_eq!(count(&bench.json(&format!("info {file}.glb"))), count(&seen));
        assert!(count(&view(file, "--pixels 0.5")) > count(&seen));
        assert!(count(&view(file, "--pixels 2 --viewport 64x48")) < count(&seen));
        assert!(count(&view(file, "--pixels 8 --silhouette-pixels 1")) > count(&view(file, "--pixels 8")));
        let enough = view(file, "--pixels 0.5 --triangles 512");
        assert_eq!((count(&enough), number(&enough, "pixels")), (count(&view(file, "--pixels 0.5")), 0.5));
        let few = view(file, "--pixels 0.5 --triangles 100");
        assert!((80..=100).contains(&count(&few)) && number(&few, "pixels") > 0.5, "{few}");
        let again = view(file, &format!("--pixels {}", number(&few, "pixels") * 1.0001));
        assert!(count(&again).abs_diff(count(&few)) <= 2, "{again}");
        let least = view(file, "--triangles 0");
        assert_eq!((&least["stop_reason"], &least["split_count"]), (&"base_reached".into(), &0.into()));
        assert_eq!(view(file, "--pixels 2 --as strips")["triangle_count"], seen["triangle_count"]);
    }
    // Errors of vertex removals are guaranteed for every floor, also in views.
    let seen = view("free", "--pixels 4 --silhouette-pixels 1");
    assert_eq!(seen["error_is_guaranteed"], true);
    let measured = distance(&bench, "sphere.obj", "free.glb");
    assert!(measured <= number(&seen, "error") + 1e-9, "measured {measured}, {seen}");
    assert_eq!(view("quadric", "--pixels 2")["error_is_guaranteed"], false);
    // Patterns that are not in the file are built if requested, and equal stored ones.
    let stored = view("quadric", "--pixels 2");
    let built = view("ball", "--pixels 2 --model patterns");
    assert_eq!((&built["patterns"], count(&built)), (&"built".into(), count(&stored)));
    assert_eq!(view("ball", "--pixels 2")["fans"], "built", "views use fans by default");
    assert!(bench.refused("extract free.striata -o x.ply --eye 0,0,3 --model pm").contains("patterns"));
}

#[test]
fn a_box_has_full_detail_inside() {
    let bench = with_free_ball();
    bench.run("build sphere.obj -o sure.striata --certify --models patterns --quiet").success();
    for file in ["free", "sure", "ball"] {
        let level =
            |flags: &str| bench.json(&format!("extract {file}.striata -o level.ply --detail-box {flags}"));
        let base = bench.json(&format!("extract {file}.striata -o base.ply --detail 0"));
        let nowhere = level("5,5,5,6,6,6");
        assert_eq!((count(&nowhere), &nowhere["split_count"]), (count(&base), &0.into()));
        let everywhere = level("-2,-2,-2,2,2,2");
        assert_eq!((count(&everywhere), number(&everywhere, "error")), (512, 0.0));
        // A cap is fine, whichever corners describe the box; the rest is coarse, and less so with an error
        // limit. The box avoids the poles, where fragments depend on most of the ball.
        let cap = level("0.5,-2,-2,2,2,2");
        assert_eq!(cap, {
            let mut same = level("2,2,-2,0.5,-2,2");
            copy_times(&mut same, &cap);
            same
        });
        assert!(count(&cap) > 100 && count(&cap) < 400, "{cap}");
        let stored = if file == "ball" { "built" } else { "stored" };
        assert_eq!((&cap["model"], &cap["patterns"]), (&"patterns".into(), &stored.into()));
        assert!(cap.get("pixels").is_none());
        let finer = level("0.5,-2,-2,2,2,2 --error 1%");
        assert!(count(&finer) > count(&cap) && count(&finer) < 512, "{finer}");
        let limit = 0.01 * number(&bench.json("info sphere.obj"), "diagonal");
        assert!(number(&finer, "error") <= limit && number(&cap, "error") > limit, "{finer}");
        let is_sure = file != "ball";
        assert_eq!(finer["error_is_guaranteed"], is_sure);
        if is_sure {
            let measured = distance(&bench, "sphere.obj", "level.ply");
            assert!(measured <= number(&finer, "error") + 1e-9, "measured {measured}, {finer}");
        }
        let within = level("0.8,-2,-2,2,2,2 --triangles 300");
        assert!(
            (280..=300).contains(&count(&within)) && within["stop_reason"] == "target_reached",
            "{within}"
        );
        let too_few = level("0.5,-2,-2,2,2,2 --triangles 60");
        assert_eq!((count(&too_few), &too_few["stop_reason"]), (count(&cap), &"base_reached".into()));
    }
    // Full detail means the original vertices.
    bench.json("extract free.striata -o part.ply --detail-box 0.5,-2,-2,2,2,2");
    let back = bench.json("distance part.ply sphere.obj --samples 20000");
    assert!(number(&back["a_to_b"], "max") > 0.0);
    let vertices = |name: &str| {
        let mesh = String::from_utf8(bench.read(name)).expect("text");
        let rows = mesh.lines().filter_map(|line| line.strip_prefix("v ")).map(|row| {
            [0, 1, 2].map(|i| row.split(' ').nth(i).and_then(|x| x.parse::<f64>().ok()).expect("a number"))
        });
        rows.filter(|at| at[0] >= 0.5).count()
    };
    bench.run("convert part.ply part.obj --quiet").success();
    assert_eq!(vertices("part.obj"), vertices("sphere.obj"));
}

/// Copies the times of another report, which always differ.
fn copy_times(report: &mut Value, as_in: &Value) {
    for key in ["secs", "seek_secs"] {
        report[key] = as_in[key].clone();
    }
}

#[test]
fn patterns_preserve_seams_and_materials() {
    let bench = Workbench::new();
    for input in ["shape:two-materials", &asset("spot.obj.zst").display().to_string()] {
        for order in ["--order hausdorff", "--certify"] {
            bench.run(&format!("build {input} -o it.striata --models patterns {order} --quiet")).success();
            let original = bench.json(&format!("info {input}"));
            let full = bench.json("info it.striata");
            assert_eq!(full["attributes"], original["attributes"], "{input}");
            assert_eq!(full["groups"].as_array().map(Vec::len), original["groups"].as_array().map(Vec::len));
            for level in ["--triangles 900", "--detail-box 0,0,0,9,9,9", "--eye 0.3,2,-3 --pixels 3"] {
                let report = bench.json(&format!("extract it.striata -o level.glb --raw {level}"));
                assert_eq!(report["error_is_guaranteed"], true, "{report}");
                let info = bench.json("info level.glb");
                assert_eq!(info["triangle_count"], report["triangle_count"]);
                assert_eq!(info["materials"], original["materials"], "{input} {level}");
                let measured = distance(&bench, input, "level.glb");
                assert!(
                    measured <= 1.000_001 * number(&report, "error"),
                    "{input} {level}: {measured}, {report}"
                );
            }
        }
    }
}

#[test]
fn wrong_boxes_and_damaged_files_are_refused() {
    let bench = with_free_ball();
    for (arguments, named) in [
        ("--detail-box 0,0,0,1,1", "is not a box; write two opposite corners"),
        ("--detail-box 0,0,0,1,1,nan", "is not a box"),
        ("--detail-box 0,0,0,1,1,1 --eye 0,0,3", "--eye"),
        ("--detail-box 0,0,0,1,1,1 --vertices 9", "--vertices"),
        ("--detail-box 0,0,0,1,1,1 --detail 0.5", "--detail"),
        ("--detail-box 0,0,0,1,1,1 --split-count 3", "--split-count"),
        ("--detail-box 0,0,0,1,1,1 --model fans", "use --model patterns"),
        ("--detail-box 0,0,0,1,1,1 --pixels 3", "hint: use --eye"),
        ("--quiet", "--detail-box"),
    ] {
        let message = bench.refused(&format!("extract free.striata -o x.ply {arguments}"));
        assert!(message.contains(named), "{arguments}: {message}");
    }
    let whole = bench.read("free.striata");
    for share in 0..40 {
        bench.write("part.striata", &whole[..whole.len() * share / 40]);
        for verb in ["info part.striata", "extract part.striata -o x.ply --detail-box 0,0,0,1,1,1"] {
            assert!(bench.refused(verb).contains("part.striata"));
        }
    }
    // A corrupted byte is detected or has no effect.
    for offset in (0..whole.len()).step_by(whole.len() / 60) {
        let mut broken = whole.clone();
        broken[offset] ^= 0x41;
        bench.write("part.striata", &broken);
        let assert = bench.run("extract part.striata -o x.ply --detail 0.5");
        let code = assert.get_output().status.code();
        assert!(matches!(code, Some(0 | 1)), "byte {offset}: {assert}");
    }
}

#[test]
fn collapses_create_vertices_for_patterns() {
    let bench = Workbench::with_ball();
    for kind in ["edge", "triangle"] {
        let build = format!("build sphere.obj -o new.striata --models patterns,fans --new-vertices {kind}");
        let report = bench.json(&build);
        assert_eq!((&report["order"], &report["error_is_guaranteed"]), (&"quadric".into(), &true.into()));
        assert_eq!(count(&bench.json("info new.striata")), 512);
        for level in ["--triangles 120", "--detail 0.3", "--detail 1"] {
            let counts = ["patterns", "fans"].map(|model| {
                let line = format!("extract new.striata -o new.ply {level} --model {model}");
                let report = bench.json(&line);
                let measured = distance(&bench, "sphere.obj", "new.ply");
                assert!(measured <= number(&report, "error") + 1e-9, "{line}: measured {measured}, {report}");
                count(&report)
            });
            assert_eq!(counts[0], counts[1], "{level}");
        }
        let view = bench.json("extract new.striata -o view.ply --eye 0,0,3 --pixels 2");
        assert!((20..512).contains(&count(&view)), "{view}");
        let line = format!("simplify sphere.obj -o one.ply --triangles 120 --new-vertices {kind}");
        let report = bench.json(&line);
        assert!(count(&report) <= 120 && report["error_is_guaranteed"] == true, "{report}");
    }
    for (flags, why) in [
        ("--new-vertices edge", "model lodstrips does not support new vertices"),
        ("--new-vertices edge --models patterns,mts", "model mts does not support new vertices"),
        ("--new-vertices edge --models patterns --order hausdorff", "--new-vertices has no meaning"),
        ("--new-vertices edge --models patterns --cost tracked", "--cost does not work with --new-vertices"),
        ("--overlap-errors", "--overlap-errors has no effect without patterns"),
    ] {
        let message = bench.refused(&format!("build sphere.obj -o x.striata {flags}"));
        assert!(message.contains(why) && message.contains("hint:"), "{message}");
    }
    let message =
        bench.refused("simplify sphere.obj -o x.ply --triangles 100 --placement optimal --new-vertices edge");
    assert!(message.contains("--new-vertices does not work with --placement optimal"), "{message}");
}

#[test]
fn views_evaluate_errors_of_overlaps() {
    let bench = Workbench::with_ball();
    for order in ["hausdorff", "hausdorff-strict"] {
        let build = format!("build sphere.obj --order {order} --models patterns");
        let report = bench.json(&format!("{build} -o floors.striata"));
        assert_eq!(report["order"], order);
        bench.run(&format!("{build} -o overlaps.striata --overlap-errors --quiet")).success();
        let model = |file: &str| bench.json(&format!("info {file}.striata"))["models"]["patterns"].clone();
        let [floors, overlaps] = ["floors", "overlaps"].map(model);
        assert_eq!(
            (&floors["has_overlap_errors"], &overlaps["has_overlap_errors"]),
            (&false.into(), &true.into())
        );
        assert!(number(&overlaps, "bytes") > number(&floors, "bytes"));
        let count_of = |file: &str| {
            let line = format!("extract {file}.striata -o {file}.ply --eye -0.4,0.3,-3 --pixels 1");
            let report = bench.json(&line);
            let measured = distance(&bench, "sphere.obj", &format!("{file}.ply"));
            assert!(measured <= number(&report, "error") + 1e-9, "measured {measured}, {report}");
            count(&report)
        };
        let [by_floors, by_overlaps] = ["floors", "overlaps"].map(count_of);
        // Errors are certified again for overlaps, which may round other ones up.
        assert!(by_overlaps <= by_floors + by_floors / 20, "{by_overlaps} triangles instead of {by_floors}");
        let few = bench.json("extract overlaps.striata -o few.ply --eye -0.4,0.3,-3 --triangles 100");
        assert!((60..=100).contains(&count(&few)), "{few}");
    }
}
