// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Model/LabelWalls.h"

#include "Core/Field/FineLabels.h"
#include "Core/Field/LabelSamples.h"
#include "Core/Math/UniqueNumber.h"

#include <cmath>

namespace VolumeHaptics
{

/** The taps of a kernel at a position. Taps outside the image repeat the voxel at the border. */
struct LabelWalls::Taps
{
  static constexpr int Most = GradientKernel::MaximumTaps;

  int Count;
  /** For each axis, the weights of the value, followed by the weights of the derivative. */
  double Weights[3][2 * Most];
  std::int64_t Offset[3][Most];
  ///@{
  /** Prefix sums of the weights along x. */
  double Value[Most + 1];
  double Slope[Most + 1];
  ///@}
  const std::uint8_t* Fractions;
  std::int64_t Place[3][Most]; ///< the voxels' indices along each axis
};

/** The labels around a position, with their fractions and the gradients of the fractions. */
struct LabelWalls::Around
{
  static constexpr int Most = LabelBlock::Most;

  int Count = 0;
  int Latest = 0;
  std::int64_t Labels[Most];
  FieldSample Fractions[Most];

  FieldSample& Find(std::int64_t label) noexcept
  {
    if (this->Count > 0 && this->Labels[this->Latest] == label)
    {
      return this->Fractions[this->Latest];
    }
    for (int i = 0; i < this->Count; ++i)
    {
      if (this->Labels[i] == label)
      {
        this->Latest = i;
        return this->Fractions[i];
      }
    }
    if (this->Count < Most)
    {
      this->Latest = this->Count++;
      this->Labels[this->Latest] = label;
    }
    return this->Fractions[this->Latest];
  }
};

namespace
{

/** Computes the weights at a position inside the image. Returns the first tap's index. */
std::int64_t ComputeWeights(const GradientKernel& kernel, double position, double* weights) noexcept
{
  const double place = position * GradientKernel::Intervals;
  const double whole = std::floor(place);
  const auto interval = static_cast<std::int64_t>(whole);
  const double t = place - whole;
  const int count = 2 * kernel.Taps;
  const double* const c = kernel.Table.data() +
    (interval % GradientKernel::Intervals) * GradientKernel::Coefficients * count;
  for (int i = 0; i < count; ++i)
  {
    double sum = c[(GradientKernel::Coefficients - 1) * count + i];
    for (int power = GradientKernel::Coefficients - 2; power >= 0; --power)
    {
      sum = sum * t + c[power * count + i];
    }
    weights[i] = sum;
  }
  return interval / GradientKernel::Intervals - kernel.Radius;
}

} // namespace

template <typename T>
void LabelWalls::Gather(const VolumeView& view, const Taps& taps, Around& around) noexcept
{
  const int count = taps.Count;
  const std::int64_t* const step = taps.Offset[0];
  for (int k = 0; k < count; ++k)
  {
    const double valueZ = taps.Weights[2][k];
    const double slopeZ = taps.Weights[2][count + k];
    for (int j = 0; j < count; ++j)
    {
      const double valueY = taps.Weights[1][j];
      const double slopeY = taps.Weights[1][count + j];
      const T* const row = static_cast<const T*>(view.Data) + taps.Offset[2][k] + taps.Offset[1][j];
      int begin = 0;
      for (int i = 1; i <= count; ++i)
      {
        if (i < count && row[step[i]] == row[step[begin]])
        {
          continue;
        }
        FieldSample& fraction = around.Find(ToLabel(row[step[begin]]));
        const double value = taps.Value[i] - taps.Value[begin];
        const double slope = taps.Slope[i] - taps.Slope[begin];
        fraction.Value += valueZ * valueY * value;
        fraction.Gradient +=
          { valueZ * valueY * slope, valueZ * slopeY * value, slopeZ * valueY * value };
        begin = i;
      }
    }
  }
}

template <typename T>
void LabelWalls::GatherShared(const VolumeView& view, const Taps& taps, Around& around) noexcept
{
  const int count = taps.Count;
  for (int k = 0; k < count; ++k)
  {
    const double valueZ = taps.Weights[2][k];
    const double slopeZ = taps.Weights[2][count + k];
    for (int j = 0; j < count; ++j)
    {
      const double value = valueZ * taps.Weights[1][j];
      const Vector3 slope{ value, valueZ * taps.Weights[1][count + j],
        slopeZ * taps.Weights[1][j] };
      const std::int64_t row = taps.Offset[2][k] + taps.Offset[1][j];
      for (int i = 0; i < count; ++i)
      {
        const T* const voxel = static_cast<const T*>(view.Data) + row + taps.Offset[0][i];
        const double valueX = taps.Weights[0][i];
        const double slopeX = taps.Weights[0][count + i];
        const auto add = [&](T label, double part)
        {
          FieldSample& fraction = around.Find(ToLabel(label));
          fraction.Value += part * (value * valueX);
          fraction.Gradient +=
            { part * (slope.X * slopeX), part * (slope.Y * valueX), part * (slope.Z * valueX) };
        };
        const std::uint8_t shared = taps.Fractions[row + taps.Offset[0][i]];
        if (shared == 0)
        {
          add(*voxel, 1.0);
          continue;
        }
        const double part = static_cast<double>(shared) / FineLabels::Parts;
        T other = *voxel;
        const std::int64_t at[3] = { taps.Place[0][i], taps.Place[1][j], taps.Place[2][k] };
        for (int a = 0; a < 3 && other == *voxel; ++a)
        {
          other = at[a] > 0 ? voxel[-view.Stride[a]] : other;
          if (other == *voxel && at[a] + 1 < view.Dimensions[a])
          {
            other = voxel[view.Stride[a]];
          }
        }
        add(*voxel, 1.0 - part);
        add(other, part);
      }
    }
  }
}

LabelWalls::LabelWalls(
  const LabelView& view, const LabelTable& table, int radius, const std::uint8_t* fractions)
  : Kernel(GradientEstimator::Gaussian, radius, GaussianWeights::OwnDerivative,
      ScalePerCut * (radius + 1))
  , View(view.GetView())
  , Table(table)
  , Number(MakeUniqueNumber())
  , Last{ static_cast<double>(this->View.Dimensions[0] - 1),
    static_cast<double>(this->View.Dimensions[1] - 1),
    static_cast<double>(this->View.Dimensions[2] - 1) }
  , InverseRadius(1.0 / this->Kernel.Radius)
  , Sampler(this->View, this->Kernel)
  , Fractions(fractions)
  , GatherFractions(WithSampleType(this->View.Type,
      [fractions](auto sample) -> GatherFunction
      { return fractions ? &GatherShared<decltype(sample)> : &Gather<decltype(sample)>; }))
{
}

LabelWall LabelWalls::Compute(const Vector3& index, WallMemory& memory) const noexcept
{
  // The comparisons are false for NaN, too.
  const bool isInside = index.X >= 0.0 && index.Y >= 0.0 && index.Z >= 0.0 &&
    index.X <= this->Last.X && index.Y <= this->Last.Y && index.Z <= this->Last.Z;
  if (!isInside)
  {
    return {};
  }
  return this->Kernel.Taps == LabelBlock::Taps && !this->Fractions
    ? this->ComputeInBlock(index, memory)
    : this->ComputeInRuns(index);
}

bool LabelWalls::Remember(const LabelBlock& block, WallMemory& memory) const noexcept
{
  memory.Walls = 0;
  if (block.Count > 2)
  {
    return false;
  }
  memory.Walls = this->Number;
  memory.HasWall = false;
  if (block.Count == 2)
  {
    const LabelOrder first = this->Table.OrderOf(block.Label[0]);
    const LabelOrder second = this->Table.OrderOf(block.Label[1]);
    const bool isFirst = second < first;
    memory.HasWall = isFirst || first < second;
    std::copy_n(block.Planes[isFirst ? 0 : 1], LabelBlock::Taps, memory.Planes);
    memory.HasSteps = memory.Steps.Set(memory.Planes);
  }
  return true;
}

LabelWall LabelWalls::ComputeInBlock(const Vector3& index, WallMemory& memory) const noexcept
{
  const std::int64_t cell[3] = { static_cast<std::int64_t>(index.X),
    static_cast<std::int64_t>(index.Y), static_cast<std::int64_t>(index.Z) };
  const bool isKnown = memory.Walls == this->Number && cell[0] == memory.Cell[0] &&
    cell[1] == memory.Cell[1] && cell[2] == memory.Cell[2];
  LabelWeights weights;
  if (!isKnown)
  {
    LabelBlock block;
    this->Sampler.Collect(index, block);
    std::copy_n(cell, 3, memory.Cell);
    if (!this->Remember(block, memory))
    {
      this->Sampler.Weigh(index, weights);
      return this->FindNearest(block.Count, block.Label,
        [&](int i) { return this->Sampler.Fraction(weights, block.Planes[i]); });
    }
  }
  if (!memory.HasWall)
  {
    return {};
  }
  FieldSample fraction;
  if (memory.HasSteps)
  {
    fraction = this->Sampler.Fraction(index, memory.Steps);
  }
  else
  {
    this->Sampler.Weigh(index, weights);
    fraction = this->Sampler.Fraction(weights, memory.Planes);
  }
  return { true, 2.0 * fraction.Value - 1.0, 2.0 * fraction.Gradient };
}

LabelWall LabelWalls::ComputeInRuns(const Vector3& index) const noexcept
{
  Taps taps;
  taps.Count = this->Kernel.Taps;
  taps.Fractions = this->Fractions;
  const double position[3] = { index.X, index.Y, index.Z };
  for (int a = 0; a < 3; ++a)
  {
    const std::int64_t first = ComputeWeights(this->Kernel, position[a], taps.Weights[a]);
    const std::int64_t last = this->View.Dimensions[a] - 1;
    for (int i = 0; i < taps.Count; ++i)
    {
      taps.Place[a][i] = std::clamp<std::int64_t>(first + i, 0, last);
      taps.Offset[a][i] = taps.Place[a][i] * this->View.Stride[a];
    }
  }
  taps.Value[0] = taps.Slope[0] = 0.0;
  for (int i = 0; i < taps.Count; ++i)
  {
    taps.Value[i + 1] = taps.Value[i] + taps.Weights[0][i];
    taps.Slope[i + 1] = taps.Slope[i] + taps.Weights[0][taps.Count + i];
  }
  Around around;
  this->GatherFractions(this->View, taps, around);
  return this->FindNearest(
    around.Count, around.Labels, [&](int i) -> const FieldSample& { return around.Fractions[i]; });
}

template <typename F>
LabelWall LabelWalls::FindNearest(
  int count, const std::int64_t* labels, F&& fraction) const noexcept
{
  // Sort the labels, hardest first. There is a wall where the fractions of the hardest labels add
  // up to 1/2, unless the next label has the same place in the order. Use the nearest wall.
  LabelOrder order[LabelBlock::Most];
  int sorted[LabelBlock::Most];
  for (int i = 0; i < count; ++i)
  {
    order[i] = this->Table.OrderOf(labels[i]);
    sorted[i] = i;
    for (int at = i; at > 0 && order[sorted[at - 1]] < order[sorted[at]]; --at)
    {
      std::swap(sorted[at - 1], sorted[at]);
    }
  }
  LabelWall wall;
  double sum = 0.0;
  Vector3 gradient;
  double nearest = 2.0;
  for (int i = 0; i + 1 < count; ++i)
  {
    const FieldSample& part = fraction(sorted[i]);
    sum += part.Value;
    gradient += part.Gradient;
    const double value = 2.0 * sum - 1.0;
    if (order[sorted[i + 1]] < order[sorted[i]] && std::abs(value) < nearest)
    {
      nearest = std::abs(value);
      wall = { true, value, 2.0 * gradient };
    }
  }
  return wall;
}

} // namespace VolumeHaptics
