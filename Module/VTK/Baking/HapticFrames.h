// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The time steps of a volume that moves.
 */
#ifndef HapticFrames_h
#define HapticFrames_h

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

/** The volume at a time step. */
struct HapticFrame
{
  double Time;                         ///< in the source's units
  vtkSmartPointer<vtkImageData> Image; ///< its geometry and field data
  vtkSmartPointer<vtkDataArray> Array; ///< null if there is none at this time
  /** vtkFloatArray or vtkDoubleArray of its points; null if there is none at this time. */
  vtkSmartPointer<vtkDataArray> Displacements;
  int Component = 0; ///< of Array
  /** Its isosurface on the way to the next frame; null if the builder of models is to make it. */
  std::shared_ptr<const SurfaceMesh> Mesh = {};
};

/** Some frames of a series; none if the volume does not move. */
struct HapticFrames
{
  std::vector<HapticFrame> Frames;
  FrameSeries Series;
};

/** The time steps of an input, ascending; empty if it has less than two. */
std::vector<double> ReadTimeSteps(vtkInformation* input);

/** The series of time steps, two at least. */
FrameSeries MakeSeries(const std::vector<double>& steps);

/** The point array of an image that is touched; null if there is none. */
using TouchedArrayOf = std::function<vtkDataArray*(vtkImageData*)>;

/** The arrays of a time step that are read. */
struct FrameReading
{
  TouchedArrayOf GetArray;
  int Component;             ///< of that array
  std::string Displacements; ///< the name of their array; empty if there are none
};

/**
 * Requests a time step from the source of a filter's input port 0, and copies the array that is
 * touched: a source may write each step to the same memory, but a vtkHapticFrameSource does not.
 * False if the source fails.
 */
bool ReadFrame(vtkAlgorithm* filter, double step, const FrameReading& reading, HapticFrame& frame);

/**
 * Requests the time steps from the first one to that at or after `last` from the source of a
 * filter's input port 0, and copies the array that is touched: a source may write each step to the
 * same memory. The source stays at the first step. Empty if the source fails.
 */
std::vector<HapticFrame> CollectFrames(
  vtkAlgorithm* filter, const std::vector<double>& steps, double last, const FrameReading& reading);

/** The components of an array as frames, `spacing` apart from data time 0 on. Nothing is copied. */
std::vector<HapticFrame> MakeComponentFrames(
  vtkImageData* image, vtkDataArray* array, double spacing);

/**
 * Gives a frame of a model the displacements of a time step. False, with the reason and the cure in
 * `error`, if they are missing or no displacements of the frame's points.
 * @param name of the array
 */
bool ReadDisplacements(
  const HapticFrame& step, const std::string& name, VolumeFrame& frame, std::string& error);

/**
 * Warns of frames whose edges move by more than twice their width until the next frame, in a text
 * that names the cures; empty if there are none.
 * @param pairs the frames to look at, by their numbers; each takes some milliseconds
 * @param noise of the samples, their standard deviation
 */
std::string DescribeFastMotion(
  const BakedVolume& volume, const std::vector<std::size_t>& pairs, double noise);

} // namespace VolumeHaptics

#endif
