// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Measures the values on both sides of a blurred edge, for MaterialPlacement::FarSide.
 *
 * A scanner blurs the edge between two tissues to a ramp. At a kernel radius inside the proxy, the
 * value is somewhere on that ramp. Its material belongs to neither tissue, and changes with every
 * irregularity of the edge. The far side is the value to which the ramp leads:
 *
 *   const FarValues far = MeasureFarSide(field, index, reach, radius, rise, isDescending);
 *
 * ## The walk
 *
 * From the proxy x_p, the walk follows the normal to both sides. It makes at most
 * FarSide::MostSteps steps of a quarter of the kernel radius (in voxels along the normal), that is,
 * up to three radii. Let a_j be the rise of V in step j, m the largest rise so far of both sides or
 * of the estimator's gradient, l the smallest rise of this side since its largest one, F_l the
 * value after the step with this rise, and h_j the smaller of a_j and the largest rise before, of
 * this side or, if x_p is on the flank of an edge, of the other side. The value F of a side begins
 * with F_0 = V(x_p) and changes by
 *
 *   F_j = F_l + v_j (F_j-1 - F_l) + (w_j + e_j/2) (V_j - V_j-1),
 *   w_j = w_j-1 v_j u_j,   e_j = w_j-1 v_j (1 - u_j),   w_0 = 1.
 *
 * u_j rises smoothly from 0, at a_j/m = FarSide::Flat, to 1 at FarSide::Steep: the walk ends where
 * the ramp is flat. v_j falls from 1, at (h_j - l)/m = FarSide::Rise, to 0 at FarSide::NextEdge: if
 * another edge begins, steeper or not, F is the value between the two edges. For example, the skull
 * is not read through the scalp, even if the scalp is too thin for a plateau. On an edge that is
 * blurred by a Gaussian of 0.5 to 2 voxels (with the default radius of 2), F is the plateau's value
 * within 1 % of the edge's height. This includes the tail of the edge beyond the end of the walk.
 * On a Gaussian edge of height H, the tail is FarSide::Tail H a_j/m beyond the middle of step j, so
 * F includes the mean of the tails of the steps in which the walk ends, with the weights e_j. At
 * the border of the volume the walk of a side stops, as if V continued in the same way outside: a
 * ramp that is even up to the border counts as even.
 *
 * An even ramp has no edge. The values there are the kernel's, at a radius to both sides of each
 * position, as if MaterialPlacement were Kernel. The whole walk measures how even a ramp is:
 *
 *   E = min(p_i)/max(p_i),   p_i = a_2i-1 + a_2i of both sides.
 *
 * On an edge that is blurred as above, E is less than FarSide::EdgeEvenness. In a field of
 * distances from a point it is 0.7 or more, up to 2 voxels from the point, although coarse voxels
 * and noise of 5 % let single steps differ by more than FarSide::Rise. Between EdgeEvenness and
 * RampEvenness, the values, and the strengths of alignment Edge, are blended from the edge's to the
 * ramp's. A surface in a distance field therefore feels as with the kernel, unless a ridge of the
 * field is within reach.
 *
 * ## Along a surface
 *
 * While a surface carries a force, the values of its material follow the walk's values along the
 * proxy's path s (voxels):
 *
 *   dV/ds = (F - V)/L,   L = FarSide::PathLength ahead, FarSide::MediumPathLength behind.
 *
 * A walk is valid for FarSide::WalkInterval voxels of the path. The material therefore never jumps
 * along a surface, whatever the walk reads, for example noise, or an edge that forks. The medium
 * follows more slowly, because its drag is a force by itself: on bone, where a layer of a few
 * millimetres drags, the drag is often more than the surface's force. The medium continues to
 * follow when the proxy has left the surface and only the drag exerts a force, so that the drag
 * does not jump there.
 *
 * A new contact begins with the values at its own position. So does a contact whose walk finds
 * another edge or no edge, for example after the proxy has passed through a surface.
 *
 * On the way to an edge, the normal may turn, so that another structure is behind the edge. The
 * middle of the edge then moves ahead of the proxy, which would pass through unfelt. To prevent
 * this, the value behind the edge is stored while walks find the same edge, and follows the walks
 * over PathLength. A fully distinct edge that does not hold with the value behind it holds with the
 * stored value, from a tenth of its height beyond the middle on. The medium then has the stored
 * value, too.
 */
