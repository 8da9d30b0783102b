// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Computes the contacts of a shell's points with a volume, and their forces.
 *
 * A point is in contact where the volume's value is beyond the level of contact. Its depth is its
 * distance from the level's surface. Each contact stores the nearest place on that surface, its
 * foot. In each tick the foot moves with the point. Let V and g be value and gradient at the foot,
 * and o the vector from the foot to the point. Then
 *
 *   n = g/|g|,   d = o.n + (V - V_c)/|g|,   o <- d n.
 *
 * A new contact has its foot at the point itself. The last term of d is limited to a voxel. A point
 * may therefore be deeper than the width of its structure's edge, where there may be no gradient at
 * the point itself.
 *
 * The pressure is p = min(kappa u, P). kappa (N/m^3) and P (N/m^2) are stiffness and surface
 * strength of the material at a kernel radius behind the foot, divided by the contact area. u is
 * the depth, unless that would create energy: the energy that a point's motion has stored,
 *
 *   E = area phi(u),   phi = kappa u^2/2 up to the depth at which p = P, linear beyond,
 *
 * does not change with the material. u follows from it, but is never more than d. A point that is
 * solid in the first tick, or whose foot is not found yet, has E = 0. The difference d - u is
 * slack, which ends with the contact.
 */
#ifndef ShellContacts_h
#define ShellContacts_h

#include "Core/Model/HapticModel.h"
#include "Core/State/ShellState.h"
#include "Core/Tools/PointShell/PointShell.h"
#include "Core/Tools/PointShell/ShellReader.h"

#include <cstdint>
#include <vector>

namespace VolumeHaptics
{

/**
 * Bounds that show which points need not be read. They do not change any result.
 *
 * A block of points is clear if no sample around it is solid, up to a voxel from its points. In
 * other blocks, the bound of a point is its distance from the nearest place that may have the level
 * of contact: the difference between its value and the level, divided by the largest slope of the
 * values around the block. A point is read again when it may have moved that far.
 */
struct ShellClearance
{
  explicit ShellClearance(std::size_t blocks)
    : Until(blocks, -1.0)
    , IsClear(blocks)
    , PerValue(blocks)
    , Marks(blocks)
    , MarksUntil(blocks * ShellBlock::Size)
  {
  }
  void Reset() noexcept
  {
    this->Travelled = 0.0;
    for (double& until : this->Until)
    {
      until = -1.0;
    }
  }

  double Travelled = 0.0; ///< largest motion (voxels) of any point, summed over all evaluated poses
  /**
   * For each block, the value of Travelled at which IsClear and PerValue expire; -1 if they are not
   * known.
   */
  std::vector<double> Until;
  std::vector<char> IsClear;
  ///@{
  /**
   * Least number of voxels over which the value around each block changes by 1, ignoring removed
   * tissue (ShellMarking).
   */
  std::vector<double> PerValue;
  std::vector<std::uint64_t> Marks;
  std::vector<double> MarksUntil;
  ///@}
};

/** The contacts at a pose, in ascending order of their points. Their memory does not grow. */
struct ShellContacts
{
  explicit ShellContacts(std::size_t points)
    : List(points)
    , Marks((points + ShellBlock::Size - 1) / ShellBlock::Size)
  {
  }

  std::vector<ShellContact> List;
  std::vector<std::uint64_t> Marks; ///< one bit for each point: whether it is in List
  std::size_t Count = 0;
  double Fraction = 1.0; ///< fraction of the stored energies that counts
};

/**
 * Computes the contacts at a pose from those at a pose nearby. All arguments of the constructor
 * must outlive this object.
 */
class ShellContactFinder
{
public:
  ShellContactFinder(
    const HapticModel& model, const PointShell& shell, const ShellSettings& settings) noexcept;

  /** Returns the longest motion (m) over which contacts can be tracked. */
  double GetFarthestStep() const noexcept { return 0.25 * this->Voxel; }
  /** Returns the largest motion (voxels) of any point from one pose to another. */
  double ComputeWay(const ShellPose& from, const ShellPose& to) const noexcept;
  /**
   * Collects the contacts at a pose. If isStart, they have no energy, whatever their depth. `way`
   * is the length of the motion since the pose to which ShellClearance::Travelled belongs.
   */
  void Collect(const ShellPose& pose, double way, bool isStart, const ShellContacts& from,
    ShellContacts& to, ShellClearance& clearance, ShellSum& sum) const noexcept;

private:
  struct Candidates;
  void Survey(std::size_t block, const Affine3& toolToIndex, double way,
    ShellClearance& clearance) const noexcept;
  /**
   * Returns the least number of voxels over which the value around a block changes by 1, or 0 if it
   * is not known.
   */
  double ComputePerValue(const Vector3& centre, const Vector3& half) const noexcept;
  std::uint64_t Mark(
    std::size_t block, const double* map, double way, ShellClearance& clearance) const noexcept;
  ShellLaw MakeLaw(double fraction, bool isStart) const noexcept;
  void Append(Candidates& candidates, const ShellPlacement& placement, ShellContacts& to,
    ShellSum& sum) const noexcept;
  /** Reads the materials behind the points of a batch from labels and values. */
  void MixLabels(Candidates& candidates) const noexcept;
  void AddForces(Candidates& candidates, ShellSum& sum) const noexcept;

  const HapticModel& Model;
  const PointShell& Shell;
  const ShellSettings& Settings;
  const ShellReader Reader;
  const double Voxel; ///< smallest spacing (m)
  const double Scale; ///< length of the shell's unit (m)
  const ShellFrame Frame;
  /** Maps slopes along the axes to the slope per voxel: xx, yy, zz, xy, yz, zx. */
  double Steepness[6];
};

} // namespace VolumeHaptics

#endif
