"""What is exported to Rocq compiles, rests on no axiom, and does not compile once it is false."""

import json
import shutil
import subprocess
from copy import deepcopy
from hashlib import sha256
from pathlib import Path

import pytest

from kowalevski_cas.cli import main
from kowalevski_cas.export import Inexpressible, load
from kowalevski_cas.export.rocq.terms import Terms
from kowalevski_cas.library import find
from kowalevski_cas.verify.certificate import load_certificates

ROCQ = load("rocq")
needs_rocq = pytest.mark.skipif(shutil.which("coqc") is None, reason="Rocq is not installed")


def slow_rocq(test):
    """A test that waits for Rocq: a quick run has one of what is true, and one of what is not."""
    return needs_rocq(pytest.mark.slow(test))


def certificate(claim, derivation="kharlamov2002"):
    return deepcopy(load_certificates(find(derivation))[claim].data)


@pytest.fixture(scope="module")
def rocq(tmp_path_factory, pytestconfig):
    """Let Rocq read a text; empty if it confirms all of it, and else what it objects to.

    What all theories share is compiled once for each version of it and of Rocq.
    """
    version = subprocess.run(["coqc", "--version"], capture_output=True, text=True).stdout
    known = sha256("".join([version, *ROCQ.shared().values()]).encode()).hexdigest()[:16]
    compiled = pytestconfig.rootpath / ".pytest_cache" / f"rocq-{known}"
    compiled.mkdir(parents=True, exist_ok=True)
    for name, text in ROCQ.shared().items():
        if not (compiled / name).with_suffix(".vo").exists():
            (compiled / name).write_text(text, encoding="utf-8")
            subprocess.run(["coqc", *ROCQ.arguments(compiled / name)], cwd=compiled, check=True)
    folder = shutil.copytree(compiled, tmp_path_factory.mktemp("rocq") / "theories")

    def read(name, text):
        (folder / name).write_text(text, encoding="utf-8")
        done = subprocess.run(
            ["coqc", *ROCQ.arguments(folder / name)], cwd=folder, capture_output=True, text=True
        )
        said = done.stdout + done.stderr
        return said if done.returncode else ROCQ.objection(text, done.stdout)

    return read


# -- what is true ---------------------------------------------------------------


@slow_rocq
def test_the_exported_theories_are_built_by_coq_makefile(small, tmp_path):
    assert main(["export", "rocq", str(small), "-o", str(tmp_path / "out")]) == 0
    folder = tmp_path / "out" / "kharlamov2002"
    make = "coq_makefile -f _CoqProject -o CoqMakefile && make -f CoqMakefile -j 2"
    subprocess.run(make, shell=True, cwd=folder, check=True, capture_output=True)
    assert {path.stem for path in folder.glob("*.vo")} == {path.stem for path in folder.glob("*.v")}


@needs_rocq
@pytest.mark.parametrize(
    "claim", ["eq7", *(pytest.param(c, marks=pytest.mark.slow) for c in ("eq21", "N4-dimension"))]
)
def test_a_combination_a_misprint_and_a_rank(rocq, claim):
    assert rocq("true.v", ROCQ.translate(certificate(claim))) == ""


@slow_rocq
def test_rocq_confirms_the_paper_save_what_needs_real_numbers(tmp_path):
    assert main(["witness", "rocq", "kharlamov2002", "-o", str(tmp_path)]) == 0
    said = json.loads((tmp_path / "kharlamov2002" / "rocq.json").read_text(encoding="utf-8"))
    assert said["failed"] == {}
    assert said["confirmed"] == {c: certificate(c)["digest"] for c in said["confirmed"]}
    left_out = load_certificates(find("kharlamov2002")).keys() - said["confirmed"].keys()
    assert left_out == {"corrected/critical-set", "equilibria", "redundant-integral"}


