// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Bakes models from a vtkVolumeHapticsFilter and its inputs, and computes the slow parts in the
 * background.
 */
#ifndef HapticBaker_h
#define HapticBaker_h

#include "Core/Model/ForceCaps.h"
#include "VTK/Baking/HapticLabels.h"
#include "VTK/Baking/HapticSurface.h"
#include "VTK/Baking/ImageTimeSteps.h"
#include "VTK/Base/OutsideFiller.h"
#include "VTK/Base/TouchedArray.h"
#include "VTK/Filter/FilterTimeSteps.h"
#include "VTK/Filter/RegionSeries.h"
#include "VTK/Tools/ShellPoints.h"
#include "vtkVolumeHapticsFilter.h"
#include "vtkVolumeHapticsModule.h" // for export macro

#include "vtkDataArray.h"
#include "vtkHapticProperty.h"
#include "vtkImageData.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <array>
#include <memory>
#include <new>
#include <string>
#include <utility>
#include <vector>

class vtkAlgorithm;
class vtkDataObject;
class vtkHapticRegionSource;

namespace VolumeHaptics
{

/** Thrown if the source of the input port number Port runs out of memory. */
struct SourceLacksMemory : std::bad_alloc
{
  explicit SourceLacksMemory(int port)
    : Port(port)
  {
  }
  const int Port;
};

/**
 * Updates the sources of the image, the surface and the labels. Returns false if one of them
 * failed. Throws SourceLacksMemory.
 */
bool UpdateSources(vtkAlgorithm* filter);

/** Text to append to a bake's error after UpdateSources() returned false. */
inline constexpr char FailedSource[] =
  // VTK's executive never runs a source again that threw, because it considers it to be still
  // running.
  " A source of this filter failed: see its errors. If memory ran out in it before, VTK can't run "
  "it again: connect a new source.";

/**
 * Returns the error, with the cure, for running out of memory while an image is baked. `image` is
 * null if it is unknown.
 */
std::string DescribeLackOfMemory(vtkImageData* image);

/** Result of Prepare() while a mesh is being made, for the status text. */
inline constexpr char MeshingWork[] = "the surface is meshed";

/**
 * Computes in the background what a filter needs to bake: the mesh of SURFACE_PROXY, the distances
 * to forbidden labels, the finer grid of labels with thick slices, and the points of a tool with a
 * shape.
 */
class BakePreparation
{
public:
  explicit BakePreparation(vtkVolumeHapticsFilter* filter)
    : Filter(filter)
  {
  }

  HapticSurface& GetSurfaces() { return this->Surfaces; }
  HapticLabels& GetLabels() { return this->Labels; }
  OutsideFiller& GetOutside() { return this->Outside; }

  /**
   * Returns a copy of the array with its outside samples filled. Returns the array itself if
   * nothing is outside, or if it contains vectors or labels.
   * @param areTimeSteps whether the components of the array are time steps
   */
  vtkSmartPointer<vtkDataArray> FillOutside(
    vtkImageData* image, vtkDataArray* scalars, int component, bool areTimeSteps);

  /** Stores the note on guesses about the values. Returns whether the note is new and not empty. */
  bool IsNewGuess(const std::string& guess)
  {
    return std::exchange(this->Guess, guess) != guess && !guess.empty();
  }

  /**
   * Returns null if HapticBaker::Bake() would be quick now. Otherwise starts its slow parts in the
   * background and returns a text for the status, such as MeshingWork. The slow parts are the
   * distances to forbidden labels, the finer grid of labels with thick slices, a large mesh, and
   * the points of a tool with a shape.
   * @param isMoving whether BakeTimeSteps() follows, whose time steps may have their own meshes
   */
  const char* Prepare(bool isMoving = false);
  /** Stops the background work of Prepare(). */
  void EndPreparing();

  /**
   * Returns whether baking needs no slow meshing. If it does, starts to make the mesh in the
   * background.
   */
  bool IsSurfaceAtHand();
  /** Waits for the mesh of IsSurfaceAtHand(). Returns false if the user aborts. */
  bool AwaitSurface();
  /**
   * Estimates the time (s) that HapticBaker::Bake() would take now on a desktop computer, without
   * the pipeline before the filter. Includes only the mesh of SURFACE_PROXY; 0 if it is up to date.
   */
  double EstimateTime();

private:
  const char* PrepareLabels();
  bool PrepareSurface();
  bool PrepareTool();

