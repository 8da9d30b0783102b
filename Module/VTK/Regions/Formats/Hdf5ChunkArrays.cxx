// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Regions/Formats/Hdf5ChunkArrays.h"

#include <algorithm>

namespace VolumeHaptics
{
namespace
{

constexpr std::size_t ChecksumSize = 4;
/** Size of the signature, version and client that all parts begin with. */
constexpr std::size_t PartHeadSize = 6;
/**
 * Limit on the bits of an entry's number: larger arrays would have more chunks than a file has room
 * for.
 */
constexpr int MostArrayBits = 48;

/** Returns the position of the highest bit; -1 for 0. */
int LogOf(std::uint64_t number)
{
  int bits = -1;
  for (; number > 0; number >>= 1)
  {
    ++bits;
  }
  return bits;
}

/** Tests a bit; bits are numbered from the highest one of the first byte. */
bool HasBit(const std::vector<char>& bits, std::uint64_t number)
{
  const auto byte = static_cast<unsigned char>(bits[static_cast<std::size_t>(number / 8)]);
  return (byte & (0x80U >> (number % 8))) != 0;
}

} // namespace

Hdf5Block Hdf5ChunkArrays::BeginHeader(
  const char* signature, std::uint64_t address, std::uint64_t size)
{
  Hdf5Block head = this->Storage.ReadBlock(address, size);
  const bool isIt = head.Begins(signature);
  head.Skip(1);
  this->IsFiltered = head.Byte() == 1;
  this->EntrySize = static_cast<std::size_t>(head.Byte());
  // With filters, an entry also has a size of up to 8 bytes, and 4 bytes for the filters that were
  // left out.
  const std::size_t plain = this->Storage.GetOffsetSize() + (this->IsFiltered ? 4 : 0);
  const bool isEntry = this->IsFiltered ? this->EntrySize > plain && this->EntrySize <= plain + 8
                                        : this->EntrySize == plain;
  if (!isIt || !isEntry)
  {
    Hdf5Block::ThrowDamaged();
  }
  return head;
}

Hdf5Block Hdf5ChunkArrays::BeginBlock(
  const char* signature, std::uint64_t address, std::uint64_t size)
{
  Hdf5Block block =
    this->Storage.ReadBlock(address, PartHeadSize + this->Storage.GetOffsetSize() + size);
  if (!block.Begins(signature))
  {
    Hdf5Block::ThrowDamaged();
  }
  block.Skip(2 + this->Storage.GetOffsetSize());
  return block;
}

void Hdf5ChunkArrays::ReadEntries(Hdf5Block& block, std::uint64_t first, std::uint64_t count)
{
  for (std::uint64_t i = 0; i < count; ++i)
  {
    Hdf5Chunk chunk;
    chunk.Size = this->ChunkSize;
    chunk.Address = this->Storage.Offset(block);
    if (this->IsFiltered)
    {
      chunk.Size = block.Number(this->EntrySize - this->Storage.GetOffsetSize() - 4);
      chunk.Skipped = block.Number(4);
    }
    if (this->Storage.IsAddress(chunk.Address))
    {
      this->Take(first + i, chunk);
    }
  }
}

void Hdf5ChunkArrays::ReadPage(std::uint64_t address, std::uint64_t first, std::uint64_t count)
{
  Hdf5Block page = this->Storage.ReadBlock(address, count * this->EntrySize);
  this->ReadEntries(page, first, count);
}

void Hdf5ChunkArrays::ReadFixed(std::uint64_t address)
{
  Hdf5Block head = this->BeginHeader("FAHD", address,
    PartHeadSize + 2 + this->Storage.GetLengthSize() + this->Storage.GetOffsetSize());
  this->PageBits = head.Byte();
  const std::uint64_t count = this->Storage.Length(head);
  const std::uint64_t block = this->Storage.Offset(head);
  if (this->PageBits > MostArrayBits || LogOf(count) > MostArrayBits)
  {
    Hdf5Block::ThrowDamaged();
  }
  if (!this->Storage.IsAddress(block))
  {
    return;
  }
  const std::uint64_t pageSize = this->GetPageSize();
  if (count <= pageSize)
  {
    Hdf5Block entries = this->BeginBlock("FADB", block, count * this->EntrySize);
    this->ReadEntries(entries, 0, count);
    return;
  }
  const std::uint64_t pages = (count + pageSize - 1) / pageSize;
  const std::uint64_t bytes = (pages + 7) / 8;
  Hdf5Block body = this->BeginBlock("FADB", block, bytes);
  const std::vector<char> written = body.Take(static_cast<std::size_t>(bytes));
  std::uint64_t at = block + body.GetPlace() + ChecksumSize;
  for (std::uint64_t page = 0; page < pages; ++page)
  {
    const std::uint64_t first = page * pageSize;
    if (HasBit(written, page))
    {
      this->ReadPage(at, first, std::min(pageSize, count - first));
    }
    at += pageSize * this->EntrySize + ChecksumSize;
  }
}

void Hdf5ChunkArrays::ReadDataBlock(std::uint64_t address, std::uint64_t first, std::uint64_t count,
  const std::vector<char>& written, std::uint64_t firstPage)
{
  if (!this->Storage.IsAddress(address))
  {
    return;
  }
  const std::uint64_t pageSize = this->GetPageSize();
  if (count <= pageSize)
  {
    Hdf5Block body = this->BeginBlock("EADB", address, this->NumberSize + count * this->EntrySize);
    body.Skip(this->NumberSize);
    this->ReadEntries(body, first, count);
    return;
  }
  Hdf5Block body = this->BeginBlock("EADB", address, this->NumberSize);
  body.Skip(this->NumberSize);
  std::uint64_t at = address + body.GetPlace() + ChecksumSize;
  for (std::uint64_t page = 0; page < count / pageSize; ++page)
  {
    if (HasBit(written, firstPage + page))
    {
      this->ReadPage(at, first + page * pageSize, pageSize);
    }
    at += pageSize * this->EntrySize + ChecksumSize;
  }
}

void Hdf5ChunkArrays::ReadExtensible(std::uint64_t address)
{
  const std::size_t offset = this->Storage.GetOffsetSize();
  Hdf5Block head = this->BeginHeader(
    "EAHD", address, PartHeadSize + 6 + 6 * this->Storage.GetLengthSize() + offset);
  const int bits = head.Byte();
  const auto inIndex = static_cast<std::uint64_t>(head.Byte());
  const auto leastEntries = static_cast<std::uint64_t>(head.Byte());
  const auto leastBlocks = static_cast<std::uint64_t>(head.Byte());
  this->PageBits = head.Byte();
  head.Skip(6 * this->Storage.GetLengthSize()); // statistics
  const std::uint64_t index = this->Storage.Offset(head);
  const int groups = 1 + bits - LogOf(leastEntries);
  const int direct = 2 * LogOf(leastBlocks); // the index block lists their blocks itself
  if (bits > MostArrayBits || this->PageBits > MostArrayBits || leastEntries == 0 ||
    leastBlocks == 0 || groups < direct)
  {
    Hdf5Block::ThrowDamaged();
  }
  if (!this->Storage.IsAddress(index))
  {
    return;
  }
  this->NumberSize = static_cast<std::size_t>((bits + 7) / 8);
  const std::uint64_t addresses =
    2 * (leastBlocks - 1) + static_cast<std::uint64_t>(groups - direct);
  Hdf5Block body = this->BeginBlock("EAIB", index, inIndex * this->EntrySize + addresses * offset);
  this->ReadEntries(body, 0, inIndex);
  // Blocks come in groups. From one group to the next, alternately the number of blocks or the
  // number of entries in each block doubles.
  std::uint64_t first = inIndex;
  for (int group = 0; group < groups; ++group)
  {
    const std::uint64_t blocks = std::uint64_t{ 1 } << (group / 2);
    const std::uint64_t entries = leastEntries << ((group + 1) / 2);
    const std::uint64_t pages = entries > this->GetPageSize() ? entries / this->GetPageSize() : 0;
    if (group < direct)
    {
      if (pages > 0)
      {
        Hdf5Block::ThrowDamaged(); // no list says then which pages are written
      }
      for (std::uint64_t block = 0; block < blocks; ++block)
      {
        this->ReadDataBlock(this->Storage.Offset(body), first + block * entries, entries, {}, 0);
      }
    }
    else if (const std::uint64_t list = this->Storage.Offset(body); this->Storage.IsAddress(list))
    {
      const std::uint64_t bytes = blocks * ((pages + 7) / 8);
      Hdf5Block listed = this->BeginBlock("EASB", list, this->NumberSize + bytes + blocks * offset);
      listed.Skip(this->NumberSize);
      const std::vector<char> written = listed.Take(static_cast<std::size_t>(bytes));
      for (std::uint64_t block = 0; block < blocks; ++block)
      {
        this->ReadDataBlock(
          this->Storage.Offset(listed), first + block * entries, entries, written, block * pages);
      }
    }
    first += blocks * entries;
  }
}

} // namespace VolumeHaptics
