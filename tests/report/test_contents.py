"""What a report says: what is wrong, each thing once, and every claim in its place."""

from collections import Counter
from collections.abc import Iterator
from dataclasses import fields, is_dataclass
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kowalevski_cas.notation import Formula, Name
from kowalevski_cas.report.compare import without_marks
from kowalevski_cas.report.contents import Contents
from kowalevski_cas.report.document import (
    Document,
    Equations,
    Graph,
    Heading,
    Judgement,
    Link,
    Paragraph,
    Sign,
    for_paper,
)
from kowalevski_cas.report.latex import render_latex
from kowalevski_cas.report.typst import render_typst
from kowalevski_cas.report.witnesses import Witness
from kowalevski_cas.verify.outcome import Outcome, ReportedStep, Verdict
from tests.report.fixtures import (
    C,
    P,
    R,
    claim,
    condition,
    correction,
    counterexample,
    document,
    in_order,
    outcomes,
    point,
    read,
    run,
    step,
)

WHOLE = document()


def parts(value: Any) -> Iterator[Any]:
    """Everything in a document, at any depth; formulas and pictures are not taken apart."""
    yield value
    if isinstance(value, tuple):
        for item in value:
            yield from parts(item)
    elif is_dataclass(value) and not isinstance(value, Formula):
        for field in fields(value):
            yield from parts(getattr(value, field.name))


def said(value: Any) -> str:
    """The words in a part of a document."""
    return "".join(part for part in parts(value) if isinstance(part, str))


def under(document: Document, anchor: str) -> tuple[Any, ...]:
    """The blocks below a heading, up to the next one."""
    places = [k for k, block in enumerate(document.blocks) if isinstance(block, Heading)]
    start = next(k for k in places if document.blocks[k].anchor == anchor)
    return document.blocks[start + 1 : min([k for k in places if k > start], default=None)]


@pytest.fixture(params=["as it is", "on paper"])
def either(request: pytest.FixtureRequest) -> Document:
    return WHOLE if request.param == "as it is" else for_paper(WHOLE)


class TestPlaces:
    def test_every_claim_stands_in_one_place_with_its_sign(self, either: Document) -> None:
        signs: dict[str, list[Verdict | None]] = {}
        for part in parts(either.blocks):
            if isinstance(part, Judgement | Equations) and part.anchor.startswith("claim."):
                signs.setdefault(part.anchor, []).append(part.verdict)
        assert signs == {f"claim.{o.claim}": [o.verdict] for o in outcomes()}

    def test_every_link_ends_somewhere_and_no_anchor_is_there_twice(self, either: Document) -> None:
        anchors = [p.anchor for p in parts(either.blocks) if getattr(p, "anchor", "")]
        assert max(Counter(anchors).values()) == 1
        links = [part for part in parts(either.blocks) if isinstance(part, Link)]
        assert len(links) > len(outcomes())
        assert {link.target for link in links if not link.outside} <= set(anchors)

    def test_each_section_shows_the_verdicts_of_its_claims(self) -> None:
        table = next(b for b in under(WHOLE, "holds") if type(b).__name__ == "Table")
        for section, row in zip(in_order(run()), table.rows, strict=True):
            signs = [part.verdict for part in parts(row) if isinstance(part, Sign)]
            assert signs == [outcome.verdict for outcome in section.outcomes]

    def test_all_formulas_are_there(self, either: Document) -> None:
        shown = {
            without_marks(f)
            for part in parts(either.blocks)
            if isinstance(part, Equations)
            for f in part.formulas
        }
        for outcome in outcomes():
            for one in outcome.steps:
                assert shown.issuperset(one.formulas)
            assert shown.issuperset(outcome.formulas)


