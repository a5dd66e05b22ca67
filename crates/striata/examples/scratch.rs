//! scratch
#![allow(clippy::print_stdout, reason = "x")]
use std::time::Instant;
use striata::mesh::*;
use striata::simplify::*;
fn load(path: &str) -> IndexedMesh {
    let d = std::fs::read(path).unwrap();
    let hdr_end = d.windows(11).position(|w| w == b"end_header\n").unwrap() + 11;
    let h = std::str::from_utf8(&d[..hdr_end]).unwrap();
    let num = |k: &str| {
        h.lines().find(|l| l.starts_with(k)).unwrap().rsplit(' ').next().unwrap().parse::<usize>().unwrap()
    };
    let (nv, nf) = (num("element vertex"), num("element face"));
    let f = |o: usize| f32::from_le_bytes(d[o..o + 4].try_into().unwrap());
    let i = |o: usize| u32::from_le_bytes(d[o..o + 4].try_into().unwrap());
    let p: Vec<[f32; 3]> = (0..nv).map(|v| [0, 4, 8].map(|k| f(hdr_end + v * 12 + k))).collect();
    let fo = hdr_end + nv * 12;
    let t: Vec<[u32; 3]> = (0..nf).map(|v| [1, 5, 9].map(|k| i(fo + v * 13 + k))).collect();
    IndexedMesh::new(p, t)
}
fn main() {
    let cost = match std::env::var("COST").as_deref() {
        Ok("t") => CollapseCost::Tracked,
        Ok("a") => CollapseCost::Accumulated,
        _ => CollapseCost::Memoryless,
    };
    let shares = [0.5, 0.25, 0.1, 0.02];
    let mut logs = vec![[0.0f64; 2]; 4];
    let mut n = 0.0;
    for path in std::env::args().skip(1) {
        let mesh = load(&path);
        let nf = mesh.triangle_count();
        if let Ok(r) = std::env::var("R") {
            let (mut o, mut m) = (f64::MAX, f64::MAX);
            let w = weld(&mesh).unwrap();
            for _ in 0..r.parse().unwrap() {
                let w2 = w.clone();
                let t = Instant::now();
                let out = build_welded_sequence(
                    w2,
                    &SequenceOptions::default().with_cost(cost),
                    &mut striata::ignore_progress,
                )
                .unwrap();
                o = o.min(t.elapsed().as_secs_f64());
                let verts = bytemuck::cast_slice::<[f32; 3], u8>(&w.mesh.positions);
                let a = meshopt::VertexDataAdapter::new(verts, 12, 0).unwrap();
                let idx = bytemuck::cast_slice::<[u32; 3], u32>(&w.mesh.triangles);
                let t = Instant::now();
                meshopt::simplify(
                    idx,
                    &a,
                    (nf as f64 * 0.02) as usize * 3,
                    1e9,
                    meshopt::SimplifyOptions::None,
                    None,
                );
                m = m.min(t.elapsed().as_secs_f64());
                drop(out);
            }
            println!(
                "{path}: best ours {:.2} ms ({:.3} us/tri) meshopt {:.2} ms ratio {:.2}",
                o * 1e3,
                o * 1e6 / nf as f64,
                m * 1e3,
                o / m
            );
            continue;
        }
        let w = weld(&mesh).unwrap();
        let wm = w.mesh.clone();
        let t1 = Instant::now();
        let out = build_welded_sequence(
            w,
            &SequenceOptions::default().with_cost(cost),
            &mut striata::ignore_progress,
        )
        .unwrap();
        let t2 = Instant::now();
        let verts = bytemuck::cast_slice::<[f32; 3], u8>(&wm.positions);
        let a = meshopt::VertexDataAdapter::new(verts, 12, 0).unwrap();
        let idx = bytemuck::cast_slice::<[u32; 3], u32>(&wm.triangles);
        let t3 = Instant::now();
        let r = meshopt::simplify(
            idx,
            &a,
            (nf as f64 * 0.02) as usize * 3,
            1e9,
            meshopt::SimplifyOptions::None,
            None,
        );
        let t4 = Instant::now();
        let s = &out.refinable.sequence;
        println!(
            "{path}: simplify {:?} {:.2} us/tri meshopt {:?} ratio {:.2}  base {} tris",
            t2 - t1,
            (t2 - t1).as_secs_f64() * 1e6 / nf as f64,
            t4 - t3,
            (t2 - t1).as_secs_f64() / (t4 - t3).as_secs_f64(),
            s.triangle_count_at(0)
        );
        let _ = r;
        if std::env::var("Q").is_ok() {
            n += 1.0;
            let opt = DistanceOptions::default().with_sample_count(200_000);
            for (k, share) in shares.iter().enumerate() {
                let goal = (nf as f64 * share) as usize;
                let r = meshopt::simplify(idx, &a, goal * 3, 1e9, meshopt::SimplifyOptions::None, None);
                let mo = IndexedMesh::new(
                    wm.positions.clone(),
                    bytemuck::cast_slice::<u32, [u32; 3]>(&r).to_vec(),
                );
                let got = mo.triangle_count();
                let sc = s.split_count_for_triangles(got);
                let ours = replay(&out.refinable, sc);
                let d0 = surface_distance(&wm, &mo, &opt).unwrap();
                let d1 = surface_distance(&wm, &ours, &opt).unwrap();
                let g = 1e5 / d0.diagonal;
                println!(
                    "  {share}: tris {got}/{} meshopt {:.3} ({:.1}) ours {:.3} ({:.1}) ratio {:.3} ({:.3})  reported {:.1} vs one-sided {:.1}/{:.1}",
                    ours.triangle_count(),
                    d0.rms * g,
                    d0.max * g,
                    d1.rms * g,
                    d1.max * g,
                    d1.rms / d0.rms,
                    d1.max / d0.max,
                    s.error_at(sc) as f64 * g,
                    d1.a_to_b.max * g,
                    d1.b_to_a.max * g
                );
                logs[k][0] += (d1.rms / d0.rms).ln();
                logs[k][1] += (d1.max / d0.max).ln();
            }
        }
    }
    if n > 0.0 {
        for k in 0..4 {
            println!(
                "geomean {}: rms {:.3} max {:.3}",
                shares[k],
                (logs[k][0] / n).exp(),
                (logs[k][1] / n).exp()
            );
        }
    }
}
