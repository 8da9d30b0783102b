// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The state of HapticMethod::LocalSurface from tick to tick. In world units.
 */
#ifndef LocalState_h
#define LocalState_h

#include "Core/Math/Quadric.h"

#include <cstdint>

namespace VolumeHaptics
{

/** The plane or quadric that stands in for the isosurface near the proxy, if there is one. */
struct LocalSurface
{
  bool IsThere = false;
  Quadric Shape;
};

/** The next search of the slow loop, see LocalSurfaceFit.h. */
struct LocalSurfaceRequest
{
  Vector3 Position;      ///< the proxy's position
  Vector3 Ahead;         ///< the farthest motion of the tip until the result is replaced
  Vector3 Normal;        ///< the normal of the known surface, into the structure; 0 if there is
                         ///< none
  double DataTime = 0.0; ///< data time, if the volume moves
};

/** The state that LOCAL_SURFACE carries from tick to tick. */
struct LocalState
{
  LocalSurface Surface;
  Vector3 Position;         ///< the position of the proxy, on the surface
  bool IsHeld = false;      ///< whether the surface holds the proxy, and Position is valid
  Vector3 Tip;              ///< the tip after the last tick
  Vector3 Fading;           ///< the felt lag is Position - Tip + Fading; fades to 0
  double Fall = 0.0;        ///< the amount by which Fading gets shorter in a tick
  std::uint32_t Age = 0;    ///< ticks since the request
  std::uint32_t Number = 0; ///< number of the request
  LocalSurfaceRequest Request;
};

} // namespace VolumeHaptics

#endif
