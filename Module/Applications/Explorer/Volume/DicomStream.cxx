// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/Explorer/Volume/DicomStream.h"

#include <vtksys/SystemTools.hxx>

#include <algorithm>
#include <iterator>

namespace Explore
{
DicomStream::DicomStream(const std::string& path)
  : File(path.c_str(), std::ios::binary)
  , Length(vtksys::SystemTools::FileLength(path))
{
}

std::uint64_t DicomStream::Left()
{
  return this->Length - std::min<std::uint64_t>(this->Length, this->Place());
}

void DicomStream::GoTo(std::uint64_t place)
{
  this->File.clear();
  this->File.seekg(static_cast<std::streamoff>(place));
}

std::string DicomStream::Read(std::size_t count)
{
  std::string bytes(count, '\0');
  this->File.read(&bytes[0], static_cast<std::streamsize>(count));
  bytes.resize(static_cast<std::size_t>(this->File.gcount()));
  return bytes;
}

std::uint32_t DicomStream::Number(
  const std::string& bytes, std::size_t first, std::size_t count) const
{
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < count && first + i < bytes.size(); ++i)
  {
    const std::size_t at = first + (this->IsBig ? i : count - 1 - i);
    number = number << 8 | static_cast<unsigned char>(bytes[at]);
  }
  return number;
}

bool DicomStream::Next(Element& element)
{
  const std::string head = this->Read(8);
  if (head.size() < 8)
  {
    return false;
  }
  element.Tag = this->Number(head, 0, 2) << 16 | this->Number(head, 2, 2);
  element.Length = this->Number(head, 4, 4);
  const bool isItem = element.Tag >> 16 == 0xfffe;
  element.IsSequence = !isItem && element.Length == UNKNOWN_LENGTH;
  // The part of a file before its data set is always explicit.
  if (isItem || !this->IsExplicit)
  {
    return true;
  }
  const std::string type = head.substr(4, 2);
  static const char* const longTypes[] = { "OB", "OD", "OF", "OL", "OV", "OW", "SQ", "SV", "UC",
    "UN", "UR", "UT", "UV" };
  const bool isLong =
    std::find(std::begin(longTypes), std::end(longTypes), type) != std::end(longTypes);
  element.Length = this->Number(head, 6, 2);
  element.IsSequence = false;
  if (isLong)
  {
    const std::string length = this->Read(4);
    if (length.size() < 4)
    {
      return false;
    }
    element.Length = this->Number(length, 0, 4);
    element.IsSequence = element.Length == UNKNOWN_LENGTH;
  }
  return true;
}

bool DicomStream::Skip(const Element& element, int depth)
{
  if (element.Length != UNKNOWN_LENGTH)
  {
    if (element.Length > this->Left())
    {
      return false;
    }
    this->GoTo(this->Place() + element.Length);
    return true;
  }
  Element part;
  while (depth < DEEPEST && this->Next(part))
  {
    if (part.Tag == SEQUENCE_END || part.Tag == ITEM_END)
    {
      return true;
    }
    if (!this->Skip(part, depth + 1))
    {
      return false;
    }
  }
  return false;
}

bool DicomStream::SkipItems()
{
  Element item;
  while (this->Left() > 0)
  {
    if (!this->Next(item))
    {
      return false;
    }
    if (item.Tag == SEQUENCE_END)
    {
      return true;
    }
    if (item.Tag != ITEM || item.Length == UNKNOWN_LENGTH || !this->Skip(item))
    {
      return false;
    }
  }
  return true;
}
} // namespace Explore
