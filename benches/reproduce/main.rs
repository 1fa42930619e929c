//! Writes docs/reproduction.md: every table of the paper compared with the results of mavc.
//!
//!     cargo bench --bench reproduce              # to standard output
//!     cargo bench --bench reproduce -- --write   # to docs/reproduction.md
//!     cargo bench --bench reproduce -- --write --keep-shortest
//!
//! The last one keeps the exact model's shortest times from the existing page: their searches take minutes.

// By path, so that its parts are in the same folder.
#[path = "document.rs"]
mod document;
#[path = "shortest.rs"]
mod shortest;

use document::exact;

fn main() -> std::io::Result<()> {
    let arguments: Vec<String> = std::env::args().skip(1).filter(|argument| argument != "--bench").collect();
    let path = document::specs::root().join("docs/reproduction.md");
    match arguments.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        [] => print!("{}", document::whole(shortest::section)),
        ["--write"] => std::fs::write(path, document::whole(shortest::section))?,
        ["--write", "--keep-shortest"] => {
            let page = std::fs::read_to_string(&path)?;
            std::fs::write(path, document::whole(|| exact::written(&page).into()))?;
        }
        _ => {
            eprintln!("usage: reproduce [--write [--keep-shortest]]");
            std::process::exit(2);
        }
    }
    Ok(())
}
