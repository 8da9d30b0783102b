// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Regions/Formats/LargeFile.h"

#include "Core/Platform/HapticFiles.h"
#include "Core/Platform/PackedBytes.h"
#include "Core/Platform/ReaderProcess.h"
#include "VTK/Base/ByteOrder.h"
#include "VTK/Regions/Formats/ChunkCodecs.h"
#include "VTK/Regions/Formats/ChunkedVolume.h"
#include "VTK/Regions/Formats/FurtherAxes.h"
#include "VTK/Regions/Formats/Hdf5File.h"
#include "VTK/Regions/Formats/OpenedFile.h"
#include "VTK/Regions/Formats/RawVolumeFile.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>
#include <type_traits>
#include <unordered_map>
#include <utility>

namespace VolumeHaptics
{
namespace
{

constexpr const char* const RootGroup = "VTKHDF";

template <std::size_t N, typename T>
bool ReadNumbers(const Hdf5File& file, const std::string& name, std::array<T, N>& numbers)
{
  const std::vector<double> values = file.ReadNumbers(RootGroup, name);
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

/** Throws if nothing exists at a path in the file. */
void CheckMember(const Hdf5File& file, const std::string& path)
{
  if (!file.Has(path))
  {
    throw std::runtime_error("it has no " + Printable(path.substr(path.rfind('/') + 1)) +
      ". Give a VTKHDF file of an image with point data.");
  }
}

/** Returns the path of the active point array, or of the first one if none is active. */
std::string FindArray(const Hdf5File& file)
{
  const std::string group = std::string(RootGroup) + "/PointData";
  CheckMember(file, group);
  const std::string active = file.ReadText(group, "Scalars");
  if (!active.empty())
  {
    CheckMember(file, group + "/" + active);
    return group + "/" + active;
  }
  for (const std::string& member : file.ListMembers(group))
  {
    if (file.HasArray(group + "/" + member))
    {
      return group + "/" + member;
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
 * Throws unless an array has one component and z as its slowest axis. Of several time steps, the
 * first one is read.
 */
void CheckShape(const Hdf5Array& array, const BoxExtent& extent, bool hasSteps)
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

/** Data shared by all threads that read chunks. */
struct StoredChunks
{
  std::string Name;
  Hdf5Array Array;
  std::unordered_map<std::uint64_t, Hdf5Chunk> Chunks;
  std::array<std::uint64_t, 3> Counts{}; ///< number of chunks along x, y and z
  std::size_t Most = 0;                  ///< largest size (bytes) of a chunk, compressed or not

  bool Load(const ChunkPlace& place, std::vector<char>& bytes) const
  {
    const auto number = static_cast<std::uint64_t>(place[0]) +
      this->Counts[0] *
        (static_cast<std::uint64_t>(place[1]) +
          this->Counts[1] * static_cast<std::uint64_t>(place[2]));
    const auto found = this->Chunks.find(number);
    if (found == this->Chunks.end())
    {
      return false;
    }
    const OpenedFile file(this->Name);
    const Hdf5Chunk& chunk = found->second;
    if (chunk.Size > static_cast<std::uint64_t>(file.GetSize()) || chunk.Size > this->Most)
    {
      Hdf5File::ThrowDamaged();
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
          InflateChunk(bytes, this->Most);
          break;
        case Hdf5Filter::Shuffle:
          UnshuffleChunk(bytes, filters[f].SampleSize);
          break;
        default: // Fletcher's checksum, which follows the samples
          CheckFletcher(bytes);
          break;
      }
    }
    return true;
  }
};

/** The geometry, array and chunks of a VTKHDF file, read with the HDF5 library. */
struct VtkHdfFacts
{
  BoxExtent Extent{};
  std::array<double, 3> Origin{};
  std::array<double, 3> Spacing{};
  std::array<double, 9> Direction = LargeFile().Direction;
  bool HasSteps = false;
  Hdf5Array Array;
  std::unordered_map<std::uint64_t, Hdf5Chunk> Chunks;
};

/** Throws unless an array's samples can be read here. */
void CheckSamples(const VtkHdfFacts& facts)
{
  const Hdf5Array& array = facts.Array;
  CheckShape(array, facts.Extent, facts.HasSteps);
  if (array.ScalarType == 0)
  {
    throw std::runtime_error("the type of its array is not supported. Write it as integers or "
                             "floating-point numbers of 1 to 8 bytes.");
  }
  if (array.ChunkShape.empty() && !array.IsContiguous)
  {
    throw std::runtime_error("its array has no samples, or its storage layout is not supported. "
                             "Convert it with h5repack -l CONTI IN OUT.");
  }
  for (const Hdf5Filter& filter : array.Filters)
  {
    if (!array.ChunkShape.empty() && filter.Id != Hdf5Filter::Deflate &&
      filter.Id != Hdf5Filter::Shuffle && filter.Id != Hdf5Filter::Checksum)
    {
      throw std::runtime_error("its array is compressed by the HDF5 filter " +
        std::to_string(filter.Id) +
        ", and only gzip, shuffle and fletcher32 are read here. Convert it with h5repack -f GZIP=1 "
        "IN OUT, or open it with h5py and volumehaptics.open_large() in Python.");
    }
  }
}

/** Returns the number of chunks along x, y and z. Throws if a chunk is too large. */
std::array<std::uint64_t, 3> CountChunks(const Hdf5Array& array)
{
  std::array<std::uint64_t, 3> counts{};
  const std::size_t x = array.Shape.size() - 1;
  auto chunkBytes = static_cast<double>(array.SampleSize);
  for (std::size_t a = 0; a < 3; ++a)
  {
    const std::uint64_t size = array.ChunkShape[x - a];
    counts[a] = (array.Shape[x - a] + size - 1) / size;
    chunkBytes *= static_cast<double>(size);
  }
  if (chunkBytes > static_cast<double>(MostChunkBytes))
  {
    throw std::runtime_error("its chunks are larger than 1 GiB. Convert it with h5repack -l "
                             "CHUNK=64x64x64 IN OUT.");
  }
  return counts;
}

VtkHdfFacts ReadFacts(const std::string& name)
{
  const Hdf5File file(name);
  CheckMember(file, RootGroup);
  const std::string type = file.ReadText(RootGroup, "Type");
  if (type != "ImageData")
  {
    throw std::runtime_error("it holds " + (type.empty() ? "something" : Printable(type)) +
      ", not an image (Type ImageData). Give a VTKHDF file of an image.");
  }
  VtkHdfFacts facts;
  if (!ReadNumbers(file, "WholeExtent", facts.Extent) ||
    !ReadNumbers(file, "Origin", facts.Origin) || !ReadNumbers(file, "Spacing", facts.Spacing))
  {
    throw std::runtime_error("its WholeExtent, Origin or Spacing is missing, or has other numbers "
                             "than an image needs. Write it again.");
  }
  ReadNumbers(file, "Direction", facts.Direction);
  const std::string path = FindArray(file);
  facts.Array = file.ReadArray(path);
  facts.HasSteps = file.Has(std::string(RootGroup) + "/Steps");
  CheckSamples(facts);
  if (!facts.Array.ChunkShape.empty())
  {
    facts.Chunks = file.LocateChunks(path, facts.Array, CountChunks(facts.Array));
  }
  return facts;
}

void PackFacts(const VtkHdfFacts& facts, BytePacker& packer)
{
  packer.Put(facts.Extent);
  packer.Put(facts.Origin);
  packer.Put(facts.Spacing);
  packer.Put(facts.Direction);
  packer.Put(facts.HasSteps);
  packer.Put(facts.Array.ScalarType);
  packer.Put(facts.Array.SampleSize);
  packer.Put(facts.Array.IsBig);
  packer.PutList(facts.Array.Shape);
  packer.PutList(facts.Array.FillValue);
  packer.Put(facts.Array.IsContiguous);
  packer.Put(facts.Array.Address);
  packer.PutList(facts.Array.Filters);
  packer.PutList(facts.Array.ChunkShape);
  packer.Put<std::uint64_t>(facts.Chunks.size());
  for (const auto& [number, chunk] : facts.Chunks)
  {
    packer.Put(number);
    packer.Put(chunk);
  }
}

/**
 * Unpacks the facts and checks them, because a damaged file may have corrupted the process that
 * sent them.
 */
VtkHdfFacts UnpackFacts(ByteUnpacker& unpacker)
{
  VtkHdfFacts facts;
  facts.Extent = unpacker.Get<BoxExtent>();
  facts.Origin = unpacker.Get<std::array<double, 3>>();
  facts.Spacing = unpacker.Get<std::array<double, 3>>();
  facts.Direction = unpacker.Get<std::array<double, 9>>();
  facts.HasSteps = unpacker.Get<bool>();
  Hdf5Array& array = facts.Array;
  array.ScalarType = unpacker.Get<int>();
  array.SampleSize = unpacker.Get<std::size_t>();
  array.IsBig = unpacker.Get<bool>();
  array.Shape = unpacker.GetList<std::uint64_t>();
  array.FillValue = unpacker.GetList<char>();
  array.IsContiguous = unpacker.Get<bool>();
  array.Address = unpacker.Get<std::uint64_t>();
  array.Filters = unpacker.GetList<Hdf5Filter>();
  array.ChunkShape = unpacker.GetList<std::uint64_t>();
  for (auto left = unpacker.Get<std::uint64_t>(); left > 0; --left)
  {
    const auto number = unpacker.Get<std::uint64_t>();
    facts.Chunks[number] = unpacker.Get<Hdf5Chunk>();
  }
  const bool isInteger = array.ScalarType != VTK_FLOAT && array.ScalarType != VTK_DOUBLE;
  const bool isKnown = array.ScalarType == ChooseScalarType(isInteger, true, array.SampleSize) ||
    array.ScalarType == ChooseScalarType(isInteger, false, array.SampleSize);
  const bool areChunks = array.ChunkShape.empty() ||
    (array.ChunkShape.size() == array.Shape.size() &&
      std::count(array.ChunkShape.begin(), array.ChunkShape.end(), std::uint64_t{ 0 }) == 0);
  if (!isKnown || !areChunks || array.FillValue.size() != array.SampleSize)
  {
    Hdf5File::ThrowDamaged();
  }
  CheckSamples(facts);
  return facts;
}

VtkHdfFacts AskForFacts(const std::string& name, std::vector<std::string>& notes)
{
  std::string answer;
  switch (AskReader(ReadTask::VtkHdf, name, answer))
  {
    case ReadResult::NoProcess:
      notes.insert(notes.end(), answer.empty() ? 0 : 1, answer);
      return ReadFacts(name);
    case ReadResult::Ended:
      throw std::runtime_error(answer + ". Copy or write it again.");
    case ReadResult::Answered:
      break;
  }
  ByteUnpacker unpacker(answer);
  const std::string fault = unpacker.GetText();
  if (!fault.empty())
  {
    throw std::runtime_error(fault);
  }
  return UnpackFacts(unpacker);
}

BoxReader MakeChunkReader(const std::string& name, VtkHdfFacts&& facts, LargeFile& file)
{
  Hdf5Array& array = facts.Array;
  ChunkedVolume volume;
  volume.Extent = file.Extent;
  volume.SampleSize = array.SampleSize;
  volume.IsSwapped = IsOtherByteOrder(array.IsBig);
  volume.FillValue = array.FillValue;
  auto chunks = std::make_shared<StoredChunks>();
  chunks->Counts = CountChunks(array);
  std::size_t chunkBytes = array.SampleSize;
  for (std::size_t a = 0; a < 3; ++a)
  {
    const std::uint64_t size = array.ChunkShape[array.ChunkShape.size() - 1 - a];
    volume.ChunkSize[a] = static_cast<std::int64_t>(size);
    chunkBytes *= static_cast<std::size_t>(size);
  }
  file.ChunkSize = volume.ChunkSize;
  chunks->Name = name;
  chunks->Most = GetMostPackedBytes(chunkBytes);
  chunks->Chunks = std::move(facts.Chunks);
  chunks->Array = std::move(array);
  volume.Load = [chunks](const ChunkPlace& place, std::vector<char>& bytes)
  { return chunks->Load(place, bytes); };
  return [volume](const int box[6], void* samples)
  {
    volume.Read(box, samples);
    return true;
  };
}

BoxReader MakeReader(const std::string& name, VtkHdfFacts&& facts, LargeFile& file)
{
  const Hdf5Array& array = facts.Array;
  if (!array.ChunkShape.empty())
  {
    return MakeChunkReader(name, std::move(facts), file);
  }
  const RawVolumeFile raw{ name, file.Extent, array.SampleSize,
    static_cast<vtkTypeInt64>(array.Address), IsOtherByteOrder(array.IsBig) };
  return [raw](const int box[6], void* samples)
  {
    raw.Read(box, samples);
    return true;
  };
}

} // namespace

std::string PackVtkHdf(const std::string& name)
{
  BytePacker packer;
  try
  {
    const VtkHdfFacts facts = ReadFacts(name);
    packer.PutText({});
    PackFacts(facts, packer);
  }
  catch (const std::runtime_error& fault)
  {
    packer.Bytes.clear();
    packer.PutText(fault.what());
  }
  return std::move(packer.Bytes);
}

LargeFile OpenVtkHdf(const std::string& name, bool, int volume)
{
  LargeFile large;
  VtkHdfFacts facts = AskForFacts(name, large.Notes);
  ChooseVolume({}, volume, large);
  large.Extent = facts.Extent;
  large.Origin = facts.Origin;
  large.Spacing = facts.Spacing;
  large.Direction = facts.Direction;
  large.ScalarType = facts.Array.ScalarType;
  large.Read = MakeReader(MakeAbsolute(name), std::move(facts), large);
  return large;
}

} // namespace VolumeHaptics
