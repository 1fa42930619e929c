"""A session at an editor: a spec is opened, broken, mended, renamed in and formatted.

The client is pytest-lsp's, which checks every message against the protocol's own types.
"""

import os
import pathlib

import pytest
import pytest_lsp
from lsprotocol import types
from pytest_lsp import ClientServerConfig, LanguageClient, client_capabilities, make_test_lsp_client

MAVC = os.environ["MAVC"]

LIBRARY = """\
/// A quadcopter that carries a camera.
vehicle quad {
    layout  = "PPNNPPNN"
    arm     = 25 cm
    mass    = 1.6 kg
    inertia = [0.014, 0.014, 0.026] kg*m^2
    rotor {
        max_thrust        = 9 N
        torque_per_thrust = 16 mm
        max_speed         = 8500 rpm
    }
}

faults {
    every 1 rotor lost as M { rate = 1e-4 1/h }
}

let top = 8 m
"""

ROOT = """\
use "library.mav"

mission survey {
    start at [0, 0, 2] m
    waypoint mast at [12 m, 3 m, top]
    limits { tilt <= 20 deg }
}

plan {
    against = [M1]
    time = 20 s
}
"""


@pytest.fixture
def folder(tmp_path: pathlib.Path) -> pathlib.Path:
    (tmp_path / "library.mav").write_text(LIBRARY)
    (tmp_path / "root.mav").write_text(ROOT)
    return tmp_path


def editor() -> LanguageClient:
    """pytest-lsp's client, which watches files when it is asked to, as editors do."""
    client = make_test_lsp_client()
    client.watched = []

    @client.feature(types.CLIENT_REGISTER_CAPABILITY)
    def register(params: types.RegistrationParams) -> None:
        client.watched += [registration.method for registration in params.registrations]

    return client


@pytest_lsp.fixture(config=ClientServerConfig(server_command=[MAVC, "lsp"], client_factory=editor))
async def client(lsp_client: LanguageClient, tmp_path: pathlib.Path):
    await lsp_client.initialize_session(
        types.InitializeParams(
            capabilities=client_capabilities("visual-studio-code"),
            workspace_folders=[types.WorkspaceFolder(uri=tmp_path.as_uri(), name="specs")],
        )
    )
    yield
    await lsp_client.shutdown_session()


