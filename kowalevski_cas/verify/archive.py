"""Evidence that is known: certificates that are read in place of a search."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from typing import TypeVar

from kowalevski_cas.problem.examine import Unproved
from kowalevski_cas.problem.trees import FormatError
from kowalevski_cas.verify.certificate import Stored
from kowalevski_cas.verify.confirm import Disagreement
from kowalevski_cas.verify.statement import Statement, Verdicts

Result = TypeVar("Result")


class Archive:
    """Certificates by name; what one of them lacks is searched for."""

    def __init__(self, certificates: Mapping[str, Stored] | None = None) -> None:
        self.certificates = dict(certificates or {})
        self._rejected: dict[str, str] = {}

    def evidence(self, statement: Statement, name: str) -> Verdicts | None:
        """The evidence that is stored for a statement, or that a search finds."""
        stored = self.certificates.get(name)
        verdicts = None if stored is None else stored.verdicts(statement)
        return statement.search() if verdicts is None else verdicts

    def anew(self, statement: Statement, name: str, work: Callable[[], Result]) -> Result:
        """What comes of stored evidence; if that is rejected, which is told, of what is found."""
        try:
            return work()
        except (FormatError, Unproved, Disagreement) as error:
            stored = self.certificates.get(name)
            if stored is None or not stored.concerns(statement):
                raise
            said = f"{stored.path} is rejected: {error}; another one is sought"
            self._rejected[name] = said
            del self.certificates[name]
            return work()

    def rejections(self, names: Iterable[str]) -> str:
        """What is told of stored evidence that was not used, once."""
        return "\n".join(self._rejected.pop(name) for name in names if name in self._rejected)
