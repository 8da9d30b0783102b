// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Where a volume holds the points of a shell, and with which force.
 *
 * A point is in contact where the volume's value is beyond the level of contact. Its depth is the
 * distance from the level's surface, of which each contact knows the nearest place: its foot. In a
 * tick the foot goes along with the point, and from value V and gradient g that are read there,
 *
 *   n = g/|g|,   d = o.n + (V - V_c)/|g|,   o <- d n,
 *
 * with o the way from the foot to the point; a new contact has its foot at the point itself. The
 * last term is bounded by a voxel. So a point may be deeper than the edge of its structure is wide:
 * where it is, there may be no gradient.
 *
 * The pressure is p = min(kappa u, P), where kappa (N/m^3) and P (N/m^2) are stiffness and surface
 * strength of the material at a kernel radius behind the foot, over the area of contact, and u is
 * the depth, unless that would create energy: the energy that the way of a point has stored,
 *
 *   E = area phi(u),   phi = kappa u^2/2 up to the depth at which p = P, linear beyond,
 *
 * is kept if the material changes, and u follows from it, but is never more than d. A point that is
 * solid in the first tick, or whose foot is still searched, has E = 0 there. What u lacks is slack;
 * it ends with the contact.
 */
#ifndef ShellContacts_h
#define ShellContacts_h

#include "Core/Model/HapticModel.h"
#include "Core/Model/PointShell.h"
#include "Core/State/ShellState.h"
#include "Core/Tools/PointShell/ShellReader.h"

#include <cstdint>
#include <vector>

namespace VolumeHaptics
{

/**
 * Bounds by which points need not be read. They only save time: results are the same to the bit.
 *
 * A block of points is clear if no sample around it is solid, up to a voxel beyond its points. Of
 * other points it is known how far they are from where they may come to the level of contact: the
 * distance of their values from it, over the largest slope of the values around their block. They
 * are read anew when they may have come so far.
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

  double Travelled = 0.0;    ///< voxels that any point has moved at most, from look to look
  std::vector<double> Until; ///< how far a block is as IsClear and PerValue say; -1: unknown
  std::vector<char> IsClear;
  ///@{
  /** Without what was removed: see ShellMarking. */
  std::vector<double> PerValue;
  std::vector<std::uint64_t> Marks;
  std::vector<double> MarksUntil;
  ///@}
};

/** The contacts at a pose, by ascending number of the point. Its memory never grows. */
struct ShellContacts
{
  explicit ShellContacts(std::size_t points)
    : List(points)
    , Marks((points + ShellBlock::Size - 1) / ShellBlock::Size)
  {
  }

  std::vector<ShellContact> List;
  std::vector<std::uint64_t> Marks; ///< a bit for each point: whether it is in the list
  std::size_t Count = 0;
  double Share = 1.0; ///< of the energies that counts
};

/** Finds the contacts at a pose from those at a pose nearby. Borrows all that it gets. */
class ShellContactFinder
{
public:
  ShellContactFinder(
    const HapticModel& model, const PointShell& shell, const ShellSettings& settings) noexcept;

  /** m: a contact may be followed over a motion of this length. */
  double GetFarthestStep() const noexcept { return 0.25 * this->Voxel; }
  /** Voxels that any point moves at most from one pose to another. */
  double FindWay(const ShellPose& from, const ShellPose& to) const noexcept;
  /**
   * With isStart, no contact has energy, whatever its depth is. `way` is that from the pose to
   * which ShellClearance::Travelled belongs.
   */
  void Find(const ShellPose& pose, double way, bool isStart, const ShellContacts& from,
    ShellContacts& to, ShellClearance& clearance, ShellSum& sum) const noexcept;

private:
  struct Candidates;
  void Survey(std::size_t block, const Affine3& toolToIndex, double way,
    ShellClearance& clearance) const noexcept;
  /** Voxels that a value takes at least to change by 1, around a block; 0 if that is unknown. */
  double FindPerValue(const Vector3& centre, const Vector3& half) const noexcept;
  std::uint64_t Mark(
    std::size_t block, const double* map, double way, ShellClearance& clearance) const noexcept;
  ShellLaw MakeLaw(double share, bool isStart) const noexcept;
  void Append(Candidates& candidates, const ShellPlacement& placement, ShellContacts& to,
    ShellSum& sum) const noexcept;
  /** Finds the materials behind the points of a batch. */
  void MixLabels(Candidates& candidates) const noexcept;
  void AddForces(Candidates& candidates, ShellSum& sum) const noexcept;

  const HapticModel& Model;
  const PointShell& Shell;
  const ShellSettings& Settings;
  const ShellReader Reader;
  const double Voxel; ///< m, the smallest spacing
  const double Scale; ///< m, of the shell's unit of length
  const ShellFrame Frame;
  double Steepness[6]; ///< of slopes along the axes, to that per voxel: xx, yy, zz, xy, yz, zx
};

} // namespace VolumeHaptics

#endif
