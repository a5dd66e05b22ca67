//! Why the command stops: a message, whose fault it is, what would cure it, and the place in the file.

use std::cell::Cell;
use std::io::{self, Write};
#[cfg(feature = "gpu")]
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::process::ExitCode;

use striata::file::{DecodeError, EncodeError};
use striata::mesh::MeshError;
use striata::model::ModelError;
use striata::simplify::SimplifyError;
use striata_io::{Place, ReadError, WriteError};
use striata_stream::StreamError;

/// A failure as the user gets to see it.
#[derive(Debug)]
pub struct Failure {
    message: String,
    hint: Option<String>,
    excerpt: Option<Excerpt>,
    is_ours: bool,
    lacks_file: bool,
}

/// A line of a text file that is to blame, with its neighbors.
#[derive(Debug)]
pub struct Excerpt {
    name: String,
    lines: Vec<String>,
    first_line: usize,
    blamed: usize,
}

impl Failure {
    /// Exit code of failures that the user can fix.
    pub const USERS: u8 = 1;
    /// Exit code of failures that are our fault.
    pub const OURS: u8 = 2;

    /// A failure that the user can fix.
    pub fn user(message: impl Into<String>) -> Self {
        Self { message: message.into(), hint: None, excerpt: None, is_ours: false, lacks_file: false }
    }

    /// A failure of our own.
    pub fn internal(message: impl Into<String>) -> Self {
        Self { is_ours: true, ..Self::user(message) }
    }

    /// Adds what would cure it.
    pub fn with_hint(self, hint: impl Into<String>) -> Self {
        Self { hint: Some(hint.into()), ..self }
    }

    /// Names the file to blame, where what the library said about its mesh leaves it out.
    pub fn in_file(self, name: &str) -> Self {
        if !self.lacks_file {
            return self;
        }
        Self { message: format!("{name}: {}", self.message), lacks_file: false, ..self }
    }

    /// Adds the line to blame.
    pub fn with_excerpt(self, excerpt: Option<Excerpt>) -> Self {
        Self { excerpt, ..self }
    }

    /// What is wrong.
    pub fn message(&self) -> &str {
        &self.message
    }

    /// What would cure it, where that is known.
    pub fn hint(&self) -> Option<&str> {
        self.hint.as_deref()
    }

    /// Tells the user, and gives the exit code.
    pub fn announce(&self) -> ExitCode {
        let mut text = format!("error: {}\n", self.message);
        if let Some(excerpt) = &self.excerpt {
            text.push_str(&excerpt.render());
        }
        if let Some(hint) = &self.hint {
            text.push_str(&format!("hint: {hint}\n"));
        }
        if self.is_ours {
            text.push_str(PLEASE_REPORT);
        }
        // A closed stderr leaves the exit code to tell.
        let _ = io::stderr().write_all(text.as_bytes());
        ExitCode::from(if self.is_ours { Self::OURS } else { Self::USERS })
    }
}

const PLEASE_REPORT: &str = "This is a fault of striata, not yours; please report it with the command line \
                             and, if you can, the file.\n";

impl From<ReadError> for Failure {
    fn from(error: ReadError) -> Self {
        let failure = Self::user(error.to_string());
        match error {
            ReadError::Malformed { place: Place::Byte(_), .. } => {
                failure.with_hint("the file is damaged or cut off; copy it or export it again")
            }
            ReadError::Malformed { .. } => failure.with_hint("correct the file there, or export it again"),
            ReadError::NotInBlocks { .. } => {
                failure.with_hint("`striata convert IN OUT.ply` makes one, with the whole mesh in memory")
            }
            ReadError::UnsupportedExtension { .. } => failure.with_hint("export the file without it"),
            _ => failure,
        }
    }
}

impl From<WriteError> for Failure {
    fn from(error: WriteError) -> Self {
        let failure = Self::user(error.to_string());
        let WriteError::Io { source, .. } = error else { return failure };
        match source.kind() {
            io::ErrorKind::NotFound => failure.with_hint("make the output's folder first"),
            io::ErrorKind::PermissionDenied => failure.with_hint("choose a folder that you may write"),
            io::ErrorKind::IsADirectory => failure.with_hint("name a file inside the folder"),
            _ => failure,
        }
    }
}

impl From<MeshError> for Failure {
    fn from(error: MeshError) -> Self {
        let hint = match error {
            MeshError::NonFinitePosition { .. } => {
                "remove or repair the vertex; `striata info` counts such defects"
            }
            _ => "the file contradicts itself; export it again",
        };
        Self { lacks_file: true, ..Self::user(error.to_string()).with_hint(hint) }
    }
}

impl From<SimplifyError> for Failure {
    fn from(error: SimplifyError) -> Self {
        match error {
            SimplifyError::Mesh(error) => error.into(),
            SimplifyError::Sequence(_) => Self::internal(error.to_string()),
            _ => Self::user(error.to_string()),
        }
    }
}

/// Failures of parts that were made here and fit together by construction; what comes from a user's file is
/// told by `Input::damaged`.
macro_rules! ours {
    ($($error:ty),*) => {
        $(impl From<$error> for Failure {
            fn from(error: $error) -> Self {
                Self::internal(error.to_string())
            }
        })*
    };
}

ours!(ModelError, DecodeError, striata_stream::DecodeError);

impl From<EncodeError> for Failure {
    fn from(error: EncodeError) -> Self {
        match error {
            EncodeError::Unstorable { .. } => {
                Self::user(error.to_string()).with_hint("store another model with --models")
            }
            error => Self::internal(error.to_string()),
        }
    }
}

