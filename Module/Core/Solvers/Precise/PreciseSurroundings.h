// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Computes single motions of the solver Precise (PreciseSolver.h): the material around a proxy, and
 * the end point of a motion.
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

/** A planned motion of the proxy, according to the law and the material at the proxy. */
struct Motion
{
  Vector3 Displacement; ///< displacement in m
  /** Whether a surface holds the proxy, so that the proxy stays on the surface's level. */
  bool IsHeld = false;
  bool IsFree = false; ///< whether no material holds the proxy
};

/** The material before a motion, for MaterialPlacement::FarSide. */
struct TouchedMaterial
{
  const PrecisePoint* Point = nullptr; ///< null if nothing was felt
  bool IsContact = false;              ///< whether the material was in contact
  /**
   * Whether the surface carries a force. If not, it did so earlier, and now only the drag of its
   * medium acts.
   */
  bool IsSurface = false;
};

/** The state at the beginning of a motion. */
struct Departure
{
  Vector3 Proxy;
  PassiveSpring Spring;
  double Level; ///< level of the surface, if the motion is held
  TouchedMaterial Touched;
};

/** The state at the end of a motion. */
struct Arrival
{
  Vector3 Proxy;
  PrecisePoint There;
  double CachedSampleDistance; ///< upper bound (voxels) of the distance from the sampled point
  PassiveSpring Spring;
};

/**
 * Changes the spring's stiffness (N/m) when the proxy moves into other tissue. `lag` (m) is the
 * distance to the tip.
 */
void PassOn(PassiveSpring& spring, double stiffness, double lag) noexcept;

/**
 * Samples the volume around a proxy. Counts the samples, because a tick has a limited number of
 * them.
 */
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
    , Hides(HasWalks && model.Baked->Materials.GetRange(VisibilityChannel).Low <= 0.0)
    , Labels(labels)
  {
  }

  /**
   * Returns the material at a proxy. If surfaces are two-sided, the normal is on the side of the
   * lag. `touched` is the material that was in contact before the proxy moved along its last path
   * of `voxels` (FarSide.h).
   */
  PrecisePoint Look(const Vector3& proxy, const Vector3& lag, const TouchedMaterial& touched,
    double voxels) noexcept;
  /** Like Look() above, if the surface through the proxy is already known. */
  PrecisePoint Look(const Vector3& proxy, const Surface& surface, const Vector3& lag,
    const TouchedMaterial& touched, double voxels) noexcept;
  /**
   * Limits the drag of a point for a proxy with this spring. `lag` (m) is the distance to the tip.
   */
  void LimitDrag(const PassiveSpring& spring, double lag, PrecisePoint& point) const noexcept
  {
    Law::LimitDrag(this->Model, spring.Tension < 1.0 ? (1.0 - spring.Tension) * lag : 0.0, point);
  }
  /** Returns whether enough samples are left for another motion. */
  bool CanGoOn() const noexcept;

  /** Returns ProxyDisplacement::LongestMean, or infinity for the placement Kernel. */
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

  /** Returns the number of voxels per metre along the axis with the smallest spacing. */
  double GetVoxelsPerMeter() const noexcept { return this->Model.MostStepsPerMeter; }

  /**
   * Returns whether a level can belong to the surface at a point. Walls between labels have other
   * levels than the scalars, and each wall has its own level.
   */
  bool IsOfLevel(const PrecisePoint& here, double level) const noexcept
  {
    return !this->Model.Baked->HasOtherSurfaces ||
      std::abs(level - here.Value) * this->Model.MostStepsPerMeter <=
      FarthestLevel * std::abs(here.Slope);
  }

  /** Returns whether both positions are outside the same face of the volume. */
  bool IsBeyond(const Vector3& a, const Vector3& b) const noexcept;

  /**
   * Returns the displacement (m) along the normal from a point to a level. The balance of the
   * spring limits it.
   */
  double ToLevel(
    const PrecisePoint& here, double k, double level, const Vector3& lag) const noexcept
  {
    const double most = FarthestLevel / this->Model.MostStepsPerMeter;
    const double push = Dot(lag, here.Normal);
    const double displacement = (level - here.Value) / here.Slope;
    // The displacement ends inward at the tip, and outward where the surface can no longer hold the
    // spring.
    const double in = std::clamp(push, 0.0, most);
    const double out = std::clamp(here.SurfaceStrength / k - push, 0.0, most);
    return std::clamp(displacement, -out, in);
  }

  /**
   * Performs a fraction of a motion, or less if the material allows less. Returns where the motion
   * ends.
   */
  Arrival Arrive(
    const Departure& start, const Motion& motion, double fraction, const Vector3& tip) noexcept;

