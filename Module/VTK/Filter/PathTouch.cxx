// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Filter/PathTouch.h"

#include "Core/Platform/HapticFiles.h"
#include "VTK/Baking/ImageTimeSteps.h"
#include "VTK/Base/vtkVolumeHapticsCompat.h"
#include "VTK/Filter/FilterTimeSteps.h"
#include "VTK/Filter/HapticBaker.h"
#include "VTK/Regions/RegionsAlongPath.h"
#include "VTK/Tools/TissueArrays.h"
#include "VTK/Trace/HapticTrace.h"
#include "VTK/Trace/Paths/TipPaths.h"
#include "VTK/Trace/Paths/TipPathsWalk.h"
#include "VTK/Trace/RecordedLabels.h"
#include "VTK/Trace/RecordingNames.h"
#include "vtkVolumeHapticsFilter.h"

#include "vtkDataArray.h"
#include "vtkHapticRegionSource.h"
#include "vtkHapticTool.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <memory>
#include <new>
#include <string>
#include <utility>

namespace VolumeHaptics
{
namespace
{

/** Touches an image along the path. Sets `ticks` as soon as the number of ticks is known. */
bool TouchPathIn(vtkVolumeHapticsFilter* filter, vtkImageData* image, vtkPolyData* path,
  TraceArrayChoice arrays, ArrayHash& labelHash, vtkPolyData* output, vtkIdType& ticks)
{
  HapticBaker& baker = filter->GetBaker();
  std::string error;
  const double period = 1.0 / filter->GetServoRate();
  TipPaths paths;
  const bool readable = !path ||
    (paths.Read(path, period, error) && (!filter->GetTool() || paths.ReadHand(path, error)));
  const RecordedPath* const recording = paths.GetRecording();
  vtkHapticRegionSource* const source = filter->GetRegionSource();
  if (source && (!path || !readable || recording))
  {
    error = recording ? "The path on port 1 is a recording, which can't be replayed through a "
                        "vtkHapticRegionSource: connect the whole image that it was made with."
                      : error;
    if (!error.empty())
    {
      vtkErrorWithObjectMacro(filter, << Printable(error));
    }
    return error.empty();
  }
  if (AreTimeStepsFelt(filter))
  {
    baker.WarnOfStillSteps();
  }
  const RegionsAlongPath regions(source,
    [&](vtkImageData* region, std::string& flaw)
    { return baker.BakeImage(region, period, ForceCaps{}, nullptr, flaw, nullptr, {}); });
  ImageTimeSteps timeSteps;
  if (path && readable && !source && !CollectTimeStepsOfPaths(filter, paths, timeSteps, error))
  {
    vtkErrorWithObjectMacro(filter, << error);
    return false;
  }
  // Without a path, only check the input, and leave a slow mesh to the background.
  if (readable && !source && timeSteps.TimeSteps.empty() &&
    !(path ? baker.GetPreparation().AwaitSurface() : baker.GetPreparation().IsSurfaceAtHand()))
  {
    return true;
  }
  std::string imageError;
  std::shared_ptr<const HapticModel> model = source
    ? regions.Begin()
    : baker.BakeImage(image, recording ? recording->TickPeriod : period, ForceCaps{}, nullptr,
        imageError, recording ? path : nullptr, std::move(timeSteps));
  if (!model || !readable)
  {
    error = model ? error : imageError;
    vtkErrorWithObjectMacro(filter, << Printable(error));
    return false;
  }

  if (model->Baked->IsMoving())
  {
    baker.WarnOfFastMotion(*model->Baked, true);
  }
  if (path && !ReadLabelHash(path).empty())
  {
    const std::string hash = labelHash.Await(baker.GetTouched()[1],
      [filter](double)
      {
        filter->UpdateProgress(0.0);
        return !MustAbort(filter);
      });
    if (MustAbort(filter))
    {
      return true;
    }
    error = CompareLabels(path, hash);
    if (!error.empty())
    {
      vtkErrorWithObjectMacro(filter, << error);
      return false;
    }
  }

  ticks = paths.GetNumberOfTicks();
  HapticTrace trace(ticks, arrays, *model->Baked);
  TipPathsWalk walk(paths, model, trace,
    source ? [&regions](auto felt, const ServoState& state, const Vector3& tip)
      { return regions.Find(std::move(felt), state, tip); }
           : ModelFinder());
  while (!walk.IsDone())
  {
    filter->UpdateProgress(walk.GetProgress());
    if (MustAbort(filter))
    {
      KeepAbortedOutput(filter);
      break;
    }
    walk.Advance();
    if (walk.GetFlaw() >= 0)
    {
      vtkErrorWithObjectMacro(filter,
        "The recording on port 1 gives numbers that are not finite in tick "
          << walk.GetFlaw() << ": it was changed, or made with another volume. Record again.");
      return false;
    }
  }
  trace.WriteTo(output, walk.GetRows(), paths.AreSeveral());
  if (const auto* const shares = walk.GetFinalTissue())
  {
    AddTissueArrays(*shares, FinalTissueNames, output->GetFieldData());
  }
  // In a recording, tick i is point i of the path, except after the user has aborted the run.
  vtkDataArray* const orientations =
    recording ? path->GetPointData()->GetArray(RecordingNames::Orientation) : nullptr;
  if (orientations && !output->GetPointData()->HasArray(RecordingNames::Orientation) &&
    output->GetNumberOfPoints() == orientations->GetNumberOfTuples())
  {
    output->GetPointData()->AddArray(orientations);
  }
  return true;
}

} // namespace

//------------------------------------------------------------------------------
bool TouchPath(vtkVolumeHapticsFilter* filter, vtkPolyData* path, TraceArrayChoice arrays,
  ArrayHash& labelHash, vtkPolyData* output)
{
  vtkImageData* const image = filter->GetTouchedImage();
  if (!image)
  {
    vtkErrorWithObjectMacro(
      filter, << filter->GetBaker().GetResampled().DescribeFault(filter->GetInputDataObject(0, 0)));
    return false;
  }
  vtkIdType ticks = 0;
  try
  {
    return TouchPathIn(filter, image, path, arrays, labelHash, output, ticks);
  }
  catch (const RegionLost& lost)
  {
    output->Initialize();
    vtkErrorWithObjectMacro(filter, << Printable(lost.what()));
    return false;
  }
  catch (const std::bad_alloc&)
  {
    output->Initialize();
    vtkErrorWithObjectMacro(
      filter, << (ticks > 0 ? DescribeLackOfMemory(ticks) : DescribeLackOfMemory(image)));
    return false;
  }
}

} // namespace VolumeHaptics
