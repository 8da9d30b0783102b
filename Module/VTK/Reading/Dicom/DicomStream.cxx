// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Reading/Dicom/DicomStream.h"

#include <vtksys/FStream.hxx>
#include <vtksys/SystemTools.hxx>

#include <algorithm>
#include <cstring>
#include <iterator>
#include <sstream>
#include <vector>
#include <zlib.h>

namespace Explore
{
std::uint64_t InflateDicom(
  const std::string& path, std::uint64_t from, std::uint64_t most, std::string& kept)
{
  constexpr std::size_t part = 1 << 18; // bytes at once
  kept.clear();
  vtksys::ifstream file(path.c_str(), std::ios::binary);
  file.seekg(static_cast<std::streamoff>(from));
  z_stream stream = {};
  if (!file || inflateInit2(&stream, -MAX_WBITS) != Z_OK)
  {
    return 0;
  }
  const std::unique_ptr<z_stream, int (*)(z_stream*)> end(&stream, &inflateEnd);
  std::vector<char> packed(part), plain(part);
  std::uint64_t count = 0;
  int state = Z_OK;
  while (state == Z_OK)
  {
    if (stream.avail_in == 0)
    {
      file.read(packed.data(), part);
      stream.next_in = reinterpret_cast<Bytef*>(packed.data());
      stream.avail_in = static_cast<uInt>(file.gcount());
    }
    stream.next_out = reinterpret_cast<Bytef*>(plain.data());
    stream.avail_out = part;
    state = inflate(&stream, Z_NO_FLUSH);
    const std::size_t size = part - stream.avail_out;
    kept.append(plain.data(), std::min<std::uint64_t>(size, most - kept.size()));
    count += size;
  }
  return state == Z_STREAM_END ? count : 0;
}

DicomStream::DicomStream(const std::string& path)
  : Path(path)
  , File(std::make_unique<vtksys::ifstream>(path.c_str(), std::ios::binary))
  , Length(vtksys::SystemTools::FileLength(path))
{
}

bool DicomStream::Inflate()
{
  constexpr std::uint64_t longestHeader = std::uint64_t{ 1 } << 26;
  std::string bytes;
  this->Length = InflateDicom(this->Path, this->Place(), longestHeader, bytes);
  this->File = std::make_unique<std::istringstream>(bytes);
  return this->Length > 0;
}

std::uint64_t DicomStream::Left()
{
  return this->Length - std::min<std::uint64_t>(this->Length, this->Place());
}

void DicomStream::GoTo(std::uint64_t place)
{
  this->File->clear();
  this->File->seekg(static_cast<std::streamoff>(place));
}

std::string DicomStream::Read(std::size_t count)
{
  std::string bytes(count, '\0');
  this->File->read(&bytes[0], static_cast<std::streamsize>(count));
  bytes.resize(static_cast<std::size_t>(this->File->gcount()));
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

double DicomStream::Real(const std::string& bytes) const
{
  std::uint64_t bits = this->Number(bytes, this->IsBig ? 0 : 4, 4);
  bits = bits << 32 | this->Number(bytes, this->IsBig ? 4 : 0, 4);
  double real = 0.0;
  if (bytes.size() == sizeof(real))
  {
    std::memcpy(&real, &bits, sizeof(real));
  }
  else if (bytes.size() == sizeof(float))
  {
    const std::uint32_t half = this->Number(bytes, 0, 4);
    float single;
    std::memcpy(&single, &half, sizeof(single));
    real = single;
  }
  return real;
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
