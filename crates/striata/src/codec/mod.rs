//! Bytes: the `.striata` container and its sections.
