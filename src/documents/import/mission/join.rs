//! A mission checked with a vehicle: the spec is compiled in memory, and what is wrong is reported at the item of the
//! file.

use super::write::{self, Written};
use super::{flyable, read};
use crate::diagnostic::{Diagnostic, sort};
use crate::import::MAX_BYTES;
use crate::read::FileSet;
use crate::source::{FileId, Source, SourceMap, Span};
use crate::spec::{Compiled, Compiler, Spec};
use crate::syntax::ast::Item;
use std::path::Path;
use std::sync::Arc;

/// A mission and a vehicle.
pub struct Joined {
    /// `None` if there is an error.
    pub spec: Option<Spec>,
    /// With the file of the mission in place of the text that was compiled.
    pub files: Arc<FileSet>,
    pub diagnostics: Vec<Diagnostic>,
}

/// Reads a mission and compiles it together with the spec at the path `vehicle`. Further diagnostics on the spec, such
/// as those of [`crate::check`], come from `more`.
pub fn join(
    name: &str,
    bytes: &[u8],
    vehicle: &str,
    compiler: &Compiler,
    more: impl FnOnce(&Spec) -> Vec<Diagnostic>,
) -> Joined {
    let mut found = Vec::new();
    let mut made = None;
    let chosen = write::name(name, &names_in(vehicle, compiler));
    let imported = crate::import::import(name, bytes, |source, warnings| {
        let draft = read(source, warnings)?;
        let path = Path::new(vehicle);
        let file = path.file_name().and_then(|file| file.to_str()).unwrap_or(vehicle);
        made = Some((write::text(source, &draft, Some(file), &chosen)?, draft));
        Ok((String::new(), Vec::new()))
    });
    found.extend(imported.diagnostics);
    let (Some((written, draft)), true) = (made, imported.text.is_some()) else {
        let files = FileSet { sources: imported.sources, ..FileSet::default() };
        return Joined { spec: None, files: Arc::new(files), diagnostics: found };
    };
    // Beside the vehicle, so that its name alone finds it.
    let folder = Path::new(vehicle).parent().unwrap_or(Path::new(""));
    let beside = folder.join(MISSION);
    // The spec may have a mission of its own, and its `plan` may name it.
    let compiler = compiler.clone().set(format!("plan.mission={chosen}"));
    let Compiled { spec, mut diagnostics, files } =
        compiler.text(&beside.display().to_string(), written.text.as_bytes());
    if let Some(spec) = &spec {
        diagnostics.extend(more(spec));
        found.extend(flyable::check(spec, &draft));
    }
    let compiled = files.sources.get(FileId(0)).clone();
    found.extend(diagnostics.into_iter().map(|d| placed(d, &compiled, &written)));
    sort(&mut found);
    let sources = with_first(imported.sources.get(FileId(0)).clone(), &files.sources);
    let files = Arc::new(FileSet { sources, ..FileSet::clone(&files) });
    Joined { spec, files, diagnostics: found }
}

/// The names that a spec and the files that it uses declare, so that a mission beside them can have another; none of a
/// file that cannot be read.
pub fn names_in(spec: &str, compiler: &Compiler) -> Vec<String> {
    let Ok(bytes) = crate::input::given(spec, crate::input::MAX_FILE_BYTES) else { return Vec::new() };
    let files = compiler.parse(spec, &bytes).files.files;
    let blocks = files.into_iter().flat_map(|file| file.items).filter_map(|item| match item {
        Item::Block(block) => block.name.map(|name| name.value),
        _ => None,
    });
    blocks.collect()
}

/// The name under which the text is compiled: no file can have it.
const MISSION: &str = "<mission>.mav";

const _: () = assert!(MAX_BYTES < u32::MAX as usize, "places are of 32 bits");

fn with_first(first: Source, sources: &SourceMap) -> SourceMap {
    let mut all = SourceMap::default();
    all.add(first);
    for (_, source) in sources.iter().skip(1) {
        all.add(source.clone());
    }
    all
}

/// The diagnostic at the item that its line came from. Edits of the spec that was compiled would not fit the file, and
/// are dropped.
fn placed(mut diagnostic: Diagnostic, compiled: &Source, written: &Written) -> Diagnostic {
    if diagnostic.span.file == FileId(0) {
        let (span, name) = origin(diagnostic.span, compiled, written);
        diagnostic.span = span;
        if let Some(name) = name {
            diagnostic.message = format!("{name}: {}", diagnostic.message);
        }
        diagnostic.fix = None;
    }
    for label in diagnostic.labels.iter_mut().filter(|label| label.span.file == FileId(0)) {
        let (span, name) = origin(label.span, compiled, written);
        label.span = span;
        if let Some(name) = name {
            label.message = format!("{name}: {}", label.message);
        }
    }
    if diagnostic.fix.as_ref().is_some_and(|fix| fix.span.file == FileId(0)) {
        diagnostic.fix = None;
    }
    diagnostic
}

/// The place in the file, and its name; the start of the file where a line came from nothing.
fn origin<'w>(span: Span, compiled: &Source, written: &'w Written) -> (Span, Option<&'w str>) {
    let line = compiled.place(span.start as usize).line - 1;
    match written.lines.get(line).and_then(Option::as_ref) {
        Some(mark) => (crate::import::at(mark.span.clone()), Some(&mark.name)),
        None => (Span::default(), None),
    }
}
