// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A tool with a shape in the hand: from the pose of the hand to force and torque.
 *
 * Between the hand's pose (y, q_y) and the tool's (x, q_x) are two springs with the energy
 *
 *   U = k/2 |x - y|^2 + 2 k_r sin^2(theta/2),
 *
 * theta being the angle between both. The tool is where the sum of U and the contacts' energy E
 * (ShellContacts.h) is smallest: it has no mass (a quasi-static coupling). A tick takes
 * Gauss-Newton steps towards that pose, from the tool's last pose; usually one is enough. No point
 * moves farther than a quarter of a voxel between two looks, so that thin walls hold fast tools.
 *
 * The hand feels f = k (x - y), and the torque k_r sin(theta) about the axis of the turn.
 *
 * Passivity. A budget S holds the energy that the hand has put in: while the tool rests and the
 * hand moves, S changes by the same amount as U. Steps keep U + E <= S; if nothing else helps, the
 * contacts lose energy. So U <= S always, and the hand gets back at most what it has put in, for
 * any volume, materials and accuracy of the steps. The energy that a contact has lost pays for
 * later rises, but only up to a tenth of the stored energy, and not after the contact.
 */
#ifndef ShellCoupling_h
#define ShellCoupling_h

#include "Core/Tools/PointShell/ShellContacts.h"

namespace VolumeHaptics
{

/** The contacts at ShellState::Tool, and room for the contacts of a step; for one shell. */
class ShellMemory
{
public:
  explicit ShellMemory(const PointShell& shell)
    : Clearance(shell.GetBlocks().size())
    , Points(shell.GetSize())
    , Contacts{ ShellContacts(shell.GetSize()), ShellContacts(shell.GetSize()) }
    , Kept(shell.GetSize())
  {
  }

  ShellContacts& GetCurrent() noexcept { return this->Contacts[this->Current]; }
  ShellContacts& GetNext() noexcept { return this->Contacts[1 - this->Current]; }
  /** Makes the next contacts the current ones. */
  void Swap() noexcept { this->Current = 1 - this->Current; }
  std::size_t GetPoints() const noexcept { return this->Points; }

  ///@{
  /**
   * Copies the current contacts (Keep), and returns the copy (GetKept): a recording begins with
   * them.
   */
  void Keep() noexcept;
  const ShellContacts& GetKept() const noexcept { return this->Kept; }
  ///@}
  /**
   * Continues with the contacts of a copy, in ascending order of their points. If the contacts
   * can't belong to this shell, returns false and changes nothing.
   */
  bool Restore(const std::vector<ShellContact>& contacts, double fraction) noexcept;
  /** Appends the memory that a tick writes. */
  void AppendTables(std::vector<MemoryRange>& tables) const;

  ShellClearance Clearance;
  /** BakedVolume::Number of the model to which the contacts belong. */
  std::uint64_t Model = 0;

private:
  std::size_t Points;
  ShellContacts Contacts[2];
  ShellContacts Kept;
  int Current = 0;
};

/** The results of one tick, in device space: metres, newtons. */
struct ShellRecord
{
  ShellPose Hand;
  ShellPose Tool;
  Vector3 Force;              ///< N, on the hand
  Vector3 Torque;             ///< N m, on the hand, about the origin of the tool
  double Stiffness = 0.0;     ///< N/m, the coupling's stiffness
  double Energy = 0.0;        ///< J, energy in the contacts
  std::uint32_t Contacts = 0; ///< number of pressed points
  std::uint32_t Yielding = 0; ///< number of points at the limit of their material
  std::uint32_t Looks = 0;    ///< how often the volume was read at all points
  bool IsUnfinished = false;  ///< whether the tool has not reached its pose yet
};

/** Returns the settings of a model whose tool has a shape, in the device's units of length. */
ShellSettings ComputeShellSettings(const HapticModel& model) noexcept;

/** Returns the energy (J) in the springs between hand and tool. */
double ComputeCouplingEnergy(const ShellSettings& settings, const ForceCaps& caps,
  const ShellPose& tool, const ShellPose& hand) noexcept;

/**
 * Advances the state by one tick. A hand that is not finite, far away, or without a unit quaternion
 * gives zero force and disables the state, and so does a model other than the last tick's, or a
 * memory of another shell. The next tick then begins at the hand. It neither allocates, locks nor
 * throws.
 */
void TickShell(const HapticModel& model, const PointShell& shell, const ShellSettings& settings,
  const ShellPose& hand, ShellState& state, ShellMemory& memory, ShellRecord& record) noexcept;

} // namespace VolumeHaptics

#endif
