//! Which request gets which answer.

use super::completion::{Offer, offers};
use super::documents::{name_of, offset, range};
use super::hover::{Shown, hover};
use super::navigation::{Somewhere, file_named_at, places, places_in_all, target};
use super::rename::rename;
use super::server::Server;
use super::workspace::Spec;
use super::{actions, formatting, hints, outline, tokens};
use crate::source::{FileId, Span};
use gen_lsp_types::*;
use lsp_server::{ErrorCode, RequestId, Response};
use serde_json::Value;
use std::collections::HashMap;
use std::sync::Arc;
use url::Url;

/// Why a request cannot be carried out.
struct Refusal {
    code: i32,
    message: String,
}

/// `RequestFailed` of the protocol: the request is sound, but not to be met.
const REQUEST_FAILED: i32 = -32803;

type Answered<T> = Result<T, Refusal>;

/// What the server offers.
pub fn capabilities() -> ServerCapabilities {
    let sync = TextDocumentSyncOptions {
        open_close: Some(true),
        change: Some(TextDocumentSyncKind::Incremental),
        ..TextDocumentSyncOptions::default()
    };
    let semantic = SemanticTokensOptions { legend: tokens::legend(), full: Some(true.into()), ..Default::default() };
    let kinds = Some(vec![CodeActionKind::QuickFix]);
    ServerCapabilities {
        position_encoding: Some(PositionEncodingKind::UTF16),
        text_document_sync: Some(sync.into()),
        hover_provider: Some(true.into()),
        completion_provider: Some(CompletionOptions {
            trigger_characters: Some([" ", "=", "[", "(", "\"", "/"].map(String::from).to_vec()),
            ..CompletionOptions::default()
        }),
        definition_provider: Some(true.into()),
        references_provider: Some(true.into()),
        document_highlight_provider: Some(true.into()),
        rename_provider: Some(RenameOptions { prepare_provider: Some(true), ..Default::default() }.into()),
        document_symbol_provider: Some(true.into()),
        folding_range_provider: Some(true.into()),
        semantic_tokens_provider: Some(semantic.into()),
        code_action_provider: Some(CodeActionOptions { code_action_kinds: kinds, ..Default::default() }.into()),
        inlay_hint_provider: Some(true.into()),
        document_formatting_provider: Some(true.into()),
        ..ServerCapabilities::default()
    }
}

/// The response to a request; `None` where it comes later.
pub fn answer(server: &mut Server, request: lsp_server::Request) -> Option<Response> {
    let lsp_server::Request { id, method, params } = request;
    macro_rules! by {
        ($kind:ty, $answer:expr) => {
            respond::<$kind>(id, params, |params| $answer(server, params))
        };
    }
    Some(match method.as_str() {
        "textDocument/hover" => return answer_hover(server, id, params),
        "textDocument/completion" => by!(CompletionRequest, completion),
        "textDocument/definition" => by!(DefinitionRequest, definition),
        "textDocument/references" => by!(ReferencesRequest, references),
        "textDocument/documentHighlight" => by!(DocumentHighlightRequest, highlights),
        "textDocument/prepareRename" => by!(PrepareRenameRequest, prepare_rename),
        "textDocument/rename" => by!(RenameRequest, renamed),
        "textDocument/documentSymbol" => by!(DocumentSymbolRequest, symbols),
        "textDocument/foldingRange" => by!(FoldingRangeRequest, folds),
        "textDocument/semanticTokens/full" => by!(SemanticTokensRequest, semantic_tokens),
        "textDocument/codeAction" => by!(CodeActionRequest, code_actions),
        "textDocument/formatting" => by!(DocumentFormattingRequest, formatted),
        "textDocument/inlayHint" => by!(InlayHintRequest, inlay_hints),
        _ => {
            let message = format!("mavc does not know `{method}`");
            Response::new_err(id, ErrorCode::MethodNotFound as i32, message)
        }
    })
}

/// Reads the parameters, answers, and wraps the answer up.
fn respond<R: Request>(
    id: RequestId,
    params: Value,
    answer: impl FnOnce(R::Params) -> Answered<R::Result>,
) -> Response {
    let params = match serde_json::from_value(params) {
        Ok(params) => params,
        Err(error) => return Response::new_err(id, ErrorCode::InvalidParams as i32, error.to_string()),
    };
    match answer(params) {
        Ok(result) => Response::new_ok(id, result),
        Err(Refusal { code, message }) => Response::new_err(id, code, message),
    }
}

/// The spec that an open text is part of, and which of its files that is.
fn look_up(server: &mut Server, uri: &Url) -> Option<(Arc<Spec>, FileId)> {
    let name = name_of(uri);
    let spec = server.workspace.spec_of(&name)?;
    let file = spec.file(&name)?;
    Some((spec, file))
}

/// The spec and the file of a position, with its byte offset.
fn look_at(server: &mut Server, at: &TextDocumentPositionParams) -> Option<(Arc<Spec>, FileId, usize)> {
    let (spec, file) = look_up(server, &at.text_document.uri)?;
    let offset = offset(spec.source(file), at.position);
    Some((spec, file, offset))
}

