// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Regions/Formats/LargeFile.h"

#include "vtksys/SystemTools.hxx"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iterator>
#include <stdexcept>

namespace VolumeHaptics
{
namespace
{

bool HasEnding(const std::string& name, const std::string& ending)
{
  return name.size() >= ending.size() &&
    std::equal(ending.rbegin(), ending.rend(), name.rbegin(),
      [](char a, char b) { return a == std::tolower(static_cast<unsigned char>(b)); });
}

/** A file format: the extension of its files or folders, and the function that opens them. */
struct KnownFormat
{
  const char* Ending;
  const char* Name;
  LargeFileOpener* Open;
};

constexpr KnownFormat TIFF_STACK{ ".tif", "TIFF", OpenTiff };
constexpr KnownFormat ZARR_FOLDER{ ".zarr", "Zarr", OpenZarr };
constexpr KnownFormat FORMATS[] = {
  { ".vtkhdf", "VTKHDF", OpenVtkHdf },
  { ".hdf", "VTKHDF", OpenVtkHdf },
  { ".mhd", "MetaImage", OpenRawHeader },
  { ".mha", "MetaImage", OpenRawHeader },
  { ".nrrd", "NRRD", OpenRawHeader },
  { ".nhdr", "NRRD", OpenRawHeader },
  { ".mgh", "FreeSurfer", OpenMgh },
  { ".mgz", "FreeSurfer", OpenMgh },
  { ".mnc", "MINC", OpenMinc },
  TIFF_STACK,
  { ".tiff", "TIFF", OpenTiff },
  ZARR_FOLDER,
};

/** Returns the format of a file by its extension, or of a folder by its files; null if unknown. */
const KnownFormat* FindFormat(const std::string& name)
{
  using Files = vtksys::SystemTools;
  if (HasEnding(name, std::string(ZARR_FOLDER.Ending) + "/"))
  {
    return &ZARR_FOLDER;
  }
  const auto holds = [&name](const char* file) { return Files::PathExists(name + "/" + file); };
  const auto found = std::find_if(std::begin(FORMATS), std::end(FORMATS),
    [&name](const KnownFormat& format) { return HasEnding(name, format.Ending); });
  if (found != std::end(FORMATS) &&
    (found->Open == ZARR_FOLDER.Open || !Files::FileIsDirectory(name)))
  {
    return found;
  }
  if (!Files::FileIsDirectory(name))
  {
    return nullptr;
  }
  return holds(".zarray") || holds(".zgroup") || holds("zarr.json") ? &ZARR_FOLDER
    : IsTiffFolder(name)                                            ? &TIFF_STACK
                                                                    : nullptr;
}

void CheckSpacing(const LargeFile& file)
{
  for (const double along : file.Spacing)
  {
    if (!std::isnormal(along) || !(along > 0.0))
    {
      throw std::runtime_error("its spacing is no finite number above zero. Correct the spacing in "
                               "its header.");
    }
  }
}

} // namespace

std::string GetFormatName(const std::string& name)
{
  const KnownFormat* const format = FindFormat(name);
  return format ? format->Name : "";
}

std::string ListFileEndings()
{
  std::string list;
  for (const KnownFormat& format : FORMATS)
  {
    list += (list.empty() ? "" : " ") + std::string(format.Ending);
  }
  return list;
}

LargeFile OpenLargeFile(const std::string& name, bool mayBeWhole, int volume)
{
  const KnownFormat* const format = FindFormat(name);
  if (format)
  {
    LargeFile file = format->Open(name, mayBeWhole, volume);
    CheckSpacing(file);
    return file;
  }
  if (vtksys::SystemTools::FileIsDirectory(name))
  {
    return IsTiffName(name) ? OpenTiff(name, mayBeWhole, volume)
                            : OpenZarr(name, mayBeWhole, volume); // Zarr: any name
  }
  throw std::runtime_error(
    "its ending is not known. Give a file or folder with one of the endings " + ListFileEndings() +
    "; or, if it is raw, SetFileName() with extent, type and spacing.");
}

int ChooseScalarType(bool isInteger, bool isSigned, std::size_t size)
{
  if (!isInteger)
  {
    return size == sizeof(float) ? VTK_FLOAT : size == sizeof(double) ? VTK_DOUBLE : 0;
  }
  switch (size)
  {
    case 1:
      return isSigned ? VTK_SIGNED_CHAR : VTK_UNSIGNED_CHAR;
    case 2:
      return isSigned ? VTK_SHORT : VTK_UNSIGNED_SHORT;
    case 4:
      return isSigned ? VTK_INT : VTK_UNSIGNED_INT;
    case 8:
      return isSigned ? VTK_LONG_LONG : VTK_UNSIGNED_LONG_LONG;
    default:
      return 0;
  }
}

} // namespace VolumeHaptics
