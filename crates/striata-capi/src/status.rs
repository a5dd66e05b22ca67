//! Statuses, the message of the last failure, and the border that no panic crosses.

use std::any::Any;
use std::cell::RefCell;
use std::ffi::{CStr, CString, c_char};
use std::fmt::Display;
use std::panic::{AssertUnwindSafe, catch_unwind};

/// Success.
pub const STRIATA_OK: i32 = 0;
/// A pointer is null that must not be.
pub const STRIATA_NULL: i32 = -1;
/// An argument is outside of its range.
pub const STRIATA_BAD_ARGUMENT: i32 = -2;
/// The mesh is inconsistent.
pub const STRIATA_BAD_MESH: i32 = -3;
/// Bytes are not a file or stream of striata, or they are damaged.
pub const STRIATA_BAD_BYTES: i32 = -4;
/// The memory of the caller is too small. The message has the size that is needed.
pub const STRIATA_TOO_SMALL: i32 = -5;
/// A file cannot be read or written.
pub const STRIATA_IO: i32 = -6;
/// The progress function canceled the call.
pub const STRIATA_CANCELED: i32 = -7;
/// The object does not have this data.
pub const STRIATA_UNAVAILABLE: i32 = -8;
/// More bytes have to arrive first.
pub const STRIATA_INCOMPLETE: i32 = -9;
/// The library failed, which is a bug.
pub const STRIATA_INTERNAL: i32 = -10;

/// Why a call failed.
pub(crate) struct CallFailure {
    status: i32,
    message: String,
}

/// Result of what a call does.
pub(crate) type CallResult<T> = Result<T, CallFailure>;

thread_local! {
    static LAST_MESSAGE: RefCell<CString> = RefCell::default();
}

impl CallFailure {
    pub(crate) fn new(status: i32, message: impl Display) -> Self {
        Self { status, message: message.to_string() }
    }

    /// An argument that is out of its range.
    pub(crate) fn argument(name: &str, problem: impl Display) -> Self {
        Self::new(STRIATA_BAD_ARGUMENT, format_args!("{name}: {problem}"))
    }

    /// Remembers the message for `striata_last_error`, and returns the status.
    fn record(self) -> i32 {
        let message = CString::new(self.message.replace('\0', "?")).unwrap_or_default();
        // A thread that is ending has no place for messages any more.
        let _ = LAST_MESSAGE.try_with(|last| last.replace(message));
        self.status
    }
}

/// Returns what a pointer refers to.
pub(crate) fn given<T>(name: &str, pointer: Option<T>) -> CallResult<T> {
    pointer.ok_or_else(|| CallFailure::new(STRIATA_NULL, format_args!("{name} is null")))
}

/// Makes a call whose result is a status.
pub(crate) fn status_of(call: impl FnOnce() -> CallResult<()>) -> i32 {
    caught(call).map_or_else(CallFailure::record, |()| STRIATA_OK)
}

/// Makes a call whose result is a count, or else a status.
pub(crate) fn count_of(call: impl FnOnce() -> CallResult<usize>) -> i64 {
    caught(call).map_or_else(|failure| i64::from(failure.record()), |count| count as i64)
}

/// Makes a call, and turns a panic into a failure.
fn caught<T>(call: impl FnOnce() -> CallResult<T>) -> CallResult<T> {
    catch_unwind(AssertUnwindSafe(call)).unwrap_or_else(|payload| {
        let reason = reason_of(payload.as_ref());
        Err(CallFailure::new(STRIATA_INTERNAL, format_args!("internal error: {reason}")))
    })
}

fn reason_of(payload: &(dyn Any + Send)) -> &str {
    let text = payload.downcast_ref::<String>().map(String::as_str);
    text.or_else(|| payload.downcast_ref::<&str>().copied()).unwrap_or("a panic")
}

/// Returns the message of the last call of this thread that failed; empty if none has. The text is valid until the next
/// call of the thread.
#[unsafe(no_mangle)]
pub extern "C" fn striata_last_error() -> *const c_char {
    LAST_MESSAGE.try_with(|last| last.borrow().as_ptr()).unwrap_or(c"".as_ptr())
}

/// Returns the name of a status, such as "too small"; "unknown status" for other numbers.
#[unsafe(no_mangle)]
pub extern "C" fn striata_status_name(status: i32) -> *const c_char {
    name_of(status).as_ptr()
}

fn name_of(status: i32) -> &'static CStr {
    match status {
        STRIATA_OK => c"ok",
        STRIATA_NULL => c"null pointer",
        STRIATA_BAD_ARGUMENT => c"bad argument",
        STRIATA_BAD_MESH => c"bad mesh",
        STRIATA_BAD_BYTES => c"bad bytes",
        STRIATA_TOO_SMALL => c"too small",
        STRIATA_IO => c"input or output failed",
        STRIATA_CANCELED => c"canceled",
        STRIATA_UNAVAILABLE => c"unavailable",
        STRIATA_INCOMPLETE => c"incomplete",
        STRIATA_INTERNAL => c"internal error",
        _ => c"unknown status",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn message() -> String {
        // SAFETY: the text is valid until the next call of this thread.
        unsafe { CStr::from_ptr(striata_last_error()) }.to_str().unwrap().to_owned()
    }

    #[test]
    fn panics_become_statuses() {
        assert_eq!(message(), "");
        assert_eq!(status_of(|| panic!("bug {}", 7)), STRIATA_INTERNAL);
        assert_eq!(message(), "internal error: bug 7");
        assert_eq!(count_of(|| std::panic::panic_any(3)), i64::from(STRIATA_INTERNAL));
        assert_eq!(message(), "internal error: a panic");
        let cut = CallFailure::argument("path", "a\0b");
        assert_eq!((status_of(|| Err(cut)), message().as_str()), (STRIATA_BAD_ARGUMENT, "path: a?b"));
        std::thread::spawn(|| assert_eq!(message(), "", "of another thread")).join().unwrap();
    }

    #[test]
    fn statuses_have_different_names() {
        let names: std::collections::BTreeSet<_> = (STRIATA_INTERNAL - 1..=0).map(name_of).collect();
        assert_eq!(names.len(), 12);
    }
}
