# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""identify() feels slabs as the closed forms predict, and confuses them as signal detection theory predicts."""

import math

import numpy as np
import pytest
from volumehaptics import identify, touch, vtkHapticProperty


def phi(x):
    return 0.5 * math.erfc(-x / math.sqrt(2))


def at(units, floor=0.05, start=1.0):
    """Returns the force whose perceived distance from `start` is `units` times the noise, for a Weber fraction of
    0.1."""
    return (start + floor) * 1.1**units - floor


@pytest.mark.parametrize("distance", (0.5, 1.0, 2.0, 3.0))
def test_two_are_told_apart_by_phi_of_half_their_distance(distance):
    """At a depth of 2 mm, 500 N/m gives 1 N; a surface strength above 4 N makes no difference."""
    near = {"stiffness": 500.0, "surface_strength": 100.0}
    far = {"stiffness": 500.0 * at(distance), "surface_strength": 100.0}
    # Both materials yield at 4 N, which the force would exceed at 10 mm.
    found = identify({"near": near, "far": far}, strategy="depth")
    assert abs(found.distance[0, 1] - distance) < 0.02
    assert np.allclose(np.diag(found.confusion), phi(distance / 2), atol=0.008)
    assert np.allclose(found.confusion.sum(axis=1), 1)
    assert found.correct == pytest.approx(2 * phi(distance / 2), abs=0.012)


def test_cues_are_the_closed_forms():
    """Under a constant force f, the cues are f/k, mu f and T_N; at a constant depth d, the cue is min(k d, T_N)."""
    materials = {
        "firm": {"stiffness": 800, "friction": 0.25, "surface_strength": 3.0},
        "weak": {"stiffness": 400, "friction": 0.0, "surface_strength": 0.3},
    }
    force = identify(materials)
    assert force.names == ("firm", "weak")
    assert np.allclose(force.cues[0], (1.25, 0.25, 3.0), atol=0.03)
    assert np.allclose(force.cues[1], (10.0, 0.0, 0.3), atol=0.01)
    depth = identify(materials, strategy="depth")
    assert np.allclose(depth.cues[0], (1.6, 0.4, 3.0), atol=0.03)
    assert np.allclose(depth.cues[1], (0.3, 0.0, 0.3), atol=0.01)
    assert "mm" in force.cue_names[0] and "(N)" in depth.cue_names[0]
    assert identify(materials, strategy="depth", depth=1.0).cues[0, 0] == pytest.approx(0.8, abs=0.02)
    assert identify(materials, force=0.5).cues[0, 0] == pytest.approx(0.625, abs=0.06)


def test_twins_are_confused_and_strangers_are_not():
    found = identify({"a": {"stiffness": 300}, "twin": {"stiffness": 300}, "bone": {"stiffness": 1000}})
    assert found.distance[0, 1] == pytest.approx(0, abs=1e-9)
    assert found.confusion[2, 2] > 0.99
    assert found.confusion[0, :2].sum() > 0.99
    assert found.correct == pytest.approx(2, abs=0.02)
    assert "of 3 right" in str(found) and "twin" in str(found)


def test_a_finer_hand_is_right_more_often():
    materials = {"a": {"stiffness": 300}, "b": {"stiffness": 330}}
    assert identify(materials, weber=0.02).correct > identify(materials, weber=0.1).correct + 0.3


def test_scalar_values_are_felt_with_a_preset_or_a_property():
    tissues = {"muscle": 50.0, "bone": 900.0, "bone under muscle": (50.0, 900.0)}
    found = identify(tissues, "CT contrast")
    assert found.confusion[0, 0] > 0.9
    assert found.cues[1, 2] > found.cues[0, 2] + 0.5, "bone yields later"
    feel = vtkHapticProperty()
    feel.ApplyPreset("CT contrast")
    assert np.array_equal(identify(tissues, property=feel).cues, found.cues)


def test_traces_are_strokes_at_constant_depth():
    volume = np.broadcast_to(100.0 * np.arange(32).reshape(-1, 1, 1), (32, 17, 33)).copy()
    down = np.linspace((8, 8, 10), (8, 8, 12), 41)
    aside = np.linspace((8, 8, 12), (20, 8, 12), 241)

    def stroke(friction):
        feel = vtkHapticProperty()
        feel.GetFriction().AddPoint(0.0, friction)
        trace = touch(volume, np.concatenate((down, aside)), property=feel)
        return trace

    smooth, rough = stroke(0.05), stroke(0.5)
    found = identify({"smooth": [smooth, smooth], "rough": rough}, strategy="depth")
    assert np.allclose(found.cues[:, 0], found.cues[0, 0], atol=0.05)
    assert found.cues[1, 1] > 5 * found.cues[0, 1]
    assert found.correct > 1.9
    with pytest.raises(ValueError, match="'rough'.*'depth'|'smooth'.*'depth'"):
        identify({"smooth": smooth, "rough": rough})


SOFT = {"soft": {"stiffness": 100}, "hard": {"stiffness": 900}}


@pytest.mark.parametrize("error, words, arguments", (
    (ValueError, "two materials", {"materials": {"soft": {"stiffness": 100}}}),
    (TypeError, "mapping of names, not list", {"materials": [1.0, 2.0]}),
    (TypeError, "'stiffnes'.*is it 'stiffness'", {"materials": {**SOFT, "odd": {"stiffnes": 1.0}}}),
    (TypeError, "stiffness of 'odd'.*'firm'", {"materials": {**SOFT, "odd": {"stiffness": "firm"}}}),
    (ValueError, "friction of 'odd'.*-1", {"materials": {**SOFT, "odd": {"friction": -1}}}),
    (ValueError, "stiffness of 'odd'.*nan", {"materials": {**SOFT, "odd": {"stiffness": math.nan}}}),
    (TypeError, "'odd'.*None", {"materials": {**SOFT, "odd": None}}),
    (TypeError, "'odd'", {"materials": {**SOFT, "odd": []}}),
    (ValueError, "'muscle'.*preset", {"materials": {**SOFT, "muscle": 50.0}}),
    (ValueError, "bones", {"materials": {**SOFT, "muscle": 50.0}, "preset": "bones"}),
    (ValueError, "'push'.*'force' and 'depth'", {"strategy": "push"}),
    (ValueError, "weber.*0", {"weber": 0}),
    (TypeError, "weber.*'ten'", {"weber": "ten"}),
    (ValueError, "force.*inf", {"force": math.inf}),
    (ValueError, "depth=11", {"depth": 11.0, "strategy": "depth"}),
    (TypeError, "kernel_radus.*kernel_radius", {"kernel_radus": 3}),
))
def test_errors_name_what_is_wrong(error, words, arguments):
    with pytest.raises(error, match=words):
        identify(**{"materials": SOFT, **arguments})
