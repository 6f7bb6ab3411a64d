"""A run with outcomes of every kind, made of the paper's own formulas."""

from __future__ import annotations

import re
from functools import cache
from hashlib import sha256
from itertools import groupby
from typing import Any

from kowalevski_cas.notation import Edit, Formula, NotationError, Vocabulary, read_display
from kowalevski_cas.paper.texts import Display, Printed
from kowalevski_cas.report.contents import Contents
from kowalevski_cas.report.document import Document
from kowalevski_cas.report.places import ClaimGroup, PaperSection, ReportItem, Row, number_items
from kowalevski_cas.verify.outcome import (
    Condition,
    Correction,
    Counterexample,
    Outcome,
    PrintedPoint,
    ReportedStep,
    Run,
    Verdict,
)
from tests.notation import paper

WORDS = Vocabulary(
    paper.WORDS.scalars | {"x", "m", "n", r"\omega", r"\xi_1", r"\xi_2"},
    paper.WORDS.vectors,
    paper.WORDS.matrices,
    paper.WORDS.functions,
    paper.WORDS.times,
)
P, C, R = Verdict.PROVED, Verdict.CONDITIONAL, Verdict.REFUTED
ALL = ("flint", "symengine", "sympy")


@cache
def read(tex: str) -> tuple[Formula, ...]:
    """The formulas of a source; none where there is nothing that can be read."""
    try:
        return tuple(statement.formula for statement in read_display(tex, WORDS))
    except NotationError:
        return ()


def value(tex: str) -> Formula | str:
    """A value at a point: the formula, or what is no formula as it is."""
    return next(iter(read(tex)), tex)


def condition(tex: str, words: str, witness: Counterexample | None = None) -> Condition:
    (formula,) = read(tex)
    return Condition(formula, words, witness)


def point(values: dict[str, str]) -> PrintedPoint:
    return PrintedPoint({read(name)[0]: value(tex) for name, tex in values.items()})


def counterexample(at: PrintedPoint, left: str, right: str, words: str = "") -> Counterexample:
    return Counterexample(at, value(left), value(right), words)


def step(words: str, tex: str = "") -> ReportedStep:
    return ReportedStep(words, read(tex))


def correction(
    tex: str, words: str, verdict: Verdict, conditions: tuple[Condition, ...] = (), place: str = ""
) -> Correction:
    """A correction; with a ``place``, one of what is printed in the display of this name."""
    if not place:
        return Correction(read(tex), words, verdict, conditions)
    printed = Printed(Display(place, tex, "1"), 1)
    edit = Edit("sign", (1,), read(tex)[0], words, read_display(tex, WORDS)[0], WORDS)
    return Correction(read(tex), words, verdict, conditions, printed=printed, edit=edit)


AWAY_FROM_THETA = condition(
    r"x_1x_2", r"the printed expression has $\sqrt{x_1x_2}$ in a denominator"
)
DEGENERATE = condition(
    "a^2-b^2",
    "the two fields are of different strength, or not orthogonal",
    counterexample(
        point(
            {
                r"\alpha_1": "1",
                r"\beta_2": "1",
                **dict.fromkeys((r"\alpha_2", r"\alpha_3", r"\beta_1", r"\beta_3"), "0"),
            }
        ),
        "5",
        "4",
        "the dimension of the set, and as stated",
    ),
)
ROWS10 = [row.source for row in read_display(paper.DISPLAYS["eq10"], WORDS)]
EQ12, EQ14, EQ21 = (paper.DISPLAYS[name] for name in ("eq12", "eq14", "eq21"))
EQ16 = read_display(paper.DISPLAYS["eq16"], WORDS)[1].source
LONG = r"x_1^2x_2^2\left(\frac{dF_1}{d\tau}\right) = " + " ".join(
    rf"{'+-'[k % 2]} {k + 2}x_1^{k % 4 + 1}x_2^{{{k % 3 + 10}}}w_1\omega_3^2y_{k % 2 + 1}"
    for k in range(60)
)


