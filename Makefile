# Every target sets up its prerequisites: a virtual environment in .venv with the project installed.
# Required: Python >= 3.11, make, and a C compiler for the tests of the generated C.

PYTHON ?= python3
VENV := .venv
BIN := $(VENV)/bin
PKMODES := $(BIN)/pkmodes
# The heading of an act of the demo, and what it shows.
ACT := printf '\n\033[1m%s\033[0m\n%s\n\n'
ROBOT := robots/linear-delta-2022.toml
LOOP := examples/closed_loop
RAIL := examples/loose_rail
CAMPAIGN := examples/campaign
IDENTIFIED := robots/linear-delta-2022-identified.toml
PLANE := x=0.29:1.23:95,y=-0.16:0.16:33,z=-0.24383544
POSE := 0.6,0,-0.24383544

# The targets share one environment: run in parallel, they would both install into it.
.NOTPARALLEL:
.PHONY: demo first-act test floors lint types check generate schemas derivation docs benchmark figures suites clean

# The first act needs the core only, and runs without its compiled evaluator, which takes longer to build than the act.
first-act: export PKMODES_BACKEND = numpy
first-act: $(VENV)/.core
	@mkdir -p build
	@$(ACT) '1. What does the model lack?' \
	    'A machine has compliant gearboxes that its robot file does not declare; diagnose gets that file and measured modes.'
	$(PKMODES) diagnose $(LOOP)/robot.toml $(LOOP)/measured.csv --save-robot build/workshop-delta.toml

demo: first-act $(VENV)/.demo  ## the loop: a cause found, corrected code, signals to modes, the paper's tables, pages to open
	@$(ACT) '2. Code of the corrected machine' \
	    'NumPy and C99 come from the corrected file and are checked; with it the same measurements need no further cause.'
	$(PKMODES) generate build/workshop-delta.toml --out build/workshop-delta
	$(PKMODES) check build/workshop-delta
	$(PKMODES) diagnose build/workshop-delta.toml $(LOOP)/measured.csv
	@$(ACT) '3. From signals' \
	    'Another machine was tapped with a hammer: its signals become modes with standard deviations, and these a cause.'
	$(PKMODES) identify $(CAMPAIGN)/campaign.toml --out build/modes.csv --report build/identification.html
	$(PKMODES) diagnose $(CAMPAIGN)/robot.toml build/modes.csv --save-robot build/corrected.toml \
	    --campaign $(CAMPAIGN)/campaign.toml --report build/diagnosis.html
	$(PKMODES) diagnose build/corrected.toml build/modes.csv
	@$(ACT) '4. The tables of the paper' \
	    'The values that the paper declares miss its printed frequencies; those identified from its tables give every digit.'
	$(PKMODES) generate $(ROBOT) --out build/linear-delta-2022
	$(PKMODES) check build/linear-delta-2022
	$(BIN)/python docs/studies/published_tables/residual.py $(ROBOT) --generated build/linear-delta-2022
	@$(ACT) '5. An effect that nobody had written' \
	    'A rail of the machine has come loose, which no catalogue has: found, derived, added, and gone from the residual.'
	$(PKMODES) diagnose $(RAIL)/robot.toml $(RAIL)/measured.csv --save-effect build/loose_rail.py \
	    --save-robot build/worn-delta.toml
	$(PKMODES) generate build/worn-delta.toml --effect build/loose_rail.py --out build/worn-delta
	PKMODES_BACKEND=numpy $(PKMODES) diagnose build/worn-delta.toml $(RAIL)/measured.csv \
	    --mechanism build/worn-delta/linear_delta
	@$(ACT) '6. Pages to open' \
	    'Each is one file that works without a network.'
	$(PKMODES) map $(IDENTIFIED) --grid $(PLANE) --out build/map.nc --overwrite --report build/map.html
	$(PKMODES) show $(IDENTIFIED) --out build/robot.html
	$(PKMODES) show $(IDENTIFIED) --pose=$(POSE) --mode 2 --out build/mode.gif
	@echo
	@echo "  build/identification.html   from signals to modes: the fits to the taps"
	@echo "  build/diagnosis.html        what that machine's model lacked, to hand on"
	@echo "  build/map.html              where the paper's machine rings"
	@echo "  build/robot.html            that machine, moving in its modes"
	@echo "  build/mode.gif              its second mode, as in the README"

test: $(VENV)/.dev  ## all tests, including the slow ones
	$(BIN)/python -m pytest -n auto --dist loadfile --no-loadscope-reorder --processor-time build/processor_time.tsv

floors: $(VENV)/.dev  ## run what a wheel installs with the oldest and the newest versions allowed, on each Python that is there
	PATH="$$PATH:$(abspath $(BIN))" .ci/floors

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

schemas: $(VENV)/.dev  ## rewrite docs/schemas from the classes of the JSON documents
	$(BIN)/python -m pkmodes.cli.schemas docs/schemas

derivation: $(VENV)/.derive  ## rebuild docs/derivation/
	$(BIN)/python -m pkmodes_derive latex

docs: $(VENV)/.docs  ## the documentation as a site, in build/site
	$(BIN)/python -m sphinx --fail-on-warning --keep-going --quiet -c docs/site docs build/site
	@echo "open build/site/index.html"

