//! The command and the language server.
//!
//! - What comes in: arguments, files, requests of an editor.
//! - What goes out: exit codes, files, texts for the terminal, answers to the editor.
//! - What it does not know: vehicles and missions: it asks the rooms above.

#[cfg(feature = "cli")]
pub mod cli;
#[cfg(feature = "lsp")]
pub mod lsp;
