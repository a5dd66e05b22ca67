//! Multiresolution models over one collapse sequence.