  vtkVolumeHapticsFilter* const Filter;
  HapticSurface Surfaces;
  HapticLabels Labels;
  OutsideFiller Outside;
  ShellPreparation Shells;
  std::string Guess;
};

/** Caches the resampled regions of a data set until the data or the arrays change. */
class ResampledInput
{
public:
  /**
   * Returns the source that resamples these arrays of the data. Returns null if the data are an
   * image, which needs no resampling, or have no cells.
   */
  vtkHapticRegionSource* Find(vtkDataObject* data, std::vector<std::string>&& arrays);
  /** Explains, with the cure, why the data of the last Find() can't be touched. */
  std::string DescribeFault(vtkDataObject* data) const;
  /**
   * Returns the warning, with the cure, that only the first of these time steps is felt. Returns an
   * empty text if the warning was already returned for these time steps.
   */
  std::string DescribeStillSteps(vtkDataObject* data, const std::vector<double>& steps);

private:
  vtkSmartPointer<vtkHapticRegionSource> Source; ///< null if the data can't be resampled
  const void* Of = nullptr;
  vtkMTimeType Time = 0;
  std::vector<std::string> Arrays;
  std::string Error;
  std::vector<double> ToldSteps;
};

/**
 * Makes models from a filter and its inputs for code that computes ticks: the device, and the
 * search for a surface under the mouse. Each filter owns one, which caches results for later bakes.
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
   * Updates port 0 and bakes it, with the property and all settings, for a servo with a rate (Hz)
   * and the force caps of its device. The matrix maps the servo's device space (m) to the world;
   * nullptr stands for the world scaled by MetersPerWorldUnit. Returns null after an error.
   */
  std::shared_ptr<const HapticModel> Bake(
    double rate, const ForceCaps& deviceCaps, vtkMatrix4x4* deviceToWorld)
  {
    return this->BakeOrTell(rate, deviceCaps, deviceToWorld, {});
  }

  /**
   * Bakes time steps of a moving volume, like Bake(). The volume's source must be at the first of
   * these time steps.
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

  /** Returns which arrays of a time step are to be read. */
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
   * Bakes only a part of the image, with the isosurface in it, like Bake(). Updates nothing.
   * Returns null, without an error, if the part can't be touched.
   */
  std::shared_ptr<const HapticModel> BakeRegion(const SurfaceRegion& part, double rate,
    const ForceCaps& deviceCaps, vtkMatrix4x4* deviceToWorld);

  /**
   * Bakes an image without changing it, for a tick period (s). Returns null, with the cure in
   * `error`, if it can't be touched.
   * @param recording the recording that is replayed, whose version decides where the material is
   * read; null if there is none
   */
  std::shared_ptr<const HapticModel> BakeImage(vtkImageData* image, double tickPeriod,
    const ForceCaps& deviceCaps, vtkMatrix4x4* deviceToWorld, std::string& error,
    vtkPolyData* recording, ImageTimeSteps&& timeSteps);

  /** Returns whether walls between the labels on port 3 are felt; false without labels. */
  bool HasLabelWalls();
  /**
   * Returns whether the scalars of an image on port 0 are felt as labels; false if they can't be
   * labels.
   */
  bool AreLabels(vtkImageData* image);

  /**
   * Returns whether the data on port 0 are a grid other than an image, which is resampled around
   * the tip.
   */
  bool IsResampled();
  /** Warns once if a grid has several time steps, because only the first one is felt. */
  void WarnOfStillSteps();
  /**
   * Warns once per series of time steps if edges move too fast for blending.
   * @param isLoop whether the first time step follows the last one
   */
  void WarnOfFastMotion(const BakedVolume& volume, bool isLoop);

  BakePreparation& GetPreparation() { return this->Preparation; }
  ResampledInput& GetResampled() { return this->Resampled; }

  /** Returns the arrays of HashScalars() and HashLabels(); null for a missing array. */
  std::array<TouchedArray, 2> GetTouched();
  /**
   * Returns the array of HashScalars(), with its outside samples filled: see
   * BakePreparation::FillOutside().
   */
  TouchedArray GetFilled()
  {
    return this->GetFilled(this->Filter->GetProperty()->GetComponent(), false);
  }
  TouchedArray GetFilled(int component, bool areTimeSteps);
  /** Returns which samples of the last filled array were outside. */
  const OutsideSamples& GetOutside() { return this->Preparation.GetOutside().GetLast(); }

private:
  vtkDataArray* GetArray(int index, vtkDataObject* data)
  {
    int association = vtkDataObject::FIELD_ASSOCIATION_POINTS;
    return this->Filter->GetChosenArray(index, data, association);
  }
  /** Bakes like Bake(), and reports errors through the filter. */
  std::shared_ptr<const HapticModel> BakeOrTell(double rate, const ForceCaps& deviceCaps,
    vtkMatrix4x4* deviceToWorld, ImageTimeSteps&& timeSteps);
  std::shared_ptr<const HapticModel> BakeInput(double rate, const ForceCaps& deviceCaps,
    vtkMatrix4x4* deviceToWorld, ImageTimeSteps&& timeSteps);
  /**
   * Bakes the labels on port 3, if there are any. `recording` may be null. Returns false after an
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
  std::weak_ptr<const BakedVolume> LastBaked; ///< last baked volume, reused while a model still
                                              ///< owns it
  vtkMTimeType LastBakedTime = 0;
};

} // namespace VolumeHaptics

#endif
