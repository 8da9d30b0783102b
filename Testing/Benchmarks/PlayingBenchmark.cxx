// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PlayingBenchmark.h"

#include "Rigs/GivenImage.h"
#include "WatchedHand.h"

#include <vtkAlgorithmOutput.h>
#include <vtkHapticDevice.h>
#include <vtkHapticProperty.h>
#include <vtkHapticTimeStepSource.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPiecewiseFunction.h>
#include <vtkSmartPointer.h>
#include <vtkVolumeHapticsFilter.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <thread>
#include <vector>

namespace benchmarks
{
namespace
{

constexpr int TimeSteps = 8;
constexpr double FramesPerSecond = 20.0;
/**
 * Number of turns. Each turn measures all rows of the table, so that a temporary disturbance
 * affects all rows equally.
 */
constexpr int Turns = 8;
constexpr double Turn = 1.0;     // s, duration of a turn
constexpr double Settling = 0.3; // s, pause after Start()
/** Pause of a GUI that draws 60 frames per second. */
constexpr auto Pause = std::chrono::milliseconds(16);

/**
 * Makes a time step. The body is on the side of lower x, and its wall advances by one voxel per
 * time step.
 */
vtkSmartPointer<vtkImageData> MakeFrame(int size, int number)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(size, size, size);
  image->AllocateScalars(VTK_SHORT, 1);
  auto* to = static_cast<std::int16_t*>(image->GetScalarPointer());
  std::vector<std::int16_t> row(static_cast<std::size_t>(size));
  for (int i = 0; i < size; ++i)
  {
    const double wall = 0.5 * size + number;
    row[static_cast<std::size_t>(i)] =
      static_cast<std::int16_t>(500.0 * (1.0 - std::tanh((i - wall) / 1.5)));
  }
  for (std::int64_t line = 0; line < std::int64_t{ size } * size; ++line)
  {
    to = std::copy(row.begin(), row.end(), to);
  }
  return image;
}

/** Results in one row of the table. */
struct Row
{
  const char* Name;
  LoopCounts Counts;
  double Longest = 0.0;   ///< ms: longest work of the GUI thread
  double Strongest = 0.0; ///< N, largest force in all turns
  int Waits = 0;
  int Looks = 0;
  int Shown = 0;
  double Seconds = 0.0;
};

void Look(vtkHapticDevice* device, double seconds, Row* row)
{
  using Clock = std::chrono::steady_clock;
  const auto begin = Clock::now();
  const auto since = [](Clock::time_point time)
  { return std::chrono::duration<double>(Clock::now() - time).count(); };
  double timeStep = -1.0;
  while (since(begin) < seconds)
  {
    const auto before = Clock::now();
    device->UpdateState();
    if (row)
    {
      row->Longest = std::max(row->Longest, 1e3 * since(before));
      ++row->Looks;
      row->Waits += device->GetPlayback()->IsWaitingForData() ? 1 : 0;
      row->Shown += device->GetPlayback()->HasTimeSteps() &&
          device->GetPlayback()->GetTimeStepValue() != timeStep
        ? 1
        : 0;
      row->Strongest = std::max(row->Strongest, device->GetState()->GetComputedForce()[0]);
    }
    timeStep =
      device->GetPlayback()->HasTimeSteps() ? device->GetPlayback()->GetTimeStepValue() : timeStep;
    std::this_thread::sleep_for(Pause);
  }
  if (row)
  {
    row->Seconds += since(begin);
  }
}

/** Measures a device for one turn. Returns false if it can't be started. */
bool Watch(vtkHapticDevice* device, LoopWatch& watch, Row& row)
{
  if (!device->Start())
  {
    return false;
  }
  Look(device, Settling, nullptr);
  watch.Reset();
  Look(device, Turn, &row);
  row.Counts += watch.GetCounts();
  device->Stop();
  return true;
}

void Print(const Row& row)
{
  const std::uint64_t* const leftOut = row.Counts.LeftOut;
  std::printf("%-10s %8.0f %9llu %8llu %8llu %9.1f %9.1f %9.1f %10.1f %8.2f\n", row.Name,
    static_cast<double>(row.Counts.Ticks) / row.Seconds,
    static_cast<unsigned long long>(leftOut[LoopCounts::Computed]),
    static_cast<unsigned long long>(leftOut[LoopCounts::Waited]),
    static_cast<unsigned long long>(leftOut[LoopCounts::Machine]),
    1e-3 * static_cast<double>(row.Counts.LongestWork), row.Longest,
    100.0 * row.Waits / std::max(1, row.Looks), row.Shown / row.Seconds, row.Strongest);
}

std::uint64_t CountOwn(const LoopCounts& counts)
{
  return counts.LeftOut[LoopCounts::Computed] + counts.LeftOut[LoopCounts::Waited];
}

/**
 * Prints whether changing time steps delays ticks. A loop without changes shows how many ticks the
 * machine delays: in a virtual machine, a thread's clock continues while the host runs something
 * else.
 */
void Judge(const LoopCounts& still, const LoopCounts& changing)
{
  const auto own = static_cast<double>(CountOwn(changing));
  const double share = static_cast<double>(changing.Ticks) /
    static_cast<double>(std::max<std::uint64_t>(1, still.Ticks));
  const double expected = share * static_cast<double>(CountOwn(still));
  // Allow for two standard deviations of the difference between two small counts.
  const bool isChance = own - expected <= 2.0 * std::sqrt(own + share * expected);
  const char* const verdict = own == 0.0 ? "reached"
    : expected > 0.0 && isChance         ? "not told apart from the machine"
                                         : "NOT reached";
  const auto print = [](const char* what, const LoopCounts& counts)
  {
    std::printf("Left out %s, of %llu ticks: %llu by the loop itself, %llu by the machine\n", what,
      static_cast<unsigned long long>(counts.Ticks),
      static_cast<unsigned long long>(CountOwn(counts)),
      static_cast<unsigned long long>(counts.LeftOut[LoopCounts::Machine]));
  };
  print("while no frame changes", still);
  print("while frames change", changing);
  std::printf("No tick left out because frames change: %s\n", verdict);
}

} // namespace

