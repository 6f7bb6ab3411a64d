"""Certificates: a problem, a sign and evidence, as files beside the derivation.

A claim has one certificate; a corrected statement has one more, in a folder below. They are the
store of evidence as well: what a search found once is read from them, and checked in every run.
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from functools import cached_property
from pathlib import Path
from types import MappingProxyType
from typing import Any, NamedTuple

from kowalevski_cas.algebra.tower import Element
from kowalevski_cas.files import read_json
from kowalevski_cas.notation import Formula
from kowalevski_cas.problem.codec import Data, evidence_data, problem_data, read_evidence
from kowalevski_cas.problem.evidence import Denial, Evidence
from kowalevski_cas.problem.examine import Accepted
from kowalevski_cas.problem.finder import finder_of
from kowalevski_cas.problem.goals import Exists, Follows, Goal
from kowalevski_cas.problem.trees import FormatError, Tree, encode
from kowalevski_cas.verify.outcome import CORRECTED
from kowalevski_cas.verify.statement import Posed, Statement, Verdicts

FOLDER = "certificates"
FORMAT, VERSION = "kowalevski-cas certificate", 2


class Supported(NamedTuple):
    """A statement with its evidence, and what was accepted of that."""

    statement: Statement
    verdicts: Verdicts
    accepted: Accepted


class Stored:
    """The certificate of a claim in a file, or other data in its place; not checked yet."""

    def __init__(self, path: Path, instead: Data | None = None) -> None:
        self.path, self.instead = path, instead

    @cached_property
    def beside(self) -> Data:
        """What it has beside a problem and evidence, which are large, and seldom read again."""
        return _heading(self.data)

    @property
    def data(self) -> Data:
        """All that it has, read whenever it is asked for.

        Raises :class:`FormatError` if the file is no JSON of this version.
        """
        if self.instead is not None:
            return self.instead
        try:
            data = read_json(self.path)
        except (OSError, ValueError) as error:
            raise FormatError(f"it cannot be read ({type(error).__name__})") from None
        if not isinstance(data, dict) or data.get("version") != VERSION:
            raise FormatError(f"it is no certificate of format {VERSION}")
        return data

    def concerns(self, statement: Statement) -> bool:
        """Whether it is about a statement, or cannot be read and may be."""
        try:
            return bool(self.beside.get("digest") == statement.digest)
        except FormatError:
            return True

    def verdicts(self, statement: Statement) -> Verdicts | None:
        """Its evidence for a statement; ``None`` if it is about another one.

        Raises :class:`FormatError` if the evidence cannot be read.
        """
        data = self.data
        self.beside = _heading(data)
        if data.get("digest") != statement.digest:
            return None
        try:
            return _verdicts(data, statement)
        except FormatError:
            raise
        except Exception as error:  # nobody trusts what is in a file
            raise FormatError(f"it cannot be read ({type(error).__name__}: {error})") from None

    def failures(self, statement: Statement, condition: Tree) -> list[Stored] | None:
        """What it has of a condition of a statement; ``None`` if it says nothing of conditions."""
        entries = self.beside.get("failures")
        if entries is None or self.beside.get("digest") != statement.digest:
            return None
        if not isinstance(entries, list) or not all(isinstance(entry, dict) for entry in entries):
            raise FormatError("a list of what fails is expected")
        return [
            Stored(self.path, entry) for entry in entries if entry.get("condition") == condition
        ]


def _heading(data: Data) -> Data:
    return {key: data.get(key) for key in ("digest", "failures")}


def _verdicts(data: Data, statement: Statement) -> Verdicts:
    """The evidence for a statement in the data of a certificate."""
    evidence, sign = data.get("evidence"), data.get("sign")
    if sign not in ("holds", "denied"):
        raise FormatError("it neither holds nor is denied")
    if sign == "denied" and isinstance(evidence, list) and evidence:
        entry = dict(evidence[0])
        place = entry.pop("goal", None)
        if not isinstance(place, int) or not 0 <= place < len(statement.goals):
            raise FormatError("it denies no goal")
        return Denial(place, read_evidence(entry, statement.goals[place], False))
    if not isinstance(evidence, list) or len(evidence) != len(statement.goals):
        raise FormatError("there is not evidence for each goal")
    pairs = zip(evidence, statement.goals, strict=True)
    return tuple(read_evidence(entry, goal) for entry, goal in pairs)


def load_certificates(folder: Path) -> dict[str, Stored]:
    """The certificates in a derivation's folder by claim; those of corrections with a slash."""
    certificates = folder / FOLDER
    places = (("", certificates), (f"{CORRECTED}/", certificates / CORRECTED))
    found = ((before + path.stem, path) for before, at in places for path in at.glob("*.json"))
    return {name: Stored(path) for name, path in sorted(found)}