def claim(
    name: str, section: str, printed: str, words: str, verdict: Verdict, **more: Any
) -> Outcome:
    more.setdefault("scene", "complex" if section == "2" else "body")
    more.setdefault("digest", sha256(name.encode()).hexdigest())
    more.setdefault("verdicts", dict.fromkeys(ALL, verdict))
    return Outcome(
        claim=name,
        section=section,
        formulas=read(printed),
        source=printed,
        words=words,
        verdict=verdict,
        **more,
    )


def outcomes() -> tuple[Outcome, ...]:
    two = ("eq10.1", "eq10.2", "eq10.5", "eq10.6", "eq10.7", "eq10.8", "eq10.9")
    change = step("The change of variables carries the equations of motion to")
    return (
        claim(
            "eq4.1",
            "1",
            r"({\bs \alpha},{\bs \alpha}) = a^2",
            "The geometric integrals are first integrals of (3)",
            P,
            steps=(
                step(
                    "The derivative along the field vanishes identically:",
                    r"2({\bs\alpha}, {\bs \alpha}\times {\bs\omega}) = 0",
                ),
            ),
        ),
        claim(
            "eq4.2",
            "1",
            r"({\bs \beta},{\bs \beta }) = b^2",
            "The geometric integrals are first integrals of (3)",
            P,
        ),
        claim(
            "eq4.3",
            "1",
            r"({\bs \alpha},{\bs \beta}) = c.",
            "The geometric integrals are first integrals of (3)",
            P,
        ),
        claim(
            "energy",
            "1",
            r"H = \frac{1}{2} ({\bf I}{\bs \omega},{\bs \omega}) - ({\bf e}_1, {\bs \alpha}) - ({\bf e}_2, {\bs \beta}).",
            "$H$ is a first integral of (2), (3), for any inertia tensor $\\mathop{\\rm diag}\\nolimits(A_1, A_2, A_3)$ and any constant $e_1$, $e_2$",
            P,
            steps=(
                step(
                    "Along the field, before anything cancels, the derivative is",
                    r"\dot H = ({\bf I}\dot{\bs\omega},{\bs\omega}) - ({\bf e}_1,{\bs\alpha}\times{\bs\omega}) - ({\bf e}_2,{\bs\beta}\times{\bs\omega})",
                ),
                step("All 24 terms cancel."),
            ),
        ),
        claim(
            "eq6",
            "1",
            r"K = J_1^2  + J_2^2 ,",
            "$K$ is a first integral of (3), (5)",
            P,
            rests_on=("eq4.1",),
            steps=(
                step("The program found", r"\dot J_1 = \omega_3J_2,\qquad \dot J_2 = -\omega_3J_1"),
            ),
        ),
        claim(
            "eq7",
            "1",
            r"J_1  = 0,\quad J_2  = 0,",
            "$J_1 = J_2 = 0$ is an invariant set",
            P,
            rests_on=("eq6",),
        ),
        claim(
            "M4-dimension",
            "1",
            "",
            "The invariant relations (7) define a four-dimensional manifold",
            C,
            rests_on=("eq7", "eq4.1", "eq4.2", "eq4.3"),
            conditions=(DEGENERATE,),
        ),
        claim(
            "eq9.i",
            "2",
            "i^2=1",
            "The unit of the change of variables, in the line above (9)",
            R,
            counterexample=counterexample(point({"i": "i"}), "-1", "1"),
            correction=correction("i^2 = -1", "a minus sign is missing", P, place="eq9.i"),
        ),
        claim(
            "eq9",
            "2",
            "",
            "The change of variables is invertible; $x_2$, $y_2$, $z_2$, $w_2$ are the conjugates of $x_1$, $y_1$, $z_1$, $w_1$",
            P,
            rests_on=("eq9.i",),
            steps=(
                step(
                    "The Jacobian determinant is a constant:",
                    r"\frac{\partial x_1}{\partial\alpha_1} = 1",
                ),
            ),
        ),
        *(
            claim(
                f"eq10.{k}",
                "2",
                tex,
                "Derived from (3), (5) and (9) in τ = it",
                R if k < 5 else P,
                rests_on=("eq9", "eq9.i"),
                steps=(
                    step(
                        change.words,
                        f"{'xxyyzzwww'[k - 1]}'_{(k - 1) % 2 + 1} = "
                        + tex.split("=")[1].strip("}., "),
                    ),
                ),
                counterexample=counterexample(
                    point(
                        {
                            "x_1": "1",
                            "x_2": "1",
                            "w_1": "2-i",
                            "w_2": "2+i",
                            "w_3": "1",
                            r"\omega_3": "0",
                            "z_1": "0",
                            "z_2": "0",
                        }
                    ),
                    "0",
                    "-1",
                )
                if k < 5
                else None,
                correction=correction(
                    tex.replace("w_3", r"\omega_3"),
                    "$w_3$ is not defined: $\\omega_3$",
                    P,
                    place="eq10",
                )
                if k < 5
                else None,
            )
            for k, tex in enumerate(ROWS10, 1)
        ),
        claim("theta-prime", "2", r"\theta ' = Q_2", "", P, rests_on=two[:2]),
        claim(
            "ansatz-exponents",
            "2",
            r"m = \frac{1}{2},n =  - \frac{1}{2}",
            "The coefficient of ω₃ vanishes exactly for these exponents: solved for, not substituted",
            C,
            rests_on=("theta-prime",),
            conditions=(
                condition(
                    "Q_2",
                    "where $Q_2$ vanishes every pair of exponents will do",
                    counterexample(
                        point({"z_1": "0", "z_2": "0", "m": "7", "n": r"-\frac{3}{2}"}),
                        "0",
                        "",
                        "the coefficient, though $m \\ne \\frac12$",
                    ),
                ),
            ),
        ),
        claim(
            "eq12",
            "2",
            EQ12,
            "The derivative of $F_1$ in virtue of (10)",
            C,
            rests_on=two,
            conditions=(AWAY_FROM_THETA,),
            steps=(
                step(
                    "With $s^2 = x_1x_2$ as a generator, cleared of denominators, the derivative that the program generated is",
                    LONG,
                ),
                step("Its difference from the printed right-hand side is zero term by term."),
            ),
        ),
        claim(
            "c1",
            "2",
            r"z_1^2  + x_1 y_2  = (a^2  - b^2 ) + 2ic = c_1  = {\rm const}",
            "",
            P,
            rests_on=("eq9", "eq4.1", "eq4.2", "eq4.3"),
        ),
        claim(
            "c2",
            "2",
            r"z_2^2  + x_2 y_1  = (a^2  - b^2 ) - 2ic = c_2  = {\rm const}",
            "",
            P,
            rests_on=("eq9", "eq4.1", "eq4.2", "eq4.3"),
        ),
        claim(
            "eq14",
            "2",
            EQ14,
            "The derivative of $U_1-U_2$",
            C,
            rests_on=("c1", "c2", *two),
            conditions=(AWAY_FROM_THETA,),
        ),
        claim(
            "eq15",
            "2",
            r"F_1  = 0,\quad F_2  = 0",
            "An invariant submanifold of the phase space",
            C,
            rests_on=("eq12", "eq14"),
            conditions=(AWAY_FROM_THETA,),
            steps=(
                step(
                    "From $F_1$ and $F_2$ alone the program found",
                    r"\frac{d}{d\tau}\begin{pmatrix} F_1 \\ F_2 \end{pmatrix} = \begin{pmatrix} 0 & \dfrac{1}{2\sqrt{x_1x_2}} \\[2mm] \dfrac{U_1+U_2}{\sqrt{x_1x_2}} & 0 \end{pmatrix} \begin{pmatrix} F_1 \\ F_2 \end{pmatrix}",
                ),
            ),
        ),
        claim(
            "eq16.1",
            "2",
            r"\displaystyle{(\xi _1^2  + \xi _2^2 )\omega _3  - 2[(\xi _1 \omega _1 + \xi _2 \omega _2 )\alpha _3  + (\xi _2 \omega _1  - \xi _1 \omega _2 )\beta _3 ] = 0,}",
            "(15) in the initial variables",
            P,
            rests_on=("eq15", "eq9"),
        ),
        claim("eq16.2", "2", EQ16, "(15) in the initial variables", P, rests_on=("eq15", "eq9")),
        claim(
            "eq16.invariance",
            "2",
            "",
            "The system (16), read literally in $R^9$ with (4), is an invariant set",
            C,
            rests_on=("eq16.1", "eq16.2"),
            conditions=(
                condition(
                    r"\xi_1^2+\xi_2^2",
                    "the component $\\xi_1 = \\xi_2 = 0$ is not invariant",
                    counterexample(
                        point(
                            {
                                r"\omega_1": "1",
                                r"\omega_2": "0",
                                r"\omega_3": "0",
                                r"\alpha_1": r"\frac{123456789}{987654321}",
                                r"\alpha_2": "0",
                                r"\alpha_3": r"\frac{3}{5}\sqrt{2}",
                                r"\beta_1": "0",
                                r"\beta_2": r"\frac{123456789}{987654321}",
                                r"\beta_3": r"-\frac{3}{5}\sqrt{2}",
                                "a": "1",
                                "b": "1",
                                "c": "0",
                            }
                        ),
                        r"\frac{12}{5}\sqrt{2}",
                        "0",
                        "the derivative of the first relation, and what it ought to be",
                    ),
                ),
            ),
        ),
        claim(
            "equilibria",
            "2",
            "",
            "There exist only four equilibria of the body",
            R,
            rests_on=("energy",),
            counterexample=counterexample(
                point({r"\omega": "0", "a": "1", "b": "1", "c": "0"}),
                "∞",
                "4",
                "the equilibria, which fill a curve, and as stated",
            ),
            correction=correction(
                "",
                "exactly four when the fields are neither parallel nor such that $a=b$, $c=0$",
                C,
                (DEGENERATE,),
            ),
        ),
        claim(
            "last-multiplier",
            "2",
            "",
            "The flow preserves a measure",
            Verdict.UNDECIDED,
            message="no density was found up to degree 6",
            verdicts={"flint": Verdict.UNDECIDED, "sympy": Verdict.TIMEOUT},
        ),
        claim(
            "eq19",
            "3",
            r"\displaystyle{2\alpha _1 \alpha _2 (\omega _1^2  - \omega _2^2  + \alpha _1 ) - (\alpha _1^2  - \alpha _2^2 )(2\omega _1 \omega _2  + \alpha _2 ) = 0}",
            "(16) for β = 0",
            P,
            rests_on=("eq16.2",),
            scene="classical",
        ),
        claim(
            "eq20.1",
            "3",
            r"\displaystyle{\omega _1^2  - \omega _2^2  + \alpha _1  = {\frac {\alpha _1^2  - \alpha _2^2 } {\alpha _1^2  + \alpha _2^2 }}\sqrt {k},}",
            "From (19) and $K = k$, with $(\\alpha,\\alpha) = 1$",
            C,
            rests_on=("eq19",),
            scene="classical",
            conditions=(condition(r"\alpha_1^2+\alpha_2^2", ""),),
        ),
        claim(
            "eq20.2",
            "3",
            r"\displaystyle{2\omega _1 \omega _2  + \alpha _2  = {\frac{2\alpha _1 \alpha _2 } {\alpha _1^2  + \alpha _2^2 }}\sqrt {k}.}",
            "From (19) and $K = k$, with $(\\alpha,\\alpha) = 1$",
            C,
            rests_on=("eq19",),
            scene="classical",
            conditions=(condition(r"\alpha_1", ""),),
        ),
        claim(
            "eq21",
            "3",
            EQ21,
            "Ψ = 2L² − H as a sum of a square and a remainder",
            R,
            scene="classical",
            rests_on=("energy",),
            counterexample=counterexample(
                point(
                    {
                        r"\alpha_1": r"\frac{3}{5}",
                        r"\alpha_2": r"\frac{4}{5}",
                        r"\omega_1": "1",
                        r"\omega_2": "-2",
                        r"\omega_3": "1",
                        r"\alpha_3": "0",
                    }
                ),
                r"-\frac{121}{50}",
                r"-\frac{97}{50}",
            ),
            correction=correction(
                EQ21.replace(r"- \frac{1}{2}", r"- \frac{1}{2}\alpha_3^2"),
                "a factor",
                C,
                (condition(r"\alpha_1^2+\alpha_2^2", ""),),
                "eq21",
            ),
        ),
        claim(
            "eq22",
            "3",
            r"2\ell^2  - h = \sqrt {k}.",
            "On (18), (20); a word with 100% of_the {special} #1 characters & \\ ~ ^",
            P,
            rests_on=("eq20.1", "eq20.2", "eq21"),
            scene="classical",
        ),
        claim(
            "probable-one",
            "3",
            "x=x",
            "Screened modulo a prime",
            Verdict.PROBABLE,
            scene="classical",
            message="the chance of error is below $2^{-60}$",
        ),
        claim("enclosed-one", "3", "x=x", "Enclosed by balls", Verdict.ENCLOSED, scene="classical"),
        claim(
            "timeout-one",
            "3",
            "x=x",
            "Too long",
            Verdict.TIMEOUT,
            scene="classical",
            message="stopped after 10 s",
        ),
        claim(
            "error-one",
            "3",
            "x=x",
            "Broken",
            Verdict.ERROR,
            scene="classical",
            message="the scene has no field",
        ),
    )