class TestWrong:
    def test_a_slip_in_several_rows_is_one_misprint(self) -> None:
        heads = [block for block in under(WHOLE, "misprints")]
        assert len(heads) == 3  # i², w₃ in four rows, and the factor in (21)
        assert "Formulas 1–4 of (10)" in said(heads[1])
        assert "Before (9)" in said(heads[0])
        assert [p.wrong for p in parts(heads[1]) if isinstance(p, Equations)] == [True, False]

    def test_the_same_words_about_two_displays_are_two_misprints(self) -> None:
        pair = [
            claim(name, "1", "x=y", "", R, correction=correction("x=x", "a letter", P, place=name))
            for name in ("one", "other")
        ]
        assert len(under(document(*pair), "misprints")) == 2

    def test_what_is_false_and_no_misprint_comes_with_the_nearest_truth(self) -> None:
        (false,) = under(WHOLE, "false")
        assert "only four equilibria" in said(false) and "Correct:" in said(false)

    @pytest.mark.parametrize("formula", ["x", "x=0", "x^2+m"])
    def test_a_false_statement_shows_what_it_is_about_once(self, formula: str) -> None:
        for words in ("this is constant", f"${formula}$ is constant"):
            (false,) = under(document(claim("a", "1", formula, words, R)), "false")
            assert [f for f in parts(false) if isinstance(f, Formula)] == [*read(formula)]

    def test_a_hypothesis_is_missing_where_a_point_denies_it_and_not_where_one_divides(
        self,
    ) -> None:
        missing = said(under(WHOLE, "hypotheses"))
        assert "two fields are of different strength" in missing
        assert "eq12" not in missing and "denominator" not in missing

    def test_valid_for_is_explained_by_a_denominator_under_the_summary(self) -> None:
        marks = next(b for b in WHOLE.blocks if "denominator" in said(b) and b.kind == "note")
        assert "has this denominator" in said(marks)
        theta = condition("x_1x_2", "").expression
        formulas = [part for part in parts((marks,)) if isinstance(part, Formula)]
        assert [formula.children()[0] for formula in formulas] == [theta]

    def test_a_hypothesis_that_several_statements_lack_is_one(self) -> None:
        needed = condition("x", "for $x=0$ it fails", witness=counterexample(point({}), "1", "2"))
        pair = [claim(n, "1", "x=x", n, C, conditions=(needed,)) for n in ("one", "other")]
        blocks = document(*pair).blocks
        assert "Both statements hold only under a hypothesis that the paper" in said(blocks[0])
        several = [
            claim(n, "1", "x=x", n, C, conditions=(needed._replace(expression=Name(n)),))
            for n in ("y", "z")
        ]
        assert "hypotheses that the paper does not state (two in all)" in said(document(*several))
        assert "One missing hypothesis" in said(blocks)

    def test_an_unmended_refutation_says_so(self) -> None:
        at = counterexample(point({}), "1", "2")
        text = said(document(claim("wrong", "1", "1=2", "", R, counterexample=at)).blocks)
        assert "No true statement was found near it." in text
        assert "The left side is , the right side ." in text  # the formulas are no words

    @pytest.mark.parametrize(
        ("chosen", "sentence"),
        [
            ([claim("a", "1", "x=x", "", P)], "The only statement holds as printed."),
            ([claim(n, "1", "x=x", "", P) for n in "ab"], "Both statements hold as printed."),
            (
                [claim("a", "1", "x=x", "", P), claim("b", "1", "x=y", "", C, conditions=(condition("x", ""),))],
                "Of two formulas and statements, one holds as printed, and one holds where its denominators do not vanish.",
            ),
            (
                [claim("a", "1", "x=x", "", P), claim("b", "1", "x=y", "", R, correction=correction("x=x", "", P, place="b"))],
                "Of two formulas and statements, one holds as printed. One is spoiled by a misprint.",
            ),
            (
                [claim("a", "1", "x=y", "", R), claim("b", "1", "x=y", "", Verdict.TIMEOUT)],
                "Of two formulas and statements, none is proved. One is false, and one is not decided in the time allowed.",
            ),
        ],
    )  # fmt: skip
    def test_the_first_sentence(self, chosen: list[Outcome], sentence: str) -> None:
        (lead,) = (b for b in document(*chosen).blocks if getattr(b, "kind", "") == "lead")
        assert isinstance(lead, Paragraph) and said(lead.text) == sentence

    @given(st.lists(st.sampled_from([P, C, R, Verdict.UNDECIDED]), min_size=2, max_size=9))
    def test_the_numbers_in_it_add_up(self, verdicts: list[Verdict]) -> None:
        chosen = [
            claim(f"c{k}", "1", "x=x", "", v, conditions=(condition("x", ""),) if v is C else ())
            for k, v in enumerate(verdicts)
        ]
        (lead,) = (b for b in document(*chosen).blocks if getattr(b, "kind", "") == "lead")
        words = said(lead.text).replace(",", "").replace(".", "").lower().split()
        words = ["two" if word == "both" else word for word in words]
        names = "no one two three four five six seven eight nine".split()
        numbers = [names.index(word) for word in words if word in names[1:]]
        assert numbers[0] == len(verdicts) == sum(numbers[1:] or numbers)


