"""Modes of frequency responses against structures whose modes are known, solved line by line from their matrices."""

from __future__ import annotations

import numpy as np
import pytest

from pkmodes.core.base.errors import MeasurementError
from pkmodes.modaltest.identification.estimates import rotate_to_real
from pkmodes.modaltest.identification.frf_identification import identify_frf
from pkmodes.modaltest.identification.frf_lines import select_lines
from pkmodes.modaltest.identification.frf_skirts import find_tone_lines
from pkmodes.modaltest.identification.modes import IdentifiedModes
from pkmodes_rig.structures.forced import mac, noise, random_structure, structure

BAND = (10.0, 400.0)
LINES = np.arange(10.0, 400.0, 0.25)


def rms(H: np.ndarray) -> float:
    return float(np.sqrt((np.abs(H) ** 2).mean()))


@pytest.mark.parametrize("power", [0, 1, 2])
def test_exact_responses_give_exact_modes(power: int) -> None:
    s = random_structure(np.random.default_rng(1))
    H = s.response(LINES, [0, 1, 2, 3], [0, 1], power)
    e = identify_frf(LINES, H, band=BAND, derivative_order=power)
    assert len(e.modes) == 6
    for m, mode in enumerate(e.modes):
        assert mode.frequency == pytest.approx(s.frequencies[m], rel=3e-5)
        assert mode.damping == pytest.approx(s.damping[m], rel=1e-3)
        assert mac(mode.shape, s.shapes[:4, m]) > 0.99999
        assert mode.complexity > 0.999
    assert rms(e.synthesised - H) < 0.02 * rms(H)


def test_two_modes_one_per_cent_apart() -> None:
    rng = np.random.default_rng(2)
    for f0 in (60.0, 140.0, 290.0):
        s = structure(np.array([30.0, f0, 1.01 * f0, 700.0]), np.array([0.01, 0.005, 0.008, 0.02]), rng)
        H = s.response(LINES, [0, 1, 2], [0, 1], 2)
        modes = identify_frf(LINES, H + noise(rng, H, 0.01 * rms(H)), band=BAND, derivative_order=2).modes
        near = [mode for mode in modes if abs(mode.frequency / f0 - 1.0) < 0.03]
        assert len(near) == 2
        assert all(mac(mode.shape, s.shapes[:3, 1 + k]) > 0.95 for k, mode in enumerate(near))


def test_noise_alone_holds_no_mode() -> None:
    for seed in range(5):
        H = noise(np.random.default_rng(seed), np.zeros((800, 4, 1), complex), 1.0)
        assert (
            identify_frf(10.0 + 0.5 * np.arange(800), H, band=(10.0, 409.5), derivative_order=2).modes == ()
        )


def test_scale_of_sensors_and_references_does_not_matter() -> None:
    rng = np.random.default_rng(3)
    s = random_structure(rng)
    H = s.response(LINES, [0, 1, 2], [0, 1], 2)
    H = H + noise(rng, H, 0.01 * rms(H))
    plain = identify_frf(LINES, H, band=BAND, derivative_order=2).modes
    scaled = identify_frf(LINES, H * np.array([1e-6, 1.0, 1e5])[:, None], band=BAND, derivative_order=2).modes
    assert [m.frequency for m in scaled] == pytest.approx([m.frequency for m in plain], rel=1e-7)


def test_pairs_of_sensor_and_reference_may_be_missing() -> None:
    rng = np.random.default_rng(4)
    s = random_structure(rng)
    H = s.response(LINES, [0, 1, 2, 3], [0, 1], 2)
    H = H + noise(rng, H, 0.003 * rms(H))
    H[:, 1, 0] = H[:, 2, 1] = H[:, 3, :] = np.nan
    modes = identify_frf(LINES, H, band=BAND, derivative_order=2).modes
    assert len(modes) == 6
    for m, mode in enumerate(modes):
        assert np.isnan(mode.shape[3])
        seen = np.isfinite(mode.shape)
        assert mac(mode.shape[seen], s.shapes[:4, m][seen]) > 0.99


def test_a_tone_is_no_mode_and_a_mode_beside_it_is() -> None:
    rng = np.random.default_rng(5)
    s = structure(np.array([50.6, 120.0, 600.0]), np.array([0.01, 0.01, 0.01]), rng)
    H = s.response(LINES, [0, 1, 2], [0], 2)
    H = H + noise(rng, H, 0.003 * rms(H))
    for tone in (50.0, 100.0, 150.0):
        H[np.argmin(np.abs(LINES - tone))] += 0.5 * np.abs(H).max()
    modes = identify_frf(LINES, H, band=BAND, derivative_order=2, tones=[50.0]).modes
    assert [m.frequency for m in modes] == pytest.approx([50.6, 120.0], rel=1e-3)


