// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Large/Hdf5File.h"

#include <algorithm>

namespace VolumeHaptics
{
namespace
{

/** Of all parts of an object's header; real ones have some hundred bytes. */
constexpr std::size_t MostHeaderParts = 4096;
constexpr std::uint64_t MostStructureBytes = std::uint64_t{ 1 } << 26;
/** Of all blocks of a file: a damaged tree may lead to the same ones again and again. */
constexpr std::uint64_t MostBytesInAll = std::uint64_t{ 1 } << 30;

constexpr int SpaceMessage = 1;
constexpr int LinkInfoMessage = 2;
constexpr int TypeMessage = 3;
constexpr int FillMessage = 5;
constexpr int LinkMessage = 6;
constexpr int ExternalMessage = 7;
constexpr int LayoutMessage = 8;
constexpr int FilterMessage = 11;
constexpr int AttributeMessage = 12;
constexpr int ContinuationMessage = 16;
constexpr int GroupMessage = 17;
constexpr int SharedFlag = 2;

constexpr std::size_t MostLinks = 65536;

/** What is left of a node of a B-tree behind its head; the number of its children. */
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

Hdf5File::Hdf5File(const std::string& name)
  : File(name)
  , FileSize(static_cast<std::uint64_t>(this->File.GetSize()))
{
  // Something else may stand before it: it begins at 0, 512, 1024, 2048 and so on.
  for (std::uint64_t at = 0; at < this->FileSize; at = at == 0 ? 512 : 2 * at)
  {
    if (this->ReadSuperblock(at))
    {
      return;
    }
  }
  throw std::runtime_error("it is no HDF5 file. Check what it really is.");
}

bool Hdf5File::ReadSuperblock(std::uint64_t at)
{
  this->Base = 0;
  Hdf5Block block = this->ReadBlock(at, std::min<std::uint64_t>(128, this->FileSize - at));
  if (block.GetLeft() < 32 || !block.Begins("\x89HDF\r\n\x1a\n"))
  {
    return false;
  }
  const int version = block.Byte();
  if (version > 3)
  {
    throw std::runtime_error("its HDF5 format is newer than what is read here. Convert it with "
                             "h5repack --high=2 IN OUT.");
  }
  const bool isOld = version < 2;
  block.Skip(isOld ? 4 : 0);
  this->OffsetSize = static_cast<std::size_t>(block.Byte());
  this->LengthSize = static_cast<std::size_t>(block.Byte());
  if (this->OffsetSize < 2 || this->OffsetSize > 8 || this->LengthSize < 2 || this->LengthSize > 8)
  {
    Hdf5Block::ThrowDamaged();
  }
  block.Skip(isOld ? (version == 0 ? 9 : 13) : 1);
  const std::uint64_t base = this->Offset(block);
  this->Offset(block); // free space, or the extension
  this->Offset(block); // end
  if (isOld)
  {
    this->Offset(block); // information of a driver
    this->Offset(block); // name of the root
  }
  this->Root = this->Offset(block);
  this->Base = base;
  return true;
}

bool Hdf5File::IsAddress(std::uint64_t address) const
{
  const std::size_t bits = 8 * this->OffsetSize;
  const std::uint64_t undefined =
    bits == 64 ? ~std::uint64_t{ 0 } : (std::uint64_t{ 1 } << bits) - 1;
  return address != undefined;
}

Hdf5Block Hdf5File::ReadBlock(std::uint64_t address, std::uint64_t size)
{
  const std::uint64_t at = address + this->Base;
  this->BytesInAll += std::min(size, MostStructureBytes) + 64;
  if (at < address || at > this->FileSize || size > this->FileSize - at ||
    size > MostStructureBytes || this->BytesInAll > MostBytesInAll)
  {
    Hdf5Block::ThrowDamaged();
  }
  std::vector<unsigned char> bytes(static_cast<std::size_t>(size));
  this->File.Read(bytes.data(), bytes.size(), static_cast<std::int64_t>(at));
  return Hdf5Block(std::move(bytes));
}

std::vector<Hdf5File::Message> Hdf5File::ReadMessages(std::uint64_t address)
{
  return this->ReadBlock(address, 4).Begins("OHDR") ? this->ReadNewMessages(address)
                                                    : this->ReadOldMessages(address);
}

void Hdf5File::AddMessage(
  Message message, std::vector<Hdf5Block>& rest, std::vector<Message>& messages)
{
  if (message.Type != ContinuationMessage)
  {
    messages.push_back(std::move(message));
    return;
  }
  const std::uint64_t address = this->Offset(message.Body);
  const std::uint64_t length = this->Length(message.Body);
  if (rest.size() >= MostHeaderParts)
  {
    Hdf5Block::ThrowDamaged();
  }
  rest.push_back(this->ReadBlock(address, length));
}

std::vector<Hdf5File::Message> Hdf5File::ReadOldMessages(std::uint64_t address)
{
  Hdf5Block head = this->ReadBlock(address, 16);
  if (head.Byte() != 1)
  {
    Hdf5Block::ThrowDamaged();
  }
  head.Skip(7);
  std::vector<Hdf5Block> blocks{ this->ReadBlock(address + 16, head.Number(4)) };
  std::vector<Message> messages;
  for (std::size_t b = 0; b < blocks.size(); ++b)
  {
    while (blocks[b].GetLeft() >= 8)
    {
      const int type = static_cast<int>(blocks[b].Number(2));
      const auto size = static_cast<std::size_t>(blocks[b].Number(2));
      const int flags = blocks[b].Byte();
      blocks[b].Skip(3);
      Hdf5Block body = blocks[b].Part(size);
      this->AddMessage({ type, flags, std::move(body) }, blocks, messages);
    }
  }
  return messages;
}

std::vector<Hdf5File::Message> Hdf5File::ReadNewMessages(std::uint64_t address)
{
  constexpr std::uint64_t longest = 4 + 2 + 16 + 4 + 8;
  const std::uint64_t left = this->FileSize - std::min(this->FileSize, address + this->Base);
  Hdf5Block head = this->ReadBlock(address, std::min(longest, left));
  head.Skip(5);
  const int flags = head.Byte();
  head.Skip((flags & 32 ? 16 : 0) + (flags & 16 ? 4 : 0));
  const std::uint64_t size = head.Number(std::size_t{ 1 } << (flags & 3));
  std::vector<Hdf5Block> blocks{ this->ReadBlock(address + head.GetPlace(), size) };
  const std::size_t order = flags & 4 ? 2 : 0;
  std::vector<Message> messages;
  for (std::size_t b = 0; b < blocks.size(); ++b)
  {
    std::size_t end = 0;
    if (b > 0) // those that follow have a signature and a checksum
    {
      end = 4;
      if (!blocks[b].Begins("OCHK"))
      {
        Hdf5Block::ThrowDamaged();
      }
    }
    while (blocks[b].GetLeft() >= 4 + order + end)
    {
      const int type = blocks[b].Byte();
      const auto length = static_cast<std::size_t>(blocks[b].Number(2));
      const int messageFlags = blocks[b].Byte();
      blocks[b].Skip(order);
      Hdf5Block body = blocks[b].Part(length);
      this->AddMessage({ type, messageFlags, std::move(body) }, blocks, messages);
    }
  }
  return messages;
}

std::vector<std::uint64_t> Hdf5File::ParseSpace(Hdf5Block& body) const
{
  const int version = body.Byte();
  const int rank = body.Byte();
  body.Skip(version == 1 ? 6 : 2);
  std::vector<std::uint64_t> shape;
  for (int d = 0; d < rank; ++d)
  {
    shape.push_back(this->Length(body));
  }
  return shape;
}

void Hdf5File::ParseAttribute(Hdf5Block& body, Hdf5Object& object) const
{
  const int version = body.Byte();
  const int flags = body.Byte();
  const auto nameSize = static_cast<std::size_t>(body.Number(2));
  const auto typeSize = static_cast<std::size_t>(body.Number(2));
  const auto spaceSize = static_cast<std::size_t>(body.Number(2));
  body.Skip(version == 3 ? 1 : 0);
  const auto padded = [&](std::size_t size) { return version == 1 ? (size + 7) / 8 * 8 : size; };
  std::string name = body.Part(padded(nameSize)).Text();
  Hdf5Block type = body.Part(padded(typeSize));
  Hdf5Block space = body.Part(padded(spaceSize));
  if (version > 1 && (flags & 3) != 0)
  {
    return; // its type stands elsewhere: none of those that image files have
  }
  Hdf5Attribute attribute;
  attribute.Type = ParseHdf5Type(type);
  const std::vector<std::uint64_t> shape = this->ParseSpace(space);
  std::uint64_t size = attribute.Type.Size;
  for (const std::uint64_t count : shape)
  {
    if (count > MostStructureBytes)
    {
      return;
    }
    size = std::min(size * count, MostStructureBytes);
  }
  attribute.Bytes = body.Take(static_cast<std::size_t>(size));
  object.Attributes[std::move(name)] = std::move(attribute);
}

void Hdf5File::ParseLink(Hdf5Block& body, Hdf5Object& object) const
{
  body.Skip(1);
  const int flags = body.Byte();
  const int type = flags & 8 ? body.Byte() : 0;
  body.Skip((flags & 4 ? 8 : 0) + (flags & 16 ? 1 : 0));
  const auto length = static_cast<std::size_t>(body.Number(std::size_t{ 1 } << (flags & 3)));
  const std::vector<char> name = body.Take(length);
  if (type == 0)
  {
    object.Links[std::string(name.begin(), name.end())] = this->Offset(body);
  }
  else
  {
    object.HasOtherLinks = true;
  }
}

void Hdf5File::ParseLayout(Hdf5Block& body, Hdf5Object& object, ChunkIndex& index) const
{
  constexpr int contiguous = 1;
  constexpr int chunked = 2;
  const int version = body.Byte();
  const int kind = version >= 3 ? body.Byte() : -1;
  object.Layout = Hdf5Object::Elsewhere;
  if (kind == contiguous)
  {
    object.Layout = Hdf5Object::Contiguous;
    object.Address = this->Offset(body);
    object.IsAllocated = this->IsAddress(object.Address);
    object.Address += this->Base;
  }
  if (kind != chunked)
  {
    return;
  }
  object.Layout = Hdf5Object::Chunked;
  const int flags = version >= 4 ? body.Byte() : 0;
  const int rank = body.Byte() - 1; // the last one is the size of a sample
  const auto size = static_cast<std::size_t>(version >= 4 ? body.Byte() : 4);
  index.Address = version >= 4 ? 0 : this->Offset(body);
  for (int d = 0; d < rank; ++d)
  {
    object.ChunkShape.push_back(body.Number(size));
  }
  body.Skip(size);
  if (version >= 4)
  {
    index.Type = body.Byte();
    if (index.Type == 1 && (flags & 2) != 0)
    {
      index.Single.Size = this->Length(body);
      index.Single.Skipped = body.Number(4);
    }
    index.Address = index.Type <= 2 ? this->Offset(body) : 0;
  }
}

Hdf5Object Hdf5File::ReadObject(std::uint64_t address)
{
  Hdf5Object object;
  ChunkIndex index;
  for (Message& message : this->ReadMessages(address))
  {
    Hdf5Block& body = message.Body;
    if ((message.Flags & SharedFlag) != 0)
    {
      if (message.Type == TypeMessage || message.Type == SpaceMessage)
      {
        throw std::runtime_error("it has types or shapes that several of its arrays share, which "
                                 "are not read here. Write it again, each with its own.");
      }
      continue;
    }
    switch (message.Type)
    {
      case SpaceMessage:
        object.Shape = this->ParseSpace(body);
        break;
      case LinkInfoMessage:
      {
        body.Skip(1);
        const int flags = body.Byte();
        body.Skip(flags & 1 ? 8 : 0);
        object.HasOtherLinks = object.HasOtherLinks || this->IsAddress(this->Offset(body));
        break;
      }
      case TypeMessage:
        object.Type = ParseHdf5Type(body);
        break;
      case FillMessage:
        object.FillValue = ParseHdf5FillValue(body);
        break;
      case LinkMessage:
        this->ParseLink(body, object);
        break;
      case ExternalMessage:
        throw std::runtime_error(
          "its samples lie in other files. Convert it with h5repack -l CONTI "
          "IN OUT, or open the raw file itself.");
      case LayoutMessage:
        this->ParseLayout(body, object, index);
        break;
      case FilterMessage:
        object.Filters = ParseHdf5Filters(body);
        break;
      case AttributeMessage:
        this->ParseAttribute(body, object);
        break;
      case GroupMessage:
      {
        const std::uint64_t tree = this->Offset(body);
        this->ReadLinks(tree, this->Offset(body), object);
        break;
      }
      default:
        break;
    }
  }
  if (object.Layout == Hdf5Object::Chunked)
  {
    this->ReadChunks(index, object);
  }
  return object;
}

void Hdf5File::ReadLinks(std::uint64_t tree, std::uint64_t heap, Hdf5Object& object)
{
  Hdf5Block head = this->ReadBlock(heap, 8 + 2 * this->LengthSize + this->OffsetSize);
  if (!head.Begins("HEAP"))
  {
    Hdf5Block::ThrowDamaged();
  }
  head.Skip(4);
  const std::uint64_t size = this->Length(head);
  this->Length(head); // free space
  Hdf5Block names = this->ReadBlock(this->Offset(head), size);
  this->ReadLinkNode(tree, -1, names, object);
}

void Hdf5File::ReadLinkNode(std::uint64_t address, int level, Hdf5Block& names, Hdf5Object& object)
{
  const std::size_t headSize = 8 + 2 * this->OffsetSize;
  const std::size_t entry = this->LengthSize + this->OffsetSize;
  const TreeNode head(this->ReadBlock(address, headSize), 0, level, this->OffsetSize);
  Hdf5Block body = this->ReadBlock(address + headSize, head.Count * entry);
  for (std::size_t i = 0; i < head.Count; ++i)
  {
    this->Length(body); // the key
    const std::uint64_t child = this->Offset(body);
    if (head.Level > 0)
    {
      this->ReadLinkNode(child, head.Level - 1, names, object);
      continue;
    }
    Hdf5Block first = this->ReadBlock(child, 8);
    if (!first.Begins("SNOD") || object.Links.size() > MostLinks)
    {
      Hdf5Block::ThrowDamaged();
    }
    first.Skip(2);
    const auto count = static_cast<std::size_t>(first.Number(2));
    Hdf5Block symbols = this->ReadBlock(child + 8, count * (2 * this->OffsetSize + 24));
    for (std::size_t s = 0; s < count; ++s)
    {
      names.Go(static_cast<std::size_t>(this->Offset(symbols)));
      const std::uint64_t header = this->Offset(symbols);
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

void Hdf5File::AddChunk(
  const std::vector<std::uint64_t>& first, Hdf5Chunk chunk, Hdf5Object& object) const
{
  const std::size_t rank = object.Shape.size();
  std::uint64_t number = 0;
  for (std::size_t d = 0; d < rank; ++d)
  {
    const std::uint64_t size = object.ChunkShape[d];
    if (first[d] % size != 0 || first[d] >= object.Shape[d])
    {
      return; // of an array that was larger before
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
  chunk.Address += this->Base;
  object.Chunks[number] = chunk;
}

void Hdf5File::ReadChunks(const ChunkIndex& index, Hdf5Object& object)
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
  constexpr int tree = 0;
  constexpr int single = 1;
  constexpr int implicit = 2;
  if (index.Type > implicit)
  {
    throw std::runtime_error(
      "the list of its chunks is of a kind that is not read here. Convert it with h5repack -f NONE "
      "-l CONTI IN OUT, or write it without libver='latest'.");
  }
  if (!this->IsAddress(index.Address))
  {
    return; // nothing was written yet
  }
  if (index.Type == tree)
  {
    this->ReadChunkNode(index.Address, -1, object);
    return;
  }
  Hdf5Chunk chunk = index.Single;
  chunk.Size = chunk.Size == 0 ? size : chunk.Size;
  chunk.Address = index.Address;
  std::vector<std::uint64_t> first(object.Shape.size(), 0);
  if (index.Type == single)
  {
    this->AddChunk(first, chunk, object);
    return;
  }
  // All chunks lie one after another, the last dimension fastest.
  bool isDone = false;
  while (!isDone)
  {
    this->AddChunk(first, chunk, object);
    chunk.Address += size;
    isDone = chunk.Address > this->FileSize;
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

void Hdf5File::ReadChunkNode(std::uint64_t address, int level, Hdf5Object& object)
{
  const std::size_t rank = object.Shape.size();
  const std::size_t headSize = 8 + 2 * this->OffsetSize;
  const std::size_t key = 8 + 8 * (rank + 1);
  const TreeNode head(this->ReadBlock(address, headSize), 1, level, this->OffsetSize);
  Hdf5Block body = this->ReadBlock(address + headSize, head.Count * (key + this->OffsetSize));
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
    chunk.Address = this->Offset(body);
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
