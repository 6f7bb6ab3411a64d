"""What a paper says of the flow as a whole: its divergence, and the measures that it preserves."""

from __future__ import annotations

import re

from kowalevski_cas.notation import EQUALITIES, Name, Relation
from kowalevski_cas.paper.claims.measure import DIVERGENCE
from kowalevski_cas.reading.known import CLAIM, OTHER, Known, StatementRole
from kowalevski_cas.reading.measures import with_divergence
from kowalevski_cas.reading.statements import SourceStatement

_MEASURE = (
    r"(?:integrating\s+factor|(?:Jacobi(?:an|['’]?s)?\s+(?:last\s+)?|last\s+)multiplier"
    r"|(?:last\s+)?multiplier\s+of\s+Jacobi"
    r"|densit(?:y|ies)(?:\s+of\s+(?:an?|the)\s+(?:invariant|preserved)\s+(?:measure|volume))?"
    r"|интегрирующ\w+\s+множител\w+|последн\w+\s+множител\w+(?:\s+Якоби)?|множител\w+\s+Якоби"
    r"|плотност\w+(?:\s+инвариантн\w+\s+мер\w+)?)"
)
_BEFORE = re.compile(rf"\b(?P<said>{_MEASURE})(?:\s+(?:is|equals|equal\s+to))?[\s:,~—-]*$", re.I)
"""How words end behind which stands the density of a measure."""
_BEHIND = re.compile(
    rf"[\s,~]*(?:is|are|[-—–]+)\s+(?:(?:an?|the)\s+)?(?P<said>{_MEASURE})\b(?!\s+of\s+(?!an?\s+invariant|Jacobi))",
    re.I,
)
"""How words begin that say of the formula before them that it is such a density."""
_KEPT = re.compile(r"\b(?:invarian\w+|preserv\w+|conserv\w+)\b|инвариантн|сохраня", re.I)
_DENSITY = re.compile(r"densit|плотност", re.I)
_PLANE = re.compile(r"integrating|интегрирующ", re.I)

_OF_FIELD = re.compile(
    r"\b(?:the\s+|its\s+)?divergence(?:\s+of\s+(?:(?:the|this|our)\s+)?(?:(?:vector|phase)\s+)?"
    r"(?:field|flow|system|equations|right[\s-]+(?:hand\s+)?sides?)(?:\s+(?:of\s+)?\(?\\(?:eq)?ref\{[^{}]*\}\)?)?"
    r"|\s+of\s+\(?\\(?:eq)?ref\{[^{}]*\}\)?)?"
    r"\s+(?:is|equals|is\s+equal\s+to)(?:\s+constant)?[\s,:~]*$"
    r"|\bдивергенци[яи](?:\s+(?:векторного\s+)?(?:поля|системы|потока))?(?:[\s~]*\(?\\(?:eq)?ref\{[^{}]*\}\)?)?"
    r"(?:\s+на\s+плоскости[\s~]*§)?\s*(?:равна|[-—–]+)[\s:~]*$",
    re.I,
)
"""How words end behind which stands the divergence of the field."""


_IS_MOTION = re.compile(
    r"\bfield(?:\s+§)?\s+on\s+the\s+right\b|\b(?:vector|phase)\s+(?:field|flow|space|volume|fluid)|right[\s-]+(?:hand\s+)?sides?\b"
    r"|\bflow\b|\b(?:this|our|the)\s+(?:dynamical\s+)?system\b|\bvolumes?\b"
    r"|векторн\w+\s+пол|фазов|поток|объ[её]м|прав\w+\s+част|(?:этой|данной)\s+систем",
    re.IGNORECASE,
)
"""Words for the field by which a law moves, or for what it does to volumes."""


def _names_field(item: SourceStatement, known: Known) -> bool:
    """Whether a field has a letter where its divergence is printed."""
    tex = known.paper.expanded.text[item.typed.start : item.typed.end]
    return any(with_divergence(part, ()) != part for part in re.split(r"[,;]|\\q?quad", tex))


def divergence(item: SourceStatement, known: Known) -> StatementRole | None:
    """What is said to be the divergence of the equations of motion."""
    if item.formula is None or not any(not law.images for law in known.laws):
        return None
    if Name(DIVERGENCE) in (item.formula.members[:1] if isinstance(item.formula, Relation) else ()):
        if _names_field(item, known) and not _IS_MOTION.search(f"{item.words} {item.earlier[:1]}"):
            return StatementRole(OTHER, "the divergence of a field that may be any")
        return StatementRole(CLAIM, "“div” is the divergence of the field", "divergence")
    said = _OF_FIELD.search(item.before)
    if said is None or (isinstance(item.formula, Relation) and item.formula.signs[0] in EQUALITIES):
        return None
    return StatementRole(CLAIM, f"“{said[0].strip()}” says what it is", "divergence")


def measure(item: SourceStatement, known: Known) -> StatementRole | None:
    """The density of a measure that the flow is said to preserve: it may have a name.

    In the plane an integrating factor is one; of other equations it says something else.
    """
    expression = item.formula is not None and not isinstance(item.formula, Relation)
    named = len(item.members) == 2 and isinstance(item.members[0], Name)
    names = item.bare[:1] if named else ()
    if not (expression or names) or item.derives or any(law.images for law in known.laws):
        return None
    found = _BEFORE.search(item.lead) or _BEHIND.match(item.tail)
    varies = known.varying(item.names - {*names})
    if not (found and varies) or (names and known.is_known(names[0])):
        return None
    said = found["said"]
    if _DENSITY.search(said) and not _KEPT.search(item.words):
        return None
    if _PLANE.search(said) and not all(len(law.variables) == 2 for law in known.laws):
        return None
    return StatementRole(CLAIM, f"“{said}” is said of it", "measure", names)
