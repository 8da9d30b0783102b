// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Reads the time steps of a moving volume.
 */
#ifndef ImageTimeSteps_h
#define ImageTimeSteps_h

#include "Core/Model/HapticModelDescription.h"

#include "vtkSmartPointer.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

class vtkAlgorithm;
class vtkDataArray;
class vtkImageData;
class vtkInformation;

namespace VolumeHaptics
{
class SurfaceMesh;
struct BakedVolume;

/** One time step of the volume. */
struct ImageTimeStep
{
  double Time;                         ///< time of the step (the source's units)
  vtkSmartPointer<vtkImageData> Image; ///< geometry and field data
  vtkSmartPointer<vtkDataArray> Array; ///< touched array; null if the source has none at this time
  /**
   * Displacements of the points, a vtkFloatArray or vtkDoubleArray; null if the source has none at
   * this time.
   */
  vtkSmartPointer<vtkDataArray> Displacements;
  int Component = 0; ///< touched component of Array
  /**
   * Isosurface with its motion to the next time step; null if the model builder still has to make
   * it.
   */
  std::shared_ptr<const SurfaceMesh> Mesh = {};
};

/** Consecutive time steps of a series; empty if the volume does not move. */
struct ImageTimeSteps
{
  std::vector<ImageTimeStep> TimeSteps;
  TimeStepSeries Series;
};

/** Reads the times that an input offers, ascending; empty if there are fewer than two. */
std::vector<double> ReadTimeSteps(vtkInformation* input);

/** Makes the series for the times of at least two time steps. */
TimeStepSeries MakeSeries(const std::vector<double>& steps);

/** Function that returns the touched point array of an image; null if there is none. */
using TouchedArrayOf = std::function<vtkDataArray*(vtkImageData*)>;

/** Selects the arrays of a time step to read. */
struct TimeStepReading
{
  TouchedArrayOf GetArray;
  int Component;             ///< component of the touched array
  std::string Displacements; ///< name of the displacement array; empty if there is none
};

/**
 * Requests a time step from the source of a filter's input port 0. Copies the touched array,
 * because a source may write each step to the same memory; arrays of a vtkHapticTimeStepSource are
 * shared instead. Returns false if the source fails.
 */
bool ReadTimeStep(
  vtkAlgorithm* filter, double step, const TimeStepReading& reading, ImageTimeStep& timeStep);

/**
 * Requests time steps from the source of a filter's input port 0: from the first of `steps` to the
 * first one at or after `last`. Copies the touched array, because a source may write each step to
 * the same memory. Finally requests the first step again. Returns no time steps if the source
 * fails.
 */
std::vector<ImageTimeStep> CollectTimeSteps(vtkAlgorithm* filter, const std::vector<double>& steps,
  double last, const TimeStepReading& reading);

/**
 * Returns an array's components as time steps at data times 0, `spacing`, 2 * `spacing`, and so on,
 * without a copy.
 */
std::vector<ImageTimeStep> MakeComponentTimeSteps(
  vtkImageData* image, vtkDataArray* array, double spacing);

/**
 * Copies the displacements of an image's time step to a model's time step. Returns false, with the
 * reason and the cure in `error`, if they are missing or do not fit the time step's points.
 * @param name name of the displacement array, for errors
 */
bool ReadDisplacements(
  const ImageTimeStep& step, const std::string& name, VolumeTimeStep& timeStep, std::string& error);

/**
 * Returns a warning, with the cures, if edges move by more than twice their width between two time
 * steps; empty otherwise.
 */
std::string DescribeFastMotion(
  const BakedVolume& volume, const std::vector<std::size_t>& pairs, double noise);

} // namespace VolumeHaptics

#endif
