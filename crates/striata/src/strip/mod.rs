//! Triangle strips: what they are, how they are made and what they cost.
