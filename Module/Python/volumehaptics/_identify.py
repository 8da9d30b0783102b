# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""An ideal hand that distinguishes materials as well as human senses allow."""

from __future__ import annotations

import difflib
import math
import numbers
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from vtkmodules.vtkCommonDataModel import vtkPiecewiseFunction, vtkPolyData

from ._touch import touch
from .arrays import arrays, image
from .vtkVolumeHaptics import vtkHapticProperty

__all__ = ["identify"]

_STRATEGIES = ("force", "depth")
_MATERIAL = ("stiffness", "friction", "viscosity", "surface_strength")
_TICK = 0.05  # mm, step of the hand per tick
_ABOVE = 6.0  # mm: height of the hand above an edge at the start
_DEEPEST = 10.0  # mm, largest depth of the hand
_STROKE = 10.0  # mm, length of a stroke
_STRONGEST = 4.0  # N: the strongest force of a press
_STEADY = 0.4  # fraction of the stroke after which cues are measured
_FLOORS = {"mm": 0.5, "N": 0.05}  # limits below which the senses are assumed to deviate from Weber's law
_DRAWS = 100_000


@dataclass(frozen=True)
class Identification:
    """How well an ideal hand distinguishes materials.

    names: names of the materials, in the order of all other members.
    cue_names: the quantities that the hand measures, with units.
    cues: the measured values, of shape (materials, cues); the mean if a material was touched more than once.
    distance: d' of each pair, in units of the noise of the senses.
    confusion: confusion[i, j] is the probability that material i is named j.
    correct: the expected number of correctly named materials, which is the sum of the diagonal.
    """

    names: tuple[str, ...]
    cue_names: tuple[str, ...]
    cues: np.ndarray
    distance: np.ndarray
    confusion: np.ndarray
    correct: float

    def __str__(self) -> str:
        width = max(len(name) for name in self.names)
        head = " " * width + "".join(f" {name:>{max(6, len(name))}}" for name in self.names)
        rows = [
            f"{name:<{width}}" + "".join(
                f" {share:{max(6, len(other))}.1%}" for share, other in zip(row, self.names))
            for name, row in zip(self.names, self.confusion)
        ]
        return "\n".join([head, *rows, f"{self.correct:.2f} of {len(self.names)} right"])


def _function(value: float) -> vtkPiecewiseFunction:
    function = vtkPiecewiseFunction()
    function.AddPoint(0.0, value)
    return function


def _constant(name: str, material: Mapping[str, float]) -> vtkHapticProperty:
    """Makes a property that has the same material everywhere."""
    feel = vtkHapticProperty()
    feel.SetDistinctness(_function(1.0))
    for key, value in material.items():
        if key not in _MATERIAL:
            close = difflib.get_close_matches(str(key), _MATERIAL, 1, 0.4)
            hint = f"is it {close[0]!r}? " if close else ""
            raise TypeError(f"{name!r} has {key!r}, which no material has; {hint}there are {', '.join(_MATERIAL)}")
        if isinstance(value, bool) or not isinstance(value, numbers.Real):
            raise TypeError(f"{key} of {name!r} is a number, not {value!r}")
        if not (math.isfinite(value) and value >= 0):
            raise ValueError(f"{key} of {name!r} is 0 or more, not {value!r}")
        getattr(feel, f"Set{key.title().replace('_', '')}")(_function(float(value)))
    return feel


def _slab(values: tuple[float, float] | None, margin: int) -> Any:
    """Makes a volume with two values, outside and inside of a surface at z = 0 with an edge of one voxel. Without
    values, makes a volume that has surfaces everywhere."""
    low = np.array((-margin, -margin, -margin - int(_ABOVE)))
    high = np.array((int(_STROKE) + margin, margin, int(_DEEPEST) + margin))
    z = np.arange(low[2], high[2] + 1, dtype=np.float64)
    if values is None:
        profile = 100.0 * z
    else:
        share = np.array([0.5 * math.erfc(-one / math.sqrt(2)) for one in z])
        profile = values[0] + (values[1] - values[0]) * share
    shape = (len(z), high[1] - low[1] + 1, high[0] - low[0] + 1)
    return image(np.ascontiguousarray(np.broadcast_to(profile[:, None, None], shape)), origin=tuple(map(float, low)))


