//! Errors of the command: a message, a hint, the offending line of a file, and an exit code.
//!
//! People read them on stderr. With `--json`, programs also get an object on stdout, in place of the report:
//! `{"error": {"kind": "usage", "message": "...", "hint": "..."}}`, where the hint may be null.

use std::any::Any;
use std::cell::Cell;
use std::error::Error;
use std::io::{self, Write};
#[cfg(feature = "gpu")]
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::process::ExitCode;

use serde_json::json;
use striata::file::{DecodeError, EncodeError};
use striata::mesh::MeshError;
use striata::model::ModelError;
use striata::simplify::SimplifyError;
use striata_io::{Place, ReadError, WriteError};
use striata_scene::stream::SceneStreamError;
use striata_stream::StreamError;

/// A failure as it is shown to the user.
#[derive(Debug)]
pub struct Failure {
    message: String,
    hint: Option<String>,
    excerpt: Option<Excerpt>,
    kind: FailureKind,
    needs_file_name: bool,
}

/// Who can do something about a failure.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FailureKind {
    /// The files or the machine prevent the work.
    Failed,
    /// The command line is wrong, which shows before the work begins.
    Usage,
    /// It is a bug in striata.
    Internal,
}

impl FailureKind {
    /// Returns the exit code of the command.
    pub const fn exit_code(self) -> u8 {
        match self {
            Self::Failed => 1,
            Self::Usage => 2,
            Self::Internal => 3,
        }
    }

    /// Returns the name in JSON.
    const fn as_str(self) -> &'static str {
        match self {
            Self::Failed => "failed",
            Self::Usage => "usage",
            Self::Internal => "internal",
        }
    }
}

/// The offending line of a text file, with the lines before and after it.
#[derive(Debug)]
pub struct Excerpt {
    name: String,
    lines: Vec<String>,
    first_line: usize,
    marked_line: usize,
}

impl Failure {
    /// Creates a failure that the user can fix in the files or on the machine.
    pub fn user(message: impl Into<String>) -> Self {
        Self {
            message: message.into(),
            hint: None,
            excerpt: None,
            kind: FailureKind::Failed,
            needs_file_name: false,
        }
    }

    /// Creates a failure of the command line, which the user can write differently.
    pub fn usage(message: impl Into<String>) -> Self {
        Self { kind: FailureKind::Usage, ..Self::user(message) }
    }

    /// Creates an internal error.
    pub fn internal(message: impl Into<String>) -> Self {
        Self { kind: FailureKind::Internal, ..Self::user(message) }
    }

    /// Adds a hint how to fix the failure.
    pub fn with_hint(self, hint: impl Into<String>) -> Self {
        Self { hint: Some(hint.into()), ..self }
    }

    /// Puts the file name before the message if the message, like those of mesh errors, lacks one.
    pub fn in_file(self, name: &str) -> Self {
        if !self.needs_file_name {
            return self;
        }
        Self { message: format!("{name}: {}", self.message), needs_file_name: false, ..self }
    }

    /// Adds the offending line.
    pub fn with_excerpt(self, excerpt: Option<Excerpt>) -> Self {
        Self { excerpt, ..self }
    }

    /// Returns the message.
    pub fn message(&self) -> &str {
        &self.message
    }

    /// Returns the hint, if there is one.
    pub fn hint(&self) -> Option<&str> {
        self.hint.as_deref()
    }

    /// Prints the failure to stderr, and as JSON to stdout if that is wanted; returns the exit code.
    pub fn announce(&self, is_json: bool) -> ExitCode {
        let mut text = format!("error: {}\n", self.message);
        if let Some(excerpt) = &self.excerpt {
            text.push_str(&excerpt.render());
        }
        if let Some(hint) = &self.hint {
            text.push_str(&format!("hint: {hint}\n"));
        }
        if self.kind == FailureKind::Internal {
            text.push_str(PLEASE_REPORT);
        }
        // If stderr is closed, the exit code still reports the failure.
        let _ = io::stderr().write_all(text.as_bytes());
        if is_json {
            print_json(self.kind, &self.message, self.hint.as_deref());
        }
        ExitCode::from(self.kind.exit_code())
    }
}

/// Prints a failure to stdout as the only JSON object.
pub(crate) fn print_json(kind: FailureKind, message: &str, hint: Option<&str>) {
    let error = json!({ "kind": kind.as_str(), "message": message, "hint": hint });
    // If stdout is closed, stderr and the exit code still report the failure.
    let _ = writeln!(io::stdout(), "{}", json!({ "error": error }));
}

const PLEASE_REPORT: &str = "This is a bug in striata; please report it with the command line and, if \
                             possible, the file.\n";

