// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Regions/Formats/Hdf5Trees.h"

#include "VTK/Regions/Formats/Hdf5ChunkArrays.h"

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace VolumeHaptics
{
namespace
{

constexpr std::size_t MostLinks = 65536;

/** A node of a B-tree: its level, the number of its children, and the block after these. */
struct TreeNode
{
  TreeNode(Hdf5Block block, int kind, int level, std::size_t offsetSize)
    : Block(std::move(block))
  {
    const bool isTree = this->Block.Begins("TREE");
    const bool isOfKind = this->Block.Byte() == kind;
    this->Level = this->Block.Byte();
    if (!isTree || !isOfKind || (level >= 0 && this->Level != level))
    {
      Hdf5Block::ThrowDamaged();
    }
    this->Count = static_cast<std::size_t>(this->Block.Number(2));
    this->Block.Skip(2 * offsetSize);
  }

  Hdf5Block Block;
  int Level = 0;
  std::size_t Count = 0;
};

} // namespace

void Hdf5Trees::ReadLinks(std::uint64_t tree, std::uint64_t heap, Hdf5Object& object)
{
  Hdf5Block head = this->Storage.ReadBlock(
    heap, 8 + 2 * this->Storage.GetLengthSize() + this->Storage.GetOffsetSize());
  if (!head.Begins("HEAP"))
  {
    Hdf5Block::ThrowDamaged();
  }
  head.Skip(4);
  const std::uint64_t size = this->Storage.Length(head);
  this->Storage.Length(head); // position of the free space
  Hdf5Block names = this->Storage.ReadBlock(this->Storage.Offset(head), size);
  this->ReadLinkNode(tree, -1, names, object);
}

void Hdf5Trees::ReadLinkNode(std::uint64_t address, int level, Hdf5Block& names, Hdf5Object& object)
{
  const std::size_t headSize = 8 + 2 * this->Storage.GetOffsetSize();
  const std::size_t entry = this->Storage.GetLengthSize() + this->Storage.GetOffsetSize();
  const TreeNode head(
    this->Storage.ReadBlock(address, headSize), 0, level, this->Storage.GetOffsetSize());
  Hdf5Block body = this->Storage.ReadBlock(address + headSize, head.Count * entry);
  for (std::size_t i = 0; i < head.Count; ++i)
  {
    this->Storage.Length(body); // the key of the node
    const std::uint64_t child = this->Storage.Offset(body);
    if (head.Level > 0)
    {
      this->ReadLinkNode(child, head.Level - 1, names, object);
      continue;
    }
    Hdf5Block first = this->Storage.ReadBlock(child, 8);
    if (!first.Begins("SNOD") || object.Links.size() > MostLinks)
    {
      Hdf5Block::ThrowDamaged();
    }
    first.Skip(2);
    const auto count = static_cast<std::size_t>(first.Number(2));
    Hdf5Block symbols =
      this->Storage.ReadBlock(child + 8, count * (2 * this->Storage.GetOffsetSize() + 24));
    for (std::size_t s = 0; s < count; ++s)
    {
      names.Go(static_cast<std::size_t>(this->Storage.Offset(symbols)));
      const std::uint64_t header = this->Storage.Offset(symbols);
      constexpr std::uint64_t soft = 2;
      if (symbols.Number(4) == soft)
      {
        object.HasOtherLinks = true;
      }
      else
      {
        object.Links[names.Text()] = header;
      }
      symbols.Skip(20);
    }
  }
}

void Hdf5Trees::AddChunk(
  const std::vector<std::uint64_t>& first, Hdf5Chunk chunk, Hdf5Object& object) const
{
  const std::size_t rank = object.Shape.size();
  std::uint64_t number = 0;
  for (std::size_t d = 0; d < rank; ++d)
  {
    const std::uint64_t size = object.ChunkShape[d];
    if (first[d] % size != 0 || first[d] >= object.Shape[d])
    {
      return; // the chunk belongs to an array that was larger before
    }
    if (d + 3 < rank)
    {
      if (first[d] != 0)
      {
        return;
      }
      continue;
    }
    number = number * ((object.Shape[d] + size - 1) / size) + first[d] / size;
  }
  chunk.Address += this->Storage.GetBase();
  object.Chunks[number] = chunk;
}

void Hdf5Trees::ReadChunks(const Hdf5ChunkIndex& index, Hdf5Object& object)
{
  std::uint64_t size = object.Type.Size;
  for (const std::uint64_t count : object.ChunkShape)
  {
    constexpr std::uint64_t most = std::uint64_t{ 1 } << 32;
    if (count == 0 || count > most || size > most)
    {
      Hdf5Block::ThrowDamaged();
    }
    size *= count;
  }
  if (object.ChunkShape.size() != object.Shape.size() || object.Shape.empty() || size == 0)
  {
    Hdf5Block::ThrowDamaged();
  }
  if (index.Type >= Hdf5ChunkIndex::NewTree)
  {
    throw std::runtime_error(
      "several of its dimensions can grow, and the list of its chunks is of a kind that is not "
      "read here. Convert it with h5repack -f NONE -l CONTI IN OUT, or write it without "
      "libver='latest'.");
  }
  if (!this->Storage.IsAddress(index.Address))
  {
    return; // nothing was written yet
  }
  if (index.Type == Hdf5ChunkIndex::FixedArray || index.Type == Hdf5ChunkIndex::ExtensibleArray)
  {
    this->ReadChunkArray(index, size, object);
    return;
  }
  if (index.Type == Hdf5ChunkIndex::Tree)
  {
    this->ReadChunkNode(index.Address, -1, object);
    return;
  }
  Hdf5Chunk chunk = index.Chunk;
  chunk.Size = chunk.Size == 0 ? size : chunk.Size;
  chunk.Address = index.Address;
  std::vector<std::uint64_t> first(object.Shape.size(), 0);
  if (index.Type == Hdf5ChunkIndex::Single)
  {
    this->AddChunk(first, chunk, object);
    return;
  }
  // All chunks are stored one after another, the last dimension fastest.
  bool isDone = false;
  while (!isDone)
  {
    this->AddChunk(first, chunk, object);
    chunk.Address += size;
    isDone = chunk.Address > this->Storage.GetFileSize();
    for (std::size_t d = first.size(); d-- > 0;)
    {
      first[d] += object.ChunkShape[d];
      if (first[d] < object.Shape[d])
      {
        break;
      }
      first[d] = 0;
      isDone = isDone || d == 0;
    }
  }
}

void Hdf5Trees::ReadChunkArray(const Hdf5ChunkIndex& index, std::uint64_t size, Hdf5Object& object)
{
  const std::size_t rank = object.Shape.size();
  const std::vector<std::uint64_t>& most = object.MostShape;
  if (most.size() != rank || std::find(most.begin(), most.end(), 0) != most.end())
  {
    Hdf5Block::ThrowDamaged();
  }
  // Entries are numbered with the last dimension as the fastest, and a dimension without limit as
  // the slowest.
  std::vector<std::size_t> order(rank);
  std::iota(order.begin(), order.end(), 0);
  const auto endless = std::find(most.begin(), most.end(), Hdf5Object::Endless) - most.begin();
  if (endless < static_cast<std::ptrdiff_t>(rank))
  {
    std::rotate(order.begin(), order.begin() + endless, order.begin() + endless + 1);
  }
  const auto add = [&](std::uint64_t number, const Hdf5Chunk& chunk)
  {
    std::vector<std::uint64_t> first(rank);
    for (std::size_t i = rank; i-- > 0;)
    {
      const std::size_t d = order[i];
      const std::uint64_t count = (most[d] - 1) / object.ChunkShape[d] + 1;
      const std::uint64_t place = i > 0 ? number % count : number;
      number /= count;
      if (object.Shape[d] == 0 || place > (object.Shape[d] - 1) / object.ChunkShape[d])
      {
        return; // the chunk belongs to an array that was larger before
      }
      first[d] = place * object.ChunkShape[d];
    }
    this->AddChunk(first, chunk, object);
  };
  Hdf5ChunkArrays arrays(this->Storage, size, add);
  index.Type == Hdf5ChunkIndex::FixedArray ? arrays.ReadFixed(index.Address)
                                           : arrays.ReadExtensible(index.Address);
}

void Hdf5Trees::ReadChunkNode(std::uint64_t address, int level, Hdf5Object& object)
{
  const std::size_t rank = object.Shape.size();
  const std::size_t headSize = 8 + 2 * this->Storage.GetOffsetSize();
  const std::size_t key = 8 + 8 * (rank + 1);
  const TreeNode head(
    this->Storage.ReadBlock(address, headSize), 1, level, this->Storage.GetOffsetSize());
  Hdf5Block body =
    this->Storage.ReadBlock(address + headSize, head.Count * (key + this->Storage.GetOffsetSize()));
  for (std::size_t i = 0; i < head.Count; ++i)
  {
    Hdf5Chunk chunk;
    chunk.Size = body.Number(4);
    chunk.Skipped = body.Number(4);
    std::vector<std::uint64_t> first;
    for (std::size_t d = 0; d < rank; ++d)
    {
      first.push_back(body.Number(8));
    }
    body.Skip(8);
    chunk.Address = this->Storage.Offset(body);
    if (head.Level > 0)
    {
      this->ReadChunkNode(chunk.Address, head.Level - 1, object);
    }
    else
    {
      this->AddChunk(first, chunk, object);
    }
  }
}

} // namespace VolumeHaptics