benchmark: $(VENV)/.benchmark  ## the tables of times in the documentation, and other times
	$(BIN)/python benchmarks/backends.py
	$(BIN)/python benchmarks/one_core.py --keep
	$(BIN)/python benchmarks/evaluation.py
	$(BIN)/python benchmarks/many_rows.py
	$(BIN)/python benchmarks/diagnosis.py
	$(BIN)/python benchmarks/map.py
	$(BIN)/python benchmarks/identification.py --out docs/explanation/identification-compared.md
	$(BIN)/python benchmarks/campaign.py

figures: $(VENV)/.dev  ## the pictures of the README and docs/explanation/published-figures.md, and the tables of that page and docs/how-to/shapers.md
	$(BIN)/python -m pkmodes figures $(IDENTIFIED) --out docs/figures/identified --format png --grid $(PLANE)
	$(BIN)/python -m pkmodes figures $(ROBOT) --out docs/figures/declared \
	    --format png --grid x=0.24:0.92:103,y=-0.12:0.12:37,z=-0.245
	rm docs/figures/declared/influence.png docs/figures/declared/dominant.png docs/figures/declared/mac.png
	$(BIN)/python -m pkmodes show $(IDENTIFIED) --pose=$(POSE) --mode 2 --out docs/figures/mode.gif
	$(BIN)/python docs/studies/published_figures/claims.py
	$(BIN)/python docs/studies/shaped_moves/table.py

# The virtual rig is test equipment: it lies beside the tests, and is not installed.
suites benchmark figures: export PYTHONPATH = tests

suites: CLUSTER = $(if $(SCHEDULER),--scheduler $(SCHEDULER))
suites: $(VENV)/.dev  ## error rates of identification and diagnosis on the virtual test rig, four hours on two cores; SCHEDULER=ADDRESS: most of them on a Dask cluster
	$(BIN)/python -m studies.diagnosis $(CLUSTER) --seed 20261216 --out docs/results/diagnosis
	$(BIN)/python -m studies.mechanism_suites $(CLUSTER) --seed 20261215 --out docs/results/mechanisms
	$(BIN)/python -m studies.limits $(CLUSTER) --seed 20261213 --out docs/results/limits
	$(BIN)/python -m studies.calibration --seed 20271127 --out docs/results/probabilities
	$(BIN)/python -m studies.refused --seed 20290202 --limit 5 --out docs/results/refused
	$(BIN)/python -m studies.clear_suites $(CLUSTER) --seed 20261207 --out docs/results/clear-causes
	$(BIN)/python -m studies.six_legged_suites $(CLUSTER) --seed 20271217 --out docs/results/six-legs
	$(BIN)/python -m studies.one_place $(CLUSTER) --seed 20280301 --out docs/results/one-place
	$(BIN)/python -m studies.changed $(CLUSTER) --seed 20290105 --out docs/results/changed
	$(BIN)/python -m studies.campaigns $(CLUSTER) --seed 20261226 --out docs/results/signals
	$(BIN)/python -m studies.damping $(CLUSTER) --seed 20261230 --out docs/results/damping
	$(BIN)/python -m studies.deciding --out tests/golden/rules.jsonl
	$(BIN)/python -m studies.thresholds --out docs/results/thresholds
	$(BIN)/python -m studies.results

clean:
	rm -rf $(VENV) build

$(VENV)/.python:
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11))' || { \
	    echo "error: $(PYTHON) is too old or missing (make); install Python >= 3.11 or run: make PYTHON=python3.12" >&2; \
	    exit 2; }
	@$(PYTHON) -m venv $(VENV) || { \
	    echo "error: $(PYTHON) cannot create a virtual environment (make); install its venv package" >&2; exit 2; }
	@touch $@

# Each environment is a subset of that for tests, so all use the same folder.  The core alone is installed without its
# compiled evaluator.  pip says only what went wrong.
INSTALL = $(BIN)/python -m pip install --quiet --quiet --disable-pip-version-check --editable

$(VENV)/.core: $(VENV)/.python pyproject.toml
	@echo "installing pkmodes into $(VENV)"
	@HATCH_BUILD_NO_HOOKS=true $(INSTALL) .
	@touch $@

$(VENV)/.derive: $(VENV)/.python pyproject.toml
	@$(INSTALL) '.[derive]'
	@touch $@ $(VENV)/.core

$(VENV)/.demo: $(VENV)/.core pyproject.toml
	@echo
	@echo "installing what makes code, maps and pages, and compiling the evaluator: two or three minutes"
	@$(INSTALL) '.[derive,report]'
	@touch $@ $(VENV)/.derive $(VENV)/.core

$(VENV)/.dev: $(VENV)/.python pyproject.toml
	@echo "installing pkmodes into $(VENV), with all that its tests need: some minutes"
	@$(INSTALL) '.[dev]'
	@touch $@ $(VENV)/.core $(VENV)/.demo $(VENV)/.derive $(VENV)/.docs

$(VENV)/.docs: $(VENV)/.python pyproject.toml
	@$(INSTALL) '.[docs]' || { \
	    echo "error: the packages of the extra 'docs' cannot be installed (make docs); check the network, or run:" \
	        "$(BIN)/python -m pip install -e '.[docs]'" >&2; \
	    exit 2; }
	@touch $@

# The packages to compare with are optional: the benchmark leaves out what is missing.
$(VENV)/.benchmark: $(VENV)/.dev
	@$(INSTALL) '.[benchmark]' \
	    || echo "note: not all packages of the extra 'benchmark' can be installed; their rows are left out"
	@touch $@
