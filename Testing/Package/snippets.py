#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes a source with each block of C++ of the documents in a function of its own, so that a build compiles them.

usage: snippets.py REPOSITORY OUTPUT

Whole programs are left out: Readme.cmake compares them with files that are built. So is what needs a VTK with OpenXR,
which VTKExperimentalTest has.
"""

import pathlib
import re
import sys

# Variables that a block may use without declaring them.
GIVEN = """
  vtkNew<vtkRenderer> renderer, otherRenderer;
  vtkNew<vtkRenderWindow> window;
  vtkNew<vtkRenderWindowInteractor> interactor, otherInteractor;
  vtkNew<vtkXMLImageDataReader> head, series;
  vtkNew<vtkImageData> image, nextImage;
  vtkNew<vtkPolyData> mesh;
  vtkNew<vtkVolume> volume, ct, mri;
  vtkNew<vtkGPUVolumeRayCastMapper> mapper;
  vtkNew<vtkPlane> plane;
  vtkNew<vtkVolumeHapticsFilter> touch, mriFilter;
  vtkNew<vtkHapticDevice> device;
  vtkNew<vtkInteractorStyleHaptic> style;
  double x = 0.0, y = 0.0, z = 0.0;
"""
OTHERS = (
    "vtkGPUVolumeRayCastMapper vtkImageData vtkNew vtkPlane vtkPointData vtkRenderWindow vtkRenderWindowInteractor vtkRenderer "
    "vtkVolume vtkXMLImageDataReader"
).split()


def main():
    root, output = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    functions = []
    for path in [root / "README.md", *sorted((root / "Documentation").rglob("*.md"))]:
        for number, block in enumerate(re.findall(r"```cpp\n(.*?)```", path.read_text(encoding="utf-8"), re.DOTALL), 1):
            if "int main(" in block or "OpenXR" in block:
                continue
            name = re.sub(r"\W", "_", path.stem)
            functions.append(f"// {path.name}\nvoid {name}{number}()\n{{{GIVEN}  {{\n{block}  }}\n}}\n")
    if len(functions) < 8:
        sys.exit(f"only {len(functions)} blocks of C++ were found")
    own = sorted(path.name for path in (root / "Module" / "VTK").rglob("vtk*.h") if "Compat" not in path.name)
    includes = [f"#include <{name}>" for name in [*own, *(f"{other}.h" for other in OTHERS)]]
    output.write_text("\n".join([*includes, "", *functions]), encoding="utf-8")


main()
