// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/Explorer/Scene/CoarseFrames.h"

#include "vtkCallbackCommand.h"
#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace
{
constexpr double SlowestMotion = 1.0;   // Hz; VTK's rate of still frames is far below
constexpr double UsualRate = 15.0;      // Hz, of vtkRenderWindowInteractor in motion
constexpr double LargestDistance = 6.0; // pixels between rays

struct Frames
{
  vtkSmartPointer<vtkGPUVolumeRayCastMapper> Mapper;
  std::chrono::steady_clock::time_point Start;
  double Sample = 1.0;   // world units between samples, at rest
  double Distance = 1.0; // pixels between rays in motion
};

void OnFrame(vtkObject* caller, unsigned long event, void* data, void*)
{
  auto* const frames = static_cast<Frames*>(data);
  const double rate = static_cast<vtkRenderWindow*>(caller)->GetDesiredUpdateRate();
  const bool inMotion = rate > SlowestMotion;
  const auto now = std::chrono::steady_clock::now();
  if (event == vtkCommand::StartEvent)
  {
    frames->Start = now;
    frames->Mapper->SetImageSampleDistance(static_cast<float>(inMotion ? frames->Distance : 1.0));
    frames->Mapper->SetSampleDistance(static_cast<float>((inMotion ? 2.0 : 1.0) * frames->Sample));
    return;
  }
  // The time is proportional to the number of rays, which falls with the square of their distance.
  const double time = std::chrono::duration<double>(now - frames->Start).count();
  const double ideal =
    inMotion ? frames->Distance * std::sqrt(time * rate) : std::sqrt(0.5 * time * UsualRate);
  frames->Distance = std::clamp(ideal, 1.0, LargestDistance);
}
} // namespace

namespace Explore
{
void DrawCoarselyInMotion(vtkRenderWindow* window, vtkGPUVolumeRayCastMapper* mapper)
{
  vtkNew<vtkCallbackCommand> command;
  auto* const frames = new Frames;
  frames->Mapper = mapper;
  frames->Sample = mapper->GetSampleDistance();
  command->SetClientData(frames);
  command->SetClientDataDeleteCallback([](void* data) { delete static_cast<Frames*>(data); });
  command->SetCallback(OnFrame);
  window->AddObserver(vtkCommand::StartEvent, command);
  window->AddObserver(vtkCommand::EndEvent, command);
}
} // namespace Explore
