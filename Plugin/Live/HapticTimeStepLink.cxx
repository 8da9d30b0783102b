// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "HapticTimeStepLink.h"

#include "VTK/Base/ArrayMemory.h"

#include "vtkFloatArray.h"
#include "vtkHapticDevice.h"
#include "vtkNew.h"
#include "vtkPVDataInformation.h"
#include "vtkPointData.h"
#include "vtkSMOutputPort.h"
#include "vtkSMSourceProxy.h"
#include "vtkTimerLog.h"
#include "vtkVolumeHapticsFilter.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace VolumeHapticsLive
{
namespace
{

///@{
/** Shortest and longest duration (s) of a step of the animation, and duration of the first step. */
constexpr double ShortestStep = 0.02;
constexpr double LongestStep = 0.3;
constexpr double SingleStep = 0.1;
///@}
/**
 * Fraction of the previous step's duration in which the servo moves, so that it arrives before the
 * next step.
 */
constexpr double StepFraction = 0.9;
/**
 * Time (s, of the servo's states) for which the data time may stop. After it, IsThere() no longer
 * waits for the servo to reach the next image.
 */
constexpr double Patience = 0.5;
/** Time (s) in which the servo reaches the first image. */
constexpr double BeginTime = 0.005;

/**
 * Returns a copy of an image with zero displacements, from which the servo moves to the image
 * itself without a known motion.
 */
vtkSmartPointer<vtkImageData> WithoutMotion(vtkImageData* image, const std::string& displacements)
{
  if (displacements.empty())
  {
    return image;
  }
  auto still = vtkSmartPointer<vtkImageData>::New();
  still->ShallowCopy(image);
  vtkNew<vtkFloatArray> none;
  none->SetName(displacements.c_str());
  none->SetNumberOfComponents(3);
  VolumeHaptics::AllocateTuples(none, image->GetNumberOfPoints());
  none->Fill(0.0);
  still->GetPointData()->AddArray(none);
  return still;
}

} // namespace

bool HapticTimeStepLink::IsMoving(
  vtkSMSourceProxy* volume, unsigned int port, vtkVolumeHapticsFilter* filter)
{
  const int method = filter->GetMethod();
  const bool isFixed = method == vtkVolumeHapticsFilter::PRIMITIVES ||
    (method == vtkVolumeHapticsFilter::SURFACE_PROXY && filter->GetNumberOfInputConnections(2) > 0);
  const bool canMove = !isFixed && filter->GetTimeUnitsPerSecond() != 0.0 &&
    filter->GetFrames() == vtkVolumeHapticsFilter::TIME_STEPS;
  vtkSMOutputPort* const output = canMove && volume ? volume->GetOutputPort(port) : nullptr;
  if (!output)
  {
    return false;
  }
  vtkPVDataInformation* const data = output->GetDataInformation();
  // Other kinds of data are resampled separately for each time step, so they do not move.
  if (data->IsCompositeDataSet() || !data->DataSetTypeIsA("vtkImageData"))
  {
    return false;
  }
  const double* const range = data->GetTimeRange();
  return data->GetNumberOfTimeSteps() > 1 || range[0] < range[1];
}

void HapticTimeStepLink::Begin(
  vtkImageData* image, double time, vtkVolumeHapticsFilter* filter, vtkHapticDevice* device)
{
  // Begin with a step that ends at this image, so that the servo reaches it from any position of
  // its clock.
  this->From = WithoutMotion(image, filter->GetDisplacementArrayName());
  this->To = image;
  this->FromTime = time - (1.0 + 0.1 * std::abs(time));
  this->ToTime = time;
  this->Filter = filter;
  this->Source = vtkSmartPointer<vtkHapticTimeStepSource>::New();
  this->Source->StreamedOn();
  this->IsBeginning = true;
  this->Send();
  filter->SetInputConnection(0, this->Source->GetOutputPort());
  device->GetPlayback()->SetModeToOnce();
  device->GetPlayback()->Play();
  this->SetDuration(BeginTime, device);
}

void HapticTimeStepLink::Go(
  vtkImageData* from, vtkImageData* to, double time, vtkHapticDevice* device)
{
  const double elapsed = vtkTimerLog::GetUniversalTime() - this->SentAt;
  this->From = from;
  this->To = to;
  this->FromTime = this->ToTime;
  this->ToTime = time;
  this->IsBeginning = false;
  this->Send();
  this->SetDuration(
    elapsed > LongestStep ? SingleStep : StepFraction * std::max(elapsed, ShortestStep), device);
}

void HapticTimeStepLink::Replace(vtkImageData* from, vtkImageData* to)
{
  this->From = from;
  this->To = to;
  this->Send();
}

void HapticTimeStepLink::Send()
{
  this->Source->RemoveAllTimeSteps();
  this->Source->AddTimeStep(this->From, this->FromTime);
  this->Source->AddTimeStep(this->To, this->ToTime);
  this->Source->Update(); // at once, because other links compare the source's image
}

void HapticTimeStepLink::SetDuration(double seconds, vtkHapticDevice* device)
{
  this->SentAt = vtkTimerLog::GetUniversalTime();
  this->SeenAt = 0.0;
  const double rate = (this->ToTime - this->FromTime) / seconds;
  device->GetPlayback()->SetSpeed(rate / this->Filter->GetTimeUnitsPerSecond());
}

void HapticTimeStepLink::Clear()
{
  this->Source = nullptr;
  this->Filter = nullptr;
  this->From = this->To = nullptr;
}

bool HapticTimeStepLink::IsThere(vtkHapticDevice* device)
{
  // Use the time of the servo's states, because the computer's clock is meaningless after the user
  // interface was busy.
  if (device->GetPlayback()->GetDataTime() != this->SeenTime || this->SeenAt == 0.0)
  {
    this->SeenTime = device->GetPlayback()->GetDataTime();
    this->SeenAt = device->GetState()->GetTime();
  }
  return !device->IsRunning() || this->SeenTime == this->ToTime ||
    device->GetState()->GetTime() - this->SeenAt > Patience;
}

} // namespace VolumeHapticsLive
