//! The specs of the open texts, each compiled on demand and compiled again only after a change.

use super::documents::{Documents, name_of, range};
use super::mentions::Mentions;
use super::names::Names;
use crate::diagnostic::{Diagnostic, Severity, sort};
use crate::input::read_named;
use crate::model::Model;
use crate::read::{FileSet, Understanding, entries, load_among, understand};
use crate::source::{FileId, Source, Span};
use gen_lsp_types::{Location, TextDocumentContentChangeEvent};
use std::collections::{BTreeMap, BTreeSet};
use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Arc, OnceLock};
use url::Url;
use walkdir::{DirEntry, WalkDir};

/// One file set, from its root, as far as it could be understood.
#[derive(Debug)]
pub struct Spec {
    /// The root's name.
    pub root: String,
    pub files: FileSet,
    pub understanding: Understanding,
    /// `None` where an error prevents it.
    pub model: Option<Arc<Model>>,
    /// The diagnostics of loading and elaboration, in the order shown.
    pub diagnostics: Vec<Diagnostic>,
    names: OnceLock<Names>,
    mentions: OnceLock<Mentions>,
}

impl Spec {
    /// Compiles `text` and what it uses up to the model, as `mavc check` does.
    pub fn read(root: &str, text: &str, read: &dyn Fn(&Path) -> io::Result<Vec<u8>>) -> Self {
        let (files, mut diagnostics) = load_among(root, text.as_bytes(), read, &entries);
        let mut understanding = understand(&files, &[]);
        diagnostics.append(&mut understanding.checked.diagnostics);
        sort(&mut diagnostics);
        let broken = diagnostics.iter().any(|d| d.severity == Severity::Error);
        let model = understanding.checked.value.take().filter(|_| !broken).map(Arc::new);
        let (names, mentions) = (OnceLock::new(), OnceLock::new());
        Spec { root: root.to_string(), files, understanding, model, diagnostics, names, mentions }
    }

    /// Whether the file of this name is part of the spec.
    pub fn reads(&self, name: &str) -> bool {
        self.file(name).is_some()
    }

    pub fn file(&self, name: &str) -> Option<FileId> {
        self.files.sources.iter().find(|(_, source)| source.name == name).map(|(id, _)| id)
    }

    pub fn source(&self, file: FileId) -> &Source {
        self.files.sources.get(file)
    }

    pub fn snippet(&self, span: Span) -> &str {
        self.files.sources.snippet(span)
    }

    pub fn names(&self) -> &Names {
        self.names.get_or_init(|| Names::of(&self.files.files))
    }

    pub fn mentions(&self) -> &Mentions {
        self.mentions.get_or_init(|| Mentions::of(&self.files.files, self.names()))
    }
}

/// The open texts and the specs that they make up.
#[derive(Debug, Default)]
pub struct Workspace {
    pub documents: Documents,
    /// By the name of the root.
    specs: BTreeMap<String, Arc<Spec>>,
    /// Roots whose spec has to be compiled again.
    stale: BTreeSet<String>,
}

impl Workspace {
    pub fn open(&mut self, uri: Url, version: i32, text: String) {
        let name = name_of(&uri);
        self.documents.open(uri, version, text);
        self.changed(&name);
    }

    pub fn change(&mut self, name: &str, version: i32, changes: Vec<TextDocumentContentChangeEvent>) {
        self.documents.change(name, version, changes);
        self.changed(name);
    }

    pub fn close(&mut self, name: &str) {
        self.documents.close(name);
        self.specs.remove(name);
        self.changed(name);
    }

    /// Marks the specs that the file of this name is part of, or may be: what could not be found may be it.
    pub fn changed(&mut self, name: &str) {
        let concerned = self.specs.values().filter(|spec| spec.reads(name) || spec.files.incomplete);
        self.stale.extend(concerned.map(|spec| spec.root.clone()));
    }

