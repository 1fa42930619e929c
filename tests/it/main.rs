//! The integration tests, one binary.
mod codes;
mod errors;
mod hostile;
mod model;
mod render;
mod syntax;
