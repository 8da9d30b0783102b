# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The phantom in the files that other libraries write: a ball with two knobs, as a formula in patient coordinates.

Positions are in mm, left-posterior-superior, as DICOM and ITK have them. The ball has a radius of 20 mm; a knob of 5
mm sits at its left, a knob of 7 mm at its top. So every flip, turn, shear, scale or shift of a file changes the
phantom. Values go from -1000 to 60 over 4 mm of the surface, linearly in the distance, so that a voxel that is
placed wrongly by 0.1 mm is off by 26.
"""

import numpy as np

CENTRE = np.array([12.0, -31.0, 47.0])  # mm; away from 0, so that a lost origin shows
BALLS = (  # centre (mm, beside CENTRE), radius (mm)
    (np.array([0.0, 0.0, 0.0]), 20.0),
    (np.array([22.0, 0.0, 0.0]), 5.0),  # left
    (np.array([0.0, 0.0, 23.0]), 7.0),  # superior
)
AIR, TISSUE = -1000.0, 60.0
EDGE = 4.0  # mm
_sampled = {}  # cache of sampled grids, because most writers use the same grid


def distance(points):
    """Returns the signed distance (mm, outside positive) of points (..., 3) from the phantom's surface: exact outside,
    and near the surface except at the seams of the knobs."""
    points = np.asarray(points, dtype=float) - CENTRE
    return np.min([np.linalg.norm(points - centre, axis=-1) - radius for centre, radius in BALLS], axis=0)


def values(points, air=AIR, tissue=TISSUE):
    """Returns the phantom's values at points (..., 3)."""
    return air + (tissue - air) * np.clip(0.5 - distance(points) / EDGE, 0.0, 1.0)


class Grid:
    """Voxels in patient space: index (i, j, k) lies at `affine` @ (i, j, k, 1), in mm, left-posterior-superior."""

    def __init__(self, size=(44, 40, 42), spacing=(1.5, 1.6, 1.7), axes=np.eye(3), at_centre=CENTRE):
        self.size = tuple(size)
        self.affine = np.eye(4)
        self.affine[:3, :3] = np.asarray(axes, dtype=float) * np.asarray(spacing, dtype=float)
        self.affine[:3, 3] = np.asarray(at_centre) - self.affine[:3, :3] @ (np.array(size) - 1.0) / 2.0

    @property
    def spacing(self):
        return np.linalg.norm(self.affine[:3, :3], axis=0)

    @property
    def axes(self):
        return self.affine[:3, :3] / self.spacing

    @property
    def origin(self):
        return self.affine[:3, 3]

    def points(self):
        """Returns the positions of all voxels, with the shape (nx, ny, nz, 3)."""
        index = np.moveaxis(np.indices(self.size, dtype=float), 0, -1)
        return index @ self.affine[:3, :3].T + self.affine[:3, 3]

    def sample(self, dtype=np.int16, **limits):
        """Returns the phantom's values at all voxels, with the shape (nx, ny, nz)."""
        key = (self.size, self.affine.tobytes(), *limits.items())
        if key not in _sampled:
            _sampled[key] = np.round(values(self.points(), **limits))
        return _sampled[key].astype(dtype)


def turned(degrees, axis=(1.0, 2.0, 3.0)):
    """Returns a matrix that rotates about an axis."""
    x, y, z = np.asarray(axis) / np.linalg.norm(axis)
    angle = np.radians(degrees)
    cross = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    return np.eye(3) + np.sin(angle) * cross + (1.0 - np.cos(angle)) * cross @ cross
