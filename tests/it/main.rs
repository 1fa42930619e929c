//! The integration tests, one binary.
mod errors;
mod syntax;
