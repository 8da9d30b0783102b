// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Counts the allocations of the whole process. Linking AllocationCounter.cxx replaces operator new,
 * and also malloc and its siblings unless a sanitizer has replaced them.
 */
#ifndef AllocationCounter_h
#define AllocationCounter_h

#include <cstddef>

namespace coretest
{
struct Allocations
{
  /// Number of calls of operator new, malloc, calloc and realloc.
  std::size_t Calls = 0;
  /// Number of bytes allocated by operator new and not yet freed.
  std::size_t LiveBytes = 0;
};

Allocations CountAllocations();
/// Returns whether calls of malloc() are counted, which a sanitizer prevents.
bool CountsMalloc();
} // namespace coretest

#endif
