"""What is false of a system is never green: each claim fails at a point that was chosen first."""

from collections import Counter

import pytest

from kowalevski_cas import System
from kowalevski_cas.paper.claims import AllIntegrals
from tests.laws.falsehoods import NAMES, Maker, Polynomial

pytestmark = pytest.mark.usefixtures("uncorrected", "here")

FEW, MANY = 2, 100


class Space:
    """A motion and a bracket of x, y, z, both polynomials, and a point."""

    def __init__(self, seed):
        self.maker = Maker(seed)
        self.point = self.maker.point()
        self.motion = self.maker.motion()
        self.bracket = [self.maker.polynomial() for _ in NAMES]  # {y,z}, {z,x}, {x,y}

    def rate(self, function):
        return dot(gradient(function), self.motion)

    def of(self, f, g):
        """The bracket of two functions."""
        return dot(cross(gradient(f), gradient(g)), self.bracket)

    def system(self, motion=None):
        rates = [rate.tex for rate in (motion or self.motion)]
        system = System(rf"\dot x={rates[0]}, \dot y={rates[1]}, \dot z={rates[2]}")
        pairs = zip((r"\{y,z\}", r"\{z,x\}", r"\{x,y\}"), self.bracket, strict=True)
        system.define(", ".join(f"{pair}={one.tex}" for pair, one in pairs))
        system.seconds = 5
        return system

    def fails(self, function):
        return function(self.point) != 0


X, Y, Z = VARIABLES = [
    Polynomial({tuple(int(k == j) for j in range(3)): 1}) for k in range(3)
]  # fmt: skip


def cross(a, b):
    return [a[1] * b[2] + a[2] * b[1] * -1, a[2] * b[0] + a[0] * b[2] * -1, a[0] * b[1] + a[1] * b[0] * -1]  # fmt: skip


def gradient(function):
    return [function.partial(k) for k in range(3)]


def dot(left, right):
    total = Polynomial()
    for one, other in zip(left, right, strict=True):
        total += one * other
    return total


def darboux(space):
    F, K = space.maker.polynomial(), space.maker.polynomial()
    if space.fails(space.rate(F) + F * K * -1):
        return space.system().darboux(F.tex, K.tex)


def casimir(space):
    F = space.maker.polynomial()
    if any(space.fails(space.of(F, one)) for one in VARIABLES):
        return space.system().casimir(F.tex)


def involution(space):
    F, G = space.maker.polynomial(), space.maker.polynomial()
    if space.fails(space.of(F, G)):
        return space.system().involution(F.tex, G.tex)


def jacobi(space):
    turned = ((X, Y, Z), (Y, Z, X), (Z, X, Y))
    total = Polynomial()
    for a, b, c in turned:
        total += space.of(a, space.of(b, c))
    if space.fails(total):
        return space.system().jacobi()


def integrable(space):
    """The motion is not that of the Hamiltonian."""
    H, C = space.maker.polynomial(), space.maker.polynomial()
    if any(space.fails(space.rate(x) + space.of(x, H) * -1) for x in VARIABLES):
        return space.system().integrable(H.tex, casimirs=[C.tex])


def all_integrals(space):
    """An integral is missing of which the degree is allowed."""
    F, G = space.maker.polynomial(2, 1), space.maker.polynomial()
    motion = cross(gradient(F), gradient(G))
    if any(map(space.fails, motion)):
        system = space.system(motion)
        return system.states(AllIntegrals, "all", "all", integrals=(F.tex,), degree=2)


def lax(space):
    """The derivative of a matrix is no commutator at the point: its trace is not zero there."""
    entries = [space.maker.polynomial() for _ in range(8)]
    if not space.fails(space.rate(entries[0] + entries[3])):
        return None
    system = space.system()
    a, b, c, d, *rest = (one.tex for one in entries)
    L = system.define(rf"{{\bf L}}=\begin{{pmatrix}}{a}&{b}\\{c}&{d}\end{{pmatrix}}")
    e, f, g, h = rest
    M = system.define(rf"{{\bf M}}=\begin{{pmatrix}}{e}&{f}\\{g}&{h}\end{{pmatrix}}")
    return system.lax(L, M)


KINDS = (darboux, casimir, involution, jacobi, integrable, all_integrals, lax)


def never_green(kind, many):
    counted, seed = Counter(), 0
    while counted.total() < many:
        seed += 1
        if (stated := kind(Space(seed))) is not None:
            counted[str(stated.verdict)] += 1
            assert not stated.verdict.green, stated
    return counted


@pytest.mark.parametrize("kind", KINDS, ids=lambda kind: kind.__name__)
def test_what_is_false_of_a_system_is_never_green(kind):
    assert never_green(kind, FEW)["refuted"]


@pytest.mark.slow
@pytest.mark.parametrize("kind", KINDS, ids=lambda kind: kind.__name__)
def test_hundreds_of_false_claims_are_never_green(kind, capsys):
    counted = never_green(kind, MANY)
    with capsys.disabled():
        print(kind.__name__, dict(counted))
    assert counted["error"] < MANY / 10