def _way(start: float, depth: float, stroke: float) -> np.ndarray:
    """Makes a path that goes down to a depth, then aside."""
    down = np.arange(start, depth + 0.5 * _TICK, _TICK)
    aside = np.arange(_TICK, stroke + 0.5 * _TICK, _TICK)
    points = np.zeros((len(down) + len(aside), 3))
    points[: len(down), 2] = down
    points[len(down):, 2] = down[-1]
    points[len(down):, 0] = aside
    return points


def _on_slab(slab: Any, above: float, strategy: str, force: float, depth: float, settings: dict[str, Any]) -> list:
    """Computes the cues of one material."""
    down = _way(-above, _DEEPEST, 0.0)
    normal = -arrays(touch(slab, down, **settings))["Force"][:, 2]
    if strategy == "force":
        held = np.flatnonzero(normal >= force)
        depth = down[held[0], 2] if len(held) else _DEEPEST
    felt = arrays(touch(slab, _way(-above, depth, _STROKE), **settings))["Force"]
    steady = felt[-int((1.0 - _STEADY) * _STROKE / _TICK):]
    pressed = max(0.0, depth) if strategy == "force" else max(0.0, -steady[:, 2].mean())
    return [pressed, max(0.0, -steady[:, 0].mean()), min(max(0.0, normal.max()), _STRONGEST)]


def _of_trace(name: str, trace: vtkPolyData) -> list:
    found = arrays(trace)
    if not {"NormalForce", "FrictionForce", "DragForce"} <= found.keys() or not trace.GetNumberOfPoints():
        raise ValueError(f"a trace of {name!r} has no forces. Cure: what touch() or a filter's GetOutput() gives")
    normal = found["NormalForce"]
    pressed = normal > 0
    aside = (found["FrictionForce"] + found["DragForce"])[pressed if pressed.any() else slice(None)]
    return [normal[pressed].mean() if pressed.any() else 0.0, aside.mean(), min(normal.max(), _STRONGEST)]


def _confusion(places: list[np.ndarray]) -> tuple[np.ndarray, np.ndarray]:
    """Returns d' of each pair, and the probabilities of names, from the cues perceived at some positions on each
    material."""
    mean = np.array([one.mean(axis=0) for one in places])
    variance = 1.0 + np.array([one.var(axis=0) for one in places])
    random = np.random.default_rng(11)
    confusion = np.empty((len(places), len(places)))
    for i, one in enumerate(places):
        percept = one[np.arange(_DRAWS) % len(one)] + random.standard_normal((_DRAWS, one.shape[1]))
        off = percept[:, None, :] - mean
        unlike = (off**2 / variance + np.log(variance)).sum(axis=2)
        confusion[i] = np.bincount(unlike.argmin(axis=1), minlength=len(places)) / _DRAWS
    return np.linalg.norm(mean[:, None] - mean, axis=2), confusion


def _positive(name: str, value: float) -> None:
    if isinstance(value, bool) or not isinstance(value, numbers.Real):
        raise TypeError(f"{name} is a number, not {value!r}")
    if not (math.isfinite(value) and value > 0):
        raise ValueError(f"{name} is above 0, not {value!r}")


def _is_values(material: Any) -> bool:
    """Whether a material is a scalar value inside, or a pair of values, outside and inside."""
    pair = material if isinstance(material, tuple) else (material,)
    return len(pair) in (1, 2) and all(isinstance(one, numbers.Real) for one in pair)


