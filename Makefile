# One-line aliases. `make` alone lists them; every command also works without make.

PYTHON ?= python3
SUBMISSION ?= solution.py
GROUP ?= small
SEED ?= 1
RUN := .venv/bin/python

.DEFAULT_GOAL := help
.PHONY: help setup data judge test test-all case figures stress strength mutants worlds calibrate \
  check schema lint format types clean

help: ## list these commands
	@sed -n 's/^\([a-z-]*\):.*## \(.*\)/  make \1|\2/p' $(MAKEFILE_LIST) | column -t -s '|' 2>/dev/null \
	  || grep '^[a-z-]*:.*## ' $(MAKEFILE_LIST)

setup: .venv/.ready-dev ## make the environment .venv (the other commands do it by themselves)

# What judging needs is there in seconds; what the tests need comes when they are run.
.venv/.ready: pyproject.toml tools/setup.py .venv/bin/python
	@$(PYTHON) tools/setup.py

.venv/.ready-dev: pyproject.toml tools/setup.py .venv/bin/python
	@$(PYTHON) tools/setup.py --dev

# Missing if the Python that the environment was made with is gone: then it is made again.
.venv/bin/python: ;

data: .venv/.ready ## build the test data: what is missing or out of date
	@$(RUN) -m gen build

judge: data ## judge a program on all test cases: make judge [SUBMISSION=my.cpp]
	@$(RUN) checker.py $(SUBMISSION)

test: setup data ## run the tests that take two minutes together
	@$(RUN) -m pytest -n auto -m "not slow"

test-all: setup data ## run all tests
	@$(RUN) -m pytest -n auto

case: .venv/.ready ## add a test case: make case FAMILY=contacts [SEED=7] [GROUP=small] [ARGS="--set n=9"]
	@$(RUN) -m gen case $(FAMILY) --seed $(SEED) --group $(GROUP) $(ARGS)

figures: .venv/.ready ## draw the figures of the statement again
	@$(RUN) -m pictures figures

stress: .venv/.ready ## solvers against each other: 10^6 random scenarios and a complete small world
	@$(RUN) -m stress all

worlds: .venv/.ready ## every scenario of complete worlds, answered by programs in C++ and Python
	@$(RUN) -m stress complete

strength: data ## which submission fails where: submissions x groups, build/strength.html
	@$(RUN) -m strength --html build/strength.html --json build/strength.json

mutants: data ## small changes of the right programs: does the data notice each?
	@$(RUN) -m strength mutants

calibrate: data ## measure the margins of the time limit
	@$(RUN) -m judge.calibrate

check: .venv/.ready ## validate every file of the data, and its checksums
	@$(RUN) -m gen check

schema: .venv/.ready ## write the schema of the JSON report, docs/report.schema.json
	@$(RUN) -m judge.reports.schema

lint: setup ## look for mistakes and bad style
	@$(RUN) -m ruff check && $(RUN) -m ruff format --check

format: setup ## lay out the code
	@$(RUN) -m ruff format

types: setup ## check the types
	@$(RUN) -m mypy

clean: ## delete what can be made again: environment, rebuilt data, caches
	@rm -rf .venv build data/secret/large data/secret/many .pytest_cache .mypy_cache .ruff_cache .hypothesis
