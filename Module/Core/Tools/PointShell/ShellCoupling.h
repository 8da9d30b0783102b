// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Computes the force and torque of a tool with a shape from the pose of the hand.
 *
 * Two springs connect the hand's pose (y, q_y) with the tool's pose (x, q_x). Their energy is
 *
 *   U = k/2 |x - y|^2 + 2 k_r sin^2(theta/2),
 *
 * where theta is the angle between both. The tool is where the sum of U and the contacts' energy E
 * (ShellContacts.h) is smallest, because it has no mass (a quasi-static coupling). A tick makes
 * Gauss-Newton steps from the tool's last pose towards this pose; usually one step is enough. No
 * point moves farther than a quarter of a voxel between two looks, so that even thin walls stop
 * fast tools.
 *
 * The hand feels f = k (x - y), and the torque k_r sin(theta) about the axis of the rotation.
 *
 * Passivity: a budget S contains the energy that the hand has put in. When the hand moves while the
 * tool rests, S changes by the same amount as U. Steps maintain U + E <= S; if nothing else helps,
 * the contacts lose energy. U <= S therefore always holds, and the hand gets back at most the
 * energy that it has put in, for any volume, materials and accuracy of the steps. The energy that a
 * contact has lost pays for later rises, but only up to a tenth of the stored energy, and not after
 * the contact.
 */
#ifndef ShellCoupling_h
#define ShellCoupling_h

#include "Core/Tools/PointShell/ShellContacts.h"

namespace VolumeHaptics
{

/**
 * The contacts at ShellState::Tool, and memory for the contacts of a step. Each shell needs its
 * own.
 */
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
   * Keep() copies the current contacts, and GetKept() returns the copy, with which a recording
   * begins.
   */
  void Keep() noexcept;
  const ShellContacts& GetKept() const noexcept { return this->Kept; }
  ///@}
  /**
   * Continues with a copy of contacts, which must be in ascending order of their points. Returns
   * false and changes nothing if the contacts can't belong to this shell.
   */
  bool Restore(const std::vector<ShellContact>& contacts, double fraction) noexcept;
  /** Appends the ranges of memory that a tick writes. */
  void AppendTables(std::vector<MemoryRange>& tables) const;

  ShellClearance Clearance;
  /** BakedVolume::Number of the contacts' model. */
  std::uint64_t Model = 0;

private:
  std::size_t Points;
  ShellContacts Contacts[2];
  ShellContacts Kept;
  int Current = 0;
};

/** The results of a tick in device space (metres and newtons). */
struct ShellRecord
{
  ShellPose Hand;
  ShellPose Tool;
  Vector3 Force;              ///< force on the hand (N)
  Vector3 Torque;             ///< torque on the hand about the tool's origin (N m)
  double Stiffness = 0.0;     ///< stiffness of the coupling (N/m)
  double Energy = 0.0;        ///< energy in the contacts (J)
  std::uint32_t Contacts = 0; ///< number of pressed points
  std::uint32_t Yielding = 0; ///< number of points at the limit of their material
  std::uint32_t Looks = 0;    ///< number of poses at which the volume was read at all points
  bool IsUnfinished = false;  ///< whether the tool has not reached its final pose yet
};

/**
 * Returns the settings of a model in the device's units of length. The model's tool must have a
 * shape.
 */
ShellSettings ComputeShellSettings(const HapticModel& model) noexcept;

/** Returns the energy (J) in the springs between hand and tool. */
double ComputeCouplingEnergy(const ShellSettings& settings, const ForceCaps& caps,
  const ShellPose& tool, const ShellPose& hand) noexcept;

/**
 * Advances the state by one tick. The force is zero and the state becomes disabled if the hand is
 * not finite, is far away, or has no unit quaternion, if the model has changed since the last tick,
 * or if the memory belongs to another shell. The next tick then begins with the tool in the hand.
 * The function neither allocates, locks nor throws.
 */
void TickShell(const HapticModel& model, const PointShell& shell, const ShellSettings& settings,
  const ShellPose& hand, ShellState& state, ShellMemory& memory, ShellRecord& record) noexcept;

} // namespace VolumeHaptics

#endif
