// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Macros for the sampling kernels.
 *
 * A kernel is inlined as a whole to make it fast. All its functions are static, because otherwise
 * the linker could put the AVX2 unit's copy of a function into the baseline kernel. Without
 * optimisation nothing is inlined, because inlined code takes ten times as long to compile, or more
 * with sanitizers.
 *
 * VOLUME_HAPTICS_UNROLL is for a loop of at most eight rounds, and keeps the loop's arrays in
 * registers.
 */
#ifndef KernelInline_h
#define KernelInline_h

#if defined(__GNUC__) && defined(__OPTIMIZE__)
#define VOLUME_HAPTICS_INLINE static inline __attribute__((always_inline))
#else
#define VOLUME_HAPTICS_INLINE static inline
#endif
#if defined(__clang__)
#define VOLUME_HAPTICS_UNROLL _Pragma("unroll")
#elif defined(__GNUC__)
#define VOLUME_HAPTICS_UNROLL _Pragma("GCC unroll 8")
#else
#define VOLUME_HAPTICS_UNROLL
#endif
#if defined(__GNUC__)
#define VOLUME_HAPTICS_OUTLINE static __attribute__((noinline))
#define VOLUME_HAPTICS_PREFETCH(address) __builtin_prefetch(address)
#else
#define VOLUME_HAPTICS_OUTLINE static
#define VOLUME_HAPTICS_PREFETCH(address) static_cast<void>(address)
#endif

#endif
