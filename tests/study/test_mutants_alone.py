"""Mutants of a paper that is its own derivation: what counts as noticed, and what does not."""

from dataclasses import replace
from functools import cache
from random import Random

import pytest

from kowalevski_cas.cli import run
from kowalevski_cas.cli.exits import NOTHING
from kowalevski_cas.verify.outcome import FALSE_AS_READ, Verdict
from study.mutants import alone
from study.mutants.alone import (
    EXCLUDED,
    HARMLESS,
    LOST,
    NOTICED,
    STRANGE,
    Alone,
    Fate,
    Fates,
    draw_mutants,
    fates,
)
from study.mutants.papers import report

PAPER = r"""\documentclass{article}
\begin{document}
The equations of motion are
\begin{equation}\label{law}
\dot x=y,\qquad \dot y=-\omega^2x,
\end{equation}
and the first integral of energy is
\begin{equation}\label{energy}
h=\tfrac12y^2+\tfrac12\omega^2x^2 .
\end{equation}
\end{document}
"""


@cache
def work():
    return Alone("oscillator.tex", PAPER, 5)


def mutant_of(role):
    """A mutant of a formula with this role, and the formula."""
    base = work().base
    for mutant in draw_mutants(work(), 3, Random(3)):
        changed = next(f for f in base.formulas if f.place == mutant.printed)
        if changed.role == role:
            return mutant, changed
    raise AssertionError(role)


def ending(monkeypatch, role, change, count=None):
    """How a mutant ends if the audit of it says what ``change`` makes of the paper's formulas."""
    mutant, changed = mutant_of(role)
    base = work().base
    said = replace(base, formulas=[change(replace(f)) for f in base.formulas][:count])
    monkeypatch.setattr(alone, "_audit", lambda *_: said)
    return work().end(mutant, changed)[0]


def claims(verdict, **more):
    return lambda f: replace(f, verdict=verdict, **more) if f.role == "claim" else f


def test_each_role_has_its_mutants_and_the_sample_is_repeated_by_its_seed():
    one, other = (draw_mutants(work(), 2, Random(5)) for _ in range(2))
    assert [m.words for m in one] == [m.words for m in other]
    roles = {f.place: f.role for f in work().base.formulas}
    assert sorted(roles[m.printed] for m in one) == ["claim", "claim", "law", "law"]


@pytest.mark.slow
def test_mutants_of_law_and_integral_are_noticed():
    found = fates(work(), draw_mutants(work(), 2, Random(5)))
    assert len(found.of(NOTICED, *EXCLUDED)) >= 3 and not found.of(STRANGE)


@pytest.mark.parametrize("role", ["law", "claim"])
def test_a_claim_that_turns_red_notices(monkeypatch, role):
    assert ending(monkeypatch, role, claims(Verdict.REFUTED)) == NOTICED


def test_a_claim_that_turns_yellow_notices_only_what_it_names(monkeypatch):
    assert ending(monkeypatch, "claim", claims(Verdict.UNDECIDED)) == NOTICED
    assert ending(monkeypatch, "law", claims(Verdict.UNDECIDED)) == LOST
    named = mutant_of("law")[1].name
    assert ending(monkeypatch, "law", claims(Verdict.UNDECIDED, causes=(named,))) == NOTICED


def test_the_changed_formula_is_noticed_where_it_is_false_as_it_was_read(monkeypatch):
    place = mutant_of("law")[1].place

    def change(formula):
        if formula.place == place:
            return replace(formula, verdict=Verdict.UNDECIDED, message=FALSE_AS_READ)
        return claims(Verdict.UNDECIDED)(formula)

    assert ending(monkeypatch, "law", change) == NOTICED


def test_a_claim_that_is_no_longer_judged_is_lost(monkeypatch):
    assert ending(monkeypatch, "law", claims("open")) == LOST
    assert ending(monkeypatch, "law", lambda f: f, count=0) == LOST


def test_what_stays_proved_is_harmless(monkeypatch):
    assert ending(monkeypatch, "law", lambda f: f) == HARMLESS


def test_what_is_green_on_a_supposition_that_is_new_is_strange(monkeypatch):
    named = mutant_of("law")[1].name
    assert ending(monkeypatch, "claim", claims(Verdict.PROVED, on=(named,))) == STRANGE


def test_on_what_nothing_green_rests_nothing_can_be_noticed(monkeypatch):
    base = work().base
    dull = replace(base, formulas=[claims("open")(replace(f)) for f in base.formulas])
    monkeypatch.setattr(Alone, "base", dull)
    assert draw_mutants(work(), 3, Random(3)) == []


def test_shares_are_told_role_by_role_and_what_is_strange_by_name():
    mutant = mutant_of("law")[0]
    results = [Fate(mutant, "law", end, "energy") for end in (NOTICED, LOST, STRANGE, HARMLESS)]
    words = report(Fates(results))
    assert "law: 1 of 3 noticed (33 %); 1 harmless" in words
    assert f"strange  law, {mutant.words}: energy" in words


@pytest.mark.slow
def test_papers_are_counted_together_and_the_sample_is_repeated_by_its_seed(tmp_path, capsys):
    path = tmp_path / "oscillator.tex"
    path.write_text(PAPER)
    command = ["study.mutants.papers", [str(path), str(path), "--sample", "1", "--seed", "5"]]
    codes = [run("python -m study.mutants.papers", *command) for _ in range(2)]
    said = capsys.readouterr().out
    assert set(codes) <= {0, 1} and said[: len(said) // 2] * 2 == said
    assert said.count("oscillator:") == 4 and said.count("all, seed 5:") == 2


def test_where_nothing_green_rests_on_anything_there_is_no_share(tmp_path, capsys):
    path = tmp_path / "empty.tex"
    path.write_text(r"\documentclass{article}\begin{document}Nothing.\end{document}")
    assert run("python -m study.mutants.papers", "study.mutants.papers", [str(path)]) == NOTHING
    assert "nothing green" in capsys.readouterr().err
