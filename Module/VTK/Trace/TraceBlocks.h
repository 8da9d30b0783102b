// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Memory for the arrays of traces, some of which is kept for the next trace.
 */
#ifndef TraceBlocks_h
#define TraceBlocks_h

#include "vtkType.h"

#include <cstddef>

class vtkDataArray;

namespace VolumeHaptics
{

/**
 * Memory that the system gives for the first time costs more than all that is written into it: it
 * comes page by page, and cleared. So up to `MostSpareBytes` of what traces leave behind are used
 * again.
 */
namespace TraceBlocks
{

constexpr std::size_t MostSpareBytes = std::size_t(32) << 20;

/**
 * Gives an array of a fixed type a block for so many tuples, which comes back when nothing uses it
 * any more. Its values are arbitrary. Throws std::bad_alloc.
 */
void Allocate(vtkDataArray* array, vtkIdType tuples);

/** The bytes that are kept now. */
std::size_t GetSpareBytes();

} // namespace TraceBlocks

} // namespace VolumeHaptics

#endif
