# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Volumes that move by formulas, so that the place of everything is known at all times.

A series has frames, each with its values and with the displacement of the material to the next frame, in millimetres;
after the last frame comes the first one again. Values are indexed [z, y, x], displacements [z, y, x, axis].
"""

import math

import numpy as np

# The beating phantom: a hollow ball of muscle around contrast medium, in fat.
BEAT_SIZE = 56
BEAT_SPACING = 1.5
BEAT_ORIGIN = -0.5 * (BEAT_SIZE - 1) * BEAT_SPACING
BEAT_INSIDE, BEAT_OUTSIDE = 16.0, 25.0  # mm, the radii of the wall at the end of filling
BEAT_STROKE = 4.0  # mm by which the inner radius shrinks in a beat
BEAT_BLUR = 1.5  # mm, of the edges
BEAT_CORE = 8.0  # mm; closer to the centre, the outflow is not modelled
BEAT_HU = {"contrast": 250.0, "muscle": 55.0, "fat": -100.0}

# The breath moves everything down: most in the middle, by this distance, and not at all at the borders.
BREATH_DEPTH = 12.0  # mm


def share_of(frame, frames):
    """0 to 1 and back over a period, as a smooth motion."""
    return 0.5 - 0.5 * math.cos(2.0 * math.pi * frame / frames)


def beat_volume(frame, frames):
    """By how much (mm^3 over 4 pi / 3) the inside has shrunk. Muscle can't be compressed: it moves by the same volume."""
    return BEAT_INSIDE**3 - (BEAT_INSIDE - BEAT_STROKE * share_of(frame, frames)) ** 3


erf = np.vectorize(math.erf, otypes=[float])  # NumPy has no erf


def beating_frame(frame, frames):
    """The heart at a frame: values (HU, int16), and the displacement to the next frame (float32)."""
    axis = BEAT_ORIGIN + BEAT_SPACING * np.arange(BEAT_SIZE)
    points = np.stack(np.meshgrid(axis, axis, axis, indexing="ij")[::-1], axis=-1)
    radius = np.sqrt((points * points).sum(axis=-1))
    shrunk = beat_volume(frame, frames)

    material = np.cbrt(radius**3 + shrunk)  # the radius of the same material when the heart is full

    def outside(wall):
        """1 beyond a wall: blurred where the heart is full, so that the blur moves with the material."""
        return 0.5 + 0.5 * erf((material - wall) / (BEAT_BLUR * math.sqrt(2.0)))

    hu = BEAT_HU
    values = hu["contrast"] + (hu["muscle"] - hu["contrast"]) * outside(BEAT_INSIDE)
    values += (hu["fat"] - hu["muscle"]) * outside(BEAT_OUTSIDE)
    flow = beat_volume(frame + 1, frames) - shrunk

    def moved(r):
        return np.cbrt(r**3 - flow)

    at = np.maximum(radius, BEAT_CORE)
    factor = moved(at) / at - 1.0  # along the radius; in the core it grows from 0 in proportion
    return np.rint(values).astype(np.int16), (factor[..., None] * points).astype(np.float32)


class Breath:
    """A volume that breathes: X goes to X - share BREATH_DEPTH f(X) along z, with f a bump that is 0 at the borders."""

    def __init__(self, values, origin, spacing):
        self.values = values
        self.axes = [o + s * np.arange(n) for o, s, n in zip(origin, spacing, values.shape[::-1])]

    def bump(self, axis, at):
        """cos^2 over the extent of the volume along an axis."""
        first, last = self.axes[axis][0], self.axes[axis][-1]
        return np.sin(math.pi * np.clip((at - first) / (last - first), 0.0, 1.0)) ** 2

    def depth(self, z):
        """BREATH_DEPTH f at heights z, an array [z, y, x]; for thin volumes less, so that nothing folds."""
        x, y, heights = self.axes
        most = min(BREATH_DEPTH, 0.15 * abs(heights[-1] - heights[0]))
        return most * self.bump(2, z) * self.bump(1, y)[None, :, None] * self.bump(0, x)[None, None, :]

    def material(self, share):
        """The height from which the material of each voxel comes: z = Z - share depth(Z), by fixed points."""
        heights = np.broadcast_to(self.axes[2][:, None, None], self.values.shape)
        height = heights
        for _ in range(40):  # each step at least halves the error
            height = heights + share * self.depth(height)
        return height

    def frame(self, frame, frames):
        """Values of the type of the volume, by linear interpolation, and the displacement (float32)."""
        share = share_of(frame, frames)
        height = self.material(share)
        heights = self.axes[2]
        index = np.clip((height - heights[0]) / (heights[1] - heights[0]), 0.0, heights.size - 1.0)
        low = np.minimum(index.astype(np.int64), heights.size - 2)
        before = np.take_along_axis(self.values, low, axis=0).astype(np.float64)
        after = np.take_along_axis(self.values, low + 1, axis=0).astype(np.float64)
        values = before + (index - low) * (after - before)
        if np.issubdtype(self.values.dtype, np.integer):
            values = np.rint(values)
        motion = np.zeros((*self.values.shape, 3), np.float32)
        motion[..., 2] = (share - share_of(frame + 1, frames)) * self.depth(height)
        return values.astype(self.values.dtype), motion