void MeasurePlaying(int size)
{
  vtkNew<vtkHapticTimeStepSource> source;
  for (int i = 0; i < TimeSteps; ++i)
  {
    source->AddTimeStep(MakeFrame(size, i), i);
  }
  vtkNew<apitest::GivenImage> reader; // copies a time step when the update time reaches it
  reader->SetInputConnection(source->GetOutputPort());
  vtkNew<vtkVolumeHapticsFilter> filter;
  filter->SetInputConnection(0, source->GetOutputPort());
  filter->SetTimeUnitsPerSecond(FramesPerSecond);
  filter->GetProperty()->GetSurfaceStrength()->AddPoint(0.0, 5.0);
  const double middle = 0.5 * size;
  LoopWatch watch;
  vtkHapticDevice::AddDeviceKind(
    MakeWatchedKind(0.001 * VolumeHaptics::Vector3{ middle + 3.0, middle, middle }, &watch));
  vtkNew<vtkHapticDevice> free;
  vtkNew<vtkHapticDevice> device;
  device->SetVolumeHaptics(filter);
  device->GetPlayback()->SetModeToPingPong();
  for (vtkHapticDevice* const each : { free.Get(), device.Get() })
  {
    each->SetAttentionTime(0.0);
    if (!each->Open("watched"))
    {
      return;
    }
  }
  Row rows[4] = { { "no volume", {} }, { "held", {} }, { "in memory", {} }, { "read", {} } };
  auto& [none, held, memory, read] = rows;
  std::printf("Frames of %d^3, %.0f a second, for %.0f s each, in turns of %.0f s\n", size,
    FramesPerSecond, Turns * Turn, Turn);
  std::printf("%-10s %8s %27s %9s %9s %9s %10s %8s\n", "", "", "left out, since the loop",
    "longest", "", "", "", "");
  std::printf("%-10s %8s %9s %8s %8s %9s %9s %9s %10s %8s\n", "", "ticks/s", "computed", "waited",
    "slept", "work us", "GUI ms", "waits %", "frames/s", "most N");
  device->GetPlayback()->SetDataTime(0.0);
  bool isMeasured = true;
  for (int turn = 0; turn < Turns && isMeasured; ++turn)
  {
    isMeasured = Watch(free, watch, none);
    device->GetPlayback()->Hold();
    filter->SetInputConnection(0, source->GetOutputPort());
    isMeasured = isMeasured && Watch(device, watch, held);
    device->GetPlayback()->Play();
    isMeasured = isMeasured && Watch(device, watch, memory);
    filter->SetInputConnection(0, reader->GetOutputPort());
    isMeasured = isMeasured && Watch(device, watch, read);
  }
  if (isMeasured)
  {
    for (const Row& row : rows)
    {
      Print(row);
    }
    LoopCounts still = none.Counts;
    still += held.Counts;
    LoopCounts changing = memory.Counts;
    changing += read.Counts;
    Judge(still, changing);
  }
  free->Close();
  device->Close();
}

} // namespace benchmarks
