"""The command ``python -m study``."""

import sys

from kowalevski_cas.cli import run

sys.exit(run("python -m study", "study.command", sys.argv[1:]))
