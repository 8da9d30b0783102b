// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Single motions of solver PRECISE (PreciseSolver.h): the material around a proxy, and the end
 * point of a motion.
 */
#ifndef PreciseSurroundings_h
#define PreciseSurroundings_h

#include "Core/Law/MaterialLaw.h"
#include "Core/Model/HapticModel.h"
#include "Core/Solvers/Precise/ProxyDisplacement.h"
#include "Core/State/PreciseState.h"

#include <limits>

namespace VolumeHaptics
{

/** A planned motion of the proxy, computed with the material law from the material at the proxy. */
struct Motion
{
  Vector3 Displacement; ///< m
  bool IsHeld = false;  ///< whether a surface holds the proxy, which then keeps the surface's level
  bool IsFree = false;  ///< whether no material holds the proxy
};

/** The material in contact before a motion, for MaterialPlacement::FarSide. */
struct TouchedMaterial
{
  const PrecisePoint* Point = nullptr; ///< null without a touched material
  /**
   * Whether the surface takes a force. If not, the surface took one earlier, and only its medium
   * drags now.
   */
  bool IsSurface = false;
};

/** The beginning of a motion. */
struct Departure
{
  Vector3 Proxy;
  PassiveSpring Spring;
  double Level; ///< the level of the surface, if the motion is held
  TouchedMaterial Touched;
};

/** The end of a motion. */
struct Arrival
{
  Vector3 Proxy;
  PrecisePoint There;
  double CachedSampleDistance; ///< an upper bound (voxels) of the distance from the sampled point
  PassiveSpring Spring;
};

/** Passes the proxy on to tissue of another stiffness (N/m), with the tip `lag` (m) away. */
void PassOn(PassiveSpring& spring, double stiffness, double lag) noexcept;

/** Samples the volume around a proxy, and counts the samples: a tick has a budget of them. */
class PreciseSurroundings
{
public:
  PreciseSurroundings(
    const HapticModel& model, double dataTime, LabelMemory& labels, TickMemory* memory) noexcept
    : Model(model)
    , Field(model.Baked->At(dataTime, memory))
    , IsPlain(model.Baked->IsPlain() && !model.Baked->IsMoving())
    , HasWalks(model.Baked->Settings.Placement != MaterialPlacement::Kernel)
    , LeavesMedium(HasWalks && model.Baked->Settings.Side == SurfaceSide::Both)
    , Labels(labels)
  {
  }

  /**
   * Returns the material at a proxy. With two-sided surfaces the normal follows the lag. `touched`
   * is the material that was in contact some voxels of path earlier: see FarSide.h.
   */
  PrecisePoint Look(const Vector3& proxy, const Vector3& lag, const TouchedMaterial& touched,
    double voxels) noexcept;
  /** Returns the same if the surface through the proxy is known. */
  PrecisePoint Look(const Vector3& proxy, const Surface& surface, const Vector3& lag,
    const TouchedMaterial& touched, double voxels) noexcept;
  /** Limits the drag of a point, for a proxy with this spring to a tip `lag` (m) away. */
  void LimitDrag(const PassiveSpring& spring, double lag, PrecisePoint& point) const noexcept
  {
    Law::LimitDrag(this->Model, spring.Tension < 1.0 ? (1.0 - spring.Tension) * lag : 0.0, point);
  }
  /** Returns whether the budget suffices for another motion. */
  bool CanGoOn() const noexcept;

  /** Returns ProxyDisplacement::LongestMean, or no limit for materials of the kernel. */
  double GetLongestMean() const noexcept
  {
    return this->HasWalks ? ProxyDisplacement::LongestMean
                          : std::numeric_limits<double>::infinity();
  }

  /** Returns the length of a displacement (m) in voxels. */
  double Voxels(const Vector3& displacement) const noexcept
  {
    return this->Model.StepsOf(displacement);
  }

  /** Returns the voxels per metre along the axis of the smallest spacing. */
  double GetVoxelsPerMeter() const noexcept { return this->Model.MostStepsPerMeter; }

  /**
   * Returns whether a level can belong to the surface at a point: walls between labels have other
   * levels than the scalars, and the next wall has another level than the last.
   */
  bool IsOfLevel(const PrecisePoint& here, double level) const noexcept
  {
    return !this->Model.Baked->HasOtherSurfaces ||
      std::abs(level - here.Value) * this->Model.MostStepsPerMeter <=
      FarthestLevel * std::abs(here.Slope);
  }

