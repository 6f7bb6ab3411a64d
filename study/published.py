"""Systems of textbooks and papers of which integrals or Darboux polynomials are published."""

from dataclasses import dataclass

from kowalevski_cas import System


@dataclass(frozen=True)
class Published:
    """A field, and what is known of it up to a degree; nothing but constants, if nothing is given.

    ``question`` is ``integrals`` or ``darboux``; ``known`` are polynomials that have to be found.
    """

    name: str
    motion: str
    question: str
    degree: int
    known: tuple[str, ...] = ()

    def system(self) -> System:
        """The field."""
        return System(self.motion)


def integrals(name: str, motion: str, degree: int, *known: str) -> Published:
    """A field of which these are the integrals up to a degree."""
    return Published(name, motion, "integrals", degree, known)


def darboux(name: str, motion: str, degree: int, *known: str) -> Published:
    """A field of which these are the Darboux polynomials up to a degree."""
    return Published(name, motion, "darboux", degree, known)


def newton(force_x: str, force_y: str) -> str:
    """Motion in the plane, with the velocities u and v."""
    return rf"\dot x=u,\quad \dot y=v,\quad \dot u={force_x},\quad \dot v={force_y}"


TOP = (
    r"2\dot p=qr,\quad 2\dot q=-pr-cn,\quad \dot r=cm,\quad "
    r"\dot l=rm-qn,\quad \dot m=pn-rl,\quad \dot n=ql-pm"
)
VOLTERRA_5 = r",\quad ".join(
    rf"\dot x_{k + 1}=x_{k + 1}(x_{(k + 1) % 5 + 1}-x_{(k - 1) % 5 + 1})" for k in range(5)
)
LORENZ = r"\dot x=s(y-x),\quad \dot y=rx-y-xz,\quad \dot z=xy-bz"
ROESSLER = r"\dot x=-y-z,\quad \dot y=x+ay,\quad \dot z=b+z(x-c)"
TODA = (
    r"\dot a_1=a_1(b_2-b_1),\quad \dot a_2=a_2(b_3-b_2),\quad \dot b_1=2a_1^2,\quad "
    r"\dot b_2=2(a_2^2-a_1^2),\quad \dot b_3=-2a_2^2"
)
PERIODIC_TODA = (
    r"\dot a_1=a_1(b_2-b_1),\quad \dot a_2=a_2(b_3-b_2),\quad \dot a_3=a_3(b_1-b_3),\quad "
    r"\dot b_1=2(a_1^2-a_3^2),\quad \dot b_2=2(a_2^2-a_1^2),\quad \dot b_3=2(a_3^2-a_2^2)"
)
CLEBSCH = (
    r"\dot x=ry-qz,\quad \dot y=pz-rx,\quad \dot z=qx-py,\quad "
    r"\dot p=2yz,\quad \dot q=-3zx,\quad \dot r=xy"
)

