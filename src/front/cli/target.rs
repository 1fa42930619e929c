//! The place that a result goes to: a file, which appears whole or not at all; a pipe; or standard output.

use super::CommandError;
use super::files::{print_result, reason, unless_gone};
use super::temporary::{self, folder};
use crate::input::Refused;
use std::fs::{File, OpenOptions};
use std::io::{Error, ErrorKind, Result as IoResult, Write};
use std::path::{Path, PathBuf};
use tempfile::NamedTempFile;

/// The place of one result.
pub struct Target {
    /// The user's spelling; `-` for standard output.
    name: PathBuf,
    place: Destination,
}

enum Destination {
    Stdout,
    /// The file behind all links; it appears whole, by a temporary file beside it and a rename.
    File(PathBuf),
    /// A pipe or a device, which is opened and written, never replaced.
    Stream,
}

impl Target {
    /// Finds the place, and fails before minutes of work if a result cannot be written there.
    pub fn new(name: &Path) -> Result<Target, CommandError> {
        let place = if name.as_os_str() == "-" { Ok(Destination::Stdout) } else { place(name) };
        let place = place.map_err(|e| cannot_write(name, &e))?;
        Ok(Target { name: name.into(), place })
    }

    /// Its name on one line.
    pub fn shown(&self) -> String {
        super::files::shown(&self.name)
    }

    pub fn is_stdout(&self) -> bool {
        matches!(self.place, Destination::Stdout)
    }

    /// The place of a file that mavc names, in a folder that the user names. A link of that name is not followed: the
    /// file replaces it.
    pub fn within(folder: &Path, name: &str) -> Result<Target, CommandError> {
        let path = folder.join(name);
        let cannot = |e: Error| cannot_write(&path, &e);
        match path.symlink_metadata() {
            Ok(there) if there.is_dir() => return Err(cannot(ErrorKind::IsADirectory.into())),
            Ok(there) if !there.is_file() && !there.is_symlink() => return Err(cannot(Refused::NotRegular.into())),
            _ => {}
        }
        let place = folder.canonicalize().and_then(|folder| checked(folder.join(name))).map_err(cannot)?;
        Ok(Target { name: path, place })
    }

    /// Refuses to replace a file that is read, or one that standard input or output is connected to.
    pub fn must_spare<'a>(&self, read: impl IntoIterator<Item = &'a str>) -> Result<(), CommandError> {
        let Destination::File(path) = &self.place else { return Ok(()) };
        // A file that does not exist yet is not among the files that were read.
        let Some(own) = own_identity(path) else { return Ok(()) };
        let refuse = |what: &str| Err(format!("{} is {what}: write to another file", self.name.display()));
        let is_own = |name: &&str| {
            let name = Path::new(name);
            [identity(name), own_identity(name)].iter().flatten().any(|id| *id == own)
        };
        if let Some(name) = read.into_iter().find(is_own) {
            let same = Path::new(name) == self.name;
            return refuse(&if same { "a file that is read".into() } else { format!("{name}, which is read") });
        }
        match streams().into_iter().find(|(_, stream)| *stream == Some(own)) {
            Some((what, _)) => refuse(what),
            None => Ok(()),
        }
    }

    /// The file behind all links; `None` for streams.
    pub fn file(&self) -> Option<&Path> {
        match &self.place {
            Destination::File(path) => Some(path),
            _ => None,
        }
    }

    /// Starts to write a result piece by piece.
    pub fn begin(&self) -> Result<Pieces<'_>, CommandError> {
        let sink = match &self.place {
            Destination::Stdout => Ok(Sink::Stream(Box::new(std::io::stdout()))),
            Destination::Stream => {
                OpenOptions::new().write(true).open(&self.name).map(|file| Sink::Stream(Box::new(file)))
            }
            Destination::File(path) => prepared(path).map(|file| Sink::File(file, path)),
        };
        let sink = sink.map_err(|e| cannot_write(&self.name, &e))?;
        Ok(Pieces { name: &self.name, sink })
    }

    /// Whether two results have the same place.
    pub fn is_same(&self, other: &Target) -> bool {
        match (&self.place, &other.place) {
            (Destination::Stdout, Destination::Stdout) => true,
            (Destination::File(a), Destination::File(b)) => {
                a == b || identity(a).is_some_and(|id| identity(b) == Some(id))
            }
            _ => false,
        }
    }
}

/// A result that is written piece by piece: a stream takes each piece, a file appears whole once it is finished.
pub struct Pieces<'a> {
    name: &'a Path,
    sink: Sink<'a>,
}

enum Sink<'a> {
    Stream(Box<dyn Write + Send>),
    File(NamedTempFile, &'a Path),
}

impl Write for Pieces<'_> {
    fn write(&mut self, bytes: &[u8]) -> IoResult<usize> {
        match &mut self.sink {
            Sink::Stream(stream) => stream.write(bytes),
            Sink::File(file, _) => file.write(bytes),
        }
    }

    fn flush(&mut self) -> IoResult<()> {
        match &mut self.sink {
            Sink::Stream(stream) => stream.flush(),
            Sink::File(file, _) => file.flush(),
        }
    }
}

