// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Four doubles as a plain struct, for compilers and processors without AVX. Only Double4.h includes
 * this file.
 */
#ifndef Double4Portable_h
#define Double4Portable_h

#include "Core/Math/KernelFloor.h"
#include "Core/Math/KernelInline.h"

#include <cmath>
#include <cstdint>

namespace VolumeHaptics
{
namespace
{

struct Double4
{
  double Lane[4];

  double operator[](int i) const { return this->Lane[i]; }
  double& operator[](int i) { return this->Lane[i]; }
};
VOLUME_HAPTICS_INLINE Double4 operator*(double s, const Double4& a)
{
  return { { s * a[0], s * a[1], s * a[2], s * a[3] } };
}
VOLUME_HAPTICS_INLINE Double4 operator*(const Double4& a, const Double4& b)
{
  return { { a[0] * b[0], a[1] * b[1], a[2] * b[2], a[3] * b[3] } };
}
VOLUME_HAPTICS_INLINE Double4 operator+(const Double4& a, const Double4& b)
{
  return { { a[0] + b[0], a[1] + b[1], a[2] + b[2], a[3] + b[3] } };
}
VOLUME_HAPTICS_INLINE Double4 operator-(const Double4& a, const Double4& b)
{
  return { { a[0] - b[0], a[1] - b[1], a[2] - b[2], a[3] - b[3] } };
}

VOLUME_HAPTICS_INLINE Double4 operator/(const Double4& a, const Double4& b)
{
  return { { a[0] / b[0], a[1] / b[1], a[2] / b[2], a[3] / b[3] } };
}
VOLUME_HAPTICS_INLINE Double4 MakeDouble4(double a, double b, double c, double d)
{
  return { { a, b, c, d } };
}

///@{
/**
 * Functions that work lane by lane. Larger() and Smaller() return the second argument if a lane is
 * NaN.
 */
template <typename F>
VOLUME_HAPTICS_INLINE Double4 EachLane(const Double4& a, const Double4& b, F&& f)
{
  return { { f(a[0], b[0]), f(a[1], b[1]), f(a[2], b[2]), f(a[3], b[3]) } };
}
VOLUME_HAPTICS_INLINE Double4 Root(const Double4& a)
{
  return EachLane(a, a, [](double x, double) { return std::sqrt(x); });
}
VOLUME_HAPTICS_INLINE Double4 Larger(const Double4& a, const Double4& b)
{
  return EachLane(a, b, [](double x, double y) { return x > y ? x : y; });
}
VOLUME_HAPTICS_INLINE Double4 Smaller(const Double4& a, const Double4& b)
{
  return EachLane(a, b, [](double x, double y) { return x < y ? x : y; });
}
VOLUME_HAPTICS_INLINE Double4 Floor(const Double4& a)
{
  return EachLane(a, a, [](double x, double) { return Floor(x); });
}
///@}

///@{
/**
 * Return for each lane x if a > b (ChooseAbove) or a == b (ChooseEqual), otherwise y; also y if a
 * or b is NaN.
 */
VOLUME_HAPTICS_INLINE Double4 ChooseAbove(
  const Double4& a, const Double4& b, const Double4& x, const Double4& y)
{
  return { { a[0] > b[0] ? x[0] : y[0], a[1] > b[1] ? x[1] : y[1], a[2] > b[2] ? x[2] : y[2],
    a[3] > b[3] ? x[3] : y[3] } };
}
VOLUME_HAPTICS_INLINE Double4 ChooseEqual(
  const Double4& a, const Double4& b, const Double4& x, const Double4& y)
{
  return { { a[0] == b[0] ? x[0] : y[0], a[1] == b[1] ? x[1] : y[1], a[2] == b[2] ? x[2] : y[2],
    a[3] == b[3] ? x[3] : y[3] } };
}
///@}

/** Stores lanes that are whole numbers below 2^51. */
VOLUME_HAPTICS_INLINE void StoreWhole(const Double4& from, std::int64_t* to)
{
  for (int lane = 0; lane < 4; ++lane)
  {
    to[lane] = static_cast<std::int64_t>(from[lane]);
  }
}
///@{
/**
 * Return one bit for each lane, the lowest for the first lane. The bit is set where the condition
 * holds; it is 0 for NaN.
 */
VOLUME_HAPTICS_INLINE std::uint64_t NotNegative(const Double4& a)
{
  std::uint64_t bits = 0;
  for (int lane = 0; lane < 4; ++lane)
  {
    bits |= static_cast<std::uint64_t>(a[lane] >= 0.0 ? 1 : 0) << lane;
  }
  return bits;
}
VOLUME_HAPTICS_INLINE std::uint64_t IsAbove(const Double4& a, const Double4& b)
{
  std::uint64_t bits = 0;
  for (int lane = 0; lane < 4; ++lane)
  {
    bits |= static_cast<std::uint64_t>(a[lane] > b[lane] ? 1 : 0) << lane;
  }
  return bits;
}
VOLUME_HAPTICS_INLINE std::uint64_t IsEqual(const Double4& a, const Double4& b)
{
  std::uint64_t bits = 0;
  for (int lane = 0; lane < 4; ++lane)
  {
    bits |= static_cast<std::uint64_t>(a[lane] == b[lane] ? 1 : 0) << lane;
  }
  return bits;
}
///@}

template <typename T>
VOLUME_HAPTICS_INLINE Double4 LoadDouble4(const T* from)
{
  return { { static_cast<double>(from[0]), static_cast<double>(from[1]),
    static_cast<double>(from[2]), static_cast<double>(from[3]) } };
}

///@{
/** Load or store the first two lanes at `low` and the last two lanes at `high`. */
VOLUME_HAPTICS_INLINE Double4 LoadHalves(const double* low, const double* high)
{
  return { { low[0], low[1], high[0], high[1] } };
}
VOLUME_HAPTICS_INLINE void StoreHalves(const Double4& from, double* low, double* high)
{
  low[0] = from[0];
  low[1] = from[1];
  high[0] = from[2];
  high[1] = from[3];
}
///@}

/**
 * Loads two consecutive samples from each of four addresses. `first` gets the first sample of each
 * pair, and `second` the second one.
 */
template <typename T>
VOLUME_HAPTICS_INLINE void LoadFourPairs(
  const T* a, const T* b, const T* c, const T* d, Double4& first, Double4& second)
{
  const T* const places[4] = { a, b, c, d };
  for (int lane = 0; lane < 4; ++lane)
  {
    first.Lane[lane] = static_cast<double>(places[lane][0]);
    second.Lane[lane] = static_cast<double>(places[lane][1]);
  }
}

VOLUME_HAPTICS_INLINE Double4 Spread(const double* from)
{
  return { { *from, *from, *from, *from } };
}
/** Returns the first two lanes of `low` and the last two lanes of `high`. */
VOLUME_HAPTICS_INLINE Double4 JoinHalves(const Double4& low, const Double4& high)
{
  return { { low[0], low[1], high[2], high[3] } };
}
/** Returns the first two lanes of both arguments. */
VOLUME_HAPTICS_INLINE Double4 JoinLow(const Double4& a, const Double4& b)
{
  return { { a[0], a[1], b[0], b[1] } };
}
/** Returns the last two lanes of both arguments. */
VOLUME_HAPTICS_INLINE Double4 JoinHigh(const Double4& a, const Double4& b)
{
  return { { a[2], a[3], b[2], b[3] } };
}
/**
 * Transposes four vectors: a gets the first lanes of all arguments, b the second lanes, and so on.
 */
VOLUME_HAPTICS_INLINE void Transpose(Double4& a, Double4& b, Double4& c, Double4& d)
{
  const Double4 rows[4] = { a, b, c, d };
  Double4* const columns[4] = { &a, &b, &c, &d };
  for (int i = 0; i < 4; ++i)
  {
    *columns[i] = { { rows[0][i], rows[1][i], rows[2][i], rows[3][i] } };
  }
}

///@{
/**
 * Returns the sum of the lanes, added in a fixed order: lanes 0 and 2, lanes 1 and 3, then both
 * sums.
 */
VOLUME_HAPTICS_INLINE double AddLanes(const Double4& a)
{
  return (a[0] + a[2]) + (a[1] + a[3]);
}
VOLUME_HAPTICS_INLINE void AddLanes(
  const Double4& a, const Double4& b, const Double4& c, const Double4& d, double* sums)
{
  sums[0] = AddLanes(a);
  sums[1] = AddLanes(b);
  sums[2] = AddLanes(c);
  sums[3] = AddLanes(d);
}
///@}

} // namespace
} // namespace VolumeHaptics

#endif
