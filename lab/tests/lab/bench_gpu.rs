//! `bench-gpu`: all ways of drawing show the same walk, and their figures are consistent.

use serde_json::Value;

use crate::workbench::Workbench;

const WAYS: [&str; 14] = [
    "list",
    "strips",
    "strips-ranges",
    "strips-draws",
    "strips-staged",
    "strips-published",
    "mts",
    "mts-published",
    "fans",
    "fans-strips",
    "fans-compute",
    "resident-list",
    "resident-strips",
    "discrete",
];

fn number(way: &Value, key: &str) -> f64 {
    way[key].as_f64().unwrap_or_else(|| panic!("{key} of {way}"))
}

#[test]
fn all_ways_are_timed_on_one_walk() {
    let bench = Workbench::with_ball();
    let report =
        bench.json("bench-gpu sphere.obj shape:two-materials --frames 4 --size 64x48 --software --quiet");
    assert_eq!(report["adapter"]["draws_on_the_processor"], true);
    assert!(!report["adapter"]["name"].as_str().unwrap().is_empty());
    assert_eq!(report["size"], serde_json::json!([64, 48]));
    let meshes = report["meshes"].as_array().unwrap();
    assert_eq!(meshes.len(), 2);
    for mesh in meshes {
        let ways = mesh["ways"].as_array().unwrap();
        let names: Vec<&str> = ways.iter().map(|way| way["name"].as_str().unwrap()).collect();
        assert_eq!(names, WAYS);
        let of = |name: &str, key: &str| number(&ways[WAYS.iter().position(|&n| n == name).unwrap()], key);
        let indices = |name| of(name, "index_count");
        for same in ["fans", "fans-compute", "resident-list"] {
            assert_eq!(indices(same), indices("list"), "{same}");
        }
        assert_eq!(indices("resident-strips"), indices("strips"));
        assert!(indices("strips-staged") <= indices("strips"));
        // MTS cuts strips at 128 indices, and the published form does not.
        assert!(indices("mts-published") <= indices("mts"));
        assert!(indices("strips") < indices("list") && indices("strips-draws") < indices("strips"));
        assert!(indices("strips-ranges") >= indices("strips"));
        let sent = |name| of(name, "uploaded_bytes");
        assert_eq!(sent("list"), 4.0 * indices("list"));
        assert_eq!(sent("strips"), 4.0 * indices("strips"));
        assert!(sent("fans-compute") > 0.0 && sent("fans-compute") < sent("fans") / 20.0);
        for resident in ["resident-list", "resident-strips", "discrete"] {
            assert_eq!(sent(resident), 0.0, "{resident}");
        }
        for way in ways {
            let [update, frame] = ["update_secs", "frame_secs"].map(|key| &way[key]);
            for key in ["median", "p95"] {
                assert!(number(frame, key) > 0.0 && number(update, key) <= number(frame, key), "{way}");
            }
            assert!(number(frame, "median") <= number(frame, "p95"));
            assert!(number(way, "gpu_bytes") > 0.0);
            assert!(number(&way["recover_secs"], "median") <= number(update, "median"), "{way}");
            assert!((0.0..1.0).contains(&number(way, "recover_share")), "{way}");
            let speeds = way["frames_per_sec"].as_array().unwrap();
            assert!(speeds.len() == 3 && speeds.iter().all(|speed| speed.as_f64().unwrap() > 0.0), "{way}");
        }
    }
}

#[test]
fn exponential_walk_draws_fewer_triangles() {
    let bench = Workbench::with_ball();
    let indices = |pace: &str| {
        let line = "bench-gpu sphere.obj --ways list,mts --frames 8 --size 32x32 --software --quiet --pace";
        let report = bench.json(&format!("{line} {pace}"));
        assert_eq!(report["pace"], pace);
        number(&report["meshes"][0]["ways"][0], "index_count")
    };
    assert!(indices("exponential") < indices("linear"));
}

#[test]
fn table_names_the_adapter_and_explains_the_ways_it_shows() {
    let bench = Workbench::with_ball();
    let arguments = "bench-gpu ball.striata --ways fans-compute,discrete --frames 2 --size 32x32 --software";
    let assert = bench.run(arguments).success();
    let text = String::from_utf8_lossy(&assert.get_output().stdout).into_owned();
    assert!(text.contains("ball.striata: "), "{text}");
    assert!(text.contains("draws on the CPU"), "{text}");
    assert!(text.contains("\nfans-compute: ") && !text.contains("\nstrips-draws: "), "{text}");
}

#[test]
fn inputs_that_cannot_be_drawn_are_rejected() {
    let bench = Workbench::with_ball();
    let text = bench.refused("bench-gpu sphere.obj --ways list,nonsense --software");
    assert!(text.contains("\"nonsense\"") && text.contains("hint: --ways takes list, strips,"), "{text}");
    let text = bench.refused("bench-gpu sphere.obj --adapter no-such-adapter");
    assert!(text.contains("no-such-adapter") && text.contains("hint: name another"), "{text}");
    bench.write("dot.off", "OFF\n3 1 0\n1 1 1\n1 1 1\n1 1 1\n3 0 1 2\n");
    let text = bench.refused("bench-gpu dot.off --software");
    assert!(text.contains("dot.off: ") && text.contains("no triangles"), "{text}");
    bench.write("points.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n");
    let text = bench.refused("bench-gpu points.obj --software");
    assert!(text.contains("points.obj") && text.contains("no triangles"), "{text}");
    let text = bench.refused("bench-gpu no-such-file.ply --software");
    assert!(text.contains("no-such-file.ply"), "{text}");
    let text = bench.refused("bench-gpu sphere.obj --size 64x99999999 --software");
    assert!(text.contains("64 x 99999999"), "{text}");
}
