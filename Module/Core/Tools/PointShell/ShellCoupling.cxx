// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Tools/PointShell/ShellCoupling.h"

#include "Core/Tools/PointShell/BakedShell.h"

#include <algorithm>
#include <cmath>

namespace VolumeHaptics
{
namespace
{

/** Largest coordinate of a hand (m). */
constexpr double FarthestHand = 1e9;
/**
 * Limit of the poses at which a tick evaluates the contacts ("looks"), and limit of the points that
 * it reads at all poses together. Two poses are always allowed.
 */
constexpr std::size_t MostLooks = 16;
constexpr std::size_t MostPointsRead = 40000;
/** Reading a point takes longer by this factor where a burr has removed tissue. */
constexpr std::size_t PointsOfCarved = 5;
/**
 * A tick ends if the next step would change the force by less than this fraction of the force plus
 * this force (N).
 */
constexpr double ForceFraction = 5e-3;
constexpr double ForceTolerance = 5e-4;
/**
 * A step may raise the energy by this fraction, because noise in the data can cause such a rise.
 */
constexpr double EnergyTolerance = 0.02;
/**
 * Largest reserve, as a fraction of the stored energy. A contact that loses energy adds to the
 * reserve, and later rises of the energy use it up.
 */
constexpr double MostReserve = 0.1;

struct Step
{
  Vector3 Move;
  Vector3 Turn;
};

/** The springs between hand and tool. */
struct Coupling
{
  double Stiffness;
  double TurningStiffness;

  struct Pull
  {
    double Energy;
    Vector3 Force;  ///< force on the hand (N)
    Vector3 Torque; ///< torque on the hand (N m)
  };
  Pull At(const ShellPose& tool, const ShellPose& hand) const noexcept
  {
    const Vector3 lag = tool.Position - hand.Position;
    const Quaternion turn = tool.Orientation * Conjugate(hand.Orientation);
    const Vector3 axis{ turn.X, turn.Y, turn.Z }; // axis of the rotation times sin(theta/2)
    return { 0.5 * this->Stiffness * Dot(lag, lag) + 2.0 * this->TurningStiffness * Dot(axis, axis),
      this->Stiffness * lag, (2.0 * this->TurningStiffness * turn.W) * axis };
  }
};

Coupling MakeCoupling(const ShellSettings& settings, const ForceCaps& caps) noexcept
{
  const double k = settings.CouplingStiffness;
  return { caps.Stiffness > 0.0 ? std::min(k, caps.Stiffness) : k, settings.TurningStiffness };
}

/** Computes the Gauss-Newton step from a pose, given the springs' pull and the contacts there. */
Step ComputeStep(const Coupling& coupling, const Coupling::Pull& pull, const ShellSum& sum) noexcept
{
  // Cholesky decomposition A = L L^T, by rows.
  double l[6][6];
  double b[6] = { -pull.Force.X - sum.Gradient[0], -pull.Force.Y - sum.Gradient[1],
    -pull.Force.Z - sum.Gradient[2], -pull.Torque.X - sum.Gradient[3],
    -pull.Torque.Y - sum.Gradient[4], -pull.Torque.Z - sum.Gradient[5] };
  const double* a = sum.Curvature;
  for (int i = 0; i < 6; ++i)
  {
    for (int j = 0; j <= i; ++j)
    {
      const double own = i < 3 ? coupling.Stiffness : coupling.TurningStiffness;
      double rest = *a++ + (i == j ? own : 0.0);
      for (int k = 0; k < j; ++k)
      {
        rest -= l[i][k] * l[j][k];
      }
      l[i][j] = i == j ? std::sqrt(std::max(rest, 1e-3 * own)) : rest / l[j][j];
    }
  }
  for (int i = 0; i < 6; ++i)
  {
    for (int k = 0; k < i; ++k)
    {
      b[i] -= l[i][k] * b[k];
    }
    b[i] /= l[i][i];
  }
  for (int i = 5; i >= 0; --i)
  {
    for (int k = i + 1; k < 6; ++k)
    {
      b[i] -= l[k][i] * b[k];
    }
    b[i] /= l[i][i];
  }
  return { { b[0], b[1], b[2] }, { b[3], b[4], b[5] } };
}

/**
 * Returns the pose after a fraction of a step. The pose rotates by 2 atan(|Turn|/2), which is less
 * than |Turn|.
 */
ShellPose Moved(const ShellPose& pose, const Step& step, double fraction) noexcept
{
  const Vector3 half = (0.5 * fraction) * step.Turn;
  const Quaternion turned = Quaternion{ 1.0, half.X, half.Y, half.Z } * pose.Orientation;
  return { pose.Position + fraction * step.Move, (1.0 / std::sqrt(SquaredNorm(turned))) * turned };
}

bool IsPose(const ShellPose& pose) noexcept
{
  Quaternion q = pose.Orientation;
  return IsNear(pose.Position, FarthestHand) && MakeUnit(q);
}

std::size_t ComputeMostLooks(const HapticModel& model, const PointShell& shell) noexcept
{
  const bool isCarved = model.Baked->Tool && model.Baked->Tool->RemovesTissue() &&
    model.Baked->Field.GetCarved().HasAny();
  const std::size_t points =
    std::max<std::size_t>(shell.GetSize(), 1) * (isCarved ? PointsOfCarved : 1);
  return std::clamp<std::size_t>(MostPointsRead / points, 2, MostLooks);
}

/** A tick of an enabled tool. */
class Advance
{
public:
  Advance(const HapticModel& model, const PointShell& shell, const ShellSettings& settings,
    ShellState& state, ShellMemory& memory) noexcept
    : Finder(model, shell, settings)
    , Springs(MakeCoupling(settings, model.Caps))
    , Reach(settings.Scale * shell.GetReach())
    , Most(ComputeMostLooks(model, shell))
    , State(state)
    , Memory(memory)
  {
  }

