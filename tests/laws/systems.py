"""Small systems of textbooks, with statements about them of which the truth is known."""

import re
from collections.abc import Callable
from dataclasses import dataclass, replace

from kowalevski_cas.paper.claims import (
    Dimension,
    FirstIntegral,
    Identity,
    Implication,
    Independence,
    InvariantRelations,
)
from kowalevski_cas.paper.derivation import Derivation, Scene, Section

NAME = re.compile(r"\\dot\b|\\[A-Za-z]+(?:_(?:\w|\{\w+\}))?|[A-Za-z](?:_(?:\w|\{\w+\}))?")


@dataclass(frozen=True)
class Stated:
    """A statement in TeX, what it says of the system, and the verdict that it deserves.

    ``about`` is ``identity``, ``integral``, ``invariant``, ``implication``, ``dimension`` or
    ``independence``; ``given`` holds equations, ``number`` a dimension.
    """

    about: str
    tex: tuple[str, ...]
    verdict: str = "proved"
    given: tuple[str, ...] = ()
    number: int = 0


def identity(tex: str, verdict: str = "proved") -> Stated:
    return Stated("identity", (tex,), verdict)


def integral(tex: str, verdict: str = "proved", given: tuple[str, ...] = ()) -> Stated:
    return Stated("integral", (tex,), verdict, given)


def invariant(*tex: str, verdict: str = "proved") -> Stated:
    return Stated("invariant", tex, verdict)


@dataclass(frozen=True)
class System:
    """Equations of motion, and statements about them."""

    name: str
    motion: tuple[str, ...]
    variables: tuple[str, ...]
    statements: tuple[Stated, ...]
    constants: tuple[str, ...] = ()
    nonzero: tuple[str, ...] = ()
    root: str = ""
    """The printed square of a root, as ``r^2=x^2+y^2``."""

    def derivation(self) -> Derivation:
        """A derivation with a claim for each statement, called s0, s1, …"""
        section = Section("1", self.name)
        motion = section.display("motion", r",\quad ".join(self.motion))
        scene = Scene(self.name).having(
            variables=self.variables, constants=self.constants, nonzero=self.nonzero
        )
        scene = scene.moving(motion)
        if self.root:
            scene = scene.adjoining(section.display("root", self.root))
        for number, one in enumerate(self.statements):
            _claim(section, scene, f"s{number}", one)
        return Derivation("textbook", self.name, "a textbook", "nowhere", (section,))

    def under(self, change: Callable[[str], str]) -> "System":
        """The system with all of its TeX changed."""

        def each(texts: tuple[str, ...]) -> tuple[str, ...]:
            return tuple(map(change, texts))

        stated = (replace(s, tex=each(s.tex), given=each(s.given)) for s in self.statements)
        return replace(
            self,
            motion=each(self.motion),
            variables=each(self.variables),
            constants=each(self.constants),
            nonzero=each(self.nonzero),
            root=change(self.root),
            statements=tuple(stated),
        )

    def with_names(self, names: dict[str, str]) -> "System":
        """The system with other names."""
        return self.under(lambda tex: NAME.sub(lambda m: names.get(m[0], m[0]), tex))


def _claim(section: Section, scene: Scene, id: str, stated: Stated) -> None:
    tex = section.display(f"display-{id}", r",\quad ".join(stated.tex))
    given = section.display(f"given-{id}", r",\quad ".join(stated.given)) if stated.given else ()
    match stated.about:
        case "identity":
            section.claim(Identity(id, scene, "", printed=tex[1]))
        case "integral":
            section.claim(FirstIntegral(id, scene, "", printed=tex[1], given=(*given,)))
        case "invariant":
            section.claim(InvariantRelations(id, scene, "", relations=(*tex,)))
        case "implication":
            section.claim(Implication(id, scene, "", printed=tex[1], given=(*given,)))
        case "dimension":
            section.claim(
                Dimension(id, scene, "", levels=(), equations=(*tex,), dimension=stated.number)
            )
        case "independence":
            scene = scene.defining(tex)
            section.claim(
                Independence(id, scene, "", levels=(), equations=(*given,), functions=(*tex,))
            )


