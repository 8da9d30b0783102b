// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Large/Hdf5File.h"

#include <algorithm>
#include <cstring>
#include <limits>

namespace VolumeHaptics
{
namespace
{

/** Of all parts of an object's header; real ones have some hundred bytes. */
constexpr std::size_t MostHeaderParts = 4096;
constexpr std::uint64_t MostStructureBytes = std::uint64_t{ 1 } << 26;

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

template <typename T>
double NumberAt(const char* bytes)
{
  T number;
  std::memcpy(&number, bytes, sizeof(T));
  return static_cast<double>(number);
}

/** One number, least significant byte first as this computer has it, or NaN. */
double NumberOf(const Hdf5Type& type, const char* bytes)
{
  if (type.Kind == Hdf5Type::Float)
  {
    return type.Size == 4 ? NumberAt<float>(bytes) : NumberAt<double>(bytes);
  }
  switch (type.Size)
  {
    case 1:
      return type.IsSigned ? NumberAt<std::int8_t>(bytes) : NumberAt<std::uint8_t>(bytes);
    case 2:
      return type.IsSigned ? NumberAt<std::int16_t>(bytes) : NumberAt<std::uint16_t>(bytes);
    case 4:
      return type.IsSigned ? NumberAt<std::int32_t>(bytes) : NumberAt<std::uint32_t>(bytes);
    case 8:
      return type.IsSigned ? NumberAt<std::int64_t>(bytes) : NumberAt<std::uint64_t>(bytes);
    default:
      return std::numeric_limits<double>::quiet_NaN();
  }
}

/** Numbers of a length that this computer has, without unused bits; all others are Other. */
Hdf5Type ParseType(Hdf5Block& body)
{
  Hdf5Type type;
  const int kind = body.Byte() & 15;
  const auto bits = static_cast<unsigned int>(body.Number(3));
  type.Size = static_cast<std::size_t>(body.Number(4));
  const bool hasUsualSize = type.Size == 1 || type.Size == 2 || type.Size == 4 || type.Size == 8;
  type.IsBig = (bits & 1U) != 0;
  if (kind == 3)
  {
    type.Kind = Hdf5Type::Text;
  }
  else if (kind == 0 && hasUsualSize)
  {
    const std::uint64_t first = body.Number(2);
    const std::uint64_t precision = body.Number(2);
    type.IsSigned = (bits & 8U) != 0;
    type.Kind = first == 0 && precision == 8 * type.Size ? Hdf5Type::Integer : Hdf5Type::Other;
  }
  else if (kind == 1 && (type.Size == 4 || type.Size == 8))
  {
    body.Skip(4);
    const int exponentAt = body.Byte();
    const int exponentSize = body.Byte();
    const bool isIeee = (bits & 64U) == 0 &&
      (type.Size == 4 ? exponentAt == 23 && exponentSize == 8
                      : exponentAt == 52 && exponentSize == 11);
    type.Kind = isIeee ? Hdf5Type::Float : Hdf5Type::Other;
    type.IsSigned = true;
  }
  return type;
}

std::vector<char> ParseFill(Hdf5Block& body)
{
  const int version = body.Byte();
  bool isDefined = false;
  if (version >= 3)
  {
    isDefined = (body.Byte() & 32) != 0;
  }
  else
  {
    body.Skip(2);
    isDefined = body.Byte() != 0 || version < 2;
  }
  return isDefined ? body.Take(static_cast<std::size_t>(body.Number(4))) : std::vector<char>();
}

std::vector<Hdf5Filter> ParseFilters(Hdf5Block& body)
{
  const int version = body.Byte();
  const int count = body.Byte();
  body.Skip(version == 1 ? 6 : 0);
  std::vector<Hdf5Filter> filters;
  for (int i = 0; i < count; ++i)
  {
    Hdf5Filter filter;
    filter.Id = static_cast<int>(body.Number(2));
    const bool hasName = version == 1 || filter.Id >= 256;
    const auto name = static_cast<std::size_t>(hasName ? body.Number(2) : 0);
    body.Skip(2);
    const auto values = static_cast<std::size_t>(body.Number(2));
    body.Skip(version == 1 ? (name + 7) / 8 * 8 : name);
    for (std::size_t v = 0; v < values; ++v)
    {
      const auto value = static_cast<std::size_t>(body.Number(4));
      filter.SampleSize = v == 0 ? value : filter.SampleSize;
    }
    body.Skip(version == 1 && values % 2 == 1 ? 4 : 0);
    filters.push_back(filter);
  }
  return filters;
}

} // namespace

std::vector<double> Hdf5Attribute::GetNumbers() const
{
  std::vector<double> numbers;
  const bool isNumber = this->Type.Kind == Hdf5Type::Integer || this->Type.Kind == Hdf5Type::Float;
  if (!isNumber)
  {
    return numbers;
  }
  const std::uint16_t probe = 1;
  const bool isHostBig = *reinterpret_cast<const unsigned char*>(&probe) == 0;
  std::vector<char> number(this->Type.Size);
  for (std::size_t at = 0; at + this->Type.Size <= this->Bytes.size(); at += this->Type.Size)
  {
    std::copy_n(
      this->Bytes.begin() + static_cast<std::ptrdiff_t>(at), number.size(), number.begin());
    if (this->Type.IsBig != isHostBig)
    {
      std::reverse(number.begin(), number.end());
    }
    numbers.push_back(NumberOf(this->Type, number.data()));
  }
  return numbers;
}

std::string Hdf5Attribute::GetText() const
{
  if (this->Type.Kind != Hdf5Type::Text)
  {
    return {};
  }
  const std::string text(this->Bytes.begin(), this->Bytes.end());
  return text.substr(0, text.find('\0'));
}

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

Hdf5Block Hdf5File::ReadBlock(std::uint64_t address, std::uint64_t size) const
{
  const std::uint64_t at = address + this->Base;
  if (at < address || at > this->FileSize || size > this->FileSize - at ||
    size > MostStructureBytes)
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
  attribute.Type = ParseType(type);
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
        object.Type = ParseType(body);
        break;
      case FillMessage:
        object.FillValue = ParseFill(body);
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
        object.Filters = ParseFilters(body);
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

} // namespace VolumeHaptics
