//! Tests of the C library, in one program.

mod calls;
mod header;
mod programs;
