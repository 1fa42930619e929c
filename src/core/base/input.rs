//! Opens files that may be hostile. A file that a spec names is read only if it is a regular file of the right kind and
//! size, so that no pipe can block mavc and no content of other files is quoted in a diagnostic.

use crate::source::visible;
use std::fmt;
use std::fs::{File, OpenOptions};
use std::io::{Error, ErrorKind, Read, Result};
use std::path::{Path, PathBuf};

/// The largest text of a spec, in bytes: 1 MiB.
pub const MAX_FILE_BYTES: usize = 1 << 20;

/// The largest table of waypoints or thrusts, in bytes: 4 MiB.
pub const MAX_TABLE_BYTES: usize = 4 << 20;

/// The kinds of files that a spec can name.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FileKind {
    Spec,
    Table,
}

impl FileKind {
    /// The kind by the extension of the name, in upper or lower case; `None` for any other.
    pub fn of(path: &Path) -> Option<FileKind> {
        let ending = path.extension()?.to_str()?.to_ascii_lowercase();
        [FileKind::Spec, FileKind::Table].into_iter().find(|kind| kind.endings().contains(&ending.as_str()))
    }

    /// The allowed extensions, in lower case and without the dot.
    pub fn endings(self) -> &'static [&'static str] {
        match self {
            FileKind::Spec => &["mav"],
            FileKind::Table => &["csv", "txt"],
        }
    }

    /// The allowed extensions for messages: `.csv` or `.txt`, in backquotes.
    pub fn endings_in_words(self) -> String {
        self.endings().iter().map(|ending| format!("`.{ending}`")).collect::<Vec<_>>().join(" or ")
    }

    /// The largest size of a file of this kind, in bytes.
    pub fn most(self) -> usize {
        match self {
            FileKind::Spec => MAX_FILE_BYTES,
            FileKind::Table => MAX_TABLE_BYTES,
        }
    }
}

/// Why an existing file is not read; wrapped in an [`Error`].
#[derive(Debug)]
pub enum Refused {
    /// A pipe, device, socket or, where links are not followed, a link.
    NotRegular,
    /// Its extension is not one of the kind's.
    Ending(FileKind),
    /// It is a link to a file of another kind.
    Elsewhere { target: PathBuf, kind: FileKind },
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

/// Reads a spec or a table, depending on the extension.
///
/// # Errors
/// [`Refused`] for any other extension, a link to another kind of file, and anything but a regular file;
/// [`ErrorKind::FileTooLarge`] for a file larger than [`FileKind::most`], which is not read; other errors of the file
/// system.
pub fn read_named(path: &Path) -> Result<Vec<u8>> {
    let real = path.canonicalize()?;
    if real.is_dir() {
        return Err(ErrorKind::IsADirectory.into());
    }
    let kind = FileKind::of(path).ok_or(Refused::Ending(FileKind::Spec))?;
    if FileKind::of(&real) != Some(kind) {
        return Err(Refused::Elsewhere { target: real, kind }.into());
    }
    let file = open_unfollowed(&real)?;
    if file.metadata()?.len() > kind.most() as u64 {
        return Err(ErrorKind::FileTooLarge.into());
    }
    at_most(file, kind.most())
}

/// Opens a regular file of any name, following links, without blocking.
///
/// # Errors
/// [`Refused::NotRegular`] for pipes, devices and sockets; other errors of the file system.
pub fn open_regular(path: &Path) -> Result<File> {
    open_unfollowed(&path.canonicalize()?)
}

/// Reads all bytes, but at most `most + 1`, so that the caller can detect an input that is too large.
///
/// # Errors
/// Those of reading.
pub fn at_most(input: impl Read, most: usize) -> Result<Vec<u8>> {
    let mut bytes = Vec::new();
    input.take(most as u64 + 1).read_to_end(&mut bytes)?;
    Ok(bytes)
}

/// Opens a regular file, without following links. The type of the file is checked before opening, because opening a
/// device may have effects, and afterwards, because the file may have been replaced in between.
///
/// # Errors
/// [`Refused::NotRegular`] for anything else, including links; other errors of the file system.
fn open_unfollowed(path: &Path) -> Result<File> {
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

/// Makes opening fail for a link in the last component of the name, and return at once for a pipe.
pub fn without_waiting(options: &mut OpenOptions) {
    #[cfg(unix)]
    std::os::unix::fs::OpenOptionsExt::custom_flags(options, libc::O_NOFOLLOW | libc::O_NONBLOCK);
    #[cfg(not(unix))]
    let _ = options;
}

/// The bytes of a spec or a certificate, at most one more than `most`; `-` is standard input. A name that ends in
/// `.mav` is read by the rules of `use`, because somebody else may have put a link or a pipe there. Any other name is
/// read as it is: the user means that stream or file, such as `/dev/fd/63`.
///
/// # Errors
/// The file cannot be read.
pub fn given(name: &str, most: usize) -> Result<Vec<u8>> {
    let path = Path::new(name);
    if name == "-" {
        return at_most(std::io::stdin().lock(), most);
    }
    if FileKind::of(path) != Some(FileKind::Spec) {
        return File::open(path).and_then(|file| at_most(file, most));
    }
    // A spec above its limit of size is an error in the spec, reported with a code.
    match read_named(path) {
        Err(e) if e.kind() == ErrorKind::FileTooLarge => open_regular(path).and_then(|file| at_most(file, most)),
        read => read,
    }
}

/// An input-output error without the operating system's number.
pub fn reason(e: &Error) -> String {
    match e.kind() {
        ErrorKind::NotFound => "no such file".into(),
        ErrorKind::PermissionDenied => "permission denied".into(),
        ErrorKind::IsADirectory => "it is a folder".into(),
        _ => {
            let text = e.to_string();
            text.split(" (os error").next().unwrap_or(&text).to_string()
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_say_what_a_file_is() {
        let of = |name: &str| FileKind::of(Path::new(name));
        assert_eq!(
            ["a.mav", "b/A.MAV", "t.csv", "t.txt"].map(of),
            [Some(FileKind::Spec), Some(FileKind::Spec), Some(FileKind::Table), Some(FileKind::Table)]
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
