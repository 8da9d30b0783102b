// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Regions/Formats/ChunkCodecs.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <string>
#include <zlib.h>

namespace VolumeHaptics
{
namespace
{

[[noreturn]] void ThrowDamaged(const char* what)
{
  throw std::runtime_error(
    std::string("a chunk of it is damaged (") + what + "). Copy or write it again.");
}

std::uint32_t ReadWord(const unsigned char* bytes)
{
  return bytes[0] | std::uint32_t{ bytes[1] } << 8 | std::uint32_t{ bytes[2] } << 16 |
    std::uint32_t{ bytes[3] } << 24;
}

/** Ends the stream when it goes out of scope, also after an exception. */
struct Inflater
{
  Inflater()
  {
    constexpr int withAnyHeader = 15 + 32; // any window; heads of zlib or gzip
    if (inflateInit2(&this->Stream, withAnyHeader) != Z_OK)
    {
      throw std::bad_alloc();
    }
  }
  ~Inflater() { inflateEnd(&this->Stream); }
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;

  z_stream Stream{};
};

/** Unpacks a block of LZ4: sequences of plain bytes, and of copies of earlier bytes. */
class Lz4Block
{
public:
  Lz4Block(const unsigned char* from, std::size_t size, unsigned char* to, std::size_t room)
    : From(from)
    , FromEnd(from + size)
    , Begin(to)
    , To(to)
    , End(to + room)
  {
  }

  /** Fills the whole output. */
  void Unpack()
  {
    while (this->From < this->FromEnd)
    {
      const unsigned char token = *this->From++;
      const std::size_t plain = this->ReadLength(token >> 4);
      if (plain > Left(this->From, this->FromEnd) || plain > Left(this->To, this->End))
      {
        ThrowDamaged("lz4");
      }
      this->To = std::copy_n(this->From, plain, this->To);
      this->From += plain;
      if (this->From == this->FromEnd)
      {
        break; // the last sequence has only plain bytes
      }
      this->Repeat(token & 15);
    }
    if (this->To != this->End)
    {
      ThrowDamaged("lz4");
    }
  }

private:
  static std::size_t Left(const unsigned char* from, const unsigned char* end)
  {
    return static_cast<std::size_t>(end - from);
  }
  std::size_t ReadLength(std::size_t length)
  {
    unsigned char more = length == 15 ? 255 : 0;
    while (more == 255)
    {
      if (this->From == this->FromEnd)
      {
        ThrowDamaged("lz4");
      }
      more = *this->From++;
      length += more;
    }
    return length;
  }
  void Repeat(std::size_t length)
  {
    if (Left(this->From, this->FromEnd) < 2)
    {
      ThrowDamaged("lz4");
    }
    const std::size_t back = this->From[0] | std::size_t{ this->From[1] } << 8;
    this->From += 2;
    const std::size_t count = this->ReadLength(length) + 4;
    if (back == 0 || back > Left(this->Begin, this->To) || count > Left(this->To, this->End))
    {
      ThrowDamaged("lz4");
    }
    for (std::size_t i = 0; i < count; ++i, ++this->To)
    {
      *this->To = *(this->To - back); // source and target may overlap
    }
  }

  const unsigned char* From;
  const unsigned char* const FromEnd;
  unsigned char* const Begin;
  unsigned char* To;
  unsigned char* const End;
};

/** Head of a chunk of Blosc 1. */
struct BloscHead
{
  static constexpr std::size_t Size = 16;

  explicit BloscHead(const std::vector<char>& bytes)
  {
    if (bytes.size() < Size)
    {
      ThrowDamaged("blosc");
    }
    const auto* const head = reinterpret_cast<const unsigned char*>(bytes.data());
    this->Flags = head[2];
    this->SampleSize = std::max<std::size_t>(head[3], 1);
    this->Plain = ReadWord(head + 4);
    this->BlockSize = ReadWord(head + 8);
    if (head[0] != 2 || ReadWord(head + 12) > bytes.size() || this->Plain > MostChunkBytes ||
      (this->Plain > 0 && this->BlockSize == 0))
    {
      ThrowDamaged("blosc");
    }
  }
  bool HasFlag(unsigned int flag) const { return (this->Flags & flag) != 0; }
  unsigned int GetCompressor() const { return this->Flags >> 5; }

