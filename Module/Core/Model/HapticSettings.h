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
  Proxy,        ///< the paper's section 3
  ForceField,   ///< the paper's eq. 1
  SurfaceProxy, ///< a sphere on the triangles of a mesh; see SurfaceProxy.h
  LocalSurface, ///< a plane or quadric that a slow loop renews; see LocalSurfaceSolver.h
  Primitives    ///< modes for vectors, tensors, ridges and guides; see PrimitivesMethod.h
};

/** How Proxy advances the proxy in a tick. */
enum class HapticSolver : std::uint8_t
{
  Paper,  ///< as published, with one gradient a tick
  Precise ///< the same law, in balance at the proxy's end point; see PreciseSolver.h
};

/** The point at which a surface begins to hold; for HapticSolver::Precise. */
enum class ContactAlignment : std::uint8_t
{
  Distinctness, ///< by W_d and T_N alone
  Edge          ///< only from V(x_p) >= (V(x_s) + V(x_v))/2 on
};

/** The image whose surfaces are felt; for HapticMethod::Proxy. */
enum class SurfaceGeometry : std::uint8_t
{
  Scalars,
  Labels, ///< only walls between labels; see LabelWalls.h
  Both    ///< walls between labels where the scalars have no distinct surface
};

/** The value that determines a surface's material; for HapticSolver::Precise. */
enum class MaterialPlacement : std::uint8_t
{
  Kernel, ///< V(x_s) and V(x_v), a kernel radius to either side of the proxy
  FarSide ///< the values of the plateaus on either side of the edge; see FarSide.h
};

/** The shape that stands in for the surface near the proxy; for HapticMethod::LocalSurface. */
enum class LocalSurfaceShape : std::uint8_t
{
  Plane,
  Quadric
};

/**
 * The side of a surface on which its structure lies: the side of higher values, the side of lower
 * values, or either.
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
  SurfaceGeometry Geometry = SurfaceGeometry::Scalars; ///< Scalars without labels
  MaterialPlacement Placement = MaterialPlacement::FarSide;
  SurfaceSide Side = SurfaceSide::Higher;
  bool SameShape = false;           ///< one stiffness for all materials that have any
  double ReleaseTime = 0.005;       ///< s, duration of a leap of Precise with FarSide; 0: at once
  double CouplingStiffness = 500.0; ///< N/m, with SameShape and for Primitives
  double TickPeriod = 1e-3;         ///< s
  double TimeUnitsPerSecond = 1.0;  ///< data time that passes in a second of the hand
  ForceCaps Caps;                   ///< the user's; the device has its own: HapticModel::Caps
  double MaximumForce = 0.0;        ///< N on the hand; 0: no limit
  double ForceFieldGain = 0.0;      ///< C1 of eq. 1, N per (scalar per world unit)
  double ForceFieldDamping = 0.0;   ///< C2 of eq. 1, N s/m
  double IsoValue = 0.0;            ///< value of the surface of SurfaceProxy and LocalSurface
  bool HasIsoSurface = false;       ///< whether the mesh is the isosurface at IsoValue
  double ProxyRadius = 0.5;         ///< world units, more than 0; for SurfaceProxy
  bool ForceShading = true;         ///< for SurfaceProxy, if the mesh has normals
  double LocalSurfaceRate = 60.0;   ///< Hz, the slow loop of LocalSurface
  double RecoveryTime = 0.015;      ///< s, from one surface to the next, for LocalSurface
  LocalSurfaceShape LocalShape = LocalSurfaceShape::Plane;
};

} // namespace VolumeHaptics

#endif
