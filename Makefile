# Everything works through a local virtual environment, made on first use.
# Needed beforehand: make, Python 3.11 or later, and its venv module.

VENV  := .venv
PY    := $(VENV)/bin/python
RUN   := $(PY) -m kowalevski_cas
SLOW  ?=
QUICK ?=
PAPER ?=
JUNIT ?=

# The first Python that is new enough. `make PYTHON=...` chooses another.
PYTHON = $(shell for p in python3.13 python3.12 python3.11 python3; do \
	"$$p" -c 'import sys; sys.exit(sys.version_info < (3, 11))' >/dev/null 2>&1 \
	&& { echo "$$p"; break; }; done)

.DEFAULT_GOAL := help
.DELETE_ON_ERROR:
.PHONY: help verify motion report certificates mutants test coverage schemas sarif lint docs record rocq witnesses study benchmark clean

help: ## Show this list
	@awk -F ':.*## ' '/^[a-z]+:.*## / { printf "  make %-13s %s\n", $$1, $$2 }' $(firstword $(MAKEFILE_LIST))

verify: $(VENV)/.installed ## Prove or refute every formula, check the certificates, write the report
	@$(RUN) verify --arithmetic all --report reports

motion: $(VENV)/.installed ## Draw motions on N⁴ and O⁴, and the bifurcation diagrams, into reports/motion; the reports show them
	@$(RUN) pictures

report: $(VENV)/.installed ## Write reports/*.html, *.pdf, *.tex and *.json
	@$(RUN) report --output reports

record: $(VENV)/.installed ## Search anew; write the record of verdicts and the certificates
	@$(RUN) record

certificates: $(VENV)/.installed ## Write the certificates, with the evidence that is there
	@$(RUN) certificates

mutants: $(VENV)/.installed ## Change one token at a time: what does an audit notice? (PAPER=, SAMPLE=, SEED=)
	@$(PY) -m study.mutants $(PAPER) $(if $(SAMPLE),--sample $(SAMPLE)) $(if $(SEED),--seed $(SEED))

test: $(VENV)/.dev ## Run the tests (SLOW=1: also the slow ones; JUNIT=file: results as XML)
	@$(PY) -m pytest -q -n auto --dist loadfile $(if $(SLOW),,-m "not slow and not example") $(if $(JUNIT),--junit-xml="$(JUNIT)")

coverage: $(VENV)/.dev ## Run the tests, and say which lines they run; build/coverage.xml
	@$(PY) -m pytest -q -n auto --dist loadfile $(if $(SLOW),,-m "not slow and not example") --cov --cov-report=term:skip-covered --cov-report=xml:build/coverage.xml

schemas: $(VENV)/.dev ## Check workflows, action, forms and citation by their schemas
	@$(PY) -m pytest -q tests/test_release.py

sarif: $(VENV)/.installed ## Let Microsoft's multitool validate results as SARIF (needs npm)
	@mkdir -p build/sarif && npm install --silent --no-audit --no-fund --prefix build/sarif @microsoft/sarif-multitool@5
	@chmod u+x build/sarif/node_modules/@microsoft/sarif-multitool-*/Sarif.Multitool
	@$(RUN) audit tests/data/papers/pendula.tex --format sarif > build/sarif/audit.sarif; test $$? -le 3
	@$(RUN) verify kharlamov2002 --format sarif > build/sarif/verify.sarif
	@DOTNET_SYSTEM_GLOBALIZATION_INVARIANT=1 build/sarif/node_modules/.bin/sarif-multitool validate build/sarif/*.sarif | tee build/sarif/validation.txt
	@grep -q "completed successfully" build/sarif/validation.txt && ! grep -q ": error " build/sarif/validation.txt # it ends with 0 in any case

lint: $(VENV)/.dev ## Check style and types
	@$(PY) -m ruff check . && $(PY) -m ruff format --check . && $(PY) -m mypy

docs: $(VENV)/.dev ## Draw the pictures of the README; write the documentation as a site, build/site/index.html
	@$(PY) docs/pictures.py && COLUMNS=80 $(PY) docs/man.py && $(INSTALL) --editable ".[docs]" && $(PY) -m mkdocs build --quiet --strict

rocq: $(VENV)/.installed ## Let Rocq confirm the certificates (DERIVATION=: of this one only)
	@$(RUN) witness rocq $(DERIVATION)

witnesses: $(VENV)/.installed ## Let Singular, PARI/GP and Maxima confirm the certificates
	@$(RUN) witness singular
	@$(RUN) witness pari
	@$(RUN) witness maxima

study: $(VENV)/.installed ## Measure speed against accuracy, and where methods fail (QUICK=1: under a minute)
	@$(PY) -m study $(if $(QUICK),--quick)

benchmark: $(VENV)/.dev ## Measure the speed of proving, of reporting, of searches, and of audits
	@$(PY) -m benchmarks.proving
	@$(PY) -m benchmarks.searches
	@$(PY) -m benchmarks.papers

clean: ## Remove the environment and everything generated, save the reports
	@rm -rf $(VENV) $(VENV).lock build dist .pytest_cache .mypy_cache .ruff_cache .hypothesis *.egg-info
	@find . -name __pycache__ -type d -prune -exec rm -rf {} +

# ---------------------------------------------------------------- environment

INSTALL = $(PY) -m pip install --quiet --disable-pip-version-check --no-input

# Each step is done under a lock, and once, if several makes come to it at the same time.
ONCE = $(PYTHON) -c 'import fcntl, subprocess, sys; lock = open("$(VENV).lock", "w"); \
	fcntl.flock(lock, fcntl.LOCK_EX); sys.exit(subprocess.call(["sh", "-ec", sys.argv[1]]))'

$(VENV)/.python: | python-is-usable
	@$(ONCE) 'test -e $@ || { rm -rf $(VENV); $(PYTHON) -m venv $(VENV); touch $@; }'

$(VENV)/.installed: pyproject.toml | $(VENV)/.python
	@$(ONCE) 'test $@ -nt pyproject.toml || { \
		echo "Installing the libraries into $(VENV) (a minute or two, once) ..." >&2; \
		$(INSTALL) --editable ".[all]"; touch $@; }'

$(VENV)/.dev: pyproject.toml | $(VENV)/.installed
	@$(ONCE) 'test $@ -nt pyproject.toml || { \
		echo "Installing the test tools into $(VENV) ..." >&2; \
		$(INSTALL) --editable ".[all,dev]"; touch $@; }'

.PHONY: python-is-usable
python-is-usable:
	@test -n "$(PYTHON)" || { \
		echo "No Python 3.11 or later was found. On Debian or Ubuntu: apt-get install python3 python3-venv" >&2; \
		echo "Or name one: make PYTHON=/path/to/python3" >&2; exit 2; }
	@$(PYTHON) -c 'import ensurepip, venv' 2>/dev/null || { \
		echo "$(PYTHON) cannot make virtual environments. On Debian or Ubuntu: apt-get install python3-venv" >&2; \
		exit 2; }
