// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The tool in the hand, baked for the servo tick.
 *
 * Without one, the hand feels with a point. A kind of tool has a value of ToolKind, its description
 * in ToolDescription, and its code in Core/Tools. What passes from tick to tick is in ServoState.
 */
#ifndef BakedTool_h
#define BakedTool_h

#include "Core/Math/PiecewiseTable.h"

#include <cstdint>

namespace VolumeHaptics
{

enum class ToolKind : std::uint8_t
{
  Point, ///< none: the method's own point
  Needle ///< see Core/Tools/NeedleTool.h
};

/** What a needle feels by the value of the scalars, where a label does not say it. */
struct NeedleDescription
{
  Polyline ShaftFriction = ConstantPolyline(0.0); ///< tau, N per metre of the shaft
  Polyline CuttingForce = ConstantPolyline(0.0);  ///< R, N
  bool HasCuttingForce = false;                   ///< if not, R is the material's viscosity
  double LateralStrength = 1.0;                   ///< s_l, N
};

/** Everything that a tool is baked from. */
struct ToolDescription
{
  ToolKind Kind = ToolKind::Point;
  NeedleDescription Needle; ///< of that kind
};

/** A tool as a tick reads it. Immutable. */
struct BakedTool
{
  explicit BakedTool(const ToolDescription& description)
    : Kind(description.Kind)
    , NeedleForces({ description.Needle.ShaftFriction, description.Needle.CuttingForce })
    , HasCuttingForce(description.Needle.HasCuttingForce)
    , LateralStrength(description.Needle.LateralStrength)
  {
  }

  const ToolKind Kind;
  ///@{
  /** Of a needle: see NeedleDescription. */
  const PiecewiseTable<2> NeedleForces; ///< channels tau, R
  const bool HasCuttingForce;
  const double LateralStrength;
  ///@}
};

} // namespace VolumeHaptics

#endif
