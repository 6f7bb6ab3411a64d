"""Poisson brackets: printed for coordinates, derived for functions."""

import pytest

from kowalevski_cas.paper.claims import Identity
from kowalevski_cas.paper.derivation import Scene, Section
from tests.paper.small import decide

AXES = ("M_1", "M_2", "M_3")


class FreeTop:
    """The free top: M = 2 omega, with the bracket of the rotations of space."""

    def __init__(self, bracket=r"\{M_i,M_j\} = -\varepsilon_{ijk}M_k"):
        self.section = Section("1", "A free top")
        inline = self.section.inline
        omega = ("\\omega_1", "\\omega_2", "\\omega_3")
        self.scene = Scene(
            "free top", variables=omega, constants=("a",),
            vectors={r"\mathbf{M}": AXES, r"\boldsymbol{\omega}": omega},
            field=(
                inline("1", r"\dot\omega_1=(a-2)\omega_2\omega_3")[1],
                inline("2", r"\dot\omega_2=(2-a)\omega_1\omega_3")[1],
                inline("3", r"\dot\omega_3=0")[1],
            ),
            definitions={
                r"\mathbf{M}": inline("M", r"{\bf M}=2{\bs\omega}")[1],
                r"\{M_i,M_j\}": inline("bracket", bracket)[1],
                "H": inline("H", r"H=2\omega_1^2+2\omega_2^2+a\omega_3^2")[1],
            },
        )  # fmt: skip

    def decide(self, tex):
        display = self.section.inline(f"d{len(self.section.displays)}", tex)
        (outcome,) = decide(self.section, Identity(display.id, self.scene, "", printed=display[1]))[
            -1:
        ]
        return str(outcome.verdict), outcome.message


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
    assert FreeTop().decide(tex)[0] == verdict


def test_a_printed_bracket_has_to_be_antisymmetric():
    verdict, message = FreeTop(r"\{M_i,M_j\} = M_k").decide(r"\{M_1,M_2\}=-M_3")
    assert verdict == "error" and "is not antisymmetric" in message


def test_the_bracket_with_the_energy_is_the_motion():
    assert FreeTop().decide(r"\dot{\bf M}=\{{\bf M},H\}")[0] == "proved"
    assert FreeTop().decide(r"\dot{\bf M}=\{H,{\bf M}\}")[0] == "refuted"
