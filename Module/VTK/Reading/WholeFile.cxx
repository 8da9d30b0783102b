// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Reading/WholeFile.h"

#include "Core/Platform/HapticFiles.h"
#include "VTK/Base/XmlStructure.h"

#include <vtksys/RegularExpression.hxx>
#include <vtksys/SystemTools.hxx>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <system_error>
#include <zlib.h>

namespace
{
constexpr std::size_t PART_SIZE = 1 << 18; // bytes that are decompressed at once
constexpr int ANY_HEADER = 15 + 32;        // accepts a zlib or gzip header

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
  std::ifstream in = VolumeHaptics::OpenStream(file);
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
        // Several gzip streams may follow one another; anything else after them is ignored.
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

std::string DetectDevice(const std::string& path)
{
  std::string fault;
  return !vtksys::SystemTools::PathExists(path) || VolumeHaptics::CheckRegular(path, fault)
    ? std::string()
    : vtksys::SystemTools::GetFilenameName(path) + " " + fault;
}

std::string DetectDeviceIn(const std::string& folder)
{
  namespace fs = std::filesystem;
  std::error_code trouble;
  for (fs::recursive_directory_iterator at(
         folder, fs::directory_options::skip_permission_denied, trouble);
       !trouble && at != fs::recursive_directory_iterator(); at.increment(trouble))
  {
    const std::string path = at->path().string();
    const std::string fault = at->is_directory(trouble) ? std::string() : DetectDevice(path);
    if (!fault.empty())
    {
      return fault;
    }
  }
  return {};
}

std::string DetectMissingEnd(const std::string& file)
{
  const std::string fault = DetectDevice(file);
  if (!fault.empty())
  {
    return fault;
  }
  const std::string falsehood = VolumeHaptics::DetectFalseXml(file);
  if (!falsehood.empty())
  {
    return falsehood;
  }
  const std::string ending =
    vtksys::SystemTools::LowerCase(vtksys::SystemTools::GetFilenameLastExtension(file));
  if (ending.find(".vtm") != 0 && ending.find(".pv") != 0)
  {
    return {};
  }
  std::ifstream in = VolumeHaptics::OpenStream(file);
  std::string text = ReadPart(in, 0, vtksys::SystemTools::FileLength(file));
  vtksys::RegularExpression piece("(file|Source)=\"([^\"]+)\"");
  while (piece.find(text))
  {
    const std::string name = vtksys::SystemTools::CollapseFullPath(piece.match(2),
      vtksys::SystemTools::GetFilenamePath(vtksys::SystemTools::CollapseFullPath(file)));
    text.erase(0, piece.end());
    // A missing file is left to the reader to report.
    const std::string missing =
      vtksys::SystemTools::FileExists(name, true) ? DetectMissingEnd(name) : std::string();
    if (!missing.empty())
    {
      return vtksys::SystemTools::GetFilenameName(name) + ": " + missing;
    }
  }
  return {};
}

std::string DetectFalseNiftiHeader(const std::string& header)
{
  constexpr unsigned sizes[] = { 348, 540 }; // bytes: NIfTI 1 and Analyze; NIfTI 2
  unsigned char bytes[sizes[1]] = {};
  const std::unique_ptr<gzFile_s, int (*)(gzFile)> file(gzopen(header.c_str(), "rb"), gzclose);
  const int count = file ? gzread(file.get(), bytes, sizes[1]) : 0;
  const auto read = [&bytes](unsigned at, unsigned size, bool isSwapped)
  {
    std::uint64_t number = 0;
    for (unsigned i = 0; i < size; ++i)
    {
      number |= std::uint64_t{ bytes[at + (isSwapped ? size - 1 - i : i)] } << (8 * i);
    }
    return static_cast<std::int64_t>(number);
  };
  for (const unsigned size : sizes)
  {
    for (const bool isSwapped : { false, true })
    {
      if (read(0, 4, isSwapped) != size)
      {
        continue;
      }
      const unsigned first = size == sizes[0] ? 40 : 16, step = size == sizes[0] ? 2 : 8;
      const std::int64_t axes = read(first, step, isSwapped);
      if (count < static_cast<int>(size))
      {
        return "its header is truncated";
      }
      double voxels = axes >= 1 && axes <= 7 ? 1.0 : 0.0;
      for (unsigned i = 1; voxels > 0.0 && i <= axes; ++i)
      {
        const std::int64_t along = read(first + i * step, step, isSwapped);
        const std::int64_t least = i <= 3 ? 1 : 0, most = step == 2 ? 32767 : 2147483647;
        const bool isTrue = along >= least && along <= most;
        voxels *= isTrue ? std::max(1.0, static_cast<double>(along)) : 0.0;
      }
      if (!(voxels > 0.0 && voxels < 1e15))
      {
        return "its header is damaged: its axes have impossible sizes";
      }
      const std::int64_t type = read(size == sizes[0] ? 70 : 12, 2, isSwapped);
      // Data types as numbered in nifti1.h, from 8-bit integers to colours with opacity.
      constexpr std::int64_t types[] = { 2, 4, 8, 16, 32, 64, 128, 256, 512, 768, 1024, 1280, 1792,
        2304 };
      const bool isKnown = std::find(std::begin(types), std::end(types), type) != std::end(types);
      return isKnown ? std::string()
                     : "its samples have the type " + std::to_string(type) + ", which is unknown";
    }
  }
  return "it does not begin like one";
}
} // namespace Explore