#ifndef FarSide_h
#define FarSide_h

#include "Core/Field/FieldAtTime.h"
#include "Core/State/PreciseState.h"

#include <algorithm>

namespace VolumeHaptics
{

namespace FarSide
{
constexpr double StepsPerRadius = 4.0;
constexpr int MostSteps = 12;
/** Distance of a walk's farthest samples, in kernel radii. */
constexpr double FarthestRadii = MostSteps / StepsPerRadius;
///@{
/** Limits as fractions of the largest rise, explained above. */
constexpr double Flat = 0.03;
constexpr double Steep = 0.12;
constexpr double Rise = 0.05;
constexpr double NextEdge = 0.2;
///@}
/**
 * Tail of a Gaussian edge beyond a place, divided by the edge's height and by the relative slope q
 * at this place: (1 - Phi(z))/q with q = exp(-z^2/2). It is 0.13 for q = FarSide::Flat, and 0.16
 * for FarSide::Steep.
 */
constexpr double Tail = 0.15;
///@{
/** Lengths (voxels) of the proxy's path along a surface. */
constexpr double PathLength = 2.5;
constexpr double MediumPathLength = 8.0;
constexpr double WalkInterval = 0.5;
///@}
/**
 * IsSameEdge() returns true if a walk's range of values overlaps the touched edge's range by at
 * least this fraction of the latter.
 */
constexpr double SharedHeight = 0.3;
/** A ramp with at most this evenness counts as an edge. */
constexpr double EdgeEvenness = 0.42;
/** A ramp with at least this evenness has no edge. */
constexpr double RampEvenness = 0.52;

/**
 * Returns 0 for an edge, 1 for an even ramp without an edge, and linearly interpolated values
 * between.
 */
inline double ComputeEvenFraction(const FarValues& far) noexcept
{
  return std::clamp((far.Evenness - EdgeEvenness) / (RampEvenness - EdgeEvenness), 0.0, 1.0);
}
} // namespace FarSide

/**
 * Returns the values of the plateaus ahead and behind. `reach` points along the normal (index
 * steps), and `radius` is the kernel radius (voxels). `rise` is the rise of V over `reach`
 * according to the gradient. isDescending is whether V falls along `reach`.
 */
FarValues MeasureFarSide(const FieldAtTime& field, const Vector3& index, const Vector3& reach,
  double radius, double rise, bool isDescending) noexcept;

/**
 * Returns whether a walk has found the edge of the touched surface again, and not the plateau
 * behind it or the next edge. Two walks across the same edge share some of its values.
 */
inline bool IsSameEdge(const FarValues& touched, const FarValues& far) noexcept
{
  const auto [low, high] = std::minmax(touched.Ahead, touched.Behind);
  const auto [farLow, farHigh] = std::minmax(far.Ahead, far.Behind);
  return std::min(high, farHigh) - std::max(low, farLow) >= FarSide::SharedHeight * (high - low);
}
inline bool IsSameEdge(const MaterialPoint& touched, const FarValues& far) noexcept
{
  return IsSameEdge(FarValues{ touched.SurfaceValue, touched.MediumValue }, far);
}

/**
 * Returns the value at the beginning of the hand's path to an edge, `voxels` of path after a walk
 * that found `before`.
 */
inline double ComputeOrigin(const FarValues& before, const FarValues& far, double voxels) noexcept
{
  return before.Ahead != before.Behind
    ? before.Behind + voxels / (voxels + FarSide::PathLength) * (far.Behind - before.Behind)
    : far.Behind;
}

/**
 * Returns the values of a surface after the proxy has moved along a path of `voxels`, where a walk
 * has found `far`.
 */
inline ValuePair ComputeFarSide(
  const MaterialPoint& touched, const FarValues& far, double voxels) noexcept
{
  const double ahead = voxels / (voxels + FarSide::PathLength);
  const double behind = voxels / (voxels + FarSide::MediumPathLength);
  return { touched.SurfaceValue + ahead * (far.Ahead - touched.SurfaceValue),
    touched.MediumValue + behind * (far.Behind - touched.MediumValue) };
}

} // namespace VolumeHaptics

#endif
