"""``pkmodes check`` evaluates the code: wrong functions are found, and correct models raise no false alarm."""

from __future__ import annotations

import runpy
import sys
import tomllib
from pathlib import Path

import numpy as np
import pytest
from scipy.linalg import eigh

import pkmodes
from helpers.generated.broken_module import Broken
from helpers.generated.emission import Emission
from helpers.generated.generated_model import MODULE
from helpers.robots.robot_text import PUBLISHED, published
from pkmodes.cli import run
from pkmodes.codegen.checking import products
from pkmodes.codegen.checking.consistency import Check
from pkmodes.codegen.derivation import REQUIREMENTS
from pkmodes.core.mechanism import registry
from pkmodes_derive.emit import product

CLAMP = '\n[effects.clamp_compliance]\ncompliance = "1e-7 m/N"\n'


@pytest.fixture
def _emitted_once(emission: Emission, monkeypatch: pytest.MonkeyPatch) -> None:
    """Let ``pkmodes check`` take what another test has emitted, or what it emits be that of others."""
    monkeypatch.setattr(product, "parametric", emission.parametric)


@pytest.mark.slow
@pytest.mark.usefixtures("_emitted_once")
def test_the_committed_model_and_the_robots_hold(capsys: pytest.CaptureFixture[str]) -> None:
    robots = sorted(str(path) for path in PUBLISHED.parent.glob("*.toml"))
    assert run(["check"]) == 0
    assert run(["check", *robots]) == 0
    assert capsys.readouterr().out.count("current\n") == len(registry.names()) + len(robots)


def test_long_rails_and_short_links_are_no_false_alarm(tmp_path: Path) -> None:
    text = (
        published().replace('"400 mm"', '"250 mm"').replace('200 mm"', '100 mm"').replace('"1.2 m"', '"6 m"')
    )
    (tmp_path / "robot.toml").write_text(text, encoding="utf-8")
    assert run(["check", str(tmp_path / "robot.toml")]) == 0


@pytest.mark.usefixtures("_emitted_once")
@pytest.mark.parametrize("target", [[], ["robot.toml"], ["model"]])
def test_current_but_inconsistent_code_fails(
    copy: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], target: list[str]
) -> None:
    failed = [Check("gravity Hessian", 0.5, 1e-10)]
    monkeypatch.setattr(products, "check_consistency", lambda *_: failed)
    assert run(["check", *(str(copy / name) for name in target)]) == 1
    out = capsys.readouterr().out
    assert "gravity Hessian: relative error 5.0e-01, expected at most 1e-10" in out
    assert "mend" not in out, "generating again would not help"


def test_a_specialised_model_that_differs_from_the_parametric_one_fails(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    mechanism = registry.mechanism("linear_delta")
    monkeypatch.setitem(vars(mechanism), "model", Broken("modal_matrices", 1 + 1e-9))
    assert run(["check", str(PUBLISHED)]) == 1
    assert "M of the parametric model: relative error 1.0e-09" in capsys.readouterr().out


def test_a_model_with_a_massless_clamp_has_an_eigenproblem(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """The steps of a new user: generate, import, solve with SciPy."""
    (tmp_path / "robot.toml").write_text(published() + CLAMP, encoding="utf-8")
    assert run(["generate", str(tmp_path / "robot.toml"), "--out", str(tmp_path / "model")]) == 0
    assert run(["check", str(tmp_path / "model")]) == 0
    assert "relations agree with finite differences" in capsys.readouterr().out
    module = runpy.run_path(str(tmp_path / "model" / MODULE))
    assert module["__doc__"].count("Coordinates without inertia: eps_1, eps_2, eps_3.") == 1
    assert "Coordinates without inertia: eps_1" in (tmp_path / "model" / "linear_delta_2022.h").read_text(
        encoding="utf-8"
    )
    pose = [0.6, 0.03, -0.245]
    M, K = module["modal_matrices"](pose)
    assert M.shape == (len(module["COORDINATES"]),) * 2
    expected = pkmodes.load(tmp_path / "robot.toml").modes(pose).frequencies[3:]
    np.testing.assert_allclose(np.sqrt(eigh(K, M, eigvals_only=True)[3:]) / (2 * np.pi), expected, rtol=1e-10)
    every = module["condensation"](pose)
    uncondensed_M, uncondensed_K = module["uncondensed_matrices"](pose)
    assert not uncondensed_M[9:].any()
    np.testing.assert_allclose(every.T @ uncondensed_K @ every, K, rtol=0, atol=1e-12 * K.max())


@pytest.mark.parametrize(
    ("broken", "check"),
    [
        ("modal_matrices", "K of the parametric model"),
        ("uncondensed_matrices", "uncondensed K of the parametric model"),
        ("condensation", "condensation of the parametric model"),
        ("platform_motion", "platform motion of the parametric model"),
        ("elastic_gradient", "elastic gradient (complex step)"),
        ("velocity_forces", "velocity forces (complex step)"),
        ("belt_spans", "belt spans (complex step)"),
    ],
)
def test_a_wrong_function_of_a_model_with_effects_is_found(
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    broken: str,
    check: str,
) -> None:
    (tmp_path / "robot.toml").write_text(published() + CLAMP, encoding="utf-8")
    executed = products._execute_module

    def spoilt(texts: dict[str, str]) -> object:
        module = executed(texts)
        if not hasattr(module, broken):  # the module without effects
            return module
        right = getattr(module, broken)

        def wrong(*arguments: object) -> object:
            found = right(*arguments)
            return tuple(1.001 * a for a in found) if isinstance(found, tuple) else 1.001 * found

        setattr(module, broken, wrong)
        return module

    monkeypatch.setattr(products, "_execute_module", spoilt)
    assert run(["check", str(tmp_path / "robot.toml")]) == 1
    assert check in capsys.readouterr().out


def test_a_missing_generator_is_named(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setitem(sys.modules, "pkmodes_derive.emit.product", None)
    with pytest.raises(pkmodes.PkmodesError, match=r"pip install 'jinja2>=3\.1' sympy==1\.14\.0"):
        products.check_committed("linear_delta")
    with (PUBLISHED.parents[1] / "pyproject.toml").open("rb") as file:
        declared = tomllib.load(file)["project"]["optional-dependencies"]["derive"]
    assert list(REQUIREMENTS) == declared
    assert run(["check"]) == 2
    assert "is not installed" in capsys.readouterr().err
