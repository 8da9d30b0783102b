// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Counts what the whole process allocates. Linking AllocationCounter.cxx replaces the allocator's
 * entry points: operator new always, malloc and its siblings where no sanitizer has taken them.
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
  /// Bytes that operator new has handed out and nobody has given back.
  std::size_t LiveBytes = 0;
};

Allocations CountAllocations();
/// Whether malloc is counted, too.
bool CountsMalloc();
} // namespace coretest

#endif
