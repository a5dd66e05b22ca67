//! Conversion between arrays and the library's vectors.
//!
//! What comes in is copied, since Python code may change an array while the library works without the
//! interpreter. What goes out is moved: the array owns the memory of the vector.

use numpy::{
    Element, IntoPyArray as _, PyArray1, PyArray2, PyArrayMethods as _, PyReadonlyArray2,
    PyUntypedArrayMethods as _,
};
use pyo3::prelude::*;

use crate::errors::{Outcome, internal_error, value_error};

/// Copies a contiguous array with rows of `N`.
pub(crate) fn rows_of<T: Element + Copy + bytemuck::AnyBitPattern + bytemuck::NoUninit, const N: usize>(
    array: &PyReadonlyArray2<'_, T>,
    what: &str,
) -> Outcome<Vec<[T; N]>>
where
    [T; N]: bytemuck::AnyBitPattern,
{
    if array.shape()[1] != N {
        return Err(value_error(format!("{what} has the shape {:?}, but must be (n, {N})", array.shape())));
    }
    let values = array.as_slice().map_err(|_| internal_error(format!("{what} is not contiguous")))?;
    Ok(values.as_chunks::<N>().0.to_vec())
}

/// Moves rows into an array of shape `(n, N)`.
pub(crate) fn rows_to_array<T, const N: usize>(py: Python<'_>, rows: Vec<[T; N]>) -> Bound<'_, PyArray2<T>>
where
    T: Element + bytemuck::Pod,
    [T; N]: bytemuck::Pod,
{
    let count = rows.len();
    let flat: Vec<T> = rows.into_flattened();
    let array = flat.into_pyarray(py);
    reshaped(array, [count, N])
}

/// Moves values into an array of shape `(n, columns)`.
pub(crate) fn flat_to_array<T: Element>(
    py: Python<'_>,
    values: Vec<T>,
    columns: usize,
) -> Bound<'_, PyArray2<T>> {
    let count = values.len() / columns.max(1);
    reshaped(values.into_pyarray(py), [count, columns])
}

fn reshaped<'py, T: Element>(array: Bound<'py, PyArray1<T>>, shape: [usize; 2]) -> Bound<'py, PyArray2<T>> {
    array.reshape(shape).expect("the number of values is that of the shape")
}

/// Moves indices into an array of signed integers; `u32::MAX` becomes -1.
pub(crate) fn signed(py: Python<'_>, indices: Vec<u32>) -> Bound<'_, PyArray1<i32>> {
    bytemuck::cast_vec::<u32, i32>(indices).into_pyarray(py)
}

/// Moves triangles into an array of signed integers.
pub(crate) fn signed_rows(py: Python<'_>, triangles: Vec<[u32; 3]>) -> Bound<'_, PyArray2<i32>> {
    rows_to_array(py, bytemuck::cast_vec::<[u32; 3], [i32; 3]>(triangles))
}