  /** Returns whether both positions lie beyond the same face of the volume. */
  bool IsBeyond(const Vector3& a, const Vector3& b) const noexcept;

  /**
   * Returns the displacement (m) along the normal from a point to a level, limited by the spring's
   * balance.
   */
  double ToLevel(
    const PrecisePoint& here, double k, double level, const Vector3& lag) const noexcept
  {
    const double most = FarthestLevel / this->Model.MostStepsPerMeter;
    const double push = Dot(lag, here.Normal);
    const double displacement = (level - here.Value) / here.Slope;
    // At most to the tip, and outwards only as far as the surface can still hold the spring.
    const double in = std::clamp(push, 0.0, most);
    const double out = std::clamp(here.SurfaceStrength / k - push, 0.0, most);
    return std::clamp(displacement, -out, in);
  }

  /**
   * Makes a part of a motion, or less if the material there allows no more; returns where it ends.
   */
  Arrival Arrive(
    const Departure& start, const Motion& motion, double fraction, const Vector3& tip) noexcept;

private:
  /** The largest distance (voxels) from a proxy to its level. */
  static constexpr double FarthestLevel = 0.25;

  /** A walk, for the members Far and FarLasts of PrecisePoint. */
  struct FarWalk
  {
    FarValues Far;
    double Lasts = 0.0;
  };
  /** The remaining spring (m) along the parts of a motion; negative if the motion went too far. */
  struct Remainder
  {
    double Normal;
    double Tangent;
    bool IsWhole; ///< whether both numbers belong to the motion as a whole
  };

  Arrival Try(const Departure& start, const Motion& motion, const Vector3& displacement,
    const Vector3& tip) noexcept;
  Remainder Judge(const Motion& motion, const Vector3& displacement, const Vector3& tip,
    const Arrival& end) const noexcept;
  Arrival DrawBack(const Departure& start, const Motion& motion, const Vector3& displacement,
    const Vector3& tip, const Arrival& end, const Remainder& rest) noexcept;

  PrecisePoint LookAt(const Vector3& index, Surface surface, const Vector3& lag,
    const TouchedMaterial& touched, double voxels) noexcept;
  /**
   * Sets the strength of a point on a surface with alignment Edge; `join` returns the material
   * between two values.
   */
  template <typename Join>
  void Align(const Vector3& index, const Law::Slope& slope, bool isDescending, const Join& join,
    PrecisePoint& point) const noexcept;
  /** Does the same as LeaveMedium, at a wall between labels. */
  void LeaveWall(const Vector3& index, const Surface& surface,
    const DistinctnessTable::Values& distinct, const ValuePair& values,
    PrecisePoint& point) const noexcept;
  /**
   * Ends the drag of a medium behind an edge that the proxy has passed, if there is less drag at
   * the proxy. When a proxy comes out of a body, the body is behind the edge, and air is around the
   * proxy.
   */
  template <typename Join>
  void LeaveMedium(
    const Join& join, const Vector3& index, bool isDescending, PrecisePoint& point) const noexcept;
  /** Whether a value is not hidden. */
  bool IsSeen(double value) const noexcept;
  /**
   * The fraction of an edge's strength that holds a proxy at a hidden value: an edge may be wide,
   * and a part of what it leads to hidden, but the hand meets it where the eye does.
   */
  double ComputeSeenFraction(const Vector3& index, const Law::Slope& slope) const noexcept;
  /** Returns the change of V over the kernel radius, by the gradient. */
  double ComputeRise(const Law::Slope& slope) const noexcept;
  /**
   * Returns the rise that the gradient predicts for an edge, over the kernel radius. For a spline
   * the rise is over one voxel, because a spline is always as wide as the Gaussian of radius 1.
   */
  double ComputePromise(const Law::Slope& slope) const noexcept;
  /**
   * Returns the values that give the material of a surface, by MaterialPlacement; with a fraction
   * of 0, the kernel's values. Writes the walk of a point if there is one.
   */
  ValuePair ComputeValues(const Vector3& index, const Law::Slope& slope, bool isDescending,
    double fraction, const TouchedMaterial& touched, double voxels, FarWalk& walk) const noexcept;

  const HapticModel& Model;
  const FieldAtTime Field;
  const bool IsPlain;      ///< whether BakedVolume::IsPlain() holds and the volume stands still
  const bool HasWalks;     ///< whether values need the proxy's path: for MaterialPlacement::FarSide
  const bool LeavesMedium; ///< whether surfaces are felt from both sides
  LabelMemory& Labels;
  int Looks = 0;
};

} // namespace VolumeHaptics

#endif
