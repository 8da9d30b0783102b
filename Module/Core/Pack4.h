// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Four doubles at a time. With GCC and Clang a vector type that compiles to whatever the
 * translation unit's instruction set has; elsewhere a plain struct with the same results.
 */
#ifndef Pack4_h
#define Pack4_h

#include <cstdint>
#include <cstring>

// The kernels must be inlined whole into their translation unit: an out-of-line copy made by the
// AVX2 unit could be picked by the linker for the baseline one.
#if defined(__GNUC__)
#define VOLUME_HAPTICS_INLINE static inline __attribute__((always_inline))
#else
#define VOLUME_HAPTICS_INLINE static inline
#endif

namespace VolumeHaptics
{
namespace
{

/** False for NaN and infinities. Not std::isfinite: see FieldKernels.h. */
VOLUME_HAPTICS_INLINE bool IsNumber(double x)
{
  return x - x == 0.0;
}

#if defined(__GNUC__)
typedef double Pack4 __attribute__((vector_size(32)));

template <typename T>
VOLUME_HAPTICS_INLINE void LoadPack4(const T* from, Pack4& to)
{
  if constexpr (sizeof(T) <= 2)
  {
    // By way of 32-bit integers: a direct conversion is taken apart into scalars.
    typedef T Narrow __attribute__((vector_size(4 * sizeof(T))));
    typedef std::int32_t Wide __attribute__((vector_size(16)));
    Narrow narrow;
    std::memcpy(&narrow, from, sizeof(narrow));
    to = __builtin_convertvector(__builtin_convertvector(narrow, Wide), Pack4);
  }
  else
  {
    typedef T Narrow __attribute__((vector_size(4 * sizeof(T))));
    Narrow narrow;
    std::memcpy(&narrow, from, sizeof(narrow));
    to = __builtin_convertvector(narrow, Pack4);
  }
}
#else
struct Pack4
{
  double Lane[4];

  double operator[](int i) const { return this->Lane[i]; }
  double& operator[](int i) { return this->Lane[i]; }
};
inline Pack4 operator*(double s, const Pack4& a)
{
  return { { s * a[0], s * a[1], s * a[2], s * a[3] } };
}
inline Pack4 operator*(const Pack4& a, const Pack4& b)
{
  return { { a[0] * b[0], a[1] * b[1], a[2] * b[2], a[3] * b[3] } };
}
inline Pack4& operator+=(Pack4& a, const Pack4& b)
{
  for (int i = 0; i < 4; ++i)
  {
    a[i] += b[i];
  }
  return a;
}

template <typename T>
VOLUME_HAPTICS_INLINE void LoadPack4(const T* from, Pack4& to)
{
  to = { { static_cast<double>(from[0]), static_cast<double>(from[1]), static_cast<double>(from[2]),
    static_cast<double>(from[3]) } };
}
#endif

} // namespace
} // namespace VolumeHaptics

#endif
