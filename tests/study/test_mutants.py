"""Mutants of the paper: what is made, what is noticed, and why something is not."""

from dataclasses import replace
from random import Random

import pytest

from kowalevski_cas import System
from kowalevski_cas.audit.audit import audit
from kowalevski_cas.audit.session import AuditSession
from kowalevski_cas.cli import run
from kowalevski_cas.library import find, load
from kowalevski_cas.paper.derivation import Derivation
from kowalevski_cas.pool import Pool
from study.mutants.catching import Caught, Measure, Measurement, measure
from study.mutants.command import report
from study.mutants.mutant import every, sample
from study.mutants.synthetic import synthetic
from tests.audit.material import NAME, audited, base, source
from tests.cli.test_flags import ODD
from tests.sample import sampled


@pytest.mark.slow
def test_a_sample_is_repeated_by_its_seed():
    one, other = (sample(audited(), 20, Random(7)) for _ in range(2))
    assert [m.words for m in one] == [m.words for m in other]
    assert len({m.text for m in one}) == 20


def test_a_sample_ends_with_the_mutants_that_there_are():
    circle = System(r"\dot x=y, \dot y=-x")
    circle.integral("x^2+y^2")
    derivation = Derivation("circle", "", "", "", (circle.section,))
    small = audit(synthetic(derivation), AuditSession(derivation, ["flint"]))
    found = sample(small, 10**400, Random(7))
    assert {m.text for m in found} <= {m.text for m in every(small)}
    assert len(found) > 10


def test_a_mutant_is_one_token_away():
    for mutant in sample(audited(), 30, Random(8)):
        assert mutant.before != mutant.after
        first = next(
            k for k, (a, b) in enumerate(zip(source().text, mutant.text, strict=False)) if a != b
        )
        assert abs(len(mutant.text) - len(source().text)) < 12
        assert mutant.line == source().line(first) or mutant.text[first] in " \\"


@pytest.mark.slow
def test_mutants_are_caught():
    name = "bobenko_reyman_semenov1989"
    derivation = load(name)
    text = synthetic(derivation)
    mutants = sample(audit(text, AuditSession(derivation, ["flint"])), 1, Random(6))
    found = measure(Measure(find(name), text.path, text.text, timeout=2), mutants)
    assert found.escapes == []
    assert "1 mutants" in report(found)


def test_what_is_not_decided_in_time_is_neither_caught_nor_missed():
    [mutant] = sample(audited(), 1, Random(9))
    survivor = Caught(mutant, "claim", (), False, "", "", late=True, seconds=1.0)
    found = Measurement([survivor, replace(survivor, late=False)])
    assert found.late == [survivor]
    assert found.share() == (0, 1)
    assert f"not in time {mutant.words}" in report(found)


def test_the_derivation_stands_in_for_the_paper():
    found = audit(synthetic(base().interpretation.derivation), base())
    assert {k: o.verdict for k, o in found.outcomes.items()} == {
        k: o.verdict for k, o in base().outcomes.items()
    }


@pytest.mark.slow
def test_a_large_sample_of_mutants_is_caught():
    work = Measure(find(NAME), source().path, source().text, timeout=2)
    found = measure(work, sample(audited(), 300, Random(2002)), Pool(jobs=2))
    assert [result.mutant.words for result in found.escapes] == []
    assert all(result.named for result in found.results if result.is_caught)


def main(arguments):
    return run("python -m study.mutants", "study.mutants.command", arguments)


@pytest.mark.slow
def test_the_command_says_how_many_it_made_and_by_which_seed(tmp_path, capsys):
    path = tmp_path / "paper.tex"
    path.write_text(source().text, encoding="utf-8")
    assert main([str(path), "--sample", "1", "--seed", "1", "--jobs", "1"]) == 0
    out = capsys.readouterr().out
    assert "seed 1" in out
    assert "1 mutants" in out


FLAGS = (("--derivation={}",), ("--jobs={}", "--derivation=x"), ("--seed={}", "--derivation=x"))
USES = ["\0".join(words).format(odd) for words in FLAGS for odd in ODD]


@pytest.mark.parametrize("use", sampled(USES, 3, id=lambda use: use[:60]))
def test_no_flag_gives_a_traceback(use, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    try:
        code = main(use.split("\0"))
    except SystemExit as stopped:
        code = stopped.code
    said = capsys.readouterr()
    assert code in range(7) and "Traceback" not in said.err
    assert said.err
