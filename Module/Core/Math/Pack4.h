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
#include <type_traits>

#if defined(__GNUC__) && defined(__x86_64__)
#include <immintrin.h>
#endif

// The kernels must be inlined whole into their translation unit: an out-of-line copy made by the
// AVX2 unit could be picked by the linker for the baseline one.
#if defined(__GNUC__)
#define VOLUME_HAPTICS_INLINE static inline __attribute__((always_inline))
#define VOLUME_HAPTICS_OUTLINE static __attribute__((noinline))
#define VOLUME_HAPTICS_PREFETCH(address) __builtin_prefetch(address)
#else
#define VOLUME_HAPTICS_INLINE static inline
#define VOLUME_HAPTICS_OUTLINE static
#define VOLUME_HAPTICS_PREFETCH(address) static_cast<void>(address)
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

#if defined(__GNUC__) && defined(__AVX__)
typedef double Pack4 __attribute__((vector_size(32)));
typedef std::int32_t Int4 __attribute__((vector_size(16)));

/** Four samples of 8 or 16 bits. */
template <typename T>
VOLUME_HAPTICS_INLINE Int4 LoadInt4(const T* from)
{
#if defined(__x86_64__)
  // GCC takes the generic conversion below apart; these are the instructions meant for it.
  constexpr bool isSigned = std::is_signed<T>::value;
  std::conditional_t<sizeof(T) == 1, std::int32_t, std::int64_t> bits;
  std::memcpy(&bits, from, sizeof(bits));
  const __m128i narrow = _mm_cvtsi64_si128(bits);
#if defined(__SSE4_1__)
  if constexpr (sizeof(T) == 1)
  {
    return reinterpret_cast<Int4>(isSigned ? _mm_cvtepi8_epi32(narrow) : _mm_cvtepu8_epi32(narrow));
  }
  else
  {
    return reinterpret_cast<Int4>(
      isSigned ? _mm_cvtepi16_epi32(narrow) : _mm_cvtepu16_epi32(narrow));
  }
#else
  const __m128i zero = _mm_setzero_si128();
  if constexpr (sizeof(T) == 1)
  {
    const __m128i half = _mm_unpacklo_epi8(isSigned ? narrow : zero, narrow);
    const __m128i whole = _mm_unpacklo_epi16(isSigned ? half : zero, half);
    return reinterpret_cast<Int4>(isSigned ? _mm_srai_epi32(whole, 24) : _mm_srli_epi32(whole, 24));
  }
  else
  {
    const __m128i whole = _mm_unpacklo_epi16(narrow, isSigned ? narrow : zero);
    return reinterpret_cast<Int4>(isSigned ? _mm_srai_epi32(whole, 16) : whole);
  }
#endif
#else
  typedef T Narrow __attribute__((vector_size(4 * sizeof(T))));
  Narrow narrow;
  std::memcpy(&narrow, from, sizeof(narrow));
  return __builtin_convertvector(narrow, Int4);
#endif
}

template <typename T>
VOLUME_HAPTICS_INLINE Pack4 LoadPack4(const T* from)
{
  if constexpr (sizeof(T) <= 2)
  {
    const Int4 wide = LoadInt4(from);
#if defined(__AVX__)
    return _mm256_cvtepi32_pd(reinterpret_cast<__m128i>(wide));
#else
    return __builtin_convertvector(wide, Pack4);
#endif
  }
#if defined(__AVX__)
  else if constexpr (std::is_same<T, float>::value)
  {
    return _mm256_cvtps_pd(_mm_loadu_ps(from));
  }
#endif
  else
  {
    typedef T Narrow __attribute__((vector_size(4 * sizeof(T))));
    Narrow narrow;
    std::memcpy(&narrow, from, sizeof(narrow));
    return __builtin_convertvector(narrow, Pack4);
  }
}
#else
struct Pack4
{
  double Lane[4];

  double operator[](int i) const { return this->Lane[i]; }
  double& operator[](int i) { return this->Lane[i]; }
};
VOLUME_HAPTICS_INLINE Pack4 operator*(double s, const Pack4& a)
{
  return { { s * a[0], s * a[1], s * a[2], s * a[3] } };
}
VOLUME_HAPTICS_INLINE Pack4 operator*(const Pack4& a, const Pack4& b)
{
  return { { a[0] * b[0], a[1] * b[1], a[2] * b[2], a[3] * b[3] } };
}
VOLUME_HAPTICS_INLINE Pack4 operator+(const Pack4& a, const Pack4& b)
{
  return { { a[0] + b[0], a[1] + b[1], a[2] + b[2], a[3] + b[3] } };
}
VOLUME_HAPTICS_INLINE Pack4 operator-(const Pack4& a, const Pack4& b)
{
  return { { a[0] - b[0], a[1] - b[1], a[2] - b[2], a[3] - b[3] } };
}

template <typename T>
VOLUME_HAPTICS_INLINE Pack4 LoadPack4(const T* from)
{
  return { { static_cast<double>(from[0]), static_cast<double>(from[1]),
    static_cast<double>(from[2]), static_cast<double>(from[3]) } };
}
#endif

/** Two samples here and two there. */
template <typename T>
VOLUME_HAPTICS_INLINE Pack4 LoadPairs(const T* low, const T* high)
{
  T joined[4];
  std::memcpy(joined, low, 2 * sizeof(T));
  std::memcpy(joined + 2, high, 2 * sizeof(T));
  return LoadPack4(joined);
}

VOLUME_HAPTICS_INLINE void StorePack4(const Pack4& from, double* to)
{
  std::memcpy(to, &from, sizeof(from));
}

} // namespace
} // namespace VolumeHaptics

#endif
