//! Simplification orders and guaranteed errors.

use serde_json::Value;

use crate::workbench::{Workbench, asset};

pub(crate) fn number(report: &Value, key: &str) -> f64 {
    report[key].as_f64().unwrap_or_else(|| panic!("no number {key} in {report}"))
}

/// Returns the largest distance from one surface to the other.
pub(crate) fn distance(bench: &Workbench, from: &str, to: &str) -> f64 {
    let report = bench.json(&format!("distance {from} {to} --samples 20000"));
    number(&report["a_to_b"], "max")
}

/// Panics unless the distance of a level is at most its error, and at most a percentage of the diagonal.
fn check_guarantee(bench: &Workbench, input: &str, percent: f64, order: &str) {
    let line = format!("simplify {input} -o out.ply --max-error {percent}% {order}");
    let report = bench.json(&line);
    assert_eq!(report["error_is_guaranteed"], true, "{line}: {report}");
    let diagonal = number(&bench.json(&format!("info {input}")), "diagonal");
    let limit = percent / 100.0 * diagonal;
    let error = number(&report, "error");
    assert!(error <= limit, "{line}: {report}, limit {limit}");
    if report["triangle_count"] == 0 {
        return;
    }
    let measured = distance(bench, input, "out.ply");
    // Sample points between vertices are rounded.
    assert!(measured <= error + 1e-9 * diagonal, "{line}: measured {measured}, {report}");
    assert!(number(&report, "reverse_error") >= 0.0, "{report}");
}

const ORDERS: [&str; 3] =
    ["", "--order hausdorff", "--order hausdorff --retriangulation collapse --criterion flatness"];

#[test]
fn no_level_exceeds_its_guaranteed_error() {
    let bench = Workbench::with_ball();
    let spot = asset("spot.obj.zst").display().to_string();
    for input in ["sphere.obj", "shape:cylinder", "shape:moebius", "shape:two-materials", "shape:cube", &spot]
    {
        for order in ORDERS {
            let percent = if order.contains("collapse") { 5.0 } else { 0.4 };
            check_guarantee(&bench, input, percent, order);
        }
    }
    for input in ["shape:grid", "shape:terrain", "shape:klein-bottle", "shape:tetrahedron"] {
        check_guarantee(&bench, input, 1.0, "");
        check_guarantee(&bench, input, 1.0, "--order hausdorff");
    }
}

#[test]
fn a_large_scan_does_not_exceed_its_guaranteed_error() {
    let bench = Workbench::new();
    let bust = concat!(env!("CARGO_MANIFEST_DIR"), "/assets/nefertiti.ply.zst");
    check_guarantee(&bench, bust, 0.2, "");
    check_guarantee(&bench, bust, 0.2, "--order hausdorff");
}

#[test]
fn triangle_soups_do_not_exceed_their_guaranteed_error() {
    let bench = Workbench::new();
    // Three triangles at one edge, a separate one, a duplicate, one without area, and an unused vertex.
    bench.write(
        "soup.off",
        "OFF\n10 7 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n0 -1 0.5\n5 5 5\n6 5 5\n5 6 5\n9 9 9\n0.5 0 0\n\
         3 0 1 2\n3 0 1 3\n3 0 1 4\n3 5 6 7\n3 5 6 7\n3 0 9 1\n3 5 7 5\n",
    );
    for order in ORDERS {
        for percent in [0.0, 3.0, 20.0, 100.0] {
            check_guarantee(&bench, "soup.off", percent, order);
        }
    }
    bench.write("empty.off", "OFF\n0 0 0\n");
    for order in ORDERS {
        let report = bench.json(&format!("simplify empty.off -o out.ply --max-error 1 {order}"));
        assert!(report["triangle_count"] == 0 && report["reverse_error"].is_null(), "{report}");
    }
}

