# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Scalar fields with closed forms, sampled on 1 mm voxels centred on the origin."""

import math

import numpy as np

SLOPE = 100.0  # scalar units per mm
RADIUS = 20.0  # mm, of the ball and of the cavity
SHELL = 8.0  # mm; the radial fields are clamped farther than this from the surface
HALF_WIDTH = 28  # voxels, of the radial fields
WALL_VALUE = 2000.0  # before blurring


class Field:
    """A sampled field: values indexed [z, y, x] and the position of its first voxel."""

    def __init__(self, values, origin):
        self.values = values
        self.origin = origin


def slab():
    """V = SLOPE z, double: rises linearly along +z, the surface of the closed forms is z = 0."""
    z = np.arange(-16.0, 25.0)
    values = np.empty((z.size, 33, 33))
    values[:] = SLOPE * z[:, None, None]
    return Field(values, (-16.0, -16.0, -16.0))


def signed_distance():
    """|p| - RADIUS, clamped to the shell."""
    axis = np.arange(-HALF_WIDTH, HALF_WIDTH + 1.0)
    square = axis * axis
    distance = np.sqrt(square[:, None, None] + square[None, :, None] + square[None, None, :])
    return np.minimum(np.maximum(distance - RADIUS, -SHELL), SHELL)


def ball():
    """V = SLOPE (RADIUS - |p|), float: densest inside."""
    values = (SLOPE * -signed_distance()).astype(np.float32)
    return Field(values, (-float(HALF_WIDTH),) * 3)


def cavity():
    """V = SLOPE (|p| - RADIUS), float: a hollow in something dense."""
    values = (SLOPE * signed_distance()).astype(np.float32)
    return Field(values, (-float(HALF_WIDTH),) * 3)


def thin_wall():
    """A wall one voxel thick at z = 0, blurred by a Gaussian of one voxel, int16."""

    def step(z):
        return 0.5 * (1.0 + math.erf(z / math.sqrt(2.0)))

    profile = [round(WALL_VALUE * (step(z + 0.5) - step(z - 0.5))) for z in range(-16, 17)]
    values = np.empty((33, 33, 33), np.int16)
    values[:] = np.array(profile, np.int16)[:, None, None]
    return Field(values, (-16.0, -16.0, -16.0))