def test_references_that_disagree_widen_sigma_and_make_no_second_mode() -> None:
    rng = np.random.default_rng(6)
    s = random_structure(rng)
    H = s.response(LINES, [0, 1, 2, 3], [0, 1], 2)
    moved = s.response(LINES * 1.0005, [0, 1, 2, 3], [1], 2)
    other = np.concatenate([H[..., :1], moved], axis=2)
    e = noise(rng, H, 0.003 * rms(H))
    plain, shifted = (identify_frf(LINES, X + e, band=BAND, derivative_order=2).modes for X in (H, other))
    assert len(plain) == len(shifted) == 6
    for one, two in zip(plain, shifted, strict=True):
        assert two.sigma_frequency > one.sigma_frequency
        assert two.sigma_frequency > 0.5 * 0.0005 / 2.0 * two.frequency


@pytest.mark.slow
def test_two_sigma_covers_and_nothing_is_false() -> None:
    """60 random structures with white noise; the limits are the issue's, with the scatter of the count."""
    found = total = false = 0
    errors: dict[str, list[float]] = {"frequency": [], "damping": [], "shape": []}
    for seed in range(70_000, 70_060):
        rng = np.random.default_rng(seed)
        s = random_structure(rng, int(rng.integers(3, 8)))
        f = np.arange(10.0, 400.0, 0.5)
        outputs = list(range(min(6, len(s.M))))
        H = s.response(f, outputs, [0, 1][: 1 + seed % 2], seed % 3)  # one reference in every other structure
        sigma = 10 ** rng.uniform(-2.5, -0.8) * np.sqrt((np.abs(H) ** 2).mean(axis=(0, 2)))[:, None]
        modes = identify_frf(f, H + noise(rng, H, sigma), band=BAND, derivative_order=seed % 3).modes
        used = set()
        for m in np.flatnonzero(s.frequencies < BAND[1]):
            pole = 2.0 * np.pi * s.frequencies[m] * (1j - s.damping[m])
            peak = np.abs(np.outer(s.shapes[outputs, m], s.shapes[: 1 + seed % 2, m])) * abs(pole) ** (
                seed % 3 - 1
            )
            visible = (peak / (2.0 * abs(pole.real)) / sigma).max() > 10**0.5
            total += visible
            near = [k for k in range(len(modes)) if abs(modes[k].frequency / s.frequencies[m] - 1.0) < 0.01]
            if not near:
                continue
            k = min(near, key=lambda k: abs(modes[k].frequency - s.frequencies[m]))
            used.add(k)
            if not visible:
                continue
            found += 1
            mode, a = modes[k], rotate_to_real(modes[k].shape).real
            best = int(np.argmax(np.abs(a)))
            b = s.shapes[outputs, m] / s.shapes[outputs[best], m]
            errors["frequency"].append((mode.frequency - s.frequencies[m]) / mode.sigma_frequency)
            errors["damping"].append((mode.damping - s.damping[m]) / mode.sigma_damping)
            errors["shape"] += list(np.delete(a - b, best) / mode.sigma_shape)
        false += len(modes) - len(used)
    covered = {name: float(np.mean(np.abs(z) < 2.0)) for name, z in errors.items()}
    assert found >= 0.95 * total
    assert false <= 0.02 * total
    assert all(0.90 <= share <= 0.99 for share in covered.values()), covered


def test_too_few_lines_and_no_complete_function_are_refused() -> None:
    H = np.ones((100, 2, 1), complex)
    with pytest.raises(MeasurementError, match="24 lines, found 3"):
        identify_frf(np.arange(100.0), H, band=(10.0, 12.0), derivative_order=2)
    with pytest.raises(MeasurementError, match="without gaps"):
        identify_frf(np.arange(100.0), H * np.nan, band=(10.0, 90.0), derivative_order=2)


def test_lines_at_a_stated_tone_do_not_bend_the_mode_beside_it() -> None:
    """Without the tone's lines the mode is as exact as without the tone."""
    rng = np.random.default_rng(6)
    s = structure(np.array([50.6, 120.0, 600.0]), np.array([0.01, 0.01, 0.01]), rng)
    H = s.response(LINES, [0, 1, 2], [0], 2)
    H = H + noise(rng, H, 0.003 * rms(H))
    plain = identify_frf(LINES, H, band=BAND, derivative_order=2).modes[0]
    loud = H.copy()
    loud[LINES == 50.0] += 3.0 * np.abs(H).max() * np.exp(1j * rng.uniform(0.0, 6.0, (1, 3, 1)))
    near = [
        mode
        for mode in identify_frf(LINES, loud, band=BAND, derivative_order=2, tones=(50.0,)).modes
        if mode.frequency < 60.0
    ]
    assert len(near) == 1
    assert near[0].frequency == pytest.approx(plain.frequency, abs=4.0 * plain.sigma_frequency)
    assert near[0].damping == pytest.approx(plain.damping, abs=4.0 * plain.sigma_damping)
    assert near[0].sigma_frequency < 3.0 * plain.sigma_frequency


