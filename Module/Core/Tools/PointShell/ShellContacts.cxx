// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Tools/PointShell/ShellContacts.h"

#include "Core/Math/LowestBit.h"

#include <algorithm>
#include <cmath>

namespace VolumeHaptics
{
namespace
{

/**
 * Voxels: a foot that is farther from the level was not followed, it is still searched. How deep
 * the point is, is no work of the hand then.
 */
constexpr double FarthestFollowed = 0.75;

/** Voxels: what sums of ways, and the map to indices, may lose to rounding. */
constexpr double LeastClearance = 1e-4;
/** Voxels: where a look is farther from the tool, its marks would not hold for long. */
constexpr double MostWayOfMarks = 0.2;

/** The law of a contact: stiffness and strength of a unit of area. */
struct ContactLaw
{
  double Stiffness; ///< kappa, N/m^3, more than 0
  double Strength;  ///< P, N/m^2, more than 0

  double Pressure(double u) const noexcept { return std::min(this->Stiffness * u, this->Strength); }
  bool Yields(double u) const noexcept { return this->Stiffness * u > this->Strength; }
  /** J/m^2 */
  double EnergyAt(double u) const noexcept
  {
    const double most = this->Strength / this->Stiffness;
    return this->Yields(u) ? this->Strength * (u - 0.5 * most) : 0.5 * this->Stiffness * u * u;
  }
  /** The depth at which it has this energy. */
  double DepthOf(double energy) const noexcept
  {
    const double most = this->Strength / this->Stiffness;
    return energy > 0.5 * this->Strength * most ? energy / this->Strength + 0.5 * most
                                                : std::sqrt(2.0 * energy / this->Stiffness);
  }
};

void SetRows(const Matrix3& matrix, double* rows) noexcept
{
  for (int i = 0; i < 3; ++i)
  {
    rows[3 * i] = matrix.Row[i].X;
    rows[3 * i + 1] = matrix.Row[i].Y;
    rows[3 * i + 2] = matrix.Row[i].Z;
  }
}

ShellFrame MakeFrame(const HapticModel& model, double voxel) noexcept
{
  ShellFrame frame;
  SetRows(model.GradientToDevice, frame.GradientToDevice);
  SetRows(model.DeviceToIndex.Linear, frame.DeviceToIndex);
  frame.UnitsPerMeter = model.WorldUnitsPerMeter;
  frame.Voxel = voxel;
  frame.KernelLength = model.KernelLength;
  return frame;
}

template <std::size_t Most>
void Set(double (*numbers)[Most], std::size_t i, const Vector3& to) noexcept
{
  numbers[0][i] = to.X;
  numbers[1][i] = to.Y;
  numbers[2][i] = to.Z;
}

Vector3 Get(const double (*numbers)[ShellBatch::Most], std::size_t i) noexcept
{
  return { numbers[0][i], numbers[1][i], numbers[2][i] };
}

} // namespace

/** Points that may be in contact, until there are enough of them to be read together. */
struct ShellContactFinder::Candidates
{
  ShellBatch Batch;
  std::uint32_t Point[ShellBatch::Most];
  const ShellContact* Before[ShellBatch::Most]; ///< null for a new one
  bool IsSolid[ShellBatch::Most];
  double Share = 1.0; ///< of the energy of Before
  MixMemory Labels;   ///< only saves time
  ///@{
  /** Those of the batch that are deep enough, and what is read behind them. */
  std::size_t Chosen[ShellBatch::Most];
  double Places[3 * ShellBatch::Most];
  double Values[ShellBatch::Most];
  ///@}
  ShellPushes Forces;
  std::size_t Pushing = 0; ///< of how many points Forces has those that press
};

ShellContactFinder::ShellContactFinder(
  const HapticModel& model, const PointShell& shell, const ShellSettings& settings) noexcept
  : Model(model)
  , Shell(shell)
  , Settings(settings)
  , Reader(model.Baked->Field.GetView(), settings.Level, settings.IsBelow,
      model.Baked->Field.GetCarved())
  , Voxel(1.0 / model.MostVoxelsPerMeter)
  , Scale(settings.Scale)
  , Frame(MakeFrame(model, this->Voxel))
{
  const Vector3* const rows = model.DeviceToIndex.Linear.Row;
  const double square = this->Voxel * this->Voxel;
  for (int a = 0; a < 3; ++a)
  {
    const int b = (a + 1) % 3;
    this->Steepness[a] = square * Dot(rows[a], rows[a]);
    this->Steepness[3 + a] = 2.0 * square * std::abs(Dot(rows[a], rows[b]));
  }
}

double ShellContactFinder::FindWay(const ShellPose& from, const ShellPose& to) const noexcept
{
  // A point at r moves by 2 sin(theta/2) |r| at most.
  const Quaternion turn = to.Orientation * Conjugate(from.Orientation);
  const double chord = 2.0 * Norm({ turn.X, turn.Y, turn.Z });
  return (Norm(to.Position - from.Position) + chord * (this->Scale * this->Shell.GetReach())) /
    this->Voxel;
}

double ShellContactFinder::FindPerValue(const Vector3& centre, const Vector3& half) const noexcept
{
  double slopes[3];
  if (!this->Reader.FindSlopes(centre, half, slopes))
  {
    return 0.0;
  }
  // |sum of g_a r_a|, of slopes up to these, r_a the rows of the map to indices.
  double square = 0.0;
  for (int a = 0; a < 3; ++a)
  {
    square +=
      slopes[a] * (this->Steepness[a] * slopes[a] + this->Steepness[3 + a] * slopes[(a + 1) % 3]);
  }
  constexpr double flattest = 1e-300;
  return 1.0 / std::max(std::sqrt(square), flattest);
}

/** Finds again what the clearance has of a block, if the tool has moved too far since. */
void ShellContactFinder::Survey(std::size_t block, const Affine3& toolToIndex, double way,
  ShellClearance& clearance) const noexcept
{
  if (clearance.Travelled + way < clearance.Until[block])
  {
    return;
  }
  if (clearance.Until[block] < 0.0)
  {
    double* const until = clearance.MarksUntil.data() + block * ShellBlock::Size;
    std::fill(until, until + ShellBlock::Size, -1.0);
  }
  // One voxel, and what rounding may take.
  constexpr double margin = 1.001;
  const ShellBlock& at = this->Shell.GetBlocks()[block];
  const Vector3& voxels = this->Model.VoxelsPerMeter;
  const double radius = this->Scale * at.Radius;
  const Vector3 centre = toolToIndex(at.Centre);
  const Vector3 half{ radius * voxels.X + margin, radius * voxels.Y + margin,
    radius * voxels.Z + margin };
  const bool isClear = !this->Reader.MayBeSolid(centre, half);
  const double perValue = isClear || way > MostWayOfMarks ? 0.0 : this->FindPerValue(centre, half);
  clearance.IsClear[block] = isClear ? 1 : 0;
  clearance.PerValue[block] = perValue;
  // What is not clear may be so soon.
  clearance.Until[block] = clearance.Travelled + way + (isClear || perValue > 0.0 ? 1.0 : 0.5);
}

std::uint64_t ShellContactFinder::Mark(
  std::size_t block, const double* map, double way, ShellClearance& clearance) const noexcept
{
  if (clearance.IsClear[block] != 0)
  {
    return 0;
  }
  const PointShell& shell = this->Shell;
  const std::size_t begin = block * ShellBlock::Size;
  const ShellNumbers points{ shell.GetX() + begin, shell.GetY() + begin, shell.GetZ() + begin,
    std::min(ShellBlock::Size, shell.GetSize() - begin) };
  std::uint64_t& marks = clearance.Marks[block];
  marks = this->Reader.MarkWhole(points, map,
    { marks, clearance.MarksUntil.data() + begin, clearance.Travelled + way,
      clearance.Travelled + way - LeastClearance, clearance.Until[block],
      clearance.PerValue[block] });
  return this->Reader.Unmark(points, map, marks);
}

void ShellContactFinder::Find(const ShellPose& pose, double way, bool isStart,
  const ShellContacts& from, ShellContacts& to, ShellClearance& clearance,
  ShellSum& sum) const noexcept
{
  sum = ShellSum{};
  to.Count = 0;
  to.Share = 1.0;
  const Affine3 toolToDevice{ this->Scale * ToMatrix(pose.Orientation), pose.Position };
  const Affine3 toolToIndex = Compose(this->Model.DeviceToIndex, toolToDevice);
  ShellPlacement placement;
  SetRows(toolToIndex.Linear, placement.ToolToIndex);
  placement.ToolToIndex[9] = toolToIndex.Offset.X;
  placement.ToolToIndex[10] = toolToIndex.Offset.Y;
  placement.ToolToIndex[11] = toolToIndex.Offset.Z;
  SetRows(toolToDevice.Linear, placement.ToolToDevice);
  Candidates candidates;
  candidates.Share = from.Share;
  const ShellContact* before = from.List.data();
  for (std::size_t block = 0; block < to.Marks.size(); ++block)
  {
    this->Survey(block, toolToIndex, way, clearance);
    const std::size_t begin = block * ShellBlock::Size;
    const std::uint64_t solid = this->Mark(block, placement.ToolToIndex, way, clearance);
    const std::uint64_t held = from.Count > 0 ? from.Marks[block] : 0;
    to.Marks[block] = 0;
    for (std::uint64_t rest = solid | held; rest != 0; rest &= rest - 1)
    {
      const int bit = LowestBit(rest);
      const std::size_t point = begin + static_cast<std::size_t>(bit);
      ShellBatch& batch = candidates.Batch;
      const std::size_t n = batch.Count++;
      const ShellContact* const last = (held >> bit & 1) != 0 ? before++ : nullptr;
      candidates.Point[n] = static_cast<std::uint32_t>(point);
      candidates.IsSolid[n] = (solid >> bit & 1) != 0;
      candidates.Before[n] = last;
      Set(batch.Position, n, this->Shell.GetPosition(point));
      Set(batch.Offset, n, last ? last->Offset : Vector3{});
      if (batch.Count == ShellBatch::Most)
      {
        this->Append(candidates, placement, isStart, to, sum);
        if (candidates.Pushing == ShellPushes::Most)
        {
          this->AddForces(candidates, sum);
        }
      }
    }
  }
  this->Append(candidates, placement, isStart, to, sum);
  this->AddForces(candidates, sum);
}

void ShellContactFinder::Append(Candidates& candidates, const ShellPlacement& placement,
  bool isStart, ShellContacts& to, ShellSum& sum) const noexcept
{
  const HapticModel& model = this->Model;
  const BakedVolume& baked = *model.Baked;
  ShellBatch& batch = candidates.Batch;
  this->Reader.Place(this->Frame, placement, batch);
  this->Reader.FindFeet(this->Frame, batch);
  std::size_t count = 0;
  for (std::size_t i = 0; i < batch.Count; ++i)
  {
    const double magnitude = batch.Magnitude[i];
    // Also false for NaN: without a gradient there is no contact. A point that has come out of a
    // thin wall on the other side is held on, see below.
    const bool isThere = magnitude > 1e-12 * std::abs(batch.Value[i]) && magnitude < HUGE_VAL &&
      batch.Depth[i] > (candidates.IsSolid[i] ? 0.0 : this->Voxel);
    if (!isThere || (baked.Cut && baked.Cut->Find(Get(batch.Index, i)).Depth < 0.0))
    {
      continue;
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      candidates.Places[3 * count + axis] = batch.Behind[axis][i];
    }
    candidates.Chosen[count++] = i;
  }
  this->Reader.ReadValues(candidates.Places, count, candidates.Values);

  const double perArea = 1.0 / this->Settings.ContactArea;
  const double* const areas = this->Shell.GetAreas();
  const double squareMeter = this->Scale * this->Scale;
  ShellPushes& forces = candidates.Forces;
  const BakedLabels* const labels = baked.Labels.get();
  for (std::size_t n = 0; n < count; ++n)
  {
    const std::size_t i = candidates.Chosen[n];
    const ShellContact* const before = candidates.Before[i];
    const DistinctnessTable::Values distinct = baked.Distinctness(batch.Magnitude[i]);
    MaterialTable::Values material = baked.Materials(candidates.Values[n]);
    if (labels)
    {
      labels->Mix(
        model.IndexToLabel(Get(batch.Behind, i)), baked.Number, candidates.Labels, material);
    }
    ContactLaw law;
    law.Stiffness = material[0] * perArea;
    law.Strength = material[2] * (distinct[0] * model.BorderFade(Get(batch.Foot, i))) *
      (material[4] * distinct[1]) * perArea;
    const bool isFelt = material[0] > HapticModel::MinimumStiffness && law.Strength > 0.0;
    const double area = squareMeter * areas[candidates.Point[i]];
    const double depth = batch.Depth[i];
    double stretch = 0.0;
    if (isFelt && !isStart)
    {
      double kept = 0.0;
      double deeper = depth;
      if (before)
      {
        // The energy stays if the material changes.
        const bool isSame = before->Stiffness == law.Stiffness &&
          before->Strength == law.Strength && candidates.Share == 1.0;
        kept = isSame
          ? before->Stretch
          : std::min(law.DepthOf(candidates.Share * before->Energy / area), before->Depth);
        deeper -= before->Depth;
      }
      const bool isFollowed = std::abs(batch.Beyond[i]) < FarthestFollowed * this->Voxel;
      stretch = std::max(kept + (isFollowed ? deeper : std::min(deeper, 0.0)), 0.0);
    }
    if (!candidates.IsSolid[i] && (stretch == 0.0 || law.Yields(stretch)))
    {
      // It has left a wall, and nothing or too much pulls it back.
      continue;
    }
    const Vector3 normal = Get(batch.Normal, i);
    ShellContact& contact = to.List[to.Count++];
    contact.Point = candidates.Point[i];
    contact.Offset = depth * normal;
    contact.Depth = depth;
    contact.Energy = 0.0;
    contact.Stretch = stretch;
    contact.Stiffness = law.Stiffness;
    contact.Strength = law.Strength;
    to.Marks[contact.Point / ShellBlock::Size] |= std::uint64_t{ 1 }
      << contact.Point % ShellBlock::Size;
    if (stretch > 0.0)
    {
      const bool yields = law.Yields(stretch);
      contact.Energy = area * law.EnergyAt(stretch);
      sum.Energy += contact.Energy;
      sum.Yielding += yields ? 1 : 0;
      ++sum.Contacts;
      const std::size_t f = forces.Count++;
      Set(forces.Normal, f, normal);
      Set(forces.Arm, f, Get(batch.Arm, i));
      forces.Force[f] = area * law.Pressure(stretch);
      forces.Stiffness[f] = yields ? 0.0 : area * law.Stiffness;
    }
  }
  candidates.Pushing += batch.Count;
  batch.Count = 0;
}

void ShellContactFinder::AddForces(Candidates& candidates, ShellSum& sum) const noexcept
{
  ShellPushes& forces = candidates.Forces;
  for (std::size_t f = forces.Count; f % 4 != 0; ++f)
  {
    Set(forces.Normal, f, {});
    Set(forces.Arm, f, {});
    forces.Force[f] = forces.Stiffness[f] = 0.0;
  }
  this->Reader.Add(forces, sum.Gradient, sum.Curvature);
  forces.Count = candidates.Pushing = 0;
}

} // namespace VolumeHaptics
