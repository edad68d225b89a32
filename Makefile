# Every target sets up its prerequisites: a virtual environment in .venv with the project installed.
# Required: Python >= 3.11, make, and a C compiler for the tests of the generated C.

PYTHON ?= python3
VENV := .venv
BIN := $(VENV)/bin
ROBOT := robots/linear-delta-2022.toml
DEMO := build/linear-delta-2022
LOOP := examples/closed_loop
CORRECTED := build/workshop-delta

# The targets share one environment: run in parallel, they would both install into it.
.NOTPARALLEL:
.PHONY: demo test lint types check generate docs benchmark suites clean

demo: $(VENV)/.derive  ## the whole loop: derive, generate, solve, compare with measured modes, diagnose, correct
	$(BIN)/python -m pkmodes generate $(ROBOT) --out $(DEMO)
	$(BIN)/python -m pkmodes check $(DEMO)
	$(BIN)/python docs/studies/published_tables/residual.py $(ROBOT) --generated $(DEMO)
	$(BIN)/python -m pkmodes compare $(LOOP)/robot.toml $(LOOP)/measured.csv
	$(BIN)/python -m pkmodes diagnose $(LOOP)/robot.toml $(LOOP)/measured.csv --save-robot $(CORRECTED).toml
	$(BIN)/python -m pkmodes generate $(CORRECTED).toml --out $(CORRECTED)
	$(BIN)/python -m pkmodes diagnose $(CORRECTED).toml $(LOOP)/measured.csv

test: $(VENV)/.dev  ## all tests, including the slow ones
	$(BIN)/python -m pytest -n auto

lint: $(VENV)/.dev
	$(BIN)/python -m ruff format --check .
	$(BIN)/python -m ruff check .

types: $(VENV)/.dev
	$(BIN)/python -m mypy

check: $(VENV)/.dev  ## check that generated code is up to date and agrees with finite differences
	$(BIN)/python -m pkmodes check
	$(BIN)/python -m pkmodes check robots/*.toml

generate: $(VENV)/.derive  ## regenerate the committed code
	$(BIN)/python -m pkmodes_derive generate

docs: $(VENV)/.derive  ## rebuild docs/derivation/
	$(BIN)/python -m pkmodes_derive latex

benchmark: $(VENV)/.benchmark  ## tables of docs/compiled.md and docs/maps.md, and other times; some minutes
	$(BIN)/python benchmarks/backends.py
	$(BIN)/python benchmarks/evaluation.py
	$(BIN)/python benchmarks/many_rows.py
	$(BIN)/python benchmarks/large_models.py
	$(BIN)/python benchmarks/map.py

suites: $(VENV)/.dev  ## error rates of the diagnosis on the virtual test rig, about an hour on two cores
	$(BIN)/python benchmarks/diagnosis.py --seed 20261204 --out docs/diagnosis-measured.md
	$(BIN)/python benchmarks/mechanism_suites.py --seed 20261205 --out docs/mechanisms-measured.md

clean:
	rm -rf $(VENV) build

$(VENV)/.python:
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11))' || { \
	    echo "error: $(PYTHON) is too old or missing (make); install Python >= 3.11 or run: make PYTHON=python3.12" >&2; \
	    exit 2; }
	@$(PYTHON) -m venv $(VENV) || { \
	    echo "error: $(PYTHON) cannot create a virtual environment (make); install its venv package" >&2; exit 2; }
	@touch $@

# The demo's environment is a subset of the tests' environment, so both use the same folder.
$(VENV)/.derive: $(VENV)/.python pyproject.toml
	$(BIN)/python -m pip install --quiet --disable-pip-version-check --editable '.[derive]'
	@touch $@

$(VENV)/.dev: $(VENV)/.python pyproject.toml
	$(BIN)/python -m pip install --quiet --disable-pip-version-check --editable '.[dev]'
	@touch $@ $(VENV)/.derive

# The packages to compare with are optional: the benchmark leaves out what is missing.
$(VENV)/.benchmark: $(VENV)/.dev
	$(BIN)/python -m pip install --quiet --disable-pip-version-check --editable '.[benchmark]' \
	    || echo "note: not all packages of the extra 'benchmark' can be installed; their rows are left out"
	@touch $@
