//! Puts `striata serve` under load with 180 quick clients, then also with 20 slow ones, all on this machine.
//!
//! Run it with `cargo run --release --manifest-path lab/Cargo.toml --example load [SECS]` after building the command.

use std::io::Write;
use std::time::Duration;

use striata_testing::server::{Connection, LoadPlan, Server, run, write_file};

/// Longer runs give no more information.
const MAX_SECS: u64 = 600;

fn main() {
    let secs = std::env::args().nth(1).map_or(60, |text| text.parse().expect("seconds, a whole number"));
    let duration = Duration::from_secs(secs.min(MAX_SECS));
    let example = std::env::current_exe().expect("a path");
    let program = example.with_file_name("").join("../striata");
    let folder = tempfile::tempdir().expect("a temporary folder");
    write_file(folder.path());
    let server = Server::start(&program, folder.path(), &[]);
    let list = Connection::open(server.address).and_then(|mut c| c.get("/models.json", "")).expect("a list");
    print(&format!("{}: {}", server.report["url"], String::from_utf8_lossy(&list.body)));
    let is_there = !list.header("etag").is_empty() && list.status == 200;
    assert!(is_there, "the server does not respond correctly");
    for plan in [
        LoadPlan { quick: 180, slow: 0, lasts: duration / 2 },
        LoadPlan { quick: 180, slow: 20, lasts: duration },
    ] {
        let outcome = run(&server, plan);
        let last = outcome.latencies.len().saturating_sub(1);
        let ms = |per_mille: usize| {
            let latency = outcome.latencies.get(last * per_mille / 1000).copied().unwrap_or_default();
            latency.as_secs_f64() * 1e3
        };
        let resident = &outcome.resident_kb;
        print(&format!(
            "{} quick, {} slow, {:.0} s: {} responses, {} errors {:?}; latency 50 % {:.2} ms, 95 % {:.2} \
             ms, 99 % {:.2} ms, \
             longest {:.2} ms; slow clients received {} bytes; memory {} to {} kB, at the end {} kB, peak \
             {} kB",
            plan.quick,
            plan.slow,
            plan.lasts.as_secs_f64(),
            outcome.latencies.len(),
            outcome.errors.len(),
            outcome.errors.first(),
            ms(500),
            ms(950),
            ms(990),
            ms(1000),
            outcome.slow_bytes,
            resident.iter().min().unwrap_or(&0),
            resident.iter().max().unwrap_or(&0),
            resident.last().unwrap_or(&0),
            outcome.peak_kb,
        ));
    }
    print(&format!("exit after termination: {}", server.end()));
}

fn print(text: &str) {
    // A closed stdout is no reason to fail.
    let _ = writeln!(std::io::stdout(), "{text}");
}
