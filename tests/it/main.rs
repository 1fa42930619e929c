//! The integration tests, one binary.
mod codes;
mod errors;
mod hostile;
mod render;
mod syntax;