impl Pieces<'_> {
    pub fn finish(self) -> Result<(), CommandError> {
        let finished = match self.sink {
            Sink::Stream(mut stream) => stream.flush(),
            Sink::File(file, path) => file.as_file().sync_all().and_then(|()| temporary::persist(file, path)),
        };
        finished.map_err(|e| cannot_write(self.name, &e))
    }
}

/// Writes results. Files appear together, after each of them and everything else has been written.
pub fn write(results: &[(&Target, &[u8])]) -> Result<(), CommandError> {
    let mut whole = Vec::new();
    for (target, bytes) in results {
        let attempt = match &target.place {
            Destination::Stdout => {
                print_result(bytes)?;
                Ok(())
            }
            Destination::File(path) => beside(path, bytes).map(|file| whole.push((target, path, file))),
            Destination::Stream => {
                let open = OpenOptions::new().write(true).open(&target.name);
                unless_gone(open.and_then(|mut stream| stream.write_all(bytes)))
            }
        };
        attempt.map_err(|e| cannot_write(&target.name, &e))?;
    }
    for (target, path, file) in whole {
        temporary::persist(file, path).map_err(|e| cannot_write(&target.name, &e))?;
    }
    Ok(())
}

pub fn cannot_write(name: &Path, e: &Error) -> CommandError {
    format!("cannot write {}: {}", name.display(), reason(e))
}

fn place(name: &Path) -> IoResult<Destination> {
    match std::fs::metadata(name) {
        Ok(there) if there.is_dir() => Err(ErrorKind::IsADirectory.into()),
        Ok(there) if !there.is_file() => Ok(Destination::Stream),
        Ok(_) => {
            OpenOptions::new().write(true).open(name)?;
            checked(name.canonicalize()?)
        }
        Err(e) if e.kind() == ErrorKind::NotFound => {
            // A link may lead to a file that does not exist yet.
            let mut path = name.to_path_buf();
            while let Ok(next) = path.read_link() {
                path = folder(&path).join(next);
            }
            let (Ok(folder), Some(file)) = (folder(&path).canonicalize(), path.file_name()) else {
                return Err(Error::other("its folder does not exist"));
            };
            checked(folder.join(file))
        }
        Err(e) => Err(e),
    }
}

/// Checks that the folder takes a temporary file.
fn checked(path: PathBuf) -> IoResult<Destination> {
    temporary::beside(&path)?;
    Ok(Destination::File(path))
}

/// A temporary file beside `path`, with its bytes, and with its permissions and owner where it exists.
fn beside(path: &Path, bytes: &[u8]) -> IoResult<NamedTempFile> {
    let mut file = prepared(path)?;
    file.write_all(bytes)?;
    file.as_file().sync_all()?;
    Ok(file)
}

/// An empty temporary file beside the target.
fn prepared(path: &Path) -> IoResult<NamedTempFile> {
    let file = temporary::beside(path)?;
    // Only a file that mavc names can be a link here ([`Target::within`]); its permissions do not count.
    if let Some(there) = path.symlink_metadata().ok().filter(std::fs::Metadata::is_file) {
        #[cfg(unix)]
        {
            use std::os::unix::fs::MetadataExt;
            // Only the superuser may change the owner; for anybody else the new file is their own.
            let _ = std::os::unix::fs::chown(file.path(), Some(there.uid()), Some(there.gid()));
        }
        std::fs::set_permissions(file.path(), there.permissions())?;
    }
    Ok(file)
}

/// What identifies a file, whatever its name.
#[cfg(unix)]
type FileIdentity = (u64, u64);
#[cfg(not(unix))]
type FileIdentity = PathBuf;

#[cfg(unix)]
fn identity(path: &Path) -> Option<FileIdentity> {
    use std::os::unix::fs::MetadataExt;
    path.metadata().ok().map(|there| (there.dev(), there.ino()))
}

/// The identity of the link itself, if it is one.
#[cfg(unix)]
fn own_identity(path: &Path) -> Option<FileIdentity> {
    use std::os::unix::fs::MetadataExt;
    path.symlink_metadata().ok().map(|there| (there.dev(), there.ino()))
}

#[cfg(not(unix))]
fn identity(path: &Path) -> Option<FileIdentity> {
    path.canonicalize().ok()
}

#[cfg(not(unix))]
fn own_identity(path: &Path) -> Option<FileIdentity> {
    let there = path.symlink_metadata().ok()?;
    let name = path.file_name().filter(|_| there.is_symlink());
    name.map_or_else(|| path.canonicalize().ok(), |name| Some(folder(path).canonicalize().ok()?.join(name)))
}

/// The files that standard input and standard output are connected to.
#[cfg(unix)]
fn streams() -> [(&'static str, Option<FileIdentity>); 2] {
    use std::os::fd::AsFd;
    use std::os::unix::fs::MetadataExt;
    let identity = |stream: std::os::fd::BorrowedFd| {
        let file = stream.try_clone_to_owned().map(File::from);
        file.and_then(|f| f.metadata()).ok().map(|there| (there.dev(), there.ino()))
    };
    [
        ("where standard input comes from", identity(std::io::stdin().as_fd())),
        ("where standard output goes", identity(std::io::stdout().as_fd())),
    ]
}

#[cfg(not(unix))]
fn streams() -> [(&'static str, Option<FileIdentity>); 0] {
    []
}