impl From<ReadError> for Failure {
    fn from(error: ReadError) -> Self {
        let failure = Self::user(error.to_string());
        match error {
            ReadError::NeedsConversion { hint, .. } => failure.with_hint(hint),
            ReadError::Empty { .. } => failure.with_hint("copy the file again, or export it again"),
            ReadError::NoTriangles { .. } => {
                failure.with_hint("make a surface of the points first, for example with MeshLab or Open3D")
            }
            ReadError::Malformed { place: Place::Byte(_), .. } => {
                failure.with_hint("the file is damaged or cut off; copy it or export it again")
            }
            ReadError::Malformed { .. } => {
                failure.with_hint("correct that line of the file, or export the file again")
            }
            ReadError::NotInBlocks { .. } => failure.with_hint(
                "convert the file with `striata convert IN OUT.ply`, which loads the whole mesh into memory",
            ),
            ReadError::UnsupportedExtension { .. } => {
                failure.with_hint("export the file without this extension")
            }
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
            io::ErrorKind::PermissionDenied => failure.with_hint("choose a folder that you can write to"),
            io::ErrorKind::IsADirectory => failure.with_hint("name a file in that folder"),
            _ => failure,
        }
    }
}

impl From<MeshError> for Failure {
    fn from(error: MeshError) -> Self {
        let hint = match error {
            MeshError::NonFinitePosition { .. } => {
                "repair or remove the vertex; `striata info` lists such defects"
            }
            _ => "the file is inconsistent; export it again",
        };
        Self { needs_file_name: true, ..Self::user(error.to_string()).with_hint(hint) }
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

/// Converts errors of data that striata itself created, which are therefore bugs. For errors in the data of a
/// user's file, use `Input::damaged`.
macro_rules! internal_errors {
    ($($error:ty),*) => {
        $(impl From<$error> for Failure {
            fn from(error: $error) -> Self {
                Self::internal(error.to_string())
            }
        })*
    };
}

internal_errors!(ModelError, DecodeError, striata_stream::DecodeError);

impl From<EncodeError> for Failure {
    fn from(error: EncodeError) -> Self {
        match error {
            EncodeError::Unstorable { .. } => {
                Self::user(error.to_string()).with_hint("choose another model with --models")
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
                Self::user(error.to_string()).with_hint("use --bits with 1 to 24, or --lossless")
            }
            error => Self::internal(error.to_string()),
        }
    }
}

#[cfg(feature = "gpu")]
impl From<striata_render::gpu::GpuError> for Failure {
    fn from(error: striata_render::gpu::GpuError) -> Self {
        use striata_render::gpu::GpuError;
        let failure = Self::user(error.to_string());
        match error {
            GpuError::NoSuchAdapter { .. } => failure.with_hint("name another adapter, or remove --adapter"),
            GpuError::NoAdapter { .. } | GpuError::NoUsableAdapter { .. } | GpuError::NoDevice { .. } => {
                failure.with_hint(driver_hint())
            }
            GpuError::TooLarge { .. } => {
                failure.with_hint("use a coarser level, or another adapter with --adapter")
            }
            _ => failure,
        }
    }
}

/// Returns the hint for machines without a usable graphics adapter.
#[cfg(feature = "gpu")]
fn driver_hint() -> String {
    let install =
        "install a Vulkan driver; `apt-get install mesa-vulkan-drivers` includes one that renders on the CPU";
    match std::env::var("WGPU_BACKEND") {
        Ok(named) => format!("{install}; note that WGPU_BACKEND={named} restricts the search"),
        Err(_) => install.to_owned(),
    }
}

thread_local! {
    /// Whether panics of this thread are caught by [`catch_panic`], whose caller reports them.
    static IS_CAUGHT: Cell<bool> = const { Cell::new(false) };
}

/// Runs `work` and returns the first line of the message if it panics; the panic is not reported otherwise.
#[cfg(feature = "gpu")]
pub fn catch_panic<T>(work: impl FnOnce() -> T) -> Result<T, String> {
    let before = IS_CAUGHT.replace(true);
    // Callers drop whatever state a panic leaves inconsistent.
    let result = catch_unwind(AssertUnwindSafe(work));
    IS_CAUGHT.set(before);
    result.map_err(|panic| panic_message(&*panic))
}

/// Returns the first line of the message of a panic.
pub(crate) fn panic_message(panic: &(dyn Any + Send)) -> String {
    let text = panic.downcast_ref::<String>().map(String::as_str);
    let text = text.or_else(|| panic.downcast_ref::<&str>().copied()).unwrap_or("no message");
    text.lines().next().unwrap_or_default().to_owned()
}

/// Panic hook: prints a panic as an internal error.
pub fn report_panic(info: &std::panic::PanicHookInfo<'_>) {
    if IS_CAUGHT.get() {
        return;
    }
    let message = info.payload_as_str().unwrap_or("no message");
    let location = info.location().map(|l| format!(" ({}:{})", l.file(), l.line())).unwrap_or_default();
    let _ = write!(io::stderr(), "internal error: {message}{location}\n{PLEASE_REPORT}");
}

impl Excerpt {
    /// Lines longer than this are not text that a person would read.
    const MAX_LINE_BYTES: usize = 400;

    /// Returns the line (counted from 1) and its neighbors; `None` if the text has no such line or a line is
    /// too long.
    pub fn around(name: &str, text: &str, line: usize) -> Option<Self> {
        let first_line = line.checked_sub(1)?.max(1);
        let shown = text.lines().skip(first_line - 1).take(line + 2 - first_line);
        let lines: Vec<String> = shown.map(str::to_owned).collect();
        let has_line = first_line + lines.len() > line;
        let is_text = lines.iter().all(|line| line.len() <= Self::MAX_LINE_BYTES);
        (has_line && is_text).then(|| Self { name: name.to_owned(), lines, first_line, marked_line: line })
    }

    /// Formats the lines with their numbers, the offending one underlined, as compilers do.
    fn render(&self) -> String {
        let margin = (self.first_line + self.lines.len() - 1).to_string().len();
        let mut text = format!("{:>margin$} --> {}:{}\n", "", self.name, self.marked_line);
        for (number, line) in (self.first_line..).zip(&self.lines) {
            text.push_str(&format!("{number:>margin$} | {line}\n"));
            if number == self.marked_line {
                text.push_str(&format!("{:>margin$} | {}\n", "", "^".repeat(line.chars().count().max(1))));
            }
        }
        text
    }
}

/// Returns what to do about a file that cannot be decoded: copies of another version of a format are no better.
pub fn decode_hint(error: &(dyn Error + 'static)) -> &'static str {
    let mut causes = std::iter::successors(Some(error), |&error| error.source());
    if causes.clone().any(is_incomplete) {
        return "wait for more of the stream; if this is all of the file, copy it again";
    }
    causes
        .find_map(version_of)
        .map_or("the file is damaged or cut off; copy it again, or build it again", |(found, supported)| {
            version_hint(found, supported)
        })
}

/// Whether what is wrong is that a stream has only begun.
fn is_incomplete(error: &(dyn Error + 'static)) -> bool {
    matches!(error.downcast_ref(), Some(DecodeError::Incomplete { .. }))
        || matches!(error.downcast_ref(), Some(striata_stream::DecodeError::Incomplete { .. }))
        || matches!(error.downcast_ref(), Some(SceneStreamError::NotDrawable { .. }))
}

/// Returns what to do about a file with another version of its format.
pub fn version_hint(found: u32, supported: u32) -> &'static str {
    if found < supported {
        "it was made by an older version of striata; build or encode it again"
    } else {
        "it was made by a newer version of striata; update this one, or build it again"
    }
}

/// Returns the version of a file and the supported one if they are what is wrong.
fn version_of(error: &(dyn Error + 'static)) -> Option<(u32, u32)> {
    if let Some(DecodeError::Version { found, supported }) = error.downcast_ref() {
        return Some((*found, *supported));
    }
    match error.downcast_ref()? {
        SceneStreamError::Version { found, supported } => Some((*found, *supported)),
        _ => None,
    }
}

/// Returns the failure for a name on the command line that is not one of `known`; `what` is the kind of thing it
/// should name.
pub fn unknown_name(what: &str, name: &str, known: &[&str]) -> Failure {
    let hint = format!("this version has: {}", known.join(", "));
    Failure::usage(format!("there is no {what} {name:?}")).with_hint(hint)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_excerpt_underlines_the_line() {
        let excerpt = Excerpt::around("x.obj", "v 0 0 0\nv 1\nv 2 2 2\nf 1 2 3\n", 2).expect("line 2");
        assert_eq!(excerpt.render(), "  --> x.obj:2\n1 | v 0 0 0\n2 | v 1\n  | ^^^\n3 | v 2 2 2\n");
        let last = Excerpt::around("x.obj", "v 0 0 0\nf", 2).expect("line 2");
        assert_eq!(last.render(), "  --> x.obj:2\n1 | v 0 0 0\n2 | f\n  | ^\n");
    }

    #[cfg(feature = "gpu")]
    #[test]
    fn a_caught_panic_returns_the_first_line_of_its_message() {
        assert_eq!(catch_panic(|| 7), Ok(7));
        assert_eq!(catch_panic(|| panic!("lost {}\nand more", "device")), Err::<(), _>("lost device".into()));
    }

    #[test]
    fn missing_or_long_lines_give_no_excerpt() {
        assert!(Excerpt::around("x", "one\n", 0).is_none());
        assert!(Excerpt::around("x", "one\n", 2).is_none());
        assert!(Excerpt::around("x", &"y".repeat(5000), 1).is_none());
    }
}
