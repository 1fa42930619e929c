//! `mavc fmt` as people and scripts use it.

use crate::cli::{mavc, mavc_with};
use std::fs;
use std::path::Path;

const UNTIDY: &str = "let  a=1\n";
const TIDY: &str = "let a = 1\n";
const BROKEN: &str = "let a = = 1\n";

/// What `--check` says of [`UNTIDY`].
fn told(name: &str) -> String {
    format!("{name}:1: would be reformatted\n  - let  a=1\n  + let a = 1\n")
}

fn folder(files: &[(&str, &str)]) -> tempfile::TempDir {
    let dir = tempfile::tempdir().unwrap();
    for (name, text) in files {
        let path = dir.path().join(name);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, text).unwrap();
    }
    dir
}

/// Exit code, standard output, standard error.
fn fmt(args: &[&str], input: &str) -> (i32, String, String) {
    let ran = mavc_with(&[&["fmt"], args].concat(), input);
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).unwrap();
    (ran.status.code().unwrap(), text(ran.stdout), text(ran.stderr))
}

fn name(path: &Path) -> &str {
    path.to_str().unwrap()
}

#[test]
fn standard_input_goes_to_standard_output() {
    assert_eq!(fmt(&["-"], UNTIDY), (0, TIDY.into(), String::new()));
    assert_eq!(fmt(&["-"], TIDY), (0, TIDY.into(), String::new()));
    assert_eq!(fmt(&["--check", "-"], UNTIDY), (1, told("<stdin>"), String::new()));
    assert_eq!(fmt(&["--check", "-", "--quiet"], UNTIDY), (1, "<stdin>\n".into(), String::new()));
    assert_eq!(fmt(&["--check", "-"], TIDY), (0, String::new(), String::new()));
    let (code, out, err) = fmt(&["-"], BROKEN);
    assert_eq!((code, out.as_str()), (1, ""));
    assert!(err.contains("mavc::syntax::") && err.contains("<stdin>"), "{err}");
}

#[test]
fn check_lists_what_would_change_and_writes_nothing() {
    let dir =
        folder(&[("a.mav", UNTIDY), ("b.mav", TIDY), ("sub/c.mav", UNTIDY), (".git/d.mav", UNTIDY), ("e.txt", UNTIDY)]);
    let path = |name: &str| dir.path().join(name).display().to_string();
    let (code, out, err) = fmt(&["--check", name(dir.path())], "");
    assert_eq!((code, out, err.as_str()), (1, told(&path("a.mav")) + &told(&path("sub/c.mav")), ""));
    assert_eq!(fs::read_to_string(path("a.mav")).unwrap(), UNTIDY);
    assert_eq!(fmt(&[name(dir.path())], ""), (0, String::new(), String::new()));
    for (file, text) in
        [("a.mav", TIDY), ("b.mav", TIDY), ("sub/c.mav", TIDY), (".git/d.mav", UNTIDY), ("e.txt", UNTIDY)]
    {
        assert_eq!(fs::read_to_string(path(file)).unwrap(), text, "{file}");
    }
    assert_eq!(fmt(&["--check", name(dir.path())], "").0, 0);
    // Nothing else is left there.
    assert_eq!(fs::read_dir(dir.path()).unwrap().count(), 5);
}

#[test]
fn check_shows_the_first_line_that_would_change() {
    for (text, line, shown) in [
        ("let a = 1\nlet b=2\n", 2, "- let b=2\n  + let b = 2"),
        ("let a = 1\n\n\nlet b = 2\n", 3, "- an empty line"),
        ("let a = 1\n\n", 2, "- an empty line"),
        ("let a = 1  \n", 1, "~ blanks at the line's end"),
        ("let a = 1", 1, "~ no line end at the end of the file"),
        ("let a = 1\r\nlet b = 2\n", 2, "~ no carriage return at the line's end, where the first line has one"),
        ("let a = 1\nlet b = 2\r\n", 2, "~ a carriage return at the line's end, where the first line has none"),
        ("\u{feff}let a = 1\n", 1, "~ a byte order mark at the beginning"),
    ] {
        let expected = format!("<stdin>:{line}: would be reformatted\n  {shown}\n");
        assert_eq!(fmt(&["--check", "-"], text), (1, expected, String::new()), "{text:?}");
    }
}

#[test]
fn a_broken_file_is_left_alone_and_holds_up_no_other() {
    let dir = folder(&[("a.mav", BROKEN), ("b.mav", UNTIDY)]);
    let (code, out, err) = fmt(&[name(dir.path())], "");
    assert_eq!((code, out.as_str()), (1, ""));
    assert!(err.contains("a.mav") && !err.contains("b.mav"), "{err}");
    assert_eq!(fs::read_to_string(dir.path().join("a.mav")).unwrap(), BROKEN);
    assert_eq!(fs::read_to_string(dir.path().join("b.mav")).unwrap(), TIDY);
    fs::write(dir.path().join("c.mav"), b"let a = \xff\n").unwrap();
    let (code, _, err) = fmt(&["--check", name(&dir.path().join("c.mav"))], "");
    assert_eq!(code, 1);
    assert!(err.contains("mavc::file::encoding"), "{err}");
}

#[test]
fn files_that_are_missing_end_with_2() {
    let dir = folder(&[("a.mav", UNTIDY), ("empty/readme", "")]);
    let missing = dir.path().join("none.mav");
    let (code, out, err) = fmt(&[name(&missing), name(&dir.path().join("a.mav"))], "");
    assert_eq!((code, out.as_str()), (2, ""));
    assert!(err.contains("none.mav: no such file"), "{err}");
    assert_eq!(fs::read_to_string(dir.path().join("a.mav")).unwrap(), TIDY);
    let (code, _, err) = fmt(&[name(&dir.path().join("empty"))], "");
    assert_eq!(code, 2);
    assert!(err.contains("holds no file whose name ends in .mav"), "{err}");
    assert_eq!(mavc(&["fmt"]).status.code(), Some(2));
}

#[cfg(unix)]
#[test]
fn a_file_keeps_its_permissions_and_its_links_and_is_left_where_nothing_changes() {
    use std::os::unix::fs::{MetadataExt, PermissionsExt, symlink};
    let dir = folder(&[("a.mav", UNTIDY)]);
    let (file, link) = (dir.path().join("a.mav"), dir.path().join("link.mav"));
    fs::set_permissions(&file, fs::Permissions::from_mode(0o640)).unwrap();
    symlink(&file, &link).unwrap();
    assert_eq!(fmt(&[name(&link)], "").0, 0);
    assert!(link.symlink_metadata().unwrap().is_symlink());
    assert_eq!(fs::read_to_string(&file).unwrap(), TIDY);
    let before = file.metadata().unwrap();
    assert_eq!(before.permissions().mode() & 0o777, 0o640);
    // Laid out already, it is not even opened for writing.
    fs::set_permissions(&file, fs::Permissions::from_mode(0o440)).unwrap();
    assert_eq!(fmt(&[name(&file)], "").0, 0);
    let after = file.metadata().unwrap();
    assert_eq!((after.ino(), after.mtime_nsec()), (before.ino(), before.mtime_nsec()));
}
