r"""Conservative and integrable systems of mechanics, each with what is true of it.

A system is a display of equations of motion, with definitions, and formulas: those with an equality
sign are identities, the others first integrals. They stand in every textbook; each is proved before
it is used.
"""

import random
import re

from kowalevski_cas import System
from kowalevski_cas.notation import NotationError

TURNING = r"\dot\gamma_1=r\gamma_2-q\gamma_3,\ \dot\gamma_2=p\gamma_3-r\gamma_1,\ \dot\gamma_3=q\gamma_1-p\gamma_2"
POISSON = r"\gamma_1^2+\gamma_2^2+\gamma_3^2"
CANONICAL = r"\dot x=\frac{\partial H}{\partial p},\ \dot y=\frac{\partial H}{\partial q},\ \dot p=-\frac{\partial H}{\partial x},\ \dot q=-\frac{\partial H}{\partial y}"

FIELDS = {
    "Euler's top": (
        r"A\dot p=(B-C)qr,\ B\dot q=(C-A)rp,\ C\dot r=(A-B)pq",
        r"Ap^2+Bq^2+Cr^2", r"A^2p^2+B^2q^2+C^2r^2",
    ),
    "Euler's top by its momentum": (
        r"\dot x=(c-b)yz,\ \dot y=(a-c)zx,\ \dot z=(b-a)xy",
        r"x^2+y^2+z^2", r"ax^2+by^2+cz^2",
    ),
    "Lagrange's top": (
        rf"A\dot p=(A-C)qr+\mu\gamma_2,\ A\dot q=(C-A)rp-\mu\gamma_1,\ C\dot r=0,\ {TURNING}",
        r"\frac12A(p^2+q^2)+\frac12Cr^2+\mu\gamma_3", r"A(p\gamma_1+q\gamma_2)+Cr\gamma_3",
        POISSON, "r",
    ),
    "Kowalevski's top": (
        rf"2\dot p=qr,\ 2\dot q=-rp+\mu\gamma_3,\ \dot r=-\mu\gamma_2,\ {TURNING}",
        r"p^2+q^2+\frac12r^2+\mu\gamma_1", r"2p\gamma_1+2q\gamma_2+r\gamma_3", POISSON,
        r"(p^2-q^2-\mu\gamma_1)^2+(2pq-\mu\gamma_2)^2",
    ),
    "the gyrostat of Zhukovsky": (
        r"A\dot p=(B-C)qr-lq+kr,\ B\dot q=(C-A)rp-jr+lp,\ C\dot r=(A-B)pq-kp+jq",
        r"Ap^2+Bq^2+Cr^2", r"(Ap+j)^2+(Bq+k)^2+(Cr+l)^2",
    ),
    "Kepler's problem in the plane": (
        r"\ddot x=-\frac{kx}{r^3},\ \ddot y=-\frac{ky}{r^3},\ r=\sqrt{x^2+y^2}",
        r"\frac12(\dot x^2+\dot y^2)-\frac kr", r"x\dot y-y\dot x",
        r"\dot y(x\dot y-y\dot x)-\frac{kx}r",
    ),
    "Kepler's problem in polar coordinates": (
        r"\ddot r=r\dot\varphi^2-\frac k{r^2},\ r\ddot\varphi=-2\dot r\dot\varphi",
        r"r^2\dot\varphi", r"\frac12(\dot r^2+r^2\dot\varphi^2)-\frac kr",
    ),
    "the oscillator in the plane": (
        r"\ddot x=-\omega^2x,\ \ddot y=-\omega^2y",
        r"\dot x^2+\omega^2x^2", r"\dot y^2+\omega^2y^2", r"x\dot y-y\dot x",
    ),
    "two coupled oscillators": (
        r"m\ddot x=-kx-c(x-y),\ m\ddot y=-ky-c(y-x)",
        r"\frac12m(\dot x^2+\dot y^2)+\frac12k(x^2+y^2)+\frac12c(x-y)^2",
        r"m(\dot x+\dot y)^2+k(x+y)^2", r"m(\dot x-\dot y)^2+(k+2c)(x-y)^2",
    ),
    "a charge in a magnetic field": (
        r"\ddot x=\omega\dot y,\ \ddot y=-\omega\dot x,\ \ddot z=0",
        r"\dot x^2+\dot y^2", r"\dot x-\omega y", r"\dot y+\omega x", r"\dot z",
    ),
    "Foucault's pendulum": (
        r"\ddot x=2n\dot y-\omega^2x,\ \ddot y=-2n\dot x-\omega^2y",
        r"\dot x^2+\dot y^2+\omega^2(x^2+y^2)", r"x\dot y-y\dot x+n(x^2+y^2)",
    ),
    "the case of Hénon and Heiles with a quadratic integral": (
        r"\ddot x=-x-2xy,\ \ddot y=-y-x^2-y^2",
        r"\frac12(\dot x^2+\dot y^2+x^2+y^2)+x^2y+\frac13y^3",
        r"\dot x\dot y+xy+\frac13x^3+xy^2",
    ),
    "the same by Hamilton's equations": (
        rf"{CANONICAL},\ H=\frac12(p^2+q^2)+\frac12a(x^2+y^2)+x^2y+\frac13y^3",
        "H", r"pq+axy+\frac13x^3+xy^2",
    ),
    "the case of Hénon and Heiles with a quartic integral": (
        rf"{CANONICAL},\ H=\frac12(p^2+q^2)+\frac12(ax^2+by^2)+x^2y+2y^3",
        "H", r"x^4+4x^2y^2-4p^2y+4xpq+4ax^2y+(4a-b)(p^2+ax^2)",
    ),
    "Garnier's system": (
        rf"{CANONICAL},\ H=\frac12(p^2+q^2)+\frac12(ax^2+by^2)+(x^2+y^2)^2",
        "H", r"2(xq-yp)^2+(b-a)(p^2+ax^2+2x^2(x^2+y^2))",
    ),
    "Toda's lattice": (
        r"\dot a_1=a_1(b_2-b_1),\ \dot a_2=a_2(b_3-b_2),\ \dot b_1=2a_1^2,\ \dot b_2=2(a_2^2-a_1^2),\ \dot b_3=-2a_2^2",
        r"b_1+b_2+b_3", r"b_1^2+b_2^2+b_3^2+2a_1^2+2a_2^2",
        r"b_1^3+b_2^3+b_3^3+3a_1^2(b_1+b_2)+3a_2^2(b_2+b_3)",
    ),
    "Volterra's lattice": (
        r"\dot x=x(y-z),\ \dot y=y(z-x),\ \dot z=z(x-y)",
        r"x+y+z", r"xyz",
    ),
    "three resonant waves": (
        r"\dot x=ayz,\ \dot y=bzx,\ \dot z=cxy",
        r"bx^2-ay^2", r"cy^2-bz^2",
    ),
    "two particles of Calogero": (
        r"\ddot x=\frac{2g}{(x-y)^3},\ \ddot y=-\frac{2g}{(x-y)^3}",
        r"\dot x+\dot y", r"\frac12(\dot x^2+\dot y^2)+\frac g{(x-y)^2}",
    ),
    "two vortices": (
        r"\dot x=-\frac{b(y-v)}s,\ \dot y=\frac{b(x-u)}s,\ \dot u=\frac{a(y-v)}s,\ \dot v=-\frac{a(x-u)}s,\ s=(x-u)^2+(y-v)^2",
        r"ax+bu", r"ay+bv", "s", r"a(x^2+y^2)+b(u^2+v^2)",
    ),
    "two bodies": (
        r"m\ddot x=-\frac{fmM(x-u)}{r^3},\ m\ddot y=-\frac{fmM(y-v)}{r^3},\ M\ddot u=\frac{fmM(x-u)}{r^3},\ M\ddot v=\frac{fmM(y-v)}{r^3},\ r=\sqrt{(x-u)^2+(y-v)^2}",
        r"m\dot x+M\dot u", r"m\dot y+M\dot v",
        r"m(x\dot y-y\dot x)+M(u\dot v-v\dot u)",
        r"\frac12m(\dot x^2+\dot y^2)+\frac12M(\dot u^2+\dot v^2)-\frac{fmM}r",
    ),
    "a stone": (
        r"\dot x=u,\ \dot y=v,\ \dot u=0,\ \dot v=-g",
        r"u", r"\frac12(u^2+v^2)+gy", r"gx+uv",
    ),
    "Duffing's oscillator": (
        r"\dot x=v,\ \dot v=-\alpha x-\beta x^3",
        r"\frac12v^2+\frac12\alpha x^2+\frac14\beta x^4", r"\ddot x=-\alpha x-\beta x^3",
    ),
    "the pendulum": (
        r"\dot\theta=w,\ \dot w=-n^2\sin\theta",
        r"\frac12w^2-n^2\cos\theta", r"\frac d{dt}\cos\theta=-w\sin\theta",
        r"\ddot\theta=-n^2\sin\theta",
    ),
    "a bead on a turning hoop": (
        r"\ddot\theta=n^2\sin\theta\cos\theta-k\sin\theta",
        r"\frac12\dot\theta^2-\frac12n^2\sin^2\theta-k\cos\theta",
        r"\frac d{dt}(\dot\theta\cos\theta)=n^2\sin\theta\cos^2\theta-k\sin\theta\cos\theta-\dot\theta^2\sin\theta",
    ),
    "Chaplygin's sleigh": (
        r"\dot v=aw^2,\ J\dot w=-mavw,\ J=I+ma^2",
        r"\frac12(mv^2+Jw^2)", r"J\dot v+a mv^2=a(mv^2+Jw^2)",
        r"\frac d{dt}(vw)=aw^3-\frac{ma}Jv^2w",
    ),
    "Maxwell and Bloch's equations": (
        r"\dot x=y,\ \dot y=xz,\ \dot z=-xy",
        r"y^2+z^2", r"x^2+2z",
    ),
    "Clebsch's case": (
        r"\dot M_1=(c-b)p_2p_3,\ \dot M_2=(a-c)p_3p_1,\ \dot M_3=(b-a)p_1p_2,\ "
        r"\dot p_1=M_3p_2-M_2p_3,\ \dot p_2=M_1p_3-M_3p_1,\ \dot p_3=M_2p_1-M_1p_2",
        r"p_1^2+p_2^2+p_3^2", r"M_1p_1+M_2p_2+M_3p_3",
        r"M_1^2+M_2^2+M_3^2+ap_1^2+bp_2^2+cp_3^2",
        r"aM_1^2+bM_2^2+cM_3^2-bcp_1^2-cap_2^2-abp_3^2",
    ),
    "the precession of a spin": (
        r"\dot x=bz-cy,\ \dot y=cx-az,\ \dot z=ay-bx",
        r"x^2+y^2+z^2", r"ax+by+cz",
    ),
}  # fmt: skip
"""By name: the display, and what is true."""


