"""Comments of authors go before all that is inferred; what they cannot mean is an error."""

from dataclasses import replace
from pathlib import Path

import pytest

from kowalevski_cas.audit.reading import ReadingSession
from kowalevski_cas.cli import main
from kowalevski_cas.paper.claims import Dimension, FirstIntegral, Implication
from kowalevski_cas.reading import read
from kowalevski_cas.reading.brackets import OF_FUNCTIONS
from kowalevski_cas.reading.canonical import MOMENTUM
from kowalevski_cas.reading.draft import beside, comments, draft, text_of
from kowalevski_cas.reading.grammar import kinds
from kowalevski_cas.reading.known import BEGINNING, TOGETHER
from kowalevski_cas.reading.small_oscillations import OF_LINEAR_PART
from kowalevski_cas.source.files import decode, read_source
from kowalevski_cas.source.text import Source, SourceError
from kowalevski_cas.verify.outcome import Verdict
from tests.sample import sampled

TOP = r"""\documentclass{article}\begin{document}
The equations of motion are
\begin{equation}\label{euler}
A\dot p=(B-C)qr,\qquad B\dot q=(C-A)rp,\qquad C\dot r=(A-B)pq.
\end{equation}
Here LINE
\begin{equation}\label{T}
T=\frac{1}{2}(Ap^2+Bq^2+Cr^2)
\end{equation}
and $G=A^2p^2+B^2q^2+C^2r^2$ MORE
are integrals. On the set
\begin{equation}\label{set}
r=0
\end{equation}
we have
\begin{equation}\label{next}
\dot p=0.
\end{equation}
Always $\dot T=0$.
LAST
\end{document}
"""


def paper(line: str = "", more: str = "", last: str = "") -> Source:
    text = TOP.replace("LINE", f"\n{line}").replace("MORE", f"\n{more}\n").replace("LAST", last)
    return decode("top.tex", text.encode())


def told(source: Source, label: str):
    """What a reading says of the formula with a label."""
    return next(f for f in read(source).formulas if label in f.item.typed.labels)


@pytest.mark.parametrize(
    ("line", "role"),
    sampled(
        [
            ("%kc: define T", "definition"),
            ("%kc: skip", "other"),
            ("%kc: given", "assumption"),
            ("%kc: claim identity", "claim"),
            ("%kc: 1 claim integral", "claim"),
        ],
        2,
    ),
)
def test_a_comment_says_the_role(line, role):
    found = told(paper(line), "T")
    assert found.role.name == role
    assert found.role.reason.startswith("line 7 of top.tex says so")


def test_what_contradicts_the_inference_is_obeyed_and_shown():
    found = told(paper(more="%kc: claim identity"), "set")
    assert found.role.name == "claim"
    assert "; without it: assumption, " in found.role.reason


def test_a_comment_says_on_what_a_claim_stands():
    text = paper().text.replace("we have", "we have\n%kc: claim on set")
    found = told(Source("top.tex", text), "next")
    assert isinstance(found.claim, Implication)
    assert [item.printed.display.id for item in found.on] == ["set"]


def test_a_kind_of_claim_is_stated_by_its_attributes():
    text = paper().text.replace("On the set", "On the set\n%kc: claim dimension 2 of set")
    (found,) = read(Source("top.tex", text)).statements
    claim = found.claim
    assert isinstance(claim, Dimension)
    assert (claim.dimension, claim.levels) == (2, ())
    assert [place.display.id for place in claim.equations] == ["set"]


def outcome(source, id="dot-T-0"):
    return ReadingSession(read(source)).outcomes[id]


@pytest.mark.parametrize(("right", "verdict"), sampled([("", "conditional"), ("2", "refuted")], 1))
def test_a_formula_between_dollars_is_claimed_though_the_paper_does_not_print_it(right, verdict):
    text = paper().text.replace(
        "On the", f"%kc: claim first integral $Ap^2+Bq^2+{right}Cr^2$\nOn the"
    )
    reading = read(Source("top.tex", text))
    (found,) = reading.statements
    assert found.claim.printed.display.source == "top.tex:14"
    assert ReadingSession(reading).outcomes[found.claim.id].verdict == verdict


@pytest.mark.parametrize(("given", "green"), sampled([("$q=0$", True), ("$p=0$", False)], 1))
def test_what_is_given_may_stand_in_the_comment_alone(given, green):
    text = paper().text.replace("we have", f"we have\n%kc: claim implication given {given}")
    found = outcome(Source("top.tex", text), "next")
    assert found.verdict.green is green and (green or found.verdict is Verdict.REFUTED)


