// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Trace/TraceBlocks.h"

#include "vtkAbstractArray.h"
#include "vtkDataArray.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <list>
#include <memory>
#include <mutex>
#include <new>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace VolumeHaptics
{
namespace
{

/** Stands before the memory of an array, and keeps its alignment. */
struct alignas(std::max_align_t) BlockHead
{
  void* Memory; ///< that operator new gave
  std::size_t Bytes;
  BlockHead* Next; ///< of the spare blocks
};

/** The size and the alignment (bytes) of a large page. */
constexpr std::size_t LargePage = std::size_t(2) << 20;

BlockHead* NewBlock(std::size_t bytes)
{
  const std::size_t room = bytes < 2 * LargePage ? 0 : LargePage; // to align it
  std::size_t space = sizeof(BlockHead) + bytes + room;
  void* const memory = ::operator new(space);
  void* begin = memory;
  if (room > 0)
  {
    std::align(LargePage, sizeof(BlockHead) + bytes, begin, space);
#if defined(__linux__)
    // Else the system gives, clears and takes back each 4 KiB by itself, and the taking back is
    // done by one thread alone. Refused where large pages are off.
    (void)madvise(begin, sizeof(BlockHead) + bytes, MADV_HUGEPAGE);
#endif
  }
  auto* const block = static_cast<BlockHead*>(begin);
  block->Memory = memory;
  block->Bytes = bytes;
  return block;
}

/** The blocks that no array uses. */
struct SpareBlocks
{
  std::mutex Mutex;
  BlockHead* First = nullptr; ///< the one that came last
  std::size_t Bytes = 0;
};

/** Never destroyed: arrays come back while the process exits, too. */
SpareBlocks& GetSpare()
{
  static auto* const spare = new SpareBlocks;
  return *spare;
}

/** A spare block of so many bytes, and of twice as many at most; null if there is none. */
BlockHead* Reuse(std::size_t bytes)
{
  SpareBlocks& spare = GetSpare();
  const std::lock_guard<std::mutex> lock(spare.Mutex);
  for (BlockHead** link = &spare.First; *link; link = &(*link)->Next)
  {
    BlockHead* const block = *link;
    if (block->Bytes >= bytes && block->Bytes / 2 <= bytes)
    {
      *link = block->Next;
      spare.Bytes -= block->Bytes;
      return block;
    }
  }
  return nullptr;
}

/** Frees the spare blocks that came first, until all take so many bytes at most. */
void Shrink(SpareBlocks& spare, std::size_t bytes)
{
  std::size_t kept = 0;
  BlockHead** link = &spare.First;
  while (*link && kept + (*link)->Bytes <= bytes)
  {
    kept += (*link)->Bytes;
    link = &(*link)->Next;
  }
  BlockHead* block = *link;
  *link = nullptr;
  spare.Bytes = kept;
  while (block)
  {
    BlockHead* const next = block->Next;
    ::operator delete(block->Memory);
    block = next;
  }
}

/** The free function of an array. */
void TakeBack(void* memory)
{
  if (memory)
  {
    SpareBlocks& spare = GetSpare();
    BlockHead* const block = static_cast<BlockHead*>(memory) - 1;
    const std::lock_guard<std::mutex> lock(spare.Mutex);
    block->Next = spare.First;
    spare.First = block;
    spare.Bytes += block->Bytes;
    Shrink(spare, TraceBlocks::MostSpareBytes);
  }
}

} // namespace

void TraceBlocks::Allocate(vtkDataArray* array, vtkIdType tuples)
{
  const vtkIdType values = tuples * array->GetNumberOfComponents();
  if (values == 0)
  {
    return;
  }
  const auto bytes =
    static_cast<std::size_t>(values) * static_cast<std::size_t>(array->GetDataTypeSize());
  BlockHead* block = Reuse(bytes);
  if (!block)
  {
    block = NewBlock(bytes);
  }
  array->SetVoidArray(block + 1, values, 0, vtkAbstractArray::VTK_DATA_ARRAY_USER_DEFINED);
  array->SetArrayFreeFunction(&TakeBack);
}

std::size_t TraceBlocks::GetSpareBytes()
{
  SpareBlocks& spare = GetSpare();
  const std::lock_guard<std::mutex> lock(spare.Mutex);
  return spare.Bytes;
}

} // namespace VolumeHaptics
