// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHapticFrameSource.h"

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

vtkStandardNewMacro(vtkHapticFrameSource);

//------------------------------------------------------------------------------
struct vtkHapticFrameSource::vtkInternals
{
  using Map = std::map<double, vtkSmartPointer<vtkImageData>>;
  Map Frames; ///< sorted by time

  Map::iterator Find(int number)
  {
    return number >= 0 && number < static_cast<int>(this->Frames.size())
      ? std::next(this->Frames.begin(), number)
      : this->Frames.end();
  }
};

//------------------------------------------------------------------------------
vtkHapticFrameSource::vtkHapticFrameSource()
  : Internals(new vtkInternals)
{
  this->SetNumberOfInputPorts(0);
}

//------------------------------------------------------------------------------
vtkHapticFrameSource::~vtkHapticFrameSource() = default;

//------------------------------------------------------------------------------
bool vtkHapticFrameSource::AddFrame(vtkImageData* image, double time)
{
  if (!image || !std::isfinite(time))
  {
    vtkErrorMacro("A frame needs an image and a finite time, and this one has "
      << (image ? "the time " : "no image, and the time ") << time << ": it is left out.");
    return false;
  }
  this->Internals->Frames[time] = image;
  this->Modified();
  return true;
}

//------------------------------------------------------------------------------
void vtkHapticFrameSource::RemoveAllFrames()
{
  if (!this->Internals->Frames.empty())
  {
    this->Internals->Frames.clear();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
int vtkHapticFrameSource::GetNumberOfFrames()
{
  return static_cast<int>(this->Internals->Frames.size());
}

//------------------------------------------------------------------------------
vtkImageData* vtkHapticFrameSource::GetFrame(int number)
{
  const auto frame = this->Internals->Find(number);
  return frame == this->Internals->Frames.end() ? nullptr : frame->second.GetPointer();
}

//------------------------------------------------------------------------------
double vtkHapticFrameSource::GetFrameTime(int number)
{
  const auto frame = this->Internals->Find(number);
  return frame == this->Internals->Frames.end() ? 0.0 : frame->first;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkHapticFrameSource::GetMTime()
{
  vtkMTimeType time = this->Superclass::GetMTime();
  for (const auto& frame : this->Internals->Frames)
  {
    time = std::max(time, frame.second->GetMTime());
  }
  return time;
}

//------------------------------------------------------------------------------
int vtkHapticFrameSource::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;

  if (this->Internals->Frames.empty())
  {
    vtkErrorMacro("There are no frames: call AddFrame() for each of them first.");
    return 0;
  }
  std::vector<double> times;
  for (const auto& frame : this->Internals->Frames)
  {
    times.push_back(frame.first);
  }
  vtkInformation* const info = outputs->GetInformationObject(0);
  vtkImageData* const first = this->Internals->Frames.begin()->second;
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
int vtkHapticFrameSource::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;

  const auto& frames = this->Internals->Frames;
  if (frames.empty())
  {
    return 0; // RequestInformation() has reported this; VTK does not call it again
  }
  vtkInformation* const info = outputs->GetInformationObject(0);
  const bool asksTime = info->Has(Pipeline::UPDATE_TIME_STEP()) != 0;
  auto frame = frames.begin();
  if (asksTime)
  {
    const auto after = frames.upper_bound(info->Get(Pipeline::UPDATE_TIME_STEP()));
    frame = after == frames.begin() ? after : std::prev(after);
  }
  vtkImageData* const output = vtkImageData::GetData(info);
  output->ShallowCopy(frame->second);
  output->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), frame->first);
  return 1;
}

//------------------------------------------------------------------------------
void vtkHapticFrameSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfFrames: " << this->GetNumberOfFrames() << "\n";
  os << indent << "Streamed: " << (this->Streamed ? "On" : "Off") << "\n";
}
