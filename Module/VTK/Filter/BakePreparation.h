// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Prepares the slow parts of a bake in the background.
 */
#ifndef BakePreparation_h
#define BakePreparation_h

#include "VTK/Baking/HapticLabels.h"
#include "VTK/Baking/HapticSurface.h"
#include "VTK/Base/OutsideFiller.h"
#include "VTK/Tools/ShellPoints.h"

#include <string>
#include <utility>

class vtkVolumeHapticsFilter;

namespace VolumeHaptics
{

/** Result of Prepare() while a mesh is being made. */
inline constexpr char MeshingWork[] = "the surface is meshed";

/**
 * Prepares in the background what a filter needs to bake: the mesh of SURFACE_PROXY, the distances
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
   * Returns a copy of the array whose outside samples are filled. Returns the array itself if
   * nothing is outside, or if it contains vectors or labels.
   * @param areTimeSteps whether the components of the array are time steps
   */
  vtkSmartPointer<vtkDataArray> FillOutside(
    vtkImageData* image, vtkDataArray* scalars, int component, bool areTimeSteps);

  /**
   * Records the text on what was guessed about the values. Returns whether there is one and it
   * differs from the last one.
   */
  bool IsNewGuess(const std::string& guess)
  {
    return std::exchange(this->Guess, guess) != guess && !guess.empty();
  }

  /**
   * Returns null if HapticBaker::Bake() needs no slow work that can be done in the background: the
   * distances to forbidden labels, a large mesh, and the points of a tool with a shape. Otherwise
   * begins this work, and returns a text for the status, such as MeshingWork.
   * @param isMoving whether BakeTimeSteps() follows, whose time steps may have meshes of their own
   */
  const char* Prepare(bool isMoving = false);
  /** Ends the work that Prepare() began. */
  void EndPreparing();

  /**
   * Whether baking needs no slow meshing. If it does, begins to make the mesh in the background.
   */
  bool IsSurfaceAtHand();
  /** Waits for the mesh of IsSurfaceAtHand(). Returns false if the user aborts the wait. */
  bool AwaitSurface();
  /**
   * Estimates how long (s) HapticBaker::Bake() would take now on a desktop computer, without the
   * pipeline before the filter. Only the mesh of SURFACE_PROXY counts; 0 if it is up to date.
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

} // namespace VolumeHaptics

#endif
