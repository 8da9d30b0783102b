// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The reading of the volume at many points at once, as templates. Included by one translation unit
 * per instruction set only; the rules of FieldKernels.h hold here too.
 */
#ifndef ShellKernels_h
#define ShellKernels_h

#include "Core/Tools/PointShell/FourCells.h"
#include "Core/Tools/PointShell/ShellFootKernels.h"
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
    for (int axis = 0; axis < 3; ++axis)
    {
      batch.Position[axis][i] = batch.Offset[axis][i] = 0.0;
    }
  }
  const double* const offset = placement.ToolToIndex + 9;
  for (std::size_t i = 0; i < batch.Count; i += 4)
  {
    const FourVectors position = LoadVectors(batch.Position, i);
    const FourVectors from = Times(frame.DeviceToIndex, LoadVectors(batch.Offset, i));
    const FourVectors turned = Times(placement.ToolToIndex, position);
    const FourVectors index = { turned.X + Spread(offset[0]), turned.Y + Spread(offset[1]),
      turned.Z + Spread(offset[2]) };
    StoreVectors(index, batch.Index, i);
    StoreVectors({ index.X - from.X, index.Y - from.Y, index.Z - from.Z }, batch.Place, i);
    StoreVectors(Times(placement.ToolToDevice, position), batch.Arm, i);
  }
}

/** The feet of four points from what was read. */
VOLUME_HAPTICS_INLINE void ComputeFeet(
  const ShellReading& reading, const ShellFrame& frame, std::size_t i, ShellBatch& batch)
{
  const FourVectors gradient = Times(frame.GradientToDevice, LoadVectors(batch.Gradient, i));
  const Double4 magnitude = Root(DotOf(gradient, gradient));
  const FourVectors normal = Scaled(Spread(reading.Sign) / magnitude, gradient);
  // Differences over two samples are less steep than the edge of a mask: by the slope of the cell
  // a step along the normal comes to the level.
  const Double4 slope =
    reading.Sign * DotOf(normal, Times(frame.GradientToDevice, LoadVectors(batch.Cell, i)));
  const Double4 steepest = frame.UnitsPerMeter * Larger(slope, magnitude);
  const Double4 beyond =
    reading.Sign * (LoadDouble4(batch.Value + i) - Spread(reading.Level)) / steepest;
  const Double4 step = Larger(Smaller(beyond, Spread(frame.Voxel)), Spread(-frame.Voxel));
  const Double4 depth = step + DotOf(LoadVectors(batch.Offset, i), normal);
  const FourVectors along = Times(frame.DeviceToIndex, normal);
  const FourVectors index = LoadVectors(batch.Index, i);
  const FourVectors foot = { index.X - depth * along.X, index.Y - depth * along.Y,
    index.Z - depth * along.Z };
  const double reach = frame.KernelLength;
  StoreVectors(normal, batch.Normal, i);
  StoreDouble4(magnitude, batch.Magnitude + i);
  StoreDouble4(beyond, batch.Beyond + i);
  StoreDouble4(depth, batch.Depth + i);
  StoreVectors(foot, batch.Foot, i);
  StoreVectors({ foot.X + reach * along.X, foot.Y + reach * along.Y, foot.Z + reach * along.Z },
    batch.Behind, i);
}

void FindFeet(const ShellReading& reading, const ShellFrame& frame, ShellBatch& batch) noexcept
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
  for (std::size_t i = 0; i < batch.Count; i += 4)
  {
    ComputeFeet(reading, frame, i, batch);
  }
}

void AddForces(const ShellPushes& forces, double* gradient, double* curvature) noexcept
{
  const Double4 zero = MakeDouble4(0.0, 0.0, 0.0, 0.0);
  Double4 ofGradient[6];
  Double4 ofCurvature[21];
  for (Double4& sum : ofGradient)
  {
    sum = zero;
  }
  for (Double4& sum : ofCurvature)
  {
    sum = zero;
  }
  for (std::size_t i = 0; i < forces.Count; i += 4)
  {
    const auto load = [i](const double* from) { return LoadDouble4(from + i); };
    const Double4 nx = load(forces.Normal[0]);
    const Double4 ny = load(forces.Normal[1]);
    const Double4 nz = load(forces.Normal[2]);
    const Double4 ax = load(forces.Arm[0]);
    const Double4 ay = load(forces.Arm[1]);
    const Double4 az = load(forces.Arm[2]);
    const Double4 w[6] = { nx, ny, nz, ay * nz - az * ny, az * nx - ax * nz, ax * ny - ay * nx };
    const Double4 force = load(forces.Force);
    const Double4 stiffness = load(forces.Stiffness);
    Double4* sum = ofCurvature;
    for (int row = 0; row < 6; ++row)
    {
      ofGradient[row] = ofGradient[row] + force * w[row];
      const Double4 scaled = stiffness * w[row];
      for (int column = 0; column <= row; ++column, ++sum)
      {
        *sum = *sum + scaled * w[column];
      }
    }
  }
  for (int i = 0; i < 6; ++i)
  {
    gradient[i] += AddLanes(ofGradient[i]);
  }
  for (int i = 0; i < 21; ++i)
  {
    curvature[i] += AddLanes(ofCurvature[i]);
  }
}

/** As Trilinear, of four positions at a time. */
template <typename T>
VOLUME_HAPTICS_INLINE Double4 ReadFourValues(const FieldView& view, const double* positions)
{
  const auto along = [positions](int axis)
  {
    return MakeDouble4(
      positions[axis], positions[3 + axis], positions[6 + axis], positions[9 + axis]);
  };
  const FourCells<T> at = FindCells<T>(view, along(0), along(1), along(2));
  const std::int64_t sy = view.Volume.Stride[1];
  const std::int64_t sz = view.Volume.Stride[2];
  const auto between = [&at](std::int64_t line, std::int64_t beside, const Double4& fraction,
                         Double4& first, Double4& second)
  {
    Double4 a;
    Double4 b;
    LoadFourPairs(at, line, first, second);
    LoadFourPairs(at, line + beside, a, b);
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
void ReadValues(
  const ShellReading& reading, const double* positions, std::size_t count, double* to) noexcept
{
  const auto readOne = [&](std::size_t i)
  {
    const double value =
      Trilinear<T>(reading.View, positions[3 * i], positions[3 * i + 1], positions[3 * i + 2]);
    to[i] = IsNumber(value) ? value : reading.View.Volume.BorderValue;
  };
  std::size_t i = 0;
  for (; i + 4 <= count; i += 4)
  {
    StoreDouble4(ReadFourValues<T>(reading.View, positions + 3 * i), to + i);
    for (std::size_t n = i; std::is_floating_point_v<T> && n < i + 4; ++n)
    {
      if (!IsNumber(to[n]))
      {
        readOne(n); // a sample that is not a number but has no weight does not count
      }
    }
  }
  for (; i < count; ++i)
  {
    readOne(i);
  }
}

/** The functions of this translation unit's instruction set. */
ShellFunctions SelectFunctionsOfShell(ScalarType type)
{
  return WithSampleType(type,
    [](auto sample)
    {
      using T = decltype(sample);
      return ShellFunctions{ MarkPoints<T>, UpdateMarks<T>, IsAnySolid<T>, FindMostSlopes<T>,
        PlacePoints, ReadOneFoot<T>, ReadFeet<T>, FindFeet, ReadValues<T>, AddForces };
    });
}

} // namespace
} // namespace VolumeHaptics

#endif