@pytest.mark.parametrize(("left", "green"), sampled([("C", True), ("A", False)], 1))
def test_a_rate_that_is_supposed_is_a_part_of_the_law(left, green):
    line = r"%kc: suppose \dot\psi=r"
    source = paper(last=f"{line}\nThen\n\\[ {left}\\ddot\\psi=(A-B)pq. \\]")
    roles = {one.item.printed.tex: one.role.name for one in read(source).formulas}
    assert roles[r"\dot\psi=r"] == "law"
    (id,) = (id for id in ReadingSession(read(source)).outcomes if "psi" in id)
    assert outcome(source, id).verdict.green is green


@pytest.mark.slow
def test_what_is_supposed_of_constants_may_speak_of_what_is_defined():
    lines = r"%kc: suppose k=\frac{T}{2}"
    source = paper(last=f"Consider $T$ once more.\n{lines}\nThen\n\\[ 4k=Ap^2+Bq^2+Cr^2. \\]")
    (id,) = (id for id in ReadingSession(read(source)).outcomes if "4k" in id)
    assert outcome(source, id).verdict.green


@pytest.mark.parametrize(("right", "green"), sampled([("B", True), ("A", False)], 1))
def test_an_equation_that_is_supposed_of_what_moves_is_given(right, green):
    last = f"Take $T$ once more.\n%kc: suppose Ap=Bq\nThen\n\\[ Ap^2={right}pq. \\]"
    (id,) = (id for id in ReadingSession(read(paper(last=last))).outcomes if "pq" in id)
    assert outcome(paper(last=last), id).verdict.green is green


@pytest.mark.parametrize(("left", "green"), sampled([("T", True), ("2T", False)], 1))
def test_roots_that_are_supposed_may_rest_on_roots_of_definitions(left, green):
    last = r"""Put $n=\sqrt{p^2+q^2}$ and $N=n+T$. Take $T$ once more.
%kc: suppose k=\sqrt{N^2}
Then \[ k^2=(n+LEFT)^2. \]""".replace("LEFT", left)
    (id,) = (id for id in ReadingSession(read(paper(last=last))).outcomes if "k-2" in id)
    assert outcome(paper(last=last), id).verdict.green is green


@pytest.mark.parametrize(("number", "green"), sampled([(27, True), (28, False)], 1))
def test_a_comment_supposes_a_list(number, green):
    line = "%kc: suppose p>0, q>0, r>0\n%kc: claim inequality"
    last = f"Always\n{line}\n\\[ {number}pqr\\le(p+q+r)^3 . \\]"
    (id,) = (id for id in ReadingSession(read(paper(last=last))).outcomes if "pqr" in id)
    assert outcome(paper(last=last), id).verdict.green is green


@pytest.mark.slow
def test_what_is_supposed_is_no_condition_any_more():
    assert outcome(paper()).verdict is Verdict.CONDITIONAL
    source = paper(r"%kc: suppose ABC\ne 0")
    assert outcome(source).verdict is Verdict.PROVED
    supposed = {item.printed.tex: role.name for item, role in read(source).parts.roles.items()}
    assert supposed[r"ABC\ne 0"] == "assumption"


def test_what_is_supposed_behind_a_claim_is_no_hypothesis_of_it():
    source = paper(last="%kc: suppose ABC\\ne 0\nIt is $T$.")
    assert outcome(source).verdict is Verdict.CONDITIONAL


def test_an_accepted_formula_is_read_by_what_rests_on_it_and_its_own_print_stays_refuted():
    right = r"T=\frac{1}{2}(Ap^2+Bq^2+Cr^2)"
    lines = f"%kc: claim integral names T\n%kc: accept {right}"
    text = paper(lines).text.replace(f"\n{right}", "\n" + right.replace("+C", "-C"))
    outcomes = ReadingSession(read(Source("top.tex", text))).outcomes
    own, rate = outcomes["T"], outcomes["dot-T-0"]
    assert own.verdict is Verdict.REFUTED and own.correction.accepted
    assert rate.verdict.green and rate.corrected == ("T",)


LOCUS = "locus p=0, q=0 off p^2+q^2"


def test_a_locus_is_tried_by_the_claim_that_names_it():
    text = paper().text.replace("On the set", f"On the set\n%kc: claim dimension 2 of set {LOCUS}")
    (found,) = read(Source("top.tex", text)).statements
    (locus,) = found.claim.scene.loci
    assert (locus.equations, locus.condition) == (("p=0", "q=0"), "p^2+q^2")


