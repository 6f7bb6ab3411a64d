"""Poisson brackets: printed for coordinates, derived for functions."""

import pytest

from kowalevski_cas.paper.claims import Identity
from kowalevski_cas.paper.derivation import Scene
from tests.paper.small import Paper

pytestmark = pytest.mark.usefixtures("uncorrected")

AXES = ("M_1", "M_2", "M_3")


class FreeTop(Paper):
    """The free top: M = 2 omega, with the bracket of the rotations of space."""

    def __init__(self, bracket=r"\{M_i,M_j\} = -\varepsilon_{ijk}M_k"):
        super().__init__()
        omega = ("\\omega_1", "\\omega_2", "\\omega_3")
        self.scene = Scene(
            "free top", variables=omega, constants=("a",),
            vectors={r"\mathbf{M}": AXES, r"\boldsymbol{\omega}": omega},
            field=self.all(
                r"\dot\omega_1=(a-2)\omega_2\omega_3, \dot\omega_2=(2-a)\omega_1\omega_3, \dot\omega_3=0"
            ),
            definitions={
                r"\mathbf{M}": self(r"{\bf M}=2{\bs\omega}"),
                r"\{M_i,M_j\}": self(bracket),
                "H": self(r"H=2\omega_1^2+2\omega_2^2+a\omega_3^2"),
            },
        )  # fmt: skip


@pytest.mark.parametrize(
    ("tex", "verdict"),
    [
        (r"\{M_1,M_2\}=-M_3", "proved"),
        (r"\{M_2,M_1\}=M_3", "proved"),
        (r"\{\omega_1,\omega_2\}=-\frac12\omega_3", "proved"),
        (r"\{M_1,M_2\}=M_3", "refuted"),
        (r"\{H,M_3\}=0", "proved"),
        (r"\{H,M_1\}=0", "refuted"),
        (r"\{H,({\bf M},{\bf M})\}=0", "proved"),
        (r"\{M_1,\{M_2,H\}\}+\{M_2,\{H,M_1\}\}+\{H,\{M_1,M_2\}\}=0", "proved"),
        (r"\{M_1M_2,H\}=M_1\{M_2,H\}+\{M_1,H\}M_2", "proved"),
        (r"\{{\bf M},M_3\}=(M_2,-M_1,0)", "proved"),
        (r"\{{\bf M},{\bf M}\}=0", "error"),
    ],
)
def test_brackets_of_functions(tex, verdict):
    assert FreeTop().verdict(Identity, tex) == verdict


def test_a_printed_bracket_has_to_be_antisymmetric():
    outcome = FreeTop(r"\{M_i,M_j\} = M_k").outcome(Identity, r"\{M_1,M_2\}=-M_3")
    assert outcome.verdict == "error" and "is not antisymmetric" in outcome.message


def test_the_bracket_with_the_energy_is_the_motion():
    assert FreeTop().verdict(Identity, r"\dot{\bf M}=\{{\bf M},H\}") == "proved"
    assert FreeTop().verdict(Identity, r"\dot{\bf M}=\{H,{\bf M}\}") == "refuted"


class Particle(Paper):
    """A particle, with a bracket that is printed with indices."""

    def __init__(self, *brackets):
        super().__init__()
        parts = {r"\mathbf{r}": ("r_1", "r_2", "r_3"), r"\mathbf{p}": ("p_1", "p_2", "p_3")}
        self.scene = Scene(
            "particle", variables=(*parts[r"\mathbf{r}"], *parts[r"\mathbf{p}"]), vectors=parts,
            definitions={tex.partition("=")[0]: self(tex) for tex in brackets},
        )  # fmt: skip


CANONICAL, OF_MOMENTA = (
    r"\{r_i,p_j\}=\delta_{ij}",
    r"\{p_i,p_j\}=r_ir_j-r_jr_i+\varepsilon_{ijk}r_k",
)


@pytest.mark.parametrize(
    ("brackets", "tex", "verdict"),
    [
        ([CANONICAL], r"\{r_1,p_1\}=1", "proved"),
        ([CANONICAL], r"\{r_1,p_2\}=0", "proved"),
        ([CANONICAL], r"\{r_2p_3-r_3p_2,r_3p_1-r_1p_3\}=r_1p_2-r_2p_1", "proved"),
        ([CANONICAL], r"\{r_2p_3-r_3p_2,p_2\}=3p_3", "refuted"),
        ([CANONICAL, OF_MOMENTA], r"\{p_1,p_2\}=r_3", "proved"),
        ([r"\{r_i,p_j\}=r_ip_j"], r"\{r_1,p_2\}=r_1p_2", "proved"),
        ([r"\{r_i,p_j\}=r_ip_j+r_kp_k\delta_{ij}"], r"\{r_1,p_1\}=2r_1p_1+r_2p_2+r_3p_3", "proved"),
        ([r"\{r_i,p_j\}=c_{ij}"], r"\{r_1,p_2\}=0", "error"),
    ],
)
def test_what_has_no_index_k_is_not_summed_over_it(brackets, tex, verdict):
    assert Particle(*brackets).verdict(Identity, tex) == verdict


@pytest.mark.parametrize(
    "bracket", [r"\{M_i,M_j\} = -\{M_j,M_i\}", r"\{M_i,M_j\} = \varepsilon_{ijk}\{M_k,H\}"]
)
def test_a_bracket_that_brackets_give_is_none(bracket):
    for tex in (r"\{M_1,M_2\}=-M_3", r"\{H,M_3\}=0"):
        outcome = FreeTop(bracket).outcome(Identity, tex)
        assert outcome.verdict == "error" and "is given by brackets" in outcome.message
