// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The tool in the hand, baked for the servo tick.
 *
 * Without one, the hand feels with a point. A kind of tool has a value of ToolKind, its description
 * in ToolDescription, and its code in Core/Tools. What passes from tick to tick is in ServoState,
 * and in ToolMemory if its size depends on the tool.
 */
#ifndef BakedTool_h
#define BakedTool_h

#include "Core/Math/PiecewiseTable.h"
#include "Core/Model/BakedBurr.h"
#include "Core/Model/PointShell.h"

#include <cstdint>
#include <memory>

namespace VolumeHaptics
{

enum class ToolKind : std::uint8_t
{
  Point,  ///< none: the method's own point
  Needle, ///< see Core/Tools/Needle/NeedleTool.h
  Shell,  ///< see Core/Tools/ShellTool.h
  Burr    ///< see Core/Tools/BurrInServo.h
};

/** How a needle feels by the value of the scalars, where no label gives a material. */
struct NeedleDescription
{
  Polyline ShaftFriction = ConstantPolyline(0.0); ///< tau, N per metre of the shaft
  Polyline CuttingForce = ConstantPolyline(0.0);  ///< R, N
  bool HasCuttingForce = false;                   ///< if false, R is the material's viscosity
  double LateralStrength = 1.0;                   ///< s_l, N
};

/** A tool with a shape, and how it is felt. */
struct ShellDescription
{
  std::shared_ptr<const PointShell> Points; ///< in world units; not null
  /**
   * Settings of the shell, except its contact area, which is in square world units here, and its
   * scale, which is not used.
   */
  ShellSettings Touch;
};

/** Everything that a tool is baked from. */
struct ToolDescription
{
  ToolKind Kind = ToolKind::Point;
  NeedleDescription Needle; ///< for Needle
  ShellDescription Shell;   ///< for Shell, and the head of a Burr
  BurrDescription Burr;     ///< for Burr
};

/** A tool as a tick reads it. Immutable. */
struct BakedTool
{
  explicit BakedTool(const ToolDescription& description)
    : Kind(description.Kind)
    , NeedleForces({ description.Needle.ShaftFriction, description.Needle.CuttingForce })
    , HasCuttingForce(description.Needle.HasCuttingForce)
    , LateralStrength(description.Needle.LateralStrength)
    , Shell(description.Shell.Points)
    , ShellTouch(description.Shell.Touch)
    , Burr(description.Kind == ToolKind::Burr ? std::make_shared<const BakedBurr>(description.Burr)
                                              : nullptr)
  {
  }

  const ToolKind Kind;
  ///@{
  /** For a needle: see NeedleDescription. */
  const PiecewiseTable<2> NeedleForces; ///< channels tau, R
  const bool HasCuttingForce;
  const double LateralStrength;
  ///@}
  ///@{
  /** For a tool with a shape: see ShellDescription. */
  const std::shared_ptr<const PointShell> Shell;
  const ShellSettings ShellTouch;
  ///@}
  const std::shared_ptr<const BakedBurr> Burr; ///< null for other tools
};

} // namespace VolumeHaptics

#endif
