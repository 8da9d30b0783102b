// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The parts of a bake that take long.
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

/** What Prepare() returns while a mesh is made. */
inline constexpr char MeshingWork[] = "the surface is meshed";

/**
 * The mesh of SURFACE_PROXY, the distances to forbidden labels, the finer grid of labels with thick
 * slices, and the points of a tool with a shape, which can be made in the background before a
 * filter bakes.
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
   * The array in which samples outside have a value, or the array itself: vectors and labels are
   * read as they are.
   * @param areFrames whether the components of the array are frames
   */
  vtkSmartPointer<vtkDataArray> FillOutside(
    vtkImageData* image, vtkDataArray* scalars, int component, bool areFrames);

  /** Whether a text on what was guessed about the values is there, and is not that told last. */
  bool IsNewGuess(const std::string& guess)
  {
    return std::exchange(this->Guess, guess) != guess && !guess.empty();
  }

  /** See HapticBaker::Prepare(). */
  const char* Prepare(bool isMoving);
  /** See HapticBaker::EndPreparing(). */
  void EndPreparing();

  /** Whether baking makes no mesh that takes long; if it does, that is begun in the background. */
  bool IsSurfaceAtHand();
  /** Waits for such a mesh; false if the user aborts that. */
  bool AwaitSurface();
  /** See HapticBaker::EstimateTime(). */
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
