//! One integration binary: every test of the compiler through its public interface.

mod controllability;
mod syntax;
mod vehicles;
