"""Long functions in pieces compute what they compute as a whole."""

from __future__ import annotations

import numpy as np
import pytest

from pkmodes_derive.emit.lanes import pieces
from pkmodes_derive.emit.lanes.pieces import Statement, in_pieces

PARAMETERS, POSE, SHAPE = [0.5, 1.25, -2.0], [3.0, -0.75], [0.125, 7.0]
INPUTS = {
    **{f"a{i}": f"const double a{i} = parameters[{i}]" for i in range(3)},
    **{f"p{i}": f"const lane p{i} = pose[{i}]" for i in range(2)},
    **{f"s{i}": f"const lane s{i} = shape[{i}]" for i in range(2)},
}


def program(rng: np.random.Generator) -> list[Statement]:
    """Random sums and products, of parameters alone, of the pose, and of the mode, and results of the mode."""
    doubles, lanes, of_mode = (["a0", "a1", "a2"], ["p0", "p1"], ["s0", "s1"])
    statements = []
    for i in range(40):
        kind = ("double", "lane", "mode")[i % 3]
        among = {"double": doubles, "lane": doubles + lanes, "mode": doubles + lanes + of_mode}[kind]
        left, right = rng.choice(among, 2)
        name = f"v{i}"
        {"double": doubles, "lane": lanes, "mode": of_mode}[kind].append(name)
        of_type = "double" if kind == "double" else "lane"
        uses = frozenset({str(left), str(right)})
        target, expression = f"const {of_type} {name}", f"0.5*{left} - {right}"
        statements.append(Statement(name, of_type, target, expression, uses, kind == "mode"))
    for k, name in enumerate(rng.choice(of_mode + lanes, 6)):
        statements.append(Statement("", "", f"out[{k}]", str(name), frozenset({str(name)}), True))
    return sorted(statements, key=lambda one: one.repeated)


def run(lines: list[str], known: dict[str, object]) -> None:
    """Carry out assignments, of nothing but what is known and what they define."""
    scope = dict(known)
    for line in lines:
        text = line.strip().removesuffix(";").removeprefix("const double ").removeprefix("const lane ")
        exec(text, {"__builtins__": {}}, scope)


@pytest.mark.parametrize("seed", range(5))
def test_pieces_compute_what_the_whole_does(monkeypatch: pytest.MonkeyPatch, seed: int) -> None:
    statements = program(np.random.default_rng(seed))
    whole, divided = [0.0] * 6, [0.0] * 6
    given: dict[str, object] = {"parameters": PARAMETERS, "pose": POSE, "shape": SHAPE}
    declared = [f"{text};" for text in INPUTS.values()]
    run([*declared, *(line for one in statements for line in one.lines(""))], {**given, "out": whole})
    monkeypatch.setattr(pieces, "MIN_PIECE_LINES", 4)
    parts, body, each = in_pieces("f", statements, INPUTS, {"shape": "const lane *", "out": "lane *"})
    sizes = [int(line.split("[")[1].removesuffix("];")) for line in body[:2]]
    kept = {name: [np.nan] * size for name, size in zip(("numbers", "kept"), sizes, strict=True)}
    assert len(parts) > 8
    for piece, call in zip(parts, [*body[2:], *each], strict=True):
        name, arguments = call.strip().removesuffix(");").split("(")
        assert name == f"lanes_f_{piece.number}"
        own = {**given, **kept, "out": divided, "effects": []}
        run(piece.lines, {one: own[one] for one in arguments.split(", ")})
    assert divided == whole
    assert np.isfinite(whole).all()
    assert len(set(whole)) > 3


def test_what_no_later_piece_needs_is_not_kept(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(pieces, "MIN_PIECE_LINES", 1)
    first = Statement("v", "lane", "const lane v", "p0 + p1", frozenset({"p0", "p1"}), False)
    last = Statement("", "", "out[0]", "p1", frozenset({"p1"}), False)
    parts, body, each = in_pieces("f", [first, last], INPUTS, {})
    assert len(parts) == 2
    assert body[:2] == ["    double numbers[1];", "    lane kept[1];"]
    assert not each
