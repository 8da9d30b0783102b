// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Four doubles in one AVX register. Only Double4.h includes this file.
 */
#ifndef Double4Avx_h
#define Double4Avx_h

#include "Core/Math/KernelInline.h"

#include <cstdint>
#include <cstring>
#include <immintrin.h>
#include <type_traits>

namespace VolumeHaptics
{
namespace
{

typedef double Double4 __attribute__((vector_size(32)));
typedef std::int32_t Int4 __attribute__((vector_size(16)));

/**
 * Makes four lanes from four numbers. Loading them from an array would be slower, because the
 * processor would have to wait.
 */
VOLUME_HAPTICS_INLINE Double4 MakeDouble4(double a, double b, double c, double d)
{
  return Double4{ a, b, c, d };
}

///@{
/**
 * Functions that work lane by lane. Larger() and Smaller() return the second argument if a lane is
 * NaN.
 */
VOLUME_HAPTICS_INLINE Double4 Root(const Double4& a)
{
  return _mm256_sqrt_pd(a);
}
VOLUME_HAPTICS_INLINE Double4 Larger(const Double4& a, const Double4& b)
{
  return a > b ? a : b;
}
VOLUME_HAPTICS_INLINE Double4 Smaller(const Double4& a, const Double4& b)
{
  return a < b ? a : b;
}
VOLUME_HAPTICS_INLINE Double4 Floor(const Double4& a)
{
  return _mm256_floor_pd(a);
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
  return a > b ? x : y;
}
VOLUME_HAPTICS_INLINE Double4 ChooseEqual(
  const Double4& a, const Double4& b, const Double4& x, const Double4& y)
{
  return a == b ? x : y;
}
///@}

/** Stores lanes that are whole numbers below 2^51. */
VOLUME_HAPTICS_INLINE void StoreWhole(const Double4& from, std::int64_t* to)
{
  // AVX2 has no instruction for this conversion. The lowest bits of (number + shift) are the whole
  // number.
  const Double4 shift = _mm256_set1_pd(0x1.8p52);
  const __m256i whole =
    _mm256_sub_epi64(_mm256_castpd_si256(from + shift), _mm256_castpd_si256(shift));
  _mm256_storeu_si256(reinterpret_cast<__m256i*>(to), whole);
}
///@{
/**
 * Return one bit for each lane, the lowest for the first lane. The bit is set where the condition
 * holds; it is 0 for NaN.
 */
VOLUME_HAPTICS_INLINE std::uint64_t NotNegative(const Double4& a)
{
  return static_cast<std::uint64_t>(
    _mm256_movemask_pd(_mm256_cmp_pd(a, _mm256_setzero_pd(), _CMP_GE_OQ)));
}
VOLUME_HAPTICS_INLINE std::uint64_t IsAbove(const Double4& a, const Double4& b)
{
  return static_cast<std::uint64_t>(_mm256_movemask_pd(_mm256_cmp_pd(a, b, _CMP_GT_OQ)));
}
VOLUME_HAPTICS_INLINE std::uint64_t IsEqual(const Double4& a, const Double4& b)
{
  return static_cast<std::uint64_t>(_mm256_movemask_pd(_mm256_cmp_pd(a, b, _CMP_EQ_OQ)));
}
///@}

/**
 * Loads four samples of 8 or 16 bits. GCC would convert them one by one, so this uses the
 * instructions for four.
 */
template <typename T>
VOLUME_HAPTICS_INLINE Int4 LoadInt4(const T* from)
{
  constexpr bool isSigned = std::is_signed<T>::value;
  std::conditional_t<sizeof(T) == 1, std::int32_t, std::int64_t> bits;
  std::memcpy(&bits, from, sizeof(bits));
  const __m128i narrow = _mm_cvtsi64_si128(bits);
  if constexpr (sizeof(T) == 1)
  {
    return reinterpret_cast<Int4>(isSigned ? _mm_cvtepi8_epi32(narrow) : _mm_cvtepu8_epi32(narrow));
  }
  else
  {
    return reinterpret_cast<Int4>(
      isSigned ? _mm_cvtepi16_epi32(narrow) : _mm_cvtepu16_epi32(narrow));
  }
}

template <typename T>
VOLUME_HAPTICS_INLINE Double4 LoadDouble4(const T* from)
{
  if constexpr (sizeof(T) <= 2)
  {
    return _mm256_cvtepi32_pd(reinterpret_cast<__m128i>(LoadInt4(from)));
  }
  else if constexpr (std::is_same<T, float>::value)
  {
    return _mm256_cvtps_pd(_mm_loadu_ps(from));
  }
  else
  {
    typedef T Narrow __attribute__((vector_size(4 * sizeof(T))));
    Narrow narrow;
    std::memcpy(&narrow, from, sizeof(narrow));
    return __builtin_convertvector(narrow, Double4);
  }
}

///@{
/** Load or store the first two lanes at `low`, and the last two lanes at `high`. */
VOLUME_HAPTICS_INLINE Double4 LoadHalves(const double* low, const double* high)
{
  return _mm256_insertf128_pd(_mm256_castpd128_pd256(_mm_loadu_pd(low)), _mm_loadu_pd(high), 1);
}
VOLUME_HAPTICS_INLINE void StoreHalves(const Double4& from, double* low, double* high)
{
  _mm_storeu_pd(low, _mm256_castpd256_pd128(from));
  _mm_storeu_pd(high, _mm256_extractf128_pd(from, 1));
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
  if constexpr (std::is_integral<T>::value && sizeof(T) == 2)
  {
    const auto pair = [](const T* from)
    {
      std::int32_t bits;
      std::memcpy(&bits, from, sizeof(bits));
      return bits;
    };
    const __m128i pairs = _mm_set_epi32(pair(d), pair(c), pair(b), pair(a));
    constexpr bool isSigned = std::is_signed<T>::value;
    const __m128i low = isSigned ? _mm_srai_epi32(_mm_slli_epi32(pairs, 16), 16)
                                 : _mm_srli_epi32(_mm_slli_epi32(pairs, 16), 16);
    const __m128i high = isSigned ? _mm_srai_epi32(pairs, 16) : _mm_srli_epi32(pairs, 16);
    first = _mm256_cvtepi32_pd(low);
    second = _mm256_cvtepi32_pd(high);
  }
  else
  {
    first = Double4{ static_cast<double>(a[0]), static_cast<double>(b[0]),
      static_cast<double>(c[0]), static_cast<double>(d[0]) };
    second = Double4{ static_cast<double>(a[1]), static_cast<double>(b[1]),
      static_cast<double>(c[1]), static_cast<double>(d[1]) };
  }
}

/** Loads one number from memory into all lanes, without a shuffle. */
VOLUME_HAPTICS_INLINE Double4 Spread(const double* from)
{
  return _mm256_broadcast_sd(from);
}
/** Returns the first two lanes of `low` and the last two lanes of `high`. */
VOLUME_HAPTICS_INLINE Double4 JoinHalves(const Double4& low, const Double4& high)
{
  return _mm256_blend_pd(low, high, 0b1100);
}
/** Returns the first two lanes of both arguments. */
VOLUME_HAPTICS_INLINE Double4 JoinLow(const Double4& a, const Double4& b)
{
  return _mm256_permute2f128_pd(a, b, 0x20);
}
/** Returns the last two lanes of both arguments. */
VOLUME_HAPTICS_INLINE Double4 JoinHigh(const Double4& a, const Double4& b)
{
  return _mm256_permute2f128_pd(a, b, 0x31);
}
/**
 * Transposes four vectors: a gets the first lanes of all arguments, b the second lanes, and so on.
 */
VOLUME_HAPTICS_INLINE void Transpose(Double4& a, Double4& b, Double4& c, Double4& d)
{
  const __m256d even = _mm256_unpacklo_pd(a, b);
  const __m256d odd = _mm256_unpackhi_pd(a, b);
  const __m256d evenOfOthers = _mm256_unpacklo_pd(c, d);
  const __m256d oddOfOthers = _mm256_unpackhi_pd(c, d);
  a = _mm256_permute2f128_pd(even, evenOfOthers, 0x20);
  b = _mm256_permute2f128_pd(odd, oddOfOthers, 0x20);
  c = _mm256_permute2f128_pd(even, evenOfOthers, 0x31);
  d = _mm256_permute2f128_pd(odd, oddOfOthers, 0x31);
}

///@{
/** Adds the lanes in a fixed order: lanes 0 and 2, lanes 1 and 3, then both sums. */
VOLUME_HAPTICS_INLINE __m128d AddHalves(const Double4& a)
{
  return _mm_add_pd(_mm256_castpd256_pd128(a), _mm256_extractf128_pd(a, 1));
}
VOLUME_HAPTICS_INLINE double AddLanes(const Double4& a)
{
  const __m128d halves = AddHalves(a);
  return _mm_cvtsd_f64(_mm_hadd_pd(halves, halves));
}
VOLUME_HAPTICS_INLINE void AddLanes(
  const Double4& a, const Double4& b, const Double4& c, const Double4& d, double* sums)
{
  _mm_storeu_pd(sums, _mm_hadd_pd(AddHalves(a), AddHalves(b)));
  _mm_storeu_pd(sums + 2, _mm_hadd_pd(AddHalves(c), AddHalves(d)));
}
///@}

} // namespace
} // namespace VolumeHaptics

#endif
