"""Whatever a source is, an audit ends without a traceback, and nothing unread is green."""

import random

import pytest

from kowalevski_cas.audit.audit import audit
from kowalevski_cas.cli.formats import OF_AUDITS, load_format
from kowalevski_cas.processes import each
from kowalevski_cas.source.files import decode
from kowalevski_cas.source.listing import list_formulas
from kowalevski_cas.source.text import Source, SourceError
from kowalevski_cas.verify.outcome import Verdict
from tests.audit.material import base, source
from tests.sample import sampled

PIECES = r"""\ne = < $ $$ { } \\ & \begin{array}{l} \end{array} \end{equation} \def\a{ \let \sqrt ^ _ '
\frac \text{ , 0 x_1 \omega_1 \theta J_1 K i % ( ) \dot /0 ^{-1} \bs\alpha""".split()


def mutated(chance: random.Random) -> bytes:
    """The bytes of the source with some of them changed, lost, repeated or put in between."""
    data = bytearray(source().text.encode(source().encoding))
    first = data.index(b"begin{document}")
    for _ in range(chance.choice([1, 2, 5, 20])):
        at, length = chance.randrange(first, len(data)), chance.choice([1, 2, 5, 40])
        other = chance.randrange(first, len(data))
        data[at : at + chance.choice([0, length])] = chance.choice(
            [b"", bytes([chance.randrange(256)]), data[other : other + length]]
            + [piece.encode() for piece in chance.sample(PIECES, 3)]
        )
    return bytes(data)


def survives(data: bytes) -> None:
    try:
        found = decode("paper.tex", data)
    except SourceError:
        return
    list_formulas(found)
    try:
        result = audit(found, base())
    except SourceError:
        return
    for name in OF_AUDITS:
        assert load_format(name).audited(result)


def survive(sources: list[bytes]) -> None:
    """Audit sources in a process of its own, where limits of time hold."""
    base().outcomes  # noqa: B018
    assert [*each(survives, sources, 1)] == [None] * len(sources)


@pytest.mark.slow
@pytest.mark.parametrize("seed", sampled(range(200), 1))
def test_a_byte_mutated_paper(seed):
    survive([mutated(random.Random(seed))])


def verdicts(change) -> tuple[dict[str, Verdict], bool]:
    """The verdicts on the source with a changed text, and whether a formula is wrong."""
    head, begin, rest = source().text.partition(r"\begin{document}")

    def audited(text: str) -> tuple[dict[str, Verdict], bool]:
        found = audit(Source("paper.tex", text), base())
        wrong = any(formula.wrong for formula in found.formulas)
        return {id: outcome.verdict for id, outcome in found.outcomes.items()}, wrong

    base().outcomes  # noqa: B018
    (found,) = each(audited, [head + begin + change(rest)], 1)
    return found


@pytest.mark.slow
@pytest.mark.parametrize("sign", [r"\ne ", "<", r"\le ", r"\approx ", r"\equiv\ne "])
def test_no_inequality_is_proved_as_an_equality(sign):
    found, _ = verdicts(lambda text: text.replace("=", sign))
    printed = {
        display.id for display in base().interpretation.derivation.displays() if not display.source
    }
    for claim in base().interpretation.derivation.claims:
        if any(
            place.display.id in printed and "=" in place.display.tex for place in claim.places()
        ):
            assert not found[claim.id].green, claim.id


def test_rows_without_commas_are_the_same_rows():
    def change(text):
        start = text.index(r"J_1  = \omega _1^2")
        end = text.index(r"J_2  = 2\omega _1", start)
        rows = text[start:end].replace(r", \quad", r" \\ ")
        rows = rows.replace("=", "&=&", 1)
        text = text[:start] + rf"\begin{{array}}{{rcl}} {rows}" + text[end:]
        stop = text.index(",", text.index(r"J_2  = 2\omega _1", start))
        second = text[text.index("J_2", start) : stop].replace("=", "&=&", 1)
        return text[: text.index("J_2", start)] + second + r" \end{array}" + text[stop:]

    assert r"\begin{array}{rcl} J_1" in change(source().text)
    assert verdicts(change)[0] == {id: o.verdict for id, o in base().outcomes.items()}


@pytest.mark.parametrize(
    ("old", "new"),
    sampled(
        [
            (r"\theta  = x_1 x_2", "x_1 = x_1 x_2"),
            ("F_2  = U_1  - U_2", "w_1  = U_1  - U_2"),
            (r"{\bf e}_1  = (1,0,0)", r"{\bf e}_1  = {\bf e}_2"),
            (r"A_1  = A_2  = 2A_3", r"A_1  = A_3 = A_3"),
        ],
        1,
    ),
)
def test_a_name_that_is_a_variable_and_defined_at_once(old, new):
    found, wrong = verdicts(lambda text: text.replace(old, new))
    assert wrong
    assert found.keys() == base().outcomes.keys()
