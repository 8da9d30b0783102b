// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Meshes frames of a volume that moves in the background, for SURFACE_PROXY.
 */
#ifndef FrameMesher_h
#define FrameMesher_h

#include "Core/Model/HapticModelDescription.h"
#include "VTK/Base/BackgroundWork.h"

#include <memory>
#include <tuple>
#include <vector>

namespace VolumeHaptics
{

/** Meshes frames on a worker. Call it from the owner's thread. */
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
