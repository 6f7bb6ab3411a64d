"""What sentences say of the volume of the phase space: it is claimed of the whole flow, or not at all."""

import pytest

from kowalevski_cas.audit.reading import ReadingSession
from tests.reading.test_reading import reading

PLANE = r"The motion obeys \[\dot u=w,\qquad\dot w=-k^2\sin u.\] "
SPIRAL = r"The motion obeys \[\dot u=w-au,\qquad\dot w=-u.\] "
BODY = r"Уравнения Эйлера \[A\dot p=(B-C)qr,\quad B\dot q=(C-A)rp,\quad C\dot r=(A-B)pq.\] "


def of_volume(text):
    """The verdicts of what words claim of the volume."""
    found = reading(text)
    outcomes = ReadingSession(found, timeout=20).outcomes
    return [outcomes[one.claim.id].verdict for one in found.statements if one.claim]


KEPT = [
    "The divergence of the right-hand sides is zero.",
    "The divergence of the system vanishes identically, whence more follows.",
    r"The flow preserves the measure $du\,dw$.",
    r"The area $du\wedge dw$ is conserved.",
    "Дивергенция правых частей равна нулю.",
    r"Фазовая площадь $du\,dw$ не изменяется.",
]


@pytest.mark.parametrize("words", KEPT)
def test_the_volume_is_preserved_or_it_is_not(words):
    (kept,) = of_volume(PLANE + words)
    assert kept.green
    (other,) = of_volume(SPIRAL + words)
    assert not other.green


def test_it_is_that_of_the_variables_of_the_law():
    words = (
        "Дивергенция правых частей, разрешённых относительно $\\dot p,\\dot q,\\dot r$, равна нулю."
    )
    (kept,) = of_volume(BODY + words)
    assert kept.green


@pytest.mark.parametrize(
    "words",
    [
        r"The flow does not preserve the area $du\,dw$.",
        "The divergence of the flow is not zero.",
        "On the line $w=0$ the divergence of the flow vanishes.",
        "For $a=0$ the divergence of the flow vanishes.",
        "The flow preserves phase area for $a=0$.",
        "Дивергенция правых частей равна нулю при $a=0$.",
        r"If the flow preserves the area $du\,dw$, then more follows.",
        "Lie believed that the flow preserves phase area.",
        "Does the flow preserve phase area?",
        r"The flow preserves the measure $w\,du\,dw$.",
        r"The flow preserves the measure $du\,dz$.",
        "The divergence of the magnetic field is zero.",
        "The divergence of the series is zero.",
    ],
)  # fmt: skip
def test_what_is_denied_or_said_of_some_place_or_of_something_else_is_not_claimed(words):
    assert not [one for one in reading(SPIRAL + words).statements if one.role.kind == "volume"]


def test_what_a_footnote_supposes_for_itself_is_over_behind_it():
    words = r"We stop.\footnote{For $a=0$ the flow preserves phase area.} The flow preserves phase area."
    (found,) = of_volume(SPIRAL + words)
    assert not found.green