class Document:
    """A text as the editor shows it."""

    def __init__(self, client: LanguageClient, path: pathlib.Path):
        self.client, self.uri, self.version, self.text = client, path.as_uri(), 1, path.read_text()
        item = types.TextDocumentItem(uri=self.uri, language_id="mav", version=1, text=self.text)
        client.text_document_did_open(types.DidOpenTextDocumentParams(text_document=item))

    @property
    def identifier(self) -> types.TextDocumentIdentifier:
        return types.TextDocumentIdentifier(uri=self.uri)

    def position(self, part: str) -> types.Position:
        """Where `part` begins, as the protocol counts."""
        before = self.text[: self.text.index(part)]
        line = before.rsplit("\n", 1)[-1]
        return types.Position(line=before.count("\n"), character=len(line.encode("utf-16-le")) // 2)

    def type(self, old: str, new: str) -> None:
        """Puts `new` in place of `old`, as an edit of its range."""
        start = self.position(old)
        end = types.Position(line=start.line, character=start.character + len(old))
        self.text = self.text.replace(old, new, 1)
        self.version += 1
        self.client.text_document_did_change(
            types.DidChangeTextDocumentParams(
                text_document=types.VersionedTextDocumentIdentifier(uri=self.uri, version=self.version),
                content_changes=[
                    types.TextDocumentContentChangePartial(range=types.Range(start=start, end=end), text=new)
                ],
            )
        )

    def apply(self, edits) -> str:
        """The text with the edits of the protocol made."""
        lines = self.text.split("\n")

        def offset(at: types.Position) -> int:
            return sum(len(line) + 1 for line in lines[: at.line]) + at.character

        text = self.text
        for edit in sorted(edits, key=lambda e: offset(e.range.start), reverse=True):
            text = text[: offset(edit.range.start)] + edit.new_text + text[offset(edit.range.end) :]
        return text

    async def codes(self, *expected: str) -> None:
        """Waits until the diagnostics are these."""
        while sorted(d.code for d in self.client.diagnostics.get(self.uri, [])) != sorted(expected):
            await self.client.wait_for_notification(types.TEXT_DOCUMENT_PUBLISH_DIAGNOSTICS)


async def test_a_session(client: LanguageClient, folder: pathlib.Path):
    root = Document(client, folder / "root.mav")
    await root.codes()

    # Broken: a unit is gone, and a name misspelt.
    root.type("20 s", "20")
    root.type("M1", "M9")
    await root.codes("mavc::unit::missing", "mavc::name::unknown")

    # Mended, the unit by its quick fix.
    told = next(d for d in client.diagnostics[root.uri] if d.code == "mavc::unit::missing")
    assert told.severity == types.DiagnosticSeverity.Error
    actions = await client.text_document_code_action_async(
        types.CodeActionParams(
            text_document=root.identifier,
            range=told.range,
            context=types.CodeActionContext(diagnostics=[told]),
        )
    )
    assert [action.title for action in actions] == ["Write `20 s`"]
    assert "time = 20 s" in root.apply(actions[0].edit.document_changes[0].edits)
    root.type("time = 20", "time = 20 s")
    root.type("M9", "M1")
    await root.codes()

    # Asked about: a value, a mode's verdict, what may stand in `against`.
    async def hover(part: str) -> str:
        params = types.HoverParams(text_document=root.identifier, position=root.position(part))
        return (await client.text_document_hover_async(params)).contents.value

    assert "0.349066 rad" in await hover("tilt")
    assert "controllable" in await hover("M1")
    items = await client.text_document_completion_async(
        types.CompletionParams(text_document=root.identifier, position=root.position("M1"))
    )
    assert "M8" in {item.label for item in items}

    # Renamed, in the file that declares it too.
    edit = await client.text_document_rename_async(
        types.RenameParams(text_document=root.identifier, position=root.position("top]"), new_name="summit")
    )
    library = (folder / "library.mav").as_uri()
    # The client takes document changes, so each file's edits name the version of the text they are for.
    changes = {change.text_document.uri: change for change in edit.document_changes}
    assert set(changes) == {root.uri, library}
    assert changes[root.uri].text_document.version is not None and changes[library].text_document.version is None
    assert "[12 m, 3 m, summit]" in root.apply(changes[root.uri].edits)
    place = await client.text_document_definition_async(
        types.DefinitionParams(text_document=root.identifier, position=root.position("top]"))
    )
    assert place.uri == library
    with pytest.raises(Exception, match="is not a name"):
        await client.text_document_rename_async(
            types.RenameParams(text_document=root.identifier, position=root.position("top]"), new_name="8 m")
        )


    # Formatted: the plan's signs of equality stand below each other, and formatting again changes nothing.
    async def format_text():
        options = types.FormattingOptions(tab_size=4, insert_spaces=True)
        params = types.DocumentFormattingParams(text_document=root.identifier, options=options)
        return await client.text_document_formatting_async(params)

    edits = await format_text()
    assert "    against = [M1]\n    time    = 20 s\n" in root.apply(edits)
    assert len(edits) == 1 and edits[0].range.start.line > 8
    root.type("time = 20 s", "time    = 20 s")
    await root.codes()
    assert len(await format_text()) == 0
    root.type("20 s", "20 s)")
    assert await format_text() is None


async def test_what_is_shown_beside_the_text(client: LanguageClient, folder: pathlib.Path):
    library = Document(client, folder / "library.mav")
    symbols = await client.text_document_document_symbol_async(
        types.DocumentSymbolParams(text_document=library.identifier)
    )
    assert [symbol.name for symbol in symbols] == ["quad", "faults", "top"]
    folds = await client.text_document_folding_range_async(types.FoldingRangeParams(text_document=library.identifier))
    assert (folds[0].start_line, folds[0].end_line) == (1, 10)
    tokens = await client.text_document_semantic_tokens_full_async(
        types.SemanticTokensParams(text_document=library.identifier)
    )
    assert len(tokens.data) % 5 == 0 and len(tokens.data) > 200
    whole = types.Range(start=types.Position(0, 0), end=types.Position(99, 0))
    hints = await client.text_document_inlay_hint_async(
        types.InlayHintParams(text_document=library.identifier, range=whole)
    )
    assert "8 modes: M1 ... M8" in [hint.label for hint in hints]


async def test_files_that_change_on_disk_are_noticed(client: LanguageClient, folder: pathlib.Path):
    root = Document(client, folder / "root.mav")
    await root.codes()
    library = folder / "library.mav"
    library.write_text(LIBRARY.replace("let top = 8 m\n", ""))
    event = types.FileEvent(uri=library.as_uri(), type=types.FileChangeType.Changed)
    client.workspace_did_change_watched_files(types.DidChangeWatchedFilesParams(changes=[event]))
    await root.codes("mavc::name::unknown")
    assert client.watched == ["workspace/didChangeWatchedFiles"]
