//! scratch
#![allow(clippy::print_stdout, reason = "x")]
use striata::simplify::*;
use striata::mesh::*;
fn main() {
    for path in std::env::args().skip(1) {
        let mesh = striata_io::read(&path).unwrap();
        let out = build_sequence(&mesh, &SequenceOptions::default(), &mut striata::ignore_progress).unwrap();
        let s = &out.refinable.sequence;
        for n in (0..=s.step_count()).rev() {
            let l = replay(&out.refinable, n);
            if l.triangle_count() != s.triangle_count_at(n) {
                println!("{path} first differs at {n} of {}: {} vs {}: removed {}", s.step_count(), l.triangle_count(), s.triangle_count_at(n), s.removed_triangle_counts()[n]);
                break;
            }
        }
    }
}
