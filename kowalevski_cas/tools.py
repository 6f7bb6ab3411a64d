"""What takes part beside this program: what it is called, and how it is run."""

from __future__ import annotations

import shutil
from dataclasses import dataclass

from kowalevski_cas import UserError


class MissingTool(UserError):
    """A tool is not installed, or does not run; the message says what to do."""


@dataclass(frozen=True)
class Tool:
    """A computer algebra system or a proof assistant, which runs as a process of its own.

    Args:
        title: what its authors call it.
        calls: how it may be called; the first that is installed is taken.
        package: what has to be installed on Debian for it.
        reads: what certificates are written as for it.
        version: the arguments with which it tells its version, on the first line.
    """

    title: str
    calls: tuple[tuple[str, ...], ...]
    package: str
    reads: str
    version: tuple[str, ...] = ("--version",)

    def call(self) -> tuple[str, ...]:
        """How it is called on this machine.

        Raises:
            MissingTool: it is not installed.
        """
        for call in self.calls:
            if shutil.which(call[0]):
                return call
        names = " or ".join(call[0] for call in self.calls)
        raise MissingTool(
            f"{names} is not installed; on Debian or Ubuntu: apt-get install {self.package}"
        )


_OWN = "polynomial identities, and it differentiates by its own `{}`".format

TOOLS = {
    "rocq": Tool(
        "Rocq", (("coqc",), ("rocq", "compile")), "coq",
        "theorems, and it differentiates by itself and assumes no axioms",
    ),
    "singular": Tool("Singular", (("Singular",),), "singular-ui", _OWN("diff")),
    "pari": Tool("PARI/GP", (("gp",),), "pari-gp", _OWN("deriv"), ("--version-short",)),
    "maxima": Tool("Maxima", (("maxima",),), "maxima", _OWN("diff")),
}  # fmt: skip
"""The tools that can confirm certificates, in the order in which they are named.

Each has a module in :mod:`kowalevski_cas.export` with a class ``Program``.
"""

_LIBRARIES = {"flint": "FLINT", "symengine": "SymEngine", "sympy": "SymPy"}


def title(name: str) -> str:
    """What the authors of a tool or a library call it; another name stays as it is.

    >>> title("flint"), title("pari"), title("maple")
    ('FLINT', 'PARI/GP', 'maple')
    """
    return TOOLS[name].title if name in TOOLS else _LIBRARIES.get(name, name)
