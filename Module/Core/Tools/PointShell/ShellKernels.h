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
#include "Core/Tools/PointShell/ShellReader.h"

namespace VolumeHaptics
{
namespace
{

/** The mark of one point from its index and the trilinear value there. */
VOLUME_HAPTICS_INLINE std::uint64_t MarkOf(
  const ShellReading& reading, double x, double y, double z, double value)
{
  const bool isInside = x >= 0.0 && y >= 0.0 && z >= 0.0 && x <= reading.Border[0] &&
    y <= reading.Border[1] && z <= reading.Border[2];
  // False for NaN.
  const bool isBeyond = reading.Sign * (value - reading.Level) >= 0.0;
  return isInside && isBeyond ? 1 : 0;
}

/** The marks of four points. */
template <typename T>
VOLUME_HAPTICS_INLINE std::uint64_t MarkFour(const ShellReading& reading, const double* px,
  const double* py, const double* pz, const double* map)
{
  const Double4 tx = LoadDouble4(px);
  const Double4 ty = LoadDouble4(py);
  const Double4 tz = LoadDouble4(pz);
  const auto along = [&](int row)
  {
    const double* const m = map + 3 * row;
    return m[0] * tx + m[1] * ty + m[2] * tz + Spread(map[9 + row]);
  };
  const Double4 x = along(0);
  const Double4 y = along(1);
  const Double4 z = along(2);
  const FieldView& view = reading.View;
  const std::int64_t sy = view.Volume.Stride[1];
  const std::int64_t sz = view.Volume.Stride[2];
  const FourCells<T> at = FindCells<T>(view, x, y, z);
  const auto line = [&](std::int64_t i)
  {
    Double4 first;
    Double4 second;
    LoadFourPairs(at, i, first, second);
    return first + at.X.Fraction * (second - first);
  };
  const auto plane = [&](std::int64_t i)
  {
    const Double4 first = line(i);
    return first + at.Y.Fraction * (line(i + sy) - first);
  };
  const Double4 near = plane(0);
  Double4 values = near + at.Z.Fraction * (plane(sz) - near);
  if constexpr (std::is_floating_point_v<T>)
  {
    for (int lane = 0; lane < 4; ++lane)
    {
      if (!IsNumber(values[lane]))
      {
        // A sample that is not a number but has no weight does not count.
        values[lane] = Trilinear<T>(view, x[lane], y[lane], z[lane]);
      }
    }
  }
  const auto isWithin = [](const Double4& p, double border)
  { return NotNegative(p) & NotNegative(Spread(border) - p); };
  return isWithin(x, reading.Border[0]) & isWithin(y, reading.Border[1]) &
    isWithin(z, reading.Border[2]) & NotNegative(reading.Sign * (values - Spread(reading.Level)));
}

template <typename T>
std::uint64_t MarkPoints(
  const ShellReading& reading, const ShellNumbers& points, const double* map) noexcept
{
  std::uint64_t mark = 0;
  std::size_t i = 0;
  for (; i + 4 <= points.Count; i += 4)
  {
    mark |= MarkFour<T>(reading, points.X + i, points.Y + i, points.Z + i, map) << i;
  }
  for (; i < points.Count; ++i)
  {
    const double px = points.X[i];
    const double py = points.Y[i];
    const double pz = points.Z[i];
    const double x = map[0] * px + map[1] * py + map[2] * pz + map[9];
    const double y = map[3] * px + map[4] * py + map[5] * pz + map[10];
    const double z = map[6] * px + map[7] * py + map[8] * pz + map[11];
    mark |= MarkOf(reading, x, y, z, Trilinear<T>(reading.View, x, y, z)) << i;
  }
  return mark;
}

template <typename T>
bool IsAnySolid(
  const ShellReading& reading, const std::int64_t* low, const std::int64_t* high) noexcept
{
  const std::int64_t* const stride = reading.View.Volume.Stride;
  for (std::int64_t k = low[2]; k <= high[2]; ++k)
  {
    for (std::int64_t j = low[1]; j <= high[1]; ++j)
    {
      const T* const line =
        static_cast<const T*>(reading.View.Volume.Data) + k * stride[2] + j * stride[1];
      bool isSolid = false;
      for (std::int64_t i = low[0]; i <= high[0]; ++i)
      {
        const auto value = static_cast<double>(line[i * stride[0]]);
        isSolid = isSolid || reading.Sign * (value - reading.Level) >= 0.0;
      }
      if (isSolid)
      {
        return true;
      }
    }
  }
  return false;
}

/** Value and gradient from positions that are clamped to the samples one by one. */
template <typename T>
VOLUME_HAPTICS_OUTLINE void ReadFootAtBorder(
  const FieldView& view, double x, double y, double z, double* to)
{
  double values[6];
  for (int i = 0; i < 6; ++i)
  {
    const double step = i % 2 == 0 ? -1.0 : 1.0;
    const int axis = i / 2;
    values[i] = Trilinear<T>(
      view, axis == 0 ? x + step : x, axis == 1 ? y + step : y, axis == 2 ? z + step : z);
  }
  to[0] = Trilinear<T>(view, x, y, z);
  for (int axis = 0; axis < 3; ++axis)
  {
    to[1 + axis] = to[4 + axis] = 0.5 * (values[2 * axis + 1] - values[2 * axis]);
  }
}

/**
 * The seven interpolations of a value and its central differences share their weights, since the
 * differences reach over one sample to either side: 32 samples are enough.
 */
template <typename T>
VOLUME_HAPTICS_INLINE void ReadFoot(const FieldView& view, double x, double y, double z, double* to)
{
  const auto& [ax, ay, az] = LocateCell(view, x, y, z);
  const auto isWithin = [&view](std::int64_t cell, int axis)
  {
    const auto place = static_cast<double>(cell);
    return place >= view.First[axis] + 1.0 && place <= view.Last[axis] - 2.0;
  };
  if (!isWithin(ax.Cell, 0) || !isWithin(ay.Cell, 1) || !isWithin(az.Cell, 2))
  {
    ReadFootAtBorder<T>(view, x, y, z, to);
    return;
  }
  const std::int64_t sx = view.Volume.Stride[0];
  const std::int64_t sy = view.Volume.Stride[1];
  const std::int64_t sz = view.Volume.Stride[2];
  const T* const p =
    static_cast<const T*>(view.Volume.Data) + ax.Cell * sx + ay.Cell * sy + az.Cell * sz;
  const double fx = ax.Fraction;
  const double fy = ay.Fraction;
  const double fz = az.Fraction;
  const double ey = 1.0 - fy;
  const double ez = 1.0 - fz;
  // Four lines along x each: those of the cell, those beside it along y, and those along z.
  const T* const inner[4] = { p, p + sy, p + sz, p + sy + sz };
  const T* const besideY[4] = { p - sy, p - sy + sz, p + 2 * sy, p + 2 * sy + sz };
  const T* const besideZ[4] = { p - sz, p - sz + sy, p + 2 * sz, p + 2 * sz + sy };
  Double4 t0;
  Double4 t1;
  Double4 t2;
  Double4 t3;
  LoadFourPairs(inner, -sx, sx, t0, t1);
  LoadFourPairs(inner, sx, sx, t2, t3);
  const Double4 step = t2 - t1;
  const Double4 a = t1 + fx * step;
  const Double4 alongX = 0.5 * ((t2 + fx * (t3 - t2)) - (t0 + fx * (t1 - t0)));
  LoadFourPairs(besideY, 0, sx, t0, t3);
  const Double4 b = t0 + fx * (t3 - t0);
  LoadFourPairs(besideZ, 0, sx, t0, t3);
  const Double4 c = t0 + fx * (t3 - t0);
  const Double4 cell = MakeDouble4(ey * ez, fy * ez, ey * fz, fy * fz);
  const Double4 innerY = MakeDouble4(-fy * ez, ey * ez, -fy * fz, ey * fz);
  const Double4 outerY = MakeDouble4(-ey * ez, -ey * fz, fy * ez, fy * fz);
  const Double4 innerZ = MakeDouble4(-ey * fz, -fy * fz, ey * ez, fy * ez);
  const Double4 outerZ = MakeDouble4(-ey * ez, -fy * ez, ey * fz, fy * fz);
  AddLanes(
    cell * a, cell * alongX, 0.5 * (innerY * a + outerY * b), 0.5 * (innerZ * a + outerZ * c), to);
  double own[4];
  AddLanes(cell * step, MakeDouble4(-ez, ez, -fz, fz) * a, MakeDouble4(-ey, -fy, ey, fy) * a,
    cell * a, own);
  to[4] = own[0];
  to[5] = own[1];
  to[6] = own[2];
  if constexpr (std::is_floating_point_v<T>)
  {
    if (!IsNumber(to[0] + to[1] + to[2] + to[3]))
    {
      // A sample that is not a number but has no weight does not count.
      ReadFootAtBorder<T>(view, x, y, z, to);
    }
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

template <typename T>
void ReadOneFoot(const ShellReading& reading, double x, double y, double z, double* to) noexcept
{
  ReadFoot<T>(reading.View, x, y, z, to);
}

/** As ReadFoot, of four points at a time. False if one of them is at the border. */
template <typename T>
VOLUME_HAPTICS_INLINE bool ReadFourFeet(const FieldView& view, std::size_t i, ShellBatch& batch)
{
  const FourVectors place = LoadVectors(batch.Place, i);
  const FourCells<T> at = FindCells<T>(view, place.X, place.Y, place.Z);
  const auto isWithin = [&view](const FourPlaces& p, int axis)
  {
    return NotNegative(p.Cell - Spread(view.First[axis] + 1.0)) &
      NotNegative(Spread(view.Last[axis] - 2.0) - p.Cell);
  };
  constexpr std::uint64_t all = 0b1111;
  if ((isWithin(at.X, 0) & isWithin(at.Y, 1) & isWithin(at.Z, 2)) != all)
  {
    return false;
  }
  const std::int64_t sx = view.Volume.Stride[0];
  const std::int64_t sy = view.Volume.Stride[1];
  const std::int64_t sz = view.Volume.Stride[2];
  const Double4 fx = at.X.Fraction;
  const Double4 fy = at.Y.Fraction;
  const Double4 fz = at.Z.Fraction;
  const Double4 one = Spread(1.0);
  const Double4 ey = one - fy;
  const Double4 ez = one - fz;
  const auto minus = [](const Double4& a) { return -1.0 * a; };
  const std::int64_t inner[4] = { 0, sy, sz, sy + sz };
  const std::int64_t besideY[4] = { -sy, -sy + sz, 2 * sy, 2 * sy + sz };
  const std::int64_t besideZ[4] = { -sz, -sz + sy, 2 * sz, 2 * sz + sy };
  const Double4 cell[4] = { ey * ez, fy * ez, ey * fz, fy * fz };
  const Double4 innerY[4] = { minus(cell[1]), cell[0], minus(cell[3]), cell[2] };
  const Double4 outerY[4] = { minus(cell[0]), minus(cell[2]), cell[1], cell[3] };
  const Double4 innerZ[4] = { minus(cell[2]), minus(cell[3]), cell[0], cell[1] };
  const Double4 outerZ[4] = { minus(cell[0]), minus(cell[1]), cell[2], cell[3] };
  const Double4 cellY[4] = { minus(ez), ez, minus(fz), fz };
  const Double4 cellZ[4] = { minus(ey), minus(fy), ey, fy };
  // What ReadFoot has in its lanes, line by line.
  Double4 terms[7][4];
  for (int line = 0; line < 4; ++line)
  {
    Double4 t0;
    Double4 t1;
    Double4 t2;
    Double4 t3;
    LoadFourPairs(at, inner[line] - sx, t0, t1);
    LoadFourPairs(at, inner[line] + sx, t2, t3);
    const Double4 step = t2 - t1;
    const Double4 a = t1 + fx * step;
    terms[0][line] = cell[line] * a;
    terms[1][line] = cell[line] * (0.5 * ((t2 + fx * (t3 - t2)) - (t0 + fx * (t1 - t0))));
    LoadFourPairs(at, besideY[line], t0, t3);
    terms[2][line] = 0.5 * (innerY[line] * a + outerY[line] * (t0 + fx * (t3 - t0)));
    LoadFourPairs(at, besideZ[line], t0, t3);
    terms[3][line] = 0.5 * (innerZ[line] * a + outerZ[line] * (t0 + fx * (t3 - t0)));
    terms[4][line] = cell[line] * step;
    terms[5][line] = cellY[line] * a;
    terms[6][line] = cellZ[line] * a;
  }
  double* const to[7] = { batch.Value, batch.Gradient[0], batch.Gradient[1], batch.Gradient[2],
    batch.Cell[0], batch.Cell[1], batch.Cell[2] };
  for (int n = 0; n < 7; ++n)
  {
    StoreDouble4((terms[n][0] + terms[n][2]) + (terms[n][1] + terms[n][3]), to[n] + i);
  }
  return true;
}

template <typename T>
void ReadFeet(const ShellReading& reading, ShellBatch& batch) noexcept
{
  const auto readOne = [&](std::size_t i)
  {
    double foot[7];
    ReadFoot<T>(reading.View, batch.Place[0][i], batch.Place[1][i], batch.Place[2][i], foot);
    batch.Value[i] = foot[0];
    for (int axis = 0; axis < 3; ++axis)
    {
      batch.Gradient[axis][i] = foot[1 + axis];
      batch.Cell[axis][i] = foot[4 + axis];
    }
  };
  std::size_t i = 0;
  for (; i + 4 <= batch.Count; i += 4)
  {
    const bool isRead = ReadFourFeet<T>(reading.View, i, batch);
    for (std::size_t n = i; n < i + 4; ++n)
    {
      // ReadFoot knows what to do with samples that are no numbers.
      const bool isDone = isRead &&
        (!std::is_floating_point_v<T> ||
          IsNumber(
            batch.Value[n] + batch.Gradient[0][n] + batch.Gradient[1][n] + batch.Gradient[2][n]));
      if (!isDone)
      {
        readOne(n);
      }
    }
  }
  for (; i < batch.Count; ++i)
  {
    readOne(i);
  }
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
      return ShellFunctions{ MarkPoints<T>, IsAnySolid<T>, ReadOneFoot<T>, ReadFeet<T>, FindFeet,
        ReadValues<T>, AddForces };
    });
}

} // namespace
} // namespace VolumeHaptics

#endif
