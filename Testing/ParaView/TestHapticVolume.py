# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The source Haptic Volume loads files that independent libraries wrote: it compares the phantom at every voxel, at
each time."""

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
from phantom import CENTRE, TISSUE, Grid, distance, values  # noqa: E402

# Test the first case in each row of rows.md, and additional files with several volumes. VOLUMEHAPTICS_ALL_FORMATS=1
# tests all cases.
NAMES = ["dicom-phases", "nifti-4d-times", "nifti-4d-second-channel", "tiff-folder", "tiff-single-page",
         "zarr-0.5-the-second-channel", "tiff-ome-channels-TCZ", "meta-4d-the-second", "meta-vector-of-which-none-is-chosen"]
for row in (FORMATS / "rows.md").read_text(encoding="utf-8").splitlines():
    proofs = [proof for proof in re.findall("`([^`]+)`", row.split("|")[-2]) if ": " not in proof] if row.startswith("| ") else []
    NAMES += proofs[:1]
if os.environ.get("VOLUMEHAPTICS_ALL_FORMATS"):
    NAMES = ["*"]

folder = Path(rig.OUTPUT, "files")
environment = {name: value for name, value in os.environ.items() if not name.startswith(("PYTHON", "OMPI_", "PMIX_"))}
subprocess.run([FORMATS / "formats.sh", os.environ["VOLUMEHAPTICS_REFERENCE_BUILD"], "only", folder, *NAMES], check=True,
               env=environment)
cases = {case["name"]: case for case in json.loads((folder / "cases.json").read_text())}
assert len(cases) > 90


def series_of(case):
    return int(case["options"][case["options"].index("--series") + 1]) if "--series" in case["options"] else 0


def open_volume(case):
    return rig.HapticVolume(Series=series_of(case), FileName=case["path"])


def compare(case, source, time=None, tissue=TISSUE):
    """Compares the volume at a time with the formula, at every voxel."""
    assert "ERR" not in rig.report_of_update(source, time)
    image = servermanager.Fetch(source)
    direction = numpy.array([[image.GetDirectionMatrix().GetElement(i, j) for j in range(3)] for i in range(3)])
    axes = direction * numpy.array(image.GetSpacing())
    index = numpy.moveaxis(numpy.indices(image.GetDimensions()), 0, -1) + numpy.array(image.GetExtent())[::2]
    points = index @ axes.T + numpy.array(image.GetOrigin())
    if case["steps"]:
        grid = Grid()
        points = ((points - case["first"]) / case["steps"]) @ grid.affine[:3, :3].T + grid.origin
    found = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(image.GetDimensions()[::-1]).transpose(2, 1, 0)
    body = values(points, tissue=tissue)
    if case["labels"]:
        one, left = case["first_label"], points[..., 0] > CENTRE[0] + 20.5
        expected = {"": one + left, "body": one, "knob": (one + 1) * left}[case["alone"]] * (body > -470.0)
        assert not ((found != expected) & (numpy.abs(body + 470.0) > 1.0)).any(), case["name"]
        return
    wrong = numpy.abs(found - case["offset"] - case["scale"] * body)
    if case["outside"]:
        wrong[distance(points) > 2.0] = 0.0
    assert case["scale"] == 0.0 or numpy.nanmax(wrong) <= case["tolerance"], (case["name"], time, wrong.max())
    assert (distance(points) < -10.0).sum() > 500, case["name"]


def check_refusal(case, said):
    cause = said.replace(case["path"], "").replace(Path(case["path"]).name, "").replace(case["name"], "")
    assert re.search(case["refused"], cause) and "Cure" in said, (case["name"], said)


for case in cases.values():
    if case["refused"]:
        source = rig.HapticVolume()
        check_refusal(case, rig.report_of_update(source, Series=series_of(case), FileName=case["path"]))
        assert source.GetDataInformation().GetNumberOfPoints() == 0
        continue
    source = open_volume(case)
    compare(case, source)
    source.UpdatePropertyInformation()
    notes = source.SMProxy.GetProperty("Notes").GetElement(0)
    for told in case["told"]:
        assert re.search(told, notes + "%d frames" % len(source.TimestepValues), re.IGNORECASE), (case["name"], notes)

# Opened as larger than memory, a volume must have the same values, or be refused with a remedy.
for case in cases.values():
    if case["name"].startswith(("dicom", "nifti", "analyze", "refused")) or case["labels"]:
        continue
    source = rig.HapticLargeFile()
    said = rig.report_of_update(source, Series=series_of(case), FileName=case["path"])
    if "ERR" in said:
        assert re.search(r"Cure: |\. [A-Z][a-z]+ ", said), said
    else:
        assert not case["refused"], case["name"]
        compare(case, source)
        source.UpdatePropertyInformation()
        notes = source.SMProxy.GetProperty("Notes").GetElement(0)
        assert case["name"] != "tiff-lzw" or "cubes of 1 mm are assumed" in notes, notes
        assert "channel" not in str(case["told"]) or "channel" in notes, (case["name"], notes)

for name, count, softer in (("dicom-phases", 2, 0.0), ("nifti-4d-times", 3, 100.0)):
    source = open_volume(cases[name])
    source.UpdatePipelineInformation()
    times = list(source.TimestepValues)
    assert len(times) == count and sorted(set(times)) == times, (name, times)
    for number in (*range(count), 0):  # and back again
        compare(cases[name], source, times[number], TISSUE - softer * number)

# A Series that is set before the file name applies to the first read. Otherwise, this file's first volume would be
# refused.
log, console = vtkStringOutputWindow(), vtkOutputWindow.GetInstance()
vtkOutputWindow.SetInstance(log)
open_volume(cases["meta-4d-the-second"]).UpdatePipeline()
assert "ERR" not in log.GetOutput(), log.GetOutput()
rig.HapticVolume(FileName=cases["meta-4d-the-second"]["path"])
assert "nothing to feel" in log.GetOutput()
vtkOutputWindow.SetInstance(console)

# A number without a volume must be refused, with a remedy in ParaView's terms.
none = open_volume(cases["tiff-folder"])
rig.expect(none, "none with the number 3", "use Series = 1 to Series = 2",
           FileName=cases["meta-vector-of-which-none-is-chosen"]["path"], Series=3)

# ParaView must survive a file that can't be read, and report why.
page = open_volume(cases["tiff-folder"])
rig.expect(page, "page.tif", "Cure", FileName=cases["tiff-single-page"]["path"])
