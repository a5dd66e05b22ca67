//! The wasm face of striata.
