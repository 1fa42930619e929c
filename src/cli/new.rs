use super::{FINE, Options, Problem, USAGE, files};
use std::path::Path;

/// `mavc new`: never overwrites.
pub fn run(file: &Path, options: &Options) -> Result<u8, Problem> {
    if file.exists() {
        eprintln!("mavc: {} exists; nothing was written", file.display());
        return Ok(USAGE);
    }
    files::must_be_writable(file)?;
    files::write_whole(file, include_str!("../template.mav").as_bytes())?;
    if !options.quiet {
        let name = file.display();
        files::print(&format!("{name} written. Next: mavc plan {name} -o traj.csv\n"));
    }
    Ok(FINE)
}
