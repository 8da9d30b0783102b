# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Volumes, paths and settings that the VTK build and ParaView share.

A scene is a file of the reference folder with a preset, an isovalue and a tip path: NAME.vti and NAMEPath.vtp. A method
is a set of settings of vtkVolumeHapticsFilter, which are also the properties of the filter in ParaView.
"""

PRECISE = {}
METHODS = {
    "Precise": PRECISE,
    "Kernel": {"ContactAlignment": 0, "MaterialPlacement": 0},
    "Edge": {"ContactAlignment": 1, "MaterialPlacement": 0},
    "SameShape": {"SameShape": 1, "CouplingStiffness": 350.0},
    "FarSide": {"ContactAlignment": 0, "MaterialPlacement": 1},
    "CubicBSpline": {"GradientEstimator": 2, "KernelRadius": 3},
    "CentralDifference": {"GradientEstimator": 0, "MaximumForce": 1.5, "MaximumStiffness": 300.0},
    "Paper": {"Solver": 0, "ServoRate": 2000.0},
    "ForceField": {"Method": 1, "ForceFieldGain": 0.005, "ForceFieldDamping": 0.5},
    "SurfaceProxy": {"Method": 2, "ProxyRadius": 1.0, "ForceShading": 0},
    "LocalPlane": {"Method": 3, "LocalSurfaceRate": 100.0, "RecoveryTime": 0.01},
    "LocalQuadric": {"Method": 3, "LocalSurfaceShape": 1, "MetersPerWorldUnit": 0.002},
}


class Scene:
    """A volume with its preset ("Custom": that of a new property) and the corners of a path (world)."""

    def __init__(self, preset, iso_value, corners):
        self.preset = preset
        self.iso_value = iso_value
        self.corners = corners

    def path(self, ticks=250):
        """Returns points along the corners, `ticks` from each corner to the next."""
        points = []
        for a, b in zip(self.corners, self.corners[1:]):
            for i in range(ticks):
                points.append([x + (y - x) * (i / ticks) for x, y in zip(a, b)])
        return points + [list(self.corners[-1])]


SCENES = {
    "Wavelet": Scene("Custom", 200.0, [(-9, 0, 0), (-2, 1, 0), (2, 3, -4), (9, 0, 0)]),
    # Enter the head from above the crown, cross it, and leave it.
    "Head": Scene("CT contrast", -300.0, [(0, 0, 115), (0, 0, 98), (-30, 6, 98), (-30, 6, 115)]),
    # Enter the head from one side, cross it, and leave it.
    "CT": Scene("CT physical", -300.0, [(122, 257, 120), (122, 274, 120), (100, 274, 120), (100, 257, 120)]),
}
