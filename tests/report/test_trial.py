"""Counterexamples to try: the page and the checker say the same at every point."""

from __future__ import annotations

import json
from fractions import Fraction
from pathlib import Path
from random import Random
from typing import Any

import pytest

from kowalevski_cas.library import available, find, load
from kowalevski_cas.notation import Vocabulary
from kowalevski_cas.problem import checker
from kowalevski_cas.report.document import Document, Trial
from kowalevski_cas.report.html import render_html
from kowalevski_cas.report.latex import render_latex
from kowalevski_cas.report.trial import trial_of
from kowalevski_cas.report.typst import render_typst
from kowalevski_cas.verify.certificate import FOLDER
from kowalevski_cas.verify.outcome import Correction, Counterexample, Outcome, PrintedPoint, Verdict
from tests.report.browser import PROGRAM, Browser

HANDWRITTEN = Path(__file__).parents[1] / "problem" / "handwritten"
POINTS = 200
WORDS = Vocabulary(scalars=frozenset({"x", "y", "z", "c"}))


def outcome(claim: str, text: str, corrected: str = "") -> Outcome:
    """A refuted claim with its certificate, and that of its correction."""
    against = Counterexample(PrintedPoint({}), "", "")
    mended = Correction((), "", Verdict.PROVED, certificate=corrected) if corrected else None
    return Outcome(
        claim, "1", "", (), "", "", Verdict.REFUTED, counterexample=against, correction=mended,
        certificate=text,
    )  # fmt: skip


def denials() -> list[tuple[str, Trial, str]]:
    """The derivation, the trial and the certificate of each refuted claim that is committed."""
    found = []
    for name in available():
        files = find(name) / FOLDER
        texts = None
        for path in sorted(files.glob("*.json")):
            text = path.read_text(encoding="utf-8")
            if json.loads(text)["sign"] != "denied":
                continue
            texts = texts or load(name).texts()
            mended = files / "corrected" / path.name
            corrected = mended.read_text(encoding="utf-8") if mended.exists() else ""
            trial = trial_of(outcome(path.stem, text, corrected), texts.vocabulary)
            assert trial is not None, path.stem
            found.append((name, trial, text))
    return found


def page(*trials: Trial) -> Document:
    return Document("Trials", "Trials", (), trials)


def accepts(text: str, values: dict[str, Any], roots: list[int]) -> bool:
    """Whether the checker takes the point for one where the statement fails."""
    data = json.loads(text)
    [evidence] = data["evidence"]
    evidence["point"] = {"roots": roots, "values": [[n, v] for n, v in sorted(values.items())]}
    try:
        checker.check(json.dumps(data))
    except checker.Rejected:
        return False
    return True


def number(random: Random, complex_too: bool, root: int) -> tuple[Any, str]:
    """A number as a tree and as it is typed."""
    top, below = random.randint(-5, 5), random.choice([1, 1, 2, 3])
    real, typed = (
        ["/", top, below] if top >= 0 else ["-", ["/", -top, below]],
        f"{Fraction(top, below)}",
    )
    kind = random.random()
    if complex_too and kind < 0.6:
        imaginary = random.choice([1, 2, -1, -3])
        part = ["*", abs(imaginary), "i"]
        sign = "+" if imaginary > 0 else "-"
        return [
            "+",
            real,
            part if imaginary > 0 else ["-", part],
        ], f"{typed}{sign}{abs(imaginary)}i"
    if root and kind < 0.3:
        return ["+", real, ["sqrt", root]], f"{typed}+√{root}"
    return real, typed


def conjugated(tree: Any, typed: str) -> tuple[Any, str]:
    """The conjugate of a number that :func:`number` made."""
    if "i" not in typed:
        return tree, typed
    at = max(typed.rfind("+"), typed.rfind("-"))
    _, real, part = tree
    turned = part[1] if part[0] == "-" else ["-", part]
    return ["+", real, turned], typed[:at] + ("-" if typed[at] == "+" else "+") + typed[at + 1 :]


SET = """(([k, values]) => {
  const form = document.querySelectorAll('form.trial')[k];
  form.querySelector('button').click();
  const part = form.querySelector('fieldset:not([hidden])');
  for (const box of part.querySelectorAll('input'))
    if (box.name in values) box.value = values[box.name];
  form.dispatchEvent(new Event('input'));
  return [part.querySelector('output').className,
          part.querySelectorAll('.broken li:not([hidden])').length,
          part.querySelector('output').textContent];
})(%s)"""
SWITCH = """(k => { const form = document.querySelectorAll('form.trial')[k];
  const choice = form.querySelectorAll('input[type=radio]')[1];
  choice.click();
  const part = form.querySelector('fieldset:not([hidden])');
  return [part.querySelector('output').className, part.querySelector('.broken').hidden]; })(%s)"""


