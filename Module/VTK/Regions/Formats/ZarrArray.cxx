// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Regions/Formats/ZarrArray.h"

#include "Core/Platform/Files.h"
#include "Core/Platform/HapticFiles.h"
#include "VTK/Base/ByteOrder.h"
#include "VTK/Base/JsonText.h"
#include "VTK/Regions/Formats/ChunkCodecs.h"
#include "VTK/Regions/Formats/LargeFile.h"
#include "VTK/Regions/Formats/OpenedFile.h"

#include "vtkSetGet.h"
#include "vtk_jsoncpp.h"
#include "vtksys/SystemTools.hxx"

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <stdexcept>

namespace VolumeHaptics
{

bool ReadZarrHead(const std::string& file, Json::Value& head)
{
  constexpr std::size_t most = std::size_t{ 1 } << 24;
  std::string text;
  std::string error;
  if (!vtksys::SystemTools::FileExists(file))
  {
    return false;
  }
  if (!ReadSmallFile(file, most, text, error))
  {
    throw std::runtime_error("its head " + Printable(file) + " " + error + ". Write it again.");
  }
  if (!ParseJson(text, head, error) || !head.isObject())
  {
    throw std::runtime_error("its head " + Printable(file) + " can't be read: " +
      (error.empty() ? "it is no object of JSON." : Printable(error)) + " Write it again.");
  }
  return true;
}

namespace
{

const char* const UsePython =
  " Open it with volumehaptics.open_large() in Python, which uses zarr, or convert it.";

[[noreturn]] void Refuse(const std::string& folder, const std::string& what)
{
  throw std::runtime_error("the Zarr array " + Printable(folder) + " " + what);
}

std::vector<std::uint64_t> ReadShape(const Json::Value& list, const std::string& folder)
{
  std::vector<std::uint64_t> shape;
  for (const Json::Value& count : list)
  {
    if (!count.isUInt64() || count.asUInt64() == 0 ||
      count.asUInt64() > std::numeric_limits<std::uint32_t>::max())
    {
      Refuse(folder, "has a size that no volume has. Check its head.");
    }
    shape.push_back(count.asUInt64());
  }
  return shape;
}

struct NumberType
{
  char Kind = 0; ///< type: i (signed integer), u (unsigned integer) or f (float)
  std::size_t Size = 0;
};

/** Parses a number type, such as "<i2" in version 2, or "int16" in version 3. */
NumberType ReadType(const std::string& name, bool& isBig)
{
  if (name.size() == 3 && std::strchr("<>|", name[0]))
  {
    isBig = name[0] == '>';
    return { name[1], static_cast<std::size_t>(name[2] - '0') };
  }
  const std::size_t digits = name.find_first_of("0123456789");
  const std::string word = name.substr(0, digits);
  const char kind = word == "int" ? 'i' : word == "uint" ? 'u' : word == "float" ? 'f' : 0;
  const int bits = digits == std::string::npos ? 0 : std::atoi(name.c_str() + digits);
  return { kind, static_cast<std::size_t>(bits / 8) };
}

/**
 * Parses a number given as bits, such as "0x7fc00000": version 3 writes unusual NaNs like this.
 * Returns false for anything else.
 */
template <typename T>
bool ReadBits(const std::string& word, T& number)
{
  const std::size_t digits = 2 * sizeof(T);
  if (word.size() != digits + 2 || word.find("0x") != 0 ||
    word.find_first_not_of("0123456789abcdefABCDEF", 2) != std::string::npos)
  {
    return false;
  }
  const unsigned long long bits = std::strtoull(word.c_str() + 2, nullptr, 16);
  if constexpr (sizeof(T) == sizeof(std::uint32_t))
  {
    const auto half = static_cast<std::uint32_t>(bits);
    std::memcpy(&number, &half, sizeof(T));
  }
  else if constexpr (sizeof(T) == sizeof(bits))
  {
    std::memcpy(&number, &bits, sizeof(T));
  }
  return sizeof(T) == sizeof(std::uint32_t) || sizeof(T) == sizeof(bits);
}

/** Stores a fill value. Returns false if it is not a number of the type. */
template <typename T>
bool PutFill(const Json::Value& value, bool isSwapped, std::vector<char>& bytes)
{
  T number{};
  const std::string word = value.isString() ? value.asString() : std::string();
  if (std::is_floating_point<T>::value && !word.empty())
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    number = static_cast<T>(word == "NaN" ? std::numeric_limits<double>::quiet_NaN()
        : word == "Infinity"              ? infinity
                                          : -infinity);
    const bool isWord = word == "NaN" || word == "Infinity" || word == "-Infinity";
    if (!isWord && !ReadBits(word, number))
    {
      return false;
    }
  }
  else if (std::is_floating_point<T>::value && value.isNumeric())
  {
    number = static_cast<T>(value.asDouble());
  }
  else if (value.isInt64())
  {
    number = static_cast<T>(value.asInt64());
  }
  else if (value.isUInt64())
  {
    number = static_cast<T>(value.asUInt64());
  }
  bytes.resize(sizeof(T));
  std::memcpy(bytes.data(), &number, sizeof(T));
  if (isSwapped)
  {
    std::reverse(bytes.begin(), bytes.end());
  }
  return true;
}

void SetType(const std::string& name, const Json::Value& fill, ZarrArray& array)
{
  const NumberType type = ReadType(name, array.IsBig);
  const bool isKnown = type.Kind == 'i' || type.Kind == 'u' || type.Kind == 'f';
  array.ScalarType = isKnown ? ChooseScalarType(type.Kind != 'f', type.Kind == 'i', type.Size) : 0;
  array.SampleSize = type.Size;
  bool isFill = true;
  switch (array.ScalarType)
  {
    vtkTemplateMacro(
      isFill = PutFill<VTK_TT>(fill, IsOtherByteOrder(array.IsBig), array.FillValue));
    default:
      Refuse(array.Folder,
        "is of type " + Printable(name) +
          ", which no volume has. Write it as integers or floating-point numbers.");
  }
  if (!isFill)
  {
    Refuse(array.Folder,
      "has the fill value '" + Printable(fill.asString()) +
        "', which is no number. Write it again.");
  }
}

void AddCodec(const std::string& name, ZarrArray& array)
{
  if (name == "zlib" || name == "gzip")
  {
    array.Codecs.push_back(ZarrArray::Zlib);
  }
  else if (name == "lz4")
  {
    array.Codecs.push_back(ZarrArray::Lz4);
  }
  else if (name == "blosc")
  {
    array.Codecs.push_back(ZarrArray::Blosc);
  }
  else if (name == "zstd")
  {
    array.Codecs.push_back(ZarrArray::Zstd);
  }
  else if (name == "crc32c")
  {
    array.Codecs.push_back(ZarrArray::Sum);
  }
  else
  {
    Refuse(array.Folder,
      "is stored with " + Printable(name) +
        ", and only zlib, gzip, lz4, zstd, blosc and crc32c are read here." + UsePython);
  }
}

/** Parses the metadata of version 2, .zarray. */
void ReadOldHead(const Json::Value& head, ZarrArray& array)
{
  array.Shape = ReadShape(head["shape"], array.Folder);
  array.ChunkShape = ReadShape(head["chunks"], array.Folder);
  const Json::Value& type = head["dtype"];
  SetType(type.isString() ? type.asString() : "structures", head["fill_value"], array);
  const Json::Value& separator = head["dimension_separator"];
  array.Separator = separator.isString() && separator.asString() == "/" ? '/' : '.';
  if (head["order"].isString() && head["order"].asString() == "F")
  {
    Refuse(array.Folder, std::string("has its first axis fastest (order F).") + UsePython);
  }
  if (head["filters"].isArray() && !head["filters"].empty())
  {
    Refuse(array.Folder, std::string("has filters.") + UsePython);
  }
  if (head["compressor"].isObject())
  {
    AddCodec(head["compressor"]["id"].asString(), array);
  }
}

/** Parses the codecs of version 3, which are in the order of encoding. */
void ReadCodecs(const Json::Value& codecs, ZarrArray& array)
{
  for (const Json::Value& codec : codecs)
  {
    const std::string name = codec["name"].asString();
    if (name == "bytes")
    {
      array.IsBig = codec["configuration"]["endian"].asString() == "big";
      continue;
    }
    AddCodec(name, array);
  }
  std::reverse(array.Codecs.begin(), array.Codecs.end());
}

/** Parses the codec of shards: files that contain several chunks and an index. */
void ReadShards(const Json::Value& configuration, ZarrArray& array)
{
  array.ShardShape = array.ChunkShape;
  array.ChunkShape = ReadShape(configuration["chunk_shape"], array.Folder);
  bool isEven = array.ChunkShape.size() == array.ShardShape.size();
  for (std::size_t d = 0; isEven && d < array.ShardShape.size(); ++d)
  {
    isEven = array.ShardShape[d] % array.ChunkShape[d] == 0;
    array.ShardShape[d] /= array.ChunkShape[d];
  }
  if (!isEven)
  {
    Refuse(array.Folder, "has shards that are no whole number of chunks. Write it again.");
  }
  array.IsIndexFirst = configuration["index_location"].asString() == "start";
  for (const Json::Value& codec : configuration["index_codecs"])
  {
    const std::string name = codec["name"].asString();
    const bool isLittle = codec["configuration"]["endian"].asString() != "big";
    array.IndexTail = name == "crc32c" ? sizeof(std::uint32_t) : array.IndexTail;
    if (name != "crc32c" && (name != "bytes" || !isLittle))
    {
      Refuse(array.Folder,
        "has an index of shards that is stored with " + Printable(name) +
          ", and only plain ones are read here." + UsePython);
    }
  }
  ReadCodecs(configuration["codecs"], array);
}

/** Parses the metadata of version 3, zarr.json. */
void ReadNewHead(const Json::Value& head, ZarrArray& array)
{
  array.Shape = ReadShape(head["shape"], array.Folder);
  array.ChunkShape = ReadShape(head["chunk_grid"]["configuration"]["chunk_shape"], array.Folder);
  const Json::Value& keys = head["chunk_key_encoding"];
  const bool isOld = keys["name"].asString() == "v2";
  const Json::Value& separator = keys["configuration"]["separator"];
  array.Separator = separator.isString() && !separator.asString().empty() ? separator.asString()[0]
    : isOld                                                               ? '.'
                                                                          : '/';
  array.Prefix = isOld ? std::string() : std::string("c") + array.Separator;
  const Json::Value& codecs = head["codecs"];
  if (codecs.size() == 1 && codecs[0]["name"].asString() == "sharding_indexed")
  {
    ReadShards(codecs[0]["configuration"], array);
  }
  else
  {
    ReadCodecs(codecs, array);
  }
  const Json::Value& type = head["data_type"];
  SetType(type.isString() ? type.asString() : "structures", head["fill_value"], array);
}

} // namespace

