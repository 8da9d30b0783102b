// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef HapticBaker_h
#define HapticBaker_h

#include "Core/Model/ForceCaps.h"
#include "VTK/Baking/HapticFrames.h"
#include "VTK/Baking/SurfaceRegion.h"
#include "VTK/Base/TouchedArray.h"
#include "VTK/Filter/BakePreparation.h"
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
 * Makes models from a filter and its inputs for the code that ticks on them: the device, and the
 * search for a surface under the mouse. Models do not belong to the filter's public interface.
 */
class VTKVOLUMEHAPTICS_EXPORT HapticBaker
{
public:
  explicit HapticBaker(vtkVolumeHapticsFilter* filter)
    : Filter(filter)
  {
  }

  /**
   * Updates port 0 and bakes it, with the property and all settings, for a servo that ticks at a
   * rate (Hz), with the caps of its device. The matrix maps the servo's device space (m) to the
   * world; nullptr means the world scaled by MetersPerWorldUnit. Returns null after an error.
   */
  std::shared_ptr<const HapticModel> Bake(
    double rate, const ForceCaps& deviceCaps, vtkMatrix4x4* deviceToWorld) const
  {
    return this->BakeOrTell(rate, deviceCaps, deviceToWorld, {});
  }

  /**
   * Bakes like Bake(), with frames of a volume that moves, whose source is at the first of these
   * time steps.
   */
  std::shared_ptr<const HapticModel> BakeFrames(double rate, const ForceCaps& deviceCaps,
    vtkMatrix4x4* deviceToWorld, std::vector<HapticFrame>&& frames,
    const std::vector<double>& steps) const
  {
    return this->BakeOrTell(
      rate, deviceCaps, deviceToWorld, { std::move(frames), MakeSeries(steps) });
  }

  /** Returns the data times of the image's frames; empty if there are fewer than two. */
  std::vector<double> FindFrameTimes() const
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

  /** Says which arrays of a time step are read. */
  FrameReading GetReading() const
  {
    const auto getArray = [filter = this->Filter](vtkImageData* step)
    {
      int association = vtkDataObject::FIELD_ASSOCIATION_POINTS;
      vtkDataArray* const array = filter->GetInputArrayToProcess(0, step, association);
      return association == vtkDataObject::FIELD_ASSOCIATION_POINTS ? array : nullptr;
    };
    return { getArray, this->Filter->GetProperty()->GetComponent(),
      this->Filter->GetDisplacementArrayName() };
  }

  /**
   * Bakes like Bake() a part of the image with the isosurface in it. Nothing is updated. Null,
   * without an error, if the part can't be touched.
   */
  std::shared_ptr<const HapticModel> BakeRegion(const SurfaceRegion& part, double rate,
    const ForceCaps& deviceCaps, vtkMatrix4x4* deviceToWorld) const;

  /**
   * Bakes an image without changing it, for ticks of a period (s). Null, with the cure in `error`,
   * if it can't be touched.
   * @param recording the recording that is replayed, whose version decides where the material is
   * read; null if there is none
   */
  std::shared_ptr<const HapticModel> BakeImage(vtkImageData* image, double tickPeriod,
    const ForceCaps& deviceCaps, vtkMatrix4x4* deviceToWorld, std::string& error,
    vtkPolyData* recording, HapticFrames&& frames) const;

  /**
   * Returns null if Bake() needs no slow work that can be done in the background: the distances to
   * forbidden labels, a large mesh, and the points of a tool with a shape. Otherwise begins this
   * work, and returns a text for the status, such as MeshingWork.
   * @param isMoving whether BakeFrames() follows, whose frames may have meshes of their own
   */
  const char* Prepare(bool isMoving = false) const
  {
    return this->Filter->Preparation->Prepare(isMoving);
  }
  /** Ends the work that Prepare() began. */
  void EndPreparing() const { this->Filter->Preparation->EndPreparing(); }
  /** Whether walls between the labels on port 3 are felt, if there are labels. */
  bool HasLabelWalls() const;
  /** Whether the scalars of an image on port 0 are felt as labels, if they can be labels. */
  bool AreLabels(vtkImageData* image) const;

  /**
   * Estimates how long (s) Bake() would take now on a desktop computer, without the pipeline before
   * the filter. Only the mesh of SURFACE_PROXY counts; 0 if it is up to date.
   */
  double EstimateTime() const { return this->Filter->Preparation->EstimateTime(); }

  /** Whether port 0 has a grid, which is resampled around the tip. */
  bool IsResampled() const;
  /** Warns once that only the first time step of a grid is felt. */
  void WarnOfStillSteps() const;
  /**
   * Warns, once for a series of frames, if their edges are too fast for blending.
   * @param isLoop whether the first frame follows the last one
   */
  void WarnOfFastMotion(const BakedVolume& volume, bool isLoop) const;

  /** Returns the arrays of HashScalars() and HashLabels(), each null if it is missing. */
  std::array<TouchedArray, 2> GetTouched() const;
  /**
   * Returns the array of HashScalars() with its outside samples filled: see
   * BakePreparation::FillOutside().
   */
  TouchedArray GetFilled() const
  {
    return this->GetFilled(this->Filter->GetProperty()->GetComponent(), false);
  }
  TouchedArray GetFilled(int component, bool areFrames) const;
  /** Returns what was outside in the array that was filled last. */
  const OutsideSamples& GetOutside() const
  {
    return this->Filter->Preparation->GetOutside().GetLast();
  }

private:
  /** Bakes like Bake(), and reports the filter's errors. */
  std::shared_ptr<const HapticModel> BakeOrTell(double rate, const ForceCaps& deviceCaps,
    vtkMatrix4x4* deviceToWorld, HapticFrames&& frames) const;
  std::shared_ptr<const HapticModel> BakeInput(double rate, const ForceCaps& deviceCaps,
    vtkMatrix4x4* deviceToWorld, HapticFrames&& frames) const;
  /** Bakes the labels, if there are any, for a recording (or null); false after an error. */
  bool BakeLabels(
    vtkPolyData* recording, std::shared_ptr<const BakedLabels>& labels, std::string& error) const;
  bool ReadPlacement(vtkMatrix4x4* deviceToWorld, Affine3& placement, std::string& error) const;

  vtkVolumeHapticsFilter* const Filter;
};

} // namespace VolumeHaptics

#endif
