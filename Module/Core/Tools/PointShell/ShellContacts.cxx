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
 * A foot is not found yet if it is more than this distance (voxels) from the level. The depth of
 * its point then does not come from work of the hand.
 */
constexpr double FarthestFollowed = 0.75;

/** Margin (voxels) for rounding in sums of lengths and in the map to indices. */
constexpr double LeastClearance = 1e-4;
/**
 * If the tool has moved farther than this (voxels) since the last time, marks would soon expire, so
 * none are made.
 */
constexpr double MostWayOfMarks = 0.2;

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
  frame.KernelRadius = model.HasLengthByDirection ? model.Baked->Kernel.Radius : 0.0;
  return frame;
}

Vector3 Get(const double (*numbers)[ShellBatch::Most], std::size_t i) noexcept
{
  return { numbers[0][i], numbers[1][i], numbers[2][i] };
}

/** Moves the chosen points, with the numbers that the law needs, to the beginning of a batch. */
void Compact(ShellBatch& batch, std::uint64_t chosen) noexcept
{
  std::uint8_t from[ShellBatch::Most];
  std::size_t count = 0;
  std::uint64_t solid = 0;
  for (std::uint64_t rest = chosen; rest != 0; rest &= rest - 1)
  {
    const int i = LowestBit(rest);
    solid |= (batch.Solid >> i & 1) << count;
    from[count++] = static_cast<std::uint8_t>(i);
  }
  const auto move = [&from, count](auto* numbers)
  {
    for (std::size_t n = 0; n < count; ++n)
    {
      numbers[n] = numbers[from[n]];
    }
  };
  move(batch.Point);
  move(batch.Before);
  move(batch.Area);
  move(batch.Was);
  move(batch.Magnitude);
  move(batch.Beyond);
  move(batch.Depth);
  for (int axis = 0; axis < 3; ++axis)
  {
    move(batch.Arm[axis]);
    move(batch.Normal[axis]);
    move(batch.Foot[axis]);
    move(batch.Behind[axis]);
  }
  batch.Solid = solid;
  batch.Count = count;
}

} // namespace

/** Collects points that may be in contact, until there are enough to compute them together. */
struct ShellContactFinder::Candidates
{
  ShellBatch Batch;
  ShellLaw Law;
  MixMemory Labels; ///< results of label lookups, which only make the next lookups faster
  ShellPushes Forces;
  /** Number of candidates since the last AddForces(). Forces contains those that press. */
  std::size_t Pushing = 0;
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

double ShellContactFinder::ComputeWay(const ShellPose& from, const ShellPose& to) const noexcept
{
  // A point at r moves by at most 2 sin(theta/2) |r|.
  const Quaternion turn = to.Orientation * Conjugate(from.Orientation);
  const double chord = 2.0 * Norm({ turn.X, turn.Y, turn.Z });
  return (Norm(to.Position - from.Position) + chord * (this->Scale * this->Shell.GetReach())) /
    this->Voxel;
}

double ShellContactFinder::ComputePerValue(
  const Vector3& centre, const Vector3& half) const noexcept
{
  double slopes[3];
  if (!this->Reader.ComputeSlopes(centre, half, slopes))
  {
    return 0.0;
  }
  // Compute the largest length of sum g_a r_a, where g_a are at most these slopes, and r_a the rows
  // of the map to indices.
  double square = 0.0;
  for (int a = 0; a < 3; ++a)
  {
    square +=
      slopes[a] * (this->Steepness[a] * slopes[a] + this->Steepness[3 + a] * slopes[(a + 1) % 3]);
  }
  constexpr double flattest = 1e-300;
  return 1.0 / std::max(std::sqrt(square), flattest);
}

/** Updates a block's clearance if the tool has moved too far since the last time. */
void ShellContactFinder::Survey(std::size_t block, const Affine3& toolToIndex, double way,
  ShellClearance& clearance) const noexcept
{
  if (clearance.Travelled + way < clearance.Until[block])
  {
    return;
  }
  const double from = clearance.Travelled;
  // Add one voxel, and a margin for rounding.
  constexpr double margin = 1.001;
  const ShellBlock& at = this->Shell.GetBlocks()[block];
  const Vector3& voxels = this->Model.VoxelsPerMeter;
  const double radius = this->Scale * at.Radius;
  const Vector3 centre = toolToIndex(at.Centre);
  const Vector3 half{ radius * voxels.X + margin, radius * voxels.Y + margin,
    radius * voxels.Z + margin };
  const bool isClear = !this->Reader.MayBeSolid(centre, half);
  const double perValue =
    isClear || way > MostWayOfMarks ? 0.0 : this->ComputePerValue(centre, half);
  // A new bound of the slope changes the lengths of motion after which points may reach the level.
  // The bound also holds for the motion so far, because the tool comes from a place in this box.
  const bool isKnown = clearance.Until[block] >= 0.0 && perValue > 0.0;
  const double fraction = isKnown ? perValue / clearance.PerValue[block] : HUGE_VAL;
  double* const until = clearance.MarksUntil.data() + block * ShellBlock::Size;
  for (std::size_t i = 0; i < ShellBlock::Size; ++i)
  {
    until[i] = fraction < HUGE_VAL ? from + fraction * (until[i] - from) : -1.0;
  }
  clearance.IsClear[block] = isClear ? 1 : 0;
  clearance.PerValue[block] = perValue;
  // Check a block that is not clear earlier, because it may soon become clear.
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
      clearance.Travelled + way - LeastClearance, clearance.PerValue[block] });
  return this->Reader.Unmark(points, map, marks);
}