std::uint64_t ZarrArray::GetChunkNumber(const ChunkPlace& place, std::size_t dimension) const
{
  const std::size_t rank = this->Shape.size();
  return dimension + 3 >= rank        ? static_cast<std::uint64_t>(place[rank - 1 - dimension])
    : dimension < this->Before.size() ? this->Before[dimension] / this->ChunkShape[dimension]
                                      : 0;
}

std::string ZarrArray::GetChunkFile(const ChunkPlace& place) const
{
  std::string name = this->Folder + "/" + this->Prefix;
  const std::size_t rank = this->Shape.size();
  for (std::size_t d = 0; d < rank; ++d)
  {
    name += d == 0 ? std::string() : std::string(1, this->Separator);
    const std::uint64_t shard = this->ShardShape.empty() ? 1 : this->ShardShape[d];
    name += std::to_string(this->GetChunkNumber(place, d) / shard);
  }
  return name;
}

bool ZarrArray::LocateInShard(const std::string& name, const OpenedFile& file,
  const ChunkPlace& place, std::uint64_t range[2]) const
{
  // Each chunk has two little-endian 64-bit numbers in the index: offset and size.
  constexpr std::uint64_t entry = 2 * sizeof(std::uint64_t);
  constexpr std::uint64_t none = std::numeric_limits<std::uint64_t>::max();
  const std::size_t rank = this->ShardShape.size();
  std::uint64_t count = 1;
  std::uint64_t number = 0;
  for (std::size_t d = 0; d < rank; ++d)
  {
    const std::uint64_t shard = this->ShardShape[d];
    count = count <= MostChunkBytes ? count * shard : count;
    number = number * shard + this->GetChunkNumber(place, d) % shard;
  }
  const auto size = static_cast<std::uint64_t>(file.GetSize());
  const std::uint64_t index = count * entry + this->IndexTail;
  if (count > MostChunkBytes || index > size)
  {
    throw std::runtime_error("a shard of it is cut off. Copy or write it again.");
  }
  const std::uint64_t begin = this->IsIndexFirst ? 0 : size - index;
  if (this->IndexTail > 0)
  {
    const std::lock_guard<std::mutex> lock(this->Checked->Access);
    if (this->Checked->Shards.count(name) == 0)
    {
      std::vector<char> whole(static_cast<std::size_t>(index));
      file.Read(whole.data(), whole.size(), static_cast<std::int64_t>(begin));
      CheckChunkSum(whole);
      this->Checked->Shards.insert(name);
    }
  }
  unsigned char bytes[entry];
  file.Read(bytes, entry, static_cast<std::int64_t>(begin + number * entry));
  for (std::size_t i = 0; i < 2; ++i)
  {
    range[i] = 0;
    for (std::size_t byte = 8; byte > 0; --byte)
    {
      range[i] = range[i] << 8 | bytes[8 * i + byte - 1];
    }
  }
  if (range[0] == none && range[1] == none)
  {
    return false;
  }
  if (range[1] > size || range[0] > size - range[1])
  {
    throw std::runtime_error(
      "a shard of it is damaged or truncated: its index names bytes that it does not have. Copy or "
      "write it again.");
  }
  return true;
}

