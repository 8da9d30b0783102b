// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/Explorer/Live/LiveRun.h"

#include "Applications/Explorer/Exploration/ShapeFile.h"
#include "VTK/Reading/MessageCapture.h"
#include "VTK/Trace/TraceWriter.h"

#include "vtkDataArray.h"
#include "vtkHapticDevice.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkVolumeHapticsFilter.h"
#include "vtksys/SystemTools.hxx"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <initializer_list>
#include <iomanip>
#include <sstream>
#include <thread>

namespace
{
void Demand(bool done, const char* what, const Explore::MessageCapture& capture)
{
  if (!done)
  {
    throw std::runtime_error(std::string(what) + ": " + capture.FirstError());
  }
}

/// Moves the tip along the path in real time, with updates at most at an application's frame rate.
void PlayPath(vtkHapticDevice* device, vtkPolyData* path, double rate)
{
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  const vtkIdType last = path->GetNumberOfPoints() - 1;
  vtkIdType now = 0;
  while (now < last)
  {
    const std::chrono::duration<double> time = Clock::now() - start;
    now = std::min(last, static_cast<vtkIdType>(time.count() * rate));
    device->GetVirtualHand()->SetPosition(path->GetPoint(now));
    device->UpdateState();
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

std::string TimeKeeping(vtkHapticDevice* device)
{
  constexpr double micro = 1e6;
  std::ostringstream text;
  text << std::fixed << std::setprecision(1) << "Live, in real time\n  " << device->GetTickRate()
       << " ticks per second, " << device->GetMissedTicks()
       << " missed\n  tick cost (microseconds) " << micro * device->GetTickPercentile(50)
       << " median, " << micro * device->GetTickPercentile(99)
       << " at 99 %\n  wake-up latency (microseconds) " << micro * device->GetWakePercentile(50)
       << " median, " << micro * device->GetWakePercentile(99) << " at 99 %\n  "
       << device->GetStatusText() << "\n";
  return text.str();
}

/// Returns the index of the first tick whose force differs; -1 if all are equal.
vtkIdType FirstDifference(vtkPolyData* a, vtkPolyData* b)
{
  vtkDataArray* const fa = a->GetPointData()->GetArray("Force");
  vtkDataArray* const fb = b->GetPointData()->GetArray("Force");
  const vtkIdType ticks = fa ? fa->GetNumberOfTuples() : 0;
  if (!fb || fb->GetNumberOfTuples() != ticks)
  {
    return 0;
  }
  for (vtkIdType i = 0; i < ticks; ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      if (fa->GetComponent(i, c) != fb->GetComponent(i, c))
      {
        return i;
      }
    }
  }
  return -1;
}
/// Result of a comparison of the servo's trace of the planned path with the offline trace, tick by
/// tick.
struct Agreement
{
  vtkIdType Ticks = 0;  // number of ticks with the same tip as an offline tick
  vtkIdType Wrong = 0;  // number of these ticks whose force differs
  vtkIdType Others = 0; // number of ticks whose tip is not that of any offline tick
};

Agreement CompareTicks(vtkPolyData* live, vtkPolyData* offline)
{
  const auto isSame = [&](const char* name, vtkIdType at, vtkIdType tick)
  {
    double a[3];
    double b[3];
    live->GetPointData()->GetArray(name)->GetTuple(at, a);
    offline->GetPointData()->GetArray(name)->GetTuple(tick, b);
    return std::equal(a, a + 3, b);
  };
  Agreement agreement;
  vtkDataArray* const ticks = live->GetPointData()->GetArray("Tick");
  for (vtkIdType i = 0; i < live->GetNumberOfPoints(); ++i)
  {
    const auto tick = static_cast<vtkIdType>(ticks->GetComponent(i, 0));
    if (tick >= offline->GetNumberOfPoints())
    {
      break; // end of the path
    }
    const bool sameTip = isSame("Tip", i, tick);
    agreement.Ticks += sameTip ? 1 : 0;
    agreement.Others += sameTip ? 0 : 1;
    agreement.Wrong += sameTip && !isSame("Force", i, tick) ? 1 : 0;
  }
  return agreement;
}

/// Reads a recording that must have these arrays. Throws std::runtime_error on failure.
vtkSmartPointer<vtkPolyData> ReadRecording(
  const std::string& file, std::initializer_list<const char*> arrays)
{
  std::string error;
  vtkSmartPointer<vtkPolyData> recording = Explore::ReadPolyData(file, error);
  for (const char* const name : arrays)
  {
    vtkDataArray* const array = recording ? recording->GetPointData()->GetArray(name) : nullptr;
    if (recording && (!array || array->GetNumberOfComponents() > 3))
    {
      error = std::string("it has no array ") + name;
    }
  }
  if (!error.empty())
  {
    throw std::runtime_error("the recording " + file + " can't be read: " + error);
  }
  return recording;
}

/// Plays the planned path through the servo in real time, one point per tick, which is more exact
/// than any hand.
Agreement ReplayPlan(const Explore::Exploration& exploration, const std::string& file)
{
  const Explore::MessageCapture capture;
  const std::string planned = file + ".planned.vtp";
  const std::string recorded = file + ".replayed.vtp";
  std::string error;
  if (!VolumeHaptics::WriteTracePolyData(exploration.Tip.Path, planned, error))
  {
    throw std::runtime_error("the planned path can't be written: " + error);
  }
  vtkNew<vtkHapticDevice> device;
  device->SetAttentionTime(0.0); // off, because no hand holds the device
  Demand(device->Open(("replay:" + planned).c_str()), "the planned path can't be opened", capture);
  device->SetVolumeHaptics(exploration.Filter);
  device->SetServoRate(exploration.ServoRate);
  // Leave the device disarmed: arming would restart the touch at a later tick.
  Demand(device->Start(), "the servo can't be started", capture);
  Demand(device->GetRecorder()->Start(recorded.c_str()), "the recording can't be started", capture);
  while (device->GetState()->GetTick() < exploration.Tip.Path->GetNumberOfPoints())
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    device->UpdateState();
  }
  Demand(device->GetRecorder()->Stop(), "the recording can't be written", capture);
  device->Stop();
  const Agreement agreement =
    CompareTicks(ReadRecording(recorded, { "Tick", "Tip", "Force" }), exploration.Trace);
  vtksys::SystemTools::RemoveFile(planned);
  vtksys::SystemTools::RemoveFile(recorded);
  return agreement;
}
} // namespace

