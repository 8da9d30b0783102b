// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Counts the allocations of the whole process. Linking AllocationCounter.cxx replaces the
 * allocator's entry points: operator new always, malloc and its siblings if no sanitizer has taken
 * them.
 */
#ifndef AllocationCounter_h
#define AllocationCounter_h

#include <cstddef>

namespace coretest
{
struct Allocations
{
  /// Calls so far, of operator new and of malloc, calloc, realloc.
  std::size_t Calls = 0;
  /// Bytes that operator new has handed out and that were not given back.
  std::size_t LiveBytes = 0;
};

Allocations CountAllocations();
/// Whether malloc is counted, too.
bool CountsMalloc();
} // namespace coretest

#endif
