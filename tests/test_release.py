"""What is said of the project is said once: the version, the authors, what is required."""

import json
import re
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest
import yaml
from jinja2 import Template

from kowalevski_cas import __version__

ROOT = Path(__file__).parents[1]
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
SCHEMAS = {
    "github-workflows": ".github/workflows/*.yml",
    "github-actions": "action.yml",
    "github-issue-forms": ".github/ISSUE_TEMPLATE/[!c]*.yml",
    "github-issue-config": ".github/ISSUE_TEMPLATE/config.yml",
    "citation-file-format": "CITATION.cff",
}


def test_a_citation_names_the_version_and_the_authors():
    citation = yaml.safe_load((ROOT / "CITATION.cff").read_text(encoding="utf-8"))
    deposit = json.loads((ROOT / ".zenodo.json").read_text(encoding="utf-8"))
    assert citation["version"] == __version__
    names = [author["name"] for author in PROJECT["authors"]]
    assert [author["name"] for author in citation["authors"]] == names
    assert [creator["name"] for creator in deposit["creators"]] == names
    assert deposit["description"] == PROJECT["description"]
    assert deposit["keywords"] == PROJECT["keywords"]
    assert citation["license"] == deposit["license"] == PROJECT["license"]["text"]


def test_the_recipe_of_conda_says_what_the_package_does():
    """As conda build reads it: a template first, then data."""

    def found(load_file, regex_pattern, from_recipe_dir):
        assert from_recipe_dir
        return re.search(regex_pattern, (ROOT / "conda" / load_file).read_text(encoding="utf-8"))

    template = (ROOT / "conda" / "meta.yaml").read_text(encoding="utf-8")
    recipe = yaml.safe_load(Template(template).render(load_file_regex=found, PYTHON="python"))
    assert recipe["package"] == {"name": PROJECT["name"], "version": __version__}
    (script,) = recipe["build"]["entry_points"]
    assert dict([script.split(" = ")]) == PROJECT["scripts"]
    assert recipe["about"]["summary"] == PROJECT["description"]
    assert recipe["about"]["license"] == PROJECT["license"]["text"]
    names = {"symengine": "python-symengine", "typst": "typst-py"}
    required = [one.partition(">=") for one in PROJECT["dependencies"]]
    required = {f"{names.get(name, name)} >={least}" for name, _, least in required}
    python = f"python {PROJECT['requires-python']}"
    assert {*recipe["requirements"]["run"]} == required | {python, "__unix"}
    assert {python, "pip"} < {*recipe["requirements"]["host"]}


def test_dev_has_what_the_tests_import():
    """All extras that tests need come with it."""
    extras = PROJECT["optional-dependencies"]
    (own,) = (one for one in extras["dev"] if one.startswith("kowalevski-cas["))
    named = set(own.removeprefix("kowalevski-cas[").removesuffix("]").split(","))
    assert {"agents", "all", "cluster", "completion", "editor", "notebook"} <= named


@pytest.mark.slow
@pytest.mark.parametrize("name", SCHEMAS)
def test_it_is_what_its_schema_says(name):
    files = sorted(ROOT.glob(SCHEMAS[name]))
    assert files
    words = [sys.executable, "-m", "check_jsonschema", "--builtin-schema", f"vendor.{name}"]
    done = subprocess.run([*words, *files], capture_output=True, text=True)
    assert done.returncode == 0, done.stdout


def test_where_it_cannot_run_it_says_so():
    code = "import os; os.name = 'nt'\nimport kowalevski_cas"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, cwd=ROOT)
    assert done.returncode == 1 and "runs on Linux and macOS" in done.stderr
