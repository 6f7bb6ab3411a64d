"""Serve an agent by the model context protocol, on standard input and output.

It has four tools: audit a text, verify claims about equations of motion, find what nobody has
printed, and check a certificate. It needs pip install 'kowalevski-cas[agents]'.
"""

from __future__ import annotations

import argparse

from kowalevski_cas.cli.exits import AS_RECORDED


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The arguments of the command: none."""


def run(arguments: argparse.Namespace) -> int:
    """Run the command and return its exit code."""
    from kowalevski_cas.servers.agents import serve

    serve()
    return AS_RECORDED
