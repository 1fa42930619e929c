//! The language server, through a client that speaks the protocol with it in memory.

mod asking;
mod client;
mod diagnosing;
mod documenting;
mod enduring;
mod families;
mod mending;
mod navigating;
