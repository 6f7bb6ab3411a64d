"""The command motion: its formats, its methods, and a message for every wrong use."""

import csv
import io
import json
import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from kowalevski_cas.cli import main
from kowalevski_cas.motion import METHODS, Motion
from kowalevski_cas.motion.methods.ball import enclosures
from tests.sample import sampled

pytestmark = pytest.mark.usefixtures("here")

FIELDS = ["--a", "1", "--b", "0.4"]
USUAL = [*FIELDS, "--m", "0.8", "--l", "0.9", "--until", "2", "--samples", "5"]
HUGE = "--b 4e59 --m 8e-61 --l 0.9 --until 1e-29".split()


@pytest.fixture
def cli(capsys):
    def cli(*arguments):
        try:
            code = main(["motion", *map(str, arguments)])
        except SystemExit as stopped:
            code = stopped.code
        out, err = capsys.readouterr()
        assert "Traceback" not in out + err
        return code, out, err

    return cli


def states(text):
    return np.array([[*s["omega"], *s["alpha"], *s["beta"]] for s in json.loads(text)["states"]])


def test_a_table_is_as_wide_as_a_terminal_and_says_what_json_says(cli):
    _, table, _ = cli(*USUAL, "--format", "table")
    head, *lines = table.splitlines()
    assert head.split()[:2] == ["t", "ω₁"] and len(head) == 80
    for line, state in zip(lines[:5], json.loads(cli(*USUAL)[1])["states"], strict=True):
        row = [state["t"], *state["omega"], *state["alpha"], *state["beta"]]
        assert len(line) == 80
        assert [float(word) for word in line.split()] == pytest.approx(row, abs=5.1e-5)


def test_json_has_states_invariants_and_regime(cli):
    code, out, _ = cli(*USUAL)
    result = json.loads(out)
    assert code == 0 and [*result][2:] == ["states", "invariants", "critical_sets", "regime"]
    assert [state["t"] for state in result["states"]] == [0, 0.5, 1, 1.5, 2]
    assert all(len(s[name]) == 3 for s in result["states"] for name in ("omega", "alpha", "beta"))
    assert result["invariants"]["h"] == -1.04675 and result["invariants"]["l"] == 0.9
    assert max(result["invariants"]["drift"].values()) < 1e-14
    assert result["regime"]["order"] == "m > 0, -a < -b < C < b < a < A"
    assert result["regime"]["tori"] == 1


@pytest.mark.parametrize("method", [m for m in METHODS if m != "taylor"])
def test_every_method_follows_the_same_motion(cli, method):
    code, out, _ = cli(*USUAL, "--method", method)
    assert code == 0
    assert np.max(np.abs(states(out) - states(cli(*USUAL)[1]))) < 1e-10


def test_taylor_follows_it_too_or_says_what_to_install(cli):
    code, out, err = cli(*USUAL, "--method", "taylor")
    if code:
        assert code == 2 and "pip install 'kowalevski-cas[taylor]'" in err
    else:
        assert np.max(np.abs(states(out) - states(cli(*USUAL)[1]))) < 1e-12


@pytest.mark.slow
@pytest.mark.parametrize(
    ("missing", "command", "extra"),
    sampled(
        [
            ("numpy", ["motion", *USUAL], "motion"),
            ("scipy", ["motion", *USUAL, "--method", "dop853"], "motion"),
            ("heyoka", ["motion", *USUAL, "--method", "taylor"], "taylor"),
            ("numpy", ["verify", "kharlamov2002", "--arithmetic", "floating"], "motion"),
            ("matplotlib", ["pictures", "rectangle"], "motion"),
            ("matplotlib", ["animation"], "motion"),
        ],
        1,
        seed=1,
    ),
)
def test_a_library_that_is_not_installed_is_named_with_its_extra(missing, command, extra, tmp_path):
    done = without(missing, command, tmp_path)
    said = f"kowalevski-cas {command[0]} needs {missing}: pip install 'kowalevski-cas[{extra}]'\n"
    assert (done.returncode, done.stdout, done.stderr) == (2, "", said)


