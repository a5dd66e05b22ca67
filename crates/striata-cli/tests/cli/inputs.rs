//! Parts that are left out of an input give a warning, an entry of the report, or an error.

use crate::workbench::Workbench;

const OBJ: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv nan 0 0\nvw 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\nf 1 2 5\nvw 2\n";

#[test]
fn warnings_count_what_was_left_out() {
    let bench = Workbench::new();
    bench.write("a.obj", OBJ);
    for verb in [
        "info a.obj",
        "convert a.obj b.ply",
        "build a.obj -o b.striata",
        "simplify a.obj -o b.ply --detail 1",
    ] {
        let stderr = bench.run(verb).success().get_output().stderr.clone();
        let stderr = String::from_utf8_lossy(&stderr).into_owned();
        let lines = "warning: a.obj: 2 lines skipped, the first is line 6: unknown statement \"vw\"\n";
        assert!(stderr.contains(lines) && stderr.contains("1 triangle left out"), "{verb}: {stderr}");
        assert_eq!(stderr.matches("warning: ").count(), 2, "{verb}: {stderr}");
        let report = bench.json(verb);
        assert_eq!(report["warnings"][0]["count"], 2, "{verb}: {report}");
        assert_eq!(report["warnings"][1]["what"], "triangle left out", "{verb}: {report}");
    }
    bench.run("info a.obj --quiet").success();
    assert!(!bench.refused("convert a.obj c.ply --strict-input").is_empty());
    assert!(bench.refused("info a.obj --strict-input").contains("(and 1 more warning)"));
    assert_eq!(bench.names(), ["a.obj", "b.ply", "b.striata"]);
}

#[test]
fn points_are_refused_before_anything_is_written() {
    let bench = Workbench::new();
    bench.write("a.obj", "v 0 0 0\nv 1 0 0\n");
    for verb in ["build a.obj -o b.striata", "convert a.obj b.ply", "simplify a.obj -o b.ply --ratio 0.5"] {
        let message = bench.refused(verb);
        assert!(message.contains("the file has 2 points and no triangles"), "{verb}: {message}");
    }
    assert_eq!(bench.names(), ["a.obj"]);
}
