// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The settings of vtkHapticRepresentation, vtkHapticFunctionEditor, vtkHapticHeadUpDisplay,
 * vtkHapticRegionPicture, vtkHapticMeasurementRepresentation, vtkHapticSliceView,
 * vtkHapticXRController and vtkInteractorStyleHaptic, one row each: see HapticSetting.h.
 */
#ifndef HapticSceneSettings_h
#define HapticSceneSettings_h

#include "VTK/Base/HapticSetting.h"

#include "vtkHapticFunctionEditor.h"
#include "vtkHapticHeadUpDisplay.h"
#include "vtkHapticMeasurementRepresentation.h"
#include "vtkHapticRegionPicture.h"
#include "vtkHapticRepresentation.h"
#include "vtkHapticSliceView.h"
#include "vtkHapticXRController.h"
#include "vtkInteractorStyleHaptic.h"

namespace VolumeHaptics
{

using RepresentationSetting = HapticSetting<vtkHapticRepresentation>;
using EditorSetting = HapticSetting<vtkHapticFunctionEditor>;
using DisplaySetting = HapticSetting<vtkHapticHeadUpDisplay>;
using PictureSetting = HapticSetting<vtkHapticRegionPicture>;
using MeasurementViewSetting = HapticSetting<vtkHapticMeasurementRepresentation>;
using SliceViewSetting = HapticSetting<vtkHapticSliceView>;
using XRControllerSetting = HapticSetting<vtkHapticXRController>;
using StyleSetting = HapticSetting<vtkInteractorStyleHaptic>;

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

inline constexpr SettingChoice DockEdgeNames[] = { { "Left", "Left" }, { "Right", "Right" },
  { "Bottom", "Bottom" }, { "Top", "Top" } };

namespace EditorSettingRows
{
using Owner = vtkHapticFunctionEditor;

inline constexpr EditorSetting All[] = {
  HapticFlagMacro(Docked, false, NotBaked,
    "Whether the editor is beside the scene, in a viewport of its own, instead of over it in its "
    "rectangle. Default off."),
  HapticChoiceMacro(DockEdge, Owner::BOTTOM_EDGE, NotBaked,
    "The edge of the window for an editor that is Docked: Left, Right, Bottom (default) or Top."),
  HapticNumberMacro(DockShare, 0.1, 0.9, 0.35, "", NotBaked,
    "The share of the window's width or height for an editor that is Docked, 0.1 to 0.9. Default "
    "0.35."),
};
} // namespace EditorSettingRows

inline constexpr SettingChoice PlotCornerNames[] = { { "Automatic", "Automatic" },
  { "LowerLeft", "Lower left" }, { "LowerRight", "Lower right" } };

namespace DisplaySettingRows
{
using Owner = vtkHapticHeadUpDisplay;

inline constexpr DisplaySetting All[] = {
  HapticNumberMacro(TimeSpan, 0.5, 60.0, 5.0, "s", NotBaked,
    "How far back the plot goes (s), 0.5 to 60. Default 5."),
  HapticFlagMacro(PlotVisibility, true, NotBaked, "Whether the plot is shown. Default on."),
  HapticChoiceMacro(PlotCorner, Owner::AUTOMATIC_CORNER, NotBaked,
    "Where the plot is. Automatic (default): at the lower left, or beside or above what the 2D "
    "actors of the program take up there. LowerLeft and LowerRight, above the scale of forces: "
    "there, whatever else is."),
  HapticFlagMacro(TextVisibility, true, NotBaked, "Whether the text is shown. Default on."),
  HapticFlagMacro(DetailsVisibility, false, NotBaked,
    "Whether the text has a line with the value in the surface, the rate of the servo and the "
    "ticks it has missed. Default off."),
  HapticFlagMacro(HintVisibility, true, NotBaked, "Whether the hint is shown. Default on."),
  HapticFlagMacro(HelpVisibility, false, NotBaked, "Whether HelpText is shown. Default off."),
  HapticFlagMacro(
    MeasurementsVisibility, true, NotBaked, "Whether the measurements are listed. Default on."),
};
} // namespace DisplaySettingRows

namespace PictureSettingRows
{
using Owner = vtkHapticRegionPicture;

inline constexpr PictureSetting All[] = {
  HapticIntegerMacro(MaximumVoxels, 1000, 1073741824, 262144, "", NotBaked,
    "The most voxels of the box, 1000 to 2^30. Default 262144."),
};
} // namespace PictureSettingRows

namespace MeasurementViewSettingRows
{
using Owner = vtkHapticMeasurementRepresentation;

inline constexpr MeasurementViewSetting All[] = {
  HapticNumberMacro(Radius, 1e-9, VTK_DOUBLE_MAX, 1.0, "", NotBaked,
    "Radius of points, world units. Default 1; lines are in proportion."),
  HapticFlagMacro(
    LabelVisibility, true, NotBaked, "Whether names and values are shown. Default on."),
  HapticFlagMacro(HiddenVisibility, true, NotBaked,
    "Whether measurements behind a surface or inside the volume show through. Default on."),
};
} // namespace MeasurementViewSettingRows

namespace SliceViewSettingRows
{
using Owner = vtkHapticSliceView;

inline constexpr SliceViewSetting All[] = {
  HapticFlagMacro(Visibility, true, NotBaked, "Whether the slices are shown. Default on."),
  HapticNumberMacro(Share, 0.1, 0.9, 0.3, "", NotBaked,
    "The column's share of the window's width, 0.1 to 0.9. Default 0.3."),
  HapticFlagMacro(
    AutoLayout, true, NotBaked, "Whether this places the renderers in the window. Default on."),
  HapticFlagMacro(Anatomical, false, NotBaked,
    "Whether the world's axes point to a patient's left, back and head, as in DICOM."),
  HapticNumberMacro(ColorWindow, 0.0, VTK_DOUBLE_MAX, 0.0, "", NotBaked,
    "The range of values from black to white, 0 or more. Default 0: nearly all values of the "
    "image, whatever the level."),
  HapticNumberMacro(ColorLevel, -VTK_DOUBLE_MAX, VTK_DOUBLE_MAX, 0.0, "", NotBaked,
    "The value in the middle of the range. Default 0."),
};
} // namespace SliceViewSettingRows

inline constexpr SettingChoice HandNames[] = { { "Left", "Left" }, { "Right", "Right" } };

namespace XRControllerSettingRows
{
using Owner = vtkHapticXRController;

inline constexpr XRControllerSetting All[] = {
  HapticChoiceMacro(Hand, Owner::RIGHT, NotBaked,
    "The hand whose controller leads the tip, Left or Right (default)."),
  HapticNumberMacro(Reach, 0.0, 1.0, 0.05, "m", NotBaked,
    "How far the tip is in front of the controller (m), 0 to 1. Default 0.05."),
};
} // namespace XRControllerSettingRows

inline constexpr SettingChoice FeltVolumeNames[] = { { "Nearest", "Nearest" },
  { "Strongest", "Strongest" } };

namespace StyleSettingRows
{
using Owner = vtkInteractorStyleHaptic;

inline constexpr StyleSetting All[] = {
  HapticFlagMacro(AutoAdjustVolumeQuality, true, NotBaked,
    "Whether ray casters draw as finely as 20 frames per second allow while something moves, and "
    "input interrupts a frame at rest; while the device is armed, a frame at rest takes 0.5 s at "
    "most, and 0.1 s if it can't be interrupted. Default on."),
  HapticFlagMacro(AutoAdjustOffScreen, false, NotBaked,
    "Whether AutoAdjustVolumeQuality also adjusts a window off the screen, for applications that "
    "show its pictures elsewhere, such as in a browser. Default off."),
  HapticNumberMacro(DepthStep, 0.0, VTK_DOUBLE_MAX, 0.0, "", NotBaked,
    "The distance that a step of the wheel moves the tip (world units, 0 or more). Default 0: the "
    "smallest spacing of the image."),
  HapticNumberMacro(DisplayRate, 1.0, 240.0, 60.0, "Hz", NotBaked,
    "Updates per second, 1 to 240. Default 60. Takes effect with the next interactor."),
  HapticChoiceMacro(FeltVolume, Owner::NEAREST, NotBaked,
    "Which one of several volumes is felt: NEAREST (default), whose surface comes first along the "
    "line of sight, or STRONGEST, whose surface along that line pushes back with the largest "
    "force, if it is pressed by four of the smallest voxels; of equal ones the nearest."),
  HapticFlagMacro(TipFollowsSurface, true, NotBaked,
    "Whether the mouse moves the tip along the first surface under it, at the depth to which the "
    "wheel has brought it, so that a stroke goes on around a head. If not, or if there is no "
    "surface, or beyond an edge, the tip moves in the plane of the view. Default on."),
  HapticFlagMacro(WorkspaceFollowsCamera, true, NotBaked,
    "Whether the workspace of a real device follows the camera. Default on."),
  HapticNumberMacro(WorkspaceScale, 0.0, VTK_DOUBLE_MAX, 0.0, "", NotBaked,
    "World units per metre of a real device's workspace, 0 or more. Default 0: by the filter's "
    "MetersPerWorldUnit."),
};
} // namespace StyleSettingRows

inline constexpr const auto& RepresentationSettings = RepresentationSettingRows::All;
inline constexpr const auto& EditorSettings = EditorSettingRows::All;
inline constexpr const auto& DisplaySettings = DisplaySettingRows::All;
inline constexpr const auto& PictureSettings = PictureSettingRows::All;
inline constexpr const auto& MeasurementViewSettings = MeasurementViewSettingRows::All;
inline constexpr const auto& SliceViewSettings = SliceViewSettingRows::All;
inline constexpr const auto& XRControllerSettings = XRControllerSettingRows::All;
inline constexpr const auto& StyleSettings = StyleSettingRows::All;

} // namespace VolumeHaptics

#endif
