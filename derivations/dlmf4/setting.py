"""Where the rows stand: real arguments, a complex one, and roots that take either sign."""

from kowalevski_cas.paper.claims import Implication
from kowalevski_cas.paper.derivation import Scene, Section

REAL = Scene(name="arguments", variables=("z", "u", "v"), constants=(r"\pi",))


def dlmf(number: str) -> str:
    """What is claimed of a row, with its place."""
    chapter, section, row = number.split(".")
    return f"a row of the DLMF, https://dlmf.nist.gov/{chapter}.{section}.E{row}"


def complex_argument(section: Section) -> Scene:
    """A complex argument with its real and its imaginary part."""
    printed = section.lemma(
        f"z-{section.number}", "z=x+iy", f"https://dlmf.nist.gov/{section.number}"
    )
    unit = section.lemma(f"i-{section.number}", "i^2=-1", "https://dlmf.nist.gov/1.9.E1")
    scene = Scene(name="a complex argument", variables=("x", "y"))
    return scene.with_unit(unit[1]).defining(printed)


def with_root(section: Section, number: str, tex: str, root: str) -> None:
    """A row with a root, which has one sign here and another one elsewhere."""
    printed = section.display(number, tex)
    words = f"{dlmf(number)}, with either sign of the root"
    on = REAL.adjoining(root)
    section.claim(Implication(number, on, words, (), printed=printed[1], root=root))