def system(display, claims):
    """The system of a display with these claims."""
    found = System(display)
    for claim in claims:
        (found.identity if "=" in claim else found.integral)(claim)
    return found


# -- one wrong token ----------------------------------------------------------------

TOKEN = re.compile(r"\\(?:frac|sqrt|left|right|quad|partial|[dt]?frac)\b|\\d?dot\s*(?:\\[a-z]+|[A-Za-z])"
                   r"|\\[A-Za-z]+|\\.|[A-Za-z]|\d|.", re.DOTALL)  # fmt: skip
OTHER = {"+": "-", "-": "+", r"\sin": r"\cos", r"\cos": r"\sin"}
NUMBERS = {"1": "23", "2": "134", "3": "124", "4": "23"}


def wrong_tokens(display):
    """A display with one token wrong, in every way: a sign, a digit, a letter, one too few.

    What is differentiated is not touched.
    """
    tokens = TOKEN.findall(display)
    letters = {
        one
        for one in tokens
        if re.fullmatch(r"[A-Za-z]|\\(?:alpha|beta|gamma|mu|omega|varphi)", one)
    }
    letters -= {"d", "t", "H"}
    for place, token in enumerate(tokens):
        others = [OTHER[token]] if token in OTHER else [*NUMBERS.get(token, "")]
        if token in letters:
            indexed = tokens[place + 1 : place + 2] == ["_"]
            others = [] if indexed else [*sorted(letters - {token}), ""]
        if token == "-" and tokens[place - 1] == "=":
            others = [""]
        for other in others:
            yield "".join((*tokens[:place], other, *tokens[place + 1 :]))


def seeded(name, seed):
    """Displays of a system with one wrong token that can be read as such, in a random order."""
    display, *claims = FIELDS[name]
    found = [*wrong_tokens(display)]
    random.Random(f"{name} {seed}").shuffle(found)
    for wrong in found:
        try:
            yield wrong, system(wrong, claims)
        except (NotationError, ValueError):
            continue
