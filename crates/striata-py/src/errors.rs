//! Conversion of the library's errors to exceptions.
//!
//! `ValueError` for arguments and meshes, `striata.DecodeError` (a `ValueError`) for bytes, `OSError` with
//! number and file name for files.

use std::fmt::Display;

use pyo3::exceptions::{PyKeyboardInterrupt, PyOSError, PyRuntimeError, PyValueError};
use pyo3::{PyErr, create_exception};
use striata::Cancelled;
use striata::simplify::SimplifyError;
use striata_io::{ReadError, WriteError};

create_exception!(striata, DecodeError, PyValueError, "Bytes are not a valid file or stream.");

/// Result of everything that Python calls.
pub(crate) type Outcome<T> = Result<T, PyErr>;

/// A `ValueError`.
pub(crate) fn value_error(error: impl Display) -> PyErr {
    PyValueError::new_err(error.to_string())
}

/// A `striata.DecodeError`.
pub(crate) fn decode_error(error: impl Display) -> PyErr {
    DecodeError::new_err(error.to_string())
}

/// A `RuntimeError` for defects of this package.
pub(crate) fn internal_error(what: impl Display) -> PyErr {
    PyRuntimeError::new_err(format!("internal error: {what}"))
}

/// A `KeyboardInterrupt`. The caller has raised the exception that cancelled the work already, so nobody
/// sees this one.
pub(crate) fn cancelled(reason: Cancelled) -> PyErr {
    PyKeyboardInterrupt::new_err(reason.to_string())
}

/// Errors of simplification.
pub(crate) fn simplify_error(error: SimplifyError) -> PyErr {
    match error {
        SimplifyError::Cancelled(reason) => cancelled(reason),
        SimplifyError::Sequence(_) | SimplifyError::Fragments(_) => internal_error(error),
        _ => value_error(error),
    }
}

/// Errors of reading a file.
pub(crate) fn read_error(error: ReadError) -> PyErr {
    match error {
        ReadError::Io { file, source } => os_error(&source, file),
        other => match other.hint() {
            Some(hint) => decode_error(format!("{other}\nhint: {hint}")),
            None => decode_error(other),
        },
    }
}

/// Errors of writing a file.
pub(crate) fn write_error(error: WriteError) -> PyErr {
    match error {
        WriteError::Io { file, source } => os_error(&source, file),
        other => value_error(other),
    }
}

/// An `OSError` whose number makes Python choose the subclass, such as `FileNotFoundError`.
pub(crate) fn os_error(error: &std::io::Error, file: String) -> PyErr {
    match error.raw_os_error() {
        Some(number) => {
            let text = error.to_string();
            let text = text.split(" (os error").next().unwrap_or_default().to_owned();
            PyOSError::new_err((number, text, file))
        }
        None => PyOSError::new_err(format!("{file}: {error}")),
    }
}

/// Warnings as texts with file and place.
pub(crate) fn warning_texts(warnings: &[striata_io::Warning]) -> Vec<String> {
    warnings.iter().map(ToString::to_string).collect()
}
