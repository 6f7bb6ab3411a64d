"""The theorems about the spaces and goals of a certificate, and their proofs."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from itertools import combinations, product

from kowalevski_cas.export.format import RANKS, SOLUTIONS, Inexpressible, Json
from kowalevski_cas.export.rocq.facts import AT, Facts
from kowalevski_cas.export.rocq.points import Place
from kowalevski_cas.export.rocq.space import Sides, Space
from kowalevski_cas.problem.trees import Tree

REAL = "it needs real numbers, and these theorems are about any field: {}"


class Theorems:
    """Theorems under the same conditions: a section of the file, with its hypotheses."""

    def __init__(self, space: Space) -> None:
        self.space, self.label = space, space.label
        self.facts = Facts(space)
        self.names: list[str] = []
        self._texts: list[str] = []

    def text(self) -> str:
        """The section."""
        head = f"Section Claims_{self.label}.\nImport Space_{self.space.k}.\n"
        return "\n".join([head, self.facts.text(), *self._texts, f"End Claims_{self.label}.\n"])

    def equal(self, name: str, pairs: list[Sides]) -> None:
        """Both sides of each pair have the same value."""
        if pairs:
            self._theorem(name, [], pairs, [f"by_known_{self.label}."] * len(pairs))

    def combination_theorem(
        self, name: str, given: list[Sides], pairs: list[Sides], proof: Json
    ) -> None:
        """Where some equations hold others do: they are combinations of them, or their powers."""
        known, lemmas = [*given], list[str]()
        if "equal" in proof:
            raise Inexpressible(REAL.format("a proof takes the signs of roots"))
        while "product" in proof:
            (first, *more), *others = proof["product"]
            if more or others or "power" in proof:
                raise Inexpressible(REAL.format("a proof splits into cases"))
            sides, rows = (self.space.say(first), "0"), proof.get("cofactors", [[]])
            shown = self._proof_by_combination(known, sides, rows[0])
            lemmas.append(f"assert (G{len(known)} : val ({sides[0]}) = val (0)) by ({shown}).")
            known.append(sides)
            (proof,) = proof["cases"]
        power = proof.get("power", 1)
        if power > 1:
            pairs = [(f"({a} - ({b})) ^ {power}", "0") for a, b in pairs]
        rows = proof.get("cofactors", [[]] * len(pairs))
        both = zip(pairs, rows, strict=True)
        steps = [f"{self._proof_by_combination(known, sides, row)}." for sides, row in both]
        self._theorem(name, given, pairs, steps, lemmas)

    def _proof_by_combination(self, known: list[Sides], sides: Sides, row: Sequence[Tree]) -> str:
        """How both sides are equal: their difference is the combination that a row gives."""
        terms, holds = list[str](), "I"
        for k in reversed(range(len(row))):
            if row[k] != 0:
                a, b = known[k]
                terms.insert(0, f"({self.space.say(row[k])}, ({a}, {b}))")
                holds = f"(conj G{k} {holds})"
        left, right = sides
        combined = f"combined {AT} [{'; '.join(terms)}] ({left}) ({right}) {holds}"
        return f"apply ({combined}); by_known_{self.label}"

    def computation_theorem(self, name: str, place: Place) -> None:
        """There is a point, where something is computed to be so."""
        self._add(name, place.statement, place.proof)

    def _theorem(
        self,
        name: str,
        given: list[Sides],
        pairs: list[Sides],
        proof: list[str],
        lemmas: Iterable[str] = (),
    ) -> None:
        hypotheses = "".join(f"val ({a}) = val ({b}) ->\n  " for a, b in given)
        conclusion = " /\\\n  ".join(f"val ({a}) = val ({b})" for a, b in pairs)
        lines = [f"intros {' '.join(f'G{k}' for k in range(len(given)))}."] if given else []
        lines += lemmas
        if len(proof) > 1:
            lines.append(f"refine {'(conj _ ' * (len(proof) - 1)}_{')' * (len(proof) - 1)}.")
            proof = [f"- {step}" for step in proof]
        self._add(name, hypotheses + conclusion, [*lines, *proof])

    def _add(self, name: str, statement: str, proof: list[str]) -> None:
        self.names.append(name)
        lines = "\n  ".join(proof)
        self._texts.append(f"Theorem {name} :\n  {statement}.\nProof.\n  {lines}\nQed.\n")


# -- what has to hold of a space ---------------------------------------------------


def foundations(space: Space) -> Theorems:
    """The vector field is the printed one; relations agree with it, and the conjugation."""
    section, k = Theorems(space), space.k
    squares = [(f"{a} * {a}", b) for a, b in space.sides(space.squares.items())]
    if "change" in space.data:
        _change(section)
    printed = []
    for names, factor, right in space.data.get("field", []):
        rates: list[Tree] = [["D", name] for name in names]
        printed.append([["*", factor, ["vector", *rates] if rates[1:] else rates[0]], right])
    section.equal(f"field_{k}", space.sides(printed))
    steps = space.data.get("steps", [])
    section.equal(f"printed_{k}", space.sides(s[3] for s in steps if s[0] == "root" and s[3:]))
    if space.checked.rates is not None:
        moving = [
            (["*", base, ["D", name]], ["*", to, name, ["D", base]])
            for kind, name, base, *more in steps
            if kind == "power"
            for to in more
        ]
        section.equal(f"moving_roots_{k}", _under("D", squares) + space.sides(moving))
    if space.conjugated:
        real = [(["conj", base], base) for base in space.bases.values()]
        pairs = _under("conjugate", squares) + space.sides(real)
        section.equal(f"conjugate_roots_{k}", pairs)
    return section


def _change(section: Theorems) -> None:
    """The inverse gives the variables back, and the vector field is the old one."""
    space, old, k = section.space, section.space.old, section.space.k
    module = f"Space_{old.k}."
    time = old.outside(space.data["change"]["time"])
    back, rates = [], []
    for name, tree in space.data["change"]["formulas"]:
        formula = old.outside(tree)
        back.append((f"subst back ({formula})", space.term(name)))
        rates.append((f"subst back ({module}D ({formula}) * ({time}))", f"D {space.term(name)}"))
    for name, square in old.squares.items():
        own = f"{module}{old.words[name]}"
        back.append((f"subst back ({own} * {own})", f"subst back ({old.outside(square)})"))
    section.equal(f"back_{k}", back)
    images = {name: f"{module}{old.words[name]}" for name in old.names}
    section.equal(
        f"chain_rule_{k}",
        rates
        + [
            (f"D (subst back {own})", f"subst back ({module}D {own} * ({time}))")
            for own in images.values()
        ],
    )
    section.equal(
        f"real_{k}",
        [
            (f"conjugate (subst back {own})", f"subst back ({module}conjugate {own})")
            for own in images.values()
        ],
    )


def _under(operation: str, pairs: list[Sides]) -> list[Sides]:
    return [(f"{operation} ({a})", f"{operation} ({b})") for a, b in pairs]


# -- goals -------------------------------------------------------------------------


def follows(section: Theorems, name: str, goal: Json, evidence: Json) -> None:
    """Where the given equations hold, the products of one difference of each conclusion vanish."""
    space = section.space
    given, conclusions = space.sides(goal["given"]), [*map(space.sides, goal["conclusions"])]
    if given or not evidence["point"]["roots"]:
        place = Place(space, evidence["point"], given if conclusions else [])
        section.computation_theorem(f"{name}_not_vacuous", place)
    if len(conclusions) == 1:
        (pairs,) = conclusions
    else:  # without any conclusion this is the product of none, and no field has 1 = 0
        pairs = [
            (" * ".join(f"({a} - ({b}))" for a, b in choice) or "1", "0")
            for choice in product(*conclusions)
        ]
    space.checked.stating = False
    section.combination_theorem(name, given, pairs, evidence)


def fails(section: Theorems, name: str, goal: Json, evidence: Json) -> None:
    """There is a point of the given equations where an equation of each conclusion fails."""
    space = section.space
    given, conclusions = space.sides(goal["given"]), [*map(space.sides, goal["conclusions"])]
    place = Place(space, evidence["point"], given)
    for pairs in conclusions:
        place.fails(pairs)
    section.computation_theorem(name, place)


def _functions(goal: Json) -> list[Tree]:
    """The functions and left minus right sides of equations whose differentials are meant."""
    return [*goal["functions"], *(["+", a, ["-", b]] for a, b in goal["given"])]


def rank(section: Theorems, name: str, goal: Json, evidence: Json, sign: str = "true") -> None:
    """There is a point of the given equations where differentials are independent, so many."""
    space, trees = section.space, _functions(goal)
    given, functions = space.sides(goal["given"]), [f for tree in trees for f in space.parts(tree)]
    elements = [e for tree in trees for e in space.value(tree)]
    place = Place(space, evidence["point"], given)
    place.independent(functions, elements)
    place.statements.append(f"Nat.eqb {len(functions)} {goal['rank']} = {sign}")
    section.computation_theorem(name, place)


def no_rank(section: Theorems, name: str, goal: Json, evidence: Json) -> None:
    """Their number is another one, or all minors vanish where the given equations hold."""
    if "minors" not in evidence:
        rank(section, name, goal, evidence, "false")
        return
    space = section.space
    given, trees = space.sides(goal["given"]), _functions(goal)
    functions = [f for tree in trees for f in space.parts(tree)]
    words = [space.partial(v) for v in space.checked.variables]
    if len(functions) > len(words):
        raise Inexpressible("there are more differentials than variables, and nothing to compute")
    rows = [[f"{word} ({f})" for word in words] for f in functions]
    minors = [
        _determinant(rows, [*columns]) for columns in combinations(range(len(words)), len(rows))
    ]
    space.checked.stating = False
    section.combination_theorem(
        name, given, [(m, "0") for m in minors], {"cofactors": evidence["minors"]}
    )


def _determinant(rows: list[list[str]], columns: list[int]) -> str:
    """By expansion along the first row."""
    if not rows:
        return "1"
    row, *rest = rows
    terms = []
    for k, column in enumerate(columns):
        minor = _determinant(rest, columns[:k] + columns[k + 1 :])
        terms.append(f"{'-' if k % 2 else '+'} {row[column]} * ({minor})")
    return "0 " + " ".join(terms)


def _inexpressible(why: str) -> Callable[..., None]:
    def say(*_: object) -> None:
        raise Inexpressible(why)

    return say


KINDS: dict[str, tuple[Callable[..., None], Callable[..., None]]] = {
    "follows": (follows, fails),
    "fails": (fails, follows),
    "rank": (rank, no_rank),
    "count": (_inexpressible(REAL.format("real solutions are counted")),) * 2,
    "kernel": (_inexpressible(RANKS),) * 2,
    "along": (_inexpressible(SOLUTIONS),) * 2,
}
"""How goals are proved, and how they are denied."""


def instances(certificate: Json) -> Iterable[tuple[Json, Json, Json, bool]]:
    """Goals, their evidence, values for bound names, and whether they hold.

    Of a goal that something exists this is all that is said about the values found for it.
    """
    denied = certificate["sign"] == "denied"
    for k, evidence in enumerate(certificate["evidence"]):
        goal = certificate["goals"][evidence["goal"] if denied else k]
        if goal["goal"] != "exists":
            yield goal, evidence, {}, not denied
            continue
        if denied:
            raise Inexpressible("nothing can be said about all expressions")
        values = dict(evidence["values"])
        for inner, entry in zip(goal["goals"], evidence["evidence"], strict=True):
            yield inner, entry, values, True
