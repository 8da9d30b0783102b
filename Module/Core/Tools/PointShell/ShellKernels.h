// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The reading of the volume at many points at once, as templates. Included by one translation unit
 * per instruction set only; the rules of FieldKernels.h hold here too.
 */
#ifndef ShellKernels_h
#define ShellKernels_h

#include "Core/Field/LinearKernels.h"
#include "Core/Tools/PointShell/ShellReader.h"

namespace VolumeHaptics
{
namespace
{

/** Not loaded from an array, which the processor would have to wait for. */
VOLUME_HAPTICS_INLINE Double4 MakeDouble4(double a, double b, double c, double d)
{
#if defined(__GNUC__) && defined(__x86_64__) && defined(__AVX__)
  return Double4{ a, b, c, d };
#else
  return { { a, b, c, d } };
#endif
}

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
    const double offset = map[9 + row];
    return m[0] * tx + m[1] * ty + m[2] * tz + MakeDouble4(offset, offset, offset, offset);
  };
  double x[4];
  double y[4];
  double z[4];
  StoreDouble4(along(0), x);
  StoreDouble4(along(1), y);
  StoreDouble4(along(2), z);
  const std::int64_t sx = reading.View.Volume.Stride[0];
  const std::int64_t sy = reading.View.Volume.Stride[1];
  const std::int64_t sz = reading.View.Volume.Stride[2];
  const T* corner[4];
  double fx[4];
  double fy[4];
  double fz[4];
  for (int lane = 0; lane < 4; ++lane)
  {
    const CellPlace place = LocateCell(reading.View, x[lane], y[lane], z[lane]);
    corner[lane] = static_cast<const T*>(reading.View.Volume.Data) + place.X.Cell * sx +
      place.Y.Cell * sy + place.Z.Cell * sz;
    fx[lane] = place.X.Fraction;
    fy[lane] = place.Y.Fraction;
    fz[lane] = place.Z.Fraction;
  }
  const Double4 u = MakeDouble4(fx[0], fx[1], fx[2], fx[3]);
  const Double4 v = MakeDouble4(fy[0], fy[1], fy[2], fy[3]);
  const Double4 w = MakeDouble4(fz[0], fz[1], fz[2], fz[3]);
  const auto at = [&](std::int64_t i)
  {
    return MakeDouble4(static_cast<double>(corner[0][i]), static_cast<double>(corner[1][i]),
      static_cast<double>(corner[2][i]), static_cast<double>(corner[3][i]));
  };
  const auto line = [&](std::int64_t i)
  {
    const Double4 first = at(i);
    return first + u * (at(i + sx) - first);
  };
  const auto plane = [&](std::int64_t i)
  {
    const Double4 first = line(i);
    return first + v * (line(i + sy) - first);
  };
  const Double4 near = plane(0);
  double values[4];
  StoreDouble4(near + w * (plane(sz) - near), values);
  std::uint64_t mark = 0;
  for (int lane = 0; lane < 4; ++lane)
  {
    if constexpr (std::is_floating_point_v<T>)
    {
      if (!IsNumber(values[lane]))
      {
        // A sample that is not a number but has no weight does not count.
        values[lane] = Trilinear<T>(reading.View, x[lane], y[lane], z[lane]);
      }
    }
    mark |= MarkOf(reading, x[lane], y[lane], z[lane], values[lane]) << lane;
  }
  return mark;
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

/** Two neighbours along x, of each of four lines: the first ones, and the second ones. */
template <typename T>
VOLUME_HAPTICS_INLINE void LoadFourPairs(
  const T* const* lines, std::int64_t sx, Double4& first, Double4& second)
{
  const auto load = [lines](std::int64_t i)
  {
    return MakeDouble4(static_cast<double>(lines[0][i]), static_cast<double>(lines[1][i]),
      static_cast<double>(lines[2][i]), static_cast<double>(lines[3][i]));
  };
  first = load(0);
  second = load(sx);
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
  const T* const before[4] = { p - sx, p + sy - sx, p + sz - sx, p + sy + sz - sx };
  Double4 t0;
  Double4 t1;
  Double4 t2;
  Double4 t3;
  LoadFourPairs(inner, sx, t1, t2);
  LoadFourPairs(before, 3 * sx, t0, t3);
  const Double4 step = t2 - t1;
  const Double4 a = t1 + fx * step;
  const Double4 alongX = 0.5 * ((t2 + fx * (t3 - t2)) - (t0 + fx * (t1 - t0)));
  LoadFourPairs(besideY, sx, t0, t3);
  const Double4 b = t0 + fx * (t3 - t0);
  LoadFourPairs(besideZ, sx, t0, t3);
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

///@{
/** Of each lane; Larger and Smaller give the second one if a lane is NaN. */
#if defined(__GNUC__) && defined(__x86_64__) && defined(__AVX__)
VOLUME_HAPTICS_INLINE Double4 Root(const Double4& a)
{
  return _mm256_sqrt_pd(a);
}
VOLUME_HAPTICS_INLINE Double4 Over(const Double4& a, const Double4& b)
{
  return a / b;
}
VOLUME_HAPTICS_INLINE Double4 Larger(const Double4& a, const Double4& b)
{
  return a > b ? a : b;
}
VOLUME_HAPTICS_INLINE Double4 Smaller(const Double4& a, const Double4& b)
{
  return a < b ? a : b;
}
#else
template <typename F>
VOLUME_HAPTICS_INLINE Double4 EachLane(const Double4& a, const Double4& b, F&& f)
{
  return { { f(a[0], b[0]), f(a[1], b[1]), f(a[2], b[2]), f(a[3], b[3]) } };
}
VOLUME_HAPTICS_INLINE Double4 Root(const Double4& a)
{
  return EachLane(a, a, [](double x, double) { return __builtin_sqrt(x); });
}
VOLUME_HAPTICS_INLINE Double4 Over(const Double4& a, const Double4& b)
{
  return EachLane(a, b, [](double x, double y) { return x / y; });
}
VOLUME_HAPTICS_INLINE Double4 Larger(const Double4& a, const Double4& b)
{
  return EachLane(a, b, [](double x, double y) { return x > y ? x : y; });
}
VOLUME_HAPTICS_INLINE Double4 Smaller(const Double4& a, const Double4& b)
{
  return EachLane(a, b, [](double x, double y) { return x < y ? x : y; });
}
#endif
///@}

/** Four vectors. */
struct FourVectors
{
  Double4 X;
  Double4 Y;
  Double4 Z;
};
VOLUME_HAPTICS_INLINE FourVectors LoadVectors(const double (*from)[ShellBatch::Most], std::size_t i)
{
  return { LoadDouble4(from[0] + i), LoadDouble4(from[1] + i), LoadDouble4(from[2] + i) };
}
VOLUME_HAPTICS_INLINE void StoreVectors(
  const FourVectors& v, double (*to)[ShellBatch::Most], std::size_t i)
{
  StoreDouble4(v.X, to[0] + i);
  StoreDouble4(v.Y, to[1] + i);
  StoreDouble4(v.Z, to[2] + i);
}
VOLUME_HAPTICS_INLINE FourVectors Scaled(const Double4& s, const FourVectors& v)
{
  return { s * v.X, s * v.Y, s * v.Z };
}
VOLUME_HAPTICS_INLINE Double4 DotOf(const FourVectors& a, const FourVectors& b)
{
  return a.X * b.X + a.Y * b.Y + a.Z * b.Z;
}
/** A matrix by rows times vectors. */
VOLUME_HAPTICS_INLINE FourVectors Times(const double* m, const FourVectors& v)
{
  return { m[0] * v.X + m[1] * v.Y + m[2] * v.Z, m[3] * v.X + m[4] * v.Y + m[5] * v.Z,
    m[6] * v.X + m[7] * v.Y + m[8] * v.Z };
}

/** The feet of four points from what was read. */
VOLUME_HAPTICS_INLINE void ComputeFeet(
  const ShellReading& reading, const ShellFrame& frame, std::size_t i, ShellBatch& batch)
{
  const auto all = [](double x) { return MakeDouble4(x, x, x, x); };
  const FourVectors gradient = Times(frame.GradientToDevice, LoadVectors(batch.Gradient, i));
  const Double4 magnitude = Root(DotOf(gradient, gradient));
  const FourVectors normal = Scaled(Over(all(reading.Sign), magnitude), gradient);
  // Differences over two samples are less steep than the edge of a mask: by the slope of the cell
  // a step along the normal comes to the level.
  const Double4 slope =
    reading.Sign * DotOf(normal, Times(frame.GradientToDevice, LoadVectors(batch.Cell, i)));
  const Double4 steepest = frame.UnitsPerMeter * Larger(slope, magnitude);
  const Double4 beyond =
    Over(reading.Sign * (LoadDouble4(batch.Value + i) - all(reading.Level)), steepest);
  const Double4 step = Larger(Smaller(beyond, all(frame.Voxel)), all(-frame.Voxel));
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

template <typename T>
void ReadFeet(const ShellReading& reading, ShellBatch& batch) noexcept
{
  for (std::size_t i = 0; i < batch.Count; ++i)
  {
    double foot[7];
    ReadFoot<T>(reading.View, batch.Place[0][i], batch.Place[1][i], batch.Place[2][i], foot);
    batch.Value[i] = foot[0];
    for (int axis = 0; axis < 3; ++axis)
    {
      batch.Gradient[axis][i] = foot[1 + axis];
      batch.Cell[axis][i] = foot[4 + axis];
    }
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

template <typename T>
void ReadValues(
  const ShellReading& reading, const double* positions, std::size_t count, double* to) noexcept
{
  for (std::size_t i = 0; i < count; ++i)
  {
    const double value =
      Trilinear<T>(reading.View, positions[3 * i], positions[3 * i + 1], positions[3 * i + 2]);
    to[i] = IsNumber(value) ? value : reading.View.Volume.BorderValue;
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