def without(missing, command, folder):
    """A command, where a library is not installed."""
    blocked = "import sys; sys.modules[sys.argv.pop(1)] = None; import kowalevski_cas.cli as cli"
    return subprocess.run(
        [sys.executable, "-c", f"{blocked}; sys.exit(cli.main())", missing, *command],
        capture_output=True, text=True, cwd=folder, check=False,
        env={**os.environ, "PYTHONPATH": str(Path(__file__).parents[2])},
    )  # fmt: skip


def test_help_speaks_of_a_command_whose_library_is_not_installed(tmp_path):
    done = without("numpy", ["motion", "--help"], tmp_path)
    assert done.returncode == 0 and "Follow a motion: the states at equal steps" in done.stdout
    assert "where there is numpy: pip install 'kowalevski-cas[motion]'" in done.stdout


def test_csv_and_npz_hold_the_same_states(cli, tmp_path):
    expected = states(cli(*USUAL)[1])
    header, *rows = csv.reader(io.StringIO(cli(*USUAL, "--format", "csv")[1]))
    assert header[:4] == ["t", "omega1", "omega2", "omega3"]
    assert np.array_equal(np.array(rows, dtype=float)[:, 1:], expected)
    code, out, _ = cli(*USUAL, "--format", "npz", "--output", tmp_path / "new")
    assert code == 0 and out.strip() == str(tmp_path / "new" / "motion.npz")
    with np.load(tmp_path / "new" / "motion.npz") as saved:
        assert np.array_equal(np.hstack([saved[n] for n in ("omega", "alpha", "beta")]), expected)
        assert json.loads(str(saved["regime"]))["tori"] == 1


@pytest.mark.parametrize("constants", [["0.8", "0.9"], ["-0.5", "0"], ["5/7", "3/7"]])
def test_balls_have_radii_in_every_format(cli, constants, tmp_path):
    m, ell = constants
    given = [*FIELDS, "--m", m, "--l", ell, "--samples", 5, "--method", "ball"]
    out = cli(*given)[1]
    radii = [state["radius"] for state in json.loads(out)["states"]]
    assert len(radii) == 5 and all(0 <= radius < 1e-15 for radius in radii)
    exact = enclosures(Motion.of(1, "0.4", m, ell=ell), np.linspace(0, 10, 5).tolist(), 200)
    for row, radius, balls in zip(states(out).tolist(), radii, exact, strict=True):
        assert all(abs(x - number) <= radius for x, number in zip(balls, row, strict=True))
    header, *rows = csv.reader(io.StringIO(cli(*given, "--format", "csv")[1]))
    assert header[-1] == "radius" and [float(row[-1]) for row in rows] == radii
    cli(*given, "--format", "npz", "--output", tmp_path)
    with np.load(tmp_path / "motion.npz") as saved:
        assert saved["radius"].tolist() == radii


@pytest.mark.parametrize("method", ["closed", "ball", "dop853"])
@pytest.mark.parametrize("nine", sampled(["000100040", "300100040", "010100040"], 1))
def test_a_zero_has_no_sign_and_what_may_be_zero_is_zero(cli, method, nine):
    given = ["--point", *nine, "--samples", 4, "--method", method]
    code, out, _ = cli(*given)
    assert code == 0
    assert "-0.0," not in cli(*given, "--format", "csv")[1] + out and "-0.0]" not in out
    assert np.all((states(out) == 0) | (np.abs(states(out)) > 1e-17))


def test_a_point_is_returned_to_at_once(cli):
    point = states(cli(*USUAL)[1])[3]
    for given in (map(repr, point.tolist()), [",".join(map(repr, point.tolist()))]):
        code, out, _ = cli("--point", *given, "--samples", 1)
        assert code == 0
        assert np.max(np.abs(states(out)[0] - point)) < 1e-14
        assert json.loads(out)["invariants"]["l"] == pytest.approx(0.9, rel=1e-14)