bool ZarrArray::LoadChunk(const ChunkPlace& place, std::vector<char>& bytes) const
{
  const std::string name = this->GetChunkFile(place);
  Files::Status status;
  if (!Files::GetStatus(name, status))
  {
    if (errno == ENOENT)
    {
      return false; // a chunk that contains only the fill value is not written
    }
    throw std::runtime_error(DescribeError(errno) + " (" + name + ").");
  }
  const OpenedFile file(name);
  std::uint64_t range[2] = { 0, static_cast<std::uint64_t>(file.GetSize()) };
  if (!this->ShardShape.empty() && !this->LocateInShard(name, file, place, range))
  {
    return false;
  }
  const std::size_t most = GetMostPackedBytes(this->ChunkBytes);
  if (range[1] > most)
  {
    throw std::runtime_error("its chunk " + name + " is larger than its samples. Write it again.");
  }
  bytes.resize(static_cast<std::size_t>(range[1]));
  file.Read(bytes.data(), bytes.size(), static_cast<std::int64_t>(range[0]));
  for (const CodecType codec : this->Codecs)
  {
    switch (codec)
    {
      case Zlib:
        InflateChunk(bytes, most);
        break;
      case Lz4:
        UnpackLz4Chunk(bytes, most);
        break;
      case Blosc:
        UnpackBloscChunk(bytes, most);
        break;
      case Zstd:
        UnpackZstdChunk(bytes, most);
        break;
      case Sum:
        CheckChunkSum(bytes);
        break;
    }
  }
  // A chunk may contain several volumes, one after another.
  std::size_t first = 0;
  for (std::size_t d = 0; d < this->Shape.size(); ++d)
  {
    const bool isBefore = d < this->Before.size();
    const auto count = static_cast<std::size_t>(this->ChunkShape[d]);
    first = first * count + (isBefore ? this->Before[d] % count : 0);
  }
  first *= this->SampleSize;
  bytes.erase(
    bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(std::min(first, bytes.size())));
  return true;
}

