"""What a text claims is noticed by a verdict, or it is listed that none covers it."""

import json
import random
import re

import pytest

from kowalevski_cas.audit.audit import Audit, audit
from kowalevski_cas.cli import main
from kowalevski_cas.reading.uncovered import Uncovered
from kowalevski_cas.source.formulas import typed_formulas
from kowalevski_cas.source.text import Source
from kowalevski_cas.source.tokens import tokens_of
from tests.audit.material import audited, base, paper_path, source, watched
from tests.sample import sampled

SEED, SIZE = 2002, 44

CHANGES = [
    ("there is no linear integral", "there is a linear integral"),
    ("there exists only four such points", "there exists only five such points"),
    ("two-parametric family", "three-parametric family"),
    ("which is the same", "which is not the same"),
    ("for almost all", "for all"),
    ("on the zero level", "on each level"),
    ("has dimension~4", "has dimension~5"),
    ("is purely imaginary", "is real"),
    ("two independent first", "two dependent first"),
    ("is exactly the set of", "contains the set of"),
    ("three invariant relations", "two invariant relations"),
    ("has dimension 5", "has dimension 4"),
    ("is algebraic", "is transcendental and algebraic"),
    ("are two-dimensional tori", "are three-dimensional tori"),
]
"""Statements of the first paper that are changed."""


def signature(found: Audit) -> dict:
    verdicts = {one.id: (one.verdict, one.message) for one in found.formulas}
    return verdicts | {id: (one.verdict, one.message) for id, one in found.outcomes.items()}


def seen(text: str, at: int, new: str) -> bool:
    """Whether a changed text has another verdict, or lists what has changed."""
    found = audit(Source("paper.tex", text), base())
    line = found.source.line(at)
    listed = [one for one in found.uncovered if abs(one.line - line) < 12]
    words = " ".join(new.split())
    return signature(found) != signature(audited()) or any(words in one.words for one in listed)


@pytest.mark.parametrize(("old", "new"), sampled(CHANGES, 1))
@watched
def test_a_changed_sentence_that_states_something_is_noticed_or_listed(old, new):
    text = source().text
    match = re.search(r"[\s~]+".join(map(re.escape, re.split(r"[\s~]", old))), text)
    if match is None:
        pytest.skip("the source has not these words")
    changed = text[: match.start()] + new + text[match.end() :]
    assert seen(changed, match.start(), new.split("~")[0])


def inline_mutants() -> list[tuple[int, int, str, str]]:
    """One token changed in each of some inline formulas: an interval, what stands there, and not."""
    chance, found = random.Random(SEED), source()
    expanded, formulas = typed_formulas(found)
    sites = []
    for one in formulas:
        tokens = [
            token
            for token in tokens_of(one.tex)
            if token.kind in ("letter", "number", "sign", "relation")
        ]
        if one.inline and len(tokens) > 1:
            sites.append((one, tokens))
    mutants = []
    for one, tokens in chance.sample(sites, min(SIZE, len(sites))):
        token = chance.choice(tokens)
        begin, end = expanded.origin(one.start + token.start, one.start + token.end)
        old = found.text[begin:end]
        others = {"number": "23456789", "sign": "+-", "letter": "xyzuvw", "relation": "<>="}
        new = chance.choice([sign for sign in others[token.kind] if sign != old])
        mutants.append((begin, end, old, f" {new} "))
    return mutants


@pytest.mark.slow
@watched
def test_inline_mutants_are_noticed_or_listed():
    paper_path()
    text = source().text
    missed = [
        (source().line(begin), old, new)
        for begin, end, old, new in inline_mutants()
        if not seen(text[:begin] + new + text[end:], begin, new.strip())
    ]
    assert len(missed) <= SIZE - 40, missed


def test_what_no_verdict_covers_is_listed(tmp_path, capsys):
    path = tmp_path / "paper.tex"
    path.write_text(
        "\\begin{document} Here $$\\dot x=y,\\quad \\dot y=-x.$$ The function $x^2+y^2$ is an integral. "
        "There is no other integral. Is there another integral?\n%kc: skip sentence\nAll motions are periodic.\n"
        "Almost all of them have period $2\\pi$. \\end{document}"
    )
    main(["audit", "--alone", "--format", "json", str(path)])
    listed = json.loads(capsys.readouterr().out)["uncovered"]
    assert [one["kind"].partition(":")[0] for one in listed] == ["one alone", "period"]
    assert [one["words"].split()[0] for one in listed] == ["There", "Almost"]
    main(["audit", "--alone", str(path)])
    assert "What the text claims and no verdict covers" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("words", "read"),
    [
        (r"Only $x^2$ is constant.", "Only $x^2$ is constant."),
        (r"By~\eqref{a} and \ref{b} \emph{all} motions", "By (1) and (b) all motions"),
        (
            r"Since it is real, \begin{equation} x=y, \end{equation} and so on",
            "Since it is real, …",
        ),
        (r"\smallskip Real motions for \[x<1\]", "Real motions for …"),
    ],
)
def test_a_sentence_is_shown_up_to_its_display_without_tex(words, read):
    passage = Uncovered(1, words, "number: “all”")
    assert passage.read(lambda label: {"a": "1"}.get(label, label)) == read
    assert passage.cue == "all"
