# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A life-size head in Hounsfield units, drawn with smooth solids: no person's anatomy.

Patient axes as in DICOM: +x to the patient's left, +y to the back, +z to the top of the head;
the face looks along -y. Lengths in millimetres.
"""

import numpy as np

from shapes import Solid, blend, both, capsule, carve, chain, ellipsoid

SIZE = 64
SPACING = 3.75
ORIGIN = -0.5 * (SIZE - 1) * SPACING
SUPERSAMPLING = 4

HU = {
    "air": -1000,
    "skin": 40,
    "fat": -100,
    "muscle": 55,
    "cartilage": 120,
    "table": 1500,
    "diploe": 700,
    "bone": 1000,
    "tooth": 2200,
    "brain": 35,
    "fluid": 5,
    "lens": 80,
}

# Depths (mm) below the surface of the head of the borders between tissues.
FAT_DEPTH = 2.5
MUSCLE_DEPTH = 8.0

CRANIUM = ellipsoid((0, 8, 34), (76, 92, 72))
# The skull lies deeper at the temples, under the temporal muscle.
VAULT = [ellipsoid((0, 8, 34), (64, 84, 64)), ellipsoid((0, 48, -4), (48, 40, 34))]

# Pairs of a solid and a fillet radius. Smooth unions and differences in this order form the surface of the head.
BULK = [
    (ellipsoid((0, -22, -28), (60, 62, 68)), 20.0),
    (ellipsoid((0, 52, -8), (56, 46, 44)), 18.0),
    (capsule((0, 22, -40), (0, 34, -180), 54, 54), 26.0),
    (ellipsoid((0, -58, -76), (32, 30, 24)), 16.0),
    *[(solid, 12.0) for solid in both(ellipsoid((26, -68, 18), (26, 14, 9)))],
    *[(solid, 22.0) for solid in both(ellipsoid((40, -52, -20), (18, 22, 16)))],
]
HOLLOWS = [(solid, 10.0) for solid in both(ellipsoid((30, -96, 3), (19, 20, 11)))]
FEATURES = [
    *[(solid, 4.0) for solid in both(ellipsoid((30, -71, 3), (13, 13, 12)))],
    (capsule((0, -80, 8), (0, -97, -32), 6, 10), 8.0),
    *[(solid, 5.0) for solid in both(ellipsoid((11, -88, -36), (8, 10, 7)))],
    (ellipsoid((0, -84, -59), (24, 8, 6)), 4.0),
    (ellipsoid((0, -83, -70), (21, 8, 6)), 4.0),
]
EARS = both(capsule((69, 6, -28), (77, 20, 12), 9, 16, 0.45))
CONCHAS = both(ellipsoid((85, 12, -2), (9, 9, 14)), ellipsoid((80, 4, -13), (9, 6, 7)))
NOSTRILS = both(capsule((7, -98, -46), (6, -78, -30), 4.5, 4))


def skin_distance(grid):
    """The signed distance to the outer surface of the head, millimetres, negative inside."""
    field = np.full(np.broadcast_shapes(*(axis.shape for axis in grid)), 1e3)
    window = CRANIUM.window(grid, 30.0)
    if window is not None:
        field[window] = CRANIUM.evaluate(grid, window)
    for solid, fillet in BULK:
        blend(field, grid, solid, fillet)
    for solid, fillet in HOLLOWS:
        carve(field, grid, solid, fillet)
    for solid, fillet in FEATURES:
        blend(field, grid, solid, fillet)
    for solid in EARS:
        blend(field, grid, solid, 6.0)
    for solid in CONCHAS + NOSTRILS:
        carve(field, grid, solid, 3.0)
    return field


class Canvas:
    """The tissues on one grid; later strokes cover earlier ones."""

    def __init__(self, grid):
        self.grid = grid
        self.depth = -skin_distance(grid)
        self.tissue = np.full(self.depth.shape, HU["air"], np.int16)
        for depth, name in ((0.0, "skin"), (FAT_DEPTH, "fat"), (MUSCLE_DEPTH, "muscle")):
            self.tissue[self.depth > depth] = HU[name]

    def paint(self, name, *solids, grow=0.0, below=None):
        """Fills every solid, grown by a length, but only deeper under the skin than below."""
        for solid in solids:
            window = solid.window(self.grid, max(grow, 0.0))
            if window is None:
                continue
            inside = solid.evaluate(self.grid, window) < grow
            if below is not None:
                inside &= self.depth[window] > below
            self.tissue[window][inside] = HU[name]


def draw_face_bones(canvas):
    canvas.paint("fat", *both(ellipsoid((48, -44, -48), (10, 16, 14))), below=FAT_DEPTH)
    canvas.paint("bone", ellipsoid((0, -46, -30), (38, 34, 26)), below=11.0)
    canvas.paint("bone", ellipsoid((0, -64, 20), (30, 14, 15)), below=7.0)
    cheek = chain([(28, -60, -22), (43, -54, -17), (53, -30, -17), (54, 0, -16)], [10, 8, 5, 5])
    rim = chain([(44, -56, -16), (49, -54, 4), (44, -62, 22)], [7, 5, 6])
    canvas.paint("bone", *both(cheek, rim), below=6.0)
    body = chain([(0, -74, -84), (26, -60, -82), (48, -18, -68)], [11, 10, 11], 0.8)
    ramus = chain([(48, -16, -64), (51, -8, -40), (52, 0, -20)], [13, 14, 6], 0.4)
    canvas.paint("bone", *both(body, ramus), below=5.0)


def draw_spine(canvas):
    canvas.paint("cartilage", capsule((0, 34, -46), (0, 40, -180), 12, 12))
    for level in range(6):
        z = -46.0 - 17.0 * level
        y = 34.0 + 0.04 * (-46.0 - z)
        canvas.paint("bone", ellipsoid((0, y, z), (16, 14, 7.5)))
        canvas.paint("bone", ellipsoid((0, y + 20, z), (17, 14, 6)))
        canvas.paint("bone", capsule((0, y + 28, z), (0, y + 42, z - 8), 4.5, 4), below=12.0)
    canvas.paint("fluid", capsule((0, 50, -40), (0, 54, -180), 8, 8))


def draw_braincase(canvas):
    layers = ((0.0, "table"), (-2.2, "diploe"), (-5.0, "table"), (-7.2, "fluid"), (-9.0, "brain"))
    for grow, name in layers:
        canvas.paint(name, *VAULT, grow=grow)
    canvas.paint("table", *both(ellipsoid((42, 16, -14), (22, 13, 11))), below=MUSCLE_DEPTH)
    canvas.paint("bone", *both(capsule((62, 22, -14), (58, 20, -34), 11, 7)), below=6.0)
    canvas.paint("bone", ellipsoid((0, -24, -8), (17, 15, 12)))
    falx = Solid([-0.9, -75, 20], [0.9, 90, 98], VAULT[0].distance)
    canvas.paint("fluid", falx, grow=-7.2)
    canvas.paint("brain", capsule((0, 30, -20), (0, 50, -46), 9, 7))
    horn = chain([(10, -24, 42), (12, 10, 50), (22, 40, 36), (28, 12, 16)], [6, 6, 8, 4])
    canvas.paint("fluid", *both(horn), capsule((0, 0, 30), (0, 16, 26), 3, 3))


def draw_eyes(canvas):
    apex = (14, -32, 4)
    canvas.paint("bone", *both(capsule((31, -74, 3), apex, 21, 8)), below=8.0)
    canvas.paint("fat", *both(capsule((31, -76, 3), apex, 18, 5)), below=FAT_DEPTH)
    canvas.paint("muscle", *both(capsule((29, -64, 3), apex, 3, 3)))
    canvas.paint("muscle", *both(ellipsoid((30, -71, 3), (12, 12, 12))), below=1.5)
    canvas.paint("fluid", *both(ellipsoid((30, -71, 3), (10.8, 10.8, 10.8))))
    canvas.paint("lens", *both(ellipsoid((30, -79, 3), (4.5, 2.2, 4.5))))


def draw_air_spaces(canvas):
    canvas.paint("air", *both(capsule((7, -72, -27), (7, -26, -28), 6, 6)))
    canvas.paint("air", *both(capsule((6, -64, -14), (6, -30, -12), 4, 4)), *NOSTRILS)
    canvas.paint("air", *both(ellipsoid((25, -46, -27), (10, 16, 13))))
    # The left frontal sinus is the larger one, which reveals a mirrored head.
    canvas.paint("air", ellipsoid((12, -63, 24), (10, 4.5, 8)), ellipsoid((-8, -64, 22), (5, 4, 5)))
    canvas.paint("air", ellipsoid((0, -24, -6), (12, 10, 8)))
    canvas.paint("air", *chain([(0, -22, -28), (0, -8, -60), (0, -4, -180)], [9, 8, 9]))
    canvas.paint("air", *both(capsule((80, 6, -12), (52, 10, -12), 3.5, 3)))


def draw_mouth_and_cartilage(canvas):
    for z, back in ((-57, 0.0), (-69, 2.0)):
        points = [(0, -72 + back, z), (14, -67 + back, z), (23, -50, z), (25, -34, z)]
        canvas.paint("tooth", *both(chain(points, [5, 5, 5.5, 5.5])), below=6.0)
    canvas.paint("muscle", ellipsoid((0, -36, -60), (18, 28, 14)))
    canvas.paint("cartilage", *EARS, grow=-3.0, below=FAT_DEPTH)
    canvas.paint("cartilage", capsule((0, -84, 0), (0, -98, -34), 2.5, 4), below=FAT_DEPTH)


def tissue_values(grid):
    """The Hounsfield units of the sharp anatomy on an open grid (z, y, x) of positions."""
    canvas = Canvas(grid)
    draw_face_bones(canvas)
    draw_spine(canvas)
    draw_braincase(canvas)
    draw_eyes(canvas)
    draw_air_spaces(canvas)
    draw_mouth_and_cartilage(canvas)
    return canvas.tissue


def blurred(total, axis):
    """Sums with the weights 1 4 1 along an axis; the border is repeated."""
    padded = np.concatenate(
        [total.take([0], axis), total, total.take([-1], axis)], axis)
    size = total.shape[axis]
    left, middle, right = (padded.take(range(i, i + size), axis) for i in range(3))
    return left + 4 * middle + right


def head_phantom():
    """The phantom, int16 Hounsfield units, indexed [z, y, x], blurred as a scanner blurs.

    Each voxel is the mean over its volume, then smoothed with 1/6 2/3 1/6 along each axis.
    The sums are kept in integers: no order of summation can change the last bit.
    """
    fine = SIZE * SUPERSAMPLING
    axis = ORIGIN + ((np.arange(fine) + 0.5) / SUPERSAMPLING - 0.5) * SPACING
    total = np.empty((SIZE, SIZE, SIZE), np.int64)
    for k in range(SIZE):
        layer = axis[k * SUPERSAMPLING : (k + 1) * SUPERSAMPLING]
        grid = (layer[:, None, None], axis[None, :, None], axis[None, None, :])
        values = tissue_values(grid).astype(np.int64)
        blocks = values.reshape(SUPERSAMPLING, SIZE, SUPERSAMPLING, SIZE, SUPERSAMPLING)
        total[k] = blocks.sum(axis=(0, 2, 4))
    for direction in range(3):
        total = blurred(total, direction)
    count = SUPERSAMPLING**3 * 6**3
    return ((2 * total + count) // (2 * count)).astype(np.int16)
