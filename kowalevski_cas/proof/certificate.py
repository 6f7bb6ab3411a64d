"""Certificates: written for every claim that is established or refuted, never unread.

Writing checks what it has written: every printed formula has to read back as
itself, the file has to parse to what was meant, and the checker has to accept it.
"""

from __future__ import annotations

import json
from collections.abc import Iterator, Sequence
from copy import deepcopy
from dataclasses import dataclass
from fractions import Fraction
from hashlib import sha256
from typing import Any

from kowalevski_cas.claims import Claim
from kowalevski_cas.claims.bench import Bench
from kowalevski_cas.paper.derivation import Derivation
from kowalevski_cas.notation import NotationError
from kowalevski_cas.proof import checker
from kowalevski_cas.proof.evidence import Evidence
from kowalevski_cas.proof.outcome import Outcome, Verdict
from kowalevski_cas.proof.parts import Parts
from kowalevski_cas.proof.statements import deny, state
from kowalevski_cas.proof.trees import CertificateError, Tree
from kowalevski_cas.proof.verify import Progress, Session
from kowalevski_cas.stage import StageError

DIVISORS = 40
"""How many polynomials a certificate divides by at most."""


@dataclass(frozen=True)
class Written:
    """A certificate as text, or the reason why there is none."""

    claim: str
    text: str = ""
    reason: str = ""

    @property
    def digest(self) -> str:
        """The digest of the certificate; empty if there is none."""
        return str(json.loads(self.text)["digest"]) if self.text else ""


def certificates(
    derivation: Derivation,
    evidence: dict[str, Evidence] | None = None,
    only: Sequence[str] = (),
    progress: Progress = lambda claim, done, total: None,
) -> list[Written]:
    """A certificate for each claim of a derivation, in the order of the paper."""
    session = Session(derivation, ["flint"], False, {} if evidence is None else evidence)
    written = []
    for done, claim in enumerate(derivation.claims):
        before = session.texts
        outcome = session.decide(claim)
        if only and claim.id not in only:
            continue
        progress(claim.id, done, len(derivation.claims))
        benches = [
            Bench("flint", texts, shelf=session.shelf, stages=session.stages)
            for texts in (before, session.texts)
        ]
        try:
            written.append(certificate(claim, outcome, benches[0], benches[1]))
        except (CertificateError, StageError, NotationError, checker.Rejected) as error:
            written.append(Written(claim.id, reason=str(error)))
    return written


def certificate(claim: Claim, outcome: Outcome, bench: Bench, mended: Bench) -> Written:
    """The certificate of one claim, decided on ``bench`` and corrected on ``mended``."""
    parts = Parts(bench)
    parts.mended = mended
    if outcome.verdict.green:
        state(claim, parts)
    elif outcome.verdict is Verdict.REFUTED:
        deny(claim, parts)
        if outcome.correction is not None and outcome.correction.verdict.green:
            parts.bench = mended
            state(claim, parts)
    else:
        raise CertificateError(f"the claim is {outcome.verdict}")
    notes = tuple(dict.fromkeys(parts.notes))
    text = dump(claim.id, outcome.digest, *_complete(parts), notes)
    read = json.loads(text)
    if read["claim"] != claim.id or dump(*(read[k] for k in KEYS)) != text:
        raise CertificateError("the certificate does not read back as it was written")
    checker.check(text)
    return Written(claim.id, text)


def stated(claim: Claim, bench: Bench) -> str:
    """What the certificate of a claim would be: nobody has asked whether the claim holds.

    Raises:
        CertificateError: there are no certificates for it.
    """
    parts = Parts(bench)
    state(claim, parts)
    return dump(claim.id, "", *_complete(parts), parts.notes)


KEYS = ("claim", "statement", "spaces", "parts", "notes")


