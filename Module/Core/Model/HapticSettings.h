// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The settings of a model: method, solver and limits.
 */
#ifndef HapticSettings_h
#define HapticSettings_h

#include "Core/Model/ForceCaps.h"

#include <cstdint>

namespace VolumeHaptics
{

enum class HapticMethod : std::uint8_t
{
  Proxy,        ///< the proxy of the paper's section 3
  ForceField,   ///< the force field of the paper's eq. 1
  SurfaceProxy, ///< a sphere on the triangles of a mesh (SurfaceProxy.h)
  LocalSurface, ///< a plane or quadric that a slow loop renews (LocalSurfaceSolver.h)
  Primitives    ///< modes for vectors, tensors, ridges and guides (PrimitivesMethod.h)
};

/** Ways to advance the proxy in a tick, for the method Proxy. */
enum class HapticSolver : std::uint8_t
{
  Paper,  ///< as published, with one gradient per tick
  Precise ///< the same law, but in balance at the proxy's end point (PreciseSolver.h)
};

/** Where a surface begins to hold, for HapticSolver::Precise. */
enum class ContactAlignment : std::uint8_t
{
  Distinctness, ///< where W_d and T_N are above 0
  Edge          ///< only where V(x_p) >= (V(x_s) + V(x_v))/2
};

/** The image whose surfaces are felt, for HapticMethod::Proxy. */
enum class SurfaceGeometry : std::uint8_t
{
  Scalars,
  Labels, ///< only walls between labels (LabelWalls.h)
  Both    ///< surfaces of the scalars and, where they are not distinct, walls between labels
};

/** Where the values are read that determine a surface's material, for HapticSolver::Precise. */
enum class MaterialPlacement : std::uint8_t
{
  Kernel, ///< V(x_s) and V(x_v), a kernel radius to either side of the proxy
  FarSide ///< values of the plateaus on both sides of the edge (FarSide.h)
};

/** The shape that replaces the surface near the proxy, for HapticMethod::LocalSurface. */
enum class LocalSurfaceShape : std::uint8_t
{
  Plane,
  Quadric
};

/**
 * The side of a surface on which its structure is: where values are higher, where they are lower,
 * or wherever the tip moves to.
 */
enum class SurfaceSide : std::uint8_t
{
  Higher,
  Lower,
  Both
};

/** Method, solver and limits of a model. */
struct HapticSettings
{
  HapticMethod Method = HapticMethod::Proxy;
  HapticSolver Solver = HapticSolver::Precise;
  ContactAlignment Alignment = ContactAlignment::Edge;
  SurfaceGeometry Geometry = SurfaceGeometry::Scalars; ///< must be Scalars without labels
  MaterialPlacement Placement = MaterialPlacement::FarSide;
  SurfaceSide Side = SurfaceSide::Higher;
  bool SameShape = false; ///< whether all materials that have any stiffness get the same one
  /**
   * Time (s) over which the force of a leap is spread, for Precise with FarSide; 0 for no
   * spreading.
   */
  double ReleaseTime = 0.005;
  double CouplingStiffness = 500.0; ///< N/m; for SameShape and for Primitives
  double TickPeriod = 1e-3;         ///< s
  double TimeUnitsPerSecond = 1.0;  ///< data time per second of the hand
  ForceCaps Caps;                   ///< the user's caps; HapticModel::Caps includes the device's
  double MaximumForce = 0.0;        ///< largest force (N) on the hand; 0 for no limit
  double ForceFieldGain = 0.0;      ///< C1 of eq. 1, N per (scalar per world unit)
  double ForceFieldDamping = 0.0;   ///< C2 of eq. 1, N s/m
  double IsoValue = 0.0;            ///< value at the surface of SurfaceProxy and LocalSurface
  bool HasIsoSurface = false;       ///< whether the mesh is the isosurface at IsoValue
  double ProxyRadius = 0.5;         ///< world units, more than 0, for SurfaceProxy
  /** Whether SurfaceProxy interpolates the mesh's normals, if it has any. */
  bool ForceShading = true;
  double LocalSurfaceRate = 60.0; ///< rate (Hz) of the slow loop of LocalSurface
  /** Time (s) over which LocalSurface changes from one surface to the next. */
  double RecoveryTime = 0.015;
  LocalSurfaceShape LocalShape = LocalSurfaceShape::Plane;
};

} // namespace VolumeHaptics

#endif
