// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The state of HapticMethod::LocalSurface from tick to tick, in world units.
 */
#ifndef LocalState_h
#define LocalState_h

#include "Core/Math/Quadric.h"

#include <cstdint>

namespace VolumeHaptics
{

/** The plane or quadric that replaces the isosurface near the proxy, if there is one. */
struct LocalSurface
{
  bool IsThere = false;
  Quadric Shape;
};

/** A request for the next search of the slow loop (LocalSurfaceFit.h). */
struct LocalSurfaceRequest
{
  Vector3 Position; ///< position of the proxy
  Vector3 Ahead;    ///< farthest tip until the result replaces the surface
  Vector3 Normal;   ///< normal of the known surface, into the structure; 0 if there is no surface
  double DataTime = 0.0; ///< data time, if the volume moves
};

/** The state that the method LocalSurface passes from tick to tick. */
struct LocalState
{
  LocalSurface Surface;
  Vector3 Position;    ///< position of the proxy on the surface
  bool IsHeld = false; ///< whether the surface holds the proxy, so that Position is valid
  Vector3 Tip;         ///< position of the tip after the last tick
  /**
   * Remainder of the lag before a change. It fades to 0. The felt lag is Position - Tip + Fading.
   */
  Vector3 Fading;
  double Fall = 0.0;        ///< length by which Fading decreases in a tick
  std::uint32_t Age = 0;    ///< number of ticks since the request
  std::uint32_t Number = 0; ///< number of the request
  LocalSurfaceRequest Request;
};

} // namespace VolumeHaptics

#endif
