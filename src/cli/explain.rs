use super::{FINE, Problem, files};
use crate::diagnostic::{codes, nearest};

/// `mavc explain`
pub fn run(code: Option<&str>) -> Result<u8, Problem> {
    let Some(code) = code else {
        for page in codes::all() {
            files::print(&format!("{}\n", page.code))?;
        }
        return Ok(FINE);
    };
    match codes::lookup(code) {
        Some(page) => {
            files::print(&format!("{}\n\n{}\n", page.code, page.page.trim()))?;
            Ok(FINE)
        }
        None => {
            let written = if code.starts_with("mavc::") { code.to_string() } else { format!("mavc::{code}") };
            let near = nearest(&written, codes::all().iter().map(|page| page.code));
            Err(match near {
                Some(near) => format!("there is no code {code}; did you mean {near}?"),
                None => format!("there is no code {code}; `mavc explain` lists all"),
            })
        }
    }
}