@slow_rocq
@pytest.mark.parametrize("claim", ["solution.2", "psi.1"])
def test_what_divides_by_a_polynomial_is_multiplied_by_it(rocq, claim):
    text = ROCQ.translate(certificate(claim, "kharlamov_savushkin2004"))
    assert "Definition under_goal_1_1 : table :=" in text
    assert rocq("multiplied.v", text) == ""


@slow_rocq
@pytest.mark.parametrize(
    "name",
    [
        "alternatives", "denied-alternatives", "denied-empty", "denied-fails", "denied-independence",
        "denied-minors", "denied-rank", "exponents", "invariant-relation", "last-multiplier",
    ],
)  # fmt: skip
def test_evidence_and_denials_of_each_kind(rocq, name):
    path = Path(__file__).parents[1] / f"problem/handwritten/{name}.json"
    data = json.loads(path.read_text(encoding="utf-8"))
    assert rocq("kind.v", ROCQ.translate(data)) == ""


@pytest.mark.parametrize(
    ("name", "reason"),
    [
        ("positive", "a proof splits into cases"),
        ("count", "real solutions are counted"),
        ("critical-set", "a proof splits into cases"),
        ("rank", "Gaussian"),
    ],
)
def test_what_cannot_be_said_is_named(name, reason):
    path = Path(__file__).parents[1] / f"problem/handwritten/{name}.json"
    with pytest.raises(Inexpressible, match=reason):
        ROCQ.translate(json.loads(path.read_text(encoding="utf-8")))


# -- what is false --------------------------------------------------------------


@slow_rocq
def test_multiplying_by_a_polynomial_makes_nothing_true(rocq):
    data = certificate("solution.2", "kharlamov_savushkin2004")
    (equations,) = data["goals"][0]["conclusions"]
    left, right = equations[0]
    equations[0] = [left, ["*", 2, right]]
    assert "Unable to unify" in rocq("multiplied_statement.v", ROCQ.translate(data))


@slow_rocq
def test_without_its_condition_a_polynomial_has_no_inverse(rocq):
    text = ROCQ.translate(certificate("solution.2", "kharlamov_savushkin2004"))
    (condition,) = (line for line in text.splitlines() if "Hypothesis nonzero_goal_1_0" in line)
    weaker = "Hypothesis nonzero_goal_1_0 : val 1 <> zero."
    assert "Unable to unify" in rocq("condition.v", text.replace(condition, weaker))


@slow_rocq
def test_what_the_derivative_of_a_root_is_divided_by_is_a_condition(rocq):
    text = ROCQ.translate(certificate("involution.2", "kharlamov_savushkin2004"))
    conditions = [line for line in text.splitlines() if "Hypothesis nonzero_goal_1_" in line]
    assert conditions and rocq("root.v", text) == ""
    for line in conditions:
        text = text.replace(line, f"{line.partition(':')[0]}: val 1 <> zero.")
    assert "Unable to unify" in rocq("root_condition.v", text)


def test_statements_are_not_empty():
    text = ROCQ.translate(certificate("eq7"))
    assert "Theorem claim_1 :" in text and "Theorem field_0 :" in text
    assert text.rstrip().endswith("Print Assumptions proved.")
    assert not {"Axiom", "Admitted", "admit", "Parameter"} & set(text.replace(".", " ").split())


@needs_rocq
def test_a_changed_statement_is_refused(rocq):
    data = certificate("corrected/eq21")
    (equations,) = data["goals"][0]["conclusions"]
    equations[0] = [equations[0][0], ["+", equations[0][1], 1]]
    assert "Unable to unify" in rocq("statement.v", ROCQ.translate(data))


@slow_rocq
def test_a_changed_vector_field_is_refused(rocq):
    data = certificate("eq6")
    field = data["spaces"][0]["field"]
    field[0][2] = ["-", field[0][2]]
    assert "Unable to unify" in rocq("field.v", ROCQ.translate(data))