class TestEvidence:
    @pytest.mark.parametrize("shared", [True, False])
    def test_conditions_that_rows_share_are_said_once(self, shared: bool) -> None:
        both = [condition(name, "a denominator") for name in ("x", "x" if shared else "m")]
        rows = [
            claim(f"eq1.{k}", "1", "x=x", "", C, conditions=(one,)) for k, one in enumerate(both, 1)
        ]
        (whole,) = (
            p for p in parts(under(document(*rows), "section.1")) if isinstance(p, Judgement)
        )
        beside = [p.label for p in whole.blocks if isinstance(p, Equations)]
        assert said(whole.head).count("Valid for ") == shared
        assert [said(label).count("valid for ") for label in beside] == [not shared] * 2

    def test_words_that_rows_do_not_share_stand_beside_each(self) -> None:
        rows = [claim(f"eq1.{k}", "1", "x=x", f"row {k}", P) for k in (1, 2)]
        (whole,) = (
            p for p in parts(under(document(*rows), "section.1")) if isinstance(p, Judgement)
        )
        assert [said(p.label) for p in whole.blocks if isinstance(p, Equations)] == [
            "row 1",
            "row 2",
        ]
        assert whole.label == ("(1)",)

    def test_a_step_that_rows_share_is_told_once(self) -> None:
        text = said(under(WHOLE, "section.2"))
        assert text.count("The change of variables carries the equations of motion to:") == 1

    def test_an_equation_that_says_nothing_is_not_shown(self) -> None:
        told = (step("This says nothing:", "1=1"), step("This does:", "x=y"))
        text = said(document(claim("a", "1", "x=x", "", P, steps=told)).blocks)
        assert "This does:" in text and "says nothing" not in text

    @pytest.mark.parametrize(
        ("letter", "plain"), [("ℓ", ""), ("x̄", ""), ("𝛂", " α"), ("𝐋²", " L²"), ("𝒜", " A")]
    )
    def test_a_box_has_no_letter_that_a_typewriter_has_not(self, letter: str, plain: str) -> None:
        one = claim("a", "1", "", letter, P)
        others = [claim(name, "1", "", letter, P, rests_on=("a",)) for name in "bcdefg"]
        (drawn,) = (p.picture for p in parts(document(one, *others)) if isinstance(p, Graph))
        assert {box.label for box in drawn.boxes} == {f"1.{k}{plain}" for k in range(1, 8)}

    @pytest.mark.parametrize("many", [1, 5, 6, 7])
    def test_few_lines_need_no_picture(self, many: int) -> None:
        one = claim("a", "1", "x=x", "", P)
        others = [claim(f"b{k}", "1", "x=x", "", P, rests_on=("a",)) for k in range(many)]
        drawn = [p for p in parts(document(one, *others)) if isinstance(p, Graph)]
        assert len(drawn) == (many >= 6)

    def test_a_box_of_the_graph_shows_what_is_stated_if_that_is_short(self) -> None:
        long = "x=1+2+3+4+5+6+7+8+9+10+11+12"
        one = claim("one", "1", "x=x", "", P)
        two = claim("two", "1", "", "$x$ is real", P, rests_on=("one",))
        three = claim("three", "1", long, "a statement of more words than there is room", P,
            rests_on=("one",))  # fmt: skip
        more = [claim(f"m{k}", "1", long, "", P, rests_on=("one",)) for k in range(4)]
        (drawn,) = (
            p.picture for p in parts(document(one, two, three, *more)) if isinstance(p, Graph)
        )
        assert {"1.1 x = x", "1.2 x is real", "1.3 a statement of more …"} <= {
            box.label for box in drawn.boxes
        }

    def test_arithmetics_that_disagree_are_named(self) -> None:
        assert "FLINT says undecided and SymPy says timeout" in said(WHOLE.blocks)

    def test_each_coordinate_has_its_equation(self) -> None:
        one = claim("a", "1", "x=y", "", R, counterexample=counterexample(
            point({"x_1": "1", "y_1": "1", "z_1": "0"}), "0", "1"
        ))  # fmt: skip
        told = next(p for p in parts(document(one)) if isinstance(p, Paragraph) and "At " in p.text)
        assert sum(isinstance(part, Formula) for part in told.text) == 3 + 2

    def test_certificates_and_programs_are_named_only_if_there_are_any(self) -> None:
        assert "certificate" not in said(under(WHOLE, "holds"))
        known = run()
        digests = {outcome.claim: "0" * 64 for outcome in known.outcomes}
        rocq = Witness("Rocq", "8.16", frozenset([known.outcomes[0].claim]))
        text = said(under(Contents(known, in_order(known), digests, (rocq,)).document(), "holds"))
        assert "Each statement has a certificate" in text and "Rocq confirms 1" in text
        del digests["eq6"]
        text = said(under(Contents(known, in_order(known), digests).document(), "holds"))
        assert f"{len(known.outcomes) - 1} of {len(known.outcomes)} have certificates" in text

    def test_numbers_of_equations_lead_to_them(self) -> None:
        six = claim("eq6", "1", "x=x", "", P)
        seven = claim("eq7", "1", "y=y", "by (6) and (10) of Kharlamov, not by (99)", P)
        (told,) = (p for p in parts(document(six, seven)) if isinstance(p, Judgement) and p.head)
        assert told.head == (
            "By ", Link("claim.eq6", ("(6)",)), " and (10) of Kharlamov, not by (99)."
        )  # fmt: skip

    def test_what_is_withheld_has_a_link_to_its_certificate(self) -> None:
        long = ReportedStep("its coefficients have 152 terms", withheld=True)
        one = run(claim("a", "1", "x=x", "", P, steps=(long,)))
        paper, accepted = in_order(one), {"a": "0" * 64}
        link = Link("there/a.json", ("a.json",), outside=True)
        assert link in parts(Contents(one, paper, accepted, evidence="there").document())
        for unproved in (
            Contents(one, paper, evidence="there").document(),
            Contents(one, paper, accepted).document(),
        ):
            assert "152 terms." in said(unproved) and link not in parts(unproved)

    def test_restated_formulas_are_called_so(self) -> None:
        first, *others = in_order(run())
        text = said(Contents(run(), [first._replace(copied=False), *others]).document().subtitle)
        assert "The formulas of section 1 are restated" in text
        assert "restated" not in said(WHOLE.subtitle)

    def test_formulas_without_a_print_are_not_compared_with_one(self) -> None:
        derived = [section._replace(copied=None) for section in in_order(run())]
        text = said(Contents(run(), derived).document().subtitle)
        assert "there is no print of them" in text and "compared" not in text

    def test_what_is_restated_does_not_hold_as_printed(self) -> None:
        one = run(claim("a", "1", "x=x", "", P))
        (section,) = in_order(one)
        lead = said(Contents(one, [section._replace(copied=False)]).document().blocks[0])
        assert "The only statement holds as stated here" in lead and "printed" not in lead


