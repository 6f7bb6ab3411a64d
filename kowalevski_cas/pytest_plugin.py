"""Derivations as tests of pytest, one a claim: files called ``derivation_*.py``.

With ``--derivations`` those of installed packages too, which name their modules as entry points of
the group ``kowalevski_cas.derivations``. FLINT decides. A test fails if the verdict is another one
than the recorded or expected one; what cannot be loaded is a test that fails, and hides no other.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial
from importlib.metadata import entry_points
from pathlib import Path
from typing import Any

import pytest

from kowalevski_cas import UserError

GROUP = "kowalevski_cas.derivations"


def pytest_addoption(parser: pytest.Parser) -> None:
    """The option for installed packages."""
    parser.addoption("--derivations", action="store_true", help="test those that are installed")
    parser.addoption("--claim-timeout", type=float, default=60.0, help="seconds for a claim (60)")


def pytest_collect_file(file_path: Path, parent: pytest.Collector) -> pytest.Collector | None:
    """A file of a derivation."""
    found = file_path.match("derivation_*.py")
    return DerivationFile.from_parent(parent, path=file_path) if found else None


def pytest_collection_modifyitems(session: pytest.Session, items: list[pytest.Item]) -> None:
    """Add the derivations of installed packages."""
    for entry in entry_points(group=GROUP) if session.config.option.derivations else ():
        derivation = DerivationFile.from_parent(session, path=session.path, name=entry.value)
        items += session.genitems(derivation)


class DerivationFile(pytest.File):
    """A derivation in a file, or in a module by its name."""

    def collect(self) -> Iterator[ClaimItem]:
        """A test for each claim, or for what is wrong with all."""
        from kowalevski_cas.cli import session
        from kowalevski_cas.cli.verify import failure_text
        from kowalevski_cas.verify.certificate import load_certificates

        try:
            ((folder, derivation),) = session.derivations(
                [str(self.path) if self.path.is_file() else self.name]
            )
            stored = load_certificates(folder)
        except UserError as error:
            yield ClaimItem.from_parent(self, name="loading", said=partial(str, error))
            return
        seconds = self.config.option.claim_timeout
        for claim in derivation.claims:
            said = partial(failure_text, folder, derivation, stored, claim.id, seconds)
            yield ClaimItem.from_parent(self, name=claim.id, said=said)


class ClaimItem(pytest.Item):
    """A test, by what is said if it fails."""

    def __init__(self, said: Callable[[], str], **options: Any) -> None:
        super().__init__(**options)
        self.said = said

    def runtest(self) -> None:
        """Decide the claim."""
        try:
            said = self.said()
        except UserError as error:
            said = str(error)
        if said:
            pytest.fail(said, pytrace=False)

    def reportinfo(self) -> tuple[Path, None, str]:
        """The place of the test."""
        return self.path, None, self.name