@slow_rocq
def test_a_changed_cofactor_is_refused(rocq):
    data = certificate("eq16.2")
    row = data["evidence"][0]["cofactors"][0]
    place = next(k for k, entry in enumerate(row) if entry != 0)
    row[place] = ["*", 2, row[place]]
    assert "Unable to unify" in rocq("cofactor.v", ROCQ.translate(data))


@slow_rocq
def test_a_point_where_both_sides_are_equal_refutes_nothing(rocq):
    data = certificate("eq21")
    for equation in data["goals"][0]["conclusions"][0]:
        equation[1] = deepcopy(equation[0])
    assert "incomplete proof" in rocq("equal.v", ROCQ.translate(data))


@slow_rocq
def test_rocq_does_not_believe_the_derivative_that_is_printed(rocq):
    text = ROCQ.translate(certificate("eq6"))
    wrong = text.replace("along (each [", "along (each [1 + ", 1)
    assert "Unable to unify" in rocq("derivative.v", wrong)


@slow_rocq
def test_an_axiom_does_not_go_unnoticed(rocq):
    text = ROCQ.translate(certificate("eq4.1"))
    lemma = "Axiom believed : 1%nat = 2%nat.\nDefinition proved := (believed, "
    said = rocq("axiom.v", text.replace("Definition proved := (", lemma))
    assert said.startswith("the theorems are not closed") and "believed" in said


@pytest.mark.parametrize(
    "output", ["", "Axioms:\nx : nat", "Closed under the global context\nAxioms:\nx : nat"]
)
def test_only_the_words_of_rocq_count(output):
    assert ROCQ.objection("", output)


# -- how it is written -----------------------------------------------------------


def test_a_point_with_other_roots_is_named():
    data = certificate("eq21")
    data["evidence"][0]["point"]["roots"] = [2]
    with pytest.raises(Inexpressible, match="Gaussian"):
        ROCQ.translate(data)


class Unrooted(Terms):
    """Terms in which no root and no derivative stands."""

    def root(self, tree):
        raise AssertionError("there is no root here")

    def partial(self, name):
        raise AssertionError("nothing is differentiated here")


@pytest.mark.parametrize(
    ("tree", "text"),
    [
        (["+", "x", ["-", "y"]], "x - y"),
        (["+", "x", ["-", ["+", "y", 1]]], "x - (y + 1)"),
        (["*", ["+", "x", "y"], ["-", 2]], "(x + y) * - 2"),
        (["/", "x", ["*", "x", "y"], "y"], "x / (x * y) / y"),
        (["^", ["*", "x", "y"], 2], "(x * y) ^ 2"),
        (["*", ["/", 1, 2], ["D", "x"], ["conj", ["+", "x", "y"]]], "1 / 2 * D x * conjugate (x + y)"),
        (["dot", "u", ["cross", "u", ["vector", 1, 0, "y"]]], "dot u (cross u (1, 0, y))"),
        (["*", 2, "u"], "map3 (Mul 2) u"),
        (["/", "u", ["diag", 1, 2, 3]], "zip3 Div u (1, 2, 3)"),
    ],
)  # fmt: skip
def test_formulas_read_as_they_are_meant(tree, text):
    terms = Unrooted()
    for name in "xyu":
        terms.new_word(name)
    terms.wide.add("u")
    assert terms.term(tree) == text


def test_words_are_distinct_and_not_rocqs():
    names = [
        r"\omega_1^*",
        r"\omega_1_star",
        "in",
        "I",
        "v",
        "d_x",
        "nonzero_1",
        r"\sqrt{x_1x_2}",
        "D",
    ]
    terms = Unrooted()
    words = [terms.new_word(name) for name in names]
    assert len(set(words)) == len(names)
    assert not set(words) & {"in", "I", "v", "d_x", "nonzero_1", "D"}
    assert words[0] == "omega_1_star" and words[-2] == "sqrt_x_1x_2"
