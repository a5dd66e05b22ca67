//! `show`: pictures of the structures in the papers.

use predicates::prelude::*;

use crate::workbench::Workbench;

#[test]
fn every_structure_is_drawn() {
    let bench = Workbench::with_ball();
    for (what, expected) in [
        ("mts", "level 0: "),
        ("tunnel", "Complementing its links joins the two strips."),
        ("fan", "in the table: ring "),
        ("pattern", "its floor, with two anchors"),
    ] {
        let report = bench.json(&format!("show {what} sphere.obj -o {what}.svg"));
        assert_eq!((&report["what"], &report["path"]), (&what.into(), &format!("{what}.svg").into()));
        let picture = String::from_utf8(bench.read(&format!("{what}.svg"))).expect("text");
        assert!(picture.starts_with("<svg") && picture.ends_with("</svg>\n"), "{what}");
        assert!(picture.contains(expected), "{what}: {picture}");
        assert!(!picture.contains("NaN") && picture.matches("<polyline").count() > 5, "{what}");
    }
}

#[test]
fn the_tunnel_removes_one_strip() {
    let bench = Workbench::with_ball();
    bench.json("show tunnel sphere.obj -o tunnel.svg --triangles 40");
    let picture = String::from_utf8(bench.read("tunnel.svg")).expect("text");
    let counts = picture.lines().filter_map(|line| {
        let (count, rest) = line.trim().split_once(' ')?;
        (rest == "strips" || rest == "strip").then(|| count.parse::<usize>().expect("a count"))
    });
    let counts: Vec<usize> = counts.collect();
    assert_eq!(counts.len(), 2, "{picture}");
    assert_eq!(counts[0], counts[1] + 1);
}

#[test]
fn what_cannot_be_drawn_is_said() {
    let bench = Workbench::with_ball();
    for (arguments, expected) in [
        ("show tunnel shape:cube -o cube.svg", "its flattest 60 triangles contain no tunnel"),
        ("show mts sphere.obj -o mts.png", "mts.png: pictures are SVG files"),
        ("show loop sphere.obj -o loop.svg", "invalid value 'loop'"),
        ("show fan missing.ply -o fan.svg", "missing.ply"),
    ] {
        bench.command(arguments).assert().failure().stderr(predicate::str::contains(expected));
    }
    assert!(!bench.path("cube.svg").exists() && !bench.path("mts.png").exists());
}
