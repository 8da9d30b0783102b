// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The settings of vtkHapticRepresentation, one row each: see HapticSetting.h.
 */
#ifndef HapticRepresentationSettings_h
#define HapticRepresentationSettings_h

#include "VTK/Base/HapticSetting.h"

#include "vtkHapticRepresentation.h"

namespace VolumeHaptics
{

using RepresentationSetting = HapticSetting<vtkHapticRepresentation>;

namespace RepresentationSettingRows
{
using Owner = vtkHapticRepresentation;

inline constexpr RepresentationSetting All[] = {
  HapticNumberMacro(Radius, 1e-9, VTK_DOUBLE_MAX, 1.5, "", NotBaked,
    "Radius of the proxy, world units. Default 1.5; the rest is in proportion."),
  HapticNumberMacro(ForceScale, 1e-9, VTK_DOUBLE_MAX, 0.1, "N per world unit", NotBaked,
    "Newtons per world unit of the arrows. Default 0.1: 1 N is 10 world units long."),
  HapticNumberMacro(MaximumArrowLength, 0.0, VTK_DOUBLE_MAX, 0.0, "", NotBaked,
    "The longest arrow, world units, 0 or more. Default 0: 30 times Radius."),
  HapticFlagMacro(SpringVisibility, true, NotBaked,
    "Whether the spring between proxy and tip is shown. Default on."),
  HapticFlagMacro(
    ForceVisibility, true, NotBaked, "Whether the arrow of the whole force is shown. Default on."),
  HapticFlagMacro(NormalForceVisibility, true, NotBaked,
    "Whether the arrow of the normal force is shown. Default on."),
  HapticFlagMacro(FrictionForceVisibility, true, NotBaked,
    "Whether the arrow of the friction force is shown. Default on."),
  HapticFlagMacro(MarkerVisibility, false, NotBaked,
    "Whether markers are shown at x_s (yellow) and x_v (turquoise), at which the materials are "
    "read. Default off."),
  HapticFlagMacro(
    StylusVisibility, true, NotBaked, "Whether a stylus is shown at the proxy. Default on."),
  HapticNumberMacro(StylusLength, 0.0, VTK_DOUBLE_MAX, 0.0, "", NotBaked,
    "Length of the stylus, world units, 0 or more. Default 0: 25 times Radius, and for a stylus "
    "that leans towards the viewer a third of the way there at most."),
  HapticFlagMacro(ScaleTextVisibility, true, NotBaked,
    "Whether a text shows the length of a newton. Default on."),
  HapticFlagMacro(HiddenVisibility, true, NotBaked,
    "Whether markers behind a surface or inside the volume show through. Default on."),
  HapticFlagMacro(LandingVisibility, true, NotBaked,
    "Whether a ring shows where the tip would touch next on its way along the line of sight, with "
    "the distance; in contact, it is the edge of the patch on the touched surface. Default on."),
  HapticFlagMacro(FollowedVisibility, true, NotBaked,
    "Whether that is shown which the modes of PRIMITIVES hold the hand on, each in its colour: the "
    "line of a flow through the proxy, a core line, fibre, vessel or guide, fronts as discs, and a "
    "tensor as an ellipsoid, drawn longer than the proxy so that its axes can be seen. Default "
    "on."),
  HapticNumberMacro(FollowedReach, 1.0, 1000.0, 48.0, "voxels", NotBaked,
    "How far these lines are followed to either side (voxels), 1 to 1000. Default 48."),
};
} // namespace RepresentationSettingRows

inline constexpr const auto& RepresentationSettings = RepresentationSettingRows::All;

} // namespace VolumeHaptics

#endif
