//! Opening files that may be hostile. What a spec names is read only if it is a regular file of the right kind and size;
//! nothing else is opened for longer than it takes to see what it is, so that no pipe can hold mavc up and no text of
//! another kind is quoted in a diagnostic.

use crate::source::visible;
use crate::syntax::MAX_FILE_BYTES;
use std::fmt;
use std::fs::{File, OpenOptions};
use std::io::{Error, ErrorKind, Read, Result};
use std::path::{Path, PathBuf};

/// Largest table of waypoints, in bytes: 4 MiB.
pub const MAX_TABLE_BYTES: usize = 4 << 20;

/// What a spec can name.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    Spec,
    Table,
}

impl Kind {
    /// By the ending of the name, in upper or lower case; `None` for any other.
    pub fn of(path: &Path) -> Option<Kind> {
        let ending = path.extension()?.to_str()?.to_ascii_lowercase();
        [Kind::Spec, Kind::Table].into_iter().find(|kind| kind.endings().contains(&ending.as_str()))
    }

    pub fn endings(self) -> &'static [&'static str] {
        match self {
            Kind::Spec => &["mav"],
            Kind::Table => &["csv", "txt"],
        }
    }

    /// `.csv or .txt`, between backticks.
    pub fn endings_in_words(self) -> String {
        self.endings().iter().map(|ending| format!("`.{ending}`")).collect::<Vec<_>>().join(" or ")
    }

    /// Bytes.
    pub fn most(self) -> usize {
        match self {
            Kind::Spec => MAX_FILE_BYTES,
            Kind::Table => MAX_TABLE_BYTES,
        }
    }
}

/// Why a file that is there is not read; within an [`Error`].
#[derive(Debug)]
pub enum Refused {
    NotRegular,
    /// Its name does not end as those of the kind do.
    Ending(Kind),
    /// A link to a file of another kind.
    Elsewhere {
        target: PathBuf,
        kind: Kind,
    },
}

impl fmt::Display for Refused {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Refused::NotRegular => write!(f, "it is not a regular file"),
            Refused::Ending(kind) => write!(f, "its name does not end in {}", kind.endings_in_words()),
            Refused::Elsewhere { target, kind } => {
                let target = target.display().to_string();
                write!(
                    f,
                    "it is a link to `{}`, whose name does not end in {}",
                    visible::line(&target),
                    kind.endings_in_words()
                )
            }
        }
    }
}

impl std::error::Error for Refused {}

impl From<Refused> for Error {
    fn from(refused: Refused) -> Self {
        Error::other(refused)
    }
}

/// Reads a spec or a table, whichever the name says.
///
/// # Errors
/// [`Refused`] for a name of no kind, a link to another kind, and what is not a regular file;
/// [`ErrorKind::FileTooLarge`] past [`Kind::most`], without reading it.
pub fn read_named(path: &Path) -> Result<Vec<u8>> {
    let real = path.canonicalize()?;
    if real.is_dir() {
        return Err(ErrorKind::IsADirectory.into());
    }
    let kind = Kind::of(path).ok_or(Refused::Ending(Kind::Spec))?;
    if Kind::of(&real) != Some(kind) {
        return Err(Refused::Elsewhere { target: real, kind }.into());
    }
    let file = open_unfollowed(&real)?;
    if file.metadata()?.len() > kind.most() as u64 {
        return Err(ErrorKind::FileTooLarge.into());
    }
    at_most(file, kind.most())
}

/// Opens a regular file of any name, behind all links, without waiting.
///
/// # Errors
/// [`Refused::NotRegular`] for pipes, devices and sockets.
pub fn open_regular(path: &Path) -> Result<File> {
    open_unfollowed(&path.canonicalize()?)
}

/// All bytes, or one more than `most` where there are more.
///
/// # Errors
/// As reading fails.
pub fn at_most(input: impl Read, most: usize) -> Result<Vec<u8>> {
    let mut bytes = Vec::new();
    input.take(most as u64 + 1).read_to_end(&mut bytes)?;
    Ok(bytes)
}

/// Opens a regular file, and no link. What is behind the name is looked at before, because opening a device may do
/// something, and after, because it may have been changed meanwhile.
///
/// # Errors
/// [`Refused::NotRegular`] for links too.
pub fn open_unfollowed(path: &Path) -> Result<File> {
    regular(&path.symlink_metadata()?)?;
    let mut options = OpenOptions::new();
    options.read(true);
    without_waiting(&mut options);
    let file = options.open(path)?;
    regular(&file.metadata()?)?;
    Ok(file)
}

/// Refuses all but regular files.
///
/// # Errors
/// [`Refused::NotRegular`]; [`ErrorKind::IsADirectory`] for folders.
pub fn regular(there: &std::fs::Metadata) -> Result<()> {
    match (there.is_file(), there.is_dir()) {
        (true, _) => Ok(()),
        (_, true) => Err(ErrorKind::IsADirectory.into()),
        _ => Err(Refused::NotRegular.into()),
    }
}

/// Opening follows no link at the end of the name and waits for nobody at the other end of a pipe.
pub fn without_waiting(options: &mut OpenOptions) {
    #[cfg(unix)]
    std::os::unix::fs::OpenOptionsExt::custom_flags(options, libc::O_NOFOLLOW | libc::O_NONBLOCK);
    #[cfg(not(unix))]
    let _ = options;
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_say_what_a_file_is() {
        let of = |name: &str| Kind::of(Path::new(name));
        assert_eq!(
            ["a.mav", "b/A.MAV", "t.csv", "t.txt"].map(of),
            [Some(Kind::Spec), Some(Kind::Spec), Some(Kind::Table), Some(Kind::Table)]
        );
        assert_eq!(["", "mav", ".mav", "a.mav.key", "environ", "a.mav~"].map(of), [None; 6]);
    }

    #[test]
    fn large_files_are_refused_by_their_size() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.mav");
        // Of a hole nothing could be read in reasonable time.
        File::create(&path).unwrap().set_len(1 << 40).unwrap();
        assert_eq!(read_named(&path).unwrap_err().kind(), ErrorKind::FileTooLarge);
        File::create(&path).unwrap().set_len(MAX_FILE_BYTES as u64).unwrap();
        assert_eq!(read_named(&path).unwrap().len(), MAX_FILE_BYTES);
    }

    #[cfg(unix)]
    #[test]
    fn pipes_and_links_to_other_kinds_are_refused_unread() {
        use std::os::unix::fs::symlink;
        let folder = tempfile::tempdir().unwrap();
        let at = |name: &str| folder.path().join(name);
        std::fs::write(at("secret.key"), "s3cret").unwrap();
        std::fs::write(at("b.mav"), "let a = 1\n").unwrap();
        symlink("secret.key", at("a.mav")).unwrap();
        symlink("b.mav", at("c.mav")).unwrap();
        symlink("b.mav", at("c.csv")).unwrap();
        assert!(std::process::Command::new("mkfifo").arg(at("p.mav")).status().unwrap().success());
        let why = |name: &str| read_named(&at(name)).unwrap_err().to_string();
        assert!(why("a.mav").ends_with("secret.key`, whose name does not end in `.mav`"), "{}", why("a.mav"));
        assert!(why("c.csv").ends_with("b.mav`, whose name does not end in `.csv` or `.txt`"));
        assert_eq!(why("p.mav"), "it is not a regular file");
        assert_eq!(read_named(&at("c.mav")).unwrap(), b"let a = 1\n");
        assert_eq!(why("secret.key"), "its name does not end in `.mav`");
        assert!(open_regular(&at("a.mav")).is_ok() && open_regular(&at("p.mav")).is_err());
    }
}
