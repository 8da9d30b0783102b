# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The source Haptic Volume loads what independent libraries wrote: the phantom at every voxel, at each time."""

import json
import os
import re
import subprocess
import sys
from pathlib import Path

import numpy

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import rig  # noqa: E402
from paraview import servermanager  # noqa: E402
from vtkmodules.util.numpy_support import vtk_to_numpy  # noqa: E402
from vtkmodules.vtkCommonCore import vtkOutputWindow, vtkStringOutputWindow  # noqa: E402

FORMATS = Path(rig.SOURCE, "Testing", "Data", "Formats")
sys.path.insert(0, str(FORMATS))
from phantom import TISSUE, Grid, distance, values  # noqa: E402

NAMES = ("dicom-oblique", "dicom-phases", "nifti-oblique", "nifti-micron", "nifti-4d-times",
         "nifti-4d-second-channel", "tiff-imagej-micrometres", "tiff-folder", "tiff-single-page",
         "zarr-0.5-the-second-channel", "tiff-ome-channels-TCZ", "meta-4d-the-second", "meta-vector-of-which-none-is-chosen")
CHOOSE = [name for name in NAMES if "second" in name or "channels" in name]

folder = Path(rig.OUTPUT, "files")
environment = {name: value for name, value in os.environ.items() if not name.startswith(("PYTHON", "OMPI_", "PMIX_"))}
subprocess.run([FORMATS / "formats.sh", os.environ["VOLUMEHAPTICS_REFERENCE_BUILD"], "only", folder, *NAMES], check=True,
               env=environment)
cases = {case["name"]: case for case in json.loads((folder / "cases.json").read_text())}
assert sorted(cases) == sorted(NAMES)


def series_of(case):
    return int(case["options"][case["options"].index("--series") + 1]) if "--series" in case["options"] else 0


def open_volume(case):
    return rig.HapticVolume(Series=series_of(case), FileName=case["path"])


def compare(case, source, time=None, tissue=TISSUE):
    """The volume of a time with the formula, at every voxel."""
    source.UpdatePipeline() if time is None else source.UpdatePipeline(time)
    image = servermanager.Fetch(source)
    direction = numpy.array([[image.GetDirectionMatrix().GetElement(i, j) for j in range(3)] for i in range(3)])
    axes = direction * numpy.array(image.GetSpacing())
    index = numpy.moveaxis(numpy.indices(image.GetDimensions()), 0, -1) + numpy.array(image.GetExtent())[::2]
    points = index @ axes.T + numpy.array(image.GetOrigin())
    if case["steps"]:
        grid = Grid()
        points = ((points - case["first"]) / case["steps"]) @ grid.affine[:3, :3].T + grid.origin
    found = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(image.GetDimensions()[::-1]).transpose(2, 1, 0)
    wrong = numpy.abs(found - case["offset"] - case["scale"] * values(points, tissue=tissue))
    assert wrong.max() <= case["tolerance"], (case["name"], time, wrong.max())
    assert (distance(points) < -10.0).sum() > 500, case["name"]


for case in cases.values():
    if case["refused"] or "phases" in case["name"] or "times" in case["name"]:
        continue
    source = open_volume(case)
    compare(case, source)
    source.UpdatePropertyInformation()
    notes = source.SMProxy.GetProperty("Notes").GetElement(0)
    for told in case["told"]:
        assert re.search(told, notes, re.IGNORECASE), (case["name"], notes)
    assert len(source.TimestepValues) <= 1, case["name"]

for name, count, softer in (("dicom-phases", 2, 0.0), ("nifti-4d-times", 3, 100.0)):
    source = open_volume(cases[name])
    source.UpdatePipelineInformation()
    times = list(source.TimestepValues)
    assert len(times) == count and sorted(set(times)) == times, (name, times)
    for number in (*range(count), 0):  # and back again
        compare(cases[name], source, times[number], TISSUE - softer * number)

# The number chooses in a file that is larger than memory, too.
for name in CHOOSE:
    if not name.startswith("nifti"):
        compare(cases[name], rig.HapticLargeFile(Series=series_of(cases[name]), FileName=cases[name]["path"]))

# A number that is given before the name is known at the first reading: the first volume of this file is refused.
log, console = vtkStringOutputWindow(), vtkOutputWindow.GetInstance()
vtkOutputWindow.SetInstance(log)
open_volume(cases["meta-4d-the-second"]).UpdatePipeline()
assert "ERR" not in log.GetOutput(), log.GetOutput()
rig.HapticVolume(FileName=cases["meta-4d-the-second"]["path"])
assert "nothing to feel" in log.GetOutput()
vtkOutputWindow.SetInstance(console)

# A number for which there is nothing is refused in ParaView's words.
none = open_volume(cases["tiff-folder"])
rig.expect(none, "none with the number 3", "take Series = 1 to Series = 2",
           FileName=cases["meta-vector-of-which-none-is-chosen"]["path"], Series=3)

# ParaView stays alive, and tells why, when a source is given a file that can't be read.
page = open_volume(cases["tiff-folder"])
rig.expect(page, "page.tif", "Cure", FileName=cases["tiff-single-page"]["path"])
