"""A language server: what an audit says of a paper, at its formulas, while it is typed.

The audit runs in a process of its own on the text as the editor has it, when nobody has typed for
a moment. Lines and columns of an audit are those of Unicode; the editor says in which it counts.
"""

from __future__ import annotations

import asyncio
import os
import re
from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from typing import Any, NamedTuple

from lsprotocol import types as lsp
from pygls import uris
from pygls.lsp.server import LanguageServer
from pygls.workspace import TextDocument

from kowalevski_cas import __version__
from kowalevski_cas.servers.commands import run_command
from kowalevski_cas.servers.hover import explain, rests_on, verdict_line

PAUSE = 0.4
"""Seconds without a key after which a paper is audited."""

NAME = "kowalevski-cas"

LEVELS = {
    "error": lsp.DiagnosticSeverity.Error,
    "warning": lsp.DiagnosticSeverity.Warning,
    "note": lsp.DiagnosticSeverity.Information,
}

Json = Mapping[str, Any]

Place = tuple[int, int]
"""A line and a column, counted from 1, in code points."""


class AuditedText(NamedTuple):
    """A version of a paper's text, and what an audit says of it."""

    version: int | None
    document: Json

    def formulas_in(self, path: str, start: Place, end: Place) -> list[Json]:
        """The formulas of a file that have a part of an interval."""
        every = [
            formula
            for formula in self.document["formulas"]
            if formula["file"] == path and formula["column"]
        ]
        return [formula for formula in every if _begin(formula) <= end and start <= _end(formula)]

    def formula_at(self, path: str, place: Place) -> Json | None:
        """The innermost formula at a place."""
        return max(self.formulas_in(path, place, place), key=_begin, default=None)


class AuditServer(LanguageServer):
    """A language server that knows the last audit of each paper that is open."""

    def __init__(self) -> None:
        super().__init__(NAME, __version__)
        self.audits: dict[str, AuditedText] = {}
        self._tasks: dict[str, asyncio.Task[None]] = {}
        self._published: dict[str, set[str]] = defaultdict(set)

    def audit_soon(self, uri: str) -> None:
        """Audit a paper after a pause, and not what it was before."""
        self.forget(uri)
        self._tasks[uri] = asyncio.create_task(self._audit(uri))

    def forget(self, uri: str) -> None:
        """End what is done for a paper."""
        self.audits.pop(uri, None)
        if (task := self._tasks.pop(uri, None)) is not None:
            task.cancel()

    async def _audit(self, uri: str) -> None:
        await asyncio.sleep(PAUSE)
        text = self.workspace.get_text_document(uri)
        version = text.version
        try:
            answer = await run_command(
                "audit", text.path, "--stdin", "--format", "json", text=text.source
            )
            document, message = answer.document, answer.errors
        except TimeoutError:
            document, message = None, "the audit takes too long"
        if document is None:
            self._publish(uri, {uri: [_failure(message)]}, version)
            return
        self.audits[uri] = AuditedText(version, document)
        found = defaultdict[str, list[lsp.Diagnostic]](list)
        for diagnostic in document["diagnostics"]:
            found[self._uri(uri, diagnostic["file"])].append(self._diagnostic(uri, diagnostic))
        self._publish(uri, found, version)

    def _publish(
        self, uri: str, found: Mapping[str, list[lsp.Diagnostic]], version: int | None
    ) -> None:
        """Show diagnostics of a paper, also in the files that it reads, and no others."""
        for file in {uri, *found, *self._published[uri]}:
            self.text_document_publish_diagnostics(
                lsp.PublishDiagnosticsParams(
                    file, found.get(file, []), version if file == uri else None
                )
            )
        self._published[uri] = {*found}

    def _uri(self, uri: str, path: str) -> str:
        """The name that the editor has for a file of a paper."""
        paper = self.workspace.get_text_document(uri)
        return uri if path == paper.path else uris.from_fs_path(path) or uri

    def _diagnostic(self, uri: str, diagnostic: Json) -> lsp.Diagnostic:
        return lsp.Diagnostic(
            self.range(uri, diagnostic),
            diagnostic["message"],
            LEVELS[diagnostic["level"]],
            diagnostic["rule"],
            source=NAME,
        )

    def range(self, uri: str, region: Json) -> lsp.Range:
        """A region as the editor counts; a whole line, if it has no columns."""
        text = self.workspace.get_text_document(self._uri(uri, region["file"]))
        first = (region["line"] or 1) - 1
        if not region["column"]:
            end = lsp.Position(first + 1, 0)
            return lsp.Range(lsp.Position(first, 0), end)
        last = lsp.Position(region["end_line"] - 1, region["end_column"] - 1)
        interval = lsp.Range(lsp.Position(first, region["column"] - 1), last)
        return text.position_codec.range_to_client_units(text.lines, interval)

    def edit(self, uri: str, fixes: Sequence[Json]) -> lsp.WorkspaceEdit:
        """What replaces regions, of the paper or of a file that it reads."""
        changes = defaultdict[str, list[lsp.TextEdit]](list)
        for fix in fixes:
            changes[self._uri(uri, fix["file"])].append(
                lsp.TextEdit(self.range(uri, fix), fix["text"])
            )
        return lsp.WorkspaceEdit(changes)

    def fixes(
        self, uri: str, audit: AuditedText, chosen: Sequence[Json]
    ) -> Iterator[lsp.CodeAction]:
        """The corrections of formulas, and the comments that say what is inferred of them."""
        ids = {diagnostic["id"] for diagnostic in chosen}
        for diagnostic in audit.document["diagnostics"]:
            if diagnostic["id"] in ids and diagnostic["fixes"]:
                shown = self._diagnostic(uri, diagnostic)
                edit = self.edit(uri, diagnostic["fixes"])
                title = f"Correct {diagnostic['id']}"
                yield lsp.CodeAction(
                    title, lsp.CodeActionKind.QuickFix, [shown], is_preferred=True, edit=edit
                )
        for diagnostic in audit.document["comments"]:
            if diagnostic["id"] in ids | {id.rpartition(".")[0] for id in ids}:
                words = diagnostic["text"].strip(" %\n")
                title = f"Say how it is meant: {words}"
                edit = self.edit(uri, [diagnostic])
                yield lsp.CodeAction(title, lsp.CodeActionKind.QuickFix, edit=edit)


