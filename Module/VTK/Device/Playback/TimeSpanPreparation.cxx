// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Device/Playback/TimeSpanPreparation.h"

#include "Core/Model/BakedVolume.h"
#include "VTK/Baking/HapticSurface.h"
#include "VTK/Base/HapticVolume.h"
#include "VTK/Device/Playback/HapticChangeTime.h"
#include "VTK/Filter/FilterTimeSteps.h"
#include "VTK/Filter/HapticBaker.h"
#include "VTK/Filter/HapticModelBuilder.h"

#include "vtkAlgorithmOutput.h"
#include "vtkDataArray.h"
#include "vtkExecutive.h"
#include "vtkHapticTimeStepSource.h"
#include "vtkImageData.h"
#include "vtkVolumeHapticsFilter.h"

#include <algorithm>
#include <memory>
#include <new>
#include <string>
#include <utility>

namespace VolumeHaptics
{

TimeSteps::Need TimeSteps::ComputeNeed(double time, bool isBackward, Playback mode) const
{
  const std::size_t count = this->Times.size();
  const bool isLoop = mode == Playback::Loop;
  const auto above = std::upper_bound(this->Times.begin(), this->Times.end(), time);
  std::size_t first =
    above == this->Times.begin() ? 0 : static_cast<std::size_t>(above - this->Times.begin()) - 1;
  const bool isOnStep = this->Times[first] == time;
  const bool isBetween = time > this->Times.back();
  if (isOnStep && isBackward && (first > 0 || isLoop))
  {
    first = this->Before(first);
  }
  else if (first + 1 == count && !isBetween && !(isLoop && !isBackward))
  {
    first = count - 2;
  }
  const bool isLoopEnd = first + 1 == count; // the interval that leads from the last step back to
                                             // the first
  const std::size_t ahead = this->After(this->After(first));
  const std::size_t behind = this->Before(first);
  const bool hasAhead = isLoop || isLoopEnd || first + 2 < count;
  const bool hasBehind = isLoop || isLoopEnd || first > 0;
  // If time can't advance, it may turn around, so choose the step on the other side.
  const bool takesAhead = isBackward ? !hasBehind : hasAhead;
  return { first, takesAhead ? ahead : behind };
}

namespace
{

/** Updates the source of the image. Returns false on failure. */
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

void ReportUnread(vtkVolumeHapticsFilter* filter)
{
  vtkErrorWithObjectMacro(filter,
    "A frame of the image on input port 0 can't be read: see the errors of its source, which may "
    "lack memory. SetTimeUnitsPerSecond(0) takes one frame alone.");
}

/**
 * Reads all components as time steps. Reads none without an image; the baker then reports the
 * error.
 */
bool ReadComponents(vtkVolumeHapticsFilter* filter, PreparedTimeSpan& read)
{
  if (!IsUpdated(filter))
  {
    ReportUnread(filter);
    return false;
  }
  std::string error;
  if (!CollectComponents(filter, read.Images, error))
  {
    vtkErrorWithObjectMacro(filter, << error);
    return false;
  }
  for (const ImageTimeStep& timeStep : read.Images)
  {
    read.Steps.Times.push_back(timeStep.Time);
  }
  if (!read.Images.empty())
  {
    const ImageTimeStep first = read.Images.front();
    read.Images.push_back(first);
  }
  return true;
}

/**
 * Returns whether the source already has all time steps in memory, in the form that is felt.
 * Meshes, or copies of displacements, would need further memory for each time step.
 */
bool AreInMemory(vtkVolumeHapticsFilter* filter)
{
  return vtkHapticTimeStepSource::SafeDownCast(filter->GetInputAlgorithm(0, 0)) &&
    filter->GetMethod() != vtkVolumeHapticsFilter::SURFACE_PROXY &&
    filter->GetDisplacementArrayName().empty();
}

/** Returns whether two arrays of the same name have the same shape and type. */
bool AreAlike(vtkDataArray* a, vtkDataArray* b)
{
  const auto name = [](vtkDataArray* array)
  { return std::string(array->GetName() ? array->GetName() : ""); };
  return name(a) == name(b) && a->GetDataType() == b->GetDataType() &&
    a->GetNumberOfComponents() == b->GetNumberOfComponents() &&
    a->GetNumberOfTuples() == b->GetNumberOfTuples();
}

/**
 * Reads a time step as ReadTimeStep() does, but reuses the copy in a time span of the same source
 * if there is one.
 */
bool ReadStep(vtkVolumeHapticsFilter* filter, double time, const TimeStepReading& reading,
  const BakedVolume* kept, ImageTimeStep& timeStep)
{
  const auto hasTime = [time](const FieldTimeStep& other) { return other.Time == time; };
  const std::vector<FieldTimeStep> none;
  const std::vector<FieldTimeStep>& timeSteps = kept ? kept->TimeSteps : none;
  const auto known = std::find_if(timeSteps.begin(), timeSteps.end(), hasTime);
  if (known == timeSteps.end())
  {
    return ReadTimeStep(filter, time, reading, timeStep);
  }
  // Check that the user has not chosen another array since.
  vtkDataArray* wanted = nullptr;
  const auto look = [&](vtkImageData* image)
  {
    wanted = reading.GetArray(image);
    return nullptr;
  };
  if (!ReadTimeStep(filter, time, { look, reading.Component, {} }, timeStep))
  {
    return false;
  }
  // Samples owns its vtkDataArray: see ShareArray() of the model's builder.
  const auto asArray = [](const std::shared_ptr<const void>& samples)
  { return static_cast<vtkDataArray*>(const_cast<void*>(samples.get())); };
  vtkDataArray* const had = asArray(known->Samples);
  if (!wanted || !had || !AreAlike(wanted, had))
  {
    return ReadTimeStep(filter, time, reading, timeStep);
  }
  timeStep.Array = had;
  timeStep.Displacements = asArray(known->DisplacementSamples);
  return true;
}

/**
 * Reads the time span at a place in the series. Leaves it empty if the series has only one time
 * step.
 */
bool ReadSteps(vtkVolumeHapticsFilter* filter, const TimeStepPlace& place, const BakedVolume* kept,
  PreparedTimeSpan& read)
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
  const bool isWhole = read.Steps.AreAllAtOnce();
  const double time = place.Time.value_or(steps.front());
  read.First = isWhole ? 0 : read.Steps.ComputeNeed(time, place.IsBackward, place.Mode).First;
  read.Images.resize(isWhole ? count + 1 : 2);
  const TimeStepReading reading = filter->GetBaker().GetReading();
  for (std::size_t i = 0; i < read.Images.size(); ++i)
  {
    const std::size_t step = (read.First + i) % count;
    bool isRead = true;
    try
    {
      isRead = i == count || ReadStep(filter, steps[step], reading, kept, read.Images[i]);
    }
    catch (const std::bad_alloc&)
    {
      isRead = false;
    }
    if (!isRead)
    {
      ReportUnread(filter);
      return false;
    }
  }
  if (isWhole)
  {
    read.Images.back() = read.Images.front();
  }
  // Read data that are the same at all times from the first step, as for recorded paths.
  const TimeStepReading nothing{ [](vtkImageData*) { return nullptr; }, 0, {} };
  ImageTimeStep first;
  return ReadTimeStep(filter, steps.front(), nothing, first); // on failure, the source has reported
                                                              // an error
}

PreparedTimeSpan ReadTimeSpan(
  vtkVolumeHapticsFilter* filter, const TimeStepPlace& place, const BakedVolume* kept)
{
  PreparedTimeSpan read;
  read.Steps.AreComponents = filter->GetFrames() == vtkVolumeHapticsFilter::COMPONENTS;
  read.AreRead =
    read.Steps.AreComponents ? ReadComponents(filter, read) : ReadSteps(filter, place, kept, read);
  return read;
}

/** Estimates the total meshing time (s). Stops adding once the sum is above ShortMeshing. */
double EstimateMeshTimes(const std::vector<ImageTimeStep>& timeSteps, double value)
{
  double seconds = 0.0;
  for (std::size_t i = 0; i + 1 < timeSteps.size() && seconds <= ShortMeshing; ++i)
  {
    const ImageTimeStep& timeStep = timeSteps[i];
    seconds += timeStep.Array
      ? EstimateMeshTime({ timeStep.Image, timeStep.Array, timeStep.Component, value })
      : 0.0; // the meshing itself will report the error
  }
  return seconds;
}

} // namespace

