// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Device/Playback/WindowPreparation.h"

#include "Core/Model/BakedVolume.h"
#include "VTK/Baking/HapticSurface.h"
#include "VTK/Base/HapticVolume.h"
#include "VTK/Device/Playback/HapticChangeTime.h"
#include "VTK/Filter/FilterFrames.h"
#include "VTK/Filter/HapticBaker.h"
#include "VTK/Filter/HapticModelBuilder.h"

#include "vtkAlgorithmOutput.h"
#include "vtkDataArray.h"
#include "vtkExecutive.h"
#include "vtkHapticFrameSource.h"
#include "vtkImageData.h"
#include "vtkVolumeHapticsFilter.h"

#include <algorithm>
#include <memory>
#include <new>
#include <string>
#include <utility>

namespace VolumeHaptics
{
namespace
{

/** Updates the source of the image; whether it succeeds. */
bool IsUpdated(vtkVolumeHapticsFilter* filter)
{
  try
  {
    vtkAlgorithm* const source = filter->GetInputAlgorithm(0, 0);
    return !source ||
      source->GetExecutive()->Update(filter->GetInputConnection(0, 0)->GetIndex()) != 0;
  }
  catch (const std::bad_alloc&)
  {
    return false;
  }
}

void TellUnread(vtkVolumeHapticsFilter* filter)
{
  vtkErrorWithObjectMacro(filter,
    "A frame of the image on input port 0 can't be read: see the errors of its source, which may "
    "lack memory. SetTimeUnitsPerSecond(0) takes one frame alone.");
}

/** Reads all components as frames; none if there is no image, an error that the baker reports. */
bool ReadComponents(vtkVolumeHapticsFilter* filter, ReadFrames& read)
{
  if (!IsUpdated(filter))
  {
    TellUnread(filter);
    return false;
  }
  std::string error;
  if (!CollectComponents(filter, read.Frames, error))
  {
    vtkErrorWithObjectMacro(filter, << error);
    return false;
  }
  for (const HapticFrame& frame : read.Frames)
  {
    read.Steps.Times.push_back(frame.Time);
  }
  if (!read.Frames.empty())
  {
    const HapticFrame first = read.Frames.front();
    read.Frames.push_back(first);
  }
  return true;
}

/**
 * Whether all frames are in the source's memory in the form that is felt. Meshes and copies of
 * displacements would need further memory for each frame.
 */
bool AreInMemory(vtkVolumeHapticsFilter* filter)
{
  return vtkHapticFrameSource::SafeDownCast(filter->GetInputAlgorithm(0, 0)) &&
    filter->GetMethod() != vtkVolumeHapticsFilter::SURFACE_PROXY &&
    filter->GetDisplacementArrayName().empty();
}

/** Whether two arrays of the same name have the same shape and type. */
bool AreAlike(vtkDataArray* a, vtkDataArray* b)
{
  const auto name = [](vtkDataArray* array)
  { return std::string(array->GetName() ? array->GetName() : ""); };
  return name(a) == name(b) && a->GetDataType() == b->GetDataType() &&
    a->GetNumberOfComponents() == b->GetNumberOfComponents() &&
    a->GetNumberOfTuples() == b->GetNumberOfTuples();
}

/**
 * Reads a time step as ReadFrame() does, but takes it from a window of the same source if it is
 * there.
 */
bool ReadStep(vtkVolumeHapticsFilter* filter, double time, const FrameReading& reading,
  const BakedVolume* kept, HapticFrame& frame)
{
  const auto hasTime = [time](const FieldFrame& other) { return other.Time == time; };
  const std::vector<FieldFrame> none;
  const std::vector<FieldFrame>& frames = kept ? kept->Frames : none;
  const auto known = std::find_if(frames.begin(), frames.end(), hasTime);
  if (known == frames.end())
  {
    return ReadFrame(filter, time, reading, frame);
  }
  // The choice of the touched array may have changed.
  vtkDataArray* wanted = nullptr;
  const auto look = [&](vtkImageData* image)
  {
    wanted = reading.GetArray(image);
    return nullptr;
  };
  if (!ReadFrame(filter, time, { look, reading.Component, {} }, frame))
  {
    return false;
  }
  // See ShareArray() of the model's builder.
  const auto asArray = [](const std::shared_ptr<const void>& samples)
  { return static_cast<vtkDataArray*>(const_cast<void*>(samples.get())); };
  vtkDataArray* const had = asArray(known->Samples);
  if (!wanted || !had || !AreAlike(wanted, had))
  {
    return ReadFrame(filter, time, reading, frame);
  }
  frame.Array = had;
  frame.Displacements = asArray(known->DisplacementSamples);
  return true;
}

/** Reads the window at a place; empty if there is only one time step. */
bool ReadSteps(vtkVolumeHapticsFilter* filter, const FramePlace& place, const BakedVolume* kept,
  ReadFrames& read)
{
  filter->GetInputAlgorithm(0, 0)->UpdateInformation();
  read.Steps.Times = ReadTimeSteps(filter->GetInputInformation(0, 0));
  read.Steps.AreInMemory = AreInMemory(filter);
  const std::vector<double>& steps = read.Steps.Times;
  const std::size_t count = steps.size();
  if (count < 2)
  {
    return true;
  }
  const bool isWhole = read.Steps.AreWindow();
  const double time = place.Time.value_or(steps.front());
  read.First = isWhole ? 0 : read.Steps.FindNeed(time, place.IsBackward, place.Mode).First;
  read.Frames.resize(isWhole ? count + 1 : 2);
  const FrameReading reading = filter->GetBaker().GetReading();
  for (std::size_t i = 0; i < read.Frames.size(); ++i)
  {
    const std::size_t step = (read.First + i) % count;
    bool isRead = true;
    try
    {
      isRead = i == count || ReadStep(filter, steps[step], reading, kept, read.Frames[i]);
    }
    catch (const std::bad_alloc&)
    {
      isRead = false;
    }
    if (!isRead)
    {
      TellUnread(filter);
      return false;
    }
  }
  if (isWhole)
  {
    read.Frames.back() = read.Frames.front();
  }
  // Data that are the same at all times come from the first step, as they do along paths.
  const FrameReading nothing{ [](vtkImageData*) { return nullptr; }, 0, {} };
  HapticFrame first;
  return ReadFrame(filter, steps.front(), nothing, first); // else the source has reported why
}

ReadFrames ReadWindow(
  vtkVolumeHapticsFilter* filter, const FramePlace& place, const BakedVolume* kept)
{
  ReadFrames read;
  read.Steps.AreComponents = filter->GetFrames() == vtkVolumeHapticsFilter::COMPONENTS;
  read.AreRead =
    read.Steps.AreComponents ? ReadComponents(filter, read) : ReadSteps(filter, place, kept, read);
  return read;
}

/** Estimates how long meshing takes; stops counting above ShortMeshing. */
double EstimateMeshTimes(const std::vector<HapticFrame>& frames, double value)
{
  double seconds = 0.0;
  for (std::size_t i = 0; i + 1 < frames.size() && seconds <= ShortMeshing; ++i)
  {
    const HapticFrame& frame = frames[i];
    seconds += frame.Array ? EstimateMeshTime({ frame.Image, frame.Array, frame.Component, value })
                           : 0.0; // the meshing itself reports the error
  }
  return seconds;
}

} // namespace

WindowPreparation::ChangeTimes WindowPreparation::FindTimes(vtkVolumeHapticsFilter* filter)
{
  return { FindChangeTime(filter, true), FindChangeTimeBesideImage(filter) };
}

/**
 * Whether the frames that were read fit the filter's present state. Newer frames of a stream don't
 * count: waiting for the last ones could mean waiting for ever.
 */
bool WindowPreparation::IsOf(vtkVolumeHapticsFilter* filter, const FramePlace& place) const
{
  const ChangeTimes now = FindTimes(filter);
  auto* const source = vtkHapticFrameSource::SafeDownCast(filter->GetInputAlgorithm(0, 0));
  const bool isSame = source && source->GetStreamed() ? this->Times.BesideImage == now.BesideImage
                                                      : this->Times.All == now.All;
  if (!this->IsBegun() || this->Of != filter || !isSame)
  {
    return false;
  }
  const TimeSteps& steps = this->Window->Steps;
  return !this->Window->AreRead || this->Window->Frames.empty() || steps.AreWindow() ||
    this->Window->First ==
    steps.FindNeed(place.Time.value_or(steps.Times.front()), place.IsBackward, place.Mode).First;
}

void WindowPreparation::End()
{
  this->Mesher.End();
  this->Window.reset();
  this->Shaped.clear();
}

bool WindowPreparation::Follow(vtkVolumeHapticsFilter* filter, const FramePlace& place,
  const BakedVolume* last, const BakedVolume* kept)
{
  if (!this->IsOf(filter, place))
  {
    this->End();
    this->Window = ReadWindow(filter, place, kept);
    this->Of = filter;
    this->Times = FindTimes(filter);
    this->Value = filter->GetIsoValue();
    this->TimeOfRest = EstimateMeshTimes(this->Window->Frames, this->Value);
    if (this->TimeOfRest > ShortMeshing && this->Shape(filter, last))
    {
      this->TimeOfRest = 0.0;
    }
    else
    {
      this->Shaped.clear();
    }
  }
  if (!this->Mesher.Follow(this->Shaped, this->Components, this->Value, this->IndexToWorld))
  {
    return false;
  }
  for (std::size_t i = 0; i < this->Shaped.size(); ++i)
  {
    this->Window->Frames[i].Mesh = this->Shaped[i].Mesh;
  }
  return true;
}

/**
 * Shapes the frames as the builder of models does. False for frames that the builder refuses, and
 * for arrays of other layouts, which copy their values for readers, into one copy for all threads.
 */
bool WindowPreparation::Shape(vtkVolumeHapticsFilter* filter, const BakedVolume* last)
{
  const std::vector<HapticFrame>& frames = this->Window->Frames;
  vtkImageData* const image = filter->GetTouchedImage();
  HapticBaker& baker = filter->GetBaker();
  HapticVolume volume;
  std::string error;
  try
  {
    const vtkSmartPointer<vtkDataArray> array = image
      ? baker
          .GetFilled(
            frames.front().Component, filter->GetFrames() == vtkVolumeHapticsFilter::COMPONENTS)
          .Array
      : nullptr;
    if (!array ||
      !ReadVolume(image, array, frames.front().Component, filter->GetKernelRadius(), volume, error))
    {
      return false;
    }
    volume.View.BorderValue = last ? last->Field.GetView().BorderValue : volume.View.BorderValue;
    this->IndexToWorld = volume.IndexToWorld;
    FrameSeries series = MakeSeries(this->Window->Steps.Times);
    series.Last =
      frames.back().Time; // if this is a part of the series, the last frame needs no displacements
    const FrameShape shape{ volume.View, volume.IndexToWorld, series, filter->GetKernelRadius(),
      filter->GetDisplacementArrayName(), baker.GetOutside() };
    this->Components.clear();
    for (const HapticFrame& frame : frames)
    {
      this->Components.push_back(frame.Component);
      this->Shaped.emplace_back();
      if (!frame.Array || !frame.Array->HasStandardMemoryLayout() ||
        !MakeVolumeFrame(frame, shape, this->Shaped.back(), error))
      {
        return false;
      }
    }
    return true;
  }
  catch (const std::bad_alloc&)
  {
    return false; // the builder reports the error
  }
}

ReadFrames WindowPreparation::Take(
  vtkVolumeHapticsFilter* filter, const FramePlace& place, const BakedVolume* kept)
{
  this->TookLate = false;
  if (!this->IsOf(filter, place))
  {
    this->End();
    return ReadWindow(filter, place, kept);
  }
  this->TookLate = this->Times.All != FindTimes(filter).All;
  ReadFrames read = *std::move(this->Window);
  this->End();
  return read;
}

} // namespace VolumeHaptics