def hann_lines(f: np.ndarray, tone: float) -> np.ndarray:
    """The spectrum of a sinusoid under Hann's window (Harris, Proceedings of the IEEE 66(1), 1978)."""
    x = (f - tone) / (f[1] - f[0])
    return (
        np.sinc(x) / (1.0 - np.where(np.abs(np.abs(x) - 1.0) < 1e-9, 0.0, x) ** 2) * np.exp(-1j * np.pi * x)
    )


@pytest.mark.parametrize("width", ["a line", "two lines", "Hann"])
def test_lines_without_bandwidth_are_found_and_do_not_bend_the_modes(width: str) -> None:
    """Mains, a fan and a motor that nobody stated."""
    for seed in (4100, 4101):
        rng = np.random.default_rng(seed)
        s = random_structure(rng, 4)
        H = s.response(LINES, [0, 1, 2], [0], 2)
        H = H + noise(rng, H, 0.003 * rms(H))
        plain = identify_frf(LINES, H, band=BAND, derivative_order=2)
        tones = [at + 0.25 * rng.uniform(0.2, 0.8) for at in (49.75, 211.0, 333.25)]
        loud = H.copy()
        for tone in tones:
            k = int(np.searchsorted(LINES, tone))
            at_lines = {
                "a line": (np.arange(len(LINES)) == k).astype(complex),
                "two lines": ((np.arange(len(LINES)) == k) - 0.7 * (np.arange(len(LINES)) == k - 1)).astype(
                    complex
                ),
                "Hann": np.where(np.abs(LINES - tone) < 3.0, hann_lines(LINES, tone), 0.0),
            }[width]
            loud += 0.3 * np.abs(H).max() * np.einsum("f,s->fs", at_lines, rng.normal(size=3))[:, :, None]
        found = identify_frf(LINES, loud, band=BAND, derivative_order=2)
        assert len(found.modes) == len(plain.modes)
        for one, other in zip(found.modes, plain.modes, strict=True):
            assert abs(one.frequency - other.frequency) < 2.0 * other.sigma_frequency
        assert len(found.tones) == 3
        np.testing.assert_allclose(found.tones, tones, atol=0.25)
        assert plain.tones == ()


@pytest.mark.parametrize("step", [0.125, 0.25])
def test_a_mode_whose_bandwidth_the_lines_do_not_resolve_is_no_tone(step: float) -> None:
    """Damping of 0.1 % at 50 Hz: half a bandwidth is 0.05 Hz, 0.4 or 0.2 of a line."""
    f = np.arange(10.0, 150.0, step)
    for seed in range(4200, 4206):
        rng = np.random.default_rng(seed)
        s = structure(np.array([rng.uniform(49.0, 51.0), 120.0, 400.0]), np.array([0.001, 0.01, 0.02]), rng)
        H = s.response(f, [0, 1, 2], [0], 2)
        e = identify_frf(f, H + noise(rng, H, 0.02 * rms(H)), band=(10.0, 149.0), derivative_order=2)
        assert e.tones == ()
        mode = e.modes[0]
        assert abs(mode.frequency - s.frequencies[0]) < 4.0 * mode.sigma_frequency
        assert mode.damping == pytest.approx(0.001, rel=0.2)


def test_stated_tones_and_their_multiples_are_left_out_of_the_lines() -> None:
    H = noise(np.random.default_rng(4300), np.zeros((len(LINES), 2, 1), complex), 1.0)
    data, _ = select_lines(LINES, H, None, None, None, [50.1])
    left_out = np.setdiff1d(LINES, data.frequencies)
    expected = [at for k in range(1, 8) for at in LINES[np.abs(LINES - 50.1 * k) < 0.2525]]
    np.testing.assert_array_equal(left_out, expected)
    assert len(left_out) >= 14


def test_a_narrow_pole_where_no_lines_are_left_is_a_line_without_bandwidth() -> None:
    """The lines around it are left out already: there is nothing to tell a resonance by."""
    f = np.arange(100.0, 400.0)
    f = f[np.abs(f - 250.0) > 40.0]
    H = np.random.default_rng(1).standard_normal((len(f), 2, 1)).astype(complex)
    data, _ = select_lines(f, H, None, None, None, ())
    poles = 2.0 * np.pi * np.array([-0.2 + 250.0j, -0.2 + 251.0j])
    modes = IdentifiedModes(poles, np.ones((2, 2), complex), np.ones((2, 1), complex))
    found = find_tone_lines(data, modes)
    assert [(round(line.frequency), line.significant) for line in found] == [(250, False)]
