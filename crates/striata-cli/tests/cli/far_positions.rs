//! Coordinates of surveys, which single precision cannot hold: every verb keeps them in place.

use crate::workbench::Workbench;

/// A wavy sheet of points 5 cm apart, in meters far from the origin.
fn survey() -> String {
    let side = 24;
    let at = |i: usize| (i / side, i % side);
    let vertex = |(x, y): (usize, usize)| {
        let [east, north] = [500_000.0 + 0.05 * x as f64, 5_000_000.0 + 0.05 * y as f64];
        format!("v {east:.2} {north:.2} {:.2}\n", 100.0 + 0.01 * ((x * y) % 7) as f64)
    };
    let vertices: String = (0..side * side).map(|i| vertex(at(i))).collect();
    let cells = (0..side * (side - 1)).filter(|i| i % side + 1 < side);
    let faces = cells.map(|i| {
        let [a, b, c, d] = [i + 1, i + 2, i + side + 2, i + side + 1];
        format!("f {a} {b} {c}\nf {a} {c} {d}\n")
    });
    vertices + &faces.collect::<String>()
}

fn points(bench: &Workbench, name: &str) -> Vec<[f64; 3]> {
    let text = String::from_utf8(bench.read(name)).unwrap();
    let lines = text.lines().filter_map(|line| line.strip_prefix("v "));
    let point = |line: &str| {
        let numbers: Vec<f64> = line.split(' ').map(|word| word.parse().unwrap()).collect();
        [numbers[0], numbers[1], numbers[2]]
    };
    lines.map(point).collect()
}

/// Largest distance of a point of one list from the nearest of another.
fn largest_move(points: &[[f64; 3]], from: &[[f64; 3]]) -> f64 {
    let distance = |a: &[f64; 3], b: &[f64; 3]| (0..3).map(|i| (a[i] - b[i]).abs()).fold(0.0, f64::max);
    let nearest = |p: &[f64; 3]| from.iter().map(|q| distance(p, q)).fold(f64::INFINITY, f64::min);
    points.iter().map(nearest).fold(0.0, f64::max)
}

#[test]
fn points_stay_where_they_are() {
    let bench = Workbench::new();
    bench.write("a.obj", survey());
    let input = points(&bench, "a.obj");
    // A ten-millionth of the diagonal.
    let allowed = 1.7e-7;
    for (verbs, allowed) in [
        (&["simplify a.obj -o b.obj --ratio 0.3"][..], 0.0),
        (&["convert a.obj b.ply", "convert b.ply b.obj"], 0.0),
        (&["convert a.obj b.off", "convert b.off b.obj"], 0.0),
        (&["convert a.obj b.glb", "convert b.glb b.obj"], allowed),
        (&["build a.obj -o b.striata", "extract b.striata -o b.obj --ratio 0.5"], allowed),
        (&["build a.obj -o b.striata --order hausdorff", "extract b.striata -o b.obj --ratio 0.5"], allowed),
        (&["encode a.obj -o b.stri --lossless", "decode b.stri -o b.obj"], allowed),
        (&["build a.obj -o b.striata --paged --exact", "extract b.striata -o b.obj --ratio 0.5"], allowed),
    ] {
        for verb in verbs {
            bench.run(verb).success();
        }
        let found = points(&bench, "b.obj");
        assert!(found.len() > 50, "{verbs:?}");
        let moved = largest_move(&found, &input);
        assert!(moved <= allowed, "{verbs:?} moved a point by {moved:e}");
    }
    bench.run("convert a.obj b.ply").success();
    assert!(String::from_utf8_lossy(&bench.read("b.ply")).contains("property double x"));
}

#[test]
fn reports_views_and_distances_use_the_coordinates_of_the_file() {
    let bench = Workbench::new();
    bench.write("a.obj", survey());
    let info = bench.json("info a.obj");
    assert_eq!(info["bounds"]["min"], serde_json::json!([500_000.0, 5_000_000.0, 100.0]));
    assert_eq!((&info["degenerate_triangle_count"], info["origin"].is_array()), (&0.into(), true));
    bench.run("simplify a.obj -o small.obj --ratio 0.3").success();
    let distance = bench.json("distance a.obj small.obj");
    assert!(distance["max"].as_f64().unwrap() < 0.05, "{distance}");
    bench.run("build a.obj -o a.striata --models fans,patterns").success();
    let detail = "--detail-box 500000,5000000,0,500000.41,5000000.41,200 --triangles 500";
    bench.run(&format!("extract a.striata -o box.obj {detail}")).success();
    let near = |p: &[f64; 3]| p[0] < 500_000.41 && p[1] < 5_000_000.41;
    let corner = points(&bench, "box.obj").iter().filter(|p| near(p)).count();
    assert_eq!(corner, points(&bench, "a.obj").iter().filter(|p| near(p)).count(), "all of the box");
    let eye = "--eye 500000.2,5000000.2,100.5 --look-at 500000.2,5000000.2,100 --up 0,1,0 --pixels 1";
    let view = bench.json(&format!("extract a.striata -o view.obj {eye}"));
    assert!(view["triangle_count"].as_u64().unwrap() > 100, "{view}");
}