def test_a_locus_is_tried_by_the_claim_of_a_formula_as_well():
    lines = f"%kc: claim implication given T {LOCUS}"
    text = paper().text.replace("On the set", f"On the set\n{lines}")
    assert len(told(Source("top.tex", text), "set").claim.scene.loci) == 1


def test_several_formulas_that_are_not_printed_are_claimed_one_by_one():
    lines = "%kc: claim implication $qr=rq$ $qr=pp$ on set"
    text = paper().text.replace("On the set", f"On the set\n{lines}")
    run = ReadingSession(read(Source("top.tex", text)))
    first, second = (run.outcomes[one.claim.id] for one in run.reading.statements)
    assert first.verdict.green and not second.verdict.green


OSCILLATOR = r"""The equations of motion are
\begin{equation}\label{motion} \dot x=y,\quad \dot y=-x,\quad \dot u=0. \end{equation}
With $i^2=-1$ and $\tau=it$ we take new variables
CHANGE
\begin{equation}\label{new} z=x+iy,\quad w=x-iy. \end{equation}
We look at
%kc: given
\begin{equation}\label{circle} zw=1. \end{equation}
"""


def test_a_change_of_variables_is_invertible_and_its_rows_are_conjugates():
    source = Source("top.tex", OSCILLATOR.replace("CHANGE", "%kc: claim invertible change in new"))
    run = ReadingSession(read(source))
    (claim,) = (one.claim for one in run.reading.statements)
    assert claim.scene.variables == ("z", "w", "u") and claim.pairs == (("z", "w"),)
    assert run.outcomes[claim.id].verdict is Verdict.PROVED


@pytest.mark.parametrize(("dimension", "verdict"), [(2, Verdict.PROVED), (1, Verdict.REFUTED)])
def test_a_claim_in_new_variables_is_one_of_their_space(dimension, verdict):
    line = f"%kc: claim dimension {dimension} of circle in new"
    run = ReadingSession(read(Source("top.tex", OSCILLATOR.replace("CHANGE", line))))
    (claim,) = (one.claim for one in run.reading.statements)
    assert run.outcomes[claim.id].verdict is verdict


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ("w=x-iy", "w=x+2iy", "no row of the change gives the conjugate of z"),
        ("i^2=-1", "i^2=1", "i is no imaginary unit"),
        (r" and $\tau=it$", "", "the paper prints no other time"),
    ],
)
def test_what_a_change_does_not_say_is_an_error(old, new, words):
    text = OSCILLATOR.replace("CHANGE", "%kc: claim invertible change in new").replace(old, new)
    with pytest.raises(SourceError, match=words):
        read(Source("top.tex", text))


def test_the_same_comments_stand_in_a_file_beside():
    source = replace(paper(), beside=decode("top.kc", b"T %kc: skip\nnext %kc: claim on set"))
    assert told(source, "T").role.name == "other"
    assert told(source, "next").role.reason.startswith("line 2 of top.kc says so")


@pytest.mark.parametrize(
    ("line", "words"),
    [
        ("%kc: clame integral", "the word clame is not known here; did you mean claim?"),
        ("%kc: claim integrall", "no kind of claim is called integrall; did you mean integral?"),
        ("%kc: claim dimension 4 off T", "the word off is not known here; did you mean of?"),
        ("%kc: claim dimension 4 of eular", "is no label of a formula; did you mean euler?"),
        ("%kc: claim dimension of T", "dimension is missing"),
        ("%kc: define U", "the formula has no name U"),
        ("%kc: define as squire T", "the word squire is not known behind as; did you mean square?"),
        ("%kc: law", "belongs to no closed set of rates"),
        ("%kc: 3 skip", "the formula has no statement 3"),
        ("%kc:", "it says nothing"),
        ("%kc: suppose", "a formula is missing behind suppose"),
        ("%kc: claim dimension 2 of set locus p=0", "a formula is missing behind locus"),
        ("%kc: suppose p=", "the formula breaks off here"),
        ("%kc: claim implication given $p=$", "the formula breaks off here"),
        ('%kc: on "x=y"', "is no formula of the paper"),
    ],
)
def test_what_a_comment_cannot_mean_is_an_error(line, words):
    with pytest.raises(SourceError) as error:
        read(paper(line))
    assert str(error.value).startswith("top.tex:7: “%kc:")
    assert words in str(error.value)


def test_a_comment_that_no_formula_follows_is_an_error():
    with pytest.raises(SourceError, match="no formula follows"):
        read(paper(last="%kc: skip"))