  unsigned int Flags;
  std::size_t SampleSize;
  std::size_t Plain;
  std::size_t BlockSize;
};

constexpr unsigned int ShuffledBytes = 1;
constexpr unsigned int Stored = 2;
constexpr unsigned int ShuffledBits = 4;
constexpr unsigned int NotSplit = 16;
constexpr unsigned int Lz4Compressor = 1;
constexpr unsigned int ZlibCompressor = 3;

void UnpackZlib(const unsigned char* from, std::size_t size, unsigned char* to, std::size_t room)
{
  uLongf done = static_cast<uLongf>(room);
  if (uncompress(to, &done, from, static_cast<uLong>(size)) != Z_OK || done != room)
  {
    ThrowDamaged("zlib");
  }
}

/** Unpacks one block, which has one stream, or one for each byte of a sample. */
void UnpackBloscBlock(const BloscHead& head, const std::vector<char>& bytes, std::size_t from,
  unsigned char* to, std::size_t size)
{
  const auto* const data = reinterpret_cast<const unsigned char*>(bytes.data());
  constexpr std::size_t mostStreams = 16;
  constexpr std::size_t leastSamples = 128;
  const bool isSplit = !head.HasFlag(NotSplit) && size == head.BlockSize &&
    head.SampleSize <= mostStreams && size / head.SampleSize >= leastSamples;
  const std::size_t streams = isSplit ? head.SampleSize : 1;
  const std::size_t part = size / streams;
  for (std::size_t stream = 0; stream < streams; ++stream, to += part)
  {
    if (from > bytes.size() || bytes.size() - from < 4)
    {
      ThrowDamaged("blosc");
    }
    const std::size_t packed = ReadWord(data + from);
    from += 4;
    if (packed > bytes.size() - from)
    {
      ThrowDamaged("blosc");
    }
    if (packed == part)
    {
      std::copy_n(data + from, part, to);
    }
    else if (head.GetCompressor() == Lz4Compressor)
    {
      Lz4Block(data + from, packed, to, part).Unpack();
    }
    else
    {
      UnpackZlib(data + from, packed, to, part);
    }
    from += packed;
  }
}

} // namespace

void InflateChunk(std::vector<char>& bytes)
{
  if (bytes.size() > std::numeric_limits<uInt>::max())
  {
    ThrowDamaged("zlib");
  }
  Inflater inflater;
  z_stream& stream = inflater.Stream;
  stream.next_in = reinterpret_cast<Bytef*>(bytes.data());
  stream.avail_in = static_cast<uInt>(bytes.size());
  std::vector<char> plain(std::max<std::size_t>(4 * bytes.size(), 4096));
  int state = Z_OK;
  while (state == Z_OK)
  {
    if (stream.total_out == plain.size())
    {
      if (plain.size() > MostChunkBytes)
      {
        ThrowDamaged("zlib");
      }
      plain.resize(2 * plain.size());
    }
    stream.next_out = reinterpret_cast<Bytef*>(plain.data() + stream.total_out);
    stream.avail_out = static_cast<uInt>(
      std::min<std::size_t>(plain.size() - stream.total_out, std::size_t{ 1 } << 30));
    state = inflate(&stream, Z_NO_FLUSH);
  }
  if (state != Z_STREAM_END)
  {
    ThrowDamaged("zlib");
  }
  plain.resize(stream.total_out);
  bytes = std::move(plain);
}

void UnpackLz4Chunk(std::vector<char>& bytes)
{
  const auto* const data = reinterpret_cast<const unsigned char*>(bytes.data());
  if (bytes.size() < 4 || ReadWord(data) > MostChunkBytes)
  {
    ThrowDamaged("lz4");
  }
  std::vector<char> plain(ReadWord(data));
  Lz4Block(data + 4, bytes.size() - 4, reinterpret_cast<unsigned char*>(plain.data()), plain.size())
    .Unpack();
  bytes = std::move(plain);
}

void UnpackBloscChunk(std::vector<char>& bytes)
{
  const BloscHead head(bytes);
  std::vector<char> plain(head.Plain);
  if (head.HasFlag(Stored))
  {
    if (bytes.size() - BloscHead::Size < head.Plain)
    {
      ThrowDamaged("blosc");
    }
    std::copy_n(bytes.begin() + BloscHead::Size, head.Plain, plain.begin());
    bytes = std::move(plain);
    return;
  }
  const unsigned int compressor = head.GetCompressor();
  if ((compressor != Lz4Compressor && compressor != ZlibCompressor) || head.HasFlag(ShuffledBits))
  {
    throw std::runtime_error(
      "its chunks are compressed by a kind of Blosc (zstd, blosclz, snappy or shuffled bits) that "
      "is not read here. Write it with Blosc's lz4 and its shuffle of bytes, or without a "
      "compressor; or open it with volumehaptics.open_large() in Python, which uses zarr.");
  }
  const std::size_t blocks =
    head.Plain == 0 ? 0 : (head.Plain + head.BlockSize - 1) / head.BlockSize;
  if ((bytes.size() - BloscHead::Size) / 4 < blocks)
  {
    ThrowDamaged("blosc");
  }
  const auto* const starts = reinterpret_cast<const unsigned char*>(bytes.data()) + BloscHead::Size;
  auto* const to = reinterpret_cast<unsigned char*>(plain.data());
  std::vector<char> block;
  for (std::size_t b = 0; b < blocks; ++b)
  {
    const std::size_t size = std::min(head.BlockSize, head.Plain - b * head.BlockSize);
    block.resize(size);
    UnpackBloscBlock(
      head, bytes, ReadWord(starts + 4 * b), reinterpret_cast<unsigned char*>(block.data()), size);
    if (head.HasFlag(ShuffledBytes))
    {
      UnshuffleChunk(block, head.SampleSize);
    }
    std::memcpy(to + b * head.BlockSize, block.data(), size);
  }
  bytes = std::move(plain);
}

void UnshuffleChunk(std::vector<char>& bytes, std::size_t sampleSize)
{
  const std::size_t count = sampleSize > 1 ? bytes.size() / sampleSize : 0;
  if (count < 2)
  {
    return;
  }
  std::vector<char> plain = bytes; // a remainder of less than a sample is not moved
  for (std::size_t byte = 0; byte < sampleSize; ++byte)
  {
    const char* const from = bytes.data() + byte * count;
    for (std::size_t i = 0; i < count; ++i)
    {
      plain[i * sampleSize + byte] = from[i];
    }
  }
  bytes = std::move(plain);
}

} // namespace VolumeHaptics