PUBLISHED = (
    integrals("the oscillator", r"\dot x=y,\quad \dot y=-x", 4, "x^2+y^2"),
    integrals("oscillators with the frequencies 1 and 2", newton("-x", "-4y"), 3,
              "x^2+u^2", "4y^2+v^2", "x^2v-u^2v-4xuy", "x^2y-u^2y+xuv"),
    integrals("the particle in a magnetic field", newton("v", "-u"), 2, "u-y", "v+x", "u^2+v^2"),
    integrals("the free particle", newton("0", "0"), 2, "u", "v", "xv-yu"),
    integrals("the falling body", r"\dot y=v,\quad \dot v=-g", 2, "v^2+2gy"),
    integrals("Duffing", r"\dot x=y,\quad \dot y=x-x^3", 4, "2y^2-2x^2+x^4"),
    integrals("the pendulum", r"\dot c=-sw,\quad \dot s=cw,\quad \dot w=-s", 4, "c^2+s^2", "w^2-2c"),
    integrals("a rotation", r"\dot x=y-z,\quad \dot y=z-x,\quad \dot z=x-y", 3, "x+y+z", "x^2+y^2+z^2"),
    integrals("a resonance", r"\dot x=x,\quad \dot y=2y,\quad \dot z=-3z", 5, "xyz", "x^3z", "y^3z^2"),
    integrals("Euler", r"A\dot p=(B-C)qr,\quad B\dot q=(C-A)rp,\quad C\dot r=(A-B)pq", 3,
              "Ap^2+Bq^2+Cr^2", "A^2p^2+B^2q^2+C^2r^2"),
    integrals("Lagrange", r"\dot p=(1-C)qr-m,\quad \dot q=(C-1)rp+l,\quad \dot r=0,\quad "
              r"\dot l=rm-qn,\quad \dot m=pn-rl,\quad \dot n=ql-pm", 3,
              "r", "l^2+m^2+n^2", "pl+qm+Crn", "p^2+q^2+Cr^2-2n"),
    integrals("Kowalevski", TOP, 4, "l^2+m^2+n^2", "2pl+2qm+rn", "2p^2+2q^2+r^2-2cl",
              "(p^2-q^2+cl)^2+(2pq+cm)^2"),
    integrals("Clebsch", CLEBSCH, 2, "x^2+y^2+z^2", "px+qy+rz", "p^2+q^2+r^2+x^2+2y^2+4z^2",
              "p^2+2q^2+4r^2-8x^2-4y^2-2z^2"),
    integrals("Nahm", r"\dot x=yz,\quad \dot y=zx,\quad \dot z=xy", 4, "x^2-y^2", "y^2-z^2"),
    integrals("three waves", r"\dot x=yz,\quad \dot y=-zx,\quad \dot z=-xy", 4, "x^2+y^2", "y^2-z^2"),
    integrals("Maxwell and Bloch", r"\dot x=y,\quad \dot y=xz,\quad \dot z=-xy", 4, "x^2+2z", "y^2+z^2"),
    integrals("Hénon and Heiles", newton("-x-2xy", "-y-x^2+y^2"), 4, "3u^2+3v^2+3x^2+3y^2+6x^2y-2y^3"),
    integrals("Hénon and Heiles, Sawada and Kotera", newton("-x-2xy", "-y-x^2-y^2"), 3,
              "3u^2+3v^2+3x^2+3y^2+6x^2y+2y^3", "3uv+3xy+x^3+3xy^2"),
    integrals("Hénon and Heiles, Korteweg and de Vries", newton("-2xy", "-x^2-6y^2"), 4,
              "u^2+v^2+2x^2y+4y^3", "x^4+4x^2y^2-4u^2y+4uvx"),
    integrals("Hénon and Heiles, Kaup and Kupershmidt", newton("-2xy", "-x^2-16y^2"), 6,
              "3u^2+3v^2+6x^2y+32y^3", "9u^4+36x^2yu^2-12x^3uv-12x^4y^2-2x^6"),
    integrals("the quartic potential 1:6:1", newton("-4x^3-12xy^2", "-12x^2y-4y^3"), 4,
              "u^2+v^2+2x^4+12x^2y^2+2y^4", "uv+4x^3y+4xy^3"),
    integrals("the quartic potential 1:12:16", newton("-4x^3-24xy^2", "-24x^2y-64y^3"), 5,
              "u^2+v^2+2x^4+24x^2y^2+32y^4", "u^2y-uvx-4x^4y-8x^2y^3"),
    integrals("the central quartic potential", newton("-4x(x^2+y^2)", "-4y(x^2+y^2)"), 4,
              "xv-yu", "u^2+v^2+2(x^2+y^2)^2"),
    integrals("Toda", TODA, 3, "b_1+b_2+b_3", "b_1^2+b_2^2+b_3^2+2a_1^2+2a_2^2",
              "b_1b_2b_3-a_1^2b_3-a_2^2b_1"),
    integrals("Toda, periodic", PERIODIC_TODA, 3, "b_1+b_2+b_3", "a_1a_2a_3",
              "b_1^2+b_2^2+b_3^2+2a_1^2+2a_2^2+2a_3^2", "b_1b_2b_3-a_1^2b_3-a_2^2b_1-a_3^2b_2"),
    integrals("Volterra with 3 species", r"\dot x=x(y-z),\quad \dot y=y(z-x),\quad \dot z=z(x-y)", 4,
              "x+y+z", "xyz"),
    integrals("Volterra with 4 species", r"\dot x=x(y-w),\quad \dot y=y(z-x),\quad "
              r"\dot z=z(w-y),\quad \dot w=w(x-z)", 3, "x+y+z+w", "xz", "yw"),
    integrals("Volterra with 5 species", VOLTERRA_5, 5, "x_1+x_2+x_3+x_4+x_5",
              "x_1x_3+x_2x_4+x_3x_5+x_4x_1+x_5x_2", "x_1x_2x_3x_4x_5"),
    integrals("an epidemic", r"\dot S=-bSI,\quad \dot I=bSI-cI,\quad \dot R=cI", 3, "S+I+R"),
    integrals("Michaelis and Menten", r"\dot s=-kes+lc,\quad \dot e=-kes+(l+m)c,\quad "
              r"\dot c=kes-(l+m)c,\quad \dot p=mc", 2, "e+c", "s+c+p"),
    integrals("Lorenz", LORENZ, 4),
    integrals("Rössler", ROESSLER, 3),
    integrals("van der Pol", r"\dot x=y,\quad \dot y=m(1-x^2)y-x", 5),
    integrals("the Brusselator", r"\dot x=a+x^2y-(b+1)x,\quad \dot y=bx-x^2y", 4),
    integrals("Nosé and Hoover", r"\dot x=y,\quad \dot y=-x-yz,\quad \dot z=a(y^2-1)", 4),
    integrals("Chen", r"\dot x=a(y-x),\quad \dot y=(c-a)x-xz+cy,\quad \dot z=xy-bz", 3),
    integrals("Sprott", r"\dot x=yz,\quad \dot y=x-y,\quad \dot z=1-xy", 4),
    darboux("Lotka and Volterra", r"\dot x=x(a-by),\quad \dot y=y(mx-n)", 3, "x", "y"),
    darboux("logistic growth", r"\dot x=rx(1-x)", 2, "x", "x-1"),
    darboux("a Darboux field", r"\dot x=3(x^2-4),\quad \dot y=3+xy-y^2", 2, "x-2", "x+2"),
    darboux("a limit cycle", r"\dot x=-y+x(1-x^2-y^2),\quad \dot y=x+y(1-x^2-y^2)", 2,
            "x^2+y^2-1", "x^2+y^2"),
    darboux("Riccati's second equation", r"\dot x=y,\quad \dot y=-3xy-x^3", 2, "y+x^2", "2y+x^2"),
    darboux("Darboux and Halphen", r"\dot x=yz-x(y+z),\quad \dot y=zx-y(z+x),\quad "
            r"\dot z=xy-z(x+y)", 1, "x-y", "y-z", "x-z"),
    darboux("Lorenz with b = 2s", LORENZ.replace("bz", "2sz"), 3, "x^2-2sz"),
    darboux("Lorenz with b = 1 and r = 0", r"\dot x=s(y-x),\quad \dot y=-y-xz,\quad \dot z=xy-z", 2,
            "y^2+z^2"),
    darboux("Lorenz with b = s = 1", r"\dot x=y-x,\quad \dot y=rx-y-xz,\quad \dot z=xy-z", 2,
            "y^2+z^2-rx^2"),
    darboux("Lorenz in general", LORENZ, 3),
    darboux("Nahm", r"\dot x=yz,\quad \dot y=zx,\quad \dot z=xy", 1,
            "x+y", "x-y", "y+z", "y-z", "x+z", "x-z"),
    darboux("May and Leonard", r"\dot x=x(1-x-ay-bz),\quad \dot y=y(1-bx-y-az),\quad "
            r"\dot z=z(1-ax-by-z)", 1, "x", "y", "z"),
    darboux("Toda", TODA, 1, "a_1", "a_2", "b_1+b_2+b_3"),
    darboux("an epidemic", r"\dot S=-bSI,\quad \dot I=bSI-cI", 2, "S", "I"),
    darboux("van der Pol", r"\dot x=y,\quad \dot y=m(1-x^2)y-x", 3),
    darboux("Rössler", ROESSLER, 2),
)  # fmt: skip
"""Controls without an answer among them."""
