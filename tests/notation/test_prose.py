"""Words with mathematics between dollars."""

import pytest

from kowalevski_cas.library import available, load
from kowalevski_cas.notation import Formula, Name, Product, print_prose, read_prose, to_plain
from kowalevski_cas.notation.typst import to_typst
from tests.notation.strategies import WORDS
from tests.sample import sampled


def shown(text):
    return print_prose(read_prose(text, WORDS), str, to_plain)


@pytest.mark.parametrize(
    ("text", "plain"),
    [
        ("for $x_1 \\ne 0$ only", "for x₁ ≠ 0 only"),
        ("no mathematics", "no mathematics"),
        ("$x_1$", "x₁"),
        ("costs 5$", "costs 5$"),
        ("on $N^4$, at $E_1$", "on N⁴, at E₁"),
        ("the roots of $\\varphi$", "the roots of φ"),
        ("as $\\beta\\to 0$, or at $\\pm a$", "as β → 0, or at ±a"),
        ("at $x_1=0,\\ x_2=\\frac{1}{2}$", "at x₁ = 0, x₂ = 1/2"),
        ("nothing: $$", "nothing: $$"),
        ("$\\frac{$ is typed", "$\\frac{$ is typed"),
    ],
)
def test_each_run_is_printed_in_its_own_way(text, plain):
    assert shown(text) == plain


def test_declared_names_keep_their_meaning():
    assert read_prose("$\\ell x_1$", WORDS) == (Product((Name("\\ell"), Name("x_1"))),)


@pytest.mark.parametrize("name", sampled(available(), 2))
def test_all_that_a_derivation_says_and_states_is_printed_everywhere(name):
    import typst

    derivation = load(name)
    texts = derivation.texts()
    formulas = {s.formula for d in derivation.displays() for s in texts.statements(d)}
    said = [derivation.title, *(section.title for section in derivation.sections)]
    said += [claim.words for claim in derivation.claims]
    said += [locus.words for scene in derivation.scenes() for locus in scene.loci]
    for text in said:
        runs = read_prose(text, texts.vocabulary)
        assert "$" not in "".join(run for run in runs if isinstance(run, str))
        formulas |= {run for run in runs if isinstance(run, Formula)}
    assert not [formula for formula in formulas if "\\" in to_plain(formula)]
    typst.compile("\n".join(sorted(f"$ {to_typst(f)} $" for f in formulas)).encode())
