"""What the LaTeX report says: everything that the run says, always in the same bytes."""

import re
import subprocess
import sys
from dataclasses import replace

import pytest

from kowalevski_cas.report import render_latex
from kowalevski_cas.report.context import report
from kowalevski_cas.report.latex import LatexWriter
from kowalevski_cas.verify.outcome import Outcome, Verdict
from tests.report.fixtures import P, R, claim, condition, correction, counterexample, point, run

WRITER = LatexWriter(report(run()))


@pytest.fixture(scope="module")
def text() -> str:
    return render_latex(run())


def test_same_bytes_from_run_to_run(text: str) -> None:
    code = (
        "import sys; from tests.report.fixtures import run; "
        "from kowalevski_cas.report import render_latex; "
        "sys.stdout.buffer.write(render_latex(run()).encode())"
    )
    for seed in ("1", "2"):
        again = subprocess.run(
            [sys.executable, "-c", code],
            capture_output=True,
            check=True,
            env={"PYTHONHASHSEED": seed, "PATH": "", "PYTHONPATH": ":".join(sys.path)},
        )
        assert again.stdout.decode() == text


def test_measured_time_is_not_in_it(text: str) -> None:
    slow = replace(
        run(), outcomes=tuple(replace(o, seconds={"flint": 9.75}) for o in run().outcomes)
    )
    assert render_latex(slow) == text


def test_every_claim_with_its_verdict(text: str) -> None:
    for outcome in run().outcomes:
        name, verdict = outcome.claim, outcome.verdict.value
        alone = rf"\Claim{{{name}}}{{{name}}}{{{verdict}}}"
        row = rf"\Place{{claim.{name}}}{{\texttt{{{name}}}}} & \Word{{{verdict}}}"
        assert (alone in text) != (row in text), name


def test_verdicts_have_a_sign_and_a_word(text: str) -> None:
    for verdict in Verdict:
        assert rf"\csname sign.{verdict.value}\endcsname" in text
        assert rf"\Verdict{{{verdict.value}}}" in text


def test_errata_are_complete(text: str) -> None:
    errata = text.partition(r"\section{Errata}")[2].partition(r"\section{")[0]
    for outcome in run().outcomes:
        link = rf"\hyperlink{{claim.{outcome.claim}}}"
        if outcome.verdict is R:
            assert link in errata
            assert outcome.counterexample is not None
            assert WRITER.value(outcome.counterexample.left).lstrip("$") in errata
    assert text.count("A minus sign is missing") == 1  # and once in small letters under the claim


def test_an_unmended_refutation_is_an_erratum_too() -> None:
    lonely = claim("wrong", "1", "1=2", "", R, counterexample=counterexample(point({}), "1", "2"))
    text = render_latex(run(lonely))
    assert "No true statement was found near it." in text
    assert "The left side is $1$, the right side $2$." in text


def test_conditions_and_where_they_fail(text: str) -> None:
    assert r"Holds where $a^2 - b^2 \ne 0$: the two fields are of different strength" in text
    assert r"\emph{Where it fails.} At $\alpha_1 = \beta_2 = 1$, the other variables $0$," in text
    provisos = text.partition("Conditions that are not stated")[2]
    assert r"$x_1x_2 \ne 0$" in provisos


def test_rows_of_a_display_stand_together(text: str) -> None:
    assert r"\Group{eq10}Derived from (3), (5) and (9)" in text
    assert text.count("The change of variables carries the equations of motion to:") == 1
    assert text.count("$x_1 = x_2 = w_3 = 1$") == 1 + 4  # under the display, and in the errata


@pytest.mark.parametrize(
    ("plain", "tex"),
    [
        ("100% of_the {special} #1 & \\ ~ ^", r"100\% of\_the \{special\} \#1 \& \textbackslash{} \textasciitilde{} \textasciicircum{}"),
        ("where $x_1 \\ne 0$, a_b", r"where $x_1 \ne 0$, a\_b"),
        ("costs 5$", r"costs 5\$"),
        ('the "proof"', "the ``proof''"),
        ("ω₁² ≠ β", r"$\omega _1^2$ $\ne $ $\beta $"),
        ("Ж", "[U+0416]"),
        ("a\x00b", "ab"),
    ],
)  # fmt: skip
def test_words_are_escaped(plain: str, tex: str) -> None:
    assert WRITER.words(plain) == tex