#[test]
fn vertex_removal_respects_its_flags() {
    let bench = Workbench::with_ball();
    let simplified = |flags: &str| bench.json(&format!("simplify sphere.obj -o out.ply {flags}"));
    let plain = simplified("--triangles 128");
    assert_eq!((&plain["order"], &plain["error_is_guaranteed"]), (&"quadric".into(), &false.into()));
    assert!(plain.get("reverse_error").is_none(), "{plain}");
    let free = simplified("--triangles 128 --order hausdorff");
    assert_eq!((&free["order"], &free["stop_reason"]), (&"hausdorff".into(), &"target_reached".into()));
    assert!((126..=128).contains(&free["triangle_count"].as_u64().expect("a count")), "{free}");
    let level = bench.read("out.ply");
    for flags in [
        "--retriangulation collapse",
        "--criterion shape",
        "--criterion flatness",
        "--degree-limit 4",
        "--feature-angle 5",
    ] {
        simplified(&format!("--triangles 128 --order hausdorff {flags}"));
        assert_ne!(bench.read("out.ply"), level, "{flags} has no effect");
    }
    // A limit alone selects a level; together with another target, the finer of both counts.
    let far = simplified("--max-error 4% --order hausdorff");
    assert_eq!(far["stop_reason"], "error_limit");
    let again = simplified("--error 4% --order hausdorff");
    assert_eq!(
        (&again["stop_reason"], &again["triangle_count"]),
        (&"target_reached".into(), &far["triangle_count"])
    );
    for order in ["", "--order hausdorff"] {
        let limited = simplified(&format!("--triangles 20 --max-error 4% {order}"));
        assert!(
            limited["stop_reason"] == "error_limit" && number(&limited, "triangle_count") > 20.0,
            "{limited}"
        );
        let unlimited = simplified(&format!("--triangles 400 --max-error 4% {order}"));
        assert!(unlimited["stop_reason"] == "target_reached", "{unlimited}");
        assert!((398..=400).contains(&unlimited["triangle_count"].as_u64().expect("a count")), "{unlimited}");
    }
    let certain = simplified("--triangles 128 --certify");
    assert_eq!((&certain["order"], &certain["error_is_guaranteed"]), (&"quadric".into(), &true.into()));
    assert_eq!(certain["triangle_count"], plain["triangle_count"]);
    let assert = bench.run("simplify sphere.obj -o out.ply --triangles 128 --order hausdorff").success();
    let stderr = String::from_utf8_lossy(&assert.get_output().stderr).into_owned();
    assert!(stderr.contains("guaranteed error ") && stderr.contains("(sampled, "), "{stderr}");
}

#[test]
fn files_store_whether_errors_are_guaranteed() {
    let bench = Workbench::with_ball();
    for (flags, is_guaranteed) in [
        ("", false),
        ("--certify", true),
        ("--max-error 3%", true),
        ("--order hausdorff", true),
        ("--order hausdorff --max-error 3%", true),
    ] {
        let report = bench.json(&format!("build sphere.obj -o it.striata --models lodstrips,fans {flags}"));
        assert_eq!(report["error_is_guaranteed"], is_guaranteed, "{flags}: {report}");
        let order = if flags.contains("hausdorff") { "hausdorff" } else { "quadric" };
        assert_eq!(report["order"], order);
        let info = bench.json("info it.striata");
        assert_eq!(
            (&info["error_is_guaranteed"], &info["error_max"]),
            (&is_guaranteed.into(), &report["error_max"])
        );
        let limit = 0.03 * number(&info, "diagonal");
        assert!(!flags.contains("max-error") || number(&report, "error_max") <= limit, "{report}");
        assert!(!flags.contains("max-error") || report["stop_reason"] == "error_limit", "{report}");
        for detail in ["0", "0.2", "0.6"] {
            let level = bench.json(&format!("extract it.striata -o level.ply --detail {detail}"));
            assert_eq!(level["error_is_guaranteed"], is_guaranteed, "{level}");
            let measured = distance(&bench, "sphere.obj", "level.ply");
            assert!(
                !is_guaranteed || measured <= 1.000_001 * number(&level, "error"),
                "{flags}: {measured}, {level}"
            );
        }
    }
    let quadric = bench.json("build sphere.obj -o it.striata --max-error 3% --base 400");
    assert_eq!(quadric["stop_reason"], "target_reached");
}

