//! scratch
#![allow(clippy::print_stdout, reason = "x")]
use std::time::Instant;
fn main() {
    for path in std::env::args().skip(1) {
        let d = std::fs::read(&path).unwrap();
        let hdr_end = d.windows(11).position(|w| w == b"end_header\n").unwrap() + 11;
        let h = std::str::from_utf8(&d[..hdr_end]).unwrap();
        let num = |k: &str| h.lines().find(|l| l.starts_with(k)).unwrap().rsplit(' ').next().unwrap().parse::<usize>().unwrap();
        let (nv, nf) = (num("element vertex"), num("element face"));
        let f = |o: usize| f32::from_le_bytes(d[o..o + 4].try_into().unwrap());
        let i = |o: usize| u32::from_le_bytes(d[o..o + 4].try_into().unwrap());
        let p: Vec<[f32; 3]> = (0..nv).map(|v| [0, 4, 8].map(|k| f(hdr_end + v * 12 + k))).collect();
        let fo = hdr_end + nv * 12;
        let t: Vec<[u32; 3]> = (0..nf).map(|v| [1, 5, 9].map(|k| i(fo + v * 13 + k))).collect();
        let mesh = striata::mesh::IndexedMesh::new(p, t);
        for _ in 0..2 {
            let t0 = Instant::now();
            let w = striata::mesh::weld(&mesh).unwrap();
            let t1 = Instant::now();
            let out = striata::simplify::build_welded_sequence(w, &Default::default(), &mut striata::ignore_progress).unwrap();
            let t2 = Instant::now();
            let verts = bytemuck::cast_slice::<[f32; 3], u8>(&mesh.positions);
            let a = meshopt::VertexDataAdapter::new(verts, 12, 0).unwrap();
            let idx = bytemuck::cast_slice::<[u32; 3], u32>(&mesh.triangles);
            let t3 = Instant::now();
            let r = meshopt::simplify(idx, &a, (nf as f64 * 0.02) as usize * 3, 1e9, meshopt::SimplifyOptions::None, None);
            let t4 = Instant::now();
            let s = &out.refinable.sequence;
            println!("{path}: weld {:?} simplify {:?} meshopt {:?} ratio {:.2}  base {} tris, steps {}, err10 {}", t1 - t0, t2 - t1, t4 - t3, (t2 - t1).as_secs_f64() / (t4 - t3).as_secs_f64(), s.triangle_count_at(0), s.step_count(), s.error_at(s.split_count_for_triangles(nf / 10)) / mesh.diagonal() as f32);
            let _ = r;
            for k in 0..=10 { let n = s.step_count()*k/10; let l = striata::mesh::replay(&out.refinable, n); assert_eq!(l.triangle_count(), s.triangle_count_at(n)); }
        }
    }
}
