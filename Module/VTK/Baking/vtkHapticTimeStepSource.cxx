// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHapticTimeStepSource.h"

#include "vtkDataObject.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMatrix3x3.h"
#include "vtkObjectFactory.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <vector>

vtkStandardNewMacro(vtkHapticTimeStepSource);

//------------------------------------------------------------------------------
struct vtkHapticTimeStepSource::vtkInternals
{
  using Map = std::map<double, vtkSmartPointer<vtkImageData>>;
  Map TimeSteps; ///< sorted by time

  Map::iterator Find(int number)
  {
    return number >= 0 && number < static_cast<int>(this->TimeSteps.size())
      ? std::next(this->TimeSteps.begin(), number)
      : this->TimeSteps.end();
  }
};

//------------------------------------------------------------------------------
vtkHapticTimeStepSource::vtkHapticTimeStepSource()
  : Internals(new vtkInternals)
{
  this->SetNumberOfInputPorts(0);
}

//------------------------------------------------------------------------------
vtkHapticTimeStepSource::~vtkHapticTimeStepSource() = default;

//------------------------------------------------------------------------------
bool vtkHapticTimeStepSource::AddTimeStep(vtkImageData* image, double time)
{
  if (!image || !std::isfinite(time))
  {
    vtkErrorMacro("A frame needs an image and a finite time, and this one has "
      << (image ? "the time " : "no image, and the time ") << time << ": it is left out.");
    return false;
  }
  this->Internals->TimeSteps[time] = image;
  this->Modified();
  return true;
}

//------------------------------------------------------------------------------
void vtkHapticTimeStepSource::RemoveAllTimeSteps()
{
  if (!this->Internals->TimeSteps.empty())
  {
    this->Internals->TimeSteps.clear();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
int vtkHapticTimeStepSource::GetNumberOfTimeSteps()
{
  return static_cast<int>(this->Internals->TimeSteps.size());
}

//------------------------------------------------------------------------------
vtkImageData* vtkHapticTimeStepSource::GetTimeStepImage(int number)
{
  const auto timeStep = this->Internals->Find(number);
  return timeStep == this->Internals->TimeSteps.end() ? nullptr : timeStep->second.GetPointer();
}

//------------------------------------------------------------------------------
double vtkHapticTimeStepSource::GetTimeStepValue(int number)
{
  const auto timeStep = this->Internals->Find(number);
  return timeStep == this->Internals->TimeSteps.end() ? 0.0 : timeStep->first;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkHapticTimeStepSource::GetMTime()
{
  vtkMTimeType time = this->Superclass::GetMTime();
  for (const auto& timeStep : this->Internals->TimeSteps)
  {
    time = std::max(time, timeStep.second->GetMTime());
  }
  return time;
}

//------------------------------------------------------------------------------
int vtkHapticTimeStepSource::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;

  if (this->Internals->TimeSteps.empty())
  {
    vtkErrorMacro("There are no frames: call AddTimeStep() for each of them first.");
    return 0;
  }
  std::vector<double> times;
  for (const auto& timeStep : this->Internals->TimeSteps)
  {
    times.push_back(timeStep.first);
  }
  vtkInformation* const info = outputs->GetInformationObject(0);
  vtkImageData* const first = this->Internals->TimeSteps.begin()->second;
  info->Set(Pipeline::WHOLE_EXTENT(), first->GetExtent(), 6);
  info->Set(vtkDataObject::SPACING(), first->GetSpacing(), 3);
  info->Set(vtkDataObject::ORIGIN(), first->GetOrigin(), 3);
  info->Set(vtkDataObject::DIRECTION(), first->GetDirectionMatrix()->GetData(), 9);
  info->Set(Pipeline::TIME_STEPS(), times.data(), static_cast<int>(times.size()));
  const double range[] = { times.front(), times.back() };
  info->Set(Pipeline::TIME_RANGE(), range, 2);
  return 1;
}

//------------------------------------------------------------------------------
int vtkHapticTimeStepSource::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;

  const auto& timeSteps = this->Internals->TimeSteps;
  if (timeSteps.empty())
  {
    return 0; // RequestInformation() has reported the error; VTK does not call it again
  }
  vtkInformation* const info = outputs->GetInformationObject(0);
  const bool asksTime = info->Has(Pipeline::UPDATE_TIME_STEP()) != 0;
  auto timeStep = timeSteps.begin();
  if (asksTime)
  {
    const auto after = timeSteps.upper_bound(info->Get(Pipeline::UPDATE_TIME_STEP()));
    timeStep = after == timeSteps.begin() ? after : std::prev(after);
  }
  vtkImageData* const output = vtkImageData::GetData(info);
  output->ShallowCopy(timeStep->second);
  output->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), timeStep->first);
  return 1;
}

//------------------------------------------------------------------------------
void vtkHapticTimeStepSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfFrames: " << this->GetNumberOfTimeSteps() << "\n";
  os << indent << "Streamed: " << (this->Streamed ? "On" : "Off") << "\n";
}
