"""What the parts of an elaboration know of it, and of each other."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Callable, Sequence

from kowalevski_cas.notation import Formula
from kowalevski_cas.paper.radicals import Radicals
from kowalevski_cas.paper.scene import Scene
from kowalevski_cas.paper.texts import Printed, Texts
from kowalevski_cas.paper.transcendental import Transcendental
from kowalevski_cas.problem.evaluate import Evaluation
from kowalevski_cas.problem.space import Setting


class Meaning(Setting):
    """A setting that a scene means; what a name rests on is noted in ``places``."""

    scene: Scene
    texts: Texts
    places: dict[str, tuple[Printed, ...]]
    turning: dict[str, Formula] | None
    """The rates of variables in whose place others stand, when the field has been looked at."""

    zero: frozenset[str]
    """The names that are set to zero."""

    met: tuple[Formula, ...]
    """The formulas of a claim with functions that the scene itself does not print."""

    @property
    @abstractmethod
    def finder(self) -> Evaluation:
        """The setting in FLINT."""

    @property
    @abstractmethod
    def plain(self) -> Callable[[Formula], Formula]:
        """What writes a formula out in the operations of a space."""

    @property
    @abstractmethod
    def printed_field(self) -> list[Formula]:
        """The equations of motion as they are printed."""

    @property
    @abstractmethod
    def velocities(self) -> dict[str, str]:
        """The variables of which higher derivatives are printed, and those derivatives' names."""

    @property
    @abstractmethod
    def transcendental(self) -> Transcendental:
        """The variables that stand under sines, cosines and exponentials."""

    @property
    @abstractmethod
    def radicals(self) -> Radicals:
        """The variables and constants of which fractional powers stand here."""

    @abstractmethod
    def partial(self, formula: Formula, name: str) -> Formula:
        """The partial derivative of what is written out in the operations of a space."""

    @abstractmethod
    def definition(self, name: str) -> Formula:
        """The expression for which a name stands."""

    @abstractmethod
    def free(self, names: Sequence[str]) -> Evaluation:
        """The setting in FLINT with more variables, bound by nothing; a root may be one."""
