// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The settings of vtkVolumeHapticsFilter, one row each: see HapticSetting.h.
 *
 * To add a setting: a member with its macros in the public header, a row here, a property in
 * ParaView's XML, and the code of the core that uses it.
 */
#ifndef HapticFilterSettings_h
#define HapticFilterSettings_h

#include "VTK/Base/HapticSetting.h"

#include "vtkVolumeHapticsAlgorithm.h"

namespace VolumeHaptics
{

using FilterSetting = HapticSetting<vtkVolumeHapticsAlgorithm>;
using FilterText = HapticTextSetting<vtkVolumeHapticsAlgorithm>;

inline constexpr SettingChoice MethodNames[] = { { "Proxy", "Proxy" },
  { "ForceField", "Force field" }, { "SurfaceProxy", "Surface proxy" },
  { "LocalSurface", "Local surface" }, { "Primitives", "Primitives" } };
inline constexpr SettingChoice SolverNames[] = { { "Paper", "Paper" }, { "Precise", "Precise" } };
inline constexpr SettingChoice ContactAlignmentNames[] = { { "Distinctness", "Distinctness" },
  { "Edge", "Edge" } };
inline constexpr SettingChoice GeometryNames[] = { { "FromScalars", "From scalars" },
  { "FromLabels", "From labels" }, { "FromBoth", "From both" } };
inline constexpr SettingChoice MaterialPlacementNames[] = { { "Kernel", "Kernel" },
  { "FarSide", "Far side" } };
inline constexpr SettingChoice GradientEstimatorNames[] = { { "CentralDifference",
                                                              "Central difference" },
  { "Gaussian", "Gaussian" }, { "CubicBSpline", "Cubic B-spline" } };
inline constexpr SettingChoice LocalSurfaceShapeNames[] = { { "Plane", "Plane" },
  { "Quadric", "Quadric" } };
inline constexpr SettingChoice FramesNames[] = { { "TimeSteps", "Time steps" },
  { "Components", "Components" } };

namespace FilterSettingRows
{
using Owner = vtkVolumeHapticsAlgorithm;
using S = HapticSettings;
using D = HapticModelDescription;

inline constexpr FilterSetting All[] = {
  HapticChoiceMacro(Method, Owner::PROXY, &S::Method,
    "Proxy (default): a proxy held back by virtual surfaces everywhere in the volume, eqs. 2 to "
    "14. The others are for comparison. Force field, eq. 1: the gradient pushes, -C1 grad V - C2 "
    "v, without a proxy. Surface proxy: a small ball that no triangle of the isosurface at the Iso "
    "Value (or of the Surface) lets through. Local surface: a slow loop fits a plane or a quadric "
    "to that isosurface near the proxy, and the servo touches that. Primitives: modes, which hold "
    "the hand by the vectors, tensors or lines in the volume."),
  HapticChoiceMacro(Solver, Owner::PRECISE, &S::Solver,
    "How the method Proxy moves the proxy in a tick. Paper: as published, with one look at the "
    "volume, at the proxy's position before the tick. Precise (default): the same law, in balance "
    "at the proxy's position after it; it neither drifts off curved walls nor leaks out of "
    "cavities."),
  HapticChoiceMacro(ContactAlignment, Owner::EDGE, &S::Alignment,
    "Where a surface begins to hold, with the solver Precise. Distinctness: as soon as "
    "distinctness and strength say so, which on a blurred edge is some voxels before its middle. "
    "Edge (default): not before the middle of the edge, so that what is felt lies on what is "
    "seen."),
  HapticChoiceMacro(Geometry, Owner::FROM_SCALARS, &S::Geometry,
    "Which image makes the surfaces of the method Proxy. From scalars (default): the volume. From "
    "labels: the label image, with walls between its labels. From both: the volume, and walls "
    "between labels where it has no distinct surface."),
  HapticChoiceMacro(MaterialPlacement, Owner::FAR_SIDE, &S::Placement,
    "Which values the materials of a surface belong to, with the solver Precise. Kernel: "
    "those a kernel radius to either side of the proxy, as in the paper. Far side (default): those "
    "that a blurred edge leads to, so that skin feels as what lies behind it, from the first touch "
    "on."),
  HapticNumberMacro(ReleaseTime, 0.0, 1.0, 0.005, "s", &S::ReleaseTime,
    "Time constant (s) with which the force of a proxy that leaps goes over to the new one, with "
    "the solver Precise and materials of the Far side, 0 to 1: where a surface gives way, the hand "
    "feels that over some milliseconds, by 150 N a second at most. 0: at once. Default 0.005."),
  HapticChoiceMacro(GradientEstimator, Owner::GAUSSIAN, &D::Estimator,
    "How gradients are estimated. Central difference: of six trilinear samples Kernel Radius "
    "voxels away. Gaussian (default): the derivative of a Gaussian, which noise disturbs least; "
    "its standard deviation after its cut is about 1.0 voxel at Kernel Radius 2 and 1.4 at 3. "
    "Cubic B-spline: the analytic derivative of a smoothing cubic B-spline over 64 voxels."),
  HapticIntegerMacro(KernelRadius, 1, 16, 2, "voxels", &D::KernelRadius,
    "Radius of the gradient kernel in voxels, 1 to 16. So many voxels along the normal (with the "
    "solver Paper, times the largest spacing) is the distance r from the proxy at which materials "
    "are picked (fig. 4): larger ones are smoother and feel less detail. Default 2."),
  HapticNumberMacro(ServoRate, 1.0, 1e5, 1000.0, "Hz", NotBaked,
    "Ticks per second (Hz), 1 to 100000. Default 1000."),
  HapticNumberMacro(MetersPerWorldUnit, 1e-12, 1e12, 0.001, "", NotBaked,
    "Metres of hand motion for one world unit, 1e-12 to 1e12. The default 0.001 means life-size "
    "for data in millimetres; 0.002 means twice life-size, and no stiffer."),
  HapticNumberMacro(TimeUnitsPerSecond, -1e9, 1e9, 1.0, "", &S::TimeUnitsPerSecond,
    "The data time that passes in a second of the hand: time steps of the image's source per "
    "second if these are whole numbers, -1e9 to 1e9. Negative, time runs backwards. 0 takes one "
    "time step, that which the pipeline asks for, as if the volume did not move. Default 1."),
  HapticChoiceMacro(Frames, Owner::TIME_STEPS, NotBaked,
    "What the frames of a volume that moves are. Time steps (default): those of the image's "
    "source, if it has several. Components: those of the touched array, Frame Spacing apart, "
    "without a copy."),
  HapticNumberMacro(FrameSpacing, 1e-12, 1e12, 1.0, "", NotBaked,
    "The data time from one component of the touched array to the next, if the components are the "
    "frames: 1e-12 to 1e12, in any unit. Default 1."),
  HapticFlagMacro(SameShape, false, &S::SameShape,
    "One stiffness everywhere, the Coupling Stiffness, instead of the stiffness of the material. A "
    "hand that strokes with a constant force then feels the shape that it sees; materials are told "
    "apart by surface strength, friction and drag. Default off."),
  HapticNumberMacro(CouplingStiffness, 0.0, VTK_DOUBLE_MAX, 500.0, "N/m", &S::CouplingStiffness,
    "The stiffness (N/m) with Same Shape, and of the method Primitives, 0 or more. Maximum "
    "Stiffness and the limits of a device cap it, too. Default 500."),
  HapticNumberMacro(ForceFieldGain, -LargestNumber, LargestNumber, 0.01, "", &S::ForceFieldGain,
    "C1 of eq. 1 (N per scalar unit per world unit), for the method Force field. Default 0.01."),
  HapticNumberMacro(ForceFieldDamping, 0.0, VTK_DOUBLE_MAX, 0.0, "", &S::ForceFieldDamping,
    "C2 of eq. 1 (N s/m), 0 or more, for the method Force field. Default 0."),
  HapticNumberMacro(IsoValue, -LargestNumber, LargestNumber, 0.0, "", &S::IsoValue,
    "Scalar value whose isosurface the methods Surface proxy and Local surface touch, and whose "
    "material it has. Default 0."),
  HapticNumberMacro(ProxyRadius, 0.0, 1e9, 0.0, "", &S::ProxyRadius,
    "Radius of the ball (world units) of the method Surface proxy, 0 to 1e9; some voxels at most. "
    "Gaps narrower than its diameter are not felt. 0 (default) stands for half of the smallest "
    "spacing."),
  HapticFlagMacro(ForceShading, true, &S::ForceShading,
    "Turn the force of the method Surface proxy smoothly from triangle to triangle, by the point "
    "normals. Default on."),
  HapticChoiceMacro(LocalSurfaceShape, Owner::PLANE, &S::LocalShape,
    "The shape that the method Local surface fits: the tangent Plane (default), or the Quadric "
    "that also bends as the normal does over Kernel Radius voxels to either side."),
  HapticNumberMacro(LocalSurfaceRate, 1.0, 1000.0, 60.0, "Hz", &S::LocalSurfaceRate,
    "How often the slow loop of the method Local surface looks (Hz), 1 to 1000; 30 to 100 are "
    "usual. Its result comes one period later. Default 60."),
  HapticNumberMacro(RecoveryTime, 0.0, 10.0, 0.015, "s", &S::RecoveryTime,
    "Time (s) in which the force of the method Local surface goes over from one surface to the "
    "next, 0 to 10: longer ones are smoother, and follow later. Default 0.015."),
  HapticNumberMacro(MaximumForce, 0.0, VTK_DOUBLE_MAX, 0.0, "N", &S::MaximumForce,
    "Longest force (N) that the trace shows; longer ones are shortened. 0 (default) does not "
    "limit."),
  HapticNumberMacro(MaximumStiffness, 0.0, VTK_DOUBLE_MAX, 0.0, "N/m", NotBaked,
    "Cap on the stiffness (N/m) whatever the material says: what a device and its sampling can "
    "hold stable. 0 (default) does not cap."),
};

inline constexpr FilterText Texts[] = {
  { "TraceArrays", "all",
    "The point arrays of the trace, by their names, with commas or spaces between them. Default "
    "\"all\". \"none\" leaves the points, the proxy, alone. What is not chosen takes neither time "
    "nor memory; forces do not depend on it.",
    [](Owner* owner) { return owner->GetTraceArrays(); },
    [](Owner* owner, const std::string& text) { owner->SetTraceArrays(text.c_str()); },
    &Owner::CheckTraceArrays },
  { "DisplacementArrayName", "",
    "The point array of the touched image, in each time step, with where its material goes until "
    "the next one: three components, in world units along the world's axes. Surfaces then move "
    "with their material from step to step, however far, and take along a hand that friction "
    "holds. Empty (default): the steps are blended in place.",
    [](Owner* owner) { return owner->GetDisplacementArrayName(); },
    [](Owner* owner, const std::string& text) { owner->SetDisplacementArrayName(text.c_str()); },
    [](const std::string&) { return std::string(); } },
};
} // namespace FilterSettingRows

inline constexpr const auto& FilterSettings = FilterSettingRows::All;
inline constexpr const auto& FilterTexts = FilterSettingRows::Texts;

} // namespace VolumeHaptics

#endif
