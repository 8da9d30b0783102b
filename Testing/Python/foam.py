# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Cases of OpenFOAM, for tests."""

import numpy as np


def write_foam(folder, size, flow):
    """Writes a case of OpenFOAM: a row of hexahedra along x, with a flow U in each at the time 10."""
    count = len(flow)
    x, y, z = np.meshgrid(np.linspace(0, size[0], count + 1), [-size[1], size[1]], [0, size[2]], indexing="ij")
    points = np.stack([x, y, z], -1).reshape(-1, 3)
    at = np.arange(4 * (count + 1)).reshape(-1, 2, 2)
    ends = [[one[0, 0], one[1, 0], one[1, 1], one[0, 1]] for one in at]  # face normals along x, out of the lower cell
    faces, owner = [list(end) for end in ends[1:-1]], list(range(count - 1))
    walls = [(ends[0][::-1], 0), (ends[-1], count - 1)]
    for cell in range(count):
        a, b = at[cell], at[cell + 1]
        walls += [([a[0, 0], b[0, 0], b[0, 1], a[0, 1]], cell), ([a[1, 0], a[1, 1], b[1, 1], b[1, 0]], cell),
                  ([a[0, 0], a[1, 0], b[1, 0], b[0, 0]], cell), ([a[0, 1], b[0, 1], b[1, 1], a[1, 1]], cell)]
    faces, owner = faces + [face for face, _ in walls], owner + [cell for _, cell in walls]

    def tuples(rows, prefix=""):
        return [prefix + "(" + " ".join(map(str, row)) + ")" for row in rows]

    def write(place, kind, name, lines, head=""):
        (folder / place).mkdir(parents=True, exist_ok=True)
        body = "\n".join([f"FoamFile {{ version 2.0; format ascii; class {kind}; object {name}; }}", head, *lines])
        (folder / place / name).write_text(body + "\n", encoding="ascii")

    def listed(lines):
        return [str(len(lines)), "(", *map(str, lines), ")"]

    mesh = "constant/polyMesh"
    write(mesh, "vectorField", "points", listed(tuples(points)))
    write(mesh, "faceList", "faces", listed(tuples(faces, "4")))
    write(mesh, "labelList", "owner", listed(owner))
    write(mesh, "labelList", "neighbour", listed(list(range(1, count))))
    write(mesh, "polyBoundaryMesh", "boundary", [
        "1 (", f"walls {{ type wall; nFaces {len(walls)}; startFace {count - 1}; }}", ")"])
    write("system", "dictionary", "controlDict", ["startTime 0; endTime 10; deltaT 10; writeControl timeStep;"])
    for name in ("0", "10"):
        write(name, "volVectorField", "U", [
            "dimensions [0 1 -1 0 0 0 0];", "internalField nonuniform List<vector>",
            *listed(tuples(flow if name == "10" else 0 * flow)), ";", "boundaryField { walls { type zeroGradient; } }"])
    case = folder / "case.foam"
    case.touch()
    return case
