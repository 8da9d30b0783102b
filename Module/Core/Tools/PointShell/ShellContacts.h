// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The contacts of a shell's points with a volume, and their forces.
 *
 * A point is in contact where the volume's value is beyond the level of contact. Its depth is the
 * distance from the level's surface; each contact stores the nearest place there, its foot. In a
 * tick the foot moves along with the point, and with value V and gradient g at the foot,
 *
 *   n = g/|g|,   d = o.n + (V - V_c)/|g|,   o <- d n,
 *
 * with o the way from the foot to the point; a new contact has its foot at the point itself. The
 * last term is bounded by a voxel. So a point may be deeper than the width of its structure's edge:
 * there may be no gradient at the point itself.
 *
 * The pressure is p = min(kappa u, P), where kappa (N/m^3) and P (N/m^2) are stiffness and surface
 * strength of the material at a kernel radius behind the foot, over the area of contact, and u is
 * the depth, unless that would create energy: the energy that a point's motion has stored,
 *
 *   E = area phi(u),   phi = kappa u^2/2 up to the depth at which p = P, linear beyond,
 *
 * is kept if the material changes, and u follows from it, but is never more than d. A point that is
 * solid in the first tick, or whose foot is not found yet, has E = 0. The difference d - u is
 * slack; it ends with the contact.
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
 * Bounds that save reading points, without changing any result.
 *
 * A block of points is clear if no sample around it is solid, up to a voxel beyond its points. For
 * other points, the bound is how far they are from the nearest place that may have the level of
 * contact: the distance of their values from the level, over the largest slope of the values around
 * their block. A point is read again when it may have moved that far.
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

  double Travelled = 0.0;    ///< voxels: the largest motion of any point, summed over all looks
  std::vector<double> Until; ///< Travelled at which IsClear and PerValue expire; -1: unknown
  std::vector<char> IsClear;
  ///@{
  /** Computed as if no tissue was removed: see ShellMarking. */
  std::vector<double> PerValue;
  std::vector<std::uint64_t> Marks;
  std::vector<double> MarksUntil;
  ///@}
};

/** The contacts at a pose, in ascending order of their points. Its memory never grows. */
struct ShellContacts
{
  explicit ShellContacts(std::size_t points)
    : List(points)
    , Marks((points + ShellBlock::Size - 1) / ShellBlock::Size)
  {
  }

  std::vector<ShellContact> List;
  std::vector<std::uint64_t> Marks; ///< a bit for each point: whether it is in List
  std::size_t Count = 0;
  double Fraction = 1.0; ///< the fraction of the stored energies that counts
};

/** Computes the contacts at a pose from those at a pose nearby. Borrows all its arguments. */
class ShellContactFinder
{
public:
  ShellContactFinder(
    const HapticModel& model, const PointShell& shell, const ShellSettings& settings) noexcept;

  /** Returns the longest motion (m) over which contacts can be followed. */
  double GetFarthestStep() const noexcept { return 0.25 * this->Voxel; }
  /** Returns the largest motion (voxels) of any point from one pose to another. */
  double ComputeWay(const ShellPose& from, const ShellPose& to) const noexcept;
  /**
   * Collects the contacts at a pose. With isStart they have no energy, whatever their depth. `way`
   * is the length of the way from the pose of ShellClearance::Travelled.
   */
  void Collect(const ShellPose& pose, double way, bool isStart, const ShellContacts& from,
    ShellContacts& to, ShellClearance& clearance, ShellSum& sum) const noexcept;

private:
  struct Candidates;
  void Survey(std::size_t block, const Affine3& toolToIndex, double way,
    ShellClearance& clearance) const noexcept;
  /**
   * Returns the fewest voxels over which the value changes by 1, around a block; 0 if that is
   * unknown.
   */
  double ComputePerValue(const Vector3& centre, const Vector3& half) const noexcept;
  std::uint64_t Mark(
    std::size_t block, const double* map, double way, ShellClearance& clearance) const noexcept;
  ShellLaw MakeLaw(double fraction, bool isStart) const noexcept;
  void Append(Candidates& candidates, const ShellPlacement& placement, ShellContacts& to,
    ShellSum& sum) const noexcept;
  /** Reads the materials behind the points of a batch. */
  void MixLabels(Candidates& candidates) const noexcept;
  void AddForces(Candidates& candidates, ShellSum& sum) const noexcept;

  const HapticModel& Model;
  const PointShell& Shell;
  const ShellSettings& Settings;
  const ShellReader Reader;
  const double Voxel; ///< m, the smallest spacing
  const double Scale; ///< m, length of the shell's unit
  const ShellFrame Frame;
  double Steepness[6]; ///< from slopes per axis to slope per voxel: xx, yy, zz, xy, yz, zx
};

} // namespace VolumeHaptics

#endif
