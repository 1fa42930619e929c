//! Writes docs/reproduction.md: every table of the paper beside what mavc computes.
//!
//!     cargo run --release --example reproduce              # to standard output
//!     cargo run --release --example reproduce -- --write   # to docs/reproduction.md

// By path, so that its parts lie beside it.
#[path = "document.rs"]
mod document;

fn main() -> std::io::Result<()> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    match arguments.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        [] => print!("{}", page()),
        ["--write"] => std::fs::write(document::specs::root().join("docs/reproduction.md"), page())?,
        _ => {
            eprintln!("usage: reproduce [--write]");
            std::process::exit(2);
        }
    }
    Ok(())
}

fn page() -> String {
    document::whole(document::exact::shortest)
}