  /** Places the tool in the hand. */
  void Start(const ShellPose& hand) noexcept
  {
    this->State.Tool = this->State.Hand = hand;
    this->State.Budget = 0.0;
    this->Memory.GetCurrent().Count = 0;
    this->Memory.Clearance.Reset();
    this->Look(hand, true);
    this->Memory.Swap();
    this->State.Sum = this->Sum;
    this->State.IsCarried = false;
    this->State.Enabled = true;
  }

  void Update(const ShellPose& hand) noexcept
  {
    ShellState& s = this->State;
    if (s.IsCarried)
    {
      this->Resume();
    }
    s.Budget += this->Springs.At(s.Tool, hand).Energy - this->Springs.At(s.Tool, s.Hand).Energy;
    s.Hand = hand;
    Coupling::Pull pull = this->Springs.At(s.Tool, hand);
    Step step = ComputeStep(this->Springs, pull, s.Sum);
    this->IsUnfinished = true;
    while (this->Looks < this->Most && this->IsUnfinished)
    {
      const double fraction = this->ComputeFraction(step);
      const bool isFree = fraction == 1.0 && s.Sum.Contacts == 0;
      ShellPose next = isFree && this->IsNearlyTurned(hand) ? hand : Moved(s.Tool, step, fraction);
      const double before = pull.Energy + s.Sum.Energy;
      this->Look(next, false);
      pull = this->Springs.At(next, hand);
      if (this->IsTooMuch(before, pull) && this->Looks < this->Most)
      {
        // The step was computed without the contacts that it has just met. The sums now contain
        // them, so correct the step once.
        next = this->Corrected(next, pull);
        this->Look(next, false);
        pull = this->Springs.At(next, hand);
      }
      for (double part = 0.25 * fraction; this->IsTooMuch(before, pull) && this->Looks < this->Most;
           part *= 0.25)
      {
        next = Moved(s.Tool, step, part);
        this->Look(next, false);
        pull = this->Springs.At(next, hand);
      }
      if (!this->Apply(next, pull))
      {
        return;
      }
      step = ComputeStep(this->Springs, pull, s.Sum);
      this->IsUnfinished = this->IsFar(step, pull);
    }
  }

