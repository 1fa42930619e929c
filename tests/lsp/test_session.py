"""A session at an editor, with a client that others wrote: pytest-lsp's.

The tests of what the server answers are in Rust (tests/it/lsp), with a client of our own that speaks in memory. This
session shows what that client cannot, because it shares our reading of the protocol: a client that knows only the
specification starts the program, frames its messages over pipes, decodes every message by the protocol's own types
(lsprotocol), and declares the capabilities of Visual Studio Code.
"""

import os
import pathlib

import pytest_lsp
from lsprotocol import types
from pytest_lsp import ClientServerConfig, LanguageClient, client_capabilities, make_test_lsp_client

LIBRARY = """\
vehicle quad {
    layout  = "PPNNPPNN"
    arm     = 25 cm
    mass    = 1.6 kg
    inertia = [0.014, 0.014, 0.026] kg*m^2
    rotor { max_thrust = 9 N; torque_per_thrust = 16 mm; max_speed = 8500 rpm }
}

faults { every 1 rotor lost as M { rate = 1e-4 1/h } }

let top = 8 m
"""

ROOT = """\
use "library.mav"

mission survey {
    start at [0, 0, 2] m
    waypoint mast at [12 m, 3 m, top]
}

plan {
    against = [M1]
    time = 20 s
}
"""


def editor() -> LanguageClient:
    """pytest-lsp's client, which watches files when it is asked to, as editors do."""
    client = make_test_lsp_client()
    client.watched = []

    @client.feature(types.CLIENT_REGISTER_CAPABILITY)
    def register(params: types.RegistrationParams) -> None:
        client.watched += [registration.method for registration in params.registrations]

    return client


@pytest_lsp.fixture(config=ClientServerConfig(server_command=[os.environ["MAVC"], "lsp"], client_factory=editor))
async def client(lsp_client: LanguageClient, tmp_path: pathlib.Path):
    await lsp_client.initialize_session(
        types.InitializeParams(
            capabilities=client_capabilities("visual-studio-code"),
            workspace_folders=[types.WorkspaceFolder(uri=tmp_path.as_uri(), name="specs")],
        )
    )
    yield
    await lsp_client.shutdown_session()


def place(part: str) -> types.Position:
    """Where `part` begins in the root."""
    before = ROOT[: ROOT.index(part)]
    return types.Position(line=before.count("\n"), character=len(before.rsplit("\n", 1)[-1]))


async def test_a_session(client: LanguageClient, tmp_path: pathlib.Path):
    (tmp_path / "library.mav").write_text(LIBRARY)
    (tmp_path / "root.mav").write_text(ROOT)
    uri = (tmp_path / "root.mav").as_uri()
    text = types.TextDocumentIdentifier(uri=uri)
    client.text_document_did_open(
        types.DidOpenTextDocumentParams(types.TextDocumentItem(uri=uri, language_id="mav", version=1, text=ROOT))
    )

    async def codes(*expected: str) -> None:
        """Waits until the diagnostics are these."""
        while uri not in client.diagnostics or [d.code for d in client.diagnostics[uri]] != list(expected):
            await client.wait_for_notification(types.TEXT_DOCUMENT_PUBLISH_DIAGNOSTICS)

    await codes()

    # Every request once: the client decodes the answers, and none is empty.
    whole = types.Range(start=types.Position(0, 0), end=types.Position(99, 0))
    top, mode = place("top]"), place("M1]")
    for answer in [
        await client.text_document_hover_async(types.HoverParams(text, mode)),
        await client.text_document_completion_async(types.CompletionParams(text, mode)),
        await client.text_document_definition_async(types.DefinitionParams(text, top)),
        await client.text_document_references_async(types.ReferenceParams(types.ReferenceContext(True), text, top)),
        await client.text_document_document_highlight_async(types.DocumentHighlightParams(text, top)),
        await client.text_document_prepare_rename_async(types.PrepareRenameParams(text, top)),
        await client.text_document_document_symbol_async(types.DocumentSymbolParams(text)),
        await client.text_document_folding_range_async(types.FoldingRangeParams(text)),
        (await client.text_document_semantic_tokens_full_async(types.SemanticTokensParams(text))).data,
        await client.text_document_inlay_hint_async(types.InlayHintParams(text, whole)),
        await client.text_document_formatting_async(
            types.DocumentFormattingParams(text, types.FormattingOptions(tab_size=4, insert_spaces=True))
        ),
    ]:
        assert answer

    # The client takes document changes, so each file's edits name the version of the text they are for.
    edit = await client.text_document_rename_async(types.RenameParams(text, top, "summit"))
    versions = {change.text_document.uri: change.text_document.version for change in edit.document_changes}
    assert versions == {uri: 1, (tmp_path / "library.mav").as_uri(): None}

    # An edit of a range, what it breaks, and the fix.
    start = place("20 s")
    unit = types.Range(
        start=types.Position(start.line, start.character + 2), end=types.Position(start.line, start.character + 4)
    )
    client.text_document_did_change(
        types.DidChangeTextDocumentParams(
            types.VersionedTextDocumentIdentifier(uri=uri, version=2),
            [types.TextDocumentContentChangePartial(range=unit, text="")],
        )
    )
    await codes("mavc::unit::missing")
    told = client.diagnostics[uri]
    context = types.CodeActionContext(diagnostics=told)
    assert await client.text_document_code_action_async(types.CodeActionParams(text, told[0].range, context))

    # The client was asked to watch files.
    assert client.watched == ["workspace/didChangeWatchedFiles"]
