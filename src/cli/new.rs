use super::files::shown;
use super::target::{Target, write};
use super::{FINE, Options, Problem, files};
use std::path::Path;

/// `mavc new`: never overwrites.
pub fn run(file: &Path, options: &Options) -> Result<u8, Problem> {
    let name = shown(file);
    if file.as_os_str() != "-" && file.symlink_metadata().is_ok() {
        return Err(format!("{name} exists; nothing was written"));
    }
    let target = Target::new(file)?;
    write(&[(&target, crate::TEMPLATE)])?;
    if !options.quiet && !target.is_stdout() {
        // The file is there, told or not.
        let _ = files::print(&format!("{name} written. Next: mavc plan {name} -o traj.csv\n"));
    }
    Ok(FINE)
}