  void Report(ShellRecord& record) const noexcept
  {
    const ShellState& s = this->State;
    const Coupling::Pull pull = this->Springs.At(s.Tool, s.Hand);
    record.Hand = s.Hand;
    record.Tool = s.Tool;
    record.Force = pull.Force;
    record.Torque = pull.Torque;
    record.Stiffness = this->Springs.Stiffness;
    record.Energy = s.Sum.Energy;
    record.Contacts = s.Sum.Contacts;
    record.Yielding = s.Sum.Yielding;
    record.Looks = this->Looks;
    record.IsUnfinished = this->IsUnfinished;
  }

private:
  /**
   * Determines which points press after a change of the model. The tool does not move, and no
   * contact gains energy.
   */
  void Resume() noexcept
  {
    ShellState& s = this->State;
    const ShellPose tool = s.Tool;
    const Coupling::Pull pull = this->Springs.At(tool, s.Hand);
    s.IsCarried = false;
    s.Budget = std::max(s.Budget, pull.Energy); // rounding may have exceeded the budget
    this->Look(tool, false);
    this->Apply(tool, pull);
  }

  void Look(const ShellPose& pose, bool isStart) noexcept
  {
    ShellMemory& memory = this->Memory;
    this->GoBack();
    this->Way = this->Finder.ComputeWay(this->State.Tool, pose);
    this->Finder.Collect(
      pose, this->Way, isStart, memory.GetCurrent(), memory.GetNext(), memory.Clearance, this->Sum);
    memory.Clearance.Travelled += this->Way;
    this->IsAway = true;
    ++this->Looks;
  }
  /** Returns from a pose that was evaluated but not accepted. */
  void GoBack() noexcept
  {
    if (this->IsAway)
    {
      this->Memory.Clearance.Travelled += this->Way;
      this->IsAway = false;
    }
  }

  bool IsTooMuch(double before, const Coupling::Pull& pull) const noexcept
  {
    return pull.Energy + this->Sum.Energy > (1.0 + EnergyTolerance) * before;
  }

  /**
   * Returns the largest fraction of a step in which all points move only as far as their feet can
   * be tracked.
   */
  double ComputeFraction(const Step& step) const noexcept
  {
    const double way = Norm(step.Move) + this->Reach * Norm(step.Turn);
    const double farthest = this->Finder.GetFarthestStep();
    return way > farthest ? farthest / way : 1.0;
  }

  /**
   * Corrects a pose by the contacts at another pose. The result is so near to the tool that feet
   * can be tracked.
   */
  ShellPose Corrected(const ShellPose& from, const Coupling::Pull& pull) const noexcept
  {
    const Step step = ComputeStep(this->Springs, pull, this->Sum);
    return Moved(from, step, this->ComputeFraction(step));
  }

  /** Returns whether one step can rotate a free tool to the hand's orientation. */
  bool IsNearlyTurned(const ShellPose& hand) const noexcept
  {
    const Quaternion turn = this->State.Tool.Orientation * Conjugate(hand.Orientation);
    constexpr double least = 0.99; // cos(theta/2)
    return std::abs(turn.W) > least;
  }

  /** Accepts the pose of the last look if the budget pays for its pull. Returns whether it does. */
  bool Apply(const ShellPose& next, const Coupling::Pull& pull) noexcept
  {
    ShellState& s = this->State;
    const double room = s.Budget - pull.Energy;
    if (this->Sum.Energy > room)
    {
      if (!(room >= 0.0))
      {
        this->GoBack();
        return false;
      }
      const double fraction = room / this->Sum.Energy;
      const double force = std::sqrt(fraction);
      this->Memory.GetNext().Fraction = fraction;
      this->Sum.Energy = room;
      for (double& gradient : this->Sum.Gradient)
      {
        gradient *= force;
      }
      if (room == 0.0)
      {
        this->Sum.Contacts = this->Sum.Yielding = 0;
      }
    }
    this->Memory.Swap();
    this->IsAway = false;
    s.Tool = next;
    s.Sum = this->Sum;
    const double stored = pull.Energy + s.Sum.Energy;
    s.Budget = s.Sum.Contacts == 0 ? pull.Energy : std::min(s.Budget, (1.0 + MostReserve) * stored);
    return true;
  }

