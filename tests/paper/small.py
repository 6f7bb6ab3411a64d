"""Small scenes: a harmonic oscillator and Euler's top, and derivations of a few claims on them."""

from kowalevski_cas.paper.derivation import Change, Derivation, Scene, Section
from kowalevski_cas.verify.run import Session


def derivation(section):
    return Derivation("small", "A small derivation", "nobody", "nowhere", (section,))


def decide(section, *claims, arithmetics=("flint",), sources=None, **options):
    """The outcomes for claims of a section, in order; ``sources`` are read in place of displays."""
    section.claim(*claims)
    paper = derivation(section)
    return Session(paper, arithmetics, texts=paper.texts(sources), **options).run().outcomes


def verdicts(section, *claims, **options):
    return [str(outcome.verdict) for outcome in decide(section, *claims, **options)]


class Paper:
    """A section that prints what it is asked for."""

    scene: Scene

    def __init__(self, title=""):
        self.section = Section("1", title)

    def __call__(self, tex, number=1):
        """A statement of a new display."""
        return self.display(tex)[number]

    def all(self, tex):
        """The statements of a new display."""
        return (*self.display(tex),)

    def display(self, tex):
        return self.section.display(f"d{len(self.section.displays)}", tex)

    def outcome(self, kind, tex="", on=None, arithmetics=("flint",), **attributes):
        """What becomes of a claim, about a formula if there is one, on this scene or on its own."""
        self.section.claims.clear()
        claim = kind("t", on or self.scene, "", printed=self(tex) if tex else None, **attributes)
        (found,) = decide(self.section, claim, arithmetics=arithmetics, explain=True)
        return found

    def verdict(self, *claim, **attributes):
        return str(self.outcome(*claim, **attributes).verdict)


class Motion(Paper):
    """Equations of motion with a scene of their own."""

    def __init__(self, tex, *variables, **more):
        super().__init__()
        self.scene = Scene("motion", variables=variables, field=self.all(tex), **more)


class Oscillator(Paper):
    """x' = v, v' = -x, with the energy, and the complex variables x + iv, x - iv in tau = it."""

    def __init__(self):
        super().__init__("The oscillator")
        motion = self.section.display("motion", r"\dot x = v,\quad \dot v = -x")
        self.energy = self.section.display("energy", r"E=\frac{1}{2}(x^2+v^2)")
        self.unit = self.section.inline("unit", "i^2=-1")
        self.change = self.section.display("change", r"z_1=x+iv,\quad z_2=x-iv")
        self.tau = self.section.inline("tau", r"\tau=it")
        field = (motion[1], motion[2])
        self.scene = Scene(
            "oscillator", variables=("x", "v"), constants=("k",), field=field,
            definitions={"E": self.energy[1]}, roots={r"\sqrt{x^2+v^2}": None},
        )  # fmt: skip
        self.old = Scene(
            "oscillator with the unit", variables=("x", "v"), field=field, unit=self.unit[1],
            clock=self.tau[1], definitions={"z_1": self.change[1], "z_2": self.change[2]},
        )  # fmt: skip
        self.new = Scene(
            "complex oscillator", variables=("z_1", "z_2"), time=r"\tau", unit=self.unit[1],
            field=Change(self.old, (self.change[1], self.change[2]), self.tau[1]),
            conjugates=(("z_1", "z_2"),),
        )  # fmt: skip


class Top(Motion):
    """Euler's top with principal moments 1, 2, 3."""

    def __init__(self):
        super().__init__(
            r"\dot\omega_1=-\omega_2\omega_3,\quad \dot\omega_2=\omega_3\omega_1,"
            r"\quad 3\dot\omega_3=-\omega_1\omega_2",
            r"\omega_1", r"\omega_2", r"\omega_3",
        )  # fmt: skip


TWICE_ENERGY = r"\omega_1^2+2\omega_2^2+3\omega_3^2"
MOMENTUM = r"\omega_1^2+4\omega_2^2+9\omega_3^2"