TimeSpanPreparation::ChangeTimes TimeSpanPreparation::ComputeChangeTimes(
  vtkVolumeHapticsFilter* filter)
{
  return { ComputeChangeTime(filter, true), ComputeChangeTimeBesideImage(filter) };
}

/**
 * Returns whether the prepared time steps belong to the filter's present state. Ignores newer time
 * steps of a stream: otherwise a fast stream would make the owner wait for ever.
 */
bool TimeSpanPreparation::IsOf(vtkVolumeHapticsFilter* filter, const TimeStepPlace& place) const
{
  const ChangeTimes now = ComputeChangeTimes(filter);
  auto* const source = vtkHapticTimeStepSource::SafeDownCast(filter->GetInputAlgorithm(0, 0));
  const bool isSame = source && source->GetStreamed() ? this->Times.BesideImage == now.BesideImage
                                                      : this->Times.All == now.All;
  if (!this->IsBegun() || this->Of != filter || !isSame)
  {
    return false;
  }
  const TimeSteps& steps = this->Span->Steps;
  return !this->Span->AreRead || this->Span->Images.empty() || steps.AreAllAtOnce() ||
    this->Span->First ==
    steps.ComputeNeed(place.Time.value_or(steps.Times.front()), place.IsBackward, place.Mode).First;
}

