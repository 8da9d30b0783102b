// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Regions/Formats/Hdf5File.h"

#include "VTK/Regions/Formats/Hdf5Trees.h"

#include <algorithm>

namespace VolumeHaptics
{
namespace
{

/** Limit on the parts of an object's header; real headers have some hundred bytes. */
constexpr std::size_t MostHeaderParts = 4096;
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

} // namespace

std::vector<Hdf5File::Message> Hdf5File::ReadMessages(std::uint64_t address)
{
  return this->Storage.ReadBlock(address, 4).Begins("OHDR") ? this->ReadNewMessages(address)
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
  const std::uint64_t address = this->Storage.Offset(message.Body);
  const std::uint64_t length = this->Storage.Length(message.Body);
  if (rest.size() >= MostHeaderParts)
  {
    Hdf5Block::ThrowDamaged();
  }
  rest.push_back(this->Storage.ReadBlock(address, length));
}

std::vector<Hdf5File::Message> Hdf5File::ReadOldMessages(std::uint64_t address)
{
  Hdf5Block head = this->Storage.ReadBlock(address, 16);
  if (head.Byte() != 1)
  {
    Hdf5Block::ThrowDamaged();
  }
  head.Skip(7);
  std::vector<Hdf5Block> blocks{ this->Storage.ReadBlock(address + 16, head.Number(4)) };
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
  const std::uint64_t left = this->Storage.GetFileSize() -
    std::min(this->Storage.GetFileSize(), address + this->Storage.GetBase());
  Hdf5Block head = this->Storage.ReadBlock(address, std::min(longest, left));
  head.Skip(5);
  const int flags = head.Byte();
  head.Skip((flags & 32 ? 16 : 0) + (flags & 16 ? 4 : 0));
  const std::uint64_t size = head.Number(std::size_t{ 1 } << (flags & 3));
  std::vector<Hdf5Block> blocks{ this->Storage.ReadBlock(address + head.GetPlace(), size) };
  const std::size_t order = flags & 4 ? 2 : 0;
  std::vector<Message> messages;
  for (std::size_t b = 0; b < blocks.size(); ++b)
  {
    std::size_t end = 0;
    if (b > 0) // continuation blocks have a signature and a checksum
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

std::vector<std::uint64_t> Hdf5File::ParseSpace(
  Hdf5Block& body, std::vector<std::uint64_t>* most) const
{
  const int version = body.Byte();
  const int rank = body.Byte();
  const int flags = body.Byte();
  body.Skip(version == 1 ? 5 : 1);
  std::vector<std::uint64_t> shape;
  for (int d = 0; d < rank; ++d)
  {
    shape.push_back(this->Storage.Length(body));
  }
  for (int d = 0; most && d < rank; ++d)
  {
    const std::uint64_t length = (flags & 1) != 0 ? this->Storage.Length(body) : shape[d];
    // A length without limit has all bits set, like an address of nothing.
    const bool isEndless = length >> (8 * this->Storage.GetLengthSize() - 1) != 0;
    most->push_back(isEndless ? Hdf5Object::Endless : length);
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
    return; // its type is stored elsewhere, which image files do not do
  }
  Hdf5Attribute attribute;
  attribute.Type = ParseHdf5Type(type);
  const std::vector<std::uint64_t> shape = this->ParseSpace(space);
  std::uint64_t size = attribute.Type.Size;
  for (const std::uint64_t count : shape)
  {
    if (count > Hdf5Storage::MostBytes)
    {
      return;
    }
    size = std::min(size * count, Hdf5Storage::MostBytes);
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
    object.Links[std::string(name.begin(), name.end())] = this->Storage.Offset(body);
  }
  else
  {
    object.HasOtherLinks = true;
  }
}

void Hdf5File::ParseLayout(Hdf5Block& body, Hdf5Object& object, Hdf5ChunkIndex& index) const
{
  constexpr int contiguous = 1;
  constexpr int chunked = 2;
  const int version = body.Byte();
  const int kind = version >= 3 ? body.Byte() : -1;
  object.Layout = Hdf5Object::Elsewhere;
  if (kind == contiguous)
  {
    object.Layout = Hdf5Object::Contiguous;
    object.Address = this->Storage.Offset(body);
    object.IsAllocated = this->Storage.IsAddress(object.Address);
    object.Address += this->Storage.GetBase();
  }
  if (kind != chunked)
  {
    return;
  }
  object.Layout = Hdf5Object::Chunked;
  const int flags = version >= 4 ? body.Byte() : 0;
  const int rank = body.Byte() - 1; // the last number is the size of a sample
  const auto size = static_cast<std::size_t>(version >= 4 ? body.Byte() : 4);
  index.Address = version >= 4 ? 0 : this->Storage.Offset(body);
  for (int d = 0; d < rank; ++d)
  {
    object.ChunkShape.push_back(body.Number(size));
  }
  body.Skip(size);
  if (version >= 4)
  {
    index.Type = body.Byte();
    if (index.Type == Hdf5ChunkIndex::Single && (flags & 2) != 0)
    {
      index.Chunk.Size = this->Storage.Length(body);
      index.Chunk.Skipped = body.Number(4);
    }
    // The headers of the arrays repeat these parameters, so they are skipped.
    const bool isFixed = index.Type == Hdf5ChunkIndex::FixedArray;
    const bool isExtensible = index.Type == Hdf5ChunkIndex::ExtensibleArray;
    body.Skip(isFixed ? 1 : isExtensible ? 5 : 0);
    index.Address = index.Type < Hdf5ChunkIndex::NewTree ? this->Storage.Offset(body) : 0;
  }
}

Hdf5Object Hdf5File::ReadObject(std::uint64_t address)
{
  Hdf5Object object;
  Hdf5ChunkIndex index;
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
        object.MostShape.clear();
        object.Shape = this->ParseSpace(body, &object.MostShape);
        break;
      case LinkInfoMessage:
      {
        body.Skip(1);
        const int flags = body.Byte();
        body.Skip(flags & 1 ? 8 : 0);
        object.HasOtherLinks =
          object.HasOtherLinks || this->Storage.IsAddress(this->Storage.Offset(body));
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
        const std::uint64_t tree = this->Storage.Offset(body);
        Hdf5Trees(this->Storage).ReadLinks(tree, this->Storage.Offset(body), object);
        break;
      }
      default:
        break;
    }
  }
  if (object.Layout == Hdf5Object::Chunked)
  {
    Hdf5Trees(this->Storage).ReadChunks(index, object);
  }
  return object;
}

} // namespace VolumeHaptics
