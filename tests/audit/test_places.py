"""The displays of the derivation are those of the paper, and are found where they stand."""

import re

import pytest

from kowalevski_cas.audit.places import find_places
from kowalevski_cas.source.files import read_source
from kowalevski_cas.source.formulas import typed_formulas
from kowalevski_cas.source.text import Source
from kowalevski_cas.source.tokens import likeness, words
from tests.audit.material import article, base, paper_path, source


def places(found: Source):
    return find_places(base().interpretation.derivation, typed_formulas(found)[1])


def test_the_formulas_are_those_of_the_paper():
    path = paper_path()
    found = places(read_source(path))
    differing = [
        place.display.id
        for place in found
        if place.typed is None or words(place.typed.tex) != words(place.display.tex)
    ]
    assert differing == []
    assert [place.display.id for place in found if place.moved] == []


def test_every_display_of_the_paper_has_a_place():
    formulas = typed_formulas(read_source(paper_path()))[1]
    known = {id(place.typed) for place in find_places(base().interpretation.derivation, formulas)}
    assert [f.tex for f in formulas if not f.inline and id(f) not in known] == []


CHANGES = [
    ("eq9.i", "i^2=1", "i^2=2"),
    ("tau", r"\tau=it", r"\tau=is"),
    ("theta-prime", r"\theta ' = Q_2", r"\theta ' = Q_1"),
    ("Q1-prime", r"\frac{1}{2}Q_2 \omega _3 + ...", r"\frac{1}{3}Q_2 \omega _3 + ..."),
    ("ansatz-exponents", r"m = \frac{1}{2},n", r"m = \frac{1}{2},m"),
    ("F2", "F_2  = U_1  - U_2", "F_2  = U_1  + U_2"),
    ("beta", r"{\bs \beta} = 0$ (the second", r"{\bs \alpha} = 0$ (the second"),
    ("Psi", r"\Psi  = 2L^2  - H", r"\Psi  = 2L^2  - K"),
    ("A3", "A_3=1", "A_2=1"),
    ("time-unit", "A_3 /u_0", "A_1 /u_0"),
    ("combined-integral", "(2L^2  - H)^2", "(2L^2  - H)^3"),
    ("norm", r"{( {\bs \alpha},{\bs \alpha}) = 1}", r"{( {\bs \alpha},{\bs \beta}) = 1}"),
]


@pytest.mark.parametrize(("id", "old", "new"), CHANGES)
def test_inline_formulas_survive_a_changed_token(id, old, new):
    text = read_source(paper_path()).text
    assert old in text
    line = next(p for p in places(Source("p", text)) if p.display.id == id)
    found = next(p for p in places(Source("p", text.replace(old, new, 1))) if p.display.id == id)
    assert found.typed is not None
    assert abs(found.typed.start - line.typed.start) < 10
    assert not found.moved
    assert likeness(found.typed.tex, line.typed.tex) < 1


def cut(text: str, label: str) -> tuple[str, str]:
    """A text without an equation, and the equation."""
    found = re.search(
        rf"\\begin\{{equation\}}\\label\{{{label}\}}.*?\\end\{{equation\}}\n", text, re.DOTALL
    )
    assert found is not None
    return text[: found.start()] + text[found.end() :], found[0]


def test_a_missing_formula_is_missing_and_a_moved_one_is_moved():
    text, equation = cut(source().text, "eq6")
    found = {p.display.id: p for p in places(Source("p", text))}
    assert found["eq6"].typed is None
    assert sum(place.typed is None for place in found.values()) == 1
    text, _ = cut(text, "eq22")
    moved = text.replace(r"\begin{equation}\label{eq9}", equation + r"\begin{equation}\label{eq9}")
    found = {p.display.id: p for p in places(Source("p", moved))}
    assert found["eq6"].moved
    assert found["eq22"].typed is None
    assert sum(place.moved for place in found.values()) == 1


def test_another_article_has_none_of_the_places():
    found = places(article("$$ E = mc^2 $$ and $a=b$ and \\begin{align}x&=1\\\\y&=2\\end{align}"))
    assert sum(place.typed is None for place in found) > 40
