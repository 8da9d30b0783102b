// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Moves a burr by a hand. Lengths are in millimetres unless stated otherwise. */
#ifndef BurrRig_h
#define BurrRig_h

#include "CarvingRig.h"
#include "ShellRig.h"

#include "Core/Tools/Burr/BakedBurr.h"
#include "Core/Tools/Burr/BurrTool.h"

namespace coretest
{
/// A volume with voxels of `size` (mm) that is solid above z = Surface (mm), and its removed
/// tissue.
struct HalfSpace
{
  HalfSpace(const TestVolume::Size& n, double size, std::int64_t surface)
    : Volume(ScalarType::UInt8, n)
    , Surface((static_cast<double>(surface) - 0.5) * size)
    , Removal(std::make_shared<TissueRemoval>())
  {
    this->Volume.Fill<std::uint8_t>([surface](std::int64_t, std::int64_t, std::int64_t k)
      { return static_cast<std::uint8_t>(k >= surface ? 200 : 0); });
    this->Scene = Describe(this->Volume);
    this->Scene.IndexToWorld.Linear = size * Matrix3{};
    this->Scene.Removal = this->Removal;
  }

  TestVolume Volume;
  double Surface; ///< mm
  std::shared_ptr<TissueRemoval> Removal;
  HapticModelDescription Scene;
};

/// A burr, and the contact settings of its head. Lengths are in world units.
struct BurrInHand : BurrSettings
{
  ShellSettings Shell;
};

inline BurrDescription DescribeBurr(
  const BurrInHand& settings, const Polyline& specificEnergy, std::size_t points = 1000)
{
  BurrDescription tool;
  tool.Settings = settings;
  tool.SpecificEnergy = specificEnergy;
  tool.Head.Points =
    std::make_shared<const PointShell>(BakedBurr::MakeHead(settings.Radius, points));
  tool.Head.Touch = settings.Shell;
  return tool;
}

/// A burr that a hand moves through a volume, with 1 ms per tick.
class BurrInVolume
{
public:
  BurrInVolume(HapticModelDescription description, const BurrInHand& settings,
    const Polyline& specificEnergy, std::size_t points = 1000)
    : Settings(settings)
    , Model(With(std::move(description), DescribeBurr(settings, specificEnergy, points)))
    , Points(*ShapedTool::Find(*this->Model.Baked)->Description.Points)
  {
  }

  const BurrRecord& Tick(const Vector3& position)
  {
    const BurrRecord last = this->Record;
    const bool wasEnabled = this->Shell.Enabled;
    const Vector3 hand = 0.001 * position;
    TissueRemoval* const removal = this->Model.Baked->Removal.get();
    if (removal && removal->Serve())
    {
      // Initialize the state as the servo does (ServoTick.h).
      this->Shell.Enabled = false;
      this->State = BurrState{};
      this->Record = BurrRecord{};
      this->Record.Shell.Hand.Position = this->Record.Shell.Tool.Position = hand;
      return this->Record;
    }
    if (wasEnabled)
    {
      this->Work += this->EnergyOfSpring(last.Shell.Tool.Position, hand) -
        this->EnergyOfSpring(last.Shell.Tool.Position, last.Shell.Hand.Position);
      this->VibrationWork -= Dot(last.Force - last.Shell.Force, hand - last.Shell.Hand.Position);
    }
    TickBurr(this->Model, { hand, this->IsSpinning, this->Step }, this->Shell, this->State,
      { this->Points, this->Carver }, this->Record);
    this->Energy += this->Record.Energy;
    this->Removed += this->Record.RemovedVolume;
    if (this->IsSpinning)
    {
      this->Earned += this->Settings.Friction * Norm(this->Record.Shell.Force) * 2.0 * Pi * 0.001 *
        this->Settings.Radius * this->Settings.Speed * this->Step;
    }
    return this->Record;
  }
  const BurrRecord& Lead(const Vector3& goal, double step = 0.05)
  {
    const Vector3 from = 1000.0 * this->Record.Shell.Hand.Position;
    const double steps = std::ceil(Norm(goal - from) / step);
    for (double i = 1.0; i <= steps; i += 1.0)
    {
      this->Tick(from + (i / steps) * (goal - from));
    }
    return this->Record;
  }
  /// Presses with a force (N) along z. The hand stays at the distance from the tool at which the
  /// spring exerts this force.
  const BurrRecord& Press(double force)
  {
    Vector3 hand = this->Record.Shell.Hand.Position;
    hand.Z = this->Record.Shell.Tool.Position.Z + force / this->Settings.Shell.CouplingStiffness;
    return this->Tick(1000.0 * hand);
  }
  double EnergyOfSpring(const Vector3& tool, const Vector3& hand) const
  {
    const Vector3 lag = tool - hand;
    return 0.5 * this->Settings.Shell.CouplingStiffness * Dot(lag, lag);
  }

  const BurrInHand Settings;
  const HapticModel Model;
  ShellMemory Points;
  SphereCarver Carver;
  ShellState Shell;
  BurrState State;
  BurrRecord Record;
  bool IsSpinning = true;
  double Step = 1e-3;         ///< s, duration of a tick
  double Work = 0.0;          ///< J, work of the hand on the spring
  double VibrationWork = 0.0; ///< J, work of the hand against the vibration
  double Earned = 0.0;        ///< J, sum of mu F v over all ticks
  double Energy = 0.0;        ///< J, spent on removal
  double Removed = 0.0;       ///< mm^3 of removed tissue

private:
  static HapticModelDescription With(HapticModelDescription description, BurrDescription tool)
  {
    description.Tool = std::make_shared<const BakedBurr>(std::move(tool));
    return description;
  }
};

/// Returns a burr of 2 mm radius that rotates at 60 000/min with a friction of 0.3, on bone of
/// stiffness `kappa` (N/m^3).
inline BurrInHand MakeBurr(double kappa, double level)
{
  BurrInHand settings;
  settings.Radius = 2.0;
  settings.Speed = 1000.0;
  settings.Friction = 0.3;
  settings.Shell.Level = level;
  settings.Shell.ContactArea = 1e6 * 500.0 / kappa; // mm^2, for the default stiffness
  return settings;
}
} // namespace coretest

#endif