bool IsZarrArray(const std::string& folder)
{
  Json::Value head;
  return ReadZarrHead(folder + "/.zarray", head) ||
    (ReadZarrHead(folder + "/zarr.json", head) && head["node_type"].isString() &&
      head["node_type"].asString() == "array");
}

ZarrArray OpenZarrArray(const std::string& folder)
{
  ZarrArray array;
  array.Folder = folder;
  Json::Value head;
  try
  {
    if (ReadZarrHead(folder + "/.zarray", head))
    {
      ReadOldHead(head, array);
    }
    else if (ReadZarrHead(folder + "/zarr.json", head))
    {
      ReadNewHead(head, array);
    }
    else
    {
      Refuse(folder,
        "has no head (.zarray or zarr.json): it may not have been copied. Copy it, or "
        "check the name.");
    }
  }
  catch (const Json::Exception&)
  {
    Refuse(folder, "has a head that is not as Zarr wants it. Write it again.");
  }
  if (array.Shape.size() < 3 || array.ChunkShape.size() != array.Shape.size())
  {
    Refuse(folder,
      "has " + std::to_string(array.Shape.size()) +
        " dimensions, and a volume needs z, y and x, as the last ones.");
  }
  double size = static_cast<double>(array.SampleSize);
  for (const std::uint64_t count : array.ChunkShape)
  {
    size *= static_cast<double>(count);
  }
  if (size > static_cast<double>(MostChunkBytes))
  {
    Refuse(folder, "has chunks larger than 1 GiB. Write it with chunks such as 64 x 64 x 64.");
  }
  array.ChunkBytes = static_cast<std::size_t>(size);
  return array;
}

} // namespace VolumeHaptics