  bool IsFar(const Step& step, const Coupling::Pull& pull) const noexcept
  {
    const double tolerance = ForceTolerance + ForceFraction * Norm(pull.Force);
    // At an arm of this length, a force of this size corresponds to the torque's change.
    constexpr double leastArm = 1e-3; // in m
    const double torque = std::max(this->Reach, leastArm) * tolerance;
    return this->Springs.Stiffness * Norm(step.Move) > tolerance ||
      this->Springs.TurningStiffness * Norm(step.Turn) > torque;
  }

  const ShellContactFinder Finder;
  const Coupling Springs;
  const double Reach;
  const std::size_t Most;
  ShellState& State;
  ShellMemory& Memory;
  ShellSum Sum;        ///< sum at the pose of the last look
  double Way = 0.0;    ///< distance (voxels) from the tool to the last look
  bool IsAway = false; ///< whether the pose of the last look was not accepted
  std::uint32_t Looks = 0;
  bool IsUnfinished = false;
};

} // namespace

ShellSettings ComputeShellSettings(const HapticModel& model) noexcept
{
  ShellSettings settings = static_cast<const ShapedTool&>(*model.Baked->Tool).Description.Touch;
  settings.Scale = 1.0 / model.WorldUnitsPerMeter;
  settings.ContactArea *= settings.Scale * settings.Scale;
  return settings;
}

double ComputeCouplingEnergy(const ShellSettings& settings, const ForceCaps& caps,
  const ShellPose& tool, const ShellPose& hand) noexcept
{
  return MakeCoupling(settings, caps).At(tool, hand).Energy;
}

void ShellMemory::Keep() noexcept
{
  const ShellContacts& current = this->GetCurrent();
  std::copy_n(current.List.begin(), current.Count, this->Kept.List.begin());
  this->Kept.Count = current.Count;
  this->Kept.Fraction = current.Fraction;
}

bool ShellMemory::Restore(const std::vector<ShellContact>& contacts, double fraction) noexcept
{
  std::uint64_t next = 0;
  for (const ShellContact& contact : contacts)
  {
    if (contact.Point < next || contact.Point >= this->Points)
    {
      return false;
    }
    next = std::uint64_t{ contact.Point } + 1;
  }
  ShellContacts& current = this->GetCurrent();
  std::fill(current.Marks.begin(), current.Marks.end(), 0);
  std::copy(contacts.begin(), contacts.end(), current.List.begin());
  for (const ShellContact& contact : contacts)
  {
    current.Marks[contact.Point / ShellBlock::Size] |= std::uint64_t{ 1 }
      << contact.Point % ShellBlock::Size;
  }
  current.Count = contacts.size();
  current.Fraction = fraction;
  this->Clearance.Reset();
  return true;
}

void ShellMemory::AppendTables(std::vector<MemoryRange>& tables) const
{
  const auto append = [&tables](const auto& list) {
    tables.push_back({ list.data(), list.size() * sizeof(list[0]) });
  };
  append(this->Clearance.Until);
  append(this->Clearance.IsClear);
  append(this->Clearance.PerValue);
  append(this->Clearance.Marks);
  append(this->Clearance.MarksUntil);
  for (const ShellContacts* const contacts :
    { &this->Contacts[0], &this->Contacts[1], &this->Kept })
  {
    append(contacts->List);
    append(contacts->Marks);
  }
}

void TickShell(const HapticModel& model, const PointShell& shell, const ShellSettings& settings,
  const ShellPose& hand, ShellState& state, ShellMemory& memory, ShellRecord& record) noexcept
{
  record = ShellRecord{};
  const bool isSame = memory.GetPoints() == shell.GetSize() &&
    (!state.Enabled || memory.Model == model.Baked->Number);
  if (!IsPose(hand) || !isSame)
  {
    state.Enabled = false;
    record.Hand = hand;
    record.Tool = state.Tool;
    return;
  }
  ShellPose unit = hand;
  MakeUnit(unit.Orientation);
  Advance advance(model, shell, settings, state, memory);
  if (state.Enabled)
  {
    advance.Update(unit);
  }
  else
  {
    memory.Model = model.Baked->Number;
    advance.Start(unit);
  }
  advance.Report(record);
}

} // namespace VolumeHaptics
