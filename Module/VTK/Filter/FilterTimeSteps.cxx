// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Filter/FilterTimeSteps.h"

#include "Core/Model/BakedVolume.h"
#include "Core/Platform/HapticFiles.h"
#include "VTK/Base/HapticNoise.h"
#include "VTK/Base/HapticVolume.h"
#include "VTK/Filter/HapticBaker.h"
#include "VTK/Trace/Paths/TipPaths.h"
#include "vtkVolumeHapticsFilter.h"

#include "vtkDataArray.h"
#include "vtkHapticProperty.h"
#include "vtkHapticTimeStepSource.h"
#include "vtkImageData.h"

#include <algorithm>

namespace VolumeHaptics
{
namespace
{
/**
 * Limits on the number of pairs of time steps whose edges are compared. PairsAtOnce: per call.
 * MostPairs: per series.
 */
constexpr std::size_t PairsAtOnce = 8;
constexpr std::size_t MostPairs = 64;

double ComputeLastDataTime(const RecordedPath& recording)
{
  return *std::max_element(recording.DataTimes.begin(), recording.DataTimes.end());
}

/** Repeats the first time step at the end if the recording played the time steps in a loop. */
void AddLoop(const RecordedPath& recording, std::vector<ImageTimeStep>& timeSteps)
{
  if (!timeSteps.empty() && ComputeLastDataTime(recording) > timeSteps.back().Time)
  {
    const ImageTimeStep first = timeSteps.front();
    timeSteps.push_back(first);
  }
}
} // namespace

//------------------------------------------------------------------------------
bool AreTimeStepsFelt(vtkVolumeHapticsFilter* filter)
{
  return filter->GetFrames() == vtkVolumeHapticsFilter::TIME_STEPS &&
    filter->GetTimeUnitsPerSecond() != 0.0 && filter->GetNumberOfInputConnections(1) > 0;
}

//------------------------------------------------------------------------------
bool CollectComponents(
  vtkVolumeHapticsFilter* filter, std::vector<ImageTimeStep>& timeSteps, std::string& error)
{
  vtkImageData* const image = filter->GetTouchedImage();
  vtkDataArray* const array = image ? filter->GetBaker().GetReading().GetArray(image) : nullptr;
  if (!array)
  {
    return true;
  }
  const char* flaw = nullptr;
  if (array->GetNumberOfComponents() < 2)
  {
    flaw = " has one component, and the components are the frames (SetFramesToComponents). Give it "
           "one for each frame, for example with vtkNIFTIImageReader::TimeAsVectorOn(), or take "
           "SetFramesToTimeSteps().";
  }
  else if (!filter->GetDisplacementArrayName().empty())
  {
    flaw = " has frames that are components (SetFramesToComponents), which have no displacements. "
           "Give them as time steps, or take SetDisplacementArrayName(\"\").";
  }
  if (flaw)
  {
    error = "The input image's " + Printable(DescribeArray(array)) + flaw;
    return false;
  }
  timeSteps = MakeComponentTimeSteps(image, array, filter->GetFrameSpacing());
  return true;
}

//------------------------------------------------------------------------------
bool CollectTimeStepsOfPaths(vtkVolumeHapticsFilter* filter, const TipPaths& paths,
  ImageTimeSteps& timeSteps, std::string& error)
{
  const RecordedPath* const recording = paths.GetRecording();
  const bool isMoving = recording && !recording->DataTimes.empty();
  if (recording && !isMoving)
  {
    return true;
  }
  const bool areComponents = filter->GetFrames() == vtkVolumeHapticsFilter::COMPONENTS;
  if (areComponents && filter->GetTimeUnitsPerSecond() != 0.0)
  {
    const bool areThere = CollectComponents(filter, timeSteps.TimeSteps, error);
    if (isMoving)
    {
      AddLoop(*recording, timeSteps.TimeSteps);
    }
    return areThere;
  }
  const std::vector<double> steps = AreTimeStepsFelt(filter)
    ? ReadTimeSteps(filter->GetInputInformation(0, 0))
    : std::vector<double>();
  if (steps.empty())
  {
    if (isMoving)
    {
      error = "The recording on port 1 is of a volume that moves (it has the point array "
              "DataTime), and the image on input port 0 does not. Connect the source of its "
              "time steps, with a TimeUnitsPerSecond that is not 0.";
    }
    return !isMoving;
  }
  const double last = isMoving
    ? ComputeLastDataTime(*recording)
    : steps.front() + filter->GetTimeUnitsPerSecond() * paths.ComputeLastTime();
  timeSteps.Series = MakeSeries(steps);
  timeSteps.TimeSteps = CollectTimeSteps(filter, steps, last, filter->GetBaker().GetReading());
  if (isMoving)
  {
    AddLoop(*recording, timeSteps.TimeSteps);
  }
  if (timeSteps.TimeSteps.empty())
  {
    error = "A time step of the image on input port 0 can't be read: see the errors of its "
            "source. SetTimeUnitsPerSecond(0) takes one time step alone.";
  }
  return !timeSteps.TimeSteps.empty();
}

//------------------------------------------------------------------------------
std::vector<std::size_t> FastMotionWarning::ChoosePairs(
  const BakedVolume& volume, bool isLoop) const
{
  std::vector<std::size_t> fresh;
  for (std::size_t i = 0; i + 1 < volume.TimeSteps.size(); ++i)
  {
    const FieldTimeStep& timeStep = volume.TimeSteps[i];
    const bool isKnown = std::find(this->LookedAt.begin(), this->LookedAt.end(), timeStep.Time) !=
      this->LookedAt.end();
    if (!isKnown && !timeStep.Motion && (isLoop || timeStep.Time < volume.Series.Last))
    {
      fresh.push_back(i);
    }
  }
  std::vector<std::size_t> chosen;
  const std::size_t room = MostPairs - std::min(MostPairs, this->LookedAt.size());
  const std::size_t step = fresh.size() / (PairsAtOnce + 1) + 1;
  for (std::size_t i = 0; i < fresh.size() && chosen.size() < room; i += step)
  {
    chosen.push_back(fresh[i]);
  }
  return chosen;
}

//------------------------------------------------------------------------------
std::string FastMotionWarning::Describe(
  vtkVolumeHapticsFilter* filter, const BakedVolume& volume, bool isLoop)
{
  vtkAlgorithm* const producer = filter->GetInputAlgorithm(0, 0);
  auto* const source = vtkHapticTimeStepSource::SafeDownCast(producer);
  const bool isStream = source && source->GetStreamed();
  const SeriesKey series = { producer, isStream ? 0 : producer->GetMTime() };
  if (!filter->GetDisplacementArrayName().empty() || (this->HasWarned && this->Series == series))
  {
    return {};
  }
  if (this->Series != series)
  {
    vtkImageData* const image = filter->GetTouchedImage();
    vtkDataArray* const scalars = image ? filter->GetBaker().GetReading().GetArray(image) : nullptr;
    if (!scalars)
    {
      return {};
    }
    const bool areComponents = filter->GetFrames() == vtkVolumeHapticsFilter::COMPONENTS;
    const int component = areComponents ? 0 : filter->GetProperty()->GetComponent();
    this->Noise = EstimateImageNoise(image, scalars, volume.Field.GetView(), component).Noise;
    this->Series = series;
    this->HasWarned = false;
    this->LookedAt.clear();
  }
  const std::vector<std::size_t> pairs = this->ChoosePairs(volume, isLoop);
  for (const std::size_t i : pairs)
  {
    this->LookedAt.push_back(volume.TimeSteps[i].Time);
  }
  std::string warning = DescribeFastMotion(volume, pairs, this->Noise);
  this->HasWarned = !warning.empty();
  return warning;
}

} // namespace VolumeHaptics
