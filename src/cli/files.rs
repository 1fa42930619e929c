//! Files: specs in, results out, whole or not at all.

use super::Problem;
use std::io::{Read, Write};
use std::path::Path;

/// The bytes of a spec, at most one more than `most`; `-` is standard input.
pub fn read_spec(name: &str, most: usize) -> Result<Vec<u8>, Problem> {
    let mut bytes = Vec::new();
    let limit = most as u64 + 1;
    let result = if name == "-" {
        std::io::stdin().lock().take(limit).read_to_end(&mut bytes)
    } else {
        std::fs::File::open(name).and_then(|f| f.take(limit).read_to_end(&mut bytes))
    };
    match result {
        Ok(_) => Ok(bytes),
        Err(e) => Err(format!("cannot read {name}: {}", reason(&e))),
    }
}

/// Writes a file through a temporary neighbour and a rename, so that it appears whole or not at all.
pub fn write_whole(path: &Path, contents: &[u8]) -> Result<(), Problem> {
    let folder = match path.parent() {
        Some(p) if !p.as_os_str().is_empty() => p,
        _ => Path::new("."),
    };
    let attempt = || -> std::io::Result<()> {
        if path.is_dir() {
            return Err(std::io::Error::other("it is a folder"));
        }
        let mut file = tempfile::Builder::new().prefix(".mavc-").tempfile_in(folder)?;
        file.write_all(contents)?;
        file.as_file().sync_all()?;
        set_usual_permissions(file.path())?;
        file.persist(path).map_err(|e| e.error)?;
        Ok(())
    };
    attempt().map_err(|e| format!("cannot write {}: {}", path.display(), reason(&e)))
}

/// Temporary files are private; results are not.
#[cfg(unix)]
fn set_usual_permissions(path: &Path) -> std::io::Result<()> {
    use std::os::unix::fs::PermissionsExt;
    std::fs::set_permissions(path, std::fs::Permissions::from_mode(0o644))
}

#[cfg(not(unix))]
fn set_usual_permissions(_: &Path) -> std::io::Result<()> {
    Ok(())
}

/// Says early that a result could not be written, before minutes of work.
pub fn must_be_writable(path: &Path) -> Result<(), Problem> {
    let folder = match path.parent() {
        Some(p) if !p.as_os_str().is_empty() => p,
        _ => Path::new("."),
    };
    let refuse = |why: &str| Err(format!("cannot write {}: {why}", path.display()));
    if path.is_dir() {
        return refuse("it is a folder");
    }
    if !folder.is_dir() {
        return refuse("its folder does not exist");
    }
    match tempfile::Builder::new().prefix(".mavc-").tempfile_in(folder) {
        Ok(_) => Ok(()),
        Err(e) => refuse(&reason(&e)),
    }
}

/// An input-output error without the operating system's number.
pub fn reason(e: &std::io::Error) -> String {
    match e.kind() {
        std::io::ErrorKind::NotFound => "no such file".into(),
        std::io::ErrorKind::PermissionDenied => "permission denied".into(),
        std::io::ErrorKind::IsADirectory => "it is a folder".into(),
        _ => {
            let text = e.to_string();
            text.split(" (os error").next().unwrap_or(&text).to_string()
        }
    }
}

/// Prints to standard output; a reader that has gone away is no error.
pub fn print(text: &str) {
    let _ = anstream::stdout().write_all(text.as_bytes());
    let _ = anstream::stdout().flush();
}
