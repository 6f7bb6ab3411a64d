"""The command that finds first integrals: what it finds is decided like any claim."""

import json
import os

import pytest

from kowalevski_cas.cli import main
from tests.sample import sampled

pytestmark = pytest.mark.usefixtures("here")

CLOSURE = ["find", "closure", "kharlamov2002", "--scene"]
CASE = ["find", "integrals", "kharlamov2002", "--scene", "Kowalevski case"]


def test_the_integrals_of_the_kowalevski_case_of_which_a_long_one_is_cut(capsys):
    assert main([*CASE, "--degree", "4"]) == 0
    lines = capsys.readouterr().out.splitlines()
    (cut,) = [line for line in lines if line.endswith(" letters: -v shows all)")]
    assert len(cut.partition(":  ")[2]) < 450
    assert lines[0].endswith(":  α₁² + α₂² + α₃²")
    assert lines[3].endswith(":  2ω₁² + 2ω₂² + ω₃² − 2α₁ − 2β₂")
    assert "each polynomial first integral up to degree 4 is a polynomial in these" in lines[6]
    assert all(line.startswith("proved  ") for line in lines[:-1])
    assert lines[-1] == "7 found"


def test_coefficients_in_the_constants(capsys):
    scene = ["find", "integrals", "kharlamov2002", "--scene", "general body"]
    assert main([*scene, "--format", "json"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert len(found) == 5
    assert {entry["verdict"] for entry in found} == {"proved"}
    assert r"\omega_1^2A_1" in found[3]["formulas"][0]


def test_a_degree_by_the_weights_of_the_motion(capsys):
    assert main([*CASE, "--degree", "2", "--weighted"]) == 0
    energy, every, number = capsys.readouterr().out.splitlines()
    assert energy.endswith(":  2ω₁² + 2ω₂² + ω₃² − 2α₁ − 2β₂") and number == "2 found"
    assert "ω₁ counts 1, ω₂ counts 1, ω₃ counts 1, α₁ counts 2" in every


def test_a_field_without_an_integral_is_answered_none(tmp_path, capsys):
    (tmp_path / "lorenz").mkdir()
    (tmp_path / "lorenz" / "__init__.py").write_text(LORENZ, encoding="utf-8")
    assert main(["find", "integrals", str(tmp_path / "lorenz"), "--degree", "5"]) == 0
    (line, number) = capsys.readouterr().out.splitlines()
    assert number == "1 found"
    assert line == (
        "proved  each polynomial first integral up to degree 5 is a constant, "
        "for almost all values of the constants"
    )


@pytest.mark.parametrize(
    ("words", "code", "said"),
    [
        (["find", "integrals", "kharlamov2002"], 6, "name a scene"),
        (["find", "integrals", "kharlamov2002", "--scene", "Kowalevski"], 6, "Kowalevski case"),
        (["find", "integrals", "nobody1900"], 2, "there is no derivation"),
        ([*CLOSURE, "Kowalevski case", "q_7"], 2, "q_7 is not declared here"),
        ([*CLOSURE, "Kowalevski case", "J_1-J_1"], 2, "the function vanishes identically"),
        (
            ["find", "integrals", "kharlamov2002", "--scene", "complex variables with the root"],
            2,
            "a root stands in the equations of motion",
        ),
    ],
)
def test_what_cannot_be_done_says_why(capsys, words, code, said):
    assert main(words) == code
    assert said in capsys.readouterr().err


def test_a_function_and_its_derivative_define_an_invariant_set(capsys):
    assert main([*CLOSURE, "Kowalevski case", "J_1", "--order", "2"]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert lines[0].startswith("conditional  ")
    assert ":  ω₁² − ω₂² + α₁ − β₂ = 0, 2ω₁ω₂ω₃ + ω₃α₂ + " in lines[0]
    assert [line.split()[0] for line in lines[1:]] == ["conditional", "proved", "3"]


def test_the_constants_for_which_a_polynomial_divides_its_derivative(capsys, tmp_path):
    field = r"\dot x=\sigma(y-x),\quad \dot y=\rho x-y-xz,\quad \dot z=xy-bz"
    file = tmp_path / "lorenz.py"
    file.write_text(
        f"from kowalevski_cas import System\nlorenz = System(r'{field}')\n"
        "lorenz.invariant('x=0', 'y=0')\n"
    )
    assert main(["find", "parameters", str(file), "x^2+Az"]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert [line.split()[0] for line in lines] == ["proved"] * 4 + ["4"]
    assert "only where σ = 0, or b = 2σ" in lines[1]
    assert "with K = −2σ where A = −2σ and b = 2σ" in lines[3]
    assert main(["find", "parameters", str(file), "x+y^2"]) == 0
    assert "for no values of the constants" in capsys.readouterr().out
    file.write_text(
        "from kowalevski_cas import System\ns = System(r'\\dot x=y,\\quad \\dot y=-x')\n"
    )
    assert main(["find", "parameters", str(file), "x^2+y^2"]) == 2
    assert "nothing is to be determined" in capsys.readouterr().err
    assert main(["find", "parameters", str(file), "A"]) == 2
    assert "no variable stands in the polynomial" in capsys.readouterr().err


def test_cases_that_only_real_numbers_exclude(capsys, tmp_path):
    file = tmp_path / "cycle.py"
    field = r"\dot x=-y+x(1-x^2-y^2),\quad \dot y=x+y(1-x^2-y^2)"
    file.write_text(f"from kowalevski_cas import System\ncycle = System(r'{field}')\n")
    assert main(["find", "parameters", str(file), "x+Ay"]) == 0
    assert "proved  F' = KF for no values of the constants" in capsys.readouterr().out


def test_a_large_question_is_said_to_be_large_beforehand_and_what_was_found_in_time_is_kept(
    tmp_path, capsys, monkeypatch
):
    monkeypatch.undo()
    file = tmp_path / "nahm.py"
    field = r"\dot x=yz,\quad \dot y=zx,\quad \dot z=xy"
    file.write_text(f"from kowalevski_cas import System\nnahm = System(r'{field}')\n")
    assert main(["find", "darboux", str(file), "--degree", "50", "--timeout", "0.5"]) == 3
    said = capsys.readouterr()
    assert "3 variables have 23426 monomials up to degree 50: the search ends before" in said.err
    *found, number = said.out.splitlines()
    assert number == f"{len(found)} found" != "0 found"
    assert main(["find", "integrals", str(file), "--degree", "25", "--timeout", "0.1"]) == 3
    said = capsys.readouterr().err
    assert "3 variables have 3276 monomials up to degree 25: it may take" in said
    assert "give it more time" in said


@pytest.mark.slow
def test_the_relations_of_the_paper_and_a_third_one_that_needs_no_condition(capsys):
    assert main([*CLOSURE, "complex variables", r"\theta\omega_3-Q_1", "--format", "json"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert [one["verdict"] for one in found] == ["conditional"] * 2 + ["proved"] * 4
    assert [len(one["formulas"]) for one in found] == [2, 1, 2, 3, 1, 1]
    assert "dimension 7" in found[2]["says"]
    assert found[4]["says"].startswith("the symmetric square of y'' = qy with $q=")


LORENZ = r"""
from kowalevski_cas.paper.claims import Identity
from kowalevski_cas.paper.derivation import Derivation, Scene, Section

section = Section("1", "The field")
motion = section.display(
    "motion", r"\dot x=\sigma(y-x),\quad \dot y=\rho x-y-xz,\quad \dot z=xy-bz"
)
scene = Scene("Lorenz").having(variables=("x", "y", "z"), constants=(r"\sigma", r"\rho", "b"))
section.states(Identity, motion[1], on=scene.moving(motion), says="the motion")
derivation = Derivation("lorenz", "Lorenz", "", "", (section,))
"""


def test_darboux_polynomials_and_the_constants_for_which_there_are_some(tmp_path, capsys):
    (tmp_path / "lorenz").mkdir()
    (tmp_path / "lorenz" / "__init__.py").write_text(LORENZ, encoding="utf-8")
    assert main(["find", "darboux", str(tmp_path / "lorenz"), "--special"]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert "proved  F' = KF with K = −2σ where b = 2σ:  d/dt(x² − 2zσ) = (−2σ)(x² − 2zσ)" in [
        line.replace("K=", "K = ") for line in lines
    ]
    assert lines[-1] == "4 found"


TWO_FIELDS = ["find", "exponents", "kharlamov2002", "--scene", "Kowalevski case"]


@pytest.mark.slow
def test_kowalevski_exponents_of_two_fields(capsys):
    assert main([*TWO_FIELDS, "--format", "json"]) == 0
    weights, *found = json.loads(capsys.readouterr().out)
    assert r"$\omega_3$ counts 1, $\alpha_1$ counts 2" in weights["says"]
    assert {one["verdict"] for one in (weights, *found)} == {"proved"}
    (principal,) = [one for one in found if ", principal" in one["says"]]
    assert principal["says"].endswith(": exponents -1, 0, 0, 1, 2, 2, 3, 4, 4, principal")
    assert any("is passed" in one for one in principal["computed"])
    assert [len(one["computed"]) for one in found] == [2] * len(found)


def test_the_steps_of_exponents_are_printed_only_if_they_are_asked_for(tmp_path, capsys):
    file = tmp_path / "henon_heiles.py"
    field = r"\dot x=u,\quad \dot y=v,\quad \dot u=-2xy,\quad \dot v=-x^2-6y^2"
    file.write_text(f"from kowalevski_cas import System\nheiles = System(r'{field}')\n")
    words = ["find", "exponents", str(file)]
    assert main(words) == 0
    short = capsys.readouterr().out.splitlines()
    assert max(map(len, short)) < 400 and "counts" not in "".join(short[1:])
    assert [line.split()[0] for line in short[:4]] == ["proved", "proved", "computed", "computed"]
    assert main([*words, "-v"]) == 0
    full = capsys.readouterr().out.splitlines()
    assert all(long.startswith(line) for line, long in zip(short, full, strict=True))
    assert sum("det(" in line for line in full) == sum("balance" in line for line in short) == 2


def test_without_a_degree_the_largest_exponent_is_taken(tmp_path, capsys):
    file = tmp_path / "toda.py"
    field = r"\dot a=2a(v-u),\; \dot b=2b(w-v),\; \dot u=2a,\; \dot v=2b-2a,\; \dot w=-2b"
    file.write_text(f"from kowalevski_cas import System\ntoda = System(r'{field}')\n")
    assert main(["find", "integrals", str(file), "--weighted"]) == 0
    *found, every, _ = capsys.readouterr().out.splitlines()
    assert len(found) == 3 and "up to degree 3 is a polynomial in these" in every


def test_the_painleve_test_of_the_lorenz_equations(tmp_path, capsys):
    file = tmp_path / "lorenz.py"
    field = r"\dot x=\sigma(y-x),\quad \dot y=\rho x-y-xz,\quad \dot z=xy-bz"
    file.write_text(f"from kowalevski_cas import System\nlorenz = System(r'{field}')\n")
    assert main(["find", "exponents", str(file), "--write"]) == 0
    printed = capsys.readouterr().out
    assert (
        "passed where σ = 1/2, b = 1, ρ = 0, or σ = 1, b = 2, ρ = 1/9, or σ = 1/3, b = 0;"
        in printed
    )
    assert "are not critical here has weight 2 or 4" in printed
    assert "Painlev" not in file.read_text()


def test_an_integral_with_an_exponential_factor(tmp_path, capsys):
    file = tmp_path / "node.py"
    field = r"\dot x=x^2,\quad \dot y=y(1+x)"
    file.write_text(f"from kowalevski_cas import System\nnode = System(r'{field}')\n")
    assert main(["find", "darboux", str(file), "--degree", "1"]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert all(line.split()[0] in ("proved", "conditional") for line in lines[:-1])
    assert "so exp(1/x) is an exponential factor" in lines[2]
    assert "y exp(1/x) is constant along every motion" in lines[3]


@pytest.mark.parametrize("question", sampled(["integrals", "darboux"], 1))
def test_several_processes_print_what_one_does(tmp_path, capsys, monkeypatch, question):
    monkeypatch.undo()
    file = tmp_path / "volterra.py"
    field = r"\dot x=x(y-cz),\quad \dot y=y(z-x),\quad \dot z=z(cx-y)"
    file.write_text(f"from kowalevski_cas import System\nchain = System(r'{field}')\n")
    printed = []
    for jobs in ("1", "3"):
        assert main(["find", question, str(file), "--degree", "3", "--jobs", jobs]) == 0
        printed.append(capsys.readouterr().out)
    assert printed[0] == printed[1] and int(printed[0].split()[-2]) > 1


@pytest.mark.slow
def test_a_cluster_prints_what_one_process_does(tmp_path, capfd):
    distributed = pytest.importorskip("distributed")
    file = tmp_path / "lorenz.py"
    field = r"\dot x=s(y-x),\quad \dot y=rx-y-xz,\quad \dot z=xy-bz"
    file.write_text(f"from kowalevski_cas import System\nlorenz = System(r'{field}')\n")
    words, printed = ["find", "darboux", str(file), "--degree", "3", "--special"], []
    cluster = distributed.LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None)
    with cluster:
        for more in ([], ["--scheduler", cluster.scheduler_address]):
            assert main([*words, *more]) == 0
            printed.append(capfd.readouterr().out)
    assert printed[0] == printed[1] and printed[0].endswith("7 found\n")


@pytest.mark.slow
def test_a_search_goes_on_from_what_was_found_when_its_time_was_over(tmp_path, capsys, monkeypatch):
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    monkeypatch.setattr("kowalevski_cas.pool.BATCH", 0)
    file = tmp_path / "lorenz.py"
    field = r"\dot x=s(y-x),\quad \dot y=rx-y-xz,\quad \dot z=xy-bz"
    file.write_text(f"from kowalevski_cas import System\nlorenz = System(r'{field}')\n")
    words = ["find", "darboux", str(file), "--degree", "4", "--special", "--jobs", "1"]
    old = tmp_path / "cache" / "kowalevski-cas" / "old"
    old.parent.mkdir(parents=True)
    old.touch()
    os.utime(old, (0, 0))
    assert main([*words, "--timeout", "1"]) == 3
    assert not old.exists() and [*(tmp_path / "cache").rglob("*/*")]
    assert main([*words, "--timeout", "60"]) == 0
    assert capsys.readouterr().out.endswith("11 found\n")
    assert not [*(tmp_path / "cache").rglob("*/*")]


def test_what_is_written_to_the_file_is_proved_there(tmp_path, capsys):
    file = tmp_path / "special.py"
    field = r"\dot x=s(y-x),\quad \dot y=rx-y-xz,\quad \dot z=xy-2sz"
    file.write_text(f"from kowalevski_cas import System\nspecial = System(r'{field}')\n")
    for question in ("darboux", "integrals"):
        assert main(["find", question, str(file), "--write"]) == 0
    capsys.readouterr()
    assert main(["verify", str(file)]) == 0
    assert "3 claims: " in capsys.readouterr().out
    assert main([*CASE, "--degree", "1", "--write"]) == 2
    assert "--write needs a file in which a System" in capsys.readouterr().err


def test_what_has_constants_of_its_own_is_written_and_certified_too(tmp_path, capsys):
    file = tmp_path / "found.py"
    field = r"\dot x=y,\quad \dot y=6x^2+c"
    file.write_text(f"from kowalevski_cas import System\nelliptic = System(r'{field}')\n")
    assert main(["find", "exponents", str(file), "--write"]) == 0
    assert main(["find", "parameters", str(file), "y^2+Ax^3+Bx", "--write"]) == 0
    lines = file.read_text().splitlines()
    assert r"elliptic.having('\\rho').states(" in lines[-5]
    assert "elliptic.having('A', 'B', " in lines[-1]
    for command in ("verify", "record", "check"):
        assert main([command, str(file)]) == 0
    assert "CERTIFIED 4 of 4" in capsys.readouterr().out


def test_what_is_found_is_certified(capsys, tmp_path):
    file = tmp_path / "oscillator.py"
    file.write_text(
        "from kowalevski_cas import System\n"
        "top = System(r'\\dot x=v,\\quad \\dot v=-kx')\n"
        "top.find_closure('x')\ntop.conditions('v^2+Ax^2')\n"
    )
    assert main(["record", str(file)]) == 0
    assert main(["check", str(file)]) == 0
    assert "CERTIFIED 7 of 7" in capsys.readouterr().out