@pytest.mark.slow
@pytest.mark.skipif(PROGRAM is None, reason="there is no Chromium")
def test_the_page_and_the_checker_agree(tmp_path: Path) -> None:
    """At seeded points, most of them in the hypotheses and some outside."""
    found = denials()
    for name in ("denied-identity", "denied-given"):
        text = (HANDWRITTEN / f"{name}.json").read_text(encoding="utf-8")
        if (trial := trial_of(outcome(name, text), WORDS)) is not None:
            found.append((name, trial, text))
    file = tmp_path / "page.html"
    file.write_text(render_html(page(*(trial for _, trial, _ in found))), encoding="utf-8")
    random = Random(20)
    seen = {"refuted": 0, "proved": 0, "": 0}
    with Browser(tmp_path / "user") as browser:
        browser.show(file)
        for _ in range(POINTS):
            k = random.randrange(len(found))
            name, trial, text = found[k]
            first = trial.versions[0]
            steps = json.loads(first.steps)
            point = json.loads(text)["evidence"][0]["point"]
            values = dict(point["values"])
            partner = {a: b for pair in steps["pairs"] for a, b in (pair, pair[::-1])}
            typed: dict[str, str] = {}
            for box in random.sample([n for n, _ in first.names], min(2, len(first.names))):
                tree, shown = number(random, box in partner, 7)
                values[box], typed[box] = tree, shown
                if box in partner and random.random() < 0.9:
                    values[partner[box]], typed[partner[box]] = conjugated(tree, shown)
            roots = sorted({*point["roots"], *([7] if "√7" in str(typed) else [])})
            browser_says, broken, words = browser.value(SET % json.dumps([k, typed]))
            assert browser_says in seen and "Type numbers" not in words, (name, typed, words)
            assert (browser_says == "") == bool(broken), (name, typed, words)
            assert (browser_says == "refuted") == accepts(text, values, roots), (name, typed, words)
            seen[browser_says] += 1
        assert seen["refuted"] > 40 and seen[""] > 20
        for k, (name, trial, _) in enumerate(found):
            assert browser.value(SET % json.dumps([k, {}]))[0] == "refuted", name
            if len(trial.versions) > 1:
                assert browser.value(SWITCH % k) == ["proved", True], name


@pytest.mark.slow
def test_every_refuted_formula_can_be_tried() -> None:
    found = denials()
    assert len(found) >= 9
    for name, trial, _ in found:
        assert trial.versions[0].steps, name


@pytest.mark.slow
def test_every_correction_that_is_certified_can_be_switched_to() -> None:
    certified = [p for name in available() for p in (find(name) / FOLDER / "corrected").glob("*")]
    assert len(certified) == sum(len(trial.versions) == 2 for _, trial, _ in denials()) >= 9


def test_a_trial_is_part_of_the_page_and_not_of_paper() -> None:
    text = (HANDWRITTEN / "denied-identity.json").read_text(encoding="utf-8")
    trial = trial_of(outcome("circle", text), WORDS)
    assert trial is not None
    written = render_html(page(trial))
    assert "<form" in written and written.count("<script>") == 1
    assert "<script" not in render_html(page())
    for render in (render_latex, render_typst):
        assert render(page(trial)) == render(page())


@pytest.mark.parametrize("name", ["denied-rank", "denied-count", "denied-fails", "denied-kernel"])
def test_what_compares_no_two_sides_is_not_tried(name: str) -> None:
    text = (HANDWRITTEN / f"{name}.json").read_text(encoding="utf-8")
    assert trial_of(outcome(name, text), WORDS) is None


TYPE = """(([name, value]) => {
  const part = document.querySelector('form.trial fieldset:not([hidden])');
  const box = [...part.querySelectorAll('input')].find(one => one.name === name);
  box.value = value;
  box.dispatchEvent(new Event('input', {bubbles: true}));
  const roots = [...part.querySelectorAll('input')].filter(one => one.name.startsWith('\\\\sqrt'));
  return [part.querySelector('output').className,
          part.querySelectorAll('.broken li:not([hidden])').length,
          roots.length > 0 && roots.every(one => one.closest('label').hidden)];
})(%s)"""


@pytest.mark.slow
@pytest.mark.skipif(PROGRAM is None, reason="there is no Chromium")
def test_roots_follow_the_numbers_below_them(tmp_path: Path) -> None:
    """Nobody types them; where one has no real value, the page says so and judges nothing."""
    text = (find("leroy2020") / FOLDER / "article-i.json").read_text(encoding="utf-8")
    trial = trial_of(outcome("article-i", text), load("leroy2020").texts().vocabulary)
    assert trial is not None
    file = tmp_path / "page.html"
    file.write_text(render_html(page(trial)), encoding="utf-8")
    with Browser(tmp_path / "user") as browser:
        browser.show(file)
        assert browser.value(TYPE % json.dumps(["I_3", "4"])) == ["refuted", 0, True]
        said, broken, _ = browser.value(TYPE % json.dumps(["I_3", "1/2"]))
        assert said == "" and broken
