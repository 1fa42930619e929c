//! Loads a file set: follows `use` and tables, through a reader supplied by the caller.

use std::collections::BTreeMap;
use std::io;
use std::path::{Component, Path, PathBuf};

use super::elaborate::expr_of;
use super::near_files::List;
use super::overrides::{OVERRIDE, Override};
use super::unreadable::{refused_by_name, unreadable};
use crate::diagnostic::{Diagnostic, Severity, sort};
use crate::foreign;
use crate::input::MAX_FILE_BYTES;
use crate::input::{FileKind, MAX_TABLE_BYTES};
use crate::language::table::rotor;
use crate::source::{FileId, Source, SourceMap, Span, Spanned, visible};
use crate::syntax::ast::{ExprKind, Field, Item, SpecFile, Statement};
use crate::syntax::{not_utf8, parse, too_large};

/// The most spec files, and the most tables, of one file set.
pub const MAX_FILES: usize = 256;

/// Everything that one compilation reads.
#[derive(Debug, Clone, Default)]
pub struct FileSet {
    /// All texts, including tables, in the order in which they were first named.
    pub sources: SourceMap,
    /// The parsed files, the root first.
    pub files: Vec<SpecFile>,
    /// The tables that `waypoints from` and `table` of a `rotor` name.
    pub tables: Vec<Table>,
    /// Some file could not be loaded, so that what seems to be missing may be declared there.
    pub incomplete: bool,
}

/// A table as read from its file.
#[derive(Debug, Clone)]
pub struct Table {
    pub name: String,
    pub bytes: Vec<u8>,
    /// Its text in [`FileSet::sources`].
    pub file: FileId,
}

impl FileSet {
    /// The names of the files that were read and of those that `use` names but that could not be read.
    pub fn names(&self) -> Vec<String> {
        let read = self.sources.iter().map(|(_, source)| source.name.clone());
        let used = self.files.iter().flat_map(|file| {
            let name = &self.sources.get(file.file).name;
            let used = file.items.iter().filter_map(|item| if let Item::Use(path) = item { Some(path) } else { None });
            used.map(|path| resolve(name, &path.value).display().to_string())
        });
        read.chain(used).filter(|name| !name.starts_with(['<', '-'])).collect()
    }

    /// The table at `path`, as written in `file`.
    pub fn table(&self, file: FileId, path: &str) -> Option<&Table> {
        let name = resolve(self.base(file), path).display().to_string();
        self.tables.iter().find(|table| table.name == name)
    }

    /// The name of the file whose folder the paths in `file` are relative to: an override is written as if in the root
    /// file.
    fn base(&self, file: FileId) -> &str {
        match self.sources.get(file).name.as_str() {
            OVERRIDE => &self.sources.get(FileId(0)).name,
            name => name,
        }
    }

    /// Reads the tables that overrides name; the diagnostics are those of tables that could not be read.
    pub(in crate::spec) fn bring_tables_of(
        &mut self,
        overrides: &[Override],
        read: &dyn Fn(&Path) -> io::Result<Vec<u8>>,
        list: &List,
    ) -> Vec<Diagnostic> {
        let mut loader = Loader { set: std::mem::take(self), ..Loader::new(read, list) };
        for table in overrides.iter().filter_map(table_of_override) {
            let from = loader.set.base(table.span.file).to_string();
            loader.bring_table(&from, &table);
        }
        *self = loader.set;
        loader.diagnostics
    }
}

/// Parses the root file and everything it uses, each file once. Paths given to `read` are relative to the same folder
/// as `root_name`.
///
/// Errors (missing files, cycles, limits, syntax) are returned as diagnostics together with what could be read.
pub fn load(
    root_name: &str,
    root_bytes: &[u8],
    read: &dyn Fn(&Path) -> io::Result<Vec<u8>>,
) -> (FileSet, Vec<Diagnostic>) {
    load_among(root_name, root_bytes, read, &|_| Vec::new())
}

/// Parses the root file and everything it uses, each file once, with paths relative to the folder of `root_name`.
/// `list` gives the contents of a folder ([`super::near_files::entries`]), so that the error for a missing file can
/// suggest a similar name.
pub fn load_among(
    root_name: &str,
    root_bytes: &[u8],
    read: &dyn Fn(&Path) -> io::Result<Vec<u8>>,
    list: &List,
) -> (FileSet, Vec<Diagnostic>) {
    let mut loader = Loader::new(read, list);
    loader.file(root_name.to_string(), root_bytes, None);
    sort(&mut loader.diagnostics);
    (loader.set, loader.diagnostics)
}

