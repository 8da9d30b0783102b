// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The frames of a volume that moves, as images, and as meshes for SURFACE_PROXY.
 */
#ifndef FrameMesher_h
#define FrameMesher_h

#include "Core/Model/HapticModelDescription.h"
#include "VTK/Baking/HapticFrames.h"
#include "VTK/Base/BackgroundWork.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkSmartPointer.h"

#include <memory>
#include <tuple>
#include <vector>

namespace VolumeHaptics
{

/** The frame of a moving volume that is shown, as an image. */
class FrameImage
{
public:
  /**
   * Makes an image of a frame's array, with the shape of another image. The samples are copied only
   * if the frames are components of one array with several components. Returns the last image again
   * if the frame is unchanged.
   */
  vtkImageData* Show(const HapticFrame& frame, bool isComponent, vtkImageData* shape);
  void Clear();
  /** Returns the array of the frame; null without one. */
  vtkDataArray* GetArray() const { return this->Array; }

private:
  vtkSmartPointer<vtkImageData> Image;
  vtkSmartPointer<vtkDataArray> Array; ///< array that is shown
  vtkMTimeType Changed = 0;            ///< change time of Array
  int Component = 0;
};

/** Meshes frames in the background. Call it from the owner's thread. */
class FrameMesher
{
public:
  /**
   * Gives all frames but the last one the meshes that they lack; a single frame gets a mesh that
   * does not move. Call this often: false until the frames have their meshes.
   * @param components components of the frames' arrays, one for each frame
   * @param value value of the isosurface
   */
  bool Follow(std::vector<VolumeFrame>& frames, const std::vector<int>& components, double value,
    const Affine3& indexToWorld);
  /** Ends the work that is under way, without waiting for it. */
  void End() { this->Meshing.Abandon(); }
  /** Whether no worker holds frames any more. Call it when no frames wait for their meshes. */
  bool IsIdle()
  {
    if (this->Meshing.IsUnderWay())
    {
      return false;
    }
    this->Meshing.Forget();
    return true;
  }

private:
  /** The samples of a frame and of the next frame, and the component of the frame. */
  using Key = std::tuple<const void*, const void*, int>;

  KeyedWork<Key, std::shared_ptr<const SurfaceMesh>> Meshing;
};

} // namespace VolumeHaptics

#endif