def _place(text: TextDocument, position: lsp.Position) -> Place:
    """Where a position of the editor is."""
    place = text.position_codec.position_from_client_units(text.lines, position)
    return place.line + 1, place.character + 1


def _begin(region: Json) -> Place:
    return region["line"], region["column"]


def _end(region: Json) -> Place:
    return region["end_line"], region["end_column"]


def _failure(message: str) -> lsp.Diagnostic:
    """Why a paper could not be audited, at the line that the message names."""
    named = re.search(r":(\d+): ", message)
    line = int(named[1]) - 1 if named else 0
    place = lsp.Range(lsp.Position(line, 0), lsp.Position(line + 1, 0))
    return lsp.Diagnostic(place, message, lsp.DiagnosticSeverity.Error, "error", source=NAME)


server = AuditServer()


@server.feature(lsp.TEXT_DOCUMENT_DID_OPEN)
def opened(ls: AuditServer, params: lsp.DidOpenTextDocumentParams) -> None:
    """Audit a paper that is opened."""
    ls.audit_soon(params.text_document.uri)


@server.feature(lsp.TEXT_DOCUMENT_DID_CHANGE)
def changed(ls: AuditServer, params: lsp.DidChangeTextDocumentParams) -> None:
    """Audit a paper that is typed."""
    ls.audit_soon(params.text_document.uri)


@server.feature(lsp.TEXT_DOCUMENT_DID_CLOSE)
def closed(ls: AuditServer, params: lsp.DidCloseTextDocumentParams) -> None:
    """Say nothing more of a paper that is closed."""
    ls.forget(params.text_document.uri)
    ls._publish(params.text_document.uri, {}, None)


def _at(
    ls: AuditServer, params: lsp.HoverParams | lsp.ReferenceParams
) -> tuple[TextDocument, AuditedText, Json] | None:
    """The paper, its audit and the formula at a place, if what is there has been audited."""
    text = ls.workspace.get_text_document(params.text_document.uri)
    audit = ls.audits.get(text.uri)
    if audit is None:
        return None
    formula = audit.formula_at(text.path, _place(text, params.position))
    return None if formula is None else (text, audit, formula)


@server.feature(lsp.TEXT_DOCUMENT_HOVER)
def hover(ls: AuditServer, params: lsp.HoverParams) -> lsp.Hover | None:
    """The verdict on a formula, the point where it fails, and what it rests on."""
    if (found := _at(ls, params)) is None:
        return None
    text, audit, formula = found
    words = lsp.MarkupContent(lsp.MarkupKind.Markdown, explain(audit.document, formula))
    return lsp.Hover(words, ls.range(text.uri, formula))


@server.feature(lsp.TEXT_DOCUMENT_REFERENCES)
def references(ls: AuditServer, params: lsp.ReferenceParams) -> list[lsp.Location] | None:
    """The formulas that rest on one."""
    if (found := _at(ls, params)) is None:
        return None
    text, audit, formula = found
    above = [
        dependent for dependent in rests_on(audit.document, formula["id"]) if dependent["line"]
    ]
    return [
        lsp.Location(ls._uri(text.uri, dependent["file"]), ls.range(text.uri, dependent))
        for dependent in above
    ]


@server.feature(lsp.TEXT_DOCUMENT_DOCUMENT_SYMBOL)
def symbols(ls: AuditServer, params: lsp.DocumentSymbolParams) -> list[lsp.DocumentSymbol]:
    """The formulas of a paper, each with its verdict."""
    text = ls.workspace.get_text_document(params.text_document.uri)
    audit = ls.audits.get(text.uri)
    found = []
    for formula in audit.document["formulas"] if audit is not None else ():
        if formula["file"] == text.path and formula["line"]:
            place = ls.range(text.uri, formula)
            line = verdict_line(formula)
            kind = lsp.SymbolKind.Number
            found.append(lsp.DocumentSymbol(formula["id"], kind, place, place, detail=line))
    return found


@server.feature(lsp.TEXT_DOCUMENT_CODE_ACTION, lsp.CodeActionOptions([lsp.CodeActionKind.QuickFix]))
def code_actions(ls: AuditServer, params: lsp.CodeActionParams) -> list[lsp.CodeAction]:
    """What mends the formulas of an interval, or says how they are meant."""
    text = ls.workspace.get_text_document(params.text_document.uri)
    audit = ls.audits.get(text.uri)
    if audit is None:
        return []
    interval = _place(text, params.range.start), _place(text, params.range.end)
    chosen = audit.formulas_in(text.path, *interval)
    return [*ls.fixes(text.uri, audit, chosen)]


def serve() -> None:
    """Serve an editor on standard input and output, until it ends."""
    with suppress(KeyboardInterrupt), open(os.dup(1), "wb") as output:  # it is closed there
        server.start_io(stdout=output)
