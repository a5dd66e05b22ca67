//! Why the command stops: a message, whose fault it is, what would cure it, and the place in the file.

use std::io::{self, Write};
use std::process::ExitCode;

use miette::{GraphicalReportHandler, GraphicalTheme, LabeledSpan, MietteDiagnostic, NamedSource, Report};

/// A failure as the user gets to see it.
#[derive(Debug)]
pub(crate) struct Failure {
    message: String,
    hint: Option<String>,
    excerpt: Option<Excerpt>,
    is_ours: bool,
}

/// A line of a text file that is to blame.
#[derive(Debug)]
pub(crate) struct Excerpt {
    /// The file's name.
    pub(crate) name: String,
    /// The file's text.
    pub(crate) text: String,
    /// The line, counted from 1.
    pub(crate) line: usize,
}

impl Failure {
    /// Exit code of failures that the user can fix.
    pub(crate) const USERS: u8 = 1;
    /// Exit code of failures that are our fault.
    pub(crate) const OURS: u8 = 2;

    /// A failure that the user can fix.
    pub(crate) fn user(message: impl Into<String>) -> Self {
        Self { message: message.into(), hint: None, excerpt: None, is_ours: false }
    }

    /// A failure of our own.
    pub(crate) fn internal(message: impl Into<String>) -> Self {
        Self { is_ours: true, ..Self::user(message) }
    }

    /// Adds what would cure it.
    pub(crate) fn with_hint(self, hint: impl Into<String>) -> Self {
        Self { hint: Some(hint.into()), ..self }
    }

    /// Adds the line to blame.
    pub(crate) fn with_excerpt(self, excerpt: Option<Excerpt>) -> Self {
        Self { excerpt, ..self }
    }

    /// Tells the user, and gives the exit code.
    pub(crate) fn announce(&self) -> ExitCode {
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

/// Prints a panic as what it is: our fault.
pub(crate) fn announce_panic(info: &std::panic::PanicHookInfo<'_>) {
    let message = info.payload_as_str().unwrap_or("no message");
    let place = info.location().map(|l| format!(" ({}:{})", l.file(), l.line())).unwrap_or_default();
    let _ = write!(io::stderr(), "internal error: {message}{place}\n{PLEASE_REPORT}");
}

impl Excerpt {
    /// The line with its neighbours, marked.
    fn render(&self) -> String {
        let start: usize = self.text.split_inclusive('\n').take(self.line.saturating_sub(1)).map(str::len).sum();
        let length = self.text[start..].lines().next().map_or(0, str::len);
        let label = LabeledSpan::at(start..start + length, "here");
        let diagnostic = MietteDiagnostic::new(String::new()).with_label(label);
        let source = NamedSource::new(&self.name, self.text.clone());
        let report = Report::new(diagnostic).with_source_code(source);
        let mut text = String::new();
        let handler = GraphicalReportHandler::new_themed(GraphicalTheme::none()).with_context_lines(1);
        // A report that cannot be drawn is left out: the message has said it already.
        let _ = handler.render_report(&mut text, report.as_ref());
        text
    }
}
