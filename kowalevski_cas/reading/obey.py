"""The roles and claims that comments give, in the place of those that are inferred."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Any

from kowalevski_cas.notation import NotationError, Number, read_display
from kowalevski_cas.notation.symbol import symbol
from kowalevski_cas.paper.claims import (
    Claim,
    FirstIntegral,
    Identity,
    Implication,
    Inequality,
    InvariantRelations,
)
from kowalevski_cas.paper.scene import Scene
from kowalevski_cas.paper.texts import Printed
from kowalevski_cas.reading.changed import in_new_variables
from kowalevski_cas.reading.comments import Said, names_of
from kowalevski_cas.reading.grammar import (
    INVARIANT_SET,
    PAIRS,
    ROW,
    SCENE,
    Directive,
    own_fields,
    wrong,
)
from kowalevski_cas.reading.known import (
    ASSUMPTION,
    CLAIM,
    DEFINITION,
    LAW,
    LEVEL,
    OTHER,
    Known,
    StatementRole,
)
from kowalevski_cas.reading.ladder import rungs
from kowalevski_cas.reading.rung import Rung, claim_of_kind
from kowalevski_cas.reading.stage import Stage
from kowalevski_cas.reading.statements import SourceStatement
from kowalevski_cas.reading.unprinted import is_printed

ZERO = Number(0)
SAID = "said"
"""The kind of a claim that a comment states with all that it is about."""
SKIPPED = "skipped"

_ROLES = {"law": LAW, "define": DEFINITION, "map": DEFINITION, "level": LEVEL, "given": ASSUMPTION,
          "claim": CLAIM, "skip": OTHER}  # fmt: skip
_KINDS = {"skip": SKIPPED, "map": "change"}
"""The kinds of roles that a verb gives by itself."""


def said_role(
    found: Directive, item: SourceStatement, inferred: StatementRole, known: Known
) -> StatementRole:
    """The role that a comment gives a statement, and what was inferred, if it is another one."""
    name, kind = _ROLES[found.verb], found.ruled
    if found.verb == "map" and inferred.name == LAW:
        return inferred
    if trouble := _trouble(found, item, inferred, known):
        raise wrong(found.comment, trouble)
    names = names_of(found, item) or _names(name, item, inferred)
    if name == DEFINITION and not kind and not {*names} & {*item.printed.heads.names}:
        kind = "square"
    if found.verb in _KINDS:
        kind = _KINDS[found.verb]
    elif name == CLAIM:
        kind = SAID if found.kind is not None else found.ruled
    elif not kind and inferred.name == name:
        kind = inferred.kind
    reason = f"line {found.comment.line} of {found.comment.path.rpartition('/')[2]} says so"
    if (inferred.name, inferred.kind) == (name, kind):
        return inferred._replace(reason=reason, names=names)
    if kind != SAID:
        reason += f"; without it: {inferred.name}, {inferred.reason}"
    return StatementRole(name, reason, kind, names)


def _trouble(found: Directive, item: SourceStatement, inferred: StatementRole, known: Known) -> str:
    """Why a statement cannot have the role that a comment gives it; empty if it can."""
    if found.verb == "law" and known.law_of(item) is None and inferred.name != LAW:
        return "the formula belongs to no closed set of rates"
    heads = (*item.printed.heads.names, *item.printed.heads.squares)
    named = found.names or found.ruled or heads
    if found.verb in ("define", "level", "map") and not named:
        return "no name stands alone on a side of the formula"
    return ""


def _names(name: str, item: SourceStatement, inferred: StatementRole) -> tuple[str, ...]:
    """The names that a role gives a meaning or a value, where no comment names them."""
    if inferred.name == name:
        return inferred.names
    if name in (DEFINITION, LEVEL):
        return tuple(item.printed.heads.names or item.printed.heads.squares)
    return (item.bare or tuple(sorted(item.names))) if name == ASSUMPTION else ()


def said_rungs(item: SourceStatement, id: str, stage: Stage, said: Said) -> Iterator[Rung]:
    """The claims that a statement may make: what a comment states, or on what it puts them."""
    found, on = said.role(item), said.on(item)
    if found is not None and found.kind is not None:
        yield said_rung(found, id, stage, item)
        return
    if on is None:
        yield from rungs(item, id, stage)
        return
    named = ((rung, {one for one in rung.on if is_printed(one)}) for rung in rungs(item, id, stage))
    same = [rung for rung, own in named if own == {*on}]
    yield from same or [_rung_on(item, id, stage, on)]


def said_rung(found: Directive, id: str, stage: Stage, item: SourceStatement | None = None) -> Rung:
    """The claim that a comment states with all that it is about."""
    assert found.kind is not None and found.values is not None
    item = item or found.stated
    own = [*([item] if item is not None else []), *about(found, stage.known)]
    on = found.on or ()
    typed = stage.known.said.places.get(found)
    here = next((one for one in stage.known.items if one.typed is typed), own[0])
    own_types = {one.name: one.type for one in own_fields(found.kind)}
    places = (here,) if INVARIANT_SET in own_types.values() else (here, own[0])
    in_force = [one for place in places for one in stage.known.supposed(place)]
    supposed = stage.scene(own, [*on, *dict.fromkeys(in_force)])
    words = (found.kind.__doc__ or "").strip().partition("\n")[0].rstrip(".")
    values = spelled_out(found, stage.known)
    for name in [name for name in values if own_types[name] in ROW]:
        values[name] = _row(values[name], item, found, stage.known)
    given = tuple(one.printed for one in on if one not in supposed.assumptions)
    scene = supposed.scene.having(loci=found.loci)
    if given and "given" in own_types:
        values.setdefault("given", given)
    else:  # what vanishes on a set does so on the whole scene
        scene = _restricted(scene, on)
    for name in [name for name in values if own_types[name] == SCENE]:
        beside: Any = values[name]
        values[name] = stage.scene(own, [*on, *beside, *dict.fromkeys(in_force)]).scene
    if found.change:
        old, scene = scene, in_new_variables(scene, found.change, stage.known)
        by_change = {SCENE: old, PAIRS: scene.conjugates}
        values = {n: by_change[t] for n, t in own_types.items() if t in by_change} | values
    for name in [name for name, type in own_types.items() if type == INVARIANT_SET]:
        relations: Any = values[name]
        there = _scene_of_set(relations, on, stage)
        values[name] = InvariantRelations(f"{id}/{name}", there, words, relations=relations)
    values["printed"] = item.printed if item is not None else None
    claim = claim_of_kind(found.kind, id, scene, words, values)
    return Rung(claim, (*supposed.assumptions, *on), supposed.constants)


def _row(rows: object, item: SourceStatement | None, found: Directive, known: Known) -> object:
    """The statement that is named, of several the one beside that which makes the claim."""
    if not isinstance(rows, tuple):
        return rows
    beside = [one for one in known.items if item is not None and one.typed is item.typed]
    if len(rows) != len(beside):
        raise wrong(found.comment, f"one statement is expected, or {len(beside)} in rows")
    return next(row for one, row in zip(beside, rows, strict=True) if one is item)


def _scene_of_set(
    relations: Sequence[Printed], on: Sequence[SourceStatement], stage: Stage
) -> Scene:
    """The scene of an invariant set: with what is supposed before it is printed."""
    items = [one for one in stage.known.items if one.printed in relations]
    before = [one for one in on if one.order < items[0].order]
    scene = stage.scene(items, [*before, *stage.known.supposed(items[0])]).scene
    return _restricted(scene, before)


def _restricted(scene: Scene, on: Sequence[SourceStatement]) -> Scene:
    """A scene where the statements that say that something vanishes are in force."""
    return scene.restricted(*(one.printed for one in on if ZERO in one.members))


def about(found: Directive, known: Known) -> list[SourceStatement]:
    """The statements that a comment names, and those that define what it names in TeX.

    If nothing moves there, as in a unit, the equations of motion of the names that it lists.
    """
    own = list(dict.fromkeys((*found.items, *_defining(found, known))))
    if not own and not found.is_of_formula:
        raise wrong(found.comment, "it names no formula, and nothing that one defines")
    if not known.varying({name for one in own for name in one.names}):
        own += _moving(found, known)
    return own


def _moving(found: Directive, known: Known) -> list[SourceStatement]:
    """The rows of the first law that moves all variables that a comment lists."""
    listed = {*_texts(tuple(spelled_out(found, known).values()))}
    names = {name for name in listed if known.moves(name)}
    laws = (law for law in known.laws if names and names <= {*law.variables})
    return [*next((law.rows for law in laws), ())]


def _texts(value: object) -> Iterator[str]:
    """The texts among the values of a claim."""
    if isinstance(value, str):
        yield value
    elif isinstance(value, tuple):
        for one in value:
            yield from _texts(one)


def spelled_out(found: Directive, known: Known) -> dict[str, object]:
    """The attributes of a claim, with the components of vectors where names are listed."""
    vectors = known.names.vectors
    by_letter = {symbol(name).without_type.name: name for name in vectors}

    def components(value: object) -> object:
        """The value, with components in the place of vectors."""
        if not isinstance(value, tuple):
            return value
        found: list[object] = []
        for one in value:
            if isinstance(one, str):
                found += vectors.get(by_letter.get(one, one), (one,))
            else:
                found.append(components(one))
        return tuple(found)

    return {name: components(value) for name, value in (found.values or {}).items()}


def _defining(found: Directive, known: Known) -> Iterator[SourceStatement]:
    """The statements that define the names which a comment gives in TeX."""
    words = known.paper.words
    parts = {part for own in known.names.vectors.values() for part in own}
    words = replace(words, scalars=words.scalars | parts)
    for value in spelled_out(found, known).values():
        for tex in value if isinstance(value, tuple) else (value,):
            if not isinstance(tex, str):
                continue
            try:
                read = read_display(tex, words)
            except NotationError as error:
                raise wrong(found.comment, f"{tex} cannot be read: {error.message}") from None
            for name in sorted({name for one in read for name in one.formula.names()}):
                yield from known.definitions.get(name, [])[:1]


def _rung_on(item: SourceStatement, id: str, stage: Stage, on: tuple[SourceStatement, ...]) -> Rung:
    """A claim of a statement on those that a comment names."""
    in_force = (one for one in stage.known.supposed(item) if one not in on)
    supposed = stage.scene([item, *on], [*on, *in_force])
    given = tuple(one.printed for one in on if one not in supposed.assumptions)
    words, place = "this holds on what the author names", item.printed
    claim: Claim
    if stage.known.roles[item].kind == "inequality":
        claim = Inequality(id, supposed.scene, words, printed=place, given=given)
    elif stage.known.roles[item].kind == "integral" and not item.derives:
        claim = FirstIntegral(id, supposed.scene, words, printed=place, given=given)
    elif given:
        claim = Implication(id, supposed.scene, words, printed=place, given=given)
    else:
        claim = Identity(id, supposed.scene, words, printed=place)
    return Rung(claim, (*on, *(o for o in supposed.assumptions if o not in on)), supposed.constants)


def claim_id(found: Directive, first: SourceStatement) -> str:
    """What a claim is called that no formula makes: by its kind, and the first of its places."""
    assert found.kind is not None
    return f"{found.kind.__name__.lower()}-{first.printed.display.id}"


__all__ = ["SAID", "SKIPPED", "about", "claim_id", "said_role", "said_rung", "said_rungs"]
