//! Grading: what students hand in, read with care, compared with this tracer and marked.

pub mod submission;