LORENZ = System(
    "the system of Lorenz",
    (r"\dot x=\sigma(y-x)", r"\dot y=\rho x-y-xz", r"\dot z=xy-bz"),
    ("x", "y", "z"),
    (
        invariant("x=0", "y=0"),
        invariant(r"x^2-2\sigma z=0", verdict="refuted"),
        invariant("z=0", verdict="refuted"),
        identity(r"\frac{d}{dt}(x^2)=2\sigma x(y-x)"),
        identity(r"\frac{d}{dt}(x^2)=2\sigma x(y+x)", "refuted"),
        integral("x^2+y^2", "refuted"),
    ),
    constants=(r"\sigma", r"\rho", "b"),
)

SPECIAL_LORENZ = System(
    "the system of Lorenz with b = 2σ",
    (r"\dot x=\sigma(y-x)", r"\dot y=\rho x-y-xz", r"\dot z=xy-2\sigma z"),
    ("x", "y", "z"),
    (
        invariant(r"x^2-2\sigma z=0"),
        identity(r"\frac{d}{dt}(x^2-2\sigma z)=-2\sigma(x^2-2\sigma z)"),
        identity(r"\frac{d}{dt}(x^2-2\sigma z)=-\sigma(x^2-2\sigma z)", "refuted"),
        integral(r"x^2-2\sigma z", "refuted"),
    ),
    constants=(r"\sigma", r"\rho"),
)

LOTKA_VOLTERRA = System(
    "predators and prey",
    (r"\dot x=x(a-by)", r"\dot y=y(mx-n)"),
    ("x", "y"),
    (
        invariant("x=0"),
        invariant("y=0"),
        invariant("x=1", verdict="refuted"),
        identity(r"\frac{d}{dt}(xy)=xy(a-n+mx-by)"),
        identity(r"\frac{d}{dt}(xy)=xy(a+n+mx-by)", "refuted"),
        integral("x+y", "refuted"),
    ),
    constants=("a", "b", "m", "n"),
)

EULER = System(
    "the top of Euler",
    (r"A\dot p=(B-C)qr", r"B\dot q=(C-A)rp", r"C\dot r=(A-B)pq"),
    ("p", "q", "r"),
    (
        integral("Ap^2+Bq^2+Cr^2"),
        integral("A^2p^2+B^2q^2+C^2r^2"),
        integral("Ap^2+Bq^2-Cr^2", "refuted"),
        invariant("p=0", "q=0"),
        invariant("p=0", verdict="refuted"),
        Stated("independence", ("h=Ap^2+Bq^2+Cr^2", "g=A^2p^2+B^2q^2+C^2r^2")),
        Stated("independence", ("h=Ap^2+Bq^2+Cr^2", "g=2Ap^2+2Bq^2+2Cr^2"), "refuted"),
    ),
    constants=("A", "B", "C"),
    nonzero=("A", "B", "C"),
)

HENON_HEILES = System(
    "the system of Hénon and Heiles",
    (r"\dot x=u", r"\dot y=v", r"\dot u=-x-2xy", r"\dot v=-y-x^2+y^2"),
    ("x", "y", "u", "v"),
    (
        integral(r"\frac{1}{2}(u^2+v^2+x^2+y^2)+x^2y-\frac{1}{3}y^3"),
        integral(r"\frac{1}{2}(u^2+v^2+x^2+y^2)+x^2y+\frac{1}{3}y^3", "refuted"),
        invariant("x=0", "u=0"),
        invariant("y=0", "v=0", verdict="refuted"),
        integral(r"\frac{1}{2}(v^2+y^2)-\frac{1}{3}y^3", given=("x=0", "u=0")),
    ),
)

KEPLER = System(
    "the problem of Kepler in the plane",
    (r"\dot x=u", r"\dot y=v", r"\dot u=-\frac{x}{r^3}", r"\dot v=-\frac{y}{r^3}"),
    ("x", "y", "u", "v"),
    (
        integral("xv-yu"),
        integral(r"\frac{1}{2}(u^2+v^2)-\frac{1}{r}"),
        integral(r"v(xv-yu)-\frac{x}{r}"),
        integral(r"v(xv-yu)+\frac{x}{r}", "refuted"),
        integral("xv+yu", "refuted"),
        identity(r"\frac{d}{dt}r=\frac{xu+yv}{r}"),
    ),
    nonzero=("r",),
    root="r^2=x^2+y^2",
)

