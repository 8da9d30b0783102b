# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Solids given by approximate signed distances (millimetres, negative inside).

Only + - * / sqrt, minimum and maximum are used: IEEE 754 fixes their results to the last bit, so
the volumes come out the same on every machine, which sin, exp and BLAS would not promise.
A solid is evaluated on an open grid, three broadcastable axis arrays (z, y, x).
"""

import numpy as np


class Solid:
    """A distance function and the box outside which it is positive."""

    def __init__(self, low, high, distance):
        self.low = low
        self.high = high
        self.distance = distance

    def window(self, grid, margin=0.0):
        """The slices of the open grid that cover the solid's box, or None if they miss it."""
        slices = []
        for axis, coordinates in enumerate(grid):
            values = coordinates.ravel()
            first = int(np.searchsorted(values, self.low[2 - axis] - margin, "left"))
            last = int(np.searchsorted(values, self.high[2 - axis] + margin, "right"))
            if first >= last:
                return None
            slices.append(slice(first, last))
        return tuple(slices)

    def evaluate(self, grid, window):
        """The distance on a window of the open grid."""
        z, y, x = grid
        return self.distance(x[:, :, window[2]], y[:, window[1], :], z[window[0], :, :])


def ellipsoid(center, radii):
    """An ellipsoid along the axes; the distance is exact to first order at the surface."""

    def distance(x, y, z):
        u, v, w = ((p - c) / r for p, c, r in zip((x, y, z), center, radii))
        k0 = np.sqrt(u * u + v * v + w * w)
        a, b, c = (q / r for q, r in zip((u, v, w), radii))
        k1 = np.sqrt(a * a + b * b + c * c)
        return k0 * (k0 - 1.0) / np.maximum(k1, 1e-9)

    low = [c - r for c, r in zip(center, radii)]
    high = [c + r for c, r in zip(center, radii)]
    return Solid(low, high, distance)


def capsule(start, end, start_radius, end_radius, flatten=1.0):
    """A round cone from start to end; flatten < 1 makes it thinner along x."""
    axis = [e - s for s, e in zip(start, end)]
    length2 = sum(a * a for a in axis)

    def distance(x, y, z):
        p = [q - s for q, s in zip((x, y, z), start)]
        t = (p[0] * axis[0] + p[1] * axis[1] + p[2] * axis[2]) / length2
        t = np.minimum(np.maximum(t, 0.0), 1.0)
        q = [p[i] - t * axis[i] for i in range(3)]
        q[0] = q[0] / flatten
        radius = start_radius + t * (end_radius - start_radius)
        return np.sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2]) - radius

    widest = max(start_radius, end_radius)
    low = [min(s, e) - widest for s, e in zip(start, end)]
    high = [max(s, e) + widest for s, e in zip(start, end)]
    return Solid(low, high, distance)


def chain(points, radii, flatten=1.0):
    """Round cones through several points, one solid a link."""
    return [
        capsule(points[i], points[i + 1], radii[i], radii[i + 1], flatten)
        for i in range(len(points) - 1)
    ]


def mirrored(solid):
    """The mirror image of a solid in the plane x = 0."""
    low = [-solid.high[0], solid.low[1], solid.low[2]]
    high = [-solid.low[0], solid.high[1], solid.high[2]]
    return Solid(low, high, lambda x, y, z: solid.distance(-x, y, z))


def both(*made):
    """The given solids (or lists of them) and their mirror images."""
    solids = [s for item in made for s in (item if isinstance(item, list) else [item])]
    return solids + [mirrored(solid) for solid in solids]


def blend(field, grid, solid, width):
    """Smooth union of field and solid, in place; width is the length of the fillet."""
    window = solid.window(grid, 2.0 * width)
    if window is None:
        return
    part = field[window]
    other = solid.evaluate(grid, window)
    fillet = np.maximum(width - np.abs(part - other), 0.0) / width
    field[window] = np.minimum(part, other) - 0.25 * width * fillet * fillet


def carve(field, grid, solid, width):
    """Smooth difference: takes solid out of field, in place."""
    window = solid.window(grid, 2.0 * width)
    if window is None:
        return
    part = field[window]
    other = -solid.evaluate(grid, window)
    fillet = np.maximum(width - np.abs(part - other), 0.0) / width
    field[window] = np.maximum(part, other) + 0.25 * width * fillet * fillet
