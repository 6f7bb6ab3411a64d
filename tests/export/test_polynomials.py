"""Singular, PARI/GP and Maxima compute by themselves what the certificates state."""

from __future__ import annotations

import json
import random
import shutil
import subprocess
from pathlib import Path

import pytest

from kowalevski_cas.export import Inexpressible, load
from kowalevski_cas.export.polynomials import UNSAID
from kowalevski_cas.export.polynomials.trace import Element, Traced, Writer
from kowalevski_cas.library import available, find
from kowalevski_cas.problem import checker
from kowalevski_cas.verify.certificate import load_certificates
from tests.problem.tampering import mutants, names_in, places, seal
from tests.sample import sampled

CERTIFICATES = {name: one.data for name, one in load_certificates(find("kharlamov2002")).items()}
HANDWRITTEN = sorted(Path(__file__).parents[1].glob("problem/handwritten/*"))
"""Small certificates of each kind."""


@pytest.fixture(params=["singular", "pari", "maxima"])
def language(request):
    language = load(request.param)
    if shutil.which(language.tool.calls[0][0]) is None:
        pytest.skip(f"{language.tool.title} is not installed")
    return language


@pytest.fixture
def blind(language):
    """Each equation is believed before the program sees it, so that the program has to find out."""
    language.trusting = True


def objection(language, certificate, folder):
    """What the program has against a certificate."""
    text = language.translate(certificate)
    file = folder / f"claim{language.suffix}"
    file.write_text(text, encoding="utf-8")
    done = subprocess.run(
        [*language.tool.call(), *language.arguments(file)],
        cwd=folder, capture_output=True, text=True, stdin=subprocess.DEVNULL,
    )  # fmt: skip
    return language.objection(text, done.stdout + done.stderr)


@pytest.mark.slow
@pytest.mark.parametrize("claim", ["eq14", "eq15", "reality", "equilibria"])
def test_a_certificate_of_the_paper_is_confirmed(language, claim, tmp_path):
    assert objection(language, CERTIFICATES[claim], tmp_path) == ""


def unsaid(data):
    """Why no program for polynomials can say what some goals state."""
    return [UNSAID[goal["goal"]] for goal in data["goals"] if goal["goal"] in UNSAID]


@pytest.mark.slow
@pytest.mark.parametrize("derivation", available())
def test_every_certificate_is_confirmed(language, derivation, tmp_path):
    found = {
        name: objection(language, one.data, tmp_path)
        for name, one in load_certificates(find(derivation)).items()
        if not unsaid(one.data)
    }
    assert found
    assert {claim: words for claim, words in found.items() if words} == {}


@pytest.mark.parametrize("path", sampled(HANDWRITTEN, 1, id=lambda path: path.stem))
def test_evidence_and_denials_of_each_kind_are_confirmed(language, path, tmp_path):
    data = json.loads(path.read_text(encoding="utf-8"))
    if reasons := unsaid(data):
        with pytest.raises(Inexpressible, match=reasons[0]):
            objection(language, data, tmp_path)
    elif path.stem == "denied-dependence":  # a rank above the number of functions: no computation
        assert objection(language, data, tmp_path) == "0 of 0 statements are confirmed"
    else:
        assert objection(language, data, tmp_path) == ""


@pytest.mark.slow
@pytest.mark.parametrize("many", [1, pytest.param(10, marks=pytest.mark.slow)])
def test_a_changed_statement_is_confirmed_only_if_it_is_true(language, blind, many, tmp_path):
    random.seed(1)
    denied = 0
    claims = ("eq7", "reality", "eq16.2", "eq20.1", "M4-independence")[:many]
    for claim in claims:
        data = CERTIFICATES[claim]
        assert objection(language, data, tmp_path) == ""
        names = sorted(names_in(data["spaces"][-1]["variables"]))
        changes = [
            changed
            for path in places(data)
            if path[0] == "goals" and path[2:3] and path[2] not in ("space", "goal")
            for _, changed in mutants(data, path, names)
        ]
        for changed in random.sample(changes, many + 1):
            try:
                words = objection(language, changed, tmp_path)
            except Exception:
                continue  # it is no certificate any more
            denied += bool(words)
            if not words:
                checker.check(seal(changed))
    assert denied > 0.3 * many * len(claims)


@pytest.mark.parametrize("many", [1, pytest.param(12, marks=pytest.mark.slow)])
@pytest.mark.parametrize("place", sampled(["field", "steps"], 1))
def test_a_changed_space_is_confirmed_only_if_the_statement_stays_true(
    language, blind, place, many, tmp_path
):
    random.seed(2)
    data = CERTIFICATES["eq7"]
    names = sorted(names_in(data["spaces"][-1]["variables"]))
    changes = [
        changed
        for path in places(data)
        if path[0] == "spaces" and path[2:3] == (place,)
        for _, changed in mutants(data, path, names)
    ]
    for changed in random.sample(changes, many):
        try:
            words = objection(language, changed, tmp_path)
        except Exception:
            continue
        if not words:
            checker.check(seal(changed))


class TestObjection:
    TEXT = 'ring\nholds("1 inverse", t1, d);\nholds("2 statement", t2, d);\n'

    @pytest.mark.parametrize("name", ["singular", "pari"])
    @pytest.mark.parametrize(
        ("output", "words"),
        [
            ("holds: 1 inverse\nholds: 2 statement\n", ""),
            ("holds: 1 inverse\nfails: 2 statement\n", "fails: 2 statement"),
            ("holds: 1 inverse\n", "1 of 2 statements are confirmed"),
            ("", "0 of 2 statements are confirmed"),
            ("   ? error\nholds: 1 inverse\nholds: 2 statement\n", "? error"),
            ("holds: 1 inverse\nholds: 2 statement\nSegmentation", "3 of 2 statements"),
        ],
    )
    def test_only_statements_in_so_many_words_confirm(self, name, output, words):
        said = load(name).objection(self.TEXT, output)
        assert said.startswith(words) and bool(said) == bool(words)

    @pytest.mark.parametrize("name", ["singular", "pari", "maxima"])
    def test_a_file_that_states_nothing_is_not_confirmed(self, name):
        assert load(name).objection("quit;", "")


def test_what_maxima_repeats_is_no_answer():
    text, asked = TestObjection.TEXT, 'errcatch(batchload("claim.mac"))\n'
    said = "holds: 1 inverse\n"
    assert not load("maxima").objection(text, f"{asked}{said}holds: 2 statement\nquit()\n")
    assert load("maxima").objection(text, f"{asked}{said}incorrect syntax\nquit()\n")
    assert load("maxima").objection(text, f"{asked}{said}fails: 2 statement\nquit()\n")


def test_the_program_is_asked_to_differentiate():
    data = CERTIFICATES["F1-prime"]
    assert "diff(" in load("singular").translate(data)
    assert "deriv(" in load("pari").translate(data)
    assert json.dumps(data)  # it is not changed by the translation


def test_what_is_computed_of_written_elements_is_written():
    """Else the program would be given what the checker has computed."""
    ring = Traced(Writer(load("pari")), checker.Budget(1000))
    for name in ("x", "y"):
        ring.adjoin(name)
    x, y = ring.generator("x"), ring.generator("y")
    for found in (x + y, x - y, x * y, -x, x**2, (x * y).partial("x"), ring.product([])):
        assert isinstance(found, Element)
    assert ring.product([]).text == ring.number(1).text
