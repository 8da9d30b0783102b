# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Tip paths of the closed forms: lists of (x, y, z) in mm, one point a servo tick."""

import math

STEP = 0.1  # mm per tick


def line(start, end):
    """The points after start up to and with end, STEP apart; start itself is not repeated."""
    ticks = round(math.dist(start, end) / STEP)
    return [
        tuple(round(s + (e - s) * i / ticks, 9) for s, e in zip(start, end))
        for i in range(1, ticks + 1)
    ]


def polyline(*corners):
    points = [corners[0]]
    for start, end in zip(corners, corners[1:]):
        points += line(start, end)
    return points


def turn(radius, ticks):
    """One turn about z from (radius, 0, 0), whose first point is not repeated.

    Rounding to 1e-9 mm hides the last bit of sin and cos, which the C library does not fix.
    """
    angles = [2.0 * math.pi * i / ticks for i in range(1, ticks + 1)]
    return [(round(radius * math.cos(a), 9), round(radius * math.sin(a), 9), 0.0) for a in angles]


def slab_press():
    """T1 and T2 (and T3): 10 mm into the slab and back to its surface."""
    return polyline((0.0, 0.0, 0.0), (0.0, 0.0, 10.0), (0.0, 0.0, 0.0))


def slab_slide():
    """T4 and T5: 3 mm into the slab, 10 mm along x, and back."""
    return polyline((0.0, 0.0, 0.0), (0.0, 0.0, 3.0), (10.0, 0.0, 3.0), (0.0, 0.0, 3.0))


def ball_circle():
    """T10: from the ball's surface to 2 mm inside it, then one turn in 1000 ticks."""
    return polyline((20.0, 0.0, 0.0), (18.0, 0.0, 0.0)) + turn(18.0, 1000)


def cavity_circle():
    """T11: from the cavity's surface to 2 mm behind it, then seven turns of 1257 ticks each."""
    return polyline((20.0, 0.0, 0.0), (22.0, 0.0, 0.0)) + 7 * turn(22.0, 1257)
