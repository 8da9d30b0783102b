// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The kernels of LabelSampler, as templates. The rules in FieldKernels.h also apply here.
 */
#ifndef LabelKernels_h
#define LabelKernels_h

#include "Core/Field/Kernels/LabelRows.h"
#include "Core/Field/Kernels/LinearKernels.h"
#include "Core/Field/Kernels/SeparableSum.h"
#include "Core/Field/LabelSampler.h"
#include "Core/Field/LabelSamples.h"
#include "Core/Math/LowestBit.h"

namespace VolumeHaptics
{
namespace
{

constexpr int LabelTaps = LabelBlock::Taps;

/**
 * A block of 8^3 voxels in memory. Its samples are read as unsigned numbers of the same size as the
 * label's type.
 */
template <typename U>
struct LabelCorner
{
  const U* First;
  std::int64_t Line;
  std::int64_t Plane;

  U At(int i, int j, int k) const { return this->First[i + j * this->Line + k * this->Plane]; }
};

/** One sample for each label that a block contains. */
template <typename U>
struct LabelsFound
{
  U Sample[LabelBlock::Most];
  int Count;
};

/** Sets the bits of the voxels that have a label. */
template <typename U>
VOLUME_HAPTICS_INLINE void MarkPlanes(const LabelCorner<U>& corner, U label, std::uint64_t* planes)
{
  const Labels all = Repeat(label);
  for (int k = 0; k < LabelTaps; ++k)
  {
    planes[k] = 0;
    for (int v = 0; v < VectorsOfPlane<U>; ++v)
    {
      const Labels vector = LoadVector(corner.First + k * corner.Plane, corner.Line, v);
      planes[k] |= ToBits<U>(Equal<U>(vector, all)) << (v * LabelsOfVector<U>);
    }
  }
}

/** Collects all labels after the first one, label by label. */
template <typename U>
VOLUME_HAPTICS_OUTLINE void CollectFurtherLabels(
  const LabelCorner<U>& corner, LabelBlock& block, LabelsFound<U>& found)
{
  std::uint64_t rest[LabelTaps];
  for (int k = 0; k < LabelTaps; ++k)
  {
    rest[k] = ~block.Planes[0][k];
  }
  for (int k = 0; k < LabelTaps;)
  {
    if (rest[k] == 0)
    {
      ++k;
      continue;
    }
    const int voxel = LowestBit(rest[k]);
    const U label = corner.At(voxel % LabelTaps, voxel / LabelTaps, k);
    std::uint64_t* const planes = block.Planes[found.Count];
    found.Sample[found.Count++] = label;
    const bool isLast = found.Count == LabelBlock::Most;
    MarkPlanes(corner, label, planes);
    for (int plane = 0; plane < LabelTaps; ++plane)
    {
      planes[plane] = isLast ? rest[plane] : planes[plane];
      rest[plane] &= ~planes[plane];
    }
  }
}

/**
 * Collects the labels of a block. A block with only two labels a and b is recognised in one pass,
 * because then x ^ a is 0 or a ^ b for each voxel x.
 */
template <typename U>
VOLUME_HAPTICS_INLINE void CollectFrom(
  const LabelCorner<U>& corner, LabelBlock& block, LabelsFound<U>& found)
{
  const U first = corner.At(0, 0, 0);
  const Labels all = Repeat(first);
  Labels some = XorLabels(all, all);
  Labels every = Equal<U>(all, all);
  const U* plane = corner.First;
  for (int k = 0; k < LabelTaps; ++k, plane += corner.Plane)
  {
    std::uint64_t bits = 0;
#pragma GCC unroll 4
    for (int v = 0; v < VectorsOfPlane<U>; ++v)
    {
      const Labels vector = LoadVector(plane, corner.Line, v);
      const Labels mask = Equal<U>(vector, all);
      const Labels difference = XorLabels(vector, all);
      some = OrLabels(some, difference);
      every = AndLabels(every, OrLabels(mask, difference));
      bits |= ToBits<U>(mask) << (v * LabelsOfVector<U>);
    }
    block.Planes[0][k] = bits;
    block.Planes[1][k] = ~bits;
  }
  const U any = JoinLabels<U>(some, [](std::uint64_t a, std::uint64_t b) { return a | b; });
  const U common = JoinLabels<U>(every, [](std::uint64_t a, std::uint64_t b) { return a & b; });
  found.Sample[0] = first;
  found.Sample[1] = static_cast<U>(first ^ any);
  found.Count = any == 0 ? 1 : 2;
  if (any != 0 && any != common)
  {
    found.Count = 1;
    CollectFurtherLabels(corner, block, found);
  }
}

/**
 * Collects the labels from a copy of the block. This is needed at the border, where taps outside
 * repeat the last voxel, and if the samples of a row are not adjacent in memory.
 */
template <typename U>
VOLUME_HAPTICS_OUTLINE void CollectFromCopy(
  const VolumeView& view, const std::int64_t* first, LabelBlock& block, LabelsFound<U>& found)
{
  std::int64_t offset[3][LabelTaps];
  for (int a = 0; a < 3; ++a)
  {
    for (int i = 0; i < LabelTaps; ++i)
    {
      offset[a][i] = ClampedOffset(view, a, first[a] + i);
    }
  }
  U copy[LabelTaps * LabelTaps * LabelTaps];
  U* to = copy;
  for (int k = 0; k < LabelTaps; ++k)
  {
    for (int j = 0; j < LabelTaps; ++j)
    {
      const U* const from = static_cast<const U*>(view.Data) + offset[2][k] + offset[1][j];
      for (int i = 0; i < LabelTaps; ++i)
      {
        *to++ = from[offset[0][i]];
      }
    }
  }
  CollectFrom<U>({ copy, LabelTaps, LabelTaps * LabelTaps }, block, found);
}

template <typename U>
VOLUME_HAPTICS_INLINE void CollectLabels(
  const LabelField& view, double x, double y, double z, LabelBlock& block, LabelsFound<U>& found)
{
  const VolumeView& volume = view.Volume;
  const double position[3] = { x, y, z };
  std::int64_t first[3];
  bool fits = volume.Stride[0] == 1;
  for (int a = 0; a < 3; ++a)
  {
    first[a] = static_cast<std::int64_t>(position[a]) - (LabelTaps / 2 - 1);
    fits = fits && first[a] >= 0 && first[a] + LabelTaps <= volume.Dimensions[a];
  }
  if (!fits)
  {
    CollectFromCopy<U>(volume, first, block, found);
    return;
  }
  const U* const corner = static_cast<const U*>(volume.Data) + first[0] +
    first[1] * volume.Stride[1] + first[2] * volume.Stride[2];
  CollectFrom<U>({ corner, volume.Stride[1], volume.Stride[2] }, block, found);
}

/** Computes the weights of the taps along an axis, followed by their slopes. */
VOLUME_HAPTICS_INLINE void WeighTaps(const double* table, double position, double* weights)
{
  constexpr int intervals = LabelField::Intervals;
  constexpr double scale = intervals;
  const double place = position * scale;
  const double interval = Floor(place);
  const double t = place - interval;
  const double twice = 2.0 * scale * t;
  const double thrice = 3.0 * scale * t * t;
  const double* const c = table +
    (static_cast<std::uint64_t>(static_cast<std::int64_t>(interval)) % intervals) *
      LabelField::Coefficients * LabelTaps;
  for (int i = 0; i < LabelTaps; i += 4)
  {
    const auto term = [&](int power) { return LoadDouble4(c + power * LabelTaps + i); };
    StoreDouble4((term(0) + t * term(1)) + (t * t) * (term(2) + t * term(3)), weights + i);
    StoreDouble4((scale * term(1) + twice * term(2)) + thrice * term(3), weights + LabelTaps + i);
  }
}

/**
 * For each pattern of four bits, sums the weights whose bits are set, and the slopes of these
 * weights. A row of `table` is value, slope, value, 0.
 */
VOLUME_HAPTICS_INLINE void TabulateSums(const double* weights, double (*table)[4])
{
  Double4 sums[LabelWeights::Patterns];
  sums[0] = Double4{ 0.0, 0.0, 0.0, 0.0 };
#pragma GCC unroll 4
  for (int bit = 0; bit < 4; ++bit)
  {
    const double value = weights[bit];
    const Double4 weight = { value, weights[LabelTaps + bit], value, 0.0 };
    const int count = 1 << bit;
#pragma GCC unroll 8
    for (int pattern = 0; pattern < count; ++pattern)
    {
      sums[count + pattern] = sums[pattern] + weight;
    }
  }
#pragma GCC unroll 16
  for (int pattern = 0; pattern < LabelWeights::Patterns; ++pattern)
  {
    StoreDouble4(sums[pattern], table[pattern]);
  }
}

/** Computes the factors of the rows and of the planes. */
template <typename Weights>
VOLUME_HAPTICS_INLINE void WeighRows(const double* table, double y, double z, Weights& weights)
{
  alignas(32) double across[2 * LabelTaps];
  WeighTaps(table, y, across);
  for (int j = 0; j < LabelTaps; ++j)
  {
    const double value = across[j];
    StoreDouble4(Double4{ value, value, across[LabelTaps + j], 0.0 }, weights.Across[j]);
  }
  WeighTaps(table, z, weights.Along);
}

void WeighLabels(
  const LabelField& view, double x, double y, double z, LabelWeights& weights) noexcept
{
  alignas(32) double across[2 * LabelTaps];
  WeighTaps(view.Table, x, across);
  TabulateSums(across, weights.Low);
  TabulateSums(across + 4, weights.High);
  WeighRows(view.Table, y, z, weights);
}

template <typename T>
using LabelBits = std::conditional_t<sizeof(T) == 1, std::uint8_t,
  std::conditional_t<sizeof(T) == 2, std::uint16_t,
    std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>>>;

template <typename T>
void CollectLabelsOf(
  const LabelField& view, double x, double y, double z, LabelBlock& block) noexcept
{
  LabelsFound<LabelBits<T>> found;
  CollectLabels(view, x, y, z, block, found);
  block.Count = found.Count;
  for (int i = 0; i < found.Count; ++i)
  {
    T sample;
    std::memcpy(&sample, &found.Sample[i], sizeof(sample));
    block.Label[i] = ToLabel(sample);
  }
}

/**
 * Returns the sums for a pattern. `pattern` has the pattern's number (0 to 15) in its upper four
 * bits.
 */
VOLUME_HAPTICS_INLINE const double* PatternAt(const double (*table)[4], std::uint8_t pattern)
{
  constexpr std::size_t bytes = sizeof(*table) / LabelWeights::Patterns;
  return reinterpret_cast<const double*>(
    reinterpret_cast<const char*>(table) + bytes * std::size_t(pattern));
}

/** Adds up the sums of all rows. row(j, k) returns the sums of one row: value, slope, value. */
template <typename Weights, typename F>
VOLUME_HAPTICS_INLINE FieldSample SumRows(const Weights& weights, F&& row)
{
  Double4 sum = { 0.0, 0.0, 0.0, 0.0 };
  Double4 slope = { 0.0, 0.0, 0.0, 0.0 };
  for (int k = 0; k < LabelTaps; ++k)
  {
    const auto part = [&](int j) { return LoadDouble4(weights.Across[j]) * row(j, k); };
    const Double4 plane =
      ((part(0) + part(1)) + (part(2) + part(3))) + ((part(4) + part(5)) + (part(6) + part(7)));
    sum = sum + weights.Along[k] * plane;
    slope = slope + weights.Along[LabelTaps + k] * plane;
  }
  FieldSample fraction;
  fraction.Value = sum[0];
  fraction.Gradient.X = sum[1];
  fraction.Gradient.Y = sum[2];
  fraction.Gradient.Z = slope[0];
  return fraction;
}

FieldSample FractionOf(const LabelWeights& weights, const std::uint64_t* planes) noexcept
{
  return SumRows(weights,
    [&](int j, int k)
    {
      // Shift the upper and the lower halves of all rows of a plane to the bits that PatternAt()
      // reads.
      constexpr std::uint64_t half = 0xF0F0F0F0F0F0F0F0U;
      const std::uint64_t low = (planes[k] << 4) & half;
      const std::uint64_t high = planes[k] & half;
      const double* const first =
        PatternAt(weights.Low, static_cast<std::uint8_t>(low >> (LabelTaps * j)));
      const double* const last =
        PatternAt(weights.High, static_cast<std::uint8_t>(high >> (LabelTaps * j)));
      return LoadDouble4(first) + LoadDouble4(last);
    });
}

FieldSample FractionOfSteps(
  const LabelField& view, double x, double y, double z, const LabelSteps& steps) noexcept
{
  StepWeights weights;
  alignas(32) double across[2 * LabelTaps];
  WeighTaps(view.Table, x, across);
  Double4 first = { 0.0, 0.0, 0.0, 0.0 };
  Double4 last = first;
  StoreDouble4(first, weights.Sums[0]);
  StoreDouble4(last, weights.Sums[StepWeights::Ends]);
  for (int count = 1; count <= LabelTaps; ++count)
  {
    const int i = count - 1;
    const int j = LabelTaps - count;
    first = first + Double4{ across[i], across[LabelTaps + i], across[i], 0.0 };
    last = last + Double4{ across[j], across[LabelTaps + j], across[j], 0.0 };
    StoreDouble4(first, weights.Sums[count]);
    StoreDouble4(last, weights.Sums[StepWeights::Ends + count]);
  }
  WeighRows(view.Table, y, z, weights);
  const char* const sums = reinterpret_cast<const char*>(weights.Sums);
  return SumRows(weights,
    [&](int j, int k)
    { return LoadDouble4(reinterpret_cast<const double*>(sums + steps.Place[k][j])); });
}

/** Returns the functions of this translation unit's instruction set. */
LabelFunctions SelectLabelFunctions(ScalarType type)
{
  return WithSampleType(type,
    [](auto sample) -> LabelFunctions {
      return { CollectLabelsOf<decltype(sample)>, WeighLabels, FractionOf, FractionOfSteps };
    });
}

} // namespace
} // namespace VolumeHaptics

#endif
