// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PlayingBenchmark.h"

#include <vtkAlgorithmOutput.h>
#include <vtkHapticDevice.h>
#include <vtkHapticFrameSource.h>
#include <vtkHapticProperty.h>
#include <vtkImageAlgorithm.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
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

constexpr int Frames = 8;
constexpr double FramesPerSecond = 20.0;
constexpr double Seconds = 8.0;
/** Of a GUI that draws 60 pictures a second. */
constexpr auto Pause = std::chrono::milliseconds(16);

/** Inside at lower x; the wall comes by a voxel a frame. */
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

/** Gives frames as a reader of files does, which are copied one by one as time comes to them. */
class StepReader : public vtkImageAlgorithm
{
public:
  static StepReader* New() { VTK_STANDARD_NEW_BODY(StepReader); }
  vtkTypeMacro(StepReader, vtkImageAlgorithm);

protected:
  int RequestData(
    vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override
  {
    vtkImageData::GetData(outputs)->ShallowCopy(vtkImageData::GetData(inputs[0]));
    return 1;
  }
};

void Watch(vtkHapticDevice* device, const char* what)
{
  using Clock = std::chrono::steady_clock;
  device->UpdateState();
  device->ResetStatistics();
  const auto begin = Clock::now();
  double longest = 0.0;
  double strongest = 0.0;
  int waits = 0;
  int looks = 0;
  int shown = 0;
  double frame = -1.0;
  while (std::chrono::duration<double>(Clock::now() - begin).count() < Seconds)
  {
    const auto before = Clock::now();
    device->UpdateState();
    longest =
      std::max(longest, std::chrono::duration<double, std::milli>(Clock::now() - before).count());
    ++looks;
    waits += device->IsWaitingForData() ? 1 : 0;
    shown += device->HasFrames() && device->GetFrameTime() != frame ? 1 : 0;
    frame = device->HasFrames() ? device->GetFrameTime() : frame;
    strongest = std::max(strongest, device->GetComputedForce()[0]);
    std::this_thread::sleep_for(Pause);
  }
  std::printf("%-10s %8.1f %10lld %9.1f %9.1f %9.1f %10.1f %8.2f\n", what, device->GetTickRate(),
    static_cast<long long>(device->GetMissedTicks()), 1e6 * device->GetTickPercentile(99.0),
    longest, 100.0 * waits / looks, shown / Seconds, strongest);
}

} // namespace

void MeasurePlaying(int size)
{
  vtkNew<vtkHapticFrameSource> source;
  for (int i = 0; i < Frames; ++i)
  {
    source->AddFrame(MakeFrame(size, i), i);
  }
  vtkNew<StepReader> reader;
  reader->SetInputConnection(source->GetOutputPort());
  vtkNew<vtkVolumeHapticsFilter> filter;
  filter->SetInputConnection(0, source->GetOutputPort());
  filter->SetTimeUnitsPerSecond(FramesPerSecond);
  filter->GetProperty()->GetSurfaceStrength()->AddPoint(0.0, 5.0);
  vtkNew<vtkHapticDevice> device;
  device->SetAttentionTime(0.0);
  device->SetVolumeHaptics(filter);
  const double middle = 0.5 * size;
  if (!device->Open("virtual"))
  {
    return;
  }
  device->SetVirtualTip(middle + 3.0, middle, middle);
  device->SetPlaybackToPingPong();
  if (!device->Start())
  {
    return;
  }
  std::printf("Frames of %d^3, %.0f a second, for %.0f s each\n", size, FramesPerSecond, Seconds);
  std::printf("%-10s %8s %10s %9s %9s %9s %10s %8s\n", "", "ticks/s", "missed", "p99 us", "GUI ms",
    "waits %", "frames/s", "most N");
  device->SetDataTime(0.0);
  Watch(device, "held");
  device->Play();
  Watch(device, "in memory");
  filter->SetInputConnection(0, reader->GetOutputPort());
  if (device->Publish())
  {
    Watch(device, "read");
  }
  device->Close();
}

} // namespace benchmarks
