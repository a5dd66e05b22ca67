//! Many clients at the same time, some of them slow.
//!
//! Quick clients read random ranges of one file and check every byte. Slow clients read the whole file at a
//! kilobyte per second, through small windows. The memory of the server is sampled meanwhile. The test ends
//! by itself.

use std::io::{self, Read, Write};
use std::net::{SocketAddr, TcpStream};
use std::path::Path;
use std::thread;
use std::time::{Duration, Instant};

use socket2::{Domain, Socket, Type};

use super::client::{Connection, PATIENCE, Server};

/// Name of the file that is read.
pub const FILE: &str = "large.stl";
/// Size of the file: larger than all buffers between the server and a slow client.
const FILE_BYTES: usize = 24 << 20;
/// Length of the longest range.
const MAX_RANGE: u64 = 64 << 10;
/// Bytes that a slow client reads per second.
const SLOW_BYTES: usize = 1024;
/// Interval between samples of the memory.
const SAMPLED_EVERY: Duration = Duration::from_millis(200);

/// The load to apply.
#[derive(Clone, Copy, Debug)]
pub struct LoadPlan {
    /// Number of clients that read ranges.
    pub quick: usize,
    /// Number of clients that read a kilobyte per second.
    pub slow: usize,
    /// Duration, extended until every client has received something twice.
    pub lasts: Duration,
}

/// The measurements.
#[derive(Debug, Default)]
pub struct LoadOutcome {
    /// Latency of each response to a quick client, in ascending order.
    pub latencies: Vec<Duration>,
    /// Bytes received by slow clients.
    pub slow_bytes: usize,
    /// Resident memory of the server at each sample, kB.
    pub resident_kb: Vec<u64>,
    /// Peak resident memory of the server, kB.
    pub peak_kb: u64,
    /// Errors of clients.
    pub errors: Vec<String>,
}

/// Writes the file into a folder.
pub fn write_file(folder: &Path) {
    let bytes: Vec<u8> = (0..FILE_BYTES as u64).map(byte_at).collect();
    std::fs::write(folder.join(FILE), bytes).expect("the folder is ours");
}

/// Puts a server under load.
pub fn run(server: &Server, plan: LoadPlan) -> LoadOutcome {
    let until = Instant::now() + plan.lasts;
    let address = server.address;
    let quick: Vec<_> =
        (0..plan.quick as u64).map(|i| thread::spawn(move || read_ranges(address, i, until))).collect();
    let slow: Vec<_> = (0..plan.slow).map(|_| thread::spawn(move || read_slowly(address, until))).collect();
    let mut outcome = LoadOutcome::default();
    while Instant::now() < until {
        outcome.resident_kb.extend(memory_kb(server.id(), "VmRSS:"));
        thread::sleep(SAMPLED_EVERY);
    }
    outcome.peak_kb = memory_kb(server.id(), "VmHWM:").unwrap_or(0);
    for client in quick {
        match client.join().expect("clients report, they do not panic") {
            Ok(latencies) => outcome.latencies.extend(latencies),
            Err(error) => outcome.errors.push(format!("quick: {error}")),
        }
    }
    for client in slow {
        match client.join().expect("clients report, they do not panic") {
            Ok(bytes) => outcome.slow_bytes += bytes,
            Err(error) => outcome.errors.push(format!("slow: {error}")),
        }
    }
    outcome.latencies.sort();
    outcome
}

fn read_ranges(address: SocketAddr, seed: u64, until: Instant) -> io::Result<Vec<Duration>> {
    let mut connection = Connection::open(address)?;
    let (mut latencies, mut state) = (Vec::new(), seed);
    let mut below = |limit: u64| {
        state = state.wrapping_add(1);
        mixed(state.wrapping_mul(0x9e37_79b9) ^ seed << 40) % limit
    };
    while latencies.len() < 2 || Instant::now() < until {
        let length = 1 + below(MAX_RANGE);
        let start = below(FILE_BYTES as u64 - length);
        let sent = Instant::now();
        let range = format!("range: bytes={start}-{}\r\n", start + length - 1);
        let answer = connection.get(&format!("/models/{FILE}"), &range)?;
        latencies.push(sent.elapsed());
        let is_right = answer.body.iter().zip(start..).all(|(&byte, place)| byte == byte_at(place));
        if answer.status != 206 || answer.body.len() as u64 != length || !is_right {
            let [status, found] = [u64::from(answer.status), answer.body.len() as u64];
            return Err(io::Error::other(format!("{found} bytes, status {status}, at {start} + {length}")));
        }
    }
    Ok(latencies)
}

fn read_slowly(address: SocketAddr, until: Instant) -> io::Result<usize> {
    let socket = Socket::new(Domain::for_address(address), Type::STREAM, None)?;
    socket.set_recv_buffer_size(4096)?;
    socket.set_read_timeout(Some(PATIENCE))?;
    socket.connect(&address.into())?;
    let mut stream = TcpStream::from(socket);
    stream.write_all(format!("GET /models/{FILE} HTTP/1.1\r\nhost: localhost\r\n\r\n").as_bytes())?;
    let mut head = Vec::new();
    while !head.ends_with(b"\r\n\r\n") {
        let mut byte = [0];
        stream.read_exact(&mut byte)?;
        head.push(byte[0]);
    }
    let (mut read_count, mut piece) = (0, [0; SLOW_BYTES]);
    while read_count < 2 * SLOW_BYTES || Instant::now() < until {
        stream.read_exact(&mut piece)?;
        if piece.iter().zip(read_count as u64..).any(|(&byte, offset)| byte != byte_at(offset)) {
            return Err(io::Error::other(format!("wrong bytes after {read_count}")));
        }
        read_count += SLOW_BYTES;
        thread::sleep(Duration::from_secs(1).min(until.saturating_duration_since(Instant::now())));
    }
    Ok(read_count)
}

fn byte_at(offset: u64) -> u8 {
    mixed(offset / 8).to_le_bytes()[(offset % 8) as usize]
}

fn mixed(number: u64) -> u64 {
    let x = (number ^ number >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let x = (x ^ x >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
    x ^ x >> 31
}

/// Returns a memory figure of a process from `/proc` (Linux).
pub fn memory_kb(process: u32, key: &str) -> Option<u64> {
    let status = std::fs::read_to_string(format!("/proc/{process}/status")).ok()?;
    let line = status.lines().find_map(|line| line.strip_prefix(key))?;
    line.trim().strip_suffix("kB")?.trim().parse().ok()
}
