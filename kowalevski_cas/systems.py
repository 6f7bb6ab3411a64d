"""What takes part beside this program: what it is called, and how it is run."""

from __future__ import annotations

import shutil
from dataclasses import dataclass


class MissingSystem(Exception):
    """A system is not installed, or does not run; the message says what to do."""


@dataclass(frozen=True)
class System:
    """A computer algebra system or a proof assistant, which runs as a process of its own.

    Args:
        title: what its authors call it.
        calls: how it may be called; the first that is installed is taken.
        package: what has to be installed on Debian for it.
        version: the arguments with which it tells its version, on the first line.
    """

    title: str
    calls: tuple[tuple[str, ...], ...]
    package: str
    version: tuple[str, ...] = ("--version",)

    def call(self) -> tuple[str, ...]:
        """How it is called on this machine.

        Raises:
            MissingSystem: it is not installed.
        """
        for call in self.calls:
            if shutil.which(call[0]):
                return call
        names = " or ".join(call[0] for call in self.calls)
        raise MissingSystem(
            f"{names} is not installed; on Debian or Ubuntu: apt-get install {self.package}"
        )


SYSTEMS = {
    "rocq": System("Rocq", (("coqc",), ("rocq", "compile")), "coq"),
    "singular": System("Singular", (("Singular",),), "singular-ui"),
    "pari": System("PARI/GP", (("gp",),), "pari-gp", ("--version-short",)),
    "maxima": System("Maxima", (("maxima",),), "maxima"),
}
"""The systems that can confirm certificates, in the order in which they are named."""

_LIBRARIES = {"flint": "FLINT", "symengine": "SymEngine", "sympy": "SymPy"}


def title(name: str) -> str:
    """What the authors of a system or a library call it; another name stays as it is.

    >>> title("flint"), title("pari"), title("maple")
    ('FLINT', 'PARI/GP', 'maple')
    """
    return SYSTEMS[name].title if name in SYSTEMS else _LIBRARIES.get(name, name)
