"""The command that finds first integrals: what it finds is decided like any claim."""

import json
import os
from time import sleep

import pytest

from kowalevski_cas.cli import main
from kowalevski_cas.cli.find import _shorten
from kowalevski_cas.pool import Pool
from tests.sample import sampled

pytestmark = pytest.mark.usefixtures("here")

LORENZ = r"\dot x=\sigma(y-x),\quad \dot y=\rho x-y-xz,\quad \dot z=xy-bz"
CLOSURE = ["find", "closure", "kharlamov2002", "--scene"]
CASE = ["find", "integrals", "kharlamov2002", "--scene", "Kowalevski case"]


@pytest.fixture
def system(tmp_path):
    """Write a file with a system, and whatever is claimed of it; its name."""

    def system(field, claims=""):
        file = tmp_path / "system.py"
        head = f"from kowalevski_cas import System\nsystem = System(r'{field}')\n"
        file.write_text(head + claims, encoding="utf-8")
        return str(file)

    return system


@pytest.fixture
def asked(system, capsys):
    """Ask a question about a system; the lines that are printed."""

    def asked(question, field, *words):
        assert main(["find", question, system(field), *words]) == 0
        return capsys.readouterr().out.splitlines()

    return asked


def test_the_integrals_of_the_kowalevski_case_are_called_by_their_names(capsys):
    assert main([*CASE, "--degree", "4"]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert lines[0].endswith(":  α₁² + α₂² + α₃²")
    assert [line.rpartition(":  ")[2] for line in lines[3:5]] == ["H", "K"]
    assert lines[6] == (
        "proved  each polynomial first integral up to degree 4 is a polynomial in these"
    )
    assert all(line.startswith("proved  ") for line in lines[:-1])
    assert lines[-1] == "7 found; 7 certificates checked"


def test_what_is_long_is_cut_unless_all_is_asked_for():
    assert _shorten("x" * 401, False) == f"{'x' * 400} … (401 letters: -v shows all)"
    assert _shorten("x" * 400, False) == "x" * 400 and _shorten("x" * 401, True) == "x" * 401


def test_coefficients_in_the_constants(capsys):
    scene = ["find", "integrals", "kharlamov2002", "--scene", "general body"]
    assert main([*scene, "--format", "json"]) == 0
    found = json.loads(capsys.readouterr().out)["findings"]
    assert len(found) == 5
    assert {entry["verdict"] for entry in found} == {"proved"}
    assert r"\omega_1^2A_1" in found[3]["formulas"][0]


def test_a_degree_by_the_weights_of_the_motion(capsys):
    assert main([*CASE, "--degree", "2", "--weighted"]) == 0
    energy, every, number = capsys.readouterr().out.splitlines()
    assert energy.endswith(":  H") and number == "2 found; 2 certificates checked"
    assert "ω₁ has weight 1, ω₂ has weight 1, ω₃ has weight 1, α₁ has weight 2" in every


def test_a_field_without_an_integral_is_answered_none(asked):
    line, number = asked("integrals", LORENZ, "--degree", "5")
    assert number == "1 found; 1 certificate checked"
    assert line == (
        "proved  each polynomial first integral up to degree 5 is a constant, "
        "for almost all values of the constants"
    )


def test_a_search_that_finds_nothing_says_what_was_searched(asked):
    *_, number, said = asked("darboux", LORENZ, "--degree", "2")
    assert number == "0 found; 0 certificates checked"
    assert said == (
        "no polynomial up to degree 2 with F' = KF was found for constants in general position; "
        "--special tries special values too"
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


def test_what_holds_under_conditions_is_told_with_them(asked):
    euler = r"A\dot p=(B-C)qr, B\dot q=(C-A)rp, C\dot r=(A-B)pq"
    *lines, _ = asked("integrals", euler)
    assert {line.split()[0] for line in lines} == {"conditional"}
    assert all(", where A ≠ 0, B ≠ 0, C ≠ 0" in line for line in lines)
    *lines, _ = asked("integrals", r"\dot x=y, \dot y=-x")
    assert not any("where" in line for line in lines)


def test_a_function_and_its_derivative_define_an_invariant_set(capsys):
    assert main([*CLOSURE, "Kowalevski case", "J_1", "--order", "2"]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert lines[0].startswith("conditional  ")
    assert ":  ω₁² − ω₂² + α₁ − β₂ = 0, 2ω₁ω₂ω₃ + ω₃α₂ + " in lines[0]
    assert [line.split()[0] for line in lines[1:]] == ["conditional", "proved", "3"]


def test_the_constants_for_which_a_polynomial_divides_its_derivative(asked):
    lines = asked("parameters", LORENZ, "x^2+Az")
    assert [line.split()[0] for line in lines] == ["proved"] * 4 + ["4"]
    assert "only where σ = 0, or b = 2σ" in lines[1]
    assert "with K = −2σ where A = −2σ and b = 2σ" in lines[3]
    assert "proved  F' = KF for no values of the constants" in asked("parameters", LORENZ, "x+y^2")


@pytest.mark.parametrize(
    ("polynomial", "said"),
    [("x^2+y^2", "nothing is to be determined"), ("A", "no variable stands in the polynomial")],
)
def test_what_depends_on_no_unknown_is_no_question(system, capsys, polynomial, said):
    circle = system(r"\dot x=y,\quad \dot y=-x")
    assert main(["find", "parameters", circle, polynomial]) == 2
    assert said in capsys.readouterr().err


def test_cases_that_only_real_numbers_exclude(asked):
    lines = asked("parameters", r"\dot x=-y+x(1-x^2-y^2),\quad \dot y=x+y(1-x^2-y^2)", "x+Ay")
    assert "proved  F' = KF for no values of the constants" in lines


@pytest.mark.slow
def test_a_large_question_is_said_to_be_large_beforehand_and_what_was_found_in_time_is_kept(
    system, capsys, monkeypatch
):
    monkeypatch.undo()
    nahm = system(r"\dot x=yz,\quad \dot y=zx,\quad \dot z=xy")
    assert main(["find", "darboux", nahm, "--degree", "50", "--timeout", "0.5"]) == 3
    said = capsys.readouterr()
    assert "3 variables have 23426 monomials up to degree 50: the search ends before" in said.err
    *found, number = said.out.splitlines()
    assert number.startswith(f"{len(found)} found; ") and found
    assert main(["find", "integrals", nahm, "--degree", "25", "--timeout", "0.1"]) == 3
    said = capsys.readouterr().err
    assert "3 variables have 3276 monomials up to degree 25: it may take" in said
    assert "give it more time" in said


@pytest.mark.slow
def test_the_relations_of_the_paper_and_a_third_one_that_needs_no_condition(capsys):
    assert main([*CLOSURE, "complex variables", r"\theta\omega_3-Q_1", "--format", "json"]) == 0
    found = json.loads(capsys.readouterr().out)["findings"]
    assert [one["verdict"] for one in found] == ["conditional"] * 2 + ["proved"] * 4
    assert [len(one["formulas"]) for one in found] == [2, 1, 2, 3, 1, 1]
    assert "dimension 7" in found[2]["says"]
    assert found[4]["says"].startswith("the symmetric square of y'' = qy with $q=")


def test_darboux_polynomials_and_the_constants_for_which_there_are_some(asked):
    lines = asked("darboux", LORENZ, "--special")
    assert "proved  F' = KF with K = −2σ where b = 2σ:  d/dt(x² − 2zσ) = (−2σ)(x² − 2zσ)" in [
        line.replace("K=", "K = ") for line in lines
    ]
    assert lines[-1] == "4 found; 4 certificates checked"


TWO_FIELDS = ["find", "exponents", "kharlamov2002", "--scene", "Kowalevski case"]


@pytest.mark.slow
def test_kowalevski_exponents_of_two_fields(capsys):
    assert main([*TWO_FIELDS, "--format", "json"]) == 0
    weights, *found = json.loads(capsys.readouterr().out)["findings"]
    assert r"$\omega_3$ has weight 1, $\alpha_1$ has weight 2" in weights["says"]
    assert {one["verdict"] for one in (weights, *found)} == {"proved"}
    (principal,) = [one for one in found if ", principal" in one["says"]]
    numbers = ", ".join(f"${one}$" for one in (-1, 0, 0, 1, 2, 2, 3, 4, 4))
    assert principal["says"].endswith(f": exponents {numbers}, principal")
    assert any("is passed" in one for one in principal["computed"])
    assert [len(one["computed"]) for one in found] == [2] * len(found)


def test_the_steps_of_exponents_are_printed_only_if_they_are_asked_for(asked):
    field = r"\dot x=u,\quad \dot y=v,\quad \dot u=-2xy,\quad \dot v=-x^2-6y^2"
    short, full = asked("exponents", field), asked("exponents", field, "-v")
    assert max(map(len, short)) < 400 and "homogeneous" not in "".join(short[1:])
    assert [line.split()[0] for line in short[:4]] == ["proved", "proved", "computed", "computed"]
    assert all(long.startswith(line) for line, long in zip(short, full, strict=True))
    assert sum("det(" in line for line in full) == sum("balance" in line for line in short) == 2


def test_without_a_degree_the_largest_exponent_is_taken(asked):
    field = r"\dot a=2a(v-u),\; \dot b=2b(w-v),\; \dot u=2a,\; \dot v=2b-2a,\; \dot w=-2b"
    *found, every, _ = asked("integrals", field, "--weighted")
    assert len(found) == 3 and "up to degree 3 is a polynomial in these" in every


def test_the_painleve_test_of_the_lorenz_equations(asked, tmp_path):
    printed = "\n".join(asked("exponents", LORENZ, "--write"))
    assert (
        "passed where σ = 1/2, b = 1, ρ = 0, or σ = 1, b = 2, ρ = 1/9, or σ = 1/3, b = 0;"
        in printed
    )
    assert "are not critical here has weight 2 or 4" in printed
    assert "Painlev" not in (tmp_path / "system.py").read_text()


def test_an_integral_with_an_exponential_factor(asked):
    lines = asked("darboux", r"\dot x=x^2,\quad \dot y=y(1+x)", "--degree", "1")
    assert all(line.split()[0] in ("proved", "conditional") for line in lines[:-1])
    assert "so exp(1/x) is an exponential factor" in lines[2]
    assert "y exp(1/x) is constant along every motion" in lines[3]


@pytest.mark.parametrize("question", sampled(["integrals", "darboux"], 1))
def test_several_processes_print_what_one_does(asked, monkeypatch, question):
    monkeypatch.undo()
    field = r"\dot x=x(y-cz),\quad \dot y=y(z-x),\quad \dot z=z(cx-y)"
    one, three = (asked(question, field, "--degree", "3", "--jobs", jobs) for jobs in "13")
    assert one == three and len(one) > 2


@pytest.mark.slow
def test_a_cluster_prints_what_one_process_does(system, capfd):
    distributed = pytest.importorskip("distributed")
    words, printed = ["find", "darboux", system(LORENZ), "--degree", "3", "--special"], []
    cluster = distributed.LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None)
    with cluster:
        for more in ([], ["--scheduler", cluster.scheduler_address]):
            assert main([*words, *more]) == 0
            printed.append(capfd.readouterr().out)
    assert printed[0] == printed[1] and printed[0].endswith("7 found; 7 certificates checked\n")


@pytest.mark.slow
def test_a_search_goes_on_from_what_was_found_when_its_time_was_over(
    system, tmp_path, capsys, monkeypatch
):
    monkeypatch.undo()
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    monkeypatch.setattr("kowalevski_cas.pool.BATCH", 0)
    words = ["find", "darboux", system(LORENZ), "--degree", "4", "--special", "--jobs", "1"]
    old = tmp_path / "cache" / "kowalevski-cas" / "old"
    old.parent.mkdir(parents=True)
    old.touch()
    os.utime(old, (0, 0))
    keep = Pool._keep

    def kept(*found):
        keep(*found)
        sleep(60)

    with monkeypatch.context() as stalled:
        stalled.setattr(Pool, "_keep", kept)
        assert main([*words, "--timeout", "2"]) == 3
    assert not old.exists() and [*(tmp_path / "cache").rglob("*/*")]
    assert main([*words, "--timeout", "60"]) == 0
    assert capsys.readouterr().out.endswith("11 found; 11 certificates checked\n")
    assert not [*(tmp_path / "cache").rglob("*/*")]


def test_what_is_written_to_the_file_is_proved_there(system, capsys):
    file = system(r"\dot x=s(y-x),\quad \dot y=rx-y-xz,\quad \dot z=xy-2sz")
    for question in ("darboux", "integrals"):
        assert main(["find", question, file, "--write"]) == 0
    capsys.readouterr()
    assert main(["verify", file]) == 0
    assert "3 claims: " in capsys.readouterr().out
    assert main([*CASE, "--degree", "1", "--write"]) == 2
    assert "--write needs a file in which a System" in capsys.readouterr().err


@pytest.mark.slow
def test_what_has_constants_of_its_own_is_written_and_certified_too(system, tmp_path, capsys):
    file = system(r"\dot x=y,\quad \dot y=6x^2+c")
    assert main(["find", "exponents", file, "--write"]) == 0
    assert main(["find", "parameters", file, "y^2+Ax^3+Bx", "--write"]) == 0
    lines = (tmp_path / "system.py").read_text().splitlines()
    assert r"system.having('\\rho').states(" in lines[-5]
    assert "system.having('A', 'B', " in lines[-1]
    for command in ("verify", "record", "check"):
        assert main([command, file]) == 0
    assert "CERTIFIED 4 of 4" in capsys.readouterr().out


def test_what_is_found_is_certified(system, capsys):
    found = "system.find_closure('x')\nsystem.conditions('v^2+Ax^2')\n"
    file = system(r"\dot x=v,\quad \dot v=-kx", found)
    for command in ("record", "check"):
        assert main([command, file]) == 0
    assert "CERTIFIED 7 of 7" in capsys.readouterr().out
