#!/usr/bin/python3
# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Compares a haptic trace with a baseline: the regression test of forces.

    compare_traces.py TRACE BASELINE [--tolerance REL] [--arrays NAME,...]

Both are .vtp files: outputs of vtkVolumeHapticsFilter or recordings of vtkHapticDevice. The points
(`Proxy`) and every point array that the baseline has are compared tick by tick; further arrays of
the trace are ignored. Without a tolerance numbers have to be equal. With one, a number may differ
by REL times the largest size of a number in that array of the baseline.

Prints the first differing tick, its array and component, both values, and for each array that
differs the largest difference. Exit code: 0 the same, 1 different, 2 a file can't be compared.
"""

import argparse
import math
import os
import sys

from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

PROXY = "Proxy"


class TraceError(Exception):
    """A file can't be read as a trace; the text says which and why."""


class Difference:
    """Where an array differs: the first tick, and how far it gets."""

    def __init__(self, array, tick, component, value, expected):
        self.array = array
        self.tick = tick
        self.component = component
        self.value = value
        self.expected = expected
        self.largest = 0.0
        self.count = 0

    def __str__(self):
        return (
            f"tick {self.tick}: {self.array}[{self.component}] is {self.value!r} instead of "
            f"{self.expected!r}; {self.count} value(s) differ, by up to {self.largest:.3g}"
        )


def read_trace(name):
    """Returns the polydata in a .vtp file; raises TraceError if the file has no polydata or no ticks."""
    if not os.path.isfile(name):
        raise TraceError(f"{name} does not exist")
    reader = vtkXMLPolyDataReader()
    if not reader.CanReadFile(name):
        raise TraceError(f"{name} is not a .vtp file")
    failed = []
    for source in (reader, reader.GetExecutive()):
        source.AddObserver("ErrorEvent", lambda *_: failed.append(True))
    reader.SetFileName(name)
    reader.Update()
    trace = reader.GetOutput()
    if failed or trace.GetNumberOfPoints() == 0:
        raise TraceError(f"{name} is cut off or holds no ticks")
    return trace


def get_arrays(trace):
    """The numeric arrays by name; the points are called Proxy."""
    data = trace.GetPointData()
    arrays = {PROXY: trace.GetPoints().GetData()}
    for i in range(data.GetNumberOfArrays()):
        array = data.GetArray(i)
        if array is not None and array.GetName():
            arrays[array.GetName()] = array
    return arrays


def _is_same(value, expected, allowed):
    if math.isnan(value) or math.isnan(expected):
        return math.isnan(value) and math.isnan(expected)
    return value == expected or abs(value - expected) <= allowed


def compare_array(name, array, baseline, tolerance):
    """The Difference of one array over the ticks that both have, or None."""
    ticks = min(array.GetNumberOfTuples(), baseline.GetNumberOfTuples())
    largest = 0.0
    if tolerance > 0.0:
        values = (abs(x) for t in range(ticks) for x in baseline.GetTuple(t))
        largest = max((x for x in values if math.isfinite(x)), default=0.0)
    found = None
    for tick in range(ticks):
        pairs = zip(array.GetTuple(tick), baseline.GetTuple(tick))
        for component, (value, expected) in enumerate(pairs):
            if _is_same(value, expected, tolerance * largest):
                continue
            if found is None:
                found = Difference(name, tick, component, value, expected)
            size = abs(value - expected)
            found.largest = max(found.largest, math.inf if math.isnan(size) else size)
            found.count += 1
    return found


def compare(trace, baseline, tolerance=0.0, names=None):
    """The differences between two polydata, as a list of Difference, the first tick first.

    TraceError if they can't be compared: another number of ticks, an array that is missing or
    has another number of components.
    """
    ours = get_arrays(trace)
    theirs = get_arrays(baseline)
    wanted = list(theirs) if names is None else names
    differences = []
    for name in wanted:
        if name not in theirs:
            raise TraceError(f"the baseline has no array {name}")
        if name not in ours:
            raise TraceError(f"the trace has no array {name}")
        if ours[name].GetNumberOfComponents() != theirs[name].GetNumberOfComponents():
            raise TraceError(f"the array {name} has another number of components")
        found = compare_array(name, ours[name], theirs[name], tolerance)
        if found:
            differences.append(found)
    differences.sort(key=lambda difference: difference.tick)
    return differences


def main(arguments=None):
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("trace")
    parser.add_argument("baseline")
    parser.add_argument("--tolerance", type=float, default=0.0, metavar="REL")
    parser.add_argument("--arrays", metavar="NAME,...", help="only these (default: all)")
    options = parser.parse_args(arguments)
    if not options.tolerance >= 0.0:
        parser.error("the tolerance is a share, 0 or more")
    names = options.arrays.split(",") if options.arrays else None
    try:
        trace = read_trace(options.trace)
        baseline = read_trace(options.baseline)
        differences = compare(trace, baseline, options.tolerance, names)
    except TraceError as error:
        print(f"compare_traces: {error}.", file=sys.stderr)
        return 2
    for difference in differences:
        print(("first difference in " if difference is differences[0] else "also in ") + str(difference))
    ticks = [x.GetNumberOfPoints() for x in (trace, baseline)]
    if ticks[0] != ticks[1]:
        print(f"the trace has {ticks[0]} ticks, the baseline {ticks[1]}")
    elif not differences:
        print(f"the same: {ticks[0]} ticks")
    return 1 if differences or ticks[0] != ticks[1] else 0


if __name__ == "__main__":
    sys.exit(main())