@pytest.mark.parametrize("power", sampled(range(-12, -8), 1))
def test_a_point_that_is_not_quite_returned_to_is_said(cli, power):
    point = states(cli(*USUAL)[1])[3]
    point[4] += 10.0**power
    given = ["--point", *map(repr, point.tolist()), "--samples", 1]
    code, out, err = cli(*given)
    off = json.loads(out)["invariants"]["off"]
    said = "dop853 follows it; --method closed begins"
    assert code == 0 and f"{said} {off:.3g} of its size away" in err
    assert 10.0 ** (power - 2) < off < 10.0 ** (power + 2)
    assert cli(*given, "--method", "dop853")[2] == ""


def test_a_point_off_all_three_sets_is_followed_by_an_integrator(cli):
    code, out, _ = cli("--point", *"123456789", "--until", 1, "--samples", 3)
    result = json.loads(out)
    assert code == 0 and states(out)[0].tolist() == list(range(1, 10))
    assert result["critical_sets"]["on"] == []
    assert min(result["critical_sets"]["residuals"]["largest"].values()) > 0.01
    assert max(result["invariants"]["drift"].values()) < 1e-6
    assert result["regime"]["none"].startswith("the state is not on N⁴")


def test_fields_at_any_angle_and_in_any_order(cli):
    given = ["--a", "1", "--b", "2", "--c", "-1/2", "--m", "-0.2", "--l", "0.3", "--torus", "1"]
    code, out, _ = cli(*given, "--origins", "1/3", "0", "--samples", 2)
    alpha, beta = states(out)[1].reshape(3, 3)[1:]
    assert code == 0
    assert (alpha @ alpha, beta @ beta, alpha @ beta) == pytest.approx((1, 4, -0.5), abs=1e-14)
    assert json.loads(out)["critical_sets"]["on"] == ["N4"]


def test_constants_of_O4_give_a_motion_there_in_fields_at_any_angle(cli):
    given = ["--a", "0.7", "--b", "1.2", "--c", "0.1", "--s", "0.4", "--tau", "-0.5"]
    for torus in (1, 2):
        code, out, _ = cli(*given, "--angles", "1", "1/2", "--torus", torus, "--samples", 3)
        result = json.loads(out)
        assert code == 0 and result["critical_sets"]["on"] == ["O4"]
        assert max(result["invariants"]["drift"].values()) < 1e-12
        assert result["invariants"]["c"] == pytest.approx(0.1, rel=1e-14)
        assert (result["invariants"]["s"], result["invariants"]["tau"]) == (0.4, -0.5)
        assert result["regime"]["tori"] == 2


def test_numbers_may_be_quotients_and_negative_and_times_too(cli):
    code, out, _ = cli(*FIELDS, "--m", "-1/3", "--h", "-1e-1", "--until", "-3", "--samples", 2)
    assert code == 0
    assert json.loads(out)["states"][1]["t"] == -3
    assert json.loads(out)["invariants"]["h"] == -0.1


