"""What is true by itself corrects nothing."""

import pytest

from kowalevski_cas.notation import Vocabulary, read
from kowalevski_cas.verify.vacuous import is_trivial

WORDS = Vocabulary(scalars=frozenset("a b c u v".split()))


@pytest.mark.parametrize(
    ("tex", "trivial"),
    [
        ("u=u", True),
        ("u=-u", True),
        ("u+v-u=c", True),
        (r"v=\frac{ua}{a}", True),
        (r"v=u\sqrt{\frac{b}{b}}", True),
        (r"v=-\frac{a(u+c)}{b(u+c)}", True),
        (r"v=\frac{2u}{2a}", False),
        (r"v=\frac{au}{b}+\frac{bu}{a}", False),
        (r"v=\frac{u+a}{a}", False),
        (r"v=\frac{u^2}{u+1}", False),
    ],
)
def test_sides_and_terms_are_not_the_same_and_nothing_cancels(tex, trivial):
    assert is_trivial(read(tex, WORDS)) is trivial
