"""The rate of a vector is printed, and the vector is given by one that moves: by all its prints."""

import pytest

from kowalevski_cas.audit.reading import ReadingSession
from kowalevski_cas.reading import read
from kowalevski_cas.source.files import decode
from kowalevski_cas.verify.outcome import Verdict
from tests.sample import sampled

LETTERS = [
    {"K": r"\mathbf K", "w": r"\mathbf w", "n": r"\mathbf n", "J": r"\mathbf J", "k": "k"},
    {"K": r"\bm L", "w": r"\bm\omega", "n": r"\bm e", "J": r"\mathbf A", "k": "D"},
]
"""The momentum, the angular velocity, the vertical, the inertia and a constant."""

BODY = r"""
Let @J=\operatorname{diag}(B_1,B_2,B_3)$ and $@k=\mu b^2$. The momentum about the point of contact is
\begin{equation}@K=@J@w+@k\,@n\times(@w\times@n)\label{mom}\end{equation}
and the equations of motion are
\begin{equation}\dot{@K}=@K\times@w,\qquad\dot{@n}=@n\times@w.\label{eq}\end{equation}
""".replace("Let @J", "Let $@J")

UNIT = r"Suppose that $(@n,@n)=1$. Then "


def judged(text, letters):
    for one, tex in letters.items():
        text = text.replace(f"@{one}", f"{{{tex}}}" if tex.startswith("\\") else tex)
    whole = r"\begin{document}" + text + r"\end{document}"
    found = read(decode("paper.tex", whole.encode()))
    outcomes = ReadingSession(found, timeout=10).outcomes
    return [outcomes[f.claim.id] for f in found.formulas if f.claim is not None]


TRUE = [
    r"The function $F=(@K,@n)$ is an integral.",
    r"The functions $F=\frac12(@K,@w)$, $G=(@K,@K)$ are integrals.",
    r"We find \[ \frac{d}{dt}(@K,@n)=0 . \]",
    r"Instead of \eqref{mom} one may write \[ @K=@J@w+@k(@n,@n)@w-@k(@w,@n)\,@n . \]",
    r"We put $s=(@w,@n)$. Then \[ \dot s=(\dot{@w},@n) . \]",
    r"If $(@n,@n)=1$, then \[ (@J+@k\mathbf E)\,\dot{@w}=@J@w\times@w+@k(\dot{@w},@n)\,@n . \]",
    r"""\section{A special case} The ball is homogeneous, $B_1=B_2=B_3$. Then
    \[ \dot{@w}=0 . \]""",
]

FALSE = [
    r"The function $F=(@K,@w)+(@n,@w)$ is an integral.",
    r"The functions $F=\frac12(@J@w,@w)$, $G=(@K,@w)@k$ are integrals.",
    r"We find \[ \frac{d}{dt}(@K,@n)=(@w,@n) . \]",
    r"Instead of \eqref{mom} one may write \[ @K=@J@w+@k(@n,@n)@w+@k(@w,@n)\,@n . \]",
    r"Instead of \eqref{mom} one may write \[ @K=@J@w+@k@w-@k(@w,@n)\,@n . \]",
    r"We put $s=(@w,@n)$. Then \[ \dot s=(\dot{@n},@w)+(@w,@w) . \]",
    r"If $(@n,@n)=1$, then \[ (@J-@k\mathbf E)\,\dot{@w}=@J@w\times@w+@k(\dot{@w},@n)\,@n . \]",
    r"If $(@n,@n)=1$, then \[ (@J+2@k\mathbf E)\,\dot{@w}=@J@w\times@w+@k(\dot{@w},@n)\,@n . \]",
    r"\section{A special case} Now $B_1=B_2$. Then \[ \dot{@w}=0 . \]",
    r"\section{A special case} The function $F=@k(@w,@n)$ is an integral, too.",
]


@pytest.mark.parametrize("letters", LETTERS)
@pytest.mark.parametrize("text", sampled(TRUE, 3))
def test_what_follows_from_the_equations_for_a_momentum_is_proved(text, letters):
    assert judged(BODY + text, letters)
    assert all(one.verdict.green for one in judged(BODY + text, letters))


@pytest.mark.parametrize("letters", LETTERS)
@pytest.mark.parametrize("text", sampled(FALSE, 4))
def test_what_does_not_follow_is_not_green(text, letters):
    assert not all(one.verdict.green for one in judged(BODY + text, letters))


WORDS = [
    (r"Here $\mathbf E$ is the unit matrix.", True),
    (r"Here $\mathbf E$ denotes the tensor of deformation.", False),
    (r"Through $\mathbf E$ we denote the matrix of the elastic constants.", False),
]


@pytest.mark.parametrize(("words", "is_unit"), WORDS)
def test_a_bold_letter_that_words_introduce_is_the_unit_matrix_if_they_say_so(words, is_unit):
    claim = r"If $(@n,@n)=1$, then \[ (@J+@k\mathbf E)\dot{@w}=@J@w\times@w+@k(\dot{@w},@n)@n . \]"
    found = judged(BODY + words + claim, LETTERS[0])
    assert bool(found and found[-1].verdict.green) == is_unit


@pytest.mark.parametrize(
    "words",
    [
        r"Let $@k(@n,@w)=(@n,@w)+1$ be a function.",  # it is printed at its arguments
        r"The function $@k(@w)$ is arbitrary.",
    ],
)
def test_a_letter_that_is_a_function_elsewhere_is_no_factor_of_a_scalar_product(words):
    claim = r"Then \[ @K=@J@w+@k(@n,@n)@w-@k(@w,@n)\,@n . \]"
    found = judged(BODY + words + claim, LETTERS[0])
    assert not any(one.verdict is Verdict.PROVED for one in found)


FIXED = r"""The angular momentum is $@K=@J@w$, with $@J=\operatorname{diag}(B_1,B_2,B_3)$. In the fixed frame
\[ \dot{@K}=0 .\] In the frame of the body the equations of Euler are \[ @J\dot{@w}=@J@w\times@w .\] """


@pytest.mark.parametrize(
    ("claim", "green"),
    [
        (r"The function $F=(@K,@w)$ is an integral.", True),
        (r"The function $F=(@K,@K)$ is an integral.", True),
        (r"The function $F=w_1$ is an integral.", False),
        (r"The function $F=w_1^2+w_2^2$ is an integral.", False),
        (r"The function $F=(@w,@w)$ is an integral.", False),
        (r"Then \[ B_1\dot w_1=(B_2-B_3)w_2w_3 .\]", True),
        (r"Then \[ \dot w_1=0 .\]", False),
    ],
)
def test_what_is_said_in_a_fixed_frame_is_not_the_law_in_that_of_the_body(claim, green):
    found = judged(FIXED + claim, LETTERS[0])
    assert found[-1].verdict.green == green


SPINS = r"""Two spins obey \[\dot{@K}=(k@w+b@n)\times@K,\qquad \dot{@w}=(k@K+c@n)\times@w,\]
where $@n=(0,0,1)$. """
SUM = r" The function $@K\cdot@n+@w\cdot@n$ is an integral."


@pytest.mark.parametrize(
    ("words", "green"),
    [
        (r"Equilibria are \[@K=\pm s@n,\qquad @w=\pm r@n .\]", True),
        (r"Equilibria are \[@K=s@n,\qquad @w=(r,0,0) .\]", False),
    ],
)
@pytest.mark.parametrize("letters", LETTERS)
def test_vectors_at_rest_are_no_momenta(words, green, letters):
    first, *_, last = judged(SPINS + words + SUM, letters)
    assert first.verdict.green is green
    assert last.verdict.green
