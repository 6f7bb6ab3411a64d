"""Serve an editor by the language server protocol, on standard input and output.

An editor starts it, and shows at each formula of a paper what the audit says, while one types:
diagnostics, the verdict and the point where a formula fails, corrections, and what rests on it.
It needs pip install 'kowalevski-cas[editor]'; the documentation says how editors are set up.
"""

from __future__ import annotations

import argparse

from kowalevski_cas.cli.exits import AS_RECORDED


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The arguments of the command: none."""


def run(arguments: argparse.Namespace) -> int:
    """Run the command and return its exit code."""
    from kowalevski_cas.servers.language import serve

    serve()
    return AS_RECORDED