struct Loader<'r> {
    set: FileSet,
    diagnostics: Vec<Diagnostic>,
    read: &'r dyn Fn(&Path) -> io::Result<Vec<u8>>,
    list: &'r List<'r>,
    seen: BTreeMap<PathBuf, ()>,
    /// The files being loaded, the root first.
    open: Vec<PathBuf>,
}

impl<'r> Loader<'r> {
    fn new(read: &'r dyn Fn(&Path) -> io::Result<Vec<u8>>, list: &'r List<'r>) -> Self {
        let (set, seen) = (FileSet::default(), BTreeMap::new());
        Loader { set, diagnostics: Vec::new(), read, list, seen, open: Vec::new() }
    }

    /// Loads one file and what it uses. `used_at` is the place of the `use` that named it.
    fn file(&mut self, name: String, bytes: &[u8], used_at: Option<Span>) {
        let path = normal(Path::new(&name));
        self.seen.insert(path.clone(), ());
        let id = FileId(self.set.sources.iter().count() as u32);
        if let Some(other) = foreign::of_first_bytes(bytes) {
            let source = Source::new(&name, "");
            self.fail(other.error(id, &source));
            self.set.sources.add(source);
            return;
        }
        if bytes.len() > MAX_FILE_BYTES {
            self.set.sources.add(Source::new(&name, ""));
            let span = used_at.unwrap_or(Span::new(id, 0, 0));
            self.fail(too_large(&name, span, MAX_FILE_BYTES));
            return;
        }
        match Source::from_bytes(&name, bytes) {
            Ok(source) => self.set.sources.add(source),
            Err(error) => {
                let file = self.set.sources.add(error.source.clone());
                let diagnostic = not_utf8(file, &error);
                self.fail(match used_at {
                    Some(span) => diagnostic.also(span, "named here"),
                    None => diagnostic,
                });
                return;
            }
        };
        let checked = parse(id, self.set.sources.get(id));
        let has_errors = checked.diagnostics.iter().any(|d| d.severity == Severity::Error);
        if let Some(kind) = foreign::of_text(&self.set.sources.get(id).text).filter(|_| has_errors) {
            let error = kind.error(id, self.set.sources.get(id));
            self.fail(match used_at {
                Some(span) => error.also(span, "named here"),
                None => error,
            });
            return;
        }
        self.diagnostics.extend(checked.diagnostics);
        let Some(tree) = checked.value else {
            self.set.incomplete = true;
            return;
        };
        let wanted: Vec<Wanted> = tree.items.iter().flat_map(wanted).collect();
        self.set.files.push(tree);
        self.open.push(path);
        for want in wanted {
            match want {
                Wanted::Spec(path) => self.bring(&name, &path),
                Wanted::Table(path) => self.bring_table(&name, &path),
            }
        }
        self.open.pop();
    }

    fn bring(&mut self, from: &str, path: &Spanned<String>) {
        let target = resolve(from, &path.value);
        if let Some(first) = self.open.iter().position(|open| *open == target) {
            let circle: Vec<String> = self.open[first..]
                .iter()
                .chain([&target])
                .map(|p| format!("`{}`", visible::line(&p.display().to_string())))
                .collect();
            let message = format!("`{}` uses itself", target.display());
            let error = Diagnostic::error("mavc::file::cycle", path.span, message)
                .here("this file is already being read")
                .help(format!("remove one `use` from the cycle {}", circle.join(" -> ")));
            self.fail(error);
            return;
        }
        if self.seen.contains_key(&target) {
            return;
        }
        if self.seen.len() >= MAX_FILES {
            if !self.diagnostics.iter().any(|d| d.code == "mavc::file::too_many") {
                let message = format!("a spec may have at most {MAX_FILES} files");
                let error = Diagnostic::error("mavc::file::too_many", path.span, message).here("one too many");
                self.fail(error.help("merge some of the files"));
            }
            return;
        }
        match self.bytes(FileKind::Spec, &target, path, from) {
            Ok(bytes) => self.file(target.display().to_string(), &bytes, Some(path.span)),
            Err(diagnostic) => {
                self.seen.insert(target.clone(), ());
                // Read the file that was probably meant, so that what it declares is known.
                let near = diagnostic.fix.as_ref();
                let near = near.map(|fix| Spanned::new(fix.text.trim_matches('"').to_string(), path.span));
                match near.filter(|near| !self.open.contains(&resolve(from, &near.value))) {
                    Some(near) => {
                        self.diagnostics.push(*diagnostic);
                        self.bring(from, &near);
                    }
                    None => self.fail(*diagnostic),
                }
            }
        }
    }