def test_every_kind_that_formulas_and_names_make_can_be_stated():
    assert kinds()["first integral"] is FirstIntegral
    assert {"dimension", "equilibria", "invariant relations", "casimir", "critical set"} <= {
        *kinds()
    }


def told_all(source):
    """All that a reading says, and the verdicts."""
    reading = read(source)
    outcomes = ReadingSession(reading, timeout=20).outcomes
    said = [(f.item.printed.place, f.role[0], f.role[2:], f.on and [i.printed.place for i in f.on])
            for f in reading.formulas]  # fmt: skip
    return said, {id: (one.verdict, one.message, one.conditions) for id, one in outcomes.items()}


@pytest.mark.slow
def test_what_is_drafted_is_read_as_before():
    source = paper()
    reading = read(source)
    kept = told_all(source)
    assert any(verdict.green for verdict, *_ in kept[1].values())
    assert "%kc: law" in draft(reading).text
    assert told_all(draft(reading)) == kept
    file = beside(reading)
    assert told_all(replace(source, beside=decode("top.kc", file.encode()))) == kept
    again = read(replace(source, beside=decode("top.kc", file.encode())))
    assert draft(again).text == source.text


PAPERS = Path(__file__).parents[1] / "data" / "papers"
FOUND_ANEW = (TOGETHER, OF_FUNCTIONS, BEGINNING, MOMENTUM, *OF_LINEAR_PART)
"""The kinds of what words around a formula say of it whenever it is read."""


@pytest.mark.parametrize("name", sampled(sorted(p.stem for p in PAPERS.glob("*.tex")), 1, seed=2))
def test_every_role_that_is_inferred_can_be_written(name):
    reading = read(read_source(PAPERS / f"{name}.tex"))
    lines = [line for _, own in comments(reading) for line in own]
    assert lines
    for formula in reading.formulas:
        written = formula.role.name in ("law", "definition", "level", "assumption", "claim")
        if written and formula.role.kind not in FOUND_ANEW:
            assert text_of(formula, reading.paper), (formula.item.printed.place, formula.role)


def test_the_command_drafts(tmp_path, capfdbinary):
    path = tmp_path / "top.tex"
    path.write_text(paper().text)
    assert main(["audit", "--alone", "--draft", str(path)]) == 0
    assert b"+%kc: law\n" in capfdbinary.readouterr().out
    assert main(["audit", "--alone", "--draft", "--beside", str(path)]) == 0
    assert capfdbinary.readouterr().out.startswith(b"euler %kc: law\n")


def test_comments_are_counted_at_the_head(tmp_path, capsys):
    path = tmp_path / "top.tex"
    path.write_text(paper("%kc: skip", "%kc: given").text)
    main(["audit", "--alone", str(path)])
    out = capsys.readouterr().out
    assert "Comments are obeyed: 1 given, 1 skip." in out
    assert "(T): line 7 of top.tex says so; without it" in out


def test_what_a_comment_states_in_full_is_refuted_where_it_fails():
    text = paper().text.replace("On the set", "On the set\n%kc: claim dimension 1 of set")
    (outcome,) = [
        one
        for id, one in ReadingSession(read(Source("top.tex", text))).outcomes.items()
        if id.startswith("dimension")
    ]
    assert outcome.verdict is Verdict.REFUTED


def test_names_of_vectors_stand_for_their_components():
    text = r"""\begin{document}
    \begin{equation}\label{law} \dot{\mathbf r}=\mathbf p,\quad \dot{\mathbf p}=-\mathbf r \end{equation}
    \begin{equation}\label{H} H=\tfrac12(\mathbf p^2+\mathbf r^2) \end{equation}
    %kc: claim equilibria 1 fixed \mathbf{p} with H
    There is one equilibrium.
    \end{document}"""
    (found,) = read(Source("oscillator.tex", text)).statements
    assert found.claim.fixed == ("p_1", "p_2", "p_3")
    assert [place.display.id for place in found.claim.levels] == ["H"]


@pytest.mark.slow
def test_every_format_tells_what_is_open(tmp_path, capsys):
    path = tmp_path / "top.tex"
    path.write_text(paper(last="Hence $p<q$.").text)
    for options in ([], ["--verbose"], ["--format", "json"], ["--format", "sarif"]):
        main(["audit", "--alone", *options, str(path)])
        assert capsys.readouterr().out


def test_what_a_comment_supposes_is_drafted_no_second_time():
    drafted = draft(read(paper(r"%kc: suppose ABC\ne 0"))).text
    assert drafted.count("ABC") == 1 and "%kc: law" in drafted