impl From<StreamError> for Failure {
    fn from(error: StreamError) -> Self {
        match error {
            StreamError::Mesh(error) => error.into(),
            StreamError::Grid(_) => {
                Self::user(error.to_string()).with_hint("say --bits, 1 to 24, or --lossless")
            }
            error => Self::internal(error.to_string()),
        }
    }
}

#[cfg(feature = "gpu")]
impl From<striata_gpu::GpuError> for Failure {
    fn from(error: striata_gpu::GpuError) -> Self {
        use striata_gpu::GpuError;
        let failure = Self::user(error.to_string());
        match error {
            GpuError::NoSuchAdapter { .. } => failure.with_hint("name another, or leave --adapter out"),
            GpuError::NoAdapter { .. } | GpuError::NoUsableAdapter { .. } | GpuError::NoDevice { .. } => {
                failure.with_hint(no_driver())
            }
            GpuError::TooLarge { .. } => {
                failure.with_hint("take a coarser level, or another adapter with --adapter")
            }
            _ => failure,
        }
    }
}

/// What gives a machine an adapter, or lets the one that it has be found.
#[cfg(feature = "gpu")]
fn no_driver() -> String {
    let install = "install a Vulkan driver; one that draws on the processor comes by `apt-get install mesa-vulkan-drivers`";
    match std::env::var("WGPU_BACKEND") {
        Ok(named) => format!("{install}; WGPU_BACKEND={named} narrows the search"),
        Err(_) => install.to_owned(),
    }
}

thread_local! {
    /// Whether a panic of this thread is caught and reported by whoever called.
    static IS_CAUGHT: Cell<bool> = const { Cell::new(false) };
}

/// Runs `work`; the error is the message of a panic, which nobody else reports.
#[cfg(feature = "gpu")]
pub fn catch_panic<T>(work: impl FnOnce() -> T) -> Result<T, String> {
    let before = IS_CAUGHT.replace(true);
    // What a panic leaves half-done is dropped by the callers.
    let result = catch_unwind(AssertUnwindSafe(work));
    IS_CAUGHT.set(before);
    result.map_err(|panic| {
        let text = panic.downcast_ref::<String>().map(String::as_str);
        let text = text.or_else(|| panic.downcast_ref::<&str>().copied()).unwrap_or("no message");
        text.lines().next().unwrap_or_default().to_owned()
    })
}

/// Prints a panic as what it is: our fault.
pub fn announce_panic(info: &std::panic::PanicHookInfo<'_>) {
    if IS_CAUGHT.get() {
        return;
    }
    let message = info.payload_as_str().unwrap_or("no message");
    let place = info.location().map(|l| format!(" ({}:{})", l.file(), l.line())).unwrap_or_default();
    let _ = write!(io::stderr(), "internal error: {message}{place}\n{PLEASE_REPORT}");
}

impl Excerpt {
    /// Longer lines are no text that a person would look at.
    const MAX_LINE_BYTES: usize = 400;

    /// The line, counted from 1, between its neighbors; `None` where the text has no such line.
    pub fn around(name: &str, text: &str, line: usize) -> Option<Self> {
        let first_line = line.checked_sub(1)?.max(1);
        let shown = text.lines().skip(first_line - 1).take(line + 2 - first_line);
        let lines: Vec<String> = shown.map(str::to_owned).collect();
        let has_line = first_line + lines.len() > line;
        let is_text = lines.iter().all(|line| line.len() <= Self::MAX_LINE_BYTES);
        (has_line && is_text).then(|| Self { name: name.to_owned(), lines, first_line, blamed: line })
    }

    /// The lines with their numbers, and the one to blame marked below, as compilers do it.
    fn render(&self) -> String {
        let margin = (self.first_line + self.lines.len() - 1).to_string().len();
        let mut text = format!("{:>margin$} --> {}:{}\n", "", self.name, self.blamed);
        for (number, line) in (self.first_line..).zip(&self.lines) {
            text.push_str(&format!("{number:>margin$} | {line}\n"));
            if number == self.blamed {
                text.push_str(&format!("{:>margin$} | {}\n", "", "^".repeat(line.chars().count().max(1))));
            }
        }
        text
    }
}

/// The failure of a name that is none of `known`; `what` says what it should name.
pub fn unknown_name(what: &str, name: &str, known: &[&str]) -> Failure {
    let hint = format!("this version has: {}", known.join(", "));
    Failure::user(format!("there is no {what} {name:?}")).with_hint(hint)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_excerpt_marks_the_line_between_its_neighbors() {
        let excerpt = Excerpt::around("x.obj", "v 0 0 0\nv 1\nv 2 2 2\nf 1 2 3\n", 2).expect("line 2");
        assert_eq!(excerpt.render(), "  --> x.obj:2\n1 | v 0 0 0\n2 | v 1\n  | ^^^\n3 | v 2 2 2\n");
        let last = Excerpt::around("x.obj", "v 0 0 0\nf", 2).expect("line 2");
        assert_eq!(last.render(), "  --> x.obj:2\n1 | v 0 0 0\n2 | f\n  | ^\n");
    }

    #[cfg(feature = "gpu")]
    #[test]
    fn a_panic_that_is_caught_becomes_the_first_line_of_its_message() {
        assert_eq!(catch_panic(|| 7), Ok(7));
        assert_eq!(catch_panic(|| panic!("lost {}\nand more", "device")), Err::<(), _>("lost device".into()));
    }

    #[test]
    fn lines_that_are_not_there_or_too_long_are_not_shown() {
        assert!(Excerpt::around("x", "one\n", 0).is_none());
        assert!(Excerpt::around("x", "one\n", 2).is_none());
        assert!(Excerpt::around("x", &"y".repeat(5000), 1).is_none());
    }
}
