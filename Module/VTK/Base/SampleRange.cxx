// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Base/SampleRange.h"

#include "VTK/Base/vtkVolumeHapticsCompat.h"

#include "vtkDataArray.h"
#include "vtkSMPTools.h"
#include "vtkSOADataArrayTemplate.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <type_traits>
#include <vector>

namespace VolumeHaptics
{
namespace
{

/** Samples that are compared at once, by the processor's wide instructions. */
constexpr std::int64_t Lanes = 32;
/** Samples that one thread scans at a time, some tenths of a millisecond; a multiple of Lanes. */
constexpr std::int64_t PieceSize = std::int64_t{ 1 } << 20;

/** The range so far in each lane; before the first value, the lower end is the larger. */
template <typename T>
struct LaneRanges
{
  using Limits = std::numeric_limits<T>;
  static constexpr T Highest = Limits::has_infinity ? Limits::infinity() : Limits::max();
  static constexpr T Lowest = Limits::has_infinity ? -Limits::infinity() : Limits::lowest();

  LaneRanges()
  {
    std::fill(std::begin(this->Low), std::end(this->Low), Highest);
    std::fill(std::begin(this->High), std::end(this->High), Lowest);
  }

  /** NaN is neither smaller nor larger than anything. */
  void Add(T value, std::int64_t lane)
  {
    this->Low[lane] = value < this->Low[lane] ? value : this->Low[lane];
    this->High[lane] = value > this->High[lane] ? value : this->High[lane];
  }
  void AddFinite(T value, std::int64_t lane)
  {
    const bool isFinite = value >= Limits::lowest() && value <= Limits::max();
    this->Low[lane] = isFinite && value < this->Low[lane] ? value : this->Low[lane];
    this->High[lane] = isFinite && value > this->High[lane] ? value : this->High[lane];
  }

  /** Adds the ranges of a later piece. */
  void Merge(const LaneRanges& later)
  {
    for (std::int64_t lane = 0; lane < Lanes; ++lane)
    {
      this->Low[lane] = std::min(this->Low[lane], later.Low[lane]);
      this->High[lane] = std::max(this->High[lane], later.High[lane]);
    }
  }

  T Low[Lanes];
  T High[Lanes];
};

template <bool OnlyFinite, typename T>
LaneRanges<T> ScanPiece(const T* data, std::int64_t count, std::int64_t stride)
{
  LaneRanges<T> lanes;
  const auto add = [&lanes](T value, std::int64_t lane)
  {
    if constexpr (OnlyFinite && std::is_floating_point_v<T>)
    {
      lanes.AddFinite(value, lane);
    }
    else
    {
      lanes.Add(value, lane);
    }
  };
  std::int64_t at = 0;
  if (stride == 1)
  {
    for (; at + Lanes <= count; at += Lanes)
    {
      for (std::int64_t lane = 0; lane < Lanes; ++lane)
      {
        add(data[at + lane], lane);
      }
    }
  }
  for (; at < count; ++at)
  {
    add(data[at * stride], at % Lanes);
  }
  return lanes;
}

template <bool OnlyFinite, typename T>
void ScanRange(const T* data, std::int64_t count, std::int64_t stride, double range[2])
{
  // On all cores: of a volume that is mapped from a file, most of the time goes into its pages.
  std::vector<LaneRanges<T>> pieces(static_cast<std::size_t>((count + PieceSize - 1) / PieceSize));
  vtkSMPTools::For(0, static_cast<vtkIdType>(pieces.size()), 1,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType piece = begin; piece < end; ++piece)
      {
        const std::int64_t first = PieceSize * piece;
        pieces[static_cast<std::size_t>(piece)] =
          ScanPiece<OnlyFinite>(data + first * stride, std::min(PieceSize, count - first), stride);
      }
    });
  LaneRanges<T> lanes;
  for (const LaneRanges<T>& piece : pieces)
  {
    lanes.Merge(piece);
  }
  const T low = *std::min_element(std::begin(lanes.Low), std::end(lanes.Low));
  const T high = *std::max_element(std::begin(lanes.High), std::end(lanes.High));
  if (low <= high)
  {
    range[0] = static_cast<double>(low);
    range[1] = static_cast<double>(high);
  }
}

/** False for other memory layouts. */
template <bool OnlyFinite, typename T>
bool ScanComponent(vtkDataArray* array, int component, double range[2])
{
  using SeparateComponents = vtkSOADataArrayTemplate<T>;
  const T* data = nullptr;
  std::int64_t stride = array->GetNumberOfComponents();
  if (array->HasStandardMemoryLayout())
  {
    const T* const first = static_cast<const T*>(array->GetVoidPointer(0));
    data = first ? first + component : nullptr;
  }
  else if (auto* const separate = SeparateComponents::FastDownCast(array))
  {
    data =
      HasSeparateComponents(separate) ? separate->GetComponentArrayPointer(component) : nullptr;
    stride = 1;
  }
  if (data)
  {
    ScanRange<OnlyFinite>(data, array->GetNumberOfTuples(), stride, range);
  }
  return data != nullptr;
}

template <bool OnlyFinite>
void ScanArray(vtkDataArray* array, int component, double range[2])
{
  range[0] = 1.0;
  range[1] = 0.0;
  bool isScanned = false;
  if (component < array->GetNumberOfComponents())
  {
    switch (array->GetDataType())
    {
      vtkTemplateMacro(isScanned = (ScanComponent<OnlyFinite, VTK_TT>(array, component, range)));
      default:
        break;
    }
  }
  if (!isScanned)
  {
    OnlyFinite ? array->GetFiniteRange(range, component) : array->GetRange(range, component);
  }
}

} // namespace

void FindRange(vtkDataArray* array, int component, double range[2])
{
  ScanArray<false>(array, component, range);
}

void FindFiniteRange(vtkDataArray* array, int component, double range[2])
{
  ScanArray<true>(array, component, range);
}

} // namespace VolumeHaptics
