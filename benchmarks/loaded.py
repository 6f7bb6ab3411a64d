"""How many lines of the package a paper loads that is decided with its certificates, by rooms.

python -m benchmarks.loaded [NAME]
"""

from __future__ import annotations

import subprocess
import sys
from collections import Counter
from pathlib import Path

PACKAGE = "kowalevski_cas"

DECIDE = f"""
import sys
from {PACKAGE}.library import find, load
from {PACKAGE}.verify.certificate import load_certificates
from {PACKAGE}.verify.record import load_record
from {PACKAGE}.verify.run import Session
name = sys.argv[1]
known = dict(certificates=load_certificates(find(name)), record=load_record(find(name)))
assert Session(load(name), ("flint",), **known).run().outcomes
files = ((module, getattr(sys.modules[module], "__file__", None)) for module in [*sys.modules])
print(*(f"{{module}} {{file}}" for module, file in files if file), sep="\\n")
"""


def loaded_lines(name: str) -> Counter[str]:
    """The lines of the modules that are loaded, by rooms."""
    command = [sys.executable, "-c", DECIDE, name]
    told = subprocess.run(command, capture_output=True, text=True, check=True).stdout
    lines = Counter[str]()
    for module, _, file in (row.partition(" ") for row in told.splitlines()):
        package, _, rest = module.partition(".")
        if package == PACKAGE:
            text = Path(file).read_text(encoding="utf-8")
            lines[rest.partition(".")[0] or package] += text.count("\n")
    return lines


def main() -> None:
    """Print a table."""
    lines = loaded_lines(*(sys.argv[1:] or ["kharlamov2002"]))
    for room, many in lines.most_common():
        print(f"{many:7} {room}")
    print(f"{lines.total():7} in all")


if __name__ == "__main__":
    main()
