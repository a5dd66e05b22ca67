//! `compare`: the report has every requested key and row, and the page is self-contained.

use striata_strip::{StripOptions, Stripifier, stripify};

use crate::workbench::{Workbench, assert_keys};

/// Arguments that compare strips only, with little work.
const QUICK: &str = "--parts strips --seeds 2 --tunnels 1,3,5 --budgets 0.01,0.02";

#[test]
fn report_has_all_lengths_and_stripifiers() {
    let bench = Workbench::with_ball();
    let report =
        bench.json(&format!("compare sphere.obj ball.striata {QUICK} --strips greedy,greedy+tunnel:3"));
    assert_keys(&report, &["command", "machine", "meshes", "secs"]);
    let meshes = report["meshes"].as_array().expect("a list");
    let names: Vec<&str> = meshes.iter().filter_map(|mesh| mesh["name"].as_str()).collect();
    assert_eq!(names, ["sphere.obj", "ball.striata"]);
    for mesh in meshes {
        assert_eq!((&mesh["triangle_count"], &mesh["component_count"]), (&512.into(), &1.into()));
        let lengths = mesh["strips"]["tunnel_lengths"].as_array().expect("a list");
        let settings: Vec<(&str, u64)> = lengths
            .iter()
            .map(|row| {
                (row["search"].as_str().expect("a name"), row["max_length"].as_u64().expect("a length"))
            })
            .collect();
        for length in [1, 3, 5] {
            for search in
                ["published", "per-path", "shortest-first", "same-strip", "static", "grown", "tunnel"]
            {
                assert!(settings.contains(&(search, length)), "{search} {length}: {settings:?}");
            }
        }
        assert_eq!(settings.len(), 21);
        for row in lengths {
            assert_keys(row, &["seeds", "mean", "min", "max", "std", "secs", "secs_std"]);
            let [mean, min, max] = ["mean", "min", "max"].map(|key| row[key].as_f64().expect("a number"));
            assert!(row["seeds"] == 2 && 1.0 <= min && min <= mean && mean <= max, "{row}");
        }
        let rows = mesh["strips"]["stripifiers"].as_array().expect("a list");
        for algorithm in ["greedy", "greedy+tunnel:3", "tomesh"] {
            assert!(rows.iter().any(|row| row["algorithm"] == algorithm), "{algorithm}: {rows:?}");
        }
        for row in rows {
            let keys = [
                "strip_count",
                "swap_count",
                "index_count",
                "indices_per_triangle",
                "acmr_16",
                "atvr_16",
                "secs",
            ];
            assert_keys(row, &keys);
            assert_eq!(row["triangle_count"], 512);
        }
    }
}

#[test]
fn tunnel_lengths_agree_with_the_stripifier() {
    let bench = Workbench::with_ball();
    let report = bench.json("compare sphere.obj --parts strips --seeds 1 --tunnels 3 --strips tunnel:3");
    let mesh = striata_io::read(bench.path("sphere.obj")).expect("a mesh");
    let options = StripOptions::default().with_stripifier(Stripifier::Tunnel { max_length: 3 });
    let alone = stripify(&mesh, &options).expect("strips").cost();
    let strips = &report["meshes"][0]["strips"];
    let mut lengths = strips["tunnel_lengths"].as_array().expect("a list").iter();
    let row = lengths.find(|row| row["search"] == "tunnel" && row["max_length"] == 3);
    assert_eq!(row.expect("a row")["min"], alone.strip_count);
    assert_eq!(strips["stripifiers"][0]["index_count"], alone.index_count);
}

#[test]
fn search_based_stripifiers_run_with_every_budget_and_without() {
    let bench = Workbench::with_ball();
    let report = bench.json(&format!("compare sphere.obj {QUICK} --strips greedy,cheapest"));
    let rows = report["meshes"][0]["strips"]["stripifiers"].as_array().expect("a list");
    let budgets = |algorithm: &str| -> Vec<Option<f64>> {
        rows.iter()
            .filter(|row| row["algorithm"] == algorithm)
            .map(|row| row["budget_secs"].as_f64())
            .collect()
    };
    assert_eq!(budgets("greedy"), [None]);
    assert_eq!(budgets("cheapest"), [Some(0.01), Some(0.02), None]);
}

