// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Vectors of four doubles for the instruction set of the translation unit.
 *
 * Double4Avx.h uses a vector type of the compiler, and Double4Portable.h a plain struct. Their
 * results are equal, to the bit.
 */
#ifndef Double4_h
#define Double4_h

#if defined(__GNUC__) && defined(__x86_64__) && defined(__AVX__)
#include "Core/Math/Double4Avx.h"
#else
#include "Core/Math/Double4Portable.h"
#endif

#include <cstring>
#include <type_traits>

namespace VolumeHaptics
{
namespace
{

/**
 * Returns false for NaN and infinities. std::isfinite must not be called here: see FieldKernels.h.
 */
VOLUME_HAPTICS_INLINE bool IsNumber(double x)
{
  return x - x == 0.0;
}

/** Returns the same number in all lanes. */
VOLUME_HAPTICS_INLINE Double4 Spread(double x)
{
  return MakeDouble4(x, x, x, x);
}

/** Loads two samples from each of two addresses. */
template <typename T>
VOLUME_HAPTICS_INLINE Double4 LoadPairs(const T* low, const T* high)
{
  if constexpr (std::is_same<T, double>::value)
  {
    return LoadHalves(low, high);
  }
  else
  {
    T joined[4];
    std::memcpy(joined, low, 2 * sizeof(T));
    std::memcpy(joined + 2, high, 2 * sizeof(T));
    return LoadDouble4(joined);
  }
}

VOLUME_HAPTICS_INLINE void StoreDouble4(const Double4& from, double* to)
{
  std::memcpy(to, &from, sizeof(from));
}

} // namespace
} // namespace VolumeHaptics

#endif
