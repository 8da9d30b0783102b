# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""compare_traces.py finds the first difference of two traces and describes it."""

import contextlib
import io
import math

import compare_traces
import pytest
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

TICKS = 50


def make_trace(change=None, ticks=TICKS, extra=None, name="Force"):
    """Returns a trace; `change` = (tick, component, value) adds a value to one component of Force."""
    trace = vtkPolyData()
    points = vtkPoints()
    points.SetDataTypeToDouble()
    force = vtkDoubleArray()
    force.SetName(name)
    force.SetNumberOfComponents(3)
    for tick in range(ticks):
        points.InsertNextPoint(0.1 * tick, 1.0 / 3.0, -tick)
        value = [math.sin(0.1 * tick), 0.0, 2.0]
        for at, component, added in change or []:
            if at == tick:
                value[component] += added
        force.InsertNextTuple3(*value)
    trace.SetPoints(points)
    trace.GetPointData().AddArray(force)
    if extra:
        array = vtkDoubleArray()
        array.SetName(extra)
        array.SetNumberOfTuples(ticks)
        array.Fill(1.0)
        trace.GetPointData().AddArray(array)
    return trace


@pytest.fixture
def write(tmp_path):
    """Returns a function that writes a trace to a named file and returns the file's path."""

    def write_trace(name, trace):
        path = str(tmp_path / name)
        writer = vtkXMLPolyDataWriter()
        writer.SetFileName(path)
        writer.SetInputData(trace)
        assert writer.Write()
        return path

    return write_trace


@pytest.fixture
def baseline(write):
    return write("baseline.vtp", make_trace())


def run(*arguments):
    """Returns the exit code and everything that was printed."""
    text = io.StringIO()
    with contextlib.redirect_stdout(text), contextlib.redirect_stderr(text):
        code = compare_traces.main(list(arguments))
    return code, text.getvalue()


def expect(code, words, *arguments):
    result, text = run(*arguments)
    assert result == code, (result, text)
    for word in words:
        assert word in text, (word, text)


def test_arrays_that_only_one_has(write, baseline):
    more = write("more.vtp", make_trace(extra="Command"))
    expect(0, ["the same", "50 ticks"], baseline, baseline)
    expect(0, ["the same"], more, baseline)
    expect(2, ["no array Command"], baseline, more)
    expect(2, ["no array Force"], write("other.vtp", make_trace(name="Kraft")), baseline)


def test_first_difference(write, baseline):
    # A difference in the last bit of one number, and a larger difference later.
    bit = write("bit.vtp", make_trace([(17, 2, 4.5e-16), (30, 0, -0.25)]))
    expect(1, ["first difference in tick 17: Force[2]", "instead of 2.0", "0.25"], bit, baseline)
    expect(1, ["tick 30: Force[0]", "1 value(s)"], bit, baseline, "--tolerance", "1e-9")
    expect(0, ["the same"], bit, baseline, "--tolerance", "0.2")
    expect(0, ["the same"], bit, baseline, "--arrays", "Proxy")
    expect(1, ["Force[1]", "nan"], write("nan.vtp", make_trace([(3, 1, math.nan)])), baseline)
    expect(1, ["40 ticks", "the baseline 50"], write("short.vtp", make_trace(ticks=40)), baseline)


def test_differences_are_in_the_order_of_their_ticks():
    found = compare_traces.compare(make_trace([(5, 0, 1.0), (9, 1, 3.0)]), make_trace())
    assert [(d.tick, d.array, d.component, d.count, d.largest) for d in found] == [
        (5, "Force", 0, 2, 3.0)
    ], [str(d) for d in found]


def test_files_that_cannot_be_compared(baseline, tmp_path):
    broken, empty = tmp_path / "broken.vtp", tmp_path / "empty.vtp"
    with open(baseline, "rb") as whole:
        broken.write_bytes(whole.read()[:400])
    empty.touch()
    for bad in (str(broken), str(empty), str(tmp_path / "missing.vtp"), __file__):
        expect(2, [bad], bad, baseline)
        expect(2, [bad], baseline, bad)
