//! Tests of streams, in one program.

mod fragment_streams;
mod growing;
mod hostile_streams;
mod levels;
mod stream_files;
mod streams;
