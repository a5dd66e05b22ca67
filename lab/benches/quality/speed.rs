//! Time of our whole sequence compared with meshoptimizer's single level.

use std::hint::black_box;
use std::io::Write;
use std::time::Instant;

use striata::mesh::weld;

use crate::table::Table;
use crate::{Fallible, Request, SHARES, Subject};

/// Seconds of one run and its result; dropping the result is not timed.
fn timed<T>(work: impl FnOnce() -> T) -> (f64, T) {
    let start = Instant::now();
    let result = black_box(work());
    (start.elapsed().as_secs_f64(), result)
}

pub(crate) fn report(request: &Request, subjects: &[Subject], out: &mut dyn Write) -> Fallible<()> {
    let share = SHARES[SHARES.len() - 1];
    writeln!(
        out,
        "Best of {} alternating runs on one thread: our whole sequence against \
         meshoptimizer's one level of {} %.\n",
        request.repeat_count,
        share * 100.0
    )?;
    let mut table = Table::new([
        "mesh",
        "triangles",
        "cost",
        "weld ms",
        "sequence ms",
        "meshoptimizer ms",
        "ratio",
        "µs per triangle",
    ]);
    for subject in subjects {
        for simplifier in &request.simplifiers {
            let (mut ours, mut peer, mut welding) = (f64::INFINITY, f64::INFINITY, f64::INFINITY);
            for _ in 0..request.repeat_count {
                welding = welding.min(timed(|| weld(subject.mesh())).0);
                let input = subject.welded.clone();
                let (secs, built) = timed(|| simplifier.build(input));
                built?;
                ours = ours.min(secs);
                let (secs, indices) = timed(|| subject.meshoptimizer(share));
                indices?;
                peer = peer.min(secs);
            }
            let triangle_count = subject.mesh().triangle_count();
            table.push(vec![
                subject.name.clone(),
                triangle_count.to_string(),
                simplifier.name(),
                format!("{:.1}", welding * 1e3),
                format!("{:.1}", ours * 1e3),
                format!("{:.1}", peer * 1e3),
                format!("{:.2}", ours / peer),
                format!("{:.3}", ours * 1e6 / triangle_count as f64),
            ]);
        }
    }
    table.print(out)?;
    Ok(())
}