def certificate(
    statement: Statement | Posed,
    verdicts: Verdicts,
    accepted: Accepted,
    failures: Mapping[Formula, Supported | None] = MappingProxyType({}),
) -> str:
    """The text of the certificate of a statement; nobody has checked it.

    ``failures`` are what fails where a condition is violated, or that nothing was found.

    Raises :class:`FormatError` if something has no place in it.
    """
    failing = [
        {
            "condition": encode(condition),
            **_problem_with_evidence(failure.statement, *_evidence(*failure)),
        }
        for condition, failure in failures.items()
        if failure is not None
    ]
    shown = _evidence(statement, verdicts, accepted)
    return certificate_text(statement, *shown, failing if failures else None)


def certificate_text(
    statement: Statement | Posed,
    sign: str,
    evidence: list[Data],
    failures: list[Data] | None = None,
) -> str:
    """The text of a certificate that nobody has checked."""
    head = {"format": FORMAT, "version": VERSION, "claim": statement.name}
    more = {} if failures is None else {"failures": failures}
    return dump({**head, **_problem_with_evidence(statement, sign, evidence), **more})


def _problem_with_evidence(statement: Statement | Posed, sign: str, evidence: list[Data]) -> Data:
    """A problem with a sign and evidence."""
    problem = problem_data(statement.problem)
    return {**problem, "sign": sign, "evidence": evidence, "digest": statement.digest}


def _evidence(
    statement: Statement | Posed, verdicts: Verdicts, accepted: Accepted
) -> tuple[str, list[Data]]:
    """The sign and the evidence for it."""
    away = iter(accepted.away)
    if isinstance(verdicts, Denial):
        goal = statement.goals[verdicts.goal]
        data = _with_away(verdicts.evidence, goal, away)
        return "denied", [{"goal": verdicts.goal, **data}]
    pairs = zip(verdicts, statement.goals, strict=True)
    return "holds", [_with_away(inner, goal, away) for inner, goal in pairs]


def _with_away(evidence: Evidence, goal: Goal, away: Any) -> Data:
    """Evidence with what it divides by, goal by goal."""
    data = evidence_data(evidence)
    if isinstance(goal, Exists) and "evidence" in data:
        for entry, inner in zip(data["evidence"], goal.goals, strict=True):
            _enter(entry, inner.space, next(away))
    elif not isinstance(goal, Exists):
        divided = next(away)
        if not isinstance(goal, Follows) or goal.conclusions:  # else only by what is granted
            _enter(data, goal.space, divided)
    return data


def _enter(data: Data, setting: Any, elements: list[Element]) -> None:
    """Enter what elements divide by, in an order that no other claim has a part in."""
    if found := finder_of(setting).divisor_formulas(elements):
        data["away"] = sorted(map(encode, found), key=json.dumps)


def dump(data: Data) -> str:
    """Data as JSON, an item of a list a line."""
    lines = [f'"{key}": {_json_text(item)}' for key, item in data.items()]
    return "{\n" + ",\n".join(lines) + "\n}\n"


def _json_text(item: Any) -> str:
    if isinstance(item, list) and item and isinstance(item[0], dict):
        return "[\n " + ",\n ".join(_json_text(entry) for entry in item) + "\n]"
    if isinstance(item, dict):
        entries = (f'"{key}": {json.dumps(v, separators=(",", ":"))}' for key, v in item.items())
        return "{" + ",\n  ".join(entries) + "}"
    return json.dumps(item, separators=(",", ":"))
