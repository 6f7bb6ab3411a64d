"""Imports go one way, and proving loads no library that the chosen arithmetic does not need."""

import ast
import subprocess
import sys
from importlib.util import resolve_name
from pathlib import Path

import pytest

from kowalevski_cas.algebra import EXACT, POINTS
from kowalevski_cas.library import available
from kowalevski_cas.paper.claims import MODULES
from kowalevski_cas.verify.counterexamples import OF_BRACKETS

ROOT = Path(__file__).parents[1]
LIBRARY = "kowalevski_cas"

ROOMS = (
    LIBRARY, "files", "schema", "limits", "exit_guard", "forkserver", "processes", "pool", "tools", "notation", "source", "algebra", "problem", "search", "paper", "library",
    "derivations", "verify", "reading", "questions", "pictures", "audit", "export", "report", "motion", "servers", "cli", "system", "notebook", "pytest_plugin", "__main__", "study",
    "benchmarks",
)  # fmt: skip
"""The rooms from the bottom to the top: each imports those before it."""


FRONT = {(LIBRARY, "system")}
"""What the package offers under its own name: types see it, and Python when it is asked for."""

LIBRARIES = {"flint", "symengine", "sympy", "numpy", "scipy", "matplotlib", "typst"}

NEEDED = {
    "flint": {"flint"},
    "symengine": {"flint", "symengine", "numpy"},  # its wrapper imports NumPy by itself
    "sympy": {"flint", "sympy"},
    "modular": {"flint"},
    "ball": {"flint"},
    "floating": {"flint", "numpy"},
}
"""What a scene says is derived with FLINT, and so is evidence found."""

ONLY = ["eq6", "eq12", "F2-prime", "eq18", "eq21"]

PROVE = """
import sys
from kowalevski_cas.library import find, load
from kowalevski_cas.verify.certificate import load_certificates
from kowalevski_cas.verify.run import Session
kept = load_certificates(find("kharlamov2002"))
run = Session(load("kharlamov2002"), (sys.argv[1],), certificates=kept).run(sys.argv[2:])
assert all(o.verdict.likely or o.correction is not None for o in run.outcomes), run.outcomes
print(*sys.modules)
"""


def modules(script, *arguments):
    """The modules that a script has loaded in a process of its own."""
    done = subprocess.run(
        [sys.executable, "-c", script, *arguments],
        capture_output=True, text=True, cwd=ROOT, check=True,
    )  # fmt: skip
    return set(done.stdout.split())


def test_importing_loads_no_library():
    loaded = modules(
        "import sys, kowalevski_cas.cli, kowalevski_cas.paper.claims,"
        "kowalevski_cas.report.contents, study, kowalevski_cas.pictures; print(*sys.modules)"
    )
    assert "kowalevski_cas" in loaded and not loaded & LIBRARIES


@pytest.mark.slow
@pytest.mark.parametrize("name", [*EXACT, *POINTS])
def test_proving_loads_what_its_arithmetic_needs_and_nothing_else(name):
    assert modules(PROVE, name, *ONLY) & LIBRARIES == NEEDED[name]


def test_proving_loads_nothing_that_only_shows_or_asks():
    loaded = modules(PROVE, "flint", *ONLY[:1])
    own = {room(name) for name in loaded if name.startswith(f"{LIBRARY}.")}
    assert own <= {*ROOMS[: ROOMS.index("verify") + 1]}
    assert loaded.isdisjoint(
        f"{LIBRARY}.notation.{name}" for name in ("mathml", "open", "sympy", "typst")
    )


DECIDE = """
import sys
from kowalevski_cas.library import find, load
from kowalevski_cas.verify.certificate import load_certificates
from kowalevski_cas.verify.record import load_record
from kowalevski_cas.verify.run import Session
known = {"certificates": load_certificates(find("kharlamov2002"))}
known["record"] = load_record(find("kharlamov2002"))
assert Session(load("kharlamov2002"), ("flint",), **known).run().outcomes
print(*sys.modules)
"""

SOUGHT = {"place", "points", "real"}
"""The points where a set is singular stand in no certificate; they are sought."""


@pytest.fixture(scope="module")
def decided():
    """The modules that are loaded when a paper is decided with its certificates."""
    return modules(DECIDE)


def test_deciding_with_certificates_searches_for_no_proof(decided):
    searching = {name for name in decided if name.startswith(f"{LIBRARY}.search.")}
    assert searching <= {f"{LIBRARY}.search.{name}" for name in SOUGHT}
    assert decided.isdisjoint(f"{LIBRARY}.verify.{name}" for name in ("blame", "repair", "screen"))


def test_a_kind_is_loaded_where_it_is_stated(decided):
    loaded = decided
    assert f"{LIBRARY}.paper.claims.critical_set" in loaded
    assert loaded.isdisjoint(f"{LIBRARY}.paper.claims.{kind}" for kind in ("maps", "poisson"))
    assert loaded.isdisjoint(f"{LIBRARY}.problem.{goal}" for goal in ("kernel", "along"))
    assert f"{LIBRARY}.algebra.elimination" not in loaded


