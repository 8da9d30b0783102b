// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Reading/WholeFile.h"

#include <vtksys/RegularExpression.hxx>
#include <vtksys/SystemTools.hxx>

#include <algorithm>
#include <fstream>
#include <memory>
#include <zlib.h>

namespace
{
constexpr std::size_t PART_SIZE = 1 << 18; // bytes that are unpacked at once
constexpr int ANY_HEADER = 15 + 32;        // accepts the header of zlib or of gzip
constexpr std::size_t LONGEST_END = 1024;  // bytes in which the end of an XML file is searched for

std::string ReadPart(std::ifstream& in, std::size_t from, std::size_t size)
{
  std::string part(size, '\0');
  in.seekg(static_cast<std::streamoff>(from));
  in.read(part.data(), static_cast<std::streamsize>(size));
  part.resize(static_cast<std::size_t>(std::max<std::streamsize>(in.gcount(), 0)));
  return part;
}
} // namespace

namespace Explore
{
double CountUnpacked(const std::string& file, std::size_t offset)
{
  std::ifstream in(file, std::ios::binary);
  in.seekg(static_cast<std::streamoff>(offset));
  z_stream stream = {};
  if (!in || inflateInit2(&stream, ANY_HEADER) != Z_OK)
  {
    return -1.0;
  }
  const std::unique_ptr<z_stream, int (*)(z_stream*)> end(&stream, &inflateEnd);
  const auto packed = std::make_unique<char[]>(PART_SIZE);
  const auto plain = std::make_unique<char[]>(PART_SIZE);
  double count = 0.0;
  int state = Z_STREAM_END;
  bool hasAny = false;
  while (in.read(packed.get(), PART_SIZE), in.gcount() > 0)
  {
    stream.next_in = reinterpret_cast<Bytef*>(packed.get());
    stream.avail_in = static_cast<uInt>(in.gcount());
    do
    {
      if (state == Z_STREAM_END && stream.avail_in > 0)
      {
        // Several gzip streams may follow each other. Other data after them do not belong to the
        // contents.
        const bool isGzip = *stream.next_in == 0x1f;
        if (hasAny && !isGzip)
        {
          return count;
        }
        hasAny = true;
        inflateReset(&stream);
      }
      stream.next_out = reinterpret_cast<Bytef*>(plain.get());
      stream.avail_out = PART_SIZE;
      state = inflate(&stream, Z_NO_FLUSH);
      count += static_cast<double>(PART_SIZE - stream.avail_out);
    } while ((state == Z_OK && (stream.avail_in > 0 || stream.avail_out == 0)) ||
      (state == Z_STREAM_END && stream.avail_in > 0));
    if (state != Z_OK && state != Z_STREAM_END && state != Z_BUF_ERROR)
    {
      return -1.0;
    }
  }
  return hasAny && state == Z_STREAM_END ? count : -1.0;
}

std::string DetectMissingEnd(const std::string& file)
{
  std::ifstream in(file, std::ios::binary);
  const std::size_t size = vtksys::SystemTools::FileLength(file);
  const std::size_t last = std::min(size, LONGEST_END);
  if (ReadPart(in, size - last, last).find("</VTKFile>") == std::string::npos)
  {
    return "the file ends before its last element";
  }
  if (vtksys::SystemTools::LowerCase(file).find(".vtm") == std::string::npos)
  {
    return {};
  }
  in.clear();
  std::string text = ReadPart(in, 0, size);
  vtksys::RegularExpression piece("file=\"([^\"]+)\"");
  while (piece.find(text))
  {
    const std::string name = vtksys::SystemTools::CollapseFullPath(piece.match(1),
      vtksys::SystemTools::GetFilenamePath(vtksys::SystemTools::CollapseFullPath(file)));
    text.erase(0, piece.end());
    // The reader reports a missing piece.
    const std::string missing =
      vtksys::SystemTools::FileExists(name, true) ? DetectMissingEnd(name) : std::string();
    if (!missing.empty())
    {
      return vtksys::SystemTools::GetFilenameName(name) + ": " + missing;
    }
  }
  return {};
}
} // namespace Explore
