# One-line aliases. `make` alone lists them; every command also works without make.

PYTHON ?= python3
SUBMISSION ?= solution.py
GROUP ?= small
SEED ?= 1
TARGET ?= all
RUN := .venv/bin/python

.DEFAULT_GOAL := help
.PHONY: help setup data judge test test-all case export verify-exports figures stress strength mutants gallery worlds calibrate \
  explorer check schema lint format types clean

help: ## list these commands
	@sed -n 's/^\([a-z-]*\):.*## \(.*\)/  make \1|\2/p' $(MAKEFILE_LIST) | column -t -s '|' 2>/dev/null \
	  || grep '^[a-z-]*:.*## ' $(MAKEFILE_LIST)

setup: .venv/.ready-dev ## make the environment .venv (other make commands do this themselves)

# The packages for judging install in seconds; those for tests are installed when needed.
.venv/.ready: pyproject.toml tools/setup.py .venv/bin/python
	@$(PYTHON) tools/setup.py

.venv/.ready-export: pyproject.toml tools/setup.py .venv/bin/python
	@$(PYTHON) tools/setup.py --export

.venv/.ready-dev: pyproject.toml tools/setup.py .venv/bin/python
	@$(PYTHON) tools/setup.py --dev

build/judges/.ready: pyproject.toml tools/setup.py
	@$(PYTHON) tools/setup.py --judges

# It is missing if the Python that made the environment is gone; then .venv is made again.
.venv/bin/python: ;

data: .venv/.ready ## build the test data that is missing or out of date
	@$(RUN) -m gen build

judge: data ## judge a program on all test cases: make judge [SUBMISSION=my.cpp]
	@$(RUN) checker.py $(SUBMISSION)

test: setup data ## run the fast tests, in about two minutes
	@$(RUN) -m pytest -n auto -m "not slow"

test-all: setup data ## run all tests, also the slow ones
	@$(RUN) -m pytest -n auto

case: .venv/.ready ## add a test case: make case FAMILY=contacts [SEED=7] [GROUP=small] [ARGS="--set n=9"]
	@$(RUN) -m gen case $(FAMILY) --seed $(SEED) --group $(GROUP) $(ARGS)

export: .venv/.ready-export data ## write packages for other judges: make export [TARGET=kattis]
	@$(RUN) -m export $(TARGET)

verify-exports: .venv/.ready-export build/judges/.ready data ## let the judges' own tools read the packages
	@$(RUN) -m export verify $(TARGET)

figures: .venv/.ready ## redraw the figures of the statement
	@$(RUN) -m pictures figures

explorer: .venv/.ready ## build the page to play with, docs/explorer.html
	@$(RUN) -m explorer

stress: .venv/.ready ## compare the solvers on 10^6 random scenarios and a complete small world
	@$(RUN) -m stress all

worlds: .venv/.ready ## compare programs in C++ and Python on every scenario of complete worlds
	@$(RUN) -m stress complete

strength: data ## show which submission fails in which group: build/strength.html
	@$(RUN) -m strength --html build/strength.html --json build/strength.json

mutants: data ## make small changes to correct programs and check that the data notices each
	@$(RUN) -m strength mutants

gallery: .venv/.ready ## ask all wrong programs for their answers to the gallery; is each told its lesson?
	@$(RUN) -m strength gallery && $(RUN) -m explorer

calibrate: data ## measure the margins of the time limit
	@$(RUN) -m judge.calibrate

check: .venv/.ready ## validate every data file and compare it with its checksum
	@$(RUN) -m gen check

schema: .venv/.ready ## write the schema of the JSON report, docs/report.schema.json
	@$(RUN) -m judge.reports.schema

lint: setup ## check the code for mistakes and bad style
	@$(RUN) -m ruff check && $(RUN) -m ruff format --check

format: setup ## format the code
	@$(RUN) -m ruff format

types: setup ## check the types
	@$(RUN) -m mypy

clean: ## delete what can be rebuilt: environment, large data, caches; data that you added stays
	@if [ -e .venv/.ready ]; then $(RUN) -m gen clean; else echo "data/ is kept: the kit is not set up"; fi
	@rm -rf .venv build .pytest_cache .mypy_cache .ruff_cache .hypothesis
