//! The path by which one file names another.

use crate::cli::Problem;
use crate::cli::files::cannot_read;
use std::path::{Component, Path, PathBuf};

/// The path of the spec `used` as a spec at `output` names it: relative to the folder of `output`, or to the present
/// one without an output.
pub fn relative(used: &Path, output: Option<&Path>) -> Result<String, Problem> {
    let whole = used.canonicalize().map_err(|e| cannot_read(used, &e))?;
    let folder = match output.filter(|path| path.as_os_str() != "-").and_then(Path::parent) {
        Some(folder) if folder.as_os_str().is_empty() => Path::new("."),
        Some(folder) => folder,
        None => Path::new("."),
    };
    let folder = folder.canonicalize().map_err(|e| cannot_read(folder, &e))?;
    let (from, to): (Vec<Component>, Vec<Component>) = (folder.components().collect(), whole.components().collect());
    let common = from.iter().zip(&to).take_while(|(a, b)| a == b).count();
    // Another drive, of which only the whole path tells.
    let path: PathBuf = match common {
        0 => whole.clone(),
        _ => from[common..].iter().map(|_| Component::ParentDir).chain(to[common..].iter().copied()).collect(),
    };
    match path.to_str() {
        Some(text) => Ok(text.replace('\\', "/")),
        None => Err(format!("{} cannot be named in a spec: its name is not UTF-8", used.display())),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_is_named_from_the_folder_of_the_other() {
        let dir = tempfile::tempdir().unwrap();
        let [vehicle, folder] = ["v/quad.mav", "m/deep"].map(|name| dir.path().join(name));
        std::fs::create_dir_all(vehicle.parent().unwrap()).unwrap();
        std::fs::create_dir_all(&folder).unwrap();
        std::fs::write(&vehicle, "").unwrap();
        let named = |output: &Path| relative(&vehicle, Some(output)).unwrap();
        assert_eq!(named(&folder.join("out.mav")), "../../v/quad.mav");
        assert_eq!(named(&dir.path().join("v/out.mav")), "quad.mav");
        assert_eq!(named(&dir.path().join("out.mav")), "v/quad.mav");
        assert!(relative(&dir.path().join("none.mav"), None).is_err());
    }
}
