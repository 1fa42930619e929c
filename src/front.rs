//! The command, the language server and the live page.
//!
//! - What comes in: arguments, files, requests of an editor or a browser.
//! - What goes out: exit codes, files, texts for the terminal, answers to the editor, pages.
//! - What it does not know: vehicles and missions: it asks the rooms above.

#[cfg(feature = "cli")]
pub mod cli;
#[cfg(feature = "lsp")]
pub mod lsp;
#[cfg(feature = "cli")]
mod view;
#[cfg(feature = "cli")]
mod watched;
