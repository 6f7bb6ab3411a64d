"""Evidence as JSON, and back, as it stands in certificates (docs/certificate.md)."""

from __future__ import annotations

from collections.abc import Sequence

from kowalevski_cas.notation import Formula
from kowalevski_cas.problem.codec import Data
from kowalevski_cas.problem.evidence import (
    At,
    Evidence,
    Factor,
    Found,
    Further,
    Minors,
    Point,
    Proof,
    Regardless,
    Roots,
    Row,
    Shown,
    Solutions,
    Squares,
)
from kowalevski_cas.problem.goals import (
    Count,
    Exists,
    Fails,
    Follows,
    Goal,
    Kernel,
    Positive,
    Rank,
)
from kowalevski_cas.problem.trees import FormatError, Tree, decode, encode, whole

PROOF = "cofactors product cases power"
ROOTS = "point root form eliminant solved cofactors quotients factors minors"
FACTOR = "factor squares cofactors granted"
"""The keys of a proof, of the roots of an eliminant, and of a factor of these."""


def evidence_data(evidence: Evidence) -> Data:
    """Evidence as it stands in a certificate, without what it has to divide by."""
    match evidence:
        case Shown(proof, point):
            return {**_point_data(point), **_proof_data(proof)}
        case At(point):
            return _point_data(point)
        case Minors(rows):
            return {"minors": _rows(rows)}
        case Found(values, inner):
            shown = [[name, encode(value)] for name, value in values.items()]
            return {"values": shown, "evidence": list(map(evidence_data, inner))}
        case Regardless(goal, points):
            weighted = [[encode(number), _point_data(point)["point"]] for number, point in points]
            return {"inner": goal, "points": weighted}
        case Squares(squares, row, point, zero):
            data = {**_point_data(point), "squares": _squares(squares), "cofactors": _rows((row,))}
            return data if zero is None else {**data, "zero": _proof_data(zero)}
        case Roots():
            return _roots_data(evidence)
        case Further(formula, point):
            return {"further": encode(formula), **_point_data(point)}
        case Solutions(points):
            return {"points": [_point_data(point)["point"] for point in points]}


def read_evidence(data: Data, goal: Goal, holds: bool = True) -> Evidence:
    """The evidence in the data of a certificate that a goal holds, or that it does not.

    Raises :class:`FormatError` if it is none.
    """
    try:
        return _read_evidence(data, goal, holds)
    except (AttributeError, IndexError, KeyError, TypeError, ValueError) as error:
        raise FormatError(f"it is no evidence: {error}") from None


def _read_evidence(data: Data, goal: Goal, holds: bool) -> Evidence:
    match goal:
        case Exists() if holds:
            _known(data, "values evidence")
            values = {name: decode(tree) for name, tree in data["values"]}
            pairs = zip(data["evidence"], goal.goals, strict=True)
            return Found(values, tuple(read_evidence(entry, one) for entry, one in pairs))
        case Exists():
            _known(data, "inner points away")
            weighted = ((decode(number), _read_point(point)) for number, point in data["points"])
            return Regardless(_index(data["inner"]), tuple(weighted))
        case Follows() if isinstance(goal, Fails) != holds:
            _known(data, f"point {PROOF} away")
            return Shown(_read_proof(data), _read_point(data["point"]))
        case Rank() if not holds and "minors" in data:
            _known(data, "minors away")
            return Minors(_read_rows(data["minors"]))
        case Positive() if holds:
            _known(data, "point squares cofactors zero away")
            squares, (row,) = _read_squares(data["squares"]), _read_rows(data["cofactors"])
            zero = _read_inner(data["zero"]) if "zero" in data else None
            return Squares(squares, row, _read_point(data["point"]), zero)
        case Kernel() if "further" in data:
            return Further(decode(data["further"]), _read_point(data["point"]))
        case Count() if "eliminant" in data:
            _known(data, f"{ROOTS} away")
            return _read_roots(data)
        case Count():
            _known(data, "points away")
            return Solutions(tuple(map(_read_point, data["points"])))
    _known(data, "point away")
    return At(_read_point(data["point"]))