def dump(
    claim: str, statement: str, spaces: list[Tree], parts: list[Tree], notes: Sequence[str]
) -> str:
    """The text of a certificate, an item a line, with its digest.

    The ``notes`` say what it leaves to an argument in words.
    """
    data: dict[str, Any] = {
        "format": checker.FORMAT,
        "version": checker.VERSION,
        "claim": claim,
        "statement": statement,
        "spaces": spaces,
        "parts": parts,
        "notes": list(notes),
    }
    canonical = json.dumps({**data, "digest": ""}, sort_keys=True)
    digest = sha256(canonical.encode()).hexdigest()
    lines = [f'"{key}": {_shown(item)}' for key, item in {**data, "digest": digest}.items()]
    return "{\n" + ",\n".join(lines) + "\n}\n"


def _shown(item: Any) -> str:
    """A value as JSON; the entries of spaces and parts stand on lines of their own."""
    if isinstance(item, list) and item:
        return "[\n " + ",\n ".join(_shown(entry) for entry in item) + "\n]"
    if isinstance(item, dict):
        entries = (f'"{key}": {_line(value)}' for key, value in item.items())
        return "{" + ",\n  ".join(entries) + "}"
    return _line(item)


def _line(value: Any) -> str:
    return json.dumps(value, separators=(",", ":"))


def _complete(parts: Parts) -> tuple[list[Tree], list[Tree]]:
    """The spaces and parts, with the divisors that the checker asks for, and points."""
    for writer in reversed(parts.spaces):
        writer.close()
        if writer.relations:
            stated = {"space": writer.index, "shows": "follows", "equations": writer.relations}
            parts.parts.append(stated)
    spaces = _divided(parts)
    finished = []
    for part in parts.parts:
        ready = {key: value() if callable(value) else value for key, value in part.items()}
        finished.append(ready)
    return spaces, finished


def _divided(parts: Parts) -> list[Tree]:
    """The spaces, after what is divided by has been entered in them."""
    for _ in range(DIVISORS):
        data = [writer.data() for writer in parts.spaces]
        made: list[checker.Space] = []
        try:
            for space in deepcopy(data):
                made.append(checker.Space(made, **space))
            for part in parts.parts:
                _rehearse(made[part["space"]], part)
            return data
        except checker.Rejected as error:
            if len(error.args) < 2:
                raise CertificateError(f"the checker says: {error}") from None
            divisor = error.args[1]
            places = [k for k, space in enumerate(made) if space is divisor.space]
            parts.spaces[places[0] if places else len(made)].nonzero.append(_tree(divisor))
    raise CertificateError("it divides by too much")


def _rehearse(space: checker.Space, part: dict[str, Any]) -> None:
    """Let the checker compute what needs no point."""
    checker.Space.left = checker.WORK
    if part["shows"] == "follows":
        space.differences([*part["equations"], *part.get("given", ())])
        for tree in _proof_trees(part):
            space.scalar(tree)
        return
    trees = [*part.get("levels", ()), *part.get("functions", ())]
    equations = [*part.get("given", ()), *([part["equation"]] if "equation" in part else ())]
    elements = [*map(space.scalar, trees), *space.differences(equations)]
    if part["shows"] == "rank":
        for element in elements:
            for name in space.variables:
                element.along({name: space.number(1)})


def _proof_trees(proof: dict[str, Any]) -> Iterator[Tree]:
    """The trees of a proof, with those of its cases."""
    for row in (*proof.get("cofactors", ()), *proof.get("product", ())):
        yield from row
    for case in proof.get("cases", ()):
        yield from _proof_trees(case)


def _tree(divisor: checker.Element) -> Tree:
    """A polynomial of the checker as a tree, without a factor that is a number."""
    space, terms = divisor.space, sorted(divisor.terms.items(), reverse=True)
    lead = terms[0][1]
    summands: list[Tree] = []
    for monomial, value in terms:
        powers = ((n, monomial >> s & checker.MASK) for n, s in space.at.items())
        factors: list[Tree] = [n if e == 1 else ["^", n, e] for n, e in powers if e]
        ratio = Fraction(value, lead) if len(terms) > 1 else Fraction(1)
        top, below = ratio.as_integer_ratio()
        if ratio != 1 or not factors:
            factors.insert(0, top if below == 1 else ["/", top, below])
        summands.append(["*", *factors] if len(factors) > 1 else factors[0])
    return ["+", *summands] if len(summands) > 1 else summands[0]
