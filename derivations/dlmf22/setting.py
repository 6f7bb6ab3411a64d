"""Where the rows stand: arguments, the modulus k and the complementary modulus k'."""

from kowalevski_cas.paper.derivation import Scene, Section


def dlmf(number: str) -> str:
    """What is claimed of a row, with its place."""
    chapter, section, row = number.split(".")
    return f"a row of the DLMF, https://dlmf.nist.gov/{chapter}.{section}.E{row}"


def moduli(section: Section) -> Scene:
    """Arguments and the modulus, with the complementary one."""
    printed = section.lemma(
        f"moduli-{section.number}", "k^2+k'^2=1", "https://dlmf.nist.gov/22.2: the moduli"
    )
    scene = Scene(variables=("z", "u", "v"), constants=("k",), name="arguments and a modulus")
    return scene.solving("k'", printed[1])