private:
  static constexpr int VisibilityChannel = 4; ///< channel of MaterialTable
  /** Largest distance (voxels) of a proxy from its level. */
  static constexpr double FarthestLevel = 0.25;
  /**
   * Strength (N) to which a visible edge is raised, if its material allows as much. It is above the
   * 0.1 N that a hand can feel.
   */
  static constexpr double LeastSeen = 0.15;

  /** The result of a walk: PrecisePoint::Far and PrecisePoint::FarLasts. */
  struct FarWalk
  {
    FarValues Far;
    double Lasts = 0.0;
  };
  /**
   * The spring's rest (m) along both components of a motion, after surface, friction and drag. It
   * is negative if the motion went too far.
   */
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
   * Sets the surface strength of `point` for ContactAlignment::Edge: zero before the middle of an
   * edge. `join` returns the material between two values.
   */
  template <typename Join>
  void Align(const Vector3& index, const Law::Slope& slope, bool isDescending, double distinctness,
    bool isContact, const Join& join, PrecisePoint& point) const noexcept;
  /**
   * Returns how similar the tissues on both sides of an edge are: 1 if the strength behind it is at
   * least 0.65 of the strength ahead, and 0 if it is half or less, as in air, or in fat beside
   * muscle. It also falls to 0 if a hand can't get into the tissue ahead, between 5 N and 10 N of
   * strength.
   */
  double ComputeLikeness(const ValuePair& sides) const noexcept;
  /**
   * Returns the fraction of its strength that an edge holds if it may be a ripple inside a tissue.
   *
   * Behind a boundary between two tissues, V stays on the other side. Behind noise, a streak or a
   * thin septum, V rises again to the value of the tissue from which the hand came. The hand left
   * this tissue unfelt, because surfaces are felt from one side. Such an edge holds with 2 W_d - 1
   * instead of W_d: with its full strength if W_d = 1, and not at all up to W_d = 1/2.
   */
  double ComputeHeldOfRipple(const Vector3& index, const Law::Slope& slope, double value,
    double height, bool isDescending, double distinctness) const noexcept;
  /** Like LeaveMedium(), at a wall between labels. */
  void LeaveWall(const Vector3& index, const Surface& surface,
    const DistinctnessTable::Values& distinct, const ValuePair& values,
    PrecisePoint& point) const noexcept;
  /**
   * Ends the drag of the medium behind an edge that the proxy has passed, if there is less drag at
   * the proxy. For example, when a proxy comes out of a body, the body is behind the edge, and the
   * proxy is in air.
   */
  template <typename Join>
  void LeaveMedium(
    const Join& join, const Vector3& index, bool isDescending, PrecisePoint& point) const noexcept;
  bool IsSeen(double value) const noexcept;
  /** Returns whether the display shows the volume at an index. */
  bool IsShown(const Vector3& index) const noexcept;
  /**
   * Returns whether the label at an index is visible, but too thin for a wall. The hand touches it
   * at the faces of its voxels, which the display shows.
   */
  bool IsThinAndSeen(const Vector3& index, const Surface& surface) const noexcept;
  /**
   * Gives an edge from hidden to visible values a force that can be felt, however gradually the
   * values rise, provided that the tissue behind it has a surface at all. What is visible is thus
   * felt. `joinWith` returns the material between two values for a distinctness; `whole` is the
   * distinctness 1.
   */
  template <typename JoinWith>
  void HoldWhatIsSeen(const Vector3& index, const Law::Slope& slope,
    const DistinctnessTable::Values& whole, const JoinWith& joinWith,
    PrecisePoint& point) const noexcept;
  /**
   * If the display does not show the volume at `index` (its value is hidden, or the index is
   * outside), sets the drag to zero, and also the surface strength unless the surface is a wall. A
   * wall holds the proxy in front of the visible tissue, so it keeps its strength.
   */
  void Hide(const Vector3& index, bool isWall, PrecisePoint& point) const noexcept;
  /** Returns the change of V over the kernel radius, according to the gradient. */
  double ComputeRise(const Law::Slope& slope) const noexcept;
  /**
   * Returns the rise of an edge over the kernel radius, according to the gradient. For a spline it
   * is the rise over one voxel, because a spline is always as wide as the Gaussian of radius 1.
   */
  double ComputePromise(const Law::Slope& slope) const noexcept;
  /**
   * Returns the values that determine a surface's material, by MaterialPlacement. With a fraction
   * of 0, these are the kernel's values. Writes the walk of a point if there is one.
   */
  ValuePair ComputeValues(const Vector3& index, const Law::Slope& slope, bool isDescending,
    double fraction, const TouchedMaterial& touched, double voxels, FarWalk& walk) const noexcept;

  const HapticModel& Model;
  const FieldAtTime Field;
  const bool IsPlain; ///< whether BakedVolume::IsPlain() holds and the volume does not move
  /** Whether values depend on the proxy's path, as with MaterialPlacement::FarSide. */
  const bool HasWalks;
  const bool LeavesMedium; ///< whether surfaces are felt from both sides
  const bool Hides;        ///< whether the display hides some values, which then are not felt
  LabelMemory& Labels;
  int Looks = 0;
};

} // namespace VolumeHaptics

#endif