def test_whether_a_claim_is_of_a_kind_is_asked_by_the_name_of_a_kind():
    texts = (path.read_text(encoding="utf-8") for path in (ROOT / LIBRARY).rglob("*.py"))
    nodes = (node for text in texts if "is_kind(" in text for node in ast.walk(ast.parse(text)))
    calls = (
        n for n in nodes if isinstance(n, ast.Call) and ast.unparse(n.func).endswith(".is_kind")
    )
    names = {arg.value for call in calls for arg in call.args if isinstance(arg, ast.Constant)}
    assert names and {*names, *OF_BRACKETS} <= {*MODULES}


# -- one way -----------------------------------------------------------------------


def statements(path):
    """The statements of a file of Python, wherever they stand."""
    waiting = [ast.parse(path.read_text(encoding="utf-8"))]
    while waiting:
        yield (node := waiting.pop())
        parts = (ast.stmt, ast.ExceptHandler, ast.match_case)
        waiting += [part for part in ast.iter_child_nodes(node) if isinstance(part, parts)]


def graph(root):
    """What each module below a folder imports, wherever in its file: the modules by name."""
    files = {}
    for path in (path for room in ROOMS for path in (root / room).rglob("*.py")):
        names = path.relative_to(root).with_suffix("").parts
        files[".".join(names[:-1] if names[-1] == "__init__" else names)] = path
    return {name: imported(name, path, files) for name, path in files.items()}


def imported(name, path, known):
    """The known modules that a file imports, other than itself."""
    package = name if path.name == "__init__.py" else name.rpartition(".")[0]
    found = set()
    for node in statements(path):
        if isinstance(node, ast.Import):
            found |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom):
            source = resolve_name("." * node.level + (node.module or ""), package)
            inside = (f"{source}.{alias.name}" for alias in node.names)
            found |= {module if module in known else source for module in inside}
    return found & known.keys() - {name}


def room(module):
    """The room of a module: the first name in the library, or another package beside it."""
    package, _, rest = module.partition(".")
    return rest.partition(".")[0] or package if package == LIBRARY else package


def upward(imports):
    """The rooms that import one which is not before them; the front door names what it opens."""
    pairs = {(room(a), room(b)) for a, found in imports.items() for b in found} - FRONT
    return {f"{a} -> {b}" for a, b in pairs if a != b and ROOMS.index(a) < ROOMS.index(b)}


def cycles(imports):
    """The files of a room that import each other, perhaps through others of this room."""

    def reached(start):
        found, waiting = set(), [start]
        while waiting:
            new = {b for b in imports[waiting.pop()] if room(b) == room(start)} - found
            found |= new
            waiting += new
        return found

    below = {name: reached(name) for name in imports}
    rings = {
        tuple(sorted(b for b in found if a in below[b])) for a, found in below.items() if a in found
    }
    return {f"{room(r[0])}: {' '.join(m.rpartition('.')[2] for m in r)}" for r in rings}


@pytest.fixture(scope="module")
def imports():
    return graph(ROOT)


def test_every_room_has_its_place(imports):
    assert {room(module) for module in imports} == set(ROOMS)


def test_imports_go_down(imports):
    assert upward(imports) == set()


def test_no_files_of_a_room_import_each_other(imports):
    assert cycles(imports) == set()


@pytest.mark.parametrize(
    "text",
    [
        "import kowalevski_cas.verify.record",
        "from kowalevski_cas.verify import record",
        "from kowalevski_cas.verify.record import dump",
        "from ..verify import record",
        "from ..verify.record import dump",
        "if TYPE_CHECKING:\n    from ..verify import record",
        "def function():\n    from kowalevski_cas.verify import record",
    ],
)
def test_an_import_is_seen_wherever_it_stands(tmp_path, text):
    for place, content in {
        "notation/__init__.py": "", "notation/reader.py": text, "verify/__init__.py": "",
        "verify/record.py": "from . import digest", "verify/digest.py": "import kowalevski_cas.verify.record",
    }.items():  # fmt: skip
        path = tmp_path / LIBRARY / place
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(content)
    assert upward(graph(tmp_path)) == {"notation -> verify"}
    assert cycles(graph(tmp_path)) == {"verify: digest record"}


# -- any derivation -----------------------------------------------------------------


def test_the_package_names_no_derivation():
    names = available()
    texts = (path.read_text(encoding="utf-8") for path in (ROOT / LIBRARY).rglob("*.py"))
    some = (text for text in texts if any(name in text for name in names))
    nodes = (node for text in some for node in ast.walk(ast.parse(text)))
    assert not [n.value for n in nodes if isinstance(n, ast.Constant) and n.value in names]