    fn bring_table(&mut self, from: &str, path: &Spanned<String>) {
        let target = resolve(from, &path.value);
        let name = target.display().to_string();
        if self.set.tables.iter().any(|table| table.name == name) {
            return;
        }
        if self.set.tables.len() >= MAX_FILES {
            let message = format!("a spec may have at most {MAX_FILES} tables");
            let error = Diagnostic::error("mavc::file::too_many", path.span, message).here("one too many");
            self.fail(error.help("merge some of the tables"));
            return;
        }
        match self.bytes(FileKind::Table, &target, path, from) {
            Ok(bytes) if bytes.len() > MAX_TABLE_BYTES => self.fail(too_large(&name, path.span, MAX_TABLE_BYTES)),
            Ok(bytes) => match Source::from_bytes(&name, &bytes) {
                Ok(source) => {
                    // Without a byte order mark, so that offsets in the bytes are offsets in the text.
                    let bytes = source.text.clone().into_bytes();
                    let file = self.set.sources.add(source);
                    self.set.tables.push(Table { name, bytes, file });
                }
                Err(error) => {
                    let file = self.set.sources.add(error.source.clone());
                    self.fail(not_utf8(file, &error).also(path.span, "named here"));
                }
            },
            Err(diagnostic) => self.fail(*diagnostic),
        }
    }

    /// Reads the file at `path`, as written in `from`; a file with the wrong ending is not even opened.
    fn bytes(
        &self,
        kind: FileKind,
        target: &Path,
        path: &Spanned<String>,
        from: &str,
    ) -> Result<Vec<u8>, Box<Diagnostic>> {
        if let Some(refused) = refused_by_name(kind, target, path, from, self.list) {
            return Err(Box::new(refused));
        }
        (self.read)(target).map_err(|error| Box::new(unreadable(kind, target, path, from, &error, self.list)))
    }

    fn fail(&mut self, diagnostic: Diagnostic) {
        self.set.incomplete = true;
        self.diagnostics.push(diagnostic);
    }
}

enum Wanted {
    Spec(Spanned<String>),
    Table(Spanned<String>),
}

fn wanted(item: &Item) -> Vec<Wanted> {
    match item {
        Item::Use(path) => vec![Wanted::Spec(path.clone())],
        Item::Block(block) => {
            let tables = block.body.iter().flat_map(|statement| match statement {
                Statement::WaypointsFrom { path, .. } => vec![path.clone()],
                Statement::Block(inner) if inner.keyword.value == "rotor" => {
                    let fields =
                        inner.body.iter().filter_map(|s| if let Statement::Field(f) = s { Some(f) } else { None });
                    fields.filter_map(table_of_rotor).collect()
                }
                _ => vec![],
            });
            tables.map(Wanted::Table).collect()
        }
        _ => vec![],
    }
}

/// The path that a field of `rotor { }` names, if it is `table`.
fn table_of_rotor(field: &Field) -> Option<Spanned<String>> {
    let expr = expr_of(field).filter(|_| field.name.value == rotor::TABLE.name)?;
    match &expr.kind {
        ExprKind::Text(path) => Some(Spanned::new(path.clone(), expr.span)),
        _ => None,
    }
}

/// The table that `vehicle.rotor.table = ...` names.
fn table_of_override(item: &Override) -> Option<Spanned<String>> {
    let is_rotor = item.path.last().is_some_and(|block| block.value == "rotor");
    table_of_rotor(&item.field).filter(|_| is_rotor)
}

/// `path` relative to the folder of the file `from`, without `.` and without those `..` that can be resolved.
pub fn resolve(from: &str, path: &str) -> PathBuf {
    normal(&Path::new(from).parent().unwrap_or(Path::new("")).join(path))
}

fn normal(path: &Path) -> PathBuf {
    let mut result = PathBuf::new();
    for part in path.components() {
        match part {
            Component::CurDir => {}
            Component::ParentDir if matches!(result.components().next_back(), Some(Component::Normal(_))) => {
                result.pop();
            }
            part => result.push(part),
        }
    }
    result
}
