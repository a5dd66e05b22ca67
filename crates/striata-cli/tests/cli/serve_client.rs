//! A server of one's own to talk to, and a client that says exactly what it is told to; shared with
//! `examples/load.rs`.

use std::io::{self, BufRead, BufReader, Read, Write};
use std::net::{SocketAddr, TcpStream};
use std::path::Path;
use std::process::{Child, Command, ExitStatus, Stdio};
use std::time::Duration;

/// A server that ends with its owner.
pub(crate) struct Server {
    process: Child,
    /// Where it listens.
    pub(crate) address: SocketAddr,
    /// What it said about itself.
    pub(crate) report: serde_json::Value,
}

impl Server {
    /// Serves a folder or a file at a free port.
    pub(crate) fn start(program: &Path, served: &Path, arguments: &[&str]) -> Self {
        let mut command = Command::new(program);
        command.arg("serve").arg(served).args(["--port", "0", "--json", "--quiet"]).args(arguments);
        let mut process = command.stdout(Stdio::piped()).spawn().expect("the command starts");
        let mut line = String::new();
        let stdout = process.stdout.take().expect("it is piped");
        BufReader::new(stdout).read_line(&mut line).expect("a line of text");
        let report: serde_json::Value = serde_json::from_str(&line).expect("one JSON object");
        let url = report["url"].as_str().expect("a URL");
        let address = url.trim_start_matches("http://").trim_end_matches('/');
        Self { address: address.parse().expect("an address"), process, report }
    }

    /// Its process.
    pub(crate) fn id(&self) -> u32 {
        self.process.id()
    }

    /// Asks it to end and waits until it has.
    pub(crate) fn end(mut self) -> ExitStatus {
        let id = self.id().to_string();
        let sent = Command::new("kill").args(["-TERM", &id]).status().expect("kill is there");
        assert!(sent.success());
        self.process.wait().expect("it is our child")
    }
}

impl Drop for Server {
    fn drop(&mut self) {
        let _ = self.process.kill();
        let _ = self.process.wait();
    }
}

/// What a server says.
#[derive(Debug)]
pub(crate) struct Answer {
    /// The number of the first line.
    pub(crate) status: u16,
    headers: Vec<(String, String)>,
    /// What follows.
    pub(crate) body: Vec<u8>,
}

impl Answer {
    /// A header by its lowercase name; empty where there is none.
    pub(crate) fn header(&self, name: &str) -> &str {
        self.headers.iter().find(|(known, _)| known == name).map_or("", |(_, value)| value)
    }
}

/// How long tests wait for what should come at once: no machine is so slow.
pub(crate) const PATIENCE: Duration = Duration::from_secs(600);

/// A connection, used again and again.
pub(crate) struct Connection {
    reader: BufReader<TcpStream>,
}

impl Connection {
    /// Connects.
    pub(crate) fn open(address: SocketAddr) -> io::Result<Self> {
        let stream = TcpStream::connect(address)?;
        stream.set_nodelay(true)?;
        stream.set_read_timeout(Some(PATIENCE))?;
        Ok(Self { reader: BufReader::new(stream) })
    }

    /// Sends what it is told.
    pub(crate) fn say(&mut self, text: &str) -> io::Result<()> {
        self.reader.get_mut().write_all(text.as_bytes())
    }

    /// Asks with headers, each ended by a line break, and waits for the answer.
    pub(crate) fn get(&mut self, path: &str, headers: &str) -> io::Result<Answer> {
        self.say(&format!("GET {path} HTTP/1.1\r\nhost: localhost\r\n{headers}\r\n"))?;
        self.answer(true)
    }

    /// Reads an answer, with a body or, as to HEAD, without.
    pub(crate) fn answer(&mut self, has_body: bool) -> io::Result<Answer> {
        let first = self.line()?;
        let status = first.split(' ').nth(1).and_then(|word| word.parse().ok());
        let status = status.ok_or_else(|| io::Error::other(format!("no status in {first:?}")))?;
        let mut headers = Vec::new();
        loop {
            let line = self.line()?;
            let Some((name, value)) = line.split_once(':') else { break };
            headers.push((name.to_ascii_lowercase(), value.trim().to_owned()));
        }
        let mut answer = Answer { status, headers, body: Vec::new() };
        if has_body && status != 304 {
            answer.body = self.body(&answer)?;
        }
        Ok(answer)
    }

    fn body(&mut self, answer: &Answer) -> io::Result<Vec<u8>> {
        let mut body = Vec::new();
        if answer.header("transfer-encoding") != "chunked" {
            let length = answer.header("content-length").parse().map_err(io::Error::other)?;
            body.resize(length, 0);
            self.reader.read_exact(&mut body)?;
            return Ok(body);
        }
        loop {
            let length = usize::from_str_radix(&self.line()?, 16).map_err(io::Error::other)?;
            let start = body.len();
            body.resize(start + length, 0);
            self.reader.read_exact(&mut body[start..])?;
            self.line()?;
            if length == 0 {
                return Ok(body);
            }
        }
    }

    fn line(&mut self) -> io::Result<String> {
        let mut line = String::new();
        if self.reader.read_line(&mut line)? == 0 {
            return Err(io::ErrorKind::UnexpectedEof.into());
        }
        Ok(line.trim_end().to_owned())
    }
}
