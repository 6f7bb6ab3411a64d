"""The theorems about one space of a certificate, and their proofs."""

from __future__ import annotations

import json
from itertools import combinations_with_replacement

from kowalevski_cas.export.format import Inexpressible, Json
from kowalevski_cas.export.rocq import points
from kowalevski_cas.export.rocq.facts import AT, Facts
from kowalevski_cas.export.rocq.space import Sides, Space


class Theorems:
    """What holds in one space: a section of the file, with its hypotheses."""

    def __init__(self, space: Space) -> None:
        self.space, self.k = space, space.k
        self.facts = Facts(space)
        self.names: list[str] = []
        self._texts: list[str] = []
        self._foundations()

    def text(self) -> str:
        """The section."""
        head = f"Section Claims_{self.k}.\nImport Space_{self.k}.\n"
        return "\n".join([head, self.facts.text(), *self._texts, f"End Claims_{self.k}.\n"])

    def part(self, name: str, part: Json) -> None:
        """State and prove one part of the certificate."""
        if '"conj"' in json.dumps([part, self.space.data]):
            self._conjugation()
        if part["shows"] == "differ":
            self._computed(name, points.differ(self.space, part))
        elif part["shows"] == "rank":
            self._computed(name, points.rank(self.space, part))
        elif part.get("given"):
            self._computed(f"{name}_not_vacuous", points.given(self.space, part))
            self._combinations(name, part)
        else:
            self._equal(name, self.space.sides(part["equations"]))

    # -- what has to hold of a space -----------------------------------------------

    def _foundations(self) -> None:
        """The vector field is the printed one; relations agree with it, and the conjugation."""
        space, k = self.space, self.k
        if "change" in space.data:
            self._change()
        printed = []
        for names, factor, right in space.data.get("field", []):
            rates = [["D", name] for name in names]
            printed.append(
                [["*", factor, ["vector", *rates] if len(rates) > 1 else rates[0]], right]
            )
        self._equal(f"field_{k}", space.sides(printed))
        if space.checked.rates:
            self._equal(f"moving_roots_{k}", _under("D", self._squares()))
        if "change" in space.data:
            self._conjugation()

    def _conjugation(self) -> None:
        """The conjugates of roots are roots of the conjugate squares."""
        name = f"conjugate_roots_{self.k}"
        if name not in self.names:
            self._equal(name, _under("conjugate", self._squares()))

    def _squares(self) -> list[Sides]:
        return [(f"{a} * {a}", b) for a, b in self.space.sides(self.space.squares.items())]

    def _change(self) -> None:
        """The inverse gives the variables back, and the vector field is the old one."""
        space, old, k = self.space, self.space.old, self.k
        module = f"Space_{old.k}."
        time = old.outside(space.data["change"]["time"])
        back, rates = [], []
        for name, tree in space.data["change"]["formulas"]:
            formula = old.outside(tree)
            back.append((f"subst back ({formula})", space.term(name)))
            rates.append(
                (f"subst back ({module}D ({formula}) * ({time}))", f"D {space.term(name)}")
            )
        for name, square in old.squares.items():
            own = f"{module}{old.words[name]}"
            back.append((f"subst back ({own} * {own})", f"subst back ({old.outside(square)})"))
        self._equal(f"back_{k}", back)
        if old.checked.rates:
            old_names = [f"{module}{old.words[name]}" for name in old.names]
            rates += [
                (f"D (subst back {own})", f"subst back ({module}D {own} * ({time}))")
                for own in old_names
            ]
            self._equal(f"chain_rule_{k}", rates)
        images = [f"subst back {module}{old.words[name]}" for name in old.data["variables"]]
        self._equal(f"real_{k}", [(f"conjugate ({image})", image) for image in images])

    # -- statements ----------------------------------------------------------------

    def _equal(self, name: str, pairs: list[Sides]) -> None:
        """Both sides of each pair have the same value."""
        if pairs:
            proof = [f"by_known_{self.k}."] * len(pairs)
            self._theorem(name, [], pairs, proof)

    def _combinations(self, name: str, part: Json) -> None:
        """Where some equations hold others do: they are combinations of them."""
        space = self.space
        if "product" in part:
            raise Inexpressible(
                "a split into cases needs real numbers, and these theorems are about any field"
            )
        given, pairs = space.sides(part["given"]), space.sides(part["equations"])
        if (root := part.get("root")) is not None:
            flip = f"subst {space.flip(root)}"
            both = combinations_with_replacement(pairs, 2)
            pairs = [(f"({a} - ({b})) * {flip} ({c} - ({d}))", "0") for (a, b), (c, d) in both]
        proof = []
        for (left, right), row in zip(pairs, part["cofactors"], strict=True):
            terms, holds = list[str](), "I"
            for k in reversed(range(len(given))):
                if row[k] != 0:
                    a, b = given[k]
                    terms.insert(0, f"({space.say(row[k])}, ({a}, {b}))")
                    holds = f"(conj G{k} {holds})"
            steps = f"apply (combined {AT} [{'; '.join(terms)}] ({left}) ({right}) {holds})"
            proof.append(f"{steps}; by_known_{self.k}.")
        self._theorem(name, given, pairs, proof)

    def _theorem(self, name: str, given: list[Sides], pairs: list[Sides], proof: list[str]) -> None:
        hypotheses = "".join(f"val ({a}) = val ({b}) ->\n  " for a, b in given)
        conclusion = " /\\\n  ".join(f"val ({a}) = val ({b})" for a, b in pairs)
        lines = [f"intros {' '.join(f'G{k}' for k in range(len(given)))}."] if given else []
        if len(proof) > 1:
            lines.append(f"refine {'(conj _ ' * (len(proof) - 1)}_{')' * (len(proof) - 1)}.")
            proof = [f"- {step}" for step in proof]
        self._add(name, hypotheses + conclusion, [*lines, *proof])

    def _computed(self, name: str, found: tuple[str, list[str]]) -> None:
        """There is a point, where something is computed to be so."""
        point, statements = found
        statement = "exists p : nat -> gauss,\n  " + " /\\\n  ".join(statements)
        self._add(name, statement, [f"exists (point {point}).", "vm_compute. repeat split."])

    def _add(self, name: str, statement: str, proof: list[str]) -> None:
        self.names.append(name)
        lines = "\n  ".join(proof)
        self._texts.append(f"Theorem {name} :\n  {statement}.\nProof.\n  {lines}\nQed.\n")


def _under(operation: str, pairs: list[Sides]) -> list[Sides]:
    return [(f"{operation} ({a})", f"{operation} ({b})") for a, b in pairs]