@pytest.mark.parametrize(
    "arguments, words",
    [
        ([], "--a, --b, --m missing"),
        ([*FIELDS, "--m", "1"], "one of --l and --h is needed"),
        ([*FIELDS, "--m", "1", "--l", "2", "--h", "1"], "not both"),
        (
            [*FIELDS, "--m", "0.8", "--l", "0.1"],
            "f1² = −φ(s1) is negative for all |s1| ≥ a; |ℓ| ≥ 0.6",
        ),
        (
            [*FIELDS, "--m", "0.2", "--l", "0.1"],
            "f2² = φ(s2) is negative for all |s2| ≤ b; |ℓ| ≥ 0.84",
        ),
        ([*FIELDS, "--m", "-1", "--l", "3"], "φ(s2) is negative for all |s2| ≤ b; |ℓ| ≤ 1.8"),
        (
            [*FIELDS, "--m", "-1", "--h", "99"],
            "ℓ² = 2p²m²+2hm+1 = -194.68 is negative; h ≥ 0.04 and ≤ 1.66",
        ),
        ([*FIELDS, "--m", "0", "--l", "1"], "m = 0"),
        (["--a", "1", "--b", "1", "--m", "1", "--l", "1"], "a > b ≥ 0 is needed"),
        ([*FIELDS, "--c", "0.5", "--m", "1", "--l", "1"], "|c| ≤ 0.4 would do"),
        ([*USUAL, "--torus", "2"], "there is no torus 2: these constants have one torus"),
        ([*USUAL, "--origins", "0", "x"], "“x” is not a finite number"),
        ([*FIELDS, "--m", "x", "--l", "1"], "“x” is not a finite number"),
        ([*USUAL, "--until", "inf"], "--until inf is not a finite number"),
        ([*USUAL, "--until", "1e300"], "times have to be finite, up to 1e+290"),
        ([*USUAL, "--samples", "0"], "--samples has to be from 1"),
        ([*USUAL, "--method", "euler"], "invalid choice: 'euler'"),
        ([*USUAL, "--point", "1"], "cannot stand beside it"),
        ([*FIELDS, *"--s 1 --tau 1 --m 1".split()], "of O⁴; --m cannot stand beside it"),
        ([*FIELDS, "--s", "1"], "--tau missing"),
        (["--point", "1", "2"], "nine numbers"),
        (["--a", "1e400", "--b", "1", "--m", "1", "--l", "1"], "“1e400” is too large: no float"),
        ([*FIELDS, "--m", "1e-200", "--l", "1"], "m = almost 0: the roots"),
        ([*FIELDS, "--m", "1e-400", "--l", "1"], "“1e-400” is too small: no float"),
        (["--point", "1e400", *"12345678"], "“1e400” is too large: no float"),
        ([*FIELDS, "--m", "-inf", "--l", "1"], "“-inf” is not a finite number"),
        (
            ["--point", *"123456789", "--method", "closed"],
            "no closed form, but integrators follow the motion: the state is not on N⁴",
        ),
        ([*USUAL, "--output", "/dev/null/x"], "/dev/null/x/motion.json: cannot be written"),
    ],
)
def test_wrong_use_gets_a_message(cli, arguments, words):
    code, out, err = cli(*arguments)
    assert code == 2 and out == ""
    assert words in err


@pytest.mark.slow
def test_following_a_motion_imports_no_pictures_and_the_command_line_no_arrays(cli):
    script = (
        "import sys; from kowalevski_cas.cli import main; main([]); "
        "assert 'numpy' not in sys.modules; "
        "main(['motion', *'--a 1 --b .4 --m .8 --l .9'.split()]); "
        "assert not {'matplotlib', 'scipy', 'sympy'} & set(sys.modules)"
    )
    done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr


@pytest.mark.parametrize("method", sampled(["radau", "lsoda", "dop853"], 1))
@pytest.mark.parametrize("until", sampled(["1e6", "1e300", "-1e308"], 1))
def test_a_method_that_comes_to_no_end_ends(cli, monkeypatch, method, until):
    monkeypatch.undo()
    code, out, err = cli(*USUAL, "--method", method, "--until", until, "--timeout", 0.2)
    assert code == 3 and out == ""
    assert f"{method} has not come to t = {float(until):g} within 0.2 s; --timeout" in err
    assert "Warning" not in err


def test_no_line_of_a_table_is_wider_than_eighty_letters_and_all_that_is_asked_for_is_in_it(cli):
    """Whatever the motion; the quaternions stand below the states."""
    on_O4 = "--a 1.2 --b 0.7 --s 0.4 --tau=-0.5 --torus 2".split()
    for given in ([*USUAL], on_O4, ["--point", *"123456789"], ["--a", "1e60", *HUGE]):
        asked = ["--frequencies", "--attitude", "--format", "table", "--samples", "3"]
        code, table, _ = cli(*given, *asked)
        lines = table.splitlines()
        assert code == 0 and max(map(len, lines)) == 80
        head = next(k for k, line in enumerate(lines) if line.split()[1:] == "q₀ q₁ q₂ q₃".split())
        turns = np.array([line.split()[1:] for line in lines[head + 1 : head + 4]], dtype=float)
        np.testing.assert_allclose(np.linalg.norm(turns, axis=1), 1, atol=1e-3)
        assert "frequencies: " in table or "none: " in table
        assert not any(line.endswith(" =") for line in lines)