void TimeSpanPreparation::End()
{
  this->Mesher.End();
  this->Span.reset();
  this->Shaped.clear();
}

bool TimeSpanPreparation::Poll(vtkVolumeHapticsFilter* filter, const TimeStepPlace& place,
  const BakedVolume* last, const BakedVolume* kept)
{
  if (!this->IsOf(filter, place))
  {
    this->End();
    this->Span = ReadTimeSpan(filter, place, kept);
    this->Of = filter;
    this->Times = ComputeChangeTimes(filter);
    this->Value = filter->GetIsoValue();
    this->TimeOfRest = EstimateMeshTimes(this->Span->Images, this->Value);
    if (this->TimeOfRest > ShortMeshing && this->Shape(filter, last))
    {
      this->TimeOfRest = 0.0;
    }
    else
    {
      this->Shaped.clear();
    }
  }
  if (!this->Mesher.Poll(this->Shaped, this->Components, this->Value, this->IndexToWorld))
  {
    return false;
  }
  for (std::size_t i = 0; i < this->Shaped.size(); ++i)
  {
    this->Span->Images[i].Mesh = this->Shaped[i].Mesh;
  }
  return true;
}

/**
 * Converts the time steps as the model builder does. Returns false if the builder refuses a time
 * step, or if an array has another memory layout: VTK then keeps one converted copy of its values
 * that all reading threads share.
 */
bool TimeSpanPreparation::Shape(vtkVolumeHapticsFilter* filter, const BakedVolume* last)
{
  const std::vector<ImageTimeStep>& timeSteps = this->Span->Images;
  vtkImageData* const image = filter->GetTouchedImage();
  HapticBaker& baker = filter->GetBaker();
  HapticVolume volume;
  std::string error;
  try
  {
    const vtkSmartPointer<vtkDataArray> array = image
      ? baker
          .GetFilled(
            timeSteps.front().Component, filter->GetFrames() == vtkVolumeHapticsFilter::COMPONENTS)
          .Array
      : nullptr;
    if (!array ||
      !ReadVolume(
        image, array, timeSteps.front().Component, filter->GetKernelRadius(), volume, error))
    {
      return false;
    }
    volume.View.BorderValue = last ? last->Field.GetView().BorderValue : volume.View.BorderValue;
    this->IndexToWorld = volume.IndexToWorld;
    TimeStepSeries series = MakeSeries(this->Span->Steps.Times);
    series.Last =
      // In a part of the series, the last time step needs no displacements.
      timeSteps.back().Time;
    const TimeStepShape shape{ volume.View, volume.IndexToWorld, series, filter->GetKernelRadius(),
      filter->GetDisplacementArrayName(), baker.GetOutside() };
    this->Components.clear();
    for (const ImageTimeStep& timeStep : timeSteps)
    {
      this->Components.push_back(timeStep.Component);
      this->Shaped.emplace_back();
      if (!timeStep.Array || !timeStep.Array->HasStandardMemoryLayout() ||
        !MakeVolumeTimeStep(timeStep, shape, this->Shaped.back(), error))
      {
        return false;
      }
    }
    return true;
  }
  catch (const std::bad_alloc&)
  {
    return false; // the model builder will report the error
  }
}

PreparedTimeSpan TimeSpanPreparation::Drain(
  vtkVolumeHapticsFilter* filter, const TimeStepPlace& place, const BakedVolume* kept)
{
  this->TookLate = false;
  if (!this->IsOf(filter, place))
  {
    this->End();
    return ReadTimeSpan(filter, place, kept);
  }
  this->TookLate = this->Times.All != ComputeChangeTimes(filter).All;
  PreparedTimeSpan read = *std::move(this->Span);
  this->End();
  return read;
}

} // namespace VolumeHaptics
