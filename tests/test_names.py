"""One name for one thing: the glossary of classes, and what functions are called."""

import ast
from collections import defaultdict
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]

APART = ("problem/checker", "export")
"""Programs of their own: the checker imports nothing, an export speaks another language."""

SEVERAL = {"Arithmetic": "the arithmetic of a module, which is asked for by the name of the module"}
"""Names that several classes have, and what each of them is."""


def files():
    package = ROOT / "kowalevski_cas"
    apart = tuple(f"{package}/{folder}/" for folder in APART)
    for path in sorted([*package.rglob("*.py"), *(ROOT / "study").rglob("*.py")]):
        if not str(path).startswith(apart):
            yield path, ast.parse(path.read_text(encoding="utf-8"))


@pytest.fixture(scope="module")
def classes():
    """The modules of each class by its name."""
    found = defaultdict(list)
    for path, tree in files():
        for node in tree.body:
            if isinstance(node, ast.ClassDef):
                found[node.name].append(str(path.relative_to(ROOT)))
    return found


def test_a_name_of_a_class_means_one_thing(classes):
    twice = {name: places for name, places in classes.items() if len(places) > 1}
    assert not twice.keys() - SEVERAL.keys(), twice
    assert twice.keys() >= {*SEVERAL}, "strike out what has one meaning by now"
