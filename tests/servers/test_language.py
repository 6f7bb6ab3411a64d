"""An editor and a paper: what is wrong is shown where it stands, and mended from there."""

import asyncio
import json
import subprocess
import sys
from pathlib import Path

import pytest
from lsprotocol import types as lsp
from pygls.lsp.client import LanguageClient

LIMIT = 60
PAPER = r"""\documentclass{article}
\usepackage{STYLE}
\begin{document}
The oscillator 𝔬 moves by
\begin{equation}\label{law}
\dot x=v,\quad \dot v=-x.
\end{equation}
𝔬, 𝔬: the energy $%s$ is a first integral.
\end{document}
"""
RIGHT, WRONG = r"H=\half(v^2+x^2)", r"H=\half(v^2-x^2)"


class Editor:
    """A client that keeps what it is told of each file."""

    def __init__(self, folder: Path):
        (folder / "STYLE.sty").write_text(r"\newcommand{\half}{\frac12}")
        self.path = folder / "paper.tex"
        self.uri, self.version, self.text = self.path.as_uri(), 0, ""
        self.client = LanguageClient("editor", "1")
        self.told = asyncio.Queue()
        self.client.feature(lsp.TEXT_DOCUMENT_PUBLISH_DIAGNOSTICS)(
            lambda told: self.told.put_nowait(told)
        )

    async def __aenter__(self):
        await self.client.start_io(sys.executable, "-m", "kowalevski_cas", "lsp")
        capabilities = lsp.ClientCapabilities()
        await self.client.initialize_async(lsp.InitializeParams(capabilities))
        self.client.initialized(lsp.InitializedParams())
        return self

    async def __aexit__(self, *_):
        await self.client.shutdown_async(None)
        self.client.exit(None)
        await self.client.stop()

    async def open(self, text):
        self.text = text
        document = lsp.TextDocumentItem(self.uri, "latex", self.version, text)
        self.client.text_document_did_open(lsp.DidOpenTextDocumentParams(document))
        return await self.diagnostics()

    async def type(self, text, wait=True):
        self.version, self.text = self.version + 1, text
        document = lsp.VersionedTextDocumentIdentifier(uri=self.uri, version=self.version)
        change = lsp.TextDocumentContentChangeWholeDocument(text)
        self.client.text_document_did_change(lsp.DidChangeTextDocumentParams(document, [change]))
        return await self.diagnostics() if wait else None

    async def diagnostics(self):
        """What is told of the paper as it is now."""
        while True:
            told = await asyncio.wait_for(self.told.get(), LIMIT)
            if told.uri == self.uri:
                assert told.version == self.version
                return [*told.diagnostics]

    @property
    def document(self):
        return lsp.TextDocumentIdentifier(self.uri)

    def place(self, words):
        """Where words stand, in the units of UTF-16."""
        before = self.text[: self.text.index(words)]
        line = before.rpartition("\n")[2]
        return lsp.Position(before.count("\n"), len(line.encode("utf-16-le")) // 2)

    def edited(self, edit):
        """The text after an edit."""
        lines = self.text.splitlines(keepends=True)
        (edits,) = edit.changes.values()
        for one in sorted(edits, key=lambda e: (e.range.start.line, e.range.start.character)):
            assert one.range.start.line == one.range.end.line
            line = lines[one.range.start.line].encode("utf-16-le")
            first, last = 2 * one.range.start.character, 2 * one.range.end.character
            changed = line[:first] + one.new_text.encode("utf-16-le") + line[last:]
            lines[one.range.start.line] = changed.decode("utf-16-le")
        return "".join(lines)

    async def actions(self, place):
        context = lsp.CodeActionContext([])
        params = lsp.CodeActionParams(self.document, lsp.Range(place, place), context)
        return await self.client.text_document_code_action_async(params)


def with_editor(folder, session):
    """Run a session of an editor with the server."""

    async def run():
        async with Editor(folder) as editor:
            await asyncio.wait_for(session(editor), LIMIT)

    asyncio.run(run())


@pytest.mark.slow
def test_a_false_formula_is_shown_explained_and_corrected_and_then_nothing_is_wrong(tmp_path):
    async def session(editor):
        (wrong,) = await editor.open(PAPER % WRONG)
        assert (wrong.code, wrong.severity) == ("refuted", lsp.DiagnosticSeverity.Error)
        assert wrong.range == lsp.Range(editor.place(WRONG), editor.place("$ is a first"))

        place = editor.place("v^2-x")
        hover = await editor.client.text_document_hover_async(
            lsp.HoverParams(editor.document, place)
        )
        assert hover.range == wrong.range
        assert hover.contents.value.startswith("**refuted**: claim")
        assert "Correct: $H = \\frac{1}{2}(v^2 + x^2)$" in hover.contents.value
        assert "It rests on law.1, law.2" in hover.contents.value

        correct, meant = await editor.actions(place)
        assert correct.title.startswith("Correct") and correct.is_preferred
        assert "claim integral" in meant.title
        assert await editor.type(editor.edited(correct.edit)) == []
        assert editor.text == PAPER % RIGHT

    with_editor(tmp_path, session)


@pytest.mark.slow
def test_it_is_said_what_rests_on_a_formula(tmp_path):
    async def session(editor):
        assert await editor.open(PAPER % RIGHT) == []
        context = lsp.ReferenceContext(False)
        (above,) = await editor.client.text_document_references_async(
            lsp.ReferenceParams(context, editor.document, editor.place(r"\dot x"))
        )
        assert above.range.start == editor.place(RIGHT)
        symbols = await editor.client.text_document_document_symbol_async(
            lsp.DocumentSymbolParams(editor.document)
        )
        assert [one.detail for one in symbols][-1] == "claim, proved"

    with_editor(tmp_path, session)


@pytest.mark.slow
def test_a_comment_that_says_how_a_formula_is_meant_changes_no_verdict(tmp_path):
    async def session(editor):
        assert await editor.open(PAPER % RIGHT) == []
        (law,) = await editor.actions(editor.place(r"\dot x"))
        text = editor.edited(law.edit)
        assert "\n%kc: law\n" in text
        assert await editor.type(text) == []

    with_editor(tmp_path, session)


@pytest.mark.slow
@pytest.mark.parametrize(
    "broken",
    ["", "\0" * 100, "{" * 5000, PAPER.split("law}")[0]],
    ids=["empty", "no text", "deep", "cut off"],
)
def test_a_paper_that_is_broken_while_it_is_typed_ends_nothing(tmp_path, broken):
    async def session(editor):
        assert await editor.open(PAPER % RIGHT) == []
        await editor.type(broken)
        (wrong,) = await editor.type(PAPER % WRONG)
        assert wrong.code == "refuted"

    with_editor(tmp_path, session)


@pytest.mark.slow
def test_every_paper_that_is_cut_off_gets_an_answer(tmp_path):
    whole = PAPER % RIGHT

    async def session(editor):
        await editor.open(whole)
        for end in range(0, len(whole), 40):
            for one in await editor.type(whole[:end]):
                assert one.message
            assert (
                await editor.client.text_document_hover_async(
                    lsp.HoverParams(editor.document, lsp.Position(0, 0))
                )
                is None
            )

    with_editor(tmp_path, session)


@pytest.mark.slow
def test_who_types_on_hears_of_the_last_text_only(tmp_path):
    async def session(editor):
        await editor.open(PAPER % WRONG)
        for _ in range(5):
            await editor.type(PAPER % WRONG, wait=False)
        assert await editor.type(PAPER % RIGHT) == []
        assert editor.told.empty()

    with_editor(tmp_path, session)


def test_it_ends_without_a_word_when_the_editor_says_so():
    asked = [
        ("initialize", {"params": {"capabilities": {}}, "id": 1}),
        ("shutdown", {"id": 2}),
        ("exit", {}),
    ]
    texts = [json.dumps({"jsonrpc": "2.0", "method": method} | more) for method, more in asked]
    done = subprocess.run(
        [sys.executable, "-m", "kowalevski_cas", "lsp"], capture_output=True, text=True, timeout=60,
        input="".join(f"Content-Length: {len(text)}\r\n\r\n{text}" for text in texts),
    )  # fmt: skip
    assert (done.returncode, done.stderr) == (0, "")