void ShellContactFinder::Collect(const ShellPose& pose, double way, bool isStart,
  const ShellContacts& from, ShellContacts& to, ShellClearance& clearance,
  ShellSum& sum) const noexcept
{
  sum = ShellSum{};
  to.Count = 0;
  to.Fraction = 1.0;
  const Affine3 toolToDevice{ this->Scale * ToMatrix(pose.Orientation), pose.Position };
  const Affine3 toolToIndex = Compose(this->Model.DeviceToIndex, toolToDevice);
  ShellPlacement placement;
  SetRows(toolToIndex.Linear, placement.ToolToIndex);
  placement.ToolToIndex[9] = toolToIndex.Offset.X;
  placement.ToolToIndex[10] = toolToIndex.Offset.Y;
  placement.ToolToIndex[11] = toolToIndex.Offset.Z;
  SetRows(toolToDevice.Linear, placement.ToolToDevice);
  Candidates candidates;
  candidates.Law = this->MakeLaw(from.Fraction, isStart);
  ShellBatch& batch = candidates.Batch;
  const ShellContact none{};
  const ShellContact* before = from.List.data();
  const double* const areas = this->Shell.GetAreas();
  for (std::size_t block = 0; block < to.Marks.size(); ++block)
  {
    this->Survey(block, toolToIndex, way, clearance);
    const std::size_t begin = block * ShellBlock::Size;
    const std::uint64_t solid = this->Mark(block, placement.ToolToIndex, way, clearance);
    const std::uint64_t held = from.Count > 0 ? from.Marks[block] : 0;
    // Points that turn out not to be in contact are removed later.
    to.Marks[block] = solid | held;
    for (std::uint64_t rest = solid | held; rest != 0; rest &= rest - 1)
    {
      const int bit = LowestBit(rest);
      const std::size_t point = begin + static_cast<std::size_t>(bit);
      const std::size_t n = batch.Count++;
      batch.Solid |= (solid >> bit & 1) << n;
      batch.Point[n] = static_cast<std::uint32_t>(point);
      batch.Before[n] = (held >> bit & 1) != 0 ? before++ : &none;
      batch.Position[0][n] = this->Shell.GetX()[point];
      batch.Position[1][n] = this->Shell.GetY()[point];
      batch.Position[2][n] = this->Shell.GetZ()[point];
      batch.Area[n] = areas[point];
      if (batch.Count == ShellBatch::Most)
      {
        this->Append(candidates, placement, to, sum);
        if (candidates.Pushing == ShellPushes::Most)
        {
          this->AddForces(candidates, sum);
        }
      }
    }
  }
  this->Append(candidates, placement, to, sum);
  this->AddForces(candidates, sum);
}

