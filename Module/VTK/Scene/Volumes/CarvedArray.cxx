// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/Volumes/CarvedArray.h"

#include "Core/Field/CarvedSamples.h"

#include "vtkSetGet.h"

#include <algorithm>

namespace VolumeHaptics
{
namespace
{

/** Calls f(value, component) for the values of a box with the remaining tissue, tuple by tuple. */
template <typename T, typename F>
void ForEachLeft(
  const CarvedArray& carved, std::uint32_t brick, BrickContent content, const ArrayBox& box, F&& f)
{
  constexpr std::int64_t mask = CarvedBricks::Side - 1;
  const CarvedBricks& bricks = carved.Removal->Bricks;
  const CarvedView view{ &bricks, carved.Air };
  vtkDataArray* const array = carved.Array;
  const int components = array->GetNumberOfComponents();
  const T* const values =
    array->HasStandardMemoryLayout() ? static_cast<const T*>(array->GetVoidPointer(0)) : nullptr;
  const std::int64_t x = carved.First[0] + box.Low[0];
  for (std::int64_t k = box.Low[2]; k < box.Low[2] + box.Size[2]; ++k)
  {
    for (std::int64_t j = box.Low[1]; j < box.Low[1] + box.Size[1]; ++j)
    {
      const std::int64_t y = (carved.First[1] + j) & mask;
      const std::int64_t z = (carved.First[2] + k) & mask;
      std::uint64_t fractions = content == BrickContent::Whole
        ? CarvedBricks::WholeRow
        : bricks.GetRow(brick, static_cast<int>(y + CarvedBricks::Side * z)) >> (8 * (x & mask));
      const std::int64_t tuple = box.Low[0] + carved.Dimensions[0] * (j + carved.Dimensions[1] * k);
      for (std::int64_t i = 0; i < box.Size[0]; ++i, fractions >>= 8)
      {
        const auto fraction = static_cast<std::uint8_t>(fractions);
        for (int c = 0; c < components; ++c)
        {
          const T value = values ? values[(tuple + i) * components + c]
                                 : static_cast<T>(array->GetComponent(tuple + i, c));
          const bool isLess = c == carved.Component && fraction != CarvedBricks::Whole;
          f(isLess ? NearestOf<T>(view.Left(static_cast<double>(value), fraction)) : value, c);
        }
      }
    }
  }
}

template <typename T>
T* Reserve(const CarvedArray& carved, const ArrayBox& box, std::vector<unsigned char>& to)
{
  const std::int64_t values = box.Samples() * carved.Array->GetNumberOfComponents();
  to.resize(static_cast<std::size_t>(values) * sizeof(T));
  return reinterpret_cast<T*>(to.data());
}

template <typename T>
void CopyAs(const CarvedArray& carved, std::uint32_t brick, BrickContent content,
  const ArrayBox& box, std::vector<unsigned char>& to)
{
  T* next = Reserve<T>(carved, box, to);
  ForEachLeft<T>(carved, brick, content, box, [&next](T value, int) { *next++ = value; });
}

template <typename T>
void CopyFloats(const CarvedArray& carved, std::uint32_t brick, BrickContent content,
  const ArrayBox& box, const float* scale, const float* bias, std::vector<unsigned char>& to)
{
  auto* next = Reserve<float>(carved, box, to);
  ForEachLeft<T>(carved, brick, content, box,
    [&](T value, int c)
    { *next++ = static_cast<float>(static_cast<double>(value) * scale[c] + bias[c]); });
}

} // namespace

bool ComputeBrickBox(const CarvedArray& carved, std::uint32_t brick, ArrayBox& box)
{
  const BrickPlace place = CarvedBricks::PlaceOf(carved.Removal->Bricks.GetKey(brick));
  const std::int64_t places[3] = { place.X, place.Y, place.Z };
  for (int a = 0; a < 3; ++a)
  {
    const std::int64_t first = CarvedBricks::Side * places[a] - carved.First[a];
    box.Low[a] = std::max<std::int64_t>(first, 0);
    box.Size[a] = std::min(first + CarvedBricks::Side, carved.Dimensions[a]) - box.Low[a];
    if (box.Size[a] <= 0)
    {
      return false;
    }
  }
  return true;
}

void CopyBrick(const CarvedArray& carved, std::uint32_t brick, BrickContent content,
  const ArrayBox& box, std::vector<unsigned char>& to)
{
  switch (carved.Array->GetDataType())
  {
    vtkTemplateMacro(CopyAs<VTK_TT>(carved, brick, content, box, to));
    default:
      break;
  }
}

void CopyBrickAsFloat(const CarvedArray& carved, std::uint32_t brick, BrickContent content,
  const ArrayBox& box, const float* scale, const float* bias, std::vector<unsigned char>& to)
{
  switch (carved.Array->GetDataType())
  {
    vtkTemplateMacro(CopyFloats<VTK_TT>(carved, brick, content, box, scale, bias, to));
    default:
      break;
  }
}

} // namespace VolumeHaptics
