"""Check files: a line says what each proves, or why it is rejected; with --full, all of it.

Exit codes: 0 all files are certified, 5 one is rejected, 6 there is none.
"""

import os

from .certificate import Certificate, check
from .reading import SIZE, Rejected, need, printable


def read(path: str) -> str:
    """The text of a file."""
    need(not os.path.exists(path) or os.path.isfile(path), "it is no file")
    try:
        with open(path, encoding="utf-8") as file:
            return file.read(SIZE)
    except (OSError, ValueError) as error:
        raise Rejected(f"it cannot be read: {type(error).__name__}") from None


def check_file(path: str, seen: set[tuple[str, str]]) -> Certificate:
    """What a file certifies, which has the name of the claim and is not among those seen."""
    found = check(read(path))
    need(os.path.basename(path) == f"{found.claim}.json", f"it is about {found.claim}")
    need((found.claim, found.digest) not in seen, "it was certified before")
    seen.add((found.claim, found.digest))
    return found


def main(arguments: list[str]) -> int:
    """Check files; the last line says how many are certified."""
    paths, seen = [a for a in arguments if a != "--full"], set[tuple[str, str]]()
    for path in paths:
        try:
            found = check_file(path, seen)
        except Rejected as error:
            print(f"REJECTED {printable(ascii(path))}: {error}")
            continue
        print(found.summary())
        for line in found.lines() if "--full" in arguments else ():
            print(line)
    print(f"CERTIFIED {len(seen)} of {len(paths)}")
    return 6 if not paths else 0 if len(seen) == len(paths) else 5