def identify(
    materials: Mapping[str, Any],
    preset: str | None = None,
    strategy: str = "force",
    *,
    force: float = 1.0,
    depth: float = 2.0,
    weber: float = 0.1,
    outside: float = -1000.0,
    **settings: Any,
) -> Identification:
    """Computes which materials a hand could distinguish, before anyone has touched them.

    An ideal hand presses on each material, strokes it, and presses until it yields. It knows how each of them feels,
    and makes errors only because human senses are coarse: it confuses cues that differ by about a Weber fraction.

    materials: by name; each is one of these, and kinds may be mixed: a mapping with stiffness (N/m), friction,
        viscosity (N) and surface_strength (N); missing ones have the default of vtkHapticProperty;
        a scalar value (such as HU), or a tuple of two, outside and inside: a slab of this value, felt with the preset
            or the property;
        a trace of touch(), or a list of them: strokes over data at constant depth, for strategy "depth".
    preset: the materials of scalar values, as in touch().
    strategy: "force", the hand strokes with a constant force and measures its depth (10 mm at most); "depth", it
        strokes at a constant depth and measures the force. Either way it measures the force against the stroke and the
        force at which the material yields (4 N at most).
    force: the constant force of strategy "force" (N).
    depth: the constant depth of strategy "depth" (mm).
    weber: the Weber fraction: a difference of a cue by this fraction is as large as the noise of the senses, d' = 1.
    outside: the scalar value outside slabs that are given by one value.
    settings: settings of vtkVolumeHapticsFilter for slabs, as in touch().

    Of two materials that are d' apart the hand names the right one with probability Phi(d'/2), Phi being the normal
    distribution function. Documentation/evaluation.md has the model and the thresholds of the literature.

    TypeError: a setting, a material or a number of another kind. ValueError: fewer than two materials, or a value that
    can't be touched; the text has the reason.

    >>> from volumehaptics import identify
    >>> found = identify({"fat": {"stiffness": 150}, "muscle": {"stiffness": 350}, "more muscle": {"stiffness": 351}})
    >>> found.confusion[0].round(2).tolist()
    [1.0, 0.0, 0.0]
    """
    if strategy not in _STRATEGIES:
        raise ValueError(f"strategy={strategy!r} is not known; there are {' and '.join(map(repr, _STRATEGIES))}")
    for name, value in (("force", force), ("depth", depth), ("weber", weber)):
        _positive(name, value)
    if depth > _DEEPEST:
        raise ValueError(f"depth={depth!r} is beyond the {_DEEPEST:g} mm that the hand presses")
    if not isinstance(materials, Mapping):
        raise TypeError(f"materials are a mapping of names, not {type(materials).__name__}")
    if len(materials) < 2:
        raise ValueError(f"there must be two materials at least to tell apart, not {len(materials)}")
    margin = 4 + 2 * int(settings.get("kernel_radius", 2))
    cues: list[np.ndarray] = []
    for name, material in materials.items():
        if isinstance(material, Mapping):
            own = {**settings, "property": _constant(name, material)}
            found = [_on_slab(_slab(None, margin), 0.0, strategy, force, depth, own)]
        elif _is_values(material):
            if preset is None and "property" not in settings:
                raise ValueError(f"{name!r} is a scalar value, which needs a preset or a property to be felt")
            pair = material if isinstance(material, tuple) and len(material) == 2 else (outside, material)
            values = tuple(float(np.ravel(one)[0]) for one in pair)
            own = settings if preset is None else {**settings, "preset": preset}
            found = [_on_slab(_slab(values, margin), _ABOVE, strategy, force, depth, own)]
        else:
            traces = [material] if isinstance(material, vtkPolyData) else material
            if not isinstance(traces, Sequence) or not traces or not all(isinstance(t, vtkPolyData) for t in traces):
                raise TypeError(f"{name!r} is a mapping, a scalar value, a tuple (outside, inside) or traces, not "
                                f"{material!r}")
            if strategy == "force":
                raise ValueError(f"{name!r} was stroked already: of traces, strategy is 'depth'")
            found = [_of_trace(name, trace) for trace in traces]
        cues.append(np.array(found, float))
    units = ("mm" if strategy == "force" else "N", "N", "N")
    floors = np.array([_FLOORS[unit] for unit in units])
    distance, confusion = _confusion([np.log1p(one / floors) / math.log1p(weber) for one in cues])
    return Identification(
        names=tuple(map(str, materials)),
        cue_names=(f"{'depth' if strategy == 'force' else 'force'} ({units[0]})", "force against the stroke (N)",
                   "force at which it yields (N)"),
        cues=np.array([one.mean(axis=0) for one in cues]),
        distance=distance,
        confusion=confusion,
        correct=float(np.trace(confusion)),
    )
