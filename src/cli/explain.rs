use super::{FINE, Problem, files};
use crate::diagnostic::codes;

/// `mavc explain`
pub fn run(code: Option<&str>) -> Result<u8, Problem> {
    let Some(code) = code else {
        for page in codes::all() {
            files::print(&format!("{}\n", page.code));
        }
        return Ok(FINE);
    };
    match codes::lookup(code) {
        Some(page) => {
            files::print(&format!("{}\n\n{}\n", page.code, page.page.trim()));
            Ok(FINE)
        }
        None => Err(format!("there is no code {code}; `mavc explain` lists all")),
    }
}
