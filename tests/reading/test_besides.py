"""What a sentence says besides what is judged is listed, and what leads up to that is not."""

import pytest

from tests.audit.test_doubted import audited
from tests.sample import sampled

CENTRE = r"Let $\dot x=y$, $\dot y=-x$. "
CIRCLE = "$x^2+y^2$"

FURTHER = [
    (f"The function {CIRCLE} is an integral; it is linear in $x$.", "grade"),
    (f"The functions {CIRCLE} and $(x^2+y^2)^2$ are integrals, both of them linear in $y$.", "grade"),
    (f"The function {CIRCLE} is conserved, being a homogeneous function of the third degree.", "grade"),
    (f"The function {CIRCLE} is a concave integral.", "shape"),
    (f"The curve {CIRCLE[:-1]}=1$ is invariant and compact.", "shape"),
    (f"The function {CIRCLE} is an integral, its level sets are hyperbolas.", "shape"),
    (f"The function {CIRCLE} is an integral; its minimum is $1$.", "extremum"),
    (f"The function {CIRCLE} is an integral with a maximum at the origin.", "extremum"),
    (f"The function {CIRCLE} is an integral. Its root grows with time.", "course"),
    (f"We have the integral {CIRCLE}, so that $x$ decreases for ever.", "course"),
    ("The vector $(x,y)$ is parallel to the velocity.", "direction"),
    (f"The integral {CIRCLE} generates the translations.", "symmetry"),
    (f"The function {CIRCLE} is conserved because the system is not autonomous.", "symmetry"),
    (f"The function {CIRCLE} is an integral, and every solution has the same value of it.", "equality"),
    (f"The integral {CIRCLE} takes all real values.", "range"),
    (f"The function {CIRCLE} is an integral, which is empty.", "further"),
    (f"The function {CIRCLE} is an integral; for $x=0$ it has no counterpart.", "further"),
    ("The line $x=y=0$ is invariant, and so are all its parallels.", "further"),
    (f"Интеграл {CIRCLE} линеен по $x$.", "grade"),
    (f"The function {CIRCLE} is an integral, whose gradient never vanishes.", "further"),
    (f"The function {CIRCLE} is an integral of degree three.", "further"),
    (f"The function {CIRCLE} is an integral and a Casimir function.", "further"),
    (f"The integral {CIRCLE} has elliptic levels.", "expression"),
    ("The period depends on the amplitude.", "course"),
    ("It has the divergence $0$.", "expression"),
    ("It preserves $x^2-y^2$.", "symmetry"),
    ("The function $x^2-y^2$ grows.", "course"),
    ("The trace of the matrix is $0+0$.", "expression"),
    ("The transformation $(x,y)$ is canonical.", "symmetry"),
]  # fmt: skip


@pytest.mark.parametrize(("words", "kind"), sampled(FURTHER, 4))
def test_what_is_said_besides_is_listed(words, kind):
    found = audited(CENTRE + words)
    assert [one.kind.partition(":")[0] for one in found.uncovered] != []
    assert kind in [one.kind.partition(":")[0] for one in found.uncovered]
    assert not any(one.wrong for one in found.formulas)


LEADING = [
    f"The function {CIRCLE} is an integral, which is the energy.",
    f"The function {CIRCLE} is an integral, as is easily seen.",
    f"It is well known, and it is easily verified, that {CIRCLE} is an integral.",
    f"The function {CIRCLE} is an integral, and it is called the energy.",
    f"The function {CIRCLE} is an integral, which was found by Newton.",
    f"The integral {CIRCLE} is well known. The integral {CIRCLE} has been used by many.",
    f"The smallest of the integrals that is quadratic in $x$ is the integral {CIRCLE}.",
    f"If the plane is parallel to the axis, {CIRCLE} is an integral.",
    f"Let us increase the speed. The function {CIRCLE} is an integral.",
    f"We parametrise the ellipse. The function {CIRCLE} is an integral.",
    f"The function {CIRCLE} is an integral, where the axes are parallel to the walls.",
    f"Терминология не нова; как известно, {CIRCLE} является интегралом.",
]


@pytest.mark.parametrize("words", sampled(LEADING, 3))
def test_what_leads_up_to_a_claim_supposes_or_names_states_nothing(words):
    found = audited(CENTRE + words)
    assert not found.uncovered
    assert any(one.verdict == "proved" for one in found.formulas)


def test_what_stands_before_the_law_describes_the_system():
    words = r"Two plates are parallel and the rod is perpendicular to them. Then $\dot x=y$, $\dot y=-x$."
    assert not audited(words + f" The function {CIRCLE} is an integral.").uncovered
