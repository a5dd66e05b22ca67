//! Memory of the caller: pointers and lengths that become slices, and buffers that are written.
//!
//! This is the only place that reads or writes through pointers. It refuses null, wrong alignment, and sizes that no memory
//! can have; that the memory exists is the promise of the caller.

use std::ffi::{CStr, c_char};
use std::mem::MaybeUninit;

use crate::status::{CallFailure, CallResult, STRIATA_NULL, STRIATA_TOO_SMALL};

/// Numbers that every pattern of bits is valid for.
pub(crate) trait PlainNumber: Copy {}

impl PlainNumber for u8 {}
impl PlainNumber for u16 {}
impl PlainNumber for u32 {}
impl PlainNumber for f32 {}
impl PlainNumber for f64 {}

/// Largest number of bytes of one array.
const MAX_BYTES: usize = isize::MAX as usize;

fn check_pointer<T>(name: &str, pointer: *const T, bytes: Option<usize>) -> CallResult<()> {
    if pointer.is_null() {
        return Err(CallFailure::new(STRIATA_NULL, format_args!("{name} is null")));
    }
    if bytes.is_none_or(|bytes| bytes > MAX_BYTES) {
        return Err(CallFailure::argument(name, "the length is more than any memory has"));
    }
    Ok(())
}

fn check_alignment<T>(name: &str, pointer: *const T) -> CallResult<()> {
    if pointer.is_aligned() {
        return Ok(());
    }
    Err(CallFailure::argument(name, format_args!("the address is no multiple of {}", align_of::<T>())))
}

/// Borrows an array of the caller; without elements, the pointer may be null.
///
/// # Safety
/// The array has `count` elements, which do not change during the call.
pub(crate) unsafe fn slice<'a, T>(name: &str, pointer: *const T, count: usize) -> CallResult<&'a [T]> {
    if count == 0 {
        return Ok(&[]);
    }
    check_pointer(name, pointer, count.checked_mul(size_of::<T>()))?;
    check_alignment(name, pointer)?;
    // SAFETY: the pointer is aligned and not null, and the caller promises that there are as many elements.
    Ok(unsafe { std::slice::from_raw_parts(pointer, count) })
}

/// Borrows a text of the caller.
///
/// # Safety
/// Unless it is null, the pointer is a text that ends with a zero and does not change during the call.
pub(crate) unsafe fn text<'a>(name: &str, pointer: *const c_char) -> CallResult<&'a str> {
    check_pointer(name, pointer, Some(1))?;
    // SAFETY: the pointer is not null, and the caller promises the text.
    let text = unsafe { CStr::from_ptr(pointer) };
    text.to_str().map_err(|error| CallFailure::argument(name, error))
}

/// Rows of numbers in memory of the caller, at equal distances, as in an interleaved vertex buffer.
#[derive(Clone, Copy)]
pub(crate) struct StridedRows {
    /// Address of the first number.
    pub data: *const u8,
    /// Distance between the starts of two rows, in bytes; 0 if they follow each other.
    pub stride: usize,
    /// Number of rows.
    pub count: usize,
    /// Numbers of a row.
    pub width: usize,
}

impl StridedRows {
    /// Copies all numbers, row by row.
    ///
    /// # Safety
    /// The memory has as many rows, which do not change during the call.
    pub(crate) unsafe fn read<T: PlainNumber>(self, name: &str) -> CallResult<Vec<T>> {
        let Self { data, stride, count, width } = self;
        if count == 0 || width == 0 {
            return Ok(Vec::new());
        }
        let row_bytes = width * size_of::<T>();
        let stride = if stride == 0 { row_bytes } else { stride };
        if stride < row_bytes {
            let problem = format_args!("a stride of {stride} bytes is less than a row of {row_bytes}");
            return Err(CallFailure::argument(name, problem));
        }
        check_pointer(name, data, stride.checked_mul(count))?;
        let mut numbers = Vec::with_capacity(count * width);
        for row in 0..count {
            for column in 0..width {
                let number = data.wrapping_add(row * stride + column * size_of::<T>()).cast::<T>();
                // SAFETY: the number is within the rows that the caller promises. Any bits are a number.
                numbers.push(unsafe { number.read_unaligned() });
            }
        }
        Ok(numbers)
    }
}

/// Memory of the caller that receives elements, or none, if the caller asks for their number.
pub(crate) struct CallerBuffer<'a, T>(Option<&'a mut [MaybeUninit<T>]>);

impl<T: Copy> CallerBuffer<'_, T> {
    /// Borrows the memory; null stands for none.
    ///
    /// # Safety
    /// Unless it is null, the memory has room for `capacity` elements, and nothing else uses it during the call.
    pub(crate) unsafe fn new(pointer: *mut T, capacity: usize) -> CallResult<Self> {
        if pointer.is_null() {
            return Ok(Self(None));
        }
        check_pointer("to", pointer, capacity.checked_mul(size_of::<T>()))?;
        check_alignment("to", pointer)?;
        // SAFETY: the pointer is aligned and not null, and the caller promises the memory, which need not be initialized.
        Ok(Self(Some(unsafe { std::slice::from_raw_parts_mut(pointer.cast(), capacity) })))
    }

    /// Writes what `make` returns, which are `count` elements, if the caller has given memory. Returns the number.
    pub(crate) fn fill<V: AsRef<[T]>>(self, count: usize, make: impl FnOnce() -> V) -> CallResult<usize> {
        let Some(memory) = self.0 else { return Ok(count) };
        let capacity = memory.len();
        let Some(memory) = memory.get_mut(..count) else {
            let message = format_args!("to has room for {capacity} elements, but {count} are needed");
            return Err(CallFailure::new(STRIATA_TOO_SMALL, message));
        };
        memory.write_copy_of_slice(make().as_ref());
        Ok(count)
    }

    /// Number of elements that the memory has room for; [`None`] without memory.
    pub(crate) fn capacity(&self) -> Option<usize> {
        self.0.as_ref().map(|memory| memory.len())
    }
}