TODA = System(
    "the chain of Toda with three particles",
    (
        r"\dot a_1=a_1(b_2-b_1)", r"\dot a_2=a_2(b_3-b_2)", r"\dot b_1=2a_1^2",
        r"\dot b_2=2(a_2^2-a_1^2)", r"\dot b_3=-2a_2^2",
    ),
    ("a_1", "a_2", "b_1", "b_2", "b_3"),
    (
        integral("b_1+b_2+b_3"),
        integral("b_1^2+b_2^2+b_3^2+2a_1^2+2a_2^2"),
        integral("b_1b_2b_3-a_1^2b_3-a_2^2b_1"),
        integral("b_1b_2b_3-a_1^2b_3+a_2^2b_1", "refuted"),
        invariant("a_1=0"),
        invariant("b_1=0", verdict="refuted"),
    ),
)  # fmt: skip

PENDULUM = System(
    "the pendulum",
    (r"\dot c=-sw", r"\dot s=cw", r"\dot w=-s"),
    ("c", "s", "w"),
    (
        integral("c^2+s^2"),
        integral(r"\frac{1}{2}w^2-c"),
        integral(r"\frac{1}{2}w^2+c", "refuted"),
        invariant("s=0", "w=0"),
        invariant("c=0", "w=0", verdict="refuted"),
    ),
)

VOLTERRA = System(
    "the chain of Volterra with three species",
    (r"\dot x=x(y-z)", r"\dot y=y(z-x)", r"\dot z=z(x-y)"),
    ("x", "y", "z"),
    (
        integral("x+y+z"),
        integral("xyz"),
        integral("x^2+y^2+z^2", "refuted"),
        invariant("x=0"),
        invariant("x-y=0", verdict="refuted"),
    ),
)

NAHM = System(
    "the equations of Nahm",
    (r"\dot x=yz", r"\dot y=zx", r"\dot z=xy"),
    ("x", "y", "z"),
    (
        integral("x^2-y^2"),
        integral("x^2+y^2", "refuted"),
        invariant("x-y=0"),
        invariant("x-2y=0", verdict="refuted"),
        Stated("implication", ("x^2z-y^2z=0",), given=("x-y=0",)),
        Stated("implication", ("x-y=0",), "conditional", given=("x^2-y^2=0",)),
        Stated("implication", ("x-2y=0",), "refuted", given=("x^2-y^2=0",)),
    ),
)

LAGRANGE = System(
    "the top of Lagrange",
    (
        r"\dot p=(1-C)qr-g_2", r"\dot q=(C-1)rp+g_1", r"C\dot r=0",
        r"\dot g_1=rg_2-qg_3", r"\dot g_2=pg_3-rg_1", r"\dot g_3=qg_1-pg_2",
    ),
    ("p", "q", "r", "g_1", "g_2", "g_3"),
    (
        integral("r"),
        integral("g_1^2+g_2^2+g_3^2"),
        integral("pg_1+qg_2+Crg_3"),
        integral(r"\frac{1}{2}(p^2+q^2+Cr^2)-g_3"),
        integral(r"\frac{1}{2}(p^2+q^2+Cr^2)+g_3", "refuted"),
        integral("pg_1+qg_2+rg_3", "refuted"),
    ),
    constants=("C",),
    nonzero=("C",),
)  # fmt: skip

OSCILLATOR = System(
    "the oscillator in the plane",
    (r"\dot x=u", r"\dot y=v", r"\dot u=-x", r"\dot v=-y"),
    ("x", "y", "u", "v"),
    (
        integral("xv-yu"),
        integral("xy+uv"),
        integral("xy-uv", "refuted"),
        Stated("dimension", ("x^2+u^2=1", "y^2+v^2=1"), number=2),
        Stated("dimension", ("x^2+u^2=1", "y^2+v^2=1"), "refuted", number=3),
    ),
)

SYSTEMS = (
    LORENZ, SPECIAL_LORENZ, LOTKA_VOLTERRA, EULER, HENON_HEILES, KEPLER, TODA, PENDULUM,
    VOLTERRA, NAHM, LAGRANGE, OSCILLATOR,
)  # fmt: skip
