//! Mesh files in and out: PLY, OBJ, STL, OFF and glTF, plain or inside gzip and zstd.