class TestOnPaper:
    def test_long_formulas_stand_in_an_appendix_and_nothing_else_is_moved(self) -> None:
        long = [p for p in parts(WHOLE.blocks) if isinstance(p, Equations) and p.long]
        blocks = for_paper(WHOLE).blocks
        (start,) = (k for k, b in enumerate(blocks) if getattr(b, "anchor", "") == "appendix")
        moved = [b for b in blocks[start:] if isinstance(b, Equations)]
        # one formula a display: a page can end between them
        assert [one.formulas for one in moved] == [(f,) for one in long for f in one.formulas] != []
        assert not any(isinstance(p, Equations) and p.long for p in parts(for_paper(WHOLE)))

    def test_what_leads_on_to_a_display_is_a_part_of_it(self) -> None:
        one = document(claim("a", "1", "x=x", "", P, steps=(step("The derivative:", "x_1=z_1"),)))
        (led,) = (p for p in parts(for_paper(one)) if isinstance(p, Equations) and p.lead)
        assert led.lead == ("The derivative:",)
        assert not any(isinstance(p, Equations) and p.lead for p in parts(one))
        for written in (render_latex(one), render_typst(one)):
            assert written.count("The derivative:") == 1

    @pytest.mark.parametrize("many", range(4))
    def test_what_leads_on_to_several_displays_stands_above_them(self, many: int) -> None:
        lead, shown = Paragraph(("Let:",), leads=True), (Equations((Name("x"),)),) * many
        for behind in ((), (Paragraph(("Behind.",)),), (Heading(("2",), "two"),)):
            found = for_paper(WHOLE._replace(blocks=(lead, *shown, *behind))).blocks
            alone = (shown[0]._replace(lead=lead.text),) if many == 1 else (lead, *shown)
            assert found == (*alone, *behind)

    def test_the_last_formula_of_a_claim_stays_with_what_is_said_of_it(self) -> None:
        kept = 0
        for one in (p for p in parts(for_paper(WHOLE)) if isinstance(p, Judgement)):
            row = *one.blocks, *one.folded
            kinds = "".join(type(block).__name__[0] for block in row)
            leading = [k for k, b in enumerate(row) if isinstance(b, Equations) and b.leads]
            assert leading == [kinds.find("EP")] * ("EP" in kinds)
            kept += len(leading)
        assert kept > 5

    def test_without_long_formulas_there_is_no_appendix(self) -> None:
        short = document(claim("a", "1", "x=x", "", P))
        assert "Appendix" not in said(for_paper(short).blocks)

    def test_records_are_left_out(self) -> None:
        kinds = {p.kind for p in parts(WHOLE) if isinstance(p, Paragraph)}
        left = {p.kind for p in parts(for_paper(WHOLE)) if isinstance(p, Paragraph)}
        assert kinds - left == {"record"}
