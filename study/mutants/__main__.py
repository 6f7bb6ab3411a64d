"""The command ``python -m study.mutants``."""

import sys

from kowalevski_cas.cli import run

if __name__ == "__main__":  # a worker imports the module as well
    sys.exit(run("python -m study.mutants", "study.mutants.command", sys.argv[1:]))