fn answer_hover(server: &mut Server, id: RequestId, params: Value) -> Option<Response> {
    let params: HoverParams = match serde_json::from_value(params) {
        Ok(params) => params,
        Err(error) => return Some(Response::new_err(id, ErrorCode::InvalidParams as i32, error.to_string())),
    };
    let found = look_at(server, &params.text_document_position_params);
    let shown = found.and_then(|(spec, file, offset)| Some((hover(&spec, file, offset)?, spec)));
    let Some((shown, spec)) = shown else { return Some(Response::new_ok(id, Value::Null)) };
    if shown.wanted.is_some() {
        server.wait_for_verdicts(id, spec, shown);
        return None;
    }
    Some(hover_response(id, &spec, shown))
}

/// A hover as the protocol has it.
pub fn hover_response(id: RequestId, spec: &Spec, shown: Shown) -> Response {
    let Span { file, start, end } = shown.span;
    let contents = MarkupContent { kind: MarkupKind::Markdown, value: shown.text };
    let range = range(spec.source(file), start as usize, end as usize);
    Response::new_ok(id, Hover { contents: contents.into(), range: Some(range) })
}

fn completion(server: &mut Server, params: CompletionParams) -> Answered<Option<CompletionResponse>> {
    let by_blank = params.context.is_some_and(|context| context.trigger_character.as_deref() == Some(" "));
    let Some((spec, file, offset)) = look_at(server, &params.text_document_position_params) else { return Ok(None) };
    let (offers, replaced) = offers(&spec, file, offset);
    let replaced = range(spec.source(file), replaced.start, replaced.end);
    // Indenting a line requests nothing.
    let offers =
        offers.into_iter().filter(|offer| !by_blank || offer.rank == 0 || offer.kind == CompletionItemKind::Unit);
    let item = |offer: Offer| {
        let snippet = offer.snippet.filter(|_| server.client.snippets);
        CompletionItem {
            kind: Some(offer.kind),
            detail: offer.detail,
            documentation: offer.documentation.map(|value| MarkupContent { kind: MarkupKind::Markdown, value }.into()),
            sort_text: Some(format!("{:03} {}", offer.rank, offer.label)),
            insert_text_format: snippet.is_some().then_some(InsertTextFormat::Snippet),
            text_edit: Some(TextEdit { range: replaced, new_text: snippet.unwrap_or(offer.insert) }.into()),
            label: offer.label,
            ..CompletionItem::default()
        }
    };
    Ok(Some(offers.map(item).collect::<Vec<_>>().into()))
}

fn definition(server: &mut Server, params: DefinitionParams) -> Answered<Option<DefinitionResponse>> {
    let Some((spec, file, offset)) = look_at(server, &params.text_document_position_params) else { return Ok(None) };
    let location = match target(&spec, file, offset) {
        Some((index, _)) => server.workspace.location(&spec, spec.names().definitions[index].span),
        None => {
            file_named_at(&spec, file, offset).and_then(|file| server.workspace.location(&spec, Span::new(file, 0, 0)))
        }
    };
    Ok(location.map(|location| Definition::from(location).into()))
}

fn references(server: &mut Server, params: ReferenceParams) -> Answered<Option<Vec<Location>>> {
    let Some((spec, file, offset)) = look_at(server, &params.text_document_position_params) else { return Ok(None) };
    let Some((index, _)) = target(&spec, file, offset) else { return Ok(None) };
    let (declared, specs) = users(server, &spec, index);
    let mut all = places_in_all(&specs, &declared);
    if !params.context.include_declaration {
        all.remove(&declared);
    }
    Ok(Some(all.iter().filter_map(|place| location(server, &specs, place)).collect()))
}

/// The place of a definition, and every spec that knows it.
fn users(server: &mut Server, spec: &Spec, index: usize) -> (Somewhere, Vec<Arc<Spec>>) {
    let span = spec.names().definitions[index].span;
    let name = spec.source(span.file).name.clone();
    let folders = server.folders.clone();
    let specs = server.workspace.users(&name, &folders);
    ((name, span.start as usize, span.end as usize), specs)
}

fn location(server: &Server, specs: &[Arc<Spec>], (name, start, end): &Somewhere) -> Option<Location> {
    let (spec, file) = specs.iter().find_map(|spec| Some((spec, spec.file(name)?)))?;
    server.workspace.location(spec, Span::new(file, *start, *end))
}

fn highlights(server: &mut Server, params: DocumentHighlightParams) -> Answered<Option<Vec<DocumentHighlight>>> {
    let Some((spec, file, offset)) = look_at(server, &params.text_document_position_params) else { return Ok(None) };
    let Some((index, _)) = target(&spec, file, offset) else { return Ok(None) };
    let here = places(&spec, index).into_iter().filter(|span| span.file == file);
    let at = |span: Span| DocumentHighlight {
        range: range(spec.source(file), span.start as usize, span.end as usize),
        kind: Some(DocumentHighlightKind::Text),
    };
    Ok(Some(here.map(at).collect()))
}

