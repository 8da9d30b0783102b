// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef HapticBaker_h
#define HapticBaker_h

#include "Core/Model/ForceCaps.h"
#include "VTK/Baking/HapticSurface.h"
#include "VTK/Baking/ImageTimeSteps.h"
#include "VTK/Base/TouchedArray.h"
#include "VTK/Filter/BakePreparation.h"
#include "VTK/Filter/FilterTimeSteps.h"
#include "VTK/Filter/RegionSeries.h"
#include "VTK/Filter/ResampledInput.h"
#include "vtkVolumeHapticsFilter.h"
#include "vtkVolumeHapticsModule.h" // for export macro

#include "vtkDataArray.h"
#include "vtkHapticProperty.h"
#include "vtkImageData.h"

#include <array>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace VolumeHaptics
{

/**
 * Makes models from a filter and its inputs for the callers that compute ticks: the device, and the
 * search for a surface under the mouse. Belongs to the filter, and keeps what later bakes need.
 */
class VTKVOLUMEHAPTICS_EXPORT HapticBaker
{
public:
  explicit HapticBaker(vtkVolumeHapticsFilter* filter)
    : Filter(filter)
    , Preparation(filter)
  {
  }

  /**
   * Updates port 0 and bakes it, with the property and all settings, for a servo that ticks at a
   * rate (Hz), with the caps of its device. The matrix maps the servo's device space (m) to the
   * world; nullptr means the world scaled by MetersPerWorldUnit. Returns null after an error.
   */
  std::shared_ptr<const HapticModel> Bake(
    double rate, const ForceCaps& deviceCaps, vtkMatrix4x4* deviceToWorld)
  {
    return this->BakeOrTell(rate, deviceCaps, deviceToWorld, {});
  }

  /**
   * Bakes like Bake(), with time steps of a moving volume whose source is at the first of these
   * time steps.
   */
  std::shared_ptr<const HapticModel> BakeTimeSteps(double rate, const ForceCaps& deviceCaps,
    vtkMatrix4x4* deviceToWorld, std::vector<ImageTimeStep>&& timeSteps,
    const std::vector<double>& steps)
  {
    return this->BakeOrTell(
      rate, deviceCaps, deviceToWorld, { std::move(timeSteps), MakeSeries(steps) });
  }

  /** Returns the data times of the image's time steps; empty if there are fewer than two. */
  std::vector<double> GetDataTimes()
  {
    if (this->Filter->GetFrames() == vtkVolumeHapticsFilter::TIME_STEPS)
    {
      return this->Filter->GetNumberOfInputConnections(0) > 0
        ? ReadTimeSteps(this->Filter->GetInputInformation(0, 0))
        : std::vector<double>();
    }
    vtkImageData* const image = this->Filter->GetTouchedImage();
    vtkDataArray* const array = image ? this->GetReading().GetArray(image) : nullptr;
    const int count = array ? array->GetNumberOfComponents() : 0;
    std::vector<double> times;
    for (int i = 0; count > 1 && i < count; ++i)
    {
      times.push_back(i * this->Filter->GetFrameSpacing());
    }
    return times;
  }

  /** Returns which arrays of a time step are read. */
  TimeStepReading GetReading()
  {
    const auto getArray = [filter = this->Filter](vtkImageData* step)
    {
      int association = vtkDataObject::FIELD_ASSOCIATION_POINTS;
      vtkDataArray* const array = filter->GetChosenArray(0, step, association);
      return association == vtkDataObject::FIELD_ASSOCIATION_POINTS ? array : nullptr;
    };
    return { getArray, this->Filter->GetProperty()->GetComponent(),
      this->Filter->GetDisplacementArrayName() };
  }

  /**
   * Bakes like Bake(), but only a part of the image, with the isosurface in it. Updates nothing.
   * Returns null, without an error, if the part can't be touched.
   */
  std::shared_ptr<const HapticModel> BakeRegion(const SurfaceRegion& part, double rate,
    const ForceCaps& deviceCaps, vtkMatrix4x4* deviceToWorld);

  /**
   * Bakes an image without changing it, for ticks of a period (s). Returns null, with the cure in
   * `error`, if it can't be touched.
   * @param recording the recording that is replayed, whose version decides where the material is
   * read; null if there is none
   */
  std::shared_ptr<const HapticModel> BakeImage(vtkImageData* image, double tickPeriod,
    const ForceCaps& deviceCaps, vtkMatrix4x4* deviceToWorld, std::string& error,
    vtkPolyData* recording, ImageTimeSteps&& timeSteps);

  /** Whether walls between the labels on port 3 are felt. False if there are no labels. */
  bool HasLabelWalls();
  /**
   * Whether the scalars of an image on port 0 are felt as labels. False if they can't be labels.
   */
  bool AreLabels(vtkImageData* image);

  /**
   * Whether the data on port 0 are a grid that is not an image, and are resampled around the tip.
   */
  bool IsResampled();
  /** Warns once that only the first time step of a grid is felt. */
  void WarnOfStillSteps();
  /**
   * Warns once for each series of time steps if edges move too fast for blending.
   * @param isLoop whether the first time step follows the last one
   */
  void WarnOfFastMotion(const BakedVolume& volume, bool isLoop);

  BakePreparation& GetPreparation() { return this->Preparation; }
  ResampledInput& GetResampled() { return this->Resampled; }

  /** Returns the arrays of HashScalars() and HashLabels(). An array that is missing is null. */
  std::array<TouchedArray, 2> GetTouched();
  /**
   * Returns the array of HashScalars() with its outside samples filled: see
   * BakePreparation::FillOutside().
   */
  TouchedArray GetFilled()
  {
    return this->GetFilled(this->Filter->GetProperty()->GetComponent(), false);
  }
  TouchedArray GetFilled(int component, bool areTimeSteps);
  /** Returns which samples were outside in the array that was filled last. */
  const OutsideSamples& GetOutside() { return this->Preparation.GetOutside().GetLast(); }

private:
  vtkDataArray* GetArray(int index, vtkDataObject* data)
  {
    int association = vtkDataObject::FIELD_ASSOCIATION_POINTS;
    return this->Filter->GetChosenArray(index, data, association);
  }
  /** Bakes like Bake(), and reports errors as the filter's. */
  std::shared_ptr<const HapticModel> BakeOrTell(double rate, const ForceCaps& deviceCaps,
    vtkMatrix4x4* deviceToWorld, ImageTimeSteps&& timeSteps);
  std::shared_ptr<const HapticModel> BakeInput(double rate, const ForceCaps& deviceCaps,
    vtkMatrix4x4* deviceToWorld, ImageTimeSteps&& timeSteps);
  /**
   * Bakes the labels, if there are any, for `recording`, which may be null. Returns false after an
   * error.
   */
  bool BakeLabels(
    vtkPolyData* recording, std::shared_ptr<const BakedLabels>& labels, std::string& error);
  bool ReadPlacement(vtkMatrix4x4* deviceToWorld, Affine3& placement, std::string& error);

  vtkVolumeHapticsFilter* const Filter;
  BakePreparation Preparation;
  ResampledInput Resampled;
  FastMotionWarning MotionWarning;
  RegionSeries Regions;
  std::weak_ptr<const BakedVolume> LastBaked; ///< last baked volume, reused as long as something
                                              ///< else keeps it alive
  vtkMTimeType LastBakedTime = 0;
};

} // namespace VolumeHaptics

#endif
