//! Results as texts, tables and pages; files of other tools, read and written.
//!
//! - What comes in: results of the rooms above; bytes of foreign files.
//! - What goes out: strings and bytes to be written; specs with their diagnostics.
//! - What it does not know: where anything is stored: no file is opened or written here.

pub mod exchange;
pub mod import;
pub mod log;
pub mod report;
#[cfg(feature = "report")]
pub mod safety;

#[cfg(test)]
#[path = "core/base/schemas.rs"]
pub mod schemas;
