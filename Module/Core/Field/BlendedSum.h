// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The sum over N^3 taps of two frames, blended:
 *
 *   V_i = a_i + share (b_i - a_i)
 *
 * Samples that are the same in both frames stay as they are, to the bit. The rules of
 * FieldKernels.h hold here too.
 */
#ifndef BlendedSum_h
#define BlendedSum_h

#include "Core/Field/SeparableSum.h"

namespace VolumeHaptics
{
namespace
{

/** Blends the rows of another frame into these. */
template <int N>
VOLUME_HAPTICS_INLINE void BlendRows(const RowPair<N>& other, double share, RowPair<N>& rows)
{
  for (int p = 0; p < RowPair<N>::Whole; ++p)
  {
    rows.Even[p] = rows.Even[p] + share * (other.Even[p] - rows.Even[p]);
    rows.Odd[p] = rows.Odd[p] + share * (other.Odd[p] - rows.Odd[p]);
  }
  if constexpr (RowPair<N>::HasRest)
  {
    rows.Rest = rows.Rest + share * (other.Rest - rows.Rest);
  }
}

/** N^3 samples of a frame, one behind another along x. */
template <typename T>
struct TapBlock
{
  const T* Corner;
  std::int64_t Line;
  std::int64_t Plane;
};

template <typename T, int N>
VOLUME_HAPTICS_INLINE void LoadRows(const TapBlock<T>& block, int k, int j, RowPair<N>& rows)
{
  const T* const even = block.Corner + k * block.Plane + j * block.Line;
  LoadRows<T, N>(even, even + block.Line, rows);
}

template <typename T, int N, bool WithGradient>
VOLUME_HAPTICS_INLINE double SumBlend(const TapBlock<T>& first, const TapBlock<T>& second,
  double share, const Footprint<N>& foot, Vector3* gradient)
{
  return SumPlanes<N, WithGradient>(
    [&](int k, int j, RowPair<N>& rows)
    {
      RowPair<N> other;
      LoadRows<T, N>(first, k, j, rows);
      LoadRows<T, N>(second, k, j, other);
      BlendRows<N>(other, share, rows);
    },
    foot, gradient);
}

/** The sum over copies of the taps, see CopyTaps. */
template <typename T, int N, bool WithGradient>
VOLUME_HAPTICS_OUTLINE double SumBlendOfCopies(
  const FrameBlend& blend, const Footprint<N>& foot, Vector3* gradient)
{
  T blocks[2][N * N * N];
  CopyTaps<T, N>(blend.First.Volume, foot, blocks[0]);
  CopyTaps<T, N>(blend.Second.Volume, foot, blocks[1]);
  return SumBlend<T, N, WithGradient>(
    { blocks[0], N, N * N }, { blocks[1], N, N * N }, blend.Share, foot, gradient);
}

/** The sum without memories. */
template <typename T, int N, bool WithGradient>
VOLUME_HAPTICS_OUTLINE double SumBlendOfSamples(
  const FrameBlend& blend, const Footprint<N>& foot, Vector3* gradient)
{
  const VolumeView& a = blend.First.Volume;
  const VolumeView& b = blend.Second.Volume;
  const T* const first = FindCorner<T, N>(a, foot.First);
  const T* const second = FindCorner<T, N>(b, foot.First);
  if (first && second)
  {
    if constexpr (N > 4)
    {
      PrefetchRows(first, N, a.Stride[1], a.Stride[2]);
      PrefetchRows(second, N, b.Stride[1], b.Stride[2]);
    }
    const double value = SumBlend<T, N, WithGradient>({ first, a.Stride[1], a.Stride[2] },
      { second, b.Stride[1], b.Stride[2] }, blend.Share, foot, gradient);
    if (!std::is_floating_point_v<T> || IsNumber(value))
    {
      return value;
    }
  }
  return SumBlendOfCopies<T, N, WithGradient>(blend, foot, gradient);
}

/** The memory that is a blend's; null if there is none. */
VOLUME_HAPTICS_INLINE const BlendMemory* FindBlend(
  const FrameBlend& blend, const std::int64_t* first, const TickMemory& tick)
{
  for (const BlendMemory& memory : tick.Blends)
  {
    if (HoldsTaps(memory, blend.First.Number, first) && memory.SecondField == blend.Second.Number &&
      memory.Share == blend.Share)
    {
      return &memory;
    }
  }
  return nullptr;
}

/** Gives the older memory to a blend. */
VOLUME_HAPTICS_INLINE BlendMemory& BeginBlend(
  const FrameBlend& blend, const std::int64_t* first, TickMemory& tick)
{
  BlendMemory& memory = tick.Blends[tick.OldBlend];
  tick.OldBlend = 1 - tick.OldBlend;
  SetPlace(blend.First.Number, first, memory);
  memory.SecondField = blend.Second.Number;
  memory.Share = blend.Share;
  return memory;
}

/** From the memories: from the blend, or from both frames, whose blend is kept. */
template <typename T, int N>
VOLUME_HAPTICS_INLINE bool SumRememberedBlend(const FrameBlend& blend, const Footprint<N>& foot,
  const BlendMemories& memories, FieldSample& sample)
{
  const BlendMemory* const known =
    memories.KeepsBlend ? FindBlend(blend, foot.First, *memories.Tick) : nullptr;
  if (known)
  {
    sample.Value = SumTaps<N>(known->Taps, foot, &sample.Gradient);
    return IsNumber(sample.Value);
  }
  TapMemory& first = *memories.First;
  TapMemory& second = *memories.Second;
  if (!KeepTaps(blend.First, foot.First, FillTaps<T, N>, first) ||
    !KeepTaps(blend.Second, foot.First, FillTaps<T, N>, second))
  {
    return false;
  }
  const auto load = [&](int at, RowPair<N>& rows)
  {
    RowPair<N> other;
    LoadStoredRows<N>(first.Taps + at, rows);
    LoadStoredRows<N>(second.Taps + at, other);
    BlendRows<N>(other, blend.Share, rows);
  };
  if (!memories.KeepsBlend)
  {
    sample.Value = SumPlanes<N, true>(
      [&](int k, int j, RowPair<N>& rows) { load((k * N + j) * N, rows); }, foot, &sample.Gradient);
    return IsNumber(sample.Value);
  }
  BlendMemory& kept = BeginBlend(blend, foot.First, *memories.Tick);
  sample.Value = SumPlanes<N, true>(
    [&](int k, int j, RowPair<N>& rows)
    {
      const int at = (k * N + j) * N;
      load(at, rows);
      StoreRows<N>(rows, kept.Taps + at);
    },
    foot, &sample.Gradient);
  return IsNumber(sample.Value);
}

/** The gradient of a blend. */
template <typename T, int N>
VOLUME_HAPTICS_INLINE FieldSample SumBlendedGradient(
  const FrameBlend& blend, const Footprint<N>& foot, const BlendMemories& memories)
{
  FieldSample sample;
  if constexpr (N <= TapMemory::MostTaps)
  {
    if (memories.Tick && SumRememberedBlend<T, N>(blend, foot, memories, sample))
    {
      return sample;
    }
  }
  sample.Value = SumBlendOfSamples<T, N, true>(blend, foot, &sample.Gradient);
  return sample;
}

} // namespace
} // namespace VolumeHaptics

#endif
