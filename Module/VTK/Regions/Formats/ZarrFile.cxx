// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Regions/Formats/LargeFile.h"

#include "Core/Platform/HapticFiles.h"
#include "VTK/Base/ByteOrder.h"
#include "VTK/Base/LengthUnit.h"
#include "VTK/Regions/Formats/FurtherAxes.h"
#include "VTK/Regions/Formats/ZarrArray.h"

#include "vtk_jsoncpp.h"

#include "vtksys/SystemTools.hxx"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>
#include <utility>

namespace VolumeHaptics
{
namespace
{

/** Scale and translation along one axis of an array. */
struct AxisScale
{
  double Scale = 1.0;
  double Translation = 0.0;
};

/**
 * Opens an array at fixed indices along all dimensions except the last three, and adds it to the
 * file.
 */
void AddZarrLevel(const ZarrArray& opened, const std::vector<std::size_t>& before, LargeFile& file)
{
  const auto array = std::make_shared<ZarrArray>(opened);
  array->Before = before;
  ChunkedVolume volume;
  const std::size_t x = array->Shape.size() - 1;
  for (std::size_t a = 0; a < 3; ++a)
  {
    if (array->Shape[x - a] > static_cast<std::uint64_t>(std::numeric_limits<int>::max()))
    {
      throw std::runtime_error("it has more samples along an axis than an image can have.");
    }
    file.Extent[2 * a] = 0;
    file.Extent[2 * a + 1] = static_cast<int>(array->Shape[x - a]) - 1;
    volume.ChunkSize[a] = static_cast<std::int64_t>(array->ChunkShape[x - a]);
  }
  file.ScalarType = array->ScalarType;
  file.ChunkSize = volume.ChunkSize;
  volume.Extent = file.Extent;
  volume.SampleSize = array->SampleSize;
  volume.IsSwapped = IsOtherByteOrder(array->IsBig);
  volume.FillValue = array->FillValue;
  volume.Load = [array](const ChunkPlace& place, std::vector<char>& bytes)
  { return array->LoadChunk(place, bytes); };
  file.Read = [volume](const int box[6], void* samples)
  {
    volume.Read(box, samples);
    return true;
  };
}

void ApplyTransformations(const Json::Value& steps, std::vector<AxisScale>& axes)
{
  for (const Json::Value& step : steps)
  {
    const std::string type = step["type"].asString();
    const Json::Value& numbers = step[type];
    const bool isScale = type == "scale";
    if (type == "identity")
    {
      continue;
    }
    if ((!isScale && type != "translation") || numbers.size() != axes.size())
    {
      throw std::runtime_error("it has a coordinate transformation that is neither a scale nor a "
                               "translation of all axes. Open its array itself, and set spacing "
                               "and origin.");
    }
    for (Json::ArrayIndex a = 0; a < numbers.size(); ++a)
    {
      const double number = numbers[a].asDouble();
      axes[a].Scale *= isScale ? number : 1.0;
      axes[a].Translation = isScale ? axes[a].Translation * number : axes[a].Translation + number;
    }
  }
}

/** Throws unless the axes end with z, y and x. */
void CheckAxes(const Json::Value& axes, std::size_t rank)
{
  if (!axes.isArray())
  {
    return; // before version 0.3, the axes always end with z, y and x
  }
  std::string last;
  for (const Json::Value& axis : axes)
  {
    last += axis.isObject() ? axis["name"].asString() : axis.asString();
  }
  std::transform(last.begin(), last.end(), last.begin(),
    [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  if (axes.size() != rank || last.size() < 3 || last.substr(last.size() - 3) != "zyx")
  {
    throw std::runtime_error("its axes are " + Printable(last) +
      ", and a volume needs z, y and x, as the last ones. Write it with these axes last.");
  }
}

/** Returns the metadata of an axis: null, a name, or an object that may have a unit. */
const Json::Value& GetAxis(const Json::Value& axes, std::size_t axis)
{
  return axes.isArray() ? axes[static_cast<Json::ArrayIndex>(axis)] : Json::Value::nullSingleton();
}

/** Returns the unit of an axis; empty if it has none. */
std::string NameUnit(const Json::Value& axes, std::size_t axis)
{
  const Json::Value& entry = GetAxis(axes, axis);
  return entry.isObject() ? entry["unit"].asString() : std::string();
}

/** Returns the length (mm) of an axis's unit; 1 if the unit is missing or unknown. */
double ReadUnit(const Json::Value& axes, std::size_t axis)
{
  const double unit = MillimetresPerUnit(NameUnit(axes, axis));
  return unit > 0.0 ? unit : 1.0;
}

/** Returns the names of the channels from OME-Zarr's display settings. */
std::vector<std::string> ReadChannelNames(const Json::Value& attributes)
{
  std::vector<std::string> names;
  const Json::Value& omero = attributes["omero"];
  for (const Json::Value& channel :
    omero.isObject() ? omero["channels"] : Json::Value::nullSingleton())
  {
    const bool isNamed = channel.isObject() && channel["label"].isString();
    names.push_back(isNamed ? channel["label"].asString() : "");
  }
  return names;
}

/**
 * Chooses a volume of an array by its number: see ChooseVolume(). Returns the index along each
 * dimension except the last three.
 */
std::vector<std::size_t> ChooseInArray(const ZarrArray& array, const Json::Value& axes,
  const std::vector<std::string>& channels, int number, LargeFile& file)
{
  std::vector<FurtherAxis> further;
  for (std::size_t a = array.Shape.size() - 3; a-- > 0;)
  {
    const Json::Value& axis = GetAxis(axes, a);
    const std::string name = Printable(axis.isObject() ? axis["name"].asString() : axis.asString());
    const bool isChannel = name == "c" || name == "C";
    const bool isTime = name == "t" || name == "T";
    further.push_back({ isChannel ? "channel"
        : isTime                  ? "time"
        : name.empty()            ? "volume"
                                  : "volume along " + name,
      static_cast<std::size_t>(array.Shape[a]),
      isChannel ? channels : std::vector<std::string>() });
  }
  std::vector<std::size_t> indices = ChooseVolume(further, number, file);
  std::reverse(indices.begin(), indices.end());
  return indices;
}

/**
 * Opens one resolution level. For a coarser level of `finest`, uses the same volume as that level.
 */
LargeFile OpenDataset(const std::string& folder, const Json::Value& attributes,
  const Json::Value& dataset, int volume, const LargeFile* finest)
{
  const Json::Value& scales = attributes["multiscales"][0];
  const ZarrArray array = OpenZarrArray(folder + "/" + dataset["path"].asString());
  const std::size_t rank = array.Shape.size();
  CheckAxes(scales["axes"], rank);
  std::vector<AxisScale> axes(rank);
  ApplyTransformations(dataset["coordinateTransformations"], axes);
  ApplyTransformations(scales["coordinateTransformations"], axes);
  LargeFile file;
  const std::vector<std::size_t> before =
    ChooseInArray(array, scales["axes"], ReadChannelNames(attributes), volume, file);
  if (finest && file.Volumes != finest->Volumes)
  {
    throw std::runtime_error("a coarser level of it has other volumes than the finest one.");
  }
  AddZarrLevel(array, before, file);
  for (std::size_t a = 0; a < 3; ++a)
  {
    const AxisScale& axis = axes[rank - 1 - a];
    if (!std::isfinite(axis.Scale) || axis.Scale == 0.0 || !std::isfinite(axis.Translation))
    {
      throw std::runtime_error("its scale is zero or not finite. Correct its .zattrs.");
    }
    const double unit = ReadUnit(scales["axes"], rank - 1 - a);
    file.Spacing[a] = axis.Scale * unit;
    file.Origin[a] = axis.Translation * unit;
    const std::string name = NameUnit(scales["axes"], rank - 1);
    if (a == 0 && name.empty())
    {
      file.Notes.emplace_back("its axes have no unit: lengths are taken for millimetres");
    }
    else if (a == 0 && name != "millimeter")
    {
      file.Notes.push_back(MillimetresPerUnit(name) > 0.0
          ? "lengths turned from the unit " + Printable(name) + " into millimetres"
          : "the unit " + Printable(name) + " is not known: lengths are taken for millimetres");
    }
  }
  return file;
}

/** Opens the finest resolution level and adds the coarser levels. */
LargeFile OpenMultiscales(const std::string& folder, const Json::Value& attributes, int volume)
{
  LargeFile finest;
  bool isFirst = true;
  for (const Json::Value& dataset : attributes["multiscales"][0]["datasets"])
  {
    try
    {
      LargeFile level =
        OpenDataset(folder, attributes, dataset, volume, isFirst ? nullptr : &finest);
      if (isFirst)
      {
        finest = std::move(level);
      }
      else
      {
        finest.Coarser.push_back(std::move(level));
      }
    }
    catch (const std::runtime_error&)
    {
      if (isFirst)
      {
        throw;
      }
      break; // ignore coarser levels after one that can't be read
    }
    isFirst = false;
  }
  if (isFirst)
  {
    throw std::runtime_error("it has no level. Check the datasets of its multiscales.");
  }
  return finest;
}

/**
 * Returns the folder of the only image in a collection that bioformats2raw wrote, with the folders
 * 0, 1, and so on. Throws unless there is exactly one image.
 */
std::string FindOnlyImage(const std::string& folder)
{
  const auto isThere = [&](int number)
  { return vtksys::SystemTools::FileIsDirectory(folder + "/" + std::to_string(number)); };
  int count = 0;
  while (isThere(count))
  {
    ++count;
  }
  if (count != 1)
  {
    throw std::runtime_error("it is a collection of " + std::to_string(count) +
      " images, in the folders 0, 1 and so on." +
      (count > 1 ? " Name one of them, such as " + Printable(folder) + "/0."
                 : " Check that its copy is complete."));
  }
  return folder + "/0";
}

/** Opens an array, an image, or, if mayBeCollection, a collection with a single image. */
LargeFile OpenFolder(const std::string& folder, int volume, bool mayBeCollection)
{
  if (IsZarrArray(folder))
  {
    const ZarrArray array = OpenZarrArray(folder);
    LargeFile file;
    file.Notes.emplace_back("an array of Zarr has no size of voxels: cubes of 1 mm are assumed");
    AddZarrLevel(array, ChooseInArray(array, Json::Value::nullSingleton(), {}, volume, file), file);
    return file;
  }
  Json::Value head;
  const bool isNew = !ReadZarrHead(folder + "/.zattrs", head);
  if (isNew && !ReadZarrHead(folder + "/zarr.json", head))
  {
    throw std::runtime_error("it is no folder of Zarr: it has neither .zarray, .zattrs nor "
                             "zarr.json. Check its name.");
  }
  try
  {
    const Json::Value& attributes = isNew ? head["attributes"]["ome"] : head;
    if (mayBeCollection && attributes["bioformats2raw.layout"].isInt())
    {
      return OpenFolder(FindOnlyImage(folder), volume, false);
    }
    const Json::Value& scales = attributes["multiscales"];
    if (!scales.isArray() || scales.empty())
    {
      throw std::runtime_error(attributes["plate"].isObject()
          ? "it is a plate of wells. Name an image in it, such as A/1/0."
          : "it is a group of Zarr without OME-Zarr's multiscales. Name one of its arrays.");
    }
    return OpenMultiscales(folder, attributes, volume);
  }
  catch (const Json::Exception&)
  {
    throw std::runtime_error(
      "its attributes are not as OME-Zarr wants them. Name one of its arrays.");
  }
}

} // namespace

LargeFile OpenZarr(const std::string& name, bool, int volume)
{
  return OpenFolder(MakeAbsolute(name), volume, true);
}

} // namespace VolumeHaptics
