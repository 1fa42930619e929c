//! `mavc new`: writes a spec to start from, and never overwrites a file.

use super::files::shown;
use super::target::{Target, write};
use super::{CommandError, FINE, Options, files};
use std::path::Path;

/// Writes the template, or with a `mission` that of this kind (a name in [`crate::MISSION_TEMPLATES`]).
pub fn run(file: &Path, mission: Option<&str>, options: &Options) -> Result<u8, CommandError> {
    let name = shown(file);
    if file.as_os_str() != "-" && file.symlink_metadata().is_ok() {
        return Err(format!("{name} exists already; nothing was written"));
    }
    let target = Target::new(file)?;
    let of_kind = crate::MISSION_TEMPLATES.iter().find(|(kind, _)| Some(*kind) == mission);
    write(&[(&target, of_kind.map_or(crate::TEMPLATE, |(_, text)| text).as_bytes())])?;
    if !options.quiet && !target.is_stdout() {
        // The file has been written even if this line cannot be printed.
        let _ = files::print(&format!("{name} written. Next: mavc plan {name} -o traj.csv\n"));
    }
    Ok(FINE)
}
