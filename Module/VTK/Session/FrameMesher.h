// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Meshes frames of a volume that moves in the background, for SURFACE_PROXY.
 */
#ifndef FrameMesher_h
#define FrameMesher_h

#include "Core/Model/BakedVolume.h"
#include "VTK/Work/BackgroundWork.h"

#include <array>
#include <memory>
#include <vector>

namespace VolumeHaptics
{

/** For the owner's thread. */
class FrameMesher
{
public:
  /**
   * To be called often: gives frames of a volume the meshes that they lack. False until they have
   * them all. Of other methods than SURFACE_PROXY they need none.
   * @param component of the arrays
   */
  bool Follow(const BakedVolume& volume, int component, std::vector<VolumeFrame>& frames);
  /** Ends what is under way, without waiting for it. */
  void End() { this->Meshing.Abandon(); }

private:
  /** The samples of a frame and the next one. */
  using Key = std::array<const void*, 2>;

  KeyedWork<Key, std::shared_ptr<const SurfaceMesh>> Meshing;
};

} // namespace VolumeHaptics

#endif
