//! `view`: a server for one page, which ends with it.

use std::io::{BufRead, BufReader};
use std::net::{Shutdown, SocketAddr};
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

use striata_testing::server::{Connection, PATIENCE};

use crate::workbench::Workbench;

/// A running command, which is ended when dropped.
pub(crate) struct Shown {
    process: Child,
    address: String,
}

impl Shown {
    /// Starts the command in a folder, without a browser.
    pub(crate) fn start(bench: &Workbench, arguments: &[&str]) -> Self {
        let mut command = Command::new(assert_cmd::cargo::cargo_bin("striata"));
        command.arg("view").args(arguments).args(["--no-open", "--quiet"]).current_dir(bench.path("."));
        let mut process = command.stdout(Stdio::piped()).spawn().expect("the command starts");
        let mut address = String::new();
        let stdout = process.stdout.take().expect("it is piped");
        BufReader::new(stdout).read_line(&mut address).expect("a line of text");
        Self { process, address: address.trim().to_owned() }
    }

    /// The address of the page.
    pub(crate) fn address(&self) -> &str {
        &self.address
    }

    fn socket(&self) -> SocketAddr {
        let host = self.address.trim_start_matches("http://").split('/').next().expect("a host");
        host.parse().expect("an address with a port")
    }

    fn is_running(&mut self) -> bool {
        self.process.try_wait().expect("it is our child").is_none()
    }

    /// Waits until the command ends by itself, and returns whether it has succeeded.
    fn ended(mut self) -> bool {
        let started = Instant::now();
        while self.is_running() {
            assert!(started.elapsed() < PATIENCE, "the command goes on");
            std::thread::sleep(Duration::from_millis(50));
        }
        self.process.wait().expect("it is our child").success()
    }
}

impl Drop for Shown {
    fn drop(&mut self) {
        let _ = self.process.kill();
        let _ = self.process.wait();
    }
}

#[test]
fn the_command_ends_when_its_page_is_closed() {
    let bench = Workbench::with_ball();
    let mut shown = Shown::start(&bench, &["ball.striata", "--pixels", "2", "--model", "fans"]);
    assert!(shown.address().ends_with("/?model=models/ball.striata&error=2&as=fans"), "{}", shown.address());
    let mut other = Connection::open(shown.socket()).expect("it listens");
    let listing = other.get("/models.json", "").expect("a listing");
    let listing: serde_json::Value = serde_json::from_slice(&listing.body).expect("JSON");
    assert_eq!((&listing["ends_with_page"], &listing["total"]), (&true.into(), &1.into()));
    let mut page = Connection::open(shown.socket()).expect("it listens");
    page.say("GET /session HTTP/1.1\r\nhost: localhost\r\n\r\n").expect("it listens");
    let answer = page.answer(false).expect("headers");
    assert_eq!((answer.status, answer.header("cache-control")), (200, "no-store"));
    assert!(shown.is_running());
    page.close(Shutdown::Both);
    drop(other);
    assert!(shown.ended(), "closing the page is the usual end");
}

#[test]
fn a_folder_has_a_gallery_and_servers_stay() {
    let bench = Workbench::with_ball();
    let shown = Shown::start(&bench, &[]);
    assert!(
        shown.address().starts_with("http://127.0.0.1:") && !shown.address().contains('?'),
        "{}",
        shown.address()
    );
    let program = assert_cmd::cargo::cargo_bin("striata");
    let server = striata_testing::server::Server::start(&program, &bench.path("."), &[]);
    let mut client = Connection::open(server.address).expect("it listens");
    assert_eq!(client.get("/session", "").expect("an answer").status, 404);
}

#[test]
fn what_cannot_be_shown_is_refused() {
    let bench = Workbench::with_ball();
    let stderr = bench.refused("view nowhere.ply");
    assert!(stderr.contains("nowhere.ply") && stderr.contains("hint:"), "{stderr}");
    let stderr = bench.refused("view . --pixels 1");
    assert!(stderr.contains("the settings are for one model") && stderr.contains("hint:"), "{stderr}");
    assert!(bench.refused("view ball.striata --pixels 0").contains("from 0.25 to 20"));
}
