"""What all tests share: threads, the back ends, one browser for a worker, and what is computed once for all workers.

What one process of a run has derived, of the tests or started by them, the others find in a folder of the run.

Tests marked `compiler` need a C compiler; where there is none they are skipped.  `.ci/run` requires one.
"""

from __future__ import annotations

import os

# Workers share the cores already: linear algebra has one thread, here before NumPy is loaded, and in the processes
# that tests start.
os.environ |= dict.fromkeys(
    ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS", "VECLIB_MAXIMUM_THREADS"), "1"
)

# SymPy remembers more of what it has computed than it would by itself: emission takes a sixth less.
os.environ["SYMPY_CACHE_SIZE"] = "50000"
os.environ["SOURCE_DATE_EPOCH"] = "1700000000"  # the bytes of pages do not depend on the day

import importlib
import math
import sys
import tempfile
from collections.abc import Iterator
from unittest.mock import Mock

import hypothesis
import pytest
import threadpoolctl

from helpers.generated.emission import Emission
from helpers.pages.browser import close_browsers
from helpers.pages.without_drawing import without_drawing
from helpers.runs.shared import Shared
from pkmodes.core.compiled import build
from pkmodes.core.mechanism import registry
from pkmodes.core.solve.backends import BACKEND_VARIABLE
from pkmodes_derive import kept

pytest_plugins = ["helpers.runs.fixtures", "helpers.runs.processor_time"]

# Made before workers start, which inherit the variable; a folder that a developer names outlives the run.
_derived = None
if kept.FOLDER_VARIABLE not in os.environ:
    _derived = tempfile.TemporaryDirectory(prefix="pkmodes-derived-")
    os.environ[kept.FOLDER_VARIABLE] = _derived.name

# A plugin may have loaded NumPy before.
threadpoolctl.threadpool_limits(1)

# How long an example takes depends on the machine, and what its fixtures hold is the same for every example.
hypothesis.settings.register_profile(
    "pkmodes",
    deadline=None,
    suppress_health_check=[hypothesis.HealthCheck.function_scoped_fixture, hypothesis.HealthCheck.too_slow],
)
hypothesis.settings.load_profile("pkmodes")


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption(
        "--update-golden", action="store_true", help="write tests/golden instead of comparing with it"
    )
    parser.addoption(
        "--whole-suites", action="store_true", help="run every case of the suites on the virtual rig"
    )


def pytest_unconfigure() -> None:
    if _derived is not None:
        _derived.cleanup()


@pytest.hookimpl(tryfirst=True)
def pytest_runtest_setup(item: pytest.Item) -> None:
    if item.get_closest_marker("compiler") and not build.compiler():
        pytest.skip("needs a C compiler: install gcc or clang")


@pytest.fixture(scope="module", params=["numpy", pytest.param("compiled", marks=pytest.mark.compiler)])
def backend(request: pytest.FixtureRequest) -> Iterator[str]:
    """Each back end in turn, for whatever a test evaluates without asking for one, in other processes too.

    For tests of what users see of modes and sensitivities: ``pytestmark = pytest.mark.usefixtures("backend")``.  A
    fixture of a whole module that evaluates asks for it, too.
    """
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv(BACKEND_VARIABLE, request.param)
        yield str(request.param)


@pytest.fixture(scope="session")
def shared(tmp_path_factory: pytest.TempPathFactory) -> Shared:
    """What one worker computes for all."""
    folder = tmp_path_factory.getbasetemp()
    if "PYTEST_XDIST_WORKER" in os.environ:
        folder = folder.parent
    return Shared(folder / "shared")


@pytest.fixture(scope="session")
def emission(shared: Shared) -> Emission:
    """The parametric models and the pages of the derivation: emitted once."""
    return Emission(shared)


@pytest.fixture
def subtests(subtests: pytest.Subtests) -> Iterator[pytest.Subtests]:
    """Those of pytest; a test that tries none, because its table of cases has become empty, is an error."""
    tried = subtests.test = Mock(wraps=subtests.test)
    yield subtests
    assert tried.called, "no case was tried"


@pytest.fixture
def no_drawing() -> Iterator[None]:
    """Pages are made without their figures."""
    with without_drawing():
        yield


@pytest.fixture(autouse=True)
def _mechanisms_as_supplied() -> Iterator[None]:
    """No test leaves a mechanism of pkmodes with effects of its own to the tests after it."""
    yield
    assert not {*registry._package_by_name} & {*registry.supplied_names()}
    if "pkmodes_derive.mechanisms" in sys.modules:
        own_effects = sys.modules["pkmodes_derive.mechanisms"].own_effects
        assert not [name for name in registry.supplied_names() if own_effects(name)]


@pytest.fixture(scope="session", autouse=True)
def _without_progress() -> None:
    """Lines of progress appear where a diagnosis takes long, which depends on the machine."""
    importlib.import_module("pkmodes.cli.diagnosing").PROGRESS_INTERVAL = math.inf


@pytest.fixture(scope="session", autouse=True)
def _browsers() -> Iterator[None]:
    """The browser that the tests of pages started is closed at the end."""
    yield
    close_browsers()
