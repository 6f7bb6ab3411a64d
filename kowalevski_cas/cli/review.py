r"""Audit the papers of a repository: what is false, and was not known to be, fails.

Papers are the files that git knows as *.tex and that have a \documentclass; --since takes those of
them that were changed since a commit, or that read what was. What is known stands in a baseline, by
fingerprints that do not move with the lines.
"""

from __future__ import annotations

import argparse
import asyncio
import json
import sys
from collections import Counter
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, NamedTuple

from kowalevski_cas.cli import session
from kowalevski_cas.cli.exits import (
    AS_RECORDED,
    DIFFERENT,
    NOTHING,
    UNDECIDED,
    USAGE,
    CommandError,
    most_urgent,
)
from kowalevski_cas.cli.formats.diagnostics import from_json
from kowalevski_cas.cli.formats.github import workflow_commands
from kowalevski_cas.cli.formats.sarif import log
from kowalevski_cas.cli.repository import changed_since, papers
from kowalevski_cas.files import write
from kowalevski_cas.report.badge import badge
from kowalevski_cas.schema import head
from kowalevski_cas.servers.commands import CommandAnswer, run_command
from kowalevski_cas.source.text import Region
from kowalevski_cas.verify.diagnostic import ERROR, Diagnostic


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The arguments of the command."""
    parser.add_argument(
        "papers", nargs="*", type=Path, metavar="PAPER.tex", help="all that git knows, if none"
    )
    parser.add_argument(
        "--since", metavar="COMMIT", help="only those that were changed since, or what they read"
    )
    parser.add_argument(
        "--strict",
        action="store_true",
        help="end with 3 if anything is undecided or not judged that was not known to be",
    )
    parser.add_argument("--baseline", type=Path, metavar="FILE", help="what is known")
    parser.add_argument(
        "--update", action="store_true", help="write what is found to the baseline: it is known"
    )
    parser.add_argument(
        "--format", choices=("pretty", "github"), default="pretty", help="how to print results"
    )
    parser.add_argument("--sarif", type=Path, metavar="FILE", help="write them as SARIF as well")
    parser.add_argument("--badge", type=Path, metavar="FILE", help="write a badge, an SVG")
    session.add_timeout(parser, 5)


class Review(NamedTuple):
    """What an audit says of a paper, and what of that was not known."""

    path: Path
    answer: CommandAnswer
    new: Sequence[Diagnostic]
    known: int

    @property
    def counts(self) -> Counter[str]:
        """How many claims have each verdict, in formulas and in words."""
        if self.answer.document is None:
            return Counter()
        return Counter(self.answer.document["summary"]["claims"])

    def exit_code(self, strict: bool) -> int:
        """The exit code that the paper asks for."""
        if self.answer.document is None:
            return USAGE
        if any(diagnostic.level == ERROR for diagnostic in self.new):
            return DIFFERENT
        return UNDECIDED if strict and self.new else AS_RECORDED


def run(arguments: argparse.Namespace) -> int:
    """Run the command and return its exit code."""
    if not (chosen := _chosen(arguments)):
        print(f"no paper has changed since {arguments.since}")
        return AS_RECORDED
    known = set() if arguments.update else _read_baseline(arguments.baseline)
    reviews = [_review(path, arguments.timeout, known) for path in chosen]
    for review in reviews:
        print(_text(review, arguments.format), end="")
    found = [diagnostic for review in reviews for diagnostic in review.new]
    if arguments.sarif is not None:
        write(arguments.sarif, log(found))
    if arguments.badge is not None:
        write(arguments.badge, badge(sum((review.counts for review in reviews), Counter())))
    if arguments.update and all(review.answer.document is not None for review in reviews):
        write(arguments.baseline, _baseline(found))
        return AS_RECORDED
    code = most_urgent(review.exit_code(arguments.strict) for review in reviews)
    if code == AS_RECORDED and not any(review.counts for review in reviews):
        print("no paper claims anything that could be judged", file=sys.stderr)
        return NOTHING
    return code


def _chosen(arguments: argparse.Namespace) -> list[Path]:
    """The papers that are asked for."""
    if arguments.update and arguments.baseline is None:
        raise CommandError("--update writes what --baseline FILE names")
    chosen: list[Path] = arguments.papers or papers()
    if not chosen:
        raise CommandError("git knows no paper here: no *.tex has a \\documentclass", NOTHING)
    return chosen if arguments.since is None else changed_since(arguments.since, chosen)


def _review(path: Path, seconds: float, known: set[tuple[str, str]]) -> Review:
    """The review of a paper; it is audited in a process of its own."""
    words = ("audit", "--format=json", f"--timeout={seconds}", "--", str(path))
    answer = asyncio.run(run_command(*words))
    document = answer.document or {"diagnostics": []}
    found = [from_json(entry) for entry in document["diagnostics"]]
    new = [diagnostic for diagnostic in found if _key(diagnostic) not in known]
    return Review(path, answer, new, len(found) - len(new))


def _text(review: Review, format: str) -> str:
    """What is printed of a paper."""
    if review.answer.document is None:
        said = review.answer.errors.removeprefix("kowalevski-cas audit: ")
        message = said or "the audit did not finish"
        failed = Diagnostic("error", ERROR, "audit", message, Region(str(review.path)))
        return workflow_commands([failed]) if format == "github" else _line(failed)
    counted = ", ".join(f"{n} {verdict}" for verdict, n in sorted(review.counts.items()))
    known = f"; {review.known} known" if review.known else ""
    summary = f"{review.path}: {counted or 'no claims'}{known}\n"
    if format == "github":
        return workflow_commands(review.new) + summary
    return summary + "".join(map(_line, review.new))


def _line(diagnostic: Diagnostic) -> str:
    place = ":".join(str(part) for part in diagnostic.region[:3] if part)
    return f"  {place}: {diagnostic.level}: {diagnostic.id}: {diagnostic.message}\n"


def _key(diagnostic: Diagnostic) -> tuple[str, str]:
    return Path(diagnostic.region.path).as_posix(), diagnostic.fingerprint


def _read_baseline(path: Path | None) -> set[tuple[str, str]]:
    """The files and fingerprints of what is known."""
    if path is None:
        return set()
    try:
        value: Mapping[str, Any] = json.loads(path.read_text(encoding="utf-8"))
        if (value["format"], value["version"]) != tuple(head("baseline").values()):
            raise ValueError("another format or version")
        return {(entry["file"], entry["fingerprint"]) for entry in value["known"]}
    except OSError as error:
        raise CommandError(f"{path}: {error.strerror}; --update writes it") from None
    except (ValueError, TypeError, KeyError) as error:
        raise CommandError(f"{path} is no baseline: {error}; --update writes one") from None


def _baseline(found: Sequence[Diagnostic]) -> str:
    """A baseline in which all that is found is known, in an order that does not change."""
    known = sorted(
        {
            "file": _key(diagnostic)[0],
            "fingerprint": diagnostic.fingerprint,
            "message": diagnostic.message,
        }.items()
        for diagnostic in found
    )
    return json.dumps({**head("baseline"), "known": [*map(dict, known)]}, indent=1) + "\n"
