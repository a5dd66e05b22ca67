//! Starts a server for a test, and a client that sends exact bytes.

use std::io::{self, BufRead, BufReader, Read, Write};
use std::net::{SocketAddr, TcpStream};
use std::path::Path;
use std::process::{Child, Command, ExitStatus, Stdio};
use std::time::Duration;

/// A server process that is ended when dropped.
pub struct Server {
    process: Child,
    /// Address that the server listens on.
    pub address: SocketAddr,
    /// The report that the server printed.
    pub report: serde_json::Value,
}

impl Server {
    /// Starts a server for a folder or a file on a free port.
    pub fn start(program: &Path, served: &Path, arguments: &[&str]) -> Self {
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

    /// Returns the id of the server process.
    pub fn id(&self) -> u32 {
        self.process.id()
    }

    /// Terminates the server and waits for its exit.
    pub fn end(mut self) -> ExitStatus {
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

/// A response.
#[derive(Debug)]
pub struct Answer {
    /// Status code.
    pub status: u16,
    headers: Vec<(String, String)>,
    /// Body.
    pub body: Vec<u8>,
}

impl Answer {
    /// Returns a header by its lowercase name; empty if it is missing.
    pub fn header(&self, name: &str) -> &str {
        self.headers.iter().find(|(known, _)| known == name).map_or("", |(_, value)| value)
    }
}

/// Timeout for responses that should be immediate even on slow machines.
pub const PATIENCE: Duration = Duration::from_secs(600);

/// A connection that is kept alive.
pub struct Connection {
    reader: BufReader<TcpStream>,
}

impl Connection {
    /// Opens a connection.
    pub fn open(address: SocketAddr) -> io::Result<Self> {
        let stream = TcpStream::connect(address)?;
        stream.set_nodelay(true)?;
        stream.set_read_timeout(Some(PATIENCE))?;
        Ok(Self { reader: BufReader::new(stream) })
    }

    /// Closes the connection in one or both directions.
    pub fn close(&self, how: std::net::Shutdown) {
        // It may be closed already.
        let _ = self.reader.get_ref().shutdown(how);
    }

    /// Sends raw bytes.
    pub fn say(&mut self, text: &str) -> io::Result<()> {
        self.reader.get_mut().write_all(text.as_bytes())
    }

    /// Sends a GET request with headers, each ended by a line break, and reads the response.
    pub fn get(&mut self, path: &str, headers: &str) -> io::Result<Answer> {
        self.say(&format!("GET {path} HTTP/1.1\r\nhost: localhost\r\n{headers}\r\n"))?;
        self.answer(true)
    }

    /// Reads a response, with or without a body (for HEAD).
    pub fn answer(&mut self, has_body: bool) -> io::Result<Answer> {
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