fn prepare_rename(server: &mut Server, params: PrepareRenameParams) -> Answered<Option<PrepareRenameResult>> {
    let Some((spec, file, offset)) = look_at(server, &params.text_document_position_params) else { return Ok(None) };
    let Some((index, span)) = target(&spec, file, offset) else { return Ok(None) };
    let placeholder = spec.names().definitions[index].name.clone();
    let range = range(spec.source(file), span.start as usize, span.end as usize);
    Ok(Some(PrepareRenameResult::PrepareRenamePlaceholder(PrepareRenamePlaceholder { range, placeholder })))
}

fn renamed(server: &mut Server, params: RenameParams) -> Answered<Option<WorkspaceEdit>> {
    let refuse = |message: String| Refusal { code: REQUEST_FAILED, message };
    let Some((spec, file, offset)) = look_at(server, &params.text_document_position_params) else { return Ok(None) };
    let Some((index, _)) = target(&spec, file, offset) else {
        return Err(refuse("there is no name here that the spec declares".into()));
    };
    let (_, specs) = users(server, &spec, index);
    let new = params.new_name.as_str();
    let edits = rename(&server.workspace, &specs, &spec, index, new).map_err(refuse)?;
    let mut changes: HashMap<Url, Vec<TextEdit>> = HashMap::new();
    for edit in &edits {
        if let Some(Location { uri, range }) = location(server, &specs, edit) {
            changes.entry(uri).or_default().push(TextEdit { range, new_text: new.to_string() });
        }
    }
    Ok(Some(workspace_edit(server, changes)))
}

/// The edits as the editor can take them: of each text that is open with the version that they are meant for.
fn workspace_edit(server: &Server, changes: HashMap<Url, Vec<TextEdit>>) -> WorkspaceEdit {
    if !server.client.versioned_edits {
        return WorkspaceEdit { changes: Some(changes), ..WorkspaceEdit::default() };
    }
    let mut changes: Vec<_> = changes.into_iter().collect();
    changes.sort_by(|a, b| a.0.cmp(&b.0));
    let of_text = |(uri, edits): (Url, Vec<TextEdit>)| {
        let version = server.workspace.documents.get(&name_of(&uri)).map(|document| document.version);
        let text_document = OptionalVersionedTextDocumentIdentifier {
            version,
            text_document_identifier: TextDocumentIdentifier { uri },
        };
        let edits = edits.into_iter().map(Edit::from).collect();
        DocumentChange::from(TextDocumentEdit { text_document, edits })
    };
    let document_changes = Some(changes.into_iter().map(of_text).collect());
    WorkspaceEdit { document_changes, ..WorkspaceEdit::default() }
}

fn symbols(server: &mut Server, params: DocumentSymbolParams) -> Answered<Option<DocumentSymbolResponse>> {
    let found = look_up(server, &params.text_document.uri);
    Ok(found.map(|(spec, file)| outline::symbols(&spec, file).into()))
}

fn folds(server: &mut Server, params: FoldingRangeParams) -> Answered<Option<Vec<FoldingRange>>> {
    let found = look_up(server, &params.text_document.uri);
    Ok(found.map(|(spec, file)| outline::folds(spec.source(file))))
}

fn semantic_tokens(server: &mut Server, params: SemanticTokensParams) -> Answered<Option<SemanticTokens>> {
    let found = look_up(server, &params.text_document.uri);
    Ok(found.map(|(spec, file)| SemanticTokens { result_id: None, data: tokens::tokens(&spec, file) }))
}

fn code_actions(server: &mut Server, params: CodeActionParams) -> Answered<Option<Vec<CodeActionResponse>>> {
    let wanted = params.context.only.as_ref();
    if wanted.is_some_and(|only| !only.iter().any(|k| matches!(k, CodeActionKind::QuickFix | CodeActionKind::Empty))) {
        return Ok(None);
    }
    let name = name_of(&params.text_document.uri);
    let Some((spec, _)) = look_up(server, &params.text_document.uri) else { return Ok(None) };
    let reported = server.reported(&spec);
    let server = &*server;
    let edit = |changes| workspace_edit(server, changes);
    Ok(Some(actions::fixes(&server.workspace, &spec, &name, params.range, &reported, &edit)))
}

fn inlay_hints(server: &mut Server, params: InlayHintParams) -> Answered<Option<Vec<InlayHint>>> {
    let found = look_up(server, &params.text_document.uri);
    Ok(found.map(|(spec, file)| hints::hints(&spec, file, params.range)))
}

fn formatted(server: &mut Server, params: DocumentFormattingParams) -> Answered<Option<Vec<TextEdit>>> {
    let found = look_up(server, &params.text_document.uri);
    Ok(found.and_then(|(spec, file)| formatting::layout(spec.source(file))))
}
