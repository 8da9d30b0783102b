// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Regions/Formats/VtkHdfFile.h"

#include "VTK/Base/ByteOrder.h"
#include "VTK/Base/HapticFiles.h"
#include "VTK/Regions/Formats/ChunkCodecs.h"
#include "VTK/Regions/Formats/ChunkedVolume.h"
#include "VTK/Regions/Formats/Hdf5File.h"
#include "VTK/Regions/Formats/RawVolumeFile.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>
#include <type_traits>

namespace VolumeHaptics
{
namespace
{

template <std::size_t N, typename T>
bool TakeNumbers(const Hdf5Object& object, const std::string& name, std::array<T, N>& numbers)
{
  const auto found = object.Attributes.find(name);
  const std::vector<double> values =
    found == object.Attributes.end() ? std::vector<double>() : found->second.GetNumbers();
  const auto isUsable = [](double value)
  {
    return std::isfinite(value) &&
      (std::is_floating_point<T>::value || std::abs(value) <= std::numeric_limits<int>::max());
  };
  if (values.size() != N || !std::all_of(values.begin(), values.end(), isUsable))
  {
    return false;
  }
  std::transform(values.begin(), values.end(), numbers.begin(),
    [](double value) { return static_cast<T>(value); });
  return true;
}

std::string TextOf(const Hdf5Object& object, const std::string& name)
{
  const auto found = object.Attributes.find(name);
  return found == object.Attributes.end() ? std::string() : found->second.GetText();
}

Hdf5Object ReadMember(Hdf5File& file, const Hdf5Object& group, const std::string& name)
{
  const auto link = group.Links.find(name);
  if (link == group.Links.end())
  {
    throw std::runtime_error("it has no " + name +
      (group.HasOtherLinks
          ? ", or stores it in a way that is not read here. Convert it with h5repack IN OUT."
          : ". Give a VTKHDF file of an image with point data."));
  }
  return file.ReadObject(link->second);
}

/** Reads the active array, or the first one. */
Hdf5Object ReadArray(Hdf5File& file, const Hdf5Object& group)
{
  const std::string active = TextOf(group, "Scalars");
  if (!active.empty())
  {
    return ReadMember(file, group, active);
  }
  for (const auto& link : group.Links)
  {
    Hdf5Object array = file.ReadObject(link.second);
    if (array.Layout != Hdf5Object::NoData)
    {
      return array;
    }
  }
  throw std::runtime_error("its PointData has no array. Give a VTKHDF file of an image with point "
                           "data.");
}

std::string ShapeText(const std::vector<std::uint64_t>& shape)
{
  std::string text;
  for (const std::uint64_t count : shape)
  {
    text += (text.empty() ? "" : " x ") + std::to_string(count);
  }
  return text;
}

/**
 * Checks that an array has one component, and z as its slowest axis; if there are several time
 * steps, the first one is read.
 */
void CheckShape(const Hdf5Object& array, const BoxExtent& extent, bool hasSteps)
{
  std::vector<std::uint64_t> shape = array.Shape;
  if (hasSteps && shape.size() == 4)
  {
    shape.erase(shape.begin());
  }
  std::vector<std::uint64_t> wanted;
  for (int a = 4; a >= 0; a -= 2)
  {
    wanted.push_back(static_cast<std::uint64_t>(std::int64_t{ extent[a + 1] } - extent[a] + 1));
  }
  if (shape.size() == 4)
  {
    throw std::runtime_error("its array has components, and a hand feels one. Write that as an "
                             "array of three dimensions.");
  }
  if (shape != wanted)
  {
    throw std::runtime_error("its array is of " + ShapeText(array.Shape) +
      " samples, and its WholeExtent of " + ShapeText(wanted) + " (z, y, x). Write it again.");
  }
}

/** Data that all threads that read chunks share. */
struct StoredChunks
{
  std::string Name;
  Hdf5Object Array;
  std::array<std::uint64_t, 3> Counts{}; ///< number of chunks along x, y and z

