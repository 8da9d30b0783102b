// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Comparisons of the labels in a plane of 8^2 voxels. The rules in FieldKernels.h also apply here.
 *
 * Labels are compared bit by bit, as unsigned numbers U of the same size. A plane is divided into
 * vectors, each with as many labels as the instruction set compares at once.
 */
#ifndef LabelRows_h
#define LabelRows_h

#include "Core/Math/KernelInline.h"

#include <cstdint>
#include <cstring>
#if defined(__GNUC__) && defined(__SSE2__)
#include <immintrin.h>
#endif

namespace VolumeHaptics
{
namespace
{

// Labels is the type of a vector. LoadVector() returns the vector with a given number in a plane.
// ToBits() returns one bit for each label of a mask.
#if defined(__GNUC__) && defined(__AVX2__)

typedef __m256i Labels;

template <typename U>
VOLUME_HAPTICS_INLINE Labels LoadVector(const U* plane, std::int64_t line, int number)
{
  const auto row = [&](int j) { return reinterpret_cast<const __m128i*>(plane + j * line); };
  if constexpr (sizeof(U) == 1)
  {
    const int j = 4 * number;
    const __m128i low = _mm_unpacklo_epi64(_mm_loadl_epi64(row(j)), _mm_loadl_epi64(row(j + 1)));
    const __m128i high =
      _mm_unpacklo_epi64(_mm_loadl_epi64(row(j + 2)), _mm_loadl_epi64(row(j + 3)));
    return _mm256_inserti128_si256(_mm256_castsi128_si256(low), high, 1);
  }
  else if constexpr (sizeof(U) == 2)
  {
    return _mm256_inserti128_si256(_mm256_castsi128_si256(_mm_loadu_si128(row(2 * number))),
      _mm_loadu_si128(row(2 * number + 1)), 1);
  }
  else if constexpr (sizeof(U) == 4)
  {
    return _mm256_loadu_si256(reinterpret_cast<const __m256i*>(row(number)));
  }
  else
  {
    return _mm256_loadu_si256(reinterpret_cast<const __m256i*>(row(number / 2)) + number % 2);
  }
}

template <typename U>
VOLUME_HAPTICS_INLINE Labels Repeat(U label)
{
  return sizeof(U) == 1 ? _mm256_set1_epi8(static_cast<char>(label))
    : sizeof(U) == 2    ? _mm256_set1_epi16(static_cast<short>(label))
    : sizeof(U) == 4    ? _mm256_set1_epi32(static_cast<int>(label))
                        : _mm256_set1_epi64x(static_cast<long long>(label));
}

/** Returns a mask in which all bits of a label are set if it is equal in both vectors. */
template <typename U>
VOLUME_HAPTICS_INLINE Labels Equal(Labels a, Labels b)
{
  return sizeof(U) == 1 ? _mm256_cmpeq_epi8(a, b)
    : sizeof(U) == 2    ? _mm256_cmpeq_epi16(a, b)
    : sizeof(U) == 4    ? _mm256_cmpeq_epi32(a, b)
                        : _mm256_cmpeq_epi64(a, b);
}

template <typename U>
VOLUME_HAPTICS_INLINE std::uint64_t ToBits(Labels mask)
{
  if constexpr (sizeof(U) == 2)
  {
    return static_cast<unsigned>(_mm_movemask_epi8(
      _mm_packs_epi16(_mm256_castsi256_si128(mask), _mm256_extracti128_si256(mask, 1))));
  }
  else
  {
    return static_cast<unsigned>(sizeof(U) == 1 ? _mm256_movemask_epi8(mask)
        : sizeof(U) == 4                        ? _mm256_movemask_ps(_mm256_castsi256_ps(mask))
                                                : _mm256_movemask_pd(_mm256_castsi256_pd(mask)));
  }
}

VOLUME_HAPTICS_INLINE Labels AndLabels(Labels a, Labels b)
{
  return _mm256_and_si256(a, b);
}

VOLUME_HAPTICS_INLINE Labels OrLabels(Labels a, Labels b)
{
  return _mm256_or_si256(a, b);
}

VOLUME_HAPTICS_INLINE Labels XorLabels(Labels a, Labels b)
{
  return _mm256_xor_si256(a, b);
}

#elif defined(__GNUC__) && defined(__SSE2__)

typedef __m128i Labels;

template <typename U>
VOLUME_HAPTICS_INLINE Labels LoadVector(const U* plane, std::int64_t line, int number)
{
  const auto row = [&](int j) { return reinterpret_cast<const __m128i*>(plane + j * line); };
  if constexpr (sizeof(U) == 1)
  {
    return _mm_unpacklo_epi64(
      _mm_loadl_epi64(row(2 * number)), _mm_loadl_epi64(row(2 * number + 1)));
  }
  else
  {
    constexpr int vectors = sizeof(U) / 2; // per row
    return _mm_loadu_si128(row(number / vectors) + number % vectors);
  }
}

template <typename U>
VOLUME_HAPTICS_INLINE Labels Repeat(U label)
{
  return sizeof(U) == 1 ? _mm_set1_epi8(static_cast<char>(label))
    : sizeof(U) == 2    ? _mm_set1_epi16(static_cast<short>(label))
    : sizeof(U) == 4    ? _mm_set1_epi32(static_cast<int>(label))
                        : _mm_set1_epi64x(static_cast<long long>(label));
}

/** Returns a mask in which all bits of a label are set if it is equal in both vectors. */
template <typename U>
VOLUME_HAPTICS_INLINE Labels Equal(Labels a, Labels b)
{
  if constexpr (sizeof(U) == 8)
  {
    const __m128i halves = _mm_cmpeq_epi32(a, b);
    return _mm_and_si128(halves, _mm_shuffle_epi32(halves, _MM_SHUFFLE(2, 3, 0, 1)));
  }
  else
  {
    return sizeof(U) == 1 ? _mm_cmpeq_epi8(a, b)
      : sizeof(U) == 2    ? _mm_cmpeq_epi16(a, b)
                          : _mm_cmpeq_epi32(a, b);
  }
}

template <typename U>
VOLUME_HAPTICS_INLINE std::uint64_t ToBits(Labels mask)
{
  return static_cast<unsigned>(sizeof(U) == 1 ? _mm_movemask_epi8(mask)
      : sizeof(U) == 2 ? _mm_movemask_epi8(_mm_packs_epi16(mask, _mm_setzero_si128()))
      : sizeof(U) == 4 ? _mm_movemask_ps(_mm_castsi128_ps(mask))
                       : _mm_movemask_pd(_mm_castsi128_pd(mask)));
}

VOLUME_HAPTICS_INLINE Labels AndLabels(Labels a, Labels b)
{
  return _mm_and_si128(a, b);
}

VOLUME_HAPTICS_INLINE Labels OrLabels(Labels a, Labels b)
{
  return _mm_or_si128(a, b);
}

VOLUME_HAPTICS_INLINE Labels XorLabels(Labels a, Labels b)
{
  return _mm_xor_si128(a, b);
}

#else

/** Without vector instructions, a vector has one label. */
typedef std::uint64_t Labels;

template <typename U>
VOLUME_HAPTICS_INLINE Labels LoadVector(const U* plane, std::int64_t line, int number)
{
  return plane[(number / 8) * line + number % 8];
}

template <typename U>
VOLUME_HAPTICS_INLINE Labels Repeat(U label)
{
  return label;
}

/** Returns a mask in which all bits are set if the labels are equal. */
template <typename U>
VOLUME_HAPTICS_INLINE Labels Equal(Labels a, Labels b)
{
  return a == b ? static_cast<U>(~U(0)) : U(0);
}

template <typename U>
VOLUME_HAPTICS_INLINE std::uint64_t ToBits(Labels mask)
{
  return mask & 1U;
}

VOLUME_HAPTICS_INLINE Labels AndLabels(Labels a, Labels b)
{
  return a & b;
}

VOLUME_HAPTICS_INLINE Labels OrLabels(Labels a, Labels b)
{
  return a | b;
}

VOLUME_HAPTICS_INLINE Labels XorLabels(Labels a, Labels b)
{
  return a ^ b;
}

#endif

/** Number of labels in a vector, and number of vectors in a plane. */
template <typename U>
constexpr int LabelsOfVector = sizeof(Labels) > 8 ? int(sizeof(Labels) / sizeof(U)) : 1;
template <typename U>
constexpr int VectorsOfPlane = 64 / LabelsOfVector<U>;

/** Combines all labels of a vector by a bitwise operation. */
template <typename U, typename F>
VOLUME_HAPTICS_INLINE U JoinLabels(Labels labels, F&& join)
{
  std::uint64_t words[sizeof(Labels) / 8];
  std::memcpy(words, &labels, sizeof(labels));
  std::uint64_t all = words[0];
  for (std::size_t i = 1; i < sizeof(Labels) / 8; ++i)
  {
    all = join(all, words[i]);
  }
  for (int bits = 32; bits >= int(8 * sizeof(U)) && LabelsOfVector < U >> 1; bits /= 2)
  {
    all = join(all, all >> bits);
  }
  return static_cast<U>(all);
}

} // namespace
} // namespace VolumeHaptics

#endif
