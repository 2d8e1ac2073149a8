.PHONY: run test coverage fuzz bench bench-long lint docs setup

PY := .venv/bin/python
QOVR := .venv/bin/qovr

setup:
	@.ci/setup

# With a display: the editor. Without one: the paper's job, into build/.
run: setup
	@if [ -n "$$DISPLAY$$WAYLAND_DISPLAY" ] || [ "$$(uname -s)" = Darwin ]; then $(QOVR); else $(MAKE) --no-print-directory headless; fi

.PHONY: headless
headless:
	@mkdir -p build
	$(QOVR) export paper:fig5 build/fig5.xlsx build/fig5.csv build/fig5.npz build/fig5.qovr
	$(QOVR) reproduce build/fig5.xlsx
	$(QOVR) figures build/figures
	xvfb-run -a -s "-screen 0 1920x1200x24" $(QOVR) screenshot build/window.png paper:fig5
	@echo "build/fig5.xlsx is the paper's data, build/figures holds its figures, build/window.png is the editor."

# One worker a core, each with its own virtual screen.
test: setup
	@$(PY) -m pytest --numprocesses auto --dist worksteal

# The same with what the tests reach, other processes included; a third slower.
coverage: setup
	@mkdir -p build
	@$(PY) -m pytest --numprocesses auto --dist worksteal --cov --cov-report term:skip-covered

# The properties on examples of the day, random actions and kills in the editor, then damaged files for as long as one
# likes: make fuzz SECONDS=36000.
# What fails is kept in build/.
SECONDS ?= 3600
fuzz: setup
	@$(PY) -m pytest -m hypothesis --hypothesis-profile exploring --numprocesses auto --dist worksteal
	@QOVR_ACTIONS=20000 QOVR_KILLS=200 $(PY) -m pytest tests/app/editor/test_random_actions.py \
		tests/app/editor/test_recovery.py --numprocesses auto --dist worksteal
	@QOVR_FUZZ_SECONDS=$(SECONDS) QOVR_FUZZ_SEED=$$(date +%s) $(PY) -m pytest -s tests/core/test_fuzz.py

# One table of ratios against their goals, in ten minutes on a quiet machine; what takes longer apart.
bench: setup
	@$(PY) -m pytest --quiet -rs -m "not long" tests/benchmarks

bench-long: setup
	@$(PY) -m pytest --quiet -rs -m long tests/benchmarks

lint: setup
	@$(PY) -m ruff check .
	@$(PY) -m ruff format --check .
	@$(PY) -m mypy

docs: setup
	@$(PY) .ci/docs.py
	@echo "build/docs/index.html is the library's reference, build/docs/help.html the editor's help."