  bool Load(const ChunkPlace& place, std::vector<char>& bytes) const
  {
    const auto number = static_cast<std::uint64_t>(place[0]) +
      this->Counts[0] *
        (static_cast<std::uint64_t>(place[1]) +
          this->Counts[1] * static_cast<std::uint64_t>(place[2]));
    const auto found = this->Array.Chunks.find(number);
    if (found == this->Array.Chunks.end())
    {
      return false;
    }
    const OpenedFile file(this->Name);
    const Hdf5Chunk& chunk = found->second;
    if (chunk.Size > static_cast<std::uint64_t>(file.GetSize()))
    {
      Hdf5Block::ThrowDamaged();
    }
    bytes.resize(static_cast<std::size_t>(chunk.Size));
    file.Read(bytes.data(), bytes.size(), static_cast<std::int64_t>(chunk.Address));
    const std::vector<Hdf5Filter>& filters = this->Array.Filters;
    for (std::size_t f = filters.size(); f-- > 0;)
    {
      if (f < 64 && (chunk.Skipped >> f & 1) != 0)
      {
        continue;
      }
      switch (filters[f].Id)
      {
        case Hdf5Filter::Deflate:
          InflateChunk(bytes);
          break;
        case Hdf5Filter::Shuffle:
          UnshuffleChunk(bytes, filters[f].SampleSize);
          break;
        default: // a checksum follows the samples
          bytes.resize(bytes.size() - std::min<std::size_t>(bytes.size(), 4));
          break;
      }
    }
    return true;
  }
};

BoxReader MakeChunkReader(const std::string& name, Hdf5Object&& array, LargeFile& file)
{
  for (const Hdf5Filter& filter : array.Filters)
  {
    if (filter.Id != Hdf5Filter::Deflate && filter.Id != Hdf5Filter::Shuffle &&
      filter.Id != Hdf5Filter::Checksum)
    {
      throw std::runtime_error("its array is compressed by the HDF5 filter " +
        std::to_string(filter.Id) +
        ", and only gzip, shuffle and fletcher32 are read here. Convert it with h5repack -f GZIP=1 "
        "IN OUT, or open it with h5py and volumehaptics.open_large() in Python.");
    }
  }
  ChunkedVolume volume;
  volume.Extent = file.Extent;
  volume.SampleSize = array.Type.Size;
  volume.IsSwapped = IsOtherByteOrder(array.Type.IsBig);
  volume.FillValue = array.FillValue;
  volume.FillValue.resize(volume.SampleSize, 0);
  auto chunks = std::make_shared<StoredChunks>();
  const std::size_t x = array.Shape.size() - 1;
  auto chunkBytes = static_cast<double>(volume.SampleSize);
  for (std::size_t a = 0; a < 3; ++a)
  {
    const std::uint64_t size = array.ChunkShape[x - a];
    volume.ChunkSize[a] = static_cast<std::int64_t>(size);
    chunks->Counts[a] = (array.Shape[x - a] + size - 1) / size;
    chunkBytes *= static_cast<double>(size);
  }
  if (chunkBytes > static_cast<double>(MostChunkBytes))
  {
    throw std::runtime_error("its chunks are larger than 1 GiB. Convert it with h5repack -l "
                             "CHUNK=64x64x64 IN OUT.");
  }
  file.ChunkSize = volume.ChunkSize;
  chunks->Name = name;
  chunks->Array = std::move(array);
  volume.Load = [chunks](const ChunkPlace& place, std::vector<char>& bytes)
  { return chunks->Load(place, bytes); };
  return [volume](const int box[6], void* samples)
  {
    volume.Read(box, samples);
    return true;
  };
}

BoxReader MakeReader(const std::string& name, Hdf5Object&& array, LargeFile& file)
{
  if (array.Layout == Hdf5Object::Chunked)
  {
    return MakeChunkReader(name, std::move(array), file);
  }
  if (array.Layout != Hdf5Object::Contiguous || !array.IsAllocated)
  {
    throw std::runtime_error("its array has no samples, or in a place that is not read here. "
                             "Convert it with h5repack -l CONTI IN OUT.");
  }
  const RawVolumeFile raw{ name, file.Extent, array.Type.Size,
    static_cast<vtkTypeInt64>(array.Address), IsOtherByteOrder(array.Type.IsBig) };
  return [raw](const int box[6], void* samples)
  {
    raw.Read(box, samples);
    return true;
  };
}

} // namespace

LargeFile OpenVtkHdf(const std::string& name)
{
  Hdf5File file(name);
  const Hdf5Object root = file.ReadRoot();
  const Hdf5Object group = ReadMember(file, root, "VTKHDF");
  const std::string type = TextOf(group, "Type");
  if (type != "ImageData")
  {
    throw std::runtime_error("it holds " + (type.empty() ? "something" : Printable(type)) +
      ", not an image (Type ImageData). Give a VTKHDF file of an image.");
  }
  LargeFile large;
  if (!TakeNumbers(group, "WholeExtent", large.Extent) ||
    !TakeNumbers(group, "Origin", large.Origin) || !TakeNumbers(group, "Spacing", large.Spacing))
  {
    throw std::runtime_error("its WholeExtent, Origin or Spacing is missing, or has other numbers "
                             "than an image needs. Write it again.");
  }
  TakeNumbers(group, "Direction", large.Direction);
  Hdf5Object array = ReadArray(file, ReadMember(file, group, "PointData"));
  CheckShape(array, large.Extent, group.Links.count("Steps") > 0);
  large.ScalarType =
    FindScalarType(array.Type.Kind == Hdf5Type::Integer, array.Type.IsSigned, array.Type.Size);
  const bool isNumber = array.Type.Kind == Hdf5Type::Integer || array.Type.Kind == Hdf5Type::Float;
  if (!isNumber || large.ScalarType == 0)
  {
    throw std::runtime_error("its array is of a type that no volume here has. Write it as integers "
                             "or floating-point numbers of 1 to 8 bytes.");
  }
  large.Read = MakeReader(MakeAbsolute(name), std::move(array), large);
  return large;
}

} // namespace VolumeHaptics