def run(*chosen: Outcome) -> Run:
    """The whole run, or one of the outcomes given."""
    return Run(
        derivation="kharlamov2002",
        title="One class of solutions with two invariant relations for the problem of motion of "
        "the Kowalevski top in double constant field",
        author="Mikhail P. Kharlamov",
        source="Mekhanika tverdogo tela 32 (2002), 32–38",
        sections=(
            ("1", "Main equations"),
            ("2", "New solution with two invariant relations"),
            ("3", "The classical analogue"),
        ),
        outcomes=chosen or outcomes(),
        arithmetics=ALL,
        versions={
            "kowalevski_cas": "0.1.0",
            "Python": "3.11",
            "python-flint": "0.9.0",
            "symengine": "0.15.0",
            "sympy": "1.14.0",
        },
        vocabulary=WORDS,
    )


def in_order(run: Run) -> tuple[PaperSection, ...]:
    """The claims by section; what is called ``eq10.3`` is a row of the display (10)."""
    found = []
    for number, title in run.sections:
        outcomes = [outcome for outcome in run.outcomes if outcome.section == number]
        items = []
        for name, ones in groupby(outcomes, lambda one: re.sub(r"\.\d+$", "", one.claim)):
            rows = tuple(map(Row.of, ones))
            label = f"({name[2:]})" if re.fullmatch(r"eq\d+", name) else ""
            items.append(
                ReportItem(rows, (ClaimGroup(rows),), label, display=name if rows[0].source else "")
            )
        if outcomes:
            found.append(PaperSection(number, title, number_items(number, items)))
    return tuple(found)


def document(*chosen: Outcome) -> Document:
    """The report of the whole run, or of the outcomes given."""
    known = run(*chosen)
    return Contents(known, in_order(known)).document()
