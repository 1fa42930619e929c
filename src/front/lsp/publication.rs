//! Diagnostics for the editor: compiled when typing pauses, completed by the verdicts of the fault sets.

use super::diagnostics::diagnostic;
use super::documents::name_of;
use super::server::Server;
use super::workspace::Spec;
use crate::diagnostic::{Diagnostic, sort};
use gen_lsp_types as lsp;
use gen_lsp_types::PublishDiagnosticsParams;
use lsp_server::Notification;
use std::collections::BTreeMap;
use std::sync::Arc;
use std::time::{Duration, Instant};
use url::Url;

/// How long diagnostics wait for the verdicts of the fault sets: enough for known verdicts, so that nothing flickers.
const PATIENCE: Duration = Duration::from_millis(30);

/// How far the diagnostics of the last change have come.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Progress {
    Published,
    /// Something has changed.
    Due,
    /// Verdicts were requested in a round; at this instant publish without them, unless they have been published.
    Asked {
        round: u64,
        until: Option<Instant>,
    },
}

impl Server<'_> {
    /// Compiles what has changed and requests its verdicts.
    pub(super) fn look_again(&mut self) {
        let specs = self.workspace.specs();
        self.answers.retain(|root, (of, _)| specs.iter().any(|spec| spec.root == *root && Arc::ptr_eq(spec, of)));
        let round = self.verdicts.next_round();
        let mut asked = false;
        for spec in specs.iter().filter(|spec| !self.answers.contains_key(&spec.root)) {
            if let Some(model) = &spec.model {
                self.verdicts.ask(round, &spec.root, model);
                asked = true;
            }
        }
        if asked {
            self.progress = Progress::Asked { round, until: Some(Instant::now() + PATIENCE) };
        } else {
            self.progress = Progress::Published;
            self.publish();
        }
    }

    /// Takes the verdicts of a spec; those of an earlier round are ignored.
    pub(super) fn take_answers(&mut self, round: u64, root: String, diagnostics: Vec<Diagnostic>) {
        let Progress::Asked { round: current, .. } = self.progress else { return };
        if round != current {
            return;
        }
        let specs = self.workspace.specs();
        if let Some(spec) = specs.iter().find(|spec| spec.root == root) {
            self.answers.insert(root, (spec.clone(), diagnostics));
        }
        if specs.iter().all(|spec| spec.model.is_none() || self.answers.contains_key(&spec.root)) {
            self.progress = Progress::Published;
            self.publish();
        }
    }

    /// Everything that is known to be wrong with a spec, in the order shown.
    pub fn reported(&self, spec: &Arc<Spec>) -> Vec<Diagnostic> {
        let mut reported = spec.diagnostics.clone();
        if let Some((_, answers)) = self.answers.get(&spec.root).filter(|(of, _)| Arc::ptr_eq(of, spec)) {
            reported.extend(answers.iter().cloned());
            sort(&mut reported);
        }
        reported
    }

    /// Sends the editor what has changed since the last publication.
    pub(super) fn publish(&mut self) {
        let mut now: BTreeMap<Url, Vec<lsp::Diagnostic>> = BTreeMap::new();
        for (_, document) in self.workspace.documents.iter() {
            now.insert(document.uri.clone(), Vec::new());
        }
        for spec in self.workspace.specs() {
            for reported in self.reported(&spec) {
                let Some(uri) = self.workspace.uri(&spec.source(reported.span.file).name) else { continue };
                let diagnostic = diagnostic(&self.workspace, &spec, &reported);
                let list = now.entry(uri).or_default();
                // Two specs may share a file and what is wrong with it.
                if !list.contains(&diagnostic) {
                    list.push(diagnostic);
                }
            }
        }
        let gone: Vec<Url> = self.published.keys().filter(|uri| !now.contains_key(*uri)).cloned().collect();
        for uri in gone {
            if self.published.remove(&uri).is_some_and(|list| !list.is_empty()) {
                self.tell(uri, None, Vec::new());
            }
        }
        for (uri, list) in now {
            let version = self.workspace.documents.get(&name_of(&uri)).map(|document| document.version);
            // Diagnostics of an open text are sent each time, with its version.
            if version.is_some() || self.published.get(&uri) != Some(&list) {
                self.tell(uri.clone(), version, list.clone());
            }
            self.published.insert(uri, list);
        }
    }

    fn tell(&self, uri: Url, version: Option<i32>, diagnostics: Vec<lsp::Diagnostic>) {
        let params = PublishDiagnosticsParams { uri, version, diagnostics };
        self.send(Notification::new("textDocument/publishDiagnostics".into(), params));
    }
}
