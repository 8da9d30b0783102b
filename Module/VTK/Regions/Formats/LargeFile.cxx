// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Regions/Formats/LargeFile.h"

#include "VTK/Regions/Formats/RawHeader.h"
#include "VTK/Regions/Formats/TiffFile.h"
#include "VTK/Regions/Formats/VtkHdfFile.h"
#include "VTK/Regions/Formats/ZarrFile.h"

#include "vtksys/SystemTools.hxx"

#include <algorithm>
#include <cctype>
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

/**
 * Whether a name may be that of Zarr data. Accepts any folder, because Zarr groups may have any
 * name.
 */
bool IsZarrName(const std::string& name)
{
  return HasEnding(name, ".zarr") || HasEnding(name, ".zarr/") ||
    vtksys::SystemTools::FileIsDirectory(name);
}

bool IsHeaderName(const std::string& name)
{
  return HasEnding(name, ".mhd") || HasEnding(name, ".mha") || HasEnding(name, ".nhdr") ||
    HasEnding(name, ".nrrd");
}

} // namespace

bool IsLargeFileName(const std::string& name)
{
  return HasEnding(name, ".vtkhdf") || HasEnding(name, ".hdf") || IsZarrName(name) ||
    IsHeaderName(name) || IsTiffName(name);
}

std::string GetFormatName(const std::string& name)
{
  using Files = vtksys::SystemTools;
  const bool isFolder = Files::FileIsDirectory(name);
  const auto holds = [&name](const char* file) { return Files::PathExists(name + "/" + file); };
  if (HasEnding(name, ".zarr") || HasEnding(name, ".zarr/") ||
    (isFolder && (holds(".zarray") || holds(".zgroup") || holds("zarr.json"))))
  {
    return "Zarr";
  }
  if (isFolder)
  {
    return IsTiffFolder(name) ? "TIFF" : "";
  }
  return HasEnding(name, ".vtkhdf") || HasEnding(name, ".hdf") ? "VTKHDF"
    : HasEnding(name, ".mhd") || HasEnding(name, ".mha")       ? "MetaImage"
    : HasEnding(name, ".nrrd") || HasEnding(name, ".nhdr")     ? "NRRD"
    : IsTiffName(name)                                         ? "TIFF"
                                                               : "";
}

LargeFile OpenLargeFile(const std::string& name, bool mayBeWhole)
{
  if (!IsLargeFileName(name))
  {
    throw std::runtime_error(
      "its ending is not known. Give a .vtkhdf, .mhd, .mha, .nhdr, .nrrd, .tif or .tiff file or "
      "a .zarr folder; or, if it is raw, SetFileName() with extent, type "
      "and spacing.");
  }
  return IsTiffName(name) ? OpenTiff(name)
    : IsZarrName(name)    ? OpenZarr(name)
    : IsHeaderName(name)  ? OpenRawHeader(name, mayBeWhole)
                          : OpenVtkHdf(name);
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
