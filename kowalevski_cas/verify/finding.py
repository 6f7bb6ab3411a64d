"""What a search has found, as claims like any other."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field, fields
from typing import Any

from kowalevski_cas.paper.claims import Claim
from kowalevski_cas.paper.derivation import Derivation, Section
from kowalevski_cas.paper.scene import Scene
from kowalevski_cas.paper.texts import Printed

Attribute = str | int | tuple[str, ...] | tuple[int, ...] | tuple[tuple[str, ...], ...]


@dataclass(frozen=True)
class Finding:
    """A claim of some kind whose formulas are found, and stand in no paper.

    ``tex`` is the one formula of the claim, if it has one. TeX among the ``attributes`` becomes
    places where the kind declares them; the same TeX is the same place. If the formula is only how
    the words are seen to hold, it is of ``steps``. What is ``computed`` besides is stated by no
    claim.
    """

    kind: type[Claim]
    on: Scene
    says: str
    tex: str = ""
    attributes: Mapping[str, Attribute] = field(default_factory=dict)
    steps: bool = False
    computed: tuple[str, ...] = ()

    def claim(self, id: str, place: Callable[[Any], Printed]) -> Claim:
        """The claim with this id; ``place`` says where a formula stands."""

        def put_places(value: Any) -> Any:
            if isinstance(value, tuple):
                return tuple(map(put_places, value))
            return value if isinstance(value, int) else place(value)

        of_places = {field.name for field in fields(self.kind) if "Printed" in str(field.type)}
        attributes: dict[str, Any] = {
            name: put_places(value) if name in of_places else value
            for name, value in self.attributes.items()
        }
        printed = None if self.tex == "" else place(self.tex)
        return self.kind(id, self.on, self.says, printed=printed, **attributes)

    def python(self, system: str, scene: Scene) -> str:
        """The line that claims it in a file, of a system with this name there and this scene.

        It is empty if what was found is about no such motion: a file has no words for that.
        """
        if self.on.field != scene.field:
            return ""
        letters = [repr(name) for name in self.on.constants if name not in scene.constants]
        if letters:
            system = f"{system}.having({', '.join(letters)})"
        words = [self.kind.__name__, '"found"', repr(self.says)]
        words += [f"printed={_quote(self.tex)}"] if self.tex else []
        words += [f"{name}={_quote(value)}" for name, value in self.attributes.items()]
        return f"{system}.states({', '.join(words)})"


def _quote(value: Attribute) -> str:
    """A value in Python, with TeX as it stands."""
    if isinstance(value, tuple):
        return f"({''.join(f'{_quote(member)}, ' for member in value)})"
    return f'r"{value}"' if isinstance(value, str) and '"' not in value else repr(value)


def with_findings(derivation: Derivation, findings: Iterable[Finding]) -> Derivation:
    """A derivation that rests on another one and claims what was found."""
    section = Section("1", "What was found", copied=False)
    places: dict[str, Printed] = {}

    def place(tex: str) -> Printed:
        if tex not in places:
            id = f"formula-{len(places) + 1}"
            places[tex] = section.lemma(id, tex, "found by the program")[1]
        return places[tex]

    for number, finding in enumerate(findings, 1):
        section.claim(finding.claim(f"found-{number}", place))
    return Derivation(
        derivation.name, f"Found in {derivation.name}", "", "", (section,), rests_on=(derivation,)
    )
