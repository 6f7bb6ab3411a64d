"""The first paper, read by itself, beside the derivation that was written of it by hand."""

import json
from dataclasses import replace
from pathlib import Path

from kowalevski_cas.audit.reading import ReadingSession
from kowalevski_cas.library import library, load
from kowalevski_cas.paper.claims import Claim
from kowalevski_cas.reading import read
from kowalevski_cas.source.files import decode, read_source
from kowalevski_cas.source.tokens import words

NAME = "kharlamov2002"
DATA = Path(__file__).parents[1] / "data" / NAME
COMMENTS = DATA / "paper.kc"
PAPERS = Path(__file__).parents[2] / ".." / "shared" / "paper"


def recorded():
    """The verdicts of the derivation, by its claims."""
    record = json.loads((library() / NAME / "record.json").read_text(encoding="utf-8"))
    return {id: entry["verdict"] for id, entry in record["claims"].items()}


def session(comments: Path | None = None, timeout: float = 20):
    """The run of the paper by itself, with comments beside it or without."""
    (path,) = PAPERS.glob("*.txt")
    source = read_source(path)
    if comments is not None:
        source = replace(source, beside=decode(comments.name, comments.read_bytes()))
    return ReadingSession(read(source), timeout=timeout)


def beside_each_other(run):
    """The verdict of the reading for each claim of the derivation; none if it does not make it.

    A claim is the same if it is about the same formula, or else of one kind about the same ones.
    """
    found: dict[object, list[Claim]] = {}
    for one in run.claiming.values():
        for key in _keys(one.claim):
            found.setdefault(key, []).append(one.claim)
    verdicts, used = {}, set()
    for claim in load(NAME).claims:
        same = [one for key in _keys(claim) for one in found.get(key, ()) if one.id not in used]
        alike = [one for one in same if type(one) is type(claim)] or same
        verdicts[claim.id] = run.outcomes[alike[0].id].verdict.value if alike else None
        used |= {one.id for one in alike[:1]}
    return verdicts


def _keys(claim):
    if claim.printed is not None:
        yield _tex(claim.printed)
    else:
        yield type(claim), frozenset(map(_tex, claim.places()))


def _tex(printed):
    return words(printed.tex.rstrip(" .,"))
