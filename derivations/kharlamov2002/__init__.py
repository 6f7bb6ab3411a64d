"""M. P. Kharlamov (2002): a new class of motions of the Kowalevski top in two constant fields."""

from kowalevski_cas.paper.derivation import Derivation

from . import section1, section2, section3

derivation = Derivation(
    name="kharlamov2002",
    title=(
        "One class of solutions with two invariant relations for the problem of motion "
        "of the Kowalevski top in double constant field"
    ),
    author="M. P. Kharlamov",
    source="Mekh. Tverd. Tela 32 (2002), pp. 32–38 (in Russian)",
    edition=(
        "the author's English text, dated 5 November 2002, with a section of later remarks "
        "(SHA-256 68642ca11e599718 …); the Russian print was not compared"
    ),
    main=("eq15", "N4-dimension"),
    sections=(section1.section, section2.section, section3.section),
)
