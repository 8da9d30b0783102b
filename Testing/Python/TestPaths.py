# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""touch() of several paths: each trace is the one that its path gives alone, and other threads run meanwhile."""

import threading
import time

import compare_traces
import numpy as np
import pytest
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from volumehaptics import examples, path, touch, vtkVolumeHapticsFilter
from volumehaptics.arrays import arrays


@pytest.fixture(scope="module")
def head():
    return examples.phantom()


def strokes(count):
    """Returns strokes through the skin of the phantom, beside one another, with different lengths."""
    return [np.linspace((x, -120, 60), (x, -75, 60), 30 + 7 * i) for i, x in enumerate(np.linspace(-15, 15, count))]


def test_each_as_alone(head):
    tips = strokes(12)
    traces = touch(head, tips, "CT contrast")
    assert isinstance(traces, list) and len(traces) == len(tips)
    for tip, trace in zip(tips, traces):
        assert isinstance(trace, vtkPolyData)
        assert not compare_traces.compare(trace, touch(head, tip, "CT contrast"))
    assert any(arrays(trace)["Force"].any() for trace in traces)


def test_any_kinds_together(head):
    """Arrays, lists, and polydata (with and without times, of points alone, with several lines) keep their order."""
    a, b, c = strokes(3)
    timed = path(b, time=np.linspace(2.0, 2.05, len(b)))
    whole = path(c.astype(np.float32), time=np.arange(len(c)))
    points = path(a)
    points.SetLines(None)
    several = path(np.concatenate((a, b)))
    lines = vtkCellArray()
    for line in (range(len(a)), range(len(a), len(a) + len(b))):
        lines.InsertNextCell(len(line), list(line))
    several.SetLines(lines)
    tips = (a, timed, b.tolist(), points, several, [tuple(c[0])], whole)
    traces = touch(head, tips, servo_rate=500.0)
    for tip, trace in zip(tips, traces):
        assert not compare_traces.compare(trace, touch(head, tip, servo_rate=500.0))
    assert traces[4].GetNumberOfLines() == 2 and traces[5].GetNumberOfPoints() == 1


def test_one_is_a_list_and_points_are_one_path(head):
    tip = strokes(1)[0]
    assert len(touch(head, [tip])) == 1
    assert isinstance(touch(head, list(tip)), vtkPolyData)
    assert isinstance(touch(head, tip.tolist()), vtkPolyData)


def test_lines_of_a_polydata(head):
    tips = strokes(5)
    together = path(np.concatenate(tips))
    lines, begin = vtkCellArray(), 0
    for tip in tips:
        lines.InsertNextCell(len(tip), list(range(begin, begin + len(tip))))
        begin += len(tip)
    together.SetLines(lines)
    trace = touch(head, together, "CT contrast")
    assert trace.GetNumberOfLines() == 5
    force = arrays(trace)["Force"]
    for tip, one in zip(tips, np.split(force, np.cumsum([len(tip) for tip in tips])[:-1])):
        assert (one == arrays(touch(head, tip, "CT contrast"))["Force"]).all()


def test_errors_tell_the_path(head):
    a, b, c = strokes(3)
    bad = b.copy()
    bad[4, 1] = np.nan
    with pytest.raises(ValueError, match=r"path 1 \(from 0\): .*NaN.* at point 4"):
        touch(head, [a, bad, c])
    with pytest.raises(ValueError, match=r"path 2 \(from 0\): .*decreases.* at point 1\."):
        touch(head, [a, b, path(c[:3], time=(2.0, 1.0, 3.0))])
    with pytest.raises(ValueError, match="^The input image has no point scalars"):
        touch(type(head)(), [a, b])
    with pytest.raises(ValueError, match=r"the shape \(N, 3\)"):
        touch(head, [a, b[:, :2]])
    with pytest.raises(ValueError, match=r"the shape \(N, 3\)"):
        touch(head, [])


def test_one_warning_of_those_outside(head):
    a, b = strokes(2)
    far = b + 5000.0
    with pytest.warns(UserWarning, match=r"path 1 \(from 0\), the first of 2, .* outside") as warned:
        touch(head, [a, far, far])
    assert [warning.filename for warning in warned if warning.category is UserWarning] == [__file__]


def test_trace_arrays(head):
    tip = strokes(1)[0]
    whole = arrays(touch(head, tip, "CT contrast"))
    for given in (["Force", "Contact"], ("Force", "Contact"), "Force, Contact"):
        some = arrays(touch(head, tip, "CT contrast", trace_arrays=given))
        assert sorted(some) == ["Contact", "Force", "Proxy"]
        assert all((some[name] == whole[name]).all() for name in some)
    assert sorted(arrays(touch(head, [tip], trace_arrays=["Tip"])[0])) == ["Proxy", "Tip"]
    assert sorted(arrays(touch(head, tip, trace_arrays=[]))) == ["Proxy"]
    assert sorted(arrays(touch(head, tip, trace_arrays="all"))) == sorted(whole)
    with pytest.raises(ValueError, match='"Furce".*"Time".*"Force".*"Label"'):
        touch(head, tip, trace_arrays=["Furce"])


def test_threads_of_python_run_meanwhile(head):
    """Starts a thread that wakes up every millisecond. If touch() blocked it, it would wake only a few times, before
    and after."""
    tip = np.repeat(strokes(1)[0], 10000, axis=0)
    stop, wakes = threading.Event(), []

    def wake():
        while not stop.wait(0.001):
            wakes.append(time.perf_counter())

    thread = threading.Thread(target=wake)
    thread.start()
    begin = time.perf_counter()
    trace = touch(head, tip, trace_arrays=["Force"])
    end = time.perf_counter()
    stop.set()
    thread.join()
    assert trace.GetNumberOfPoints() == len(tip)
    middle = [t for t in wakes if begin + 0.2 * (end - begin) < t < end - 0.2 * (end - begin)]
    assert len(middle) > 10


def test_threads_of_python_touch_at_once(head):
    tips = strokes(6)
    alone = [touch(head, tip, "CT contrast") for tip in tips]
    found = [None] * len(tips)

    def feel(i):
        volume = type(head)()
        volume.ShallowCopy(head)
        found[i] = touch(volume, tips[i], "CT contrast")

    threads = [threading.Thread(target=feel, args=(i,)) for i in range(len(tips))]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    for one, other in zip(found, alone):
        assert not compare_traces.compare(one, other)


def test_errors_of_the_filter_reach_python_from_the_thread(head, capfd):
    def fail(found):
        try:
            touch(head, [(0.0, 0.0, np.nan)])
        except ValueError as error:
            found.append(str(error))

    found = []
    thread = threading.Thread(target=fail, args=(found,))
    thread.start()
    thread.join()
    assert len(found) == 1 and "NaN" in found[0]
    assert capfd.readouterr().err == ""


def test_parts_share_the_memory_of_the_whole(head):
    """The traces of several paths share one memory, which stays as long as a part needs it."""
    first, second = touch(head, strokes(2), trace_arrays=["Force"])
    force = vtk_to_numpy(second.GetPointData().GetArray("Force"))
    expected = force.copy()
    del first, second
    assert (force == expected).all() and force.any()


def test_setting_in_a_filter():
    haptics = vtkVolumeHapticsFilter()
    assert haptics.GetTraceArrays() == "all"
    assert haptics.SetTraceArrays("Force Contact") and haptics.GetTraceArrays() == "Force, Contact"
