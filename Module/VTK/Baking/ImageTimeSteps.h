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

/** A time step of the volume. */
struct ImageTimeStep
{
  double Time;                         ///< time of the step (the source's units)
  vtkSmartPointer<vtkImageData> Image; ///< geometry and field data
  vtkSmartPointer<vtkDataArray> Array; ///< null if the source has no array at this time
  /**
   * Displacements of the points, a vtkFloatArray or vtkDoubleArray; null if there are none at this
   * time.
   */
  vtkSmartPointer<vtkDataArray> Displacements;
  int Component = 0; ///< component of Array that is touched
  /** Isosurface with its motion to the next time step; null if the model builder has to make it. */
  std::shared_ptr<const SurfaceMesh> Mesh = {};
};

/** Some time steps of a series; empty if the volume does not move. */
struct ImageTimeSteps
{
  std::vector<ImageTimeStep> TimeSteps;
  TimeStepSeries Series;
};

/** Reads the time steps of an input, ascending; empty if there are fewer than two. */
std::vector<double> ReadTimeSteps(vtkInformation* input);

/** Makes the series of at least two time steps. */
TimeStepSeries MakeSeries(const std::vector<double>& steps);

/** Returns the point array of an image that is touched; null if there is none. */
using TouchedArrayOf = std::function<vtkDataArray*(vtkImageData*)>;

/** Describes which arrays of a time step are read. */
struct TimeStepReading
{
  TouchedArrayOf GetArray;
  int Component;             ///< component of the touched array
  std::string Displacements; ///< name of the displacements' array; empty if there are none
};

/**
 * Requests a time step from the source of a filter's input port 0. Copies the array that is
 * touched, because a source may write each step to the same memory; the array of a
 * vtkHapticTimeStepSource is not copied. Returns false if the source fails.
 */
bool ReadTimeStep(
  vtkAlgorithm* filter, double step, const TimeStepReading& reading, ImageTimeStep& timeStep);

/**
 * Requests time steps from the source of a filter's input port 0: from the first one to the first
 * one at or after `last`. Copies the array that is touched, because a source may write each step to
 * the same memory. The source is left at the first step. Returns no time steps if the source fails.
 */
std::vector<ImageTimeStep> CollectTimeSteps(vtkAlgorithm* filter, const std::vector<double>& steps,
  double last, const TimeStepReading& reading);

/**
 * Returns an array's components as time steps at data times 0, `spacing`, and so on. Copies
 * nothing.
 */
std::vector<ImageTimeStep> MakeComponentTimeSteps(
  vtkImageData* image, vtkDataArray* array, double spacing);

/**
 * Sets the displacements of a model's time step to those of an image's time step. Returns false,
 * with the reason and the cure in `error`, if they are missing or do not fit the time step's
 * points.
 * @param name name of the array
 */
bool ReadDisplacements(
  const ImageTimeStep& step, const std::string& name, VolumeTimeStep& timeStep, std::string& error);

/**
 * Returns a warning if the edges of time steps move by more than twice their width until the next
 * time step. The text names the cures; it is empty if no edge does.
 */
std::string DescribeFastMotion(
  const BakedVolume& volume, const std::vector<std::size_t>& pairs, double noise);

} // namespace VolumeHaptics

#endif