def test_small_parts() -> None:
    assert WRITER.sentence("a factor is missing") == "A factor is missing."
    assert WRITER.sentence("the derivative is", ":") == "The derivative is:"
    assert WRITER.thousands(1234567) == r"1\,234\,567"
    at = point({"x_1": "1", "y_1": "1", "z_1": "0"})
    assert WRITER.point(at) == "At $x_1 = y_1 = 1$, $z_1 = 0$, "
    assert WRITER.point(point({})) == ""


@pytest.mark.parametrize(
    ("outcomes", "sentences"),
    [
        ([claim("a", "1", "x=x", "", P)], ("The one statement is proved as printed.", "The verdict was reached by each of FLINT, SymEngine and SymPy on its own, without a disagreement.")),
        (
            [claim("a", "1", "x=x", "", P), claim("b", "1", "x=x", "", P)],
            ("All 2 formulas and statements are proved as printed.", "Every verdict was reached by each of FLINT, SymEngine and SymPy on its own, without a disagreement."),
        ),
        (
            [claim("a", "1", "x=x", "", P), claim("b", "1", "x=y", "", R, correction=correction("x=x", "", P))],
            ("Of 2 formulas and statements, 1 is proved as printed and 1 is refuted by an exact point.", "For the refuted one the nearest true statement was found and proved; every verdict was reached by each of FLINT, SymEngine and SymPy on its own, without a disagreement."),
        ),
        (
            [claim("a", "1", "x=x", "", R), claim("b", "1", "x=y", "", Verdict.TIMEOUT, verdicts={"flint": P, "sympy": R})],
            ("Of 2 formulas and statements, 0 are proved as printed, 1 is refuted by an exact point and 1 is left undecided.", "For none of the 1 refuted the nearest true statement was found and proved; the arithmetics disagree about b."),
        ),
    ],
)  # fmt: skip
def test_the_verdict_in_two_sentences(outcomes: list[Outcome], sentences: tuple[str, str]) -> None:
    assert report(run(*outcomes)).verdict == sentences


def test_table_counts_add_up() -> None:
    arranged = report(run())
    for verdict in Verdict:
        assert sum(s.counts[verdict] for s in arranged.sections) == arranged.counts[verdict]
    assert sum(s.total for s in arranged.sections) == len(run().outcomes)


def test_a_section_that_was_not_announced_is_not_lost() -> None:
    assert "stray" in render_latex(run(claim("stray", "9", "x=x", "", P)))


def test_repeated_conditions_are_said_once() -> None:
    once = condition("x", "it is a denominator")
    rows = [
        claim(f"eq1.{k}", "1", "x=x", "", Verdict.CONDITIONAL, conditions=(once,))
        for k in (1, 2, 3)
    ]
    body = render_latex(run(*rows)).partition(r"\section{1.")[2].partition("Conditions that")[0]
    assert body.count(r"Holds where $x \ne 0$") == 1


def test_no_paragraph_ends_between_the_rows_of_a_table(text: str) -> None:
    tables = re.findall(r"\\begin\{(longtable|tabular)\}(.*?)\\end\{\1\}", text, re.DOTALL)
    assert len(tables) > 5
    assert not [body for _, body in tables if "\n\n" in body]


def test_nothing_of_jinja_is_left(text: str) -> None:
    assert not re.search(r"\(\(\*|\*\)\)|\(\(=|=\)\)|\bUndefined\b|\bNone\b", text)


def test_importing_the_package_loads_no_library() -> None:
    code = (
        "import sys, kowalevski_cas.report; "
        "print({'jinja2', 'typst', 'sympy', 'flint'} & set(sys.modules) or '')"
    )
    out = subprocess.run([sys.executable, "-c", code], capture_output=True, check=True, text=True)
    assert out.stdout.strip() == ""