PENDULUM = r"""\documentclass{article}\begin{document}
The equations of motion are
\begin{equation}\label{law} \dot x=yw,\quad \dot y=-xw,\quad \dot w=-bcx. \end{equation}
Let $c=2b$ and $b=1$. They have the integral
%kc: suppose a\ne 0
%kc: suppose bc\ne 0
%kc: LINE
\begin{equation}\label{geo} x^2+y^2=a^2. \end{equation}
\end{document}
"""


@pytest.mark.parametrize(
    ("line", "verdict"),
    [
        ("claim equilibria 2 fixed w with geo", Verdict.PROVED),
        ("claim equilibria 4 fixed w with geo", Verdict.REFUTED),
    ],
)
def test_for_given_values_the_names_of_the_levels_are_constants(line, verdict):
    found = read(decode("top.tex", PENDULUM.replace("LINE", line).encode()))
    assert [*ReadingSession(found).outcomes.values()][-1].verdict is verdict


INVARIANT = TOP.replace("r=0\n", "q=0,\\quad r=0\n")


@pytest.mark.parametrize(
    ("of", "verdict"), [("set", Verdict.CONDITIONAL), ("set.1", Verdict.REFUTED)]
)
def test_the_set_of_a_last_multiplier_is_named_by_its_equations(of, verdict):
    text = INVARIANT.replace("LAST", f"%kc: claim last multiplier relations {of}\nThe end.")
    found = read(decode("top.tex", text.replace("LINE", "").replace("MORE", "").encode()))
    outcomes = ReadingSession(found).outcomes
    assert outcomes["lastmultiplier-set"].verdict is verdict


SPRING = r"""The equations of motion are
\begin{equation}\label{motion} \dot x=y,\quad m\dot y=-kx. \end{equation}
%kc: suppose m>0,\quad k>0
Here
%kc: claim scaling simple "m=1" "k=1" measures x 0 1 y POWER 1
$UNIT$ is taken for the unit of time, which is the choice $m=1$, $k=1$.
"""


@pytest.mark.parametrize(
    ("unit", "power", "green"),
    [(r"\sqrt{m/k}", -1, True), (r"\sqrt{k/m}", -1, False), (r"\sqrt{m/k}", 0, False)],
)
def test_a_unit_of_time_simplifies_the_equations_of_what_it_measures(unit, power, green):
    text = SPRING.replace("UNIT", unit).replace("POWER", str(power))
    (outcome,) = ReadingSession(read(Source("top.tex", text))).outcomes.values()
    assert outcome.verdict.green is green


SPECIAL = r"""The equations of motion are
\begin{equation}\label{motion} \dot u=u(v+s),\quad \dot v=-v,\quad \dot s=us. \end{equation}
%kc: claim invariant relations of wide
The set
\begin{equation}\label{wide} u=0 \end{equation}
is invariant. Suppose now that $s=0$. We have
%kc: given
\begin{equation}\label{narrow} NARROW=0 \end{equation}
in its place.
%kc: claim limit general wide special narrow on "s=0"
The end.
"""


@pytest.mark.parametrize(("narrow", "green"), [("2u", True), ("v", False), ("uv", False)])
def test_a_set_goes_over_into_one_of_a_special_case_each_on_its_own_scene(narrow, green):
    found = read(Source("top.tex", SPECIAL.replace("NARROW", narrow)))
    (claim,) = (one.claim for one in found.statements if one.claim.id.startswith("limit"))
    assert "s" in claim.general.scene.variables and "s" not in claim.special.scene.variables
    assert ReadingSession(found).outcomes[claim.id].verdict.green is green


ROWS = r"""The equations of motion are
\begin{equation}\label{motion} \dot u=v,\quad \dot v=-u. \end{equation}
%kc: given
\begin{equation}\label{lines} u+v=0,\quad u-v=0. \end{equation}
The same is written as
%kc: claim equivalence to lines
\begin{equation}\label{again} SAME. \end{equation}
"""


@pytest.mark.parametrize(
    ("same", "green"),
    [(r"2u=-2v,\quad v-u=0", [True, True]), (r"v-u=0,\quad 2u=-2v", [False, False])],
)
def test_of_a_display_each_row_is_compared_with_that_of_its_number(same, green):
    found = ReadingSession(read(Source("top.tex", ROWS.replace("SAME", same)))).outcomes
    assert [found[f"again.{k}"].verdict.green for k in (1, 2)] == green


def test_as_many_rows_are_named_as_claim():
    found = told(Source("top.tex", ROWS.replace("SAME", "2u=-2v")), "again")
    assert found.claim is None and "one statement is expected, or 1 in rows" in found.message