def _known(data: Data, keys: str) -> Data:
    """Data that has none but these keys."""
    if unknown := data.keys() - keys.split():
        raise FormatError(f"“{min(unknown)}” is unknown here")
    return data


def _point_data(point: Point | None) -> Data:
    if point is None:
        return {}
    values = [[name, encode(value)] for name, value in sorted(point.values.items())]
    return {"point": {"roots": sorted(_squares_under(values)), "values": values}}


def _squares_under(tree: Tree) -> set[int]:
    """The whole numbers of which roots are taken."""
    if not isinstance(tree, list):
        return set()
    if tree[:1] == ["sqrt"]:
        return {tree[1]}
    return {number for part in tree for number in _squares_under(part)}


def _read_point(data: Data) -> Point:
    values = _known(data, "roots values")["values"]
    return Point({name: decode(tree) for name, tree in values})


def _proof_data(proof: Proof) -> Data:
    data: Data = {}
    if proof.product:
        data["product"] = _rows(proof.product)
    if proof.rows:
        data["cofactors"] = _rows(proof.rows)
    if proof.cases:
        data["cases"] = list(map(_proof_data, proof.cases))
    if proof.power != 1:
        data["power"] = proof.power
    return data


def _read_proof(data: Data) -> Proof:
    return Proof(
        _read_rows(data.get("cofactors", ())),
        _read_rows(data.get("product", ())),
        tuple(map(_read_inner, data.get("cases", ()))),
        data.get("power", 1),
    )


def _read_inner(data: Data) -> Proof:
    """A proof within another one, or beside it."""
    return _read_proof(_known(data, PROOF))


def _rows(rows: Sequence[Row]) -> list[list[Tree]]:
    return [[encode(entry) for entry in row] for row in rows]


def _read_rows(data: Sequence[Sequence[Tree]]) -> tuple[Row, ...]:
    return tuple(tuple(map(decode, row)) for row in data)


def _squares(squares: Sequence[tuple[Formula, Formula]]) -> list[list[Tree]]:
    return [[encode(number), encode(base)] for number, base in squares]


def _read_squares(data: Sequence[Tree]) -> tuple[tuple[Formula, Formula], ...]:
    return tuple((decode(number), decode(base)) for number, base in data)


def _roots_data(roots: Roots) -> Data:
    factors = []
    for factor in roots.factors:
        entry: Data = {"factor": encode(factor.factor), "squares": _squares(factor.squares)}
        if factor.row:
            entry["cofactors"] = _rows((factor.row,))[0]
        if factor.granted is not None:
            entry["granted"] = [factor.granted[0], _rows((factor.granted[1],))[0]]
        factors.append(entry)
    return {
        **_point_data(roots.point),
        "root": roots.root,
        "form": encode(roots.form),
        "eliminant": list(map(encode, roots.eliminant)),
        "solved": [[name, encode(a), encode(b)] for name, a, b in roots.solved],
        "cofactors": _rows(roots.rows),
        "quotients": list(map(encode, roots.quotients)),
        "factors": factors,
        "minors": [[encode(number), list(powers)] for number, powers in roots.minors],
    }


def _read_roots(data: Data) -> Roots:
    return Roots(
        root=data["root"],
        form=decode(data["form"]),
        eliminant=tuple(map(decode, data["eliminant"])),
        solved=tuple((name, decode(a), decode(b)) for name, a, b in data["solved"]),
        rows=_read_rows(data["cofactors"]),
        quotients=tuple(map(decode, data["quotients"])),
        factors=tuple(
            Factor(
                decode(entry["factor"]),
                _read_squares(entry["squares"]),
                tuple(map(decode, entry.get("cofactors", ()))),
                _read_granted(entry.get("granted")),
            )
            for entry in (_known(one, FACTOR) for one in data["factors"])
        ),
        minors=tuple(
            (decode(number), tuple(map(whole, powers))) for number, powers in data["minors"]
        ),
        point=_read_point(data["point"]),
    )


def _read_granted(data: Tree) -> tuple[int, Row] | None:
    if data is None:
        return None
    place, row = data
    return _index(place), tuple(map(decode, row))


def _index(data: Tree) -> int:
    if type(data) is not int or data < 0:
        raise FormatError("the place of something in a list is expected")
    return data
