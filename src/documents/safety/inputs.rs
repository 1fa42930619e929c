//! What the files of an assessment are written from, and how the folder identifies it.

use super::sha256;
use crate::read::OVERRIDE;
use crate::source::SourceMap;
use std::path::{Component, Path, PathBuf};

/// The version and the commit of this program: `0.1.0, commit 0123456789ab`.
pub fn version() -> String {
    let facts: Vec<&str> = include_str!(concat!(env!("OUT_DIR"), "/version.txt")).lines().take(2).collect();
    let words: Vec<String> = facts.iter().map(|fact| fact.split_whitespace().collect::<Vec<_>>().join(" ")).collect();
    words.join(", ")
}

/// The folder of the tables of ways out, within that of the assessment, and the file with their hashes.
pub const TABLES: &str = "branches";
pub const SUMS: &str = "branches/SHA256SUMS";

/// The folder of the texts of the spec.
const SPEC: &str = "spec";

/// What the other files are written from, beside the spec.
#[derive(Clone, Copy)]
pub struct Inputs<'a> {
    /// The bytes of the report and of the certificate.
    pub report: &'a [u8],
    pub certificate: &'a [u8],
    /// The tables of the ways out that the report names, and their index, by name; none if they are not known.
    pub tables: &'a [(String, Vec<u8>)],
    /// The [`version`] that wrote the folder.
    pub written_by: &'a str,
    /// The names of the spec's texts in a folder that was written before, with their hashes; none in a new one.
    pub spec_files: &'a [(String, String)],
}

impl Inputs<'_> {
    /// The hashes of the tables in the form of `sha256sum`; `None` without tables.
    pub fn sums(&self) -> Option<String> {
        let line = |(name, bytes): &(String, Vec<u8>)| format!("{}  {name}\n", sha256(bytes));
        (!self.tables.is_empty()).then(|| self.tables.iter().map(line).collect())
    }

    /// The hash of [`SUMS`].
    pub fn tables_sha256(&self) -> Option<String> {
        self.sums().map(|text| sha256(text.as_bytes()))
    }

    /// Compares the names of the tables with the ways out of a report.
    ///
    /// # Errors
    /// A table is missing, or belongs to no way out.
    pub fn must_hold<'n>(&self, named: impl Iterator<Item = &'n String>) -> Result<(), String> {
        if self.tables.is_empty() {
            return Ok(());
        }
        let named: std::collections::BTreeSet<&str> = named.map(String::as_str).chain(["index.csv"]).collect();
        let there: std::collections::BTreeSet<&str> = self.tables.iter().map(|(name, _)| name.as_str()).collect();
        match (named.difference(&there).next(), there.difference(&named).next()) {
            (Some(name), _) => Err(format!("it names the way out {name}, which is not in {TABLES}")),
            (None, Some(name)) => Err(format!("it does not name {TABLES}/{name}")),
            (None, None) => Ok(()),
        }
    }
}

/// The hashes and the names of a text like that of [`Inputs::sums`]; `None` if it is another one, or names a file
/// outside of its folder.
pub fn listed(sums: &str) -> Option<Vec<(&str, &str)>> {
    let is_plain = |name: &str| matches!(Path::new(name).components().collect::<Vec<_>>()[..], [Component::Normal(_)]);
    sums.lines().map(|line| line.split_once("  ").filter(|(_, name)| is_plain(name))).collect()
}

/// Gives texts the names that a folder has for them, if it has these texts: a spec may have been renamed since.
pub fn rename(texts: &mut [Text], known: &[(String, String)]) {
    let same = |(text, (_, hash)): (&Text, &(String, String))| sha256(text.text.as_bytes()) == *hash;
    if texts.len() == known.len() && texts.iter().zip(known).all(same) {
        texts.iter_mut().zip(known).for_each(|(text, (name, _))| text.file = name.clone());
    }
}

/// A text of the spec.
pub struct Text<'a> {
    /// Its name in the folder.
    pub file: String,
    pub text: &'a str,
}

/// The texts of a spec in the order in which they were named. In the folder they lie to each other as they were read,
/// so that the copy is a spec too; where that would leave the folder, they are numbered.
pub fn texts(sources: &SourceMap) -> Vec<Text<'_>> {
    let read: Vec<_> = sources.iter().map(|(_, source)| source).filter(|source| source.name != OVERRIDE).collect();
    let paths: Vec<PathBuf> = read.iter().map(|source| resolved(Path::new(&source.name))).collect();
    let mut common = paths.first().and_then(|path| path.parent()).map(Path::to_path_buf).unwrap_or_default();
    while !paths.iter().all(|path| path.starts_with(&common)) {
        common.pop();
    }
    let inside = |path: &PathBuf| {
        let rest = path.strip_prefix(&common).ok()?;
        let names = rest.components().map(|part| match part {
            Component::Normal(name) => name.to_str(),
            _ => None,
        });
        names.collect::<Option<Vec<&str>>>().map(|names| names.join("/"))
    };
    let places: Option<Vec<String>> = paths.iter().map(inside).collect();
    let numbered = |(index, path): (usize, &PathBuf)| {
        let name = path.file_name().map_or("text".into(), |name| name.to_string_lossy().into_owned());
        format!("{}-{name}", index + 1)
    };
    let places = places.unwrap_or_else(|| paths.iter().enumerate().map(numbered).collect());
    let place = |place: String| if place == "<stdin>" { "stdin.mav".to_string() } else { place };
    let named = places.into_iter().map(|name| format!("{SPEC}/{}", place(name)));
    named.zip(read).map(|(file, source)| Text { file, text: &source.text }).collect()
}

/// The values of `--set`, in their order.
pub fn set(sources: &SourceMap) -> Vec<&str> {
    sources.iter().filter(|(_, source)| source.name == OVERRIDE).map(|(_, source)| source.text.as_str()).collect()
}

/// A path without `.`, and without `..` where a name goes before.
fn resolved(path: &Path) -> PathBuf {
    let mut parts = PathBuf::new();
    for part in path.components() {
        match part {
            Component::CurDir => {}
            Component::ParentDir if matches!(parts.components().next_back(), Some(Component::Normal(_))) => {
                parts.pop();
            }
            _ => parts.push(part),
        }
    }
    parts
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::source::Source;

    fn places(names: &[&str]) -> Vec<String> {
        let mut sources = SourceMap::default();
        for name in names {
            sources.add(Source::new(*name, "text"));
        }
        texts(&sources).into_iter().map(|text| text.file).collect()
    }

    #[test]
    fn texts_keep_their_places_to_each_other() {
        assert_eq!(places(&["/a/b/octo.mav"]), ["spec/octo.mav"]);
        assert_eq!(places(&["./octo.mav", "--set"]), ["spec/octo.mav"]);
        assert_eq!(places(&["<stdin>"]), ["spec/stdin.mav"]);
        let both = ["specs/missions/tour.mav", "specs/missions/../vehicles/hexa.mav"];
        assert_eq!(places(&both), ["spec/missions/tour.mav", "spec/vehicles/hexa.mav"]);
        assert_eq!(places(&["tour.mav", "../hexa.mav"]), ["spec/1-tour.mav", "spec/2-hexa.mav"]);
    }

    #[test]
    fn sums_name_no_file_of_another_folder() {
        assert_eq!(listed("ab  one.csv\ncd  index.csv\n"), Some(vec![("ab", "one.csv"), ("cd", "index.csv")]));
        for other in ["ab  ../one.csv\n", "ab  /one.csv\n", "ab  a/one.csv\n", "ab one.csv\n", "ab  \n"] {
            assert_eq!(listed(other), None, "{other}");
        }
    }
}