namespace Explore
{
LiveRun RunLive(const Exploration& exploration, const std::string& file)
{
  vtkVolumeHapticsFilter* const filter = exploration.Filter;
  vtkPolyData* const path = exploration.Tip.Path;
  const MessageCapture capture;
  vtkNew<vtkHapticDevice> device;
  device->SetAttentionTime(0.0); // off, because no hand holds the device
  Demand(device->Open("virtual"), "the virtual device can't be opened", capture);
  device->SetVolumeHaptics(filter);
  device->SetServoRate(exploration.ServoRate);
  device->GetVirtualHand()->SetPosition(path->GetPoint(0));
  Demand(device->Start(), "the servo can't be started", capture);
  device->Arm();
  Demand(device->GetRecorder()->Start(file.c_str()), "the recording can't be started", capture);
  PlayPath(device, path, exploration.ServoRate);
  LiveRun run;
  run.Report = TimeKeeping(device);
  Demand(device->GetRecorder()->Stop(), "the recording can't be written", capture);
  device->Stop();

  run.Trace = ReadRecording(file, { "Force" });
  filter->SetPathData(run.Trace);
  filter->Update();
  const vtkIdType differs = FirstDifference(run.Trace, filter->GetOutput());
  filter->SetPathData(path);
  run.IsReproduced = differs < 0;
  run.Report += run.IsReproduced
    ? "  the offline filter gives the same forces on the recording, bit for bit\n"
    : "  the offline filter gives another force on the recording in tick " +
      std::to_string(differs) + "\n";

  const Agreement plan = ReplayPlan(exploration, file);
  run.IsReproduced = run.IsReproduced && plan.Ticks > 0 && plan.Wrong == 0;
  std::ostringstream text;
  text << "  replayed by the servo in real time, the planned path gives the tips of the offline "
          "trace in "
       << plan.Ticks << " of " << plan.Ticks + plan.Others << " ticks, and the same forces in "
       << plan.Ticks - plan.Wrong << " of these, bit for bit\n";
  run.Report += text.str();
  return run;
}
} // namespace Explore
