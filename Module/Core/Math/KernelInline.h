// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Macros for the sampling kernels.
 *
 * A kernel must be inlined whole into its translation unit: the linker could pick an out-of-line
 * copy made by the AVX2 unit for the baseline one.
 */
#ifndef KernelInline_h
#define KernelInline_h

#if defined(__GNUC__)
#define VOLUME_HAPTICS_INLINE static inline __attribute__((always_inline))
#define VOLUME_HAPTICS_OUTLINE static __attribute__((noinline))
#define VOLUME_HAPTICS_PREFETCH(address) __builtin_prefetch(address)
#else
#define VOLUME_HAPTICS_INLINE static inline
#define VOLUME_HAPTICS_OUTLINE static
#define VOLUME_HAPTICS_PREFETCH(address) static_cast<void>(address)
#endif

#endif