    /// The specs of all open texts, each compiled if it has to be. A text that another open one uses is a part of that
    /// spec and none of its own.
    pub fn specs(&mut self) -> Vec<Arc<Spec>> {
        // The known roots first: they determine which texts need no spec of their own.
        let mut names: Vec<String> = self.documents.iter().map(|(name, _)| name.to_string()).collect();
        names.sort_by_key(|name| !self.specs.contains_key(name));
        for name in names {
            let fresh = self.specs.contains_key(&name) && !self.stale.contains(&name);
            if fresh || self.is_covered(&name) {
                continue;
            }
            if let Some(spec) = self.read(&name) {
                self.stale.remove(&name);
                self.specs.insert(name, Arc::new(spec));
            }
        }
        let covered: Vec<String> = self.specs.keys().filter(|name| self.is_covered(name)).cloned().collect();
        for name in covered {
            self.specs.remove(&name);
        }
        self.stale.retain(|name| self.specs.contains_key(name));
        self.specs.values().cloned().collect()
    }

    /// The spec that an open text is part of: its own, or the first that uses it.
    pub fn spec_of(&mut self, name: &str) -> Option<Arc<Spec>> {
        self.documents.get(name)?;
        let specs = self.specs();
        self.specs.get(name).cloned().or_else(|| specs.into_iter().find(|spec| spec.reads(name)))
    }

    /// Whether the text is part of another open one's spec. Where each uses the other, the one opened first is the
    /// root.
    fn is_covered(&self, name: &str) -> bool {
        let order = |name: &str| self.documents.get(name).map(|d| d.order);
        self.specs.values().any(|other| {
            other.root != name
                && !self.stale.contains(&other.root)
                && other.reads(name)
                && !(self.specs.get(name).is_some_and(|own| own.reads(&other.root)) && order(name) < order(&other.root))
        })
    }

    /// Compiles an open text.
    fn read(&self, name: &str) -> Option<Spec> {
        let document = self.documents.get(name)?;
        Some(Spec::read(name, &document.text, &|path| self.bytes(path)))
    }

    /// A file as the editor shows it, or else as it is stored.
    pub fn bytes(&self, path: &Path) -> io::Result<Vec<u8>> {
        if let Some(document) = self.documents.get(&path.display().to_string()) {
            return Ok(document.text.clone().into_bytes());
        }
        read_named(path)
    }

    /// The specs that the file of this name is part of: those of open texts, and of files in `folders` that use it.
    pub fn users(&mut self, name: &str, folders: &[PathBuf]) -> Vec<Arc<Spec>> {
        let mut specs = self.specs();
        specs.retain(|spec| spec.reads(name));
        for path in spec_files(folders) {
            let other = path.display().to_string();
            // A file that is open has been looked at as it is shown.
            if self.documents.get(&other).is_some() || specs.iter().any(|spec| spec.reads(&other)) {
                continue;
            }
            let Some(text) = self.bytes(&path).ok().and_then(|bytes| String::from_utf8(bytes).ok()) else { continue };
            if text.lines().any(|line| line.trim_start().starts_with("use ")) {
                let spec = Spec::read(&other, &text, &|path| self.bytes(path));
                if spec.reads(name) {
                    specs.push(Arc::new(spec));
                }
            }
        }
        specs
    }

    /// The URI of a file of a spec, as the client spells it where it is open.
    pub fn uri(&self, name: &str) -> Option<Url> {
        match self.documents.get(name) {
            Some(document) => Some(document.uri.clone()),
            None => Url::from_file_path(name).ok(),
        }
    }

    /// A place of a spec as clients want it.
    pub fn location(&self, spec: &Spec, span: Span) -> Option<Location> {
        let source = spec.source(span.file);
        let range = range(source, span.start as usize, span.end as usize);
        Some(Location { uri: self.uri(&source.name)?, range })
    }
}

/// The `.mav` files below some folders, as far as they are near and not too many. Hidden folders are left out.
fn spec_files(folders: &[PathBuf]) -> Vec<PathBuf> {
    const MOST_ENTRIES: usize = 20_000;
    const MOST_FILES: usize = 1000;
    const DEPTH: usize = 8;
    let is_hidden = |entry: &DirEntry| entry.depth() > 0 && entry.file_name().to_string_lossy().starts_with('.');
    let below = |folder: &PathBuf| {
        let entries = WalkDir::new(folder).max_depth(DEPTH).sort_by_file_name().into_iter();
        entries.filter_entry(move |entry| !is_hidden(entry)).flatten().take(MOST_ENTRIES)
    };
    let is_spec =
        |entry: &DirEntry| entry.file_type().is_file() && entry.path().extension().is_some_and(|e| e == "mav");
    folders.iter().flat_map(below).filter(is_spec).map(DirEntry::into_path).take(MOST_FILES).collect()
}
