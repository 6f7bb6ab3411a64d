"""Read a paper's TeX source and prove or refute each formula in it.

The derivation says what each place of the paper is; the source says what stands
there. If no derivation of the library fits, the source is read as its own: what its formulas are
is inferred, and said with the reason. Nothing in the source is executed; read are the files that
are named, and those that they take from the paper's folder. With --list, the formulas are only
listed.
"""

from __future__ import annotations

import argparse
import json
import sys
from collections.abc import Iterable, Mapping
from dataclasses import asdict
from pathlib import Path
from typing import TypedDict

from kowalevski_cas.algebra import EXACT
from kowalevski_cas.audit.audit import Audit, audit, derivation_of
from kowalevski_cas.audit.audited import OPEN
from kowalevski_cas.audit.reading import ReadingSession, audit_reading, is_read
from kowalevski_cas.audit.referee import FirstReferee
from kowalevski_cas.audit.session import AuditSession
from kowalevski_cas.cli import session
from kowalevski_cas.cli.exits import (
    AS_RECORDED,
    DIFFERENT,
    DISAGREEMENT,
    INTERRUPTED,
    NOTHING,
    UNDECIDED,
    USAGE,
    CommandError,
)
from kowalevski_cas.cli.formats import OF_AUDITS, load_format
from kowalevski_cas.cli.watch import watch
from kowalevski_cas.files import write
from kowalevski_cas.library import available
from kowalevski_cas.limits import interruptible, run_limit
from kowalevski_cas.paper.derivation import Derivation
from kowalevski_cas.reading import CLAIM, read
from kowalevski_cas.reading.choice import Choices
from kowalevski_cas.schema import head
from kowalevski_cas.source.difference import difference
from kowalevski_cas.source.files import COMMENTS, LARGEST, read_source
from kowalevski_cas.source.listing import list_formulas
from kowalevski_cas.source.text import Source
from kowalevski_cas.verify.certificate import Stored, load_certificates
from kowalevski_cas.verify.confirm import need_certificates, received
from kowalevski_cas.verify.outcome import Outcome, Verdict
from kowalevski_cas.verify.outcome_writer import disagreement


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The arguments of the command."""
    parser.add_argument("source", type=Path, metavar="PAPER.tex", help="the source to read")
    parser.add_argument(
        "--derivation",
        metavar="NAME",
        help="name in the library, or folder (if not given, the one that fits best)",
    )
    parser.add_argument(
        "--stdin",
        action="store_true",
        help="read the text of PAPER.tex from standard input, as an editor has it",
    )
    parser.add_argument(
        "--macros",
        type=Path,
        action="append",
        default=[],
        metavar="STYLE.sty",
        help="a file of macros that the source uses; may be given several times",
    )
    parser.add_argument(
        "--alone",
        action="store_true",
        help="read the source as its own derivation, even if one of the library fits it",
    )
    parser.add_argument(
        "--strict",
        action="store_true",
        help="end with 3 if any formula is not read or not judged, not only what claims something",
    )
    parser.add_argument(
        "--list", action="store_true", help="only list the formulas, and whether they can be read"
    )
    session.add_format(parser, OF_AUDITS, "formula")
    parser.add_argument(
        "--patch",
        action="store_true",
        help="print a unified diff that mends every misprint, instead of the results",
    )
    parser.add_argument(
        "--draft",
        action="store_true",
        help="print all that is inferred as comments, to be corrected: as a diff of the source",
    )
    parser.add_argument(
        "--beside", action="store_true", help="with --draft: as the file PAPER.kc beside the source"
    )
    parser.add_argument(
        "--report",
        type=Path,
        metavar="DIR",
        help="write the paper there as a page, with its verdict beside each formula",
    )
    parser.add_argument(
        "--arithmetic",
        choices=(*EXACT, "all"),
        default="flint",
        help="decide in this arithmetic, or in all three (flint)",
    )
    session.add_timeout(parser, 5)
    session.add_limit(parser)
    parser.add_argument(
        "--watch",
        action="store_true",
        help="do it again whenever the source changes; only what has changed is decided anew",
    )


def run(arguments: argparse.Namespace) -> int:
    """Run the command and return its exit code."""
    if not arguments.watch:
        return _run(arguments, {}, None)[0]
    if arguments.stdin:
        raise CommandError("what comes from standard input does not change: --watch needs the file")
    certificates: dict[str, Stored] = {}
    choices: Choices = {}
    return watch(lambda: _run(arguments, certificates, choices))


def _run(
    arguments: argparse.Namespace, certificates: dict[str, Stored], choices: Choices | None
) -> tuple[int, Iterable[Path]]:
    """The exit code, and the files that are read.

    Evidence is taken from certificates, and kept, and so are choices of what formulas claim.
    """
    data = sys.stdin.buffer.read(LARGEST) if arguments.stdin else None
    source = read_source(arguments.source, arguments.macros, data)
    files = [*map(Path, source.files), arguments.source.with_suffix(COMMENTS)]
    with run_limit(arguments.limit):
        return _audited(arguments, source, certificates, choices), files


def _audited(
    arguments: argparse.Namespace,
    source: Source,
    certificates: dict[str, Stored],
    choices: Choices | None,
) -> int:
    if arguments.list:
        return _list(source, arguments.format)
    if arguments.draft:
        said, code = _draft(source, arguments.beside)
        _write(said, source)
        return code
    alone = arguments.alone and arguments.derivation is None
    known = None if alone else fitting_derivation(source, arguments.derivation)
    if known is None:
        with interruptible() as was_interrupted:
            found = _read(source, arguments, certificates, choices)
            outcomes, said, note, code = _render(arguments, found)
        if was_interrupted():
            note = "\n".join(filter(None, (note, "interrupted: the rest is not decided")))
            code = INTERRUPTED
        texts = {name: text for outcome in outcomes for name, text in outcome.certificates.items()}
        certificates |= {n: Stored(Path(n), json.loads(t)) for n, t in texts.items() if t}
    else:
        derivation = known

        def rendered(source: Source) -> tuple[list[Outcome], str, str, int]:
            return _render(arguments, audit(source, audit_run(*derivation, arguments)))

        ((outcomes, said, note, code),) = session.map_in_processes(received(rendered), [source])
        for outcome in outcomes:
            need_certificates(outcome)
    if arguments.patch:
        _write(said, source)
    else:
        print(said, end="")
    if note:
        print(note, file=sys.stderr)
    return code


def _write(text: str, source: Source) -> None:
    """Print text of a source, in its encoding."""
    sys.stdout.flush()
    sys.stdout.buffer.write(text.encode(source.encoding, "replace"))


def _draft(source: Source, apart: bool) -> tuple[str, int]:
    """All that is inferred of a source as comments, and the exit code."""
    from kowalevski_cas.reading.draft import beside, draft

    found = read(source)
    said = beside(found) if apart else difference(source, draft(found))
    return said, AS_RECORDED if found.formulas else NOTHING


def _render(arguments: argparse.Namespace, found: Audit) -> tuple[list[Outcome], str, str, int]:
    """The outcomes of an audit, what is to be printed and noted, and the exit code."""
    outcomes, code = [*found.outcomes.values()], exit_code(found, arguments.strict)
    notes = [outcome.note for outcome in outcomes if outcome.note]
    notes += [_write_page(found, arguments.report)] if arguments.report is not None else []
    note = "\n".join(notes)
    if arguments.patch:
        from kowalevski_cas.audit.patch import patch

        return outcomes, patch(found), note, code
    return outcomes, load_format(arguments.format).audited(found), note, code


def _read(
    source: Source,
    arguments: argparse.Namespace,
    certificates: Mapping[str, Stored],
    choices: Choices | None,
) -> Audit:
    """The audit of a source as its own derivation; processes share the work."""
    settings = _Settings(
        arithmetics=arithmetics(arguments.arithmetic),
        explain=arguments.report is not None,
        timeout=arguments.timeout,
        certificates=certificates,
    )
    with session.progress_bar() as heard:

        def told(place: int) -> None:
            heard.say(f"{source.path}:{source.line(place)}: this does not hold as it is read")

        reading = read(source, heard, FirstReferee(told, **settings), choices)
        return audit_reading(ReadingSession(reading, heard=heard, **settings))


class _Settings(TypedDict):
    """How claims are decided."""

    arithmetics: tuple[str, ...]
    explain: bool
    timeout: float
    certificates: Mapping[str, Stored]


def _write_page(found: Audit, folder: Path) -> str:
    """Write the page of an audit; where it is."""
    from kowalevski_cas.report.annotated import annotate
    from kowalevski_cas.report.html import render_html

    page = folder / f"{Path(found.source.path).stem}.html"
    write(page, render_html(annotate(found)))
    return f"{page} is written"


def fitting_derivation(source: Source, name: str | None) -> tuple[Path, Derivation] | None:
    """The derivation that is named, or the one of the library that fits a source, if one does."""
    if name is not None:
        return session.derivations([name])[0]
    candidates = session.derivations(available())
    found = derivation_of(source, [derivation for _, derivation in candidates])
    return next((pair for pair in candidates if pair[1] is found), None)


def choose(source: Source, name: str | None) -> tuple[Path, Derivation]:
    """The derivation that is named, or the one of the library that fits a source."""
    found = fitting_derivation(source, name)
    if found is None:
        said = "no derivation of the library fits this source; name one with --derivation"
        raise CommandError(f"{source.path}: {said}", NOTHING)
    return found


def arithmetics(name: str) -> tuple[str, ...]:
    """The arithmetics that are asked for."""
    return EXACT if name == "all" else (name,)


def audit_run(folder: Path, derivation: Derivation, arguments: argparse.Namespace) -> AuditSession:
    """The run of a derivation with which sources are compared."""
    stored, record = load_certificates(folder), session.readable_record(folder)
    explain, timeout = arguments.report is not None, arguments.timeout
    return AuditSession(
        derivation, arithmetics(arguments.arithmetic), explain, stored, timeout, record=record
    )


def exit_code(found: Audit, strict: bool = False) -> int:
    """The exit code that an audit asks for."""
    outcomes = found.outcomes.values()
    verdicts = {outcome.verdict for outcome in outcomes}
    if any(disagreement(outcome.verdicts) for outcome in outcomes):
        return DISAGREEMENT
    if all(formula.line == 0 for formula in found.formulas):
        return NOTHING
    if any(formula.wrong for formula in found.formulas) or Verdict.REFUTED in verdicts:
        return DIFFERENT
    if found.reading is not None:
        return _of_reading(found, strict)
    if Verdict.ERROR in verdicts:
        return USAGE
    return UNDECIDED if verdicts & {Verdict.UNDECIDED, Verdict.TIMEOUT} else AS_RECORDED


def _of_reading(found: Audit, strict: bool) -> int:
    """The exit code of a source that is its own derivation, in which nothing is refuted."""
    if not is_read(found):
        return NOTHING
    verdicts = {outcome.verdict for outcome in found.outcomes.values()}
    unsettled = [f for f in found.formulas if f.verdict == OPEN and (strict or f.role == CLAIM)]
    settled = verdicts and all(v.green for v in verdicts) and not (unsettled or found.uncovered)
    return AS_RECORDED if settled else UNDECIDED


def _list(source: Source, format: str) -> int:
    """Print the formulas of a source, and whether they can be read."""
    found, notes = list_formulas(source)
    if format == "json":
        value = {
            **head("listing"),
            "formulas": [asdict(formula) for formula in found],
            "notes": [{"line": line, "words": words} for line, words in notes],
            "files": [*source.files],
        }
        print(json.dumps(value, indent=2, ensure_ascii=False))
        return AS_RECORDED if found else NOTHING
    for formula in found:
        state = formula.trouble or f"{formula.statements} read"
        kind = "inline" if formula.inline else formula.kind
        tex = " ".join(formula.tex.split())
        tex = tex if len(tex) <= 60 else f"{tex[:59]}…"
        print(f"{formula.line:>5}  {kind:<10} {formula.label:<12} {tex:<60}  {state}")
    for line, words in notes:
        print(f"{line:>5}  {words}")
    print(f"read: {', '.join(source.files)}")
    readable = sum(1 for formula in found if not formula.trouble)
    print(f"{len(found)} formulas, {readable} can be read")
    return AS_RECORDED if found else NOTHING