#[test]
fn models_that_need_collapses_switch_the_retriangulation() {
    let bench = Workbench::with_ball();
    let assert = bench.run("build sphere.obj -o it.striata --order hausdorff").success();
    let stderr = String::from_utf8_lossy(&assert.get_output().stderr).into_owned();
    assert!(
        stderr.contains(
            "note: using --retriangulation collapse, which model lodstrips \
        requires"
        ),
        "{stderr}"
    );
    let assert =
        bench.run("build sphere.obj -o same.striata --order hausdorff --retriangulation collapse").success();
    let stderr = String::from_utf8_lossy(&assert.get_output().stderr).into_owned();
    assert!(!stderr.contains("which model lodstrips"), "{stderr}");
    assert_eq!(bench.read("it.striata"), bench.read("same.striata"));
    let message =
        bench.refused("build sphere.obj -o x.striata --order hausdorff --retriangulation free --models mts");
    assert!(
        message.contains("model mts does not support free retriangulation")
            && message.contains(
                "hint: \
            remove --retriangulation"
            ),
        "{message}"
    );
}

#[test]
fn contradicting_flags_are_refused() {
    let bench = Workbench::with_ball();
    let level = "-o x.ply --triangles 100";
    for (arguments, named) in [
        (format!("simplify sphere.obj {level} --criterion shape"), "hint: use --order hausdorff"),
        (
            format!("simplify sphere.obj {level} --degree-limit 8"),
            "--degree-limit has no meaning in quadric order",
        ),
        (format!("simplify sphere.obj {level} --feature-angle 30"), "--feature-angle has no meaning"),
        (
            "build sphere.obj -o x.striata --retriangulation free".to_owned(),
            "--retriangulation has no meaning",
        ),
        (
            "build sphere.obj -o x.striata --order hausdorff --cost tracked".to_owned(),
            "hint: use --order quadric",
        ),
        (
            format!("simplify sphere.obj {level} --order hausdorff --pair-distance 1"),
            "--pair-distance has \
            no meaning",
        ),
        (
            format!("simplify sphere.obj {level} --order hausdorff --placement optimal"),
            "remove --placement optimal",
        ),
        (format!("simplify sphere.obj {level} --max-error 1 --placement optimal"), "or --max-error"),
        (format!("simplify sphere.obj {level} --certify --placement optimal"), "or --certify"),
        (format!("simplify sphere.obj {level} --order hausdorff --degree-limit 2"), "3..=16"),
        (format!("simplify sphere.obj {level} --order hausdorff --degree-limit 17"), "3..=16"),
        (format!("simplify sphere.obj {level} --order hausdorff --feature-angle 181"), "0 to 180"),
        (
            format!("simplify sphere.obj {level} --order hausdorff --criterion beauty"),
            "distance, maximum, flatness, shape",
        ),
        (format!("simplify sphere.obj {level} --max-error -1"), "not a length"),
        (format!("simplify sphere.obj {level} --order sideways"), "quadric, hausdorff"),
        ("simplify sphere.obj -o x.ply --order hausdorff".to_owned(), "--max-error"),
    ] {
        let message = bench.refused(&arguments);
        assert!(message.contains(named), "{arguments}: {message}");
    }
    assert_eq!(bench.names(), ["ball.striata", "sphere.obj"]);
}

#[test]
fn inconsistent_meshes_are_refused_in_both_orders() {
    let bench = Workbench::new();
    bench.write("nan.off", "OFF\n4 2 0\n0 0 0\n1 0 0\n0 nan 0\n1 1 0\n3 0 1 2\n3 1 3 2\n");
    bench.write("bad.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n");
    for order in ORDERS {
        let message = bench.refused(&format!("simplify nan.off -o x.ply --max-error 1% {order}"));
        assert!(message.starts_with("error: nan.off: ") && message.contains("vertex 2"), "{message}");
        let message = bench.refused(&format!("simplify bad.off -o x.ply --max-error 1% {order}"));
        assert!(message.contains("bad.off") && message.contains('7'), "{message}");
    }
    let message = bench.refused("build nan.off -o x.striata --order hausdorff");
    assert!(message.contains("nan.off: ") && message.contains("vertex 2"), "{message}");
    assert_eq!(bench.names(), ["bad.off", "nan.off"]);
}