#[test]
fn page_is_self_contained() {
    let bench = Workbench::with_ball();
    let assert = bench.run(&format!("compare sphere.obj {QUICK} --html page.html")).success();
    let text = String::from_utf8_lossy(&assert.get_output().stdout).into_owned();
    assert!(text.contains("per-path") && text.contains("tomesh") && text.contains("greedy"), "{text}");
    let page = String::from_utf8(bench.read("page.html")).expect("text");
    assert!(page.starts_with("<!doctype html>") && page.ends_with("</html>\n"));
    assert!(
        page.contains(
            "striata-lab compare sphere.obj --parts strips --seeds 2 --tunnels 1,3,5 --budgets 0.01,0.02 --html page.html"
        ),
        "no command line"
    );
    assert_eq!(page.matches("<svg").count(), 3);
    assert_eq!(page.matches("<table>").count(), 2);
    assert!(!page.contains("{{") && !page.contains("src=\"") && !page.contains("href=\"http"));
    let piped = bench.run(&format!("compare sphere.obj {QUICK} --html - --quiet")).success();
    assert!(piped.get_output().stdout.starts_with(b"<!doctype html>"));
}

#[test]
fn meshes_without_triangles_can_be_compared() {
    let bench = Workbench::new();
    bench.write("cloud.off", "OFF\n0 0 0\n");
    bench.write("one.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    bench.run(&format!("compare cloud.off one.off {QUICK} --html page.html")).success();
    let report = bench.json(&format!("compare cloud.off one.off {QUICK}"));
    for (mesh, strips) in [(0, 0), (1, 1)] {
        let strips_of = &report["meshes"][mesh]["strips"];
        assert_eq!(strips_of["tunnel_lengths"][0]["max"], strips);
        assert_eq!(strips_of["stripifiers"][0]["strip_count"], strips);
    }
}

#[test]
fn invalid_comparisons_are_rejected_immediately() {
    let bench = Workbench::with_ball();
    for (arguments, expected) in [
        ("compare", "<INPUT>"),
        ("compare nowhere.ply", "nowhere.ply"),
        ("compare sphere.obj nowhere.ply --seeds 1000 --tunnels 999", "nowhere.ply"),
        ("compare sphere.obj --strips greedy,zigzag", "zigzag"),
        ("compare sphere.obj --strips tunnel:0", "tunnel:0"),
        ("compare sphere.obj --tunnels 0", "1..=999"),
        ("compare sphere.obj --tunnel-searches greedy", "per-path"),
        ("compare sphere.obj --seeds 0", "1..=1000"),
        ("compare sphere.obj --budgets 1,x", "0 or more"),
        ("compare sphere.obj --parts strips,models,walks", "walks"),
        ("compare sphere.obj --frames 0", "1..=10000"),
        ("compare sphere.obj --model-strips zigzag", "zigzag"),
        (
            "compare nowhere.ply --models lodstrips,vdpm",
            "hint: this version has: lodstrips, lodstrips-staged, mts, ",
        ),
        ("compare shape:ball", "hint: there are: sphere, torus, "),
        ("compare sphere.obj --html no/page.html", "hint: create the output folder first"),
        ("compare sphere.obj --html - --json", "stdout"),
    ] {
        let message = bench.refused(arguments);
        assert!(message.contains(expected), "{arguments}: {message}");
    }
    bench.write("nan.off", "OFF\n4 2 0\n0 0 0\n1 0 0\n0 nan 0\n1 1 0\n3 0 1 2\n3 1 3 2\n");
    let message = bench.refused("compare nan.off --html page.html --quiet");
    assert!(message.starts_with("error: nan.off: ") && message.contains("vertex 2"), "{message}");
    assert_eq!(bench.names(), ["ball.striata", "nan.off", "sphere.obj"]);
}