void ShellContactFinder::Append(Candidates& candidates, const ShellPlacement& placement,
  ShellContacts& to, ShellSum& sum) const noexcept
{
  const BakedVolume& baked = *this->Model.Baked;
  ShellBatch& batch = candidates.Batch;
  const auto leave = [&batch, &to](std::uint64_t points)
  {
    for (; points != 0; points &= points - 1)
    {
      const std::uint32_t point = batch.Point[LowestBit(points)];
      to.Marks[point / ShellBlock::Size] &= ~(std::uint64_t{ 1 } << point % ShellBlock::Size);
    }
  };
  candidates.Pushing += batch.Count;
  this->Reader.Place(this->Frame, placement, batch);
  std::uint64_t there = this->Reader.ComputeAllFeet(this->Frame, batch);
  if (baked.Cut)
  {
    for (std::uint64_t rest = there; rest != 0; rest &= rest - 1)
    {
      const int i = LowestBit(rest);
      const bool isCutAway =
        baked.Cut->Compute(Get(batch.Index, static_cast<std::size_t>(i))).Depth < 0.0;
      there &= ~(std::uint64_t{ isCutAway } << i);
    }
  }
  if (const std::uint64_t all = FirstBits(batch.Count); there != all)
  {
    leave(all & ~there);
    Compact(batch, there);
  }
  if (batch.Count > 0)
  {
    this->Reader.ReadValues(
      { batch.Behind[0], batch.Behind[1], batch.Behind[2], batch.Count }, batch.Inside);
    if (baked.Labels)
    {
      this->MixLabels(candidates);
    }
    ShellContact* next = to.List.data() + to.Count;
    const std::uint64_t held =
      this->Reader.Hold(candidates.Law, batch, next, candidates.Forces, sum);
    to.Count = static_cast<std::size_t>(next - to.List.data());
    leave(FirstBits(batch.Count) & ~held);
  }
  batch.Count = 0;
  batch.Solid = 0;
}

void ShellContactFinder::MixLabels(Candidates& candidates) const noexcept
{
  const BakedVolume& baked = *this->Model.Baked;
  ShellBatch& batch = candidates.Batch;
  for (std::size_t i = 0; i < batch.Count; ++i)
  {
    MaterialTable::Values material = baked.Materials(batch.Inside[i]);
    baked.Labels->Mix(
      this->Model.IndexToLabel(Get(batch.Behind, i)), baked.Number, candidates.Labels, material);
    batch.Material[0][i] = material[0];
    batch.Material[1][i] = material[2];
    batch.Material[2][i] = material[4];
  }
}

ShellLaw ShellContactFinder::MakeLaw(double fraction, bool isStart) const noexcept
{
  const BakedVolume& baked = *this->Model.Baked;
  ShellLaw law;
  law.Materials = baked.Labels ? nullptr : &baked.Materials;
  law.Distinctness = &baked.Distinctness;
  law.LastMaterial = baked.Materials.FindSegment(0.0);
  law.LastDistinctness = baked.Distinctness.FindSegment(0.0);
  law.LeastStiffness = HapticModel::MinimumStiffness;
  law.PerContactArea = 1.0 / this->Settings.ContactArea;
  law.SquareMeters = this->Scale * this->Scale;
  law.FadePerVoxel = this->Model.FadePerVoxel;
  law.Fraction = fraction;
  law.FarthestFollowed = FarthestFollowed * this->Voxel;
  law.IsStart = isStart;
  return law;
}

void ShellContactFinder::AddForces(Candidates& candidates, ShellSum& sum) const noexcept
{
  ShellPushes& forces = candidates.Forces;
  for (std::size_t f = forces.Count; f % 4 != 0; ++f)
  {
    for (double(&numbers)[ShellPushes::Most] : forces.Wrench)
    {
      numbers[f] = 0.0;
    }
    forces.Force[f] = forces.Stiffness[f] = 0.0;
  }
  this->Reader.Add(forces, sum.Gradient, sum.Curvature);
  forces.Count = candidates.Pushing = 0;
}

} // namespace VolumeHaptics
