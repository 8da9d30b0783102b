// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Reads the volume at many points at once. The functions are templates, and only one translation
 * unit for each instruction set may include this file. The rules in FieldKernels.h also apply here.
 */
#ifndef ShellKernels_h
#define ShellKernels_h

#include "Core/Math/LowestBit.h"
#include "Core/Tools/PointShell/FourCells.h"
#include "Core/Tools/PointShell/ShellFootKernels.h"
#include "Core/Tools/PointShell/ShellLawKernels.h"
#include "Core/Tools/PointShell/ShellMarkKernels.h"
#include "Core/Tools/PointShell/ShellReader.h"

#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace VolumeHaptics
{
namespace
{

void PlacePoints(
  const ShellFrame& frame, const ShellPlacement& placement, ShellBatch& batch) noexcept
{
  for (std::size_t i = batch.Count; i % 4 != 0; ++i)
  {
    batch.Before[i] = batch.Before[0];
    for (int axis = 0; axis < 3; ++axis)
    {
      batch.Position[axis][i] = 0.0;
    }
  }
  const double* const offset = placement.ToolToIndex + 9;
  for (std::size_t i = 0; i < batch.Count; i += 4)
  {
    const FourVectors position = LoadVectors(batch.Position, i);
    FourVectors way;
    Double4 was;
    LoadContacts(batch.Before + i, 0, way.X, way.Y, way.Z, was);
    StoreVectors(way, batch.Offset, i);
    StoreDouble4(was, batch.Was + i);
    const FourVectors from = Times(frame.DeviceToIndex, way);
    const FourVectors turned = Times(placement.ToolToIndex, position);
    const FourVectors index = { turned.X + Spread(offset[0]), turned.Y + Spread(offset[1]),
      turned.Z + Spread(offset[2]) };
    StoreVectors(index, batch.Index, i);
    StoreVectors({ index.X - from.X, index.Y - from.Y, index.Z - from.Z }, batch.Place, i);
    StoreVectors(Times(placement.ToolToDevice, position), batch.Arm, i);
  }
}

/**
 * Computes the feet of four points from the samples. Returns one bit for each point that may be in
 * contact.
 */
VOLUME_HAPTICS_INLINE std::uint64_t ComputeFeet(
  const ShellReading& reading, const ShellFrame& frame, std::size_t i, ShellBatch& batch)
{
  const FourVectors gradient = Times(frame.GradientToDevice, LoadVectors(batch.Gradient, i));
  const Double4 magnitude = Root(DotOf(gradient, gradient));
  const FourVectors normal = Scaled(Spread(reading.Sign) / magnitude, gradient);
  // Differences over two samples are less steep than the edge of a mask, so use the slope in the
  // cell for the step along the normal to the level.
  const Double4 slope =
    reading.Sign * DotOf(normal, Times(frame.GradientToDevice, LoadVectors(batch.Cell, i)));
  const Double4 steepest = frame.UnitsPerMeter * Larger(slope, magnitude);
  const Double4 value = LoadDouble4(batch.Value + i);
  const Double4 beyond = reading.Sign * (value - Spread(reading.Level)) / steepest;
  const Double4 step = Larger(Smaller(beyond, Spread(frame.Voxel)), Spread(-frame.Voxel));
  const Double4 depth = step + DotOf(LoadVectors(batch.Offset, i), normal);
  const FourVectors along = Times(frame.DeviceToIndex, normal);
  const FourVectors index = LoadVectors(batch.Index, i);
  const FourVectors foot = { index.X - depth * along.X, index.Y - depth * along.Y,
    index.Z - depth * along.Z };
  const Double4 reach = frame.KernelRadius > 0.0
    ? Spread(frame.KernelRadius) / Root(DotOf(along, along))
    : Spread(frame.KernelLength);
  StoreVectors(normal, batch.Normal, i);
  StoreDouble4(magnitude, batch.Magnitude + i);
  StoreDouble4(beyond, batch.Beyond + i);
  StoreDouble4(depth, batch.Depth + i);
  StoreVectors(foot, batch.Foot, i);
  StoreVectors({ foot.X + reach * along.X, foot.Y + reach * along.Y, foot.Z + reach * along.Z },
    batch.Behind, i);
  // The comparisons are false for NaN, too: without a gradient there is no contact.
  const Double4 floor = 1e-12 * Larger(value, -1.0 * value);
  const std::uint64_t isRising = IsAbove(magnitude, floor) & IsAbove(Spread(HUGE_VAL), magnitude);
  const std::uint64_t isDeep = IsAbove(depth, Spread(0.0)) & batch.Solid >> i;
  return isRising & (isDeep | IsAbove(depth, Spread(frame.Voxel)));
}

std::uint64_t ComputeAllFeet(
  const ShellReading& reading, const ShellFrame& frame, ShellBatch& batch) noexcept
{
  for (std::size_t i = batch.Count; i % 4 != 0; ++i)
  {
    batch.Value[i] = 0.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      batch.Gradient[axis][i] = batch.Cell[axis][i] = 0.0;
      batch.Index[axis][i] = batch.Offset[axis][i] = 0.0;
    }
  }
  std::uint64_t there = 0;
  for (std::size_t i = 0; i < batch.Count; i += 4)
  {
    there |= ComputeFeet(reading, frame, i, batch) << i;
  }
  return there & FirstBits(batch.Count);
}

/** Computes as many rows of AddFunction's sums as there are registers for. */
template <int First, int Last>
VOLUME_HAPTICS_INLINE void AddRows(const ShellPushes& forces, double* gradient, double* curvature)
{
  constexpr int begin = First * (First + 1) / 2;
  constexpr int count = Last * (Last + 1) / 2 - begin;
  Double4 ofGradient[Last - First];
  Double4 ofCurvature[count];
  for (Double4& sum : ofGradient)
  {
    sum = Spread(0.0);
  }
  for (Double4& sum : ofCurvature)
  {
    sum = Spread(0.0);
  }
  for (std::size_t i = 0; i < forces.Count; i += 4)
  {
    const Double4 force = LoadDouble4(forces.Force + i);
    const Double4 stiffness = LoadDouble4(forces.Stiffness + i);
    VOLUME_HAPTICS_UNROLL
    for (int row = First; row < Last; ++row)
    {
      const Double4 w = LoadDouble4(forces.Wrench[row] + i);
      ofGradient[row - First] = ofGradient[row - First] + force * w;
      const Double4 scaled = stiffness * w;
      VOLUME_HAPTICS_UNROLL
      for (int column = 0; column <= row; ++column)
      {
        Double4& sum = ofCurvature[row * (row + 1) / 2 + column - begin];
        sum = sum + scaled * LoadDouble4(forces.Wrench[column] + i);
      }
    }
  }
  for (int i = 0; i < Last - First; ++i)
  {
    gradient[First + i] += AddLanes(ofGradient[i]);
  }
  for (int i = 0; i < count; ++i)
  {
    curvature[begin + i] += AddLanes(ofCurvature[i]);
  }
}

void AddForces(const ShellPushes& forces, double* gradient, double* curvature) noexcept
{
  AddRows<0, 3>(forces, gradient, curvature);
  AddRows<3, 5>(forces, gradient, curvature);
  AddRows<5, 6>(forces, gradient, curvature);
}

/** Like Trilinear(), for four indices at a time. */
template <typename T, bool IsRow>
VOLUME_HAPTICS_INLINE Double4 ReadFourValues(const FieldView& view, const FourVectors& indices)
{
  const FourCells<T> at = ComputeCells<T>(view, indices.X, indices.Y, indices.Z);
  const std::int64_t sy = view.Volume.Stride[1];
  const std::int64_t sz = view.Volume.Stride[2];
  const auto between = [&at](std::int64_t line, std::int64_t beside, const Double4& fraction,
                         Double4& first, Double4& second)
  {
    Double4 a;
    Double4 b;
    LoadFourPairs<IsRow>(at, line, first, second);
    LoadFourPairs<IsRow>(at, line + beside, a, b);
    first = first + fraction * (a - first);
    second = second + fraction * (b - second);
  };
  Double4 near[2];
  Double4 far[2];
  between(0, sz, at.Z.Fraction, near[0], near[1]);
  between(sy, sz, at.Z.Fraction, far[0], far[1]);
  const Double4 a = near[0] + at.Y.Fraction * (far[0] - near[0]);
  const Double4 b = near[1] + at.Y.Fraction * (far[1] - near[1]);
  return a + at.X.Fraction * (b - a);
}

template <typename T>
void ReadValues(const ShellReading& reading, const ShellNumbers& indices, double* to) noexcept
{
  const auto readOne = [&](std::size_t i)
  {
    const double value = Trilinear<T>(reading.View, indices.X[i], indices.Y[i], indices.Z[i]);
    to[i] = IsNumber(value) ? value : reading.View.Volume.BorderValue;
  };
  const bool isRow = HasRows(reading.View);
  std::size_t i = 0;
  for (; i + 4 <= indices.Count; i += 4)
  {
    const FourVectors four{ LoadDouble4(indices.X + i), LoadDouble4(indices.Y + i),
      LoadDouble4(indices.Z + i) };
    StoreDouble4(isRow ? ReadFourValues<T, true>(reading.View, four)
                       : ReadFourValues<T, false>(reading.View, four),
      to + i);
    for (std::size_t n = i; std::is_floating_point_v<T> && n < i + 4; ++n)
    {
      if (!IsNumber(to[n]))
      {
        readOne(n); // ignores samples with the weight 0, which may be NaN
      }
    }
  }
  for (; i < indices.Count; ++i)
  {
    readOne(i);
  }
}

/** Returns the functions of this translation unit's instruction set. */
ShellFunctions SelectFunctionsOfShell(ScalarType type)
{
  return WithSampleType(type,
    [](auto sample)
    {
      using T = decltype(sample);
      return ShellFunctions{ MarkPoints<T>, UpdateMarks<T>, IsAnySolid<T>, ComputeMostSlopes<T>,
        PlacePoints, ReadOneFoot<T>, ReadFeet<T>, ComputeAllFeet, ReadValues<T>, HoldPoints,
        AddForces };
    });
}

} // namespace
} // namespace VolumeHaptics

#endif
