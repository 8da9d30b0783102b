// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Regions/Formats/ChunkCodecs.h"

#include "VTK/Regions/Formats/OpenedFile.h"

#include "vtk_lz4.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <memory>
#include <new>
#include <stdexcept>
#include <string>
#include <utility>
#include <zlib.h>

#if defined(VOLUME_HAPTICS_HAS_BLOSC)
#include <blosc.h>
#endif
#if defined(VOLUME_HAPTICS_HAS_ZSTD)
#include <zstd.h>
#endif

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

/** zlib stream, closed when it goes out of scope, even after an exception. */
struct Inflater
{
  Inflater()
  {
    constexpr int withAnyHeader = 15 + 32; // any window size; header of zlib or gzip
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

} // namespace

void InflateChunk(std::vector<char>& bytes, std::size_t most)
{
  if (bytes.size() > std::numeric_limits<uInt>::max())
  {
    ThrowDamaged("zlib");
  }
  Inflater inflater;
  z_stream& stream = inflater.Stream;
  stream.next_in = reinterpret_cast<Bytef*>(bytes.data());
  stream.avail_in = static_cast<uInt>(bytes.size());
  std::vector<char> plain(std::min(std::max<std::size_t>(4 * bytes.size(), 4096), most + 1));
  int state = Z_OK;
  while (state == Z_OK)
  {
    if (stream.total_out == plain.size())
    {
      plain.resize(std::min(2 * plain.size(), most + 1));
    }
    stream.next_out = reinterpret_cast<Bytef*>(plain.data() + stream.total_out);
    stream.avail_out = static_cast<uInt>(
      std::min<std::size_t>(plain.size() - stream.total_out, std::size_t{ 1 } << 30));
    state = stream.total_out > most ? Z_DATA_ERROR : inflate(&stream, Z_NO_FLUSH);
  }
  if (state != Z_STREAM_END || stream.total_out > most)
  {
    ThrowDamaged("zlib");
  }
  plain.resize(stream.total_out);
  bytes = std::move(plain);
}

std::size_t InflateFile(const OpenedFile& file, std::size_t offset, std::size_t size,
  const std::function<void(const char* part, std::size_t size)>& take)
{
  constexpr std::size_t partSize = std::size_t{ 1 } << 18;
  const auto length = static_cast<std::size_t>(file.GetSize());
  std::vector<char> packed(partSize);
  std::vector<char> plain(partSize);
  Inflater inflater;
  z_stream& stream = inflater.Stream;
  std::size_t count = 0;
  int state = Z_STREAM_END;
  bool hasAny = false;
  // After the last input byte was read, zlib may still have output.
  while (offset < length || stream.avail_in > 0 || (state == Z_OK && stream.avail_out == 0))
  {
    if (stream.avail_in == 0 && offset < length)
    {
      const std::size_t part = std::min(partSize, length - offset);
      file.Read(packed.data(), part, static_cast<std::int64_t>(offset));
      offset += part;
      stream.next_in = reinterpret_cast<Bytef*>(packed.data());
      stream.avail_in = static_cast<uInt>(part);
    }
    if (state == Z_STREAM_END)
    {
      // Another gzip stream may follow; other bytes are ignored.
      constexpr Bytef gzipMagic = 0x1f;
      if (hasAny && *stream.next_in != gzipMagic)
      {
        return count;
      }
      hasAny = true;
      inflateReset(&stream);
    }
    stream.next_out = reinterpret_cast<Bytef*>(plain.data());
    stream.avail_out = static_cast<uInt>(partSize);
    state = inflate(&stream, Z_NO_FLUSH);
    // Decompress the bytes beyond `size` only to verify the checksum.
    const std::size_t got = std::min(partSize - stream.avail_out, size - count);
    take(plain.data(), got);
    count += got;
    if (state != Z_OK && state != Z_STREAM_END && state != Z_BUF_ERROR)
    {
      break;
    }
  }
  if (!hasAny || state != Z_STREAM_END)
  {
    throw std::runtime_error(
      "its compressed samples are damaged or truncated. Check that the copy is complete, or write "
      "it again.");
  }
  return count;
}

void UnpackLz4Chunk(std::vector<char>& bytes, std::size_t most)
{
  constexpr std::size_t headSize = 4;
  if (bytes.size() < headSize || bytes.size() > MostChunkBytes)
  {
    ThrowDamaged("lz4");
  }
  const std::size_t size = ReadWord(reinterpret_cast<const unsigned char*>(bytes.data()));
  if (size > std::min(most, MostChunkBytes))
  {
    ThrowDamaged("lz4");
  }
  std::vector<char> plain(size);
  const int done = LZ4_decompress_safe(bytes.data() + headSize, plain.data(),
    static_cast<int>(bytes.size() - headSize), static_cast<int>(size));
  if (done != static_cast<int>(size))
  {
    ThrowDamaged("lz4");
  }
  bytes = std::move(plain);
}

#if defined(VOLUME_HAPTICS_HAS_BLOSC)
void UnpackBloscChunk(std::vector<char>& bytes, std::size_t most)
{
  std::size_t size = 0;
  std::size_t packed = 0;
  std::size_t block = 0;
  if (bytes.size() >= BLOSC_MIN_HEADER_LENGTH)
  {
    blosc_cbuffer_sizes(bytes.data(), &size, &packed, &block);
  }
  // A checksum may follow after the compressed bytes.
  if (packed == 0 || packed > bytes.size() || size > most ||
    blosc_cbuffer_validate(bytes.data(), packed, &size) != 0)
  {
    ThrowDamaged("blosc");
  }
  std::vector<char> plain(size);
  constexpr int threads = 1;
  if (blosc_decompress_ctx(bytes.data(), plain.data(), size, threads) != static_cast<int>(size))
  {
    ThrowDamaged("blosc");
  }
  bytes = std::move(plain);
}
#else
void UnpackBloscChunk(std::vector<char>&, std::size_t)
{
  throw std::runtime_error(
    "its chunks are compressed by Blosc, which this build can't unpack. Build it with c-blosc "
    "(package libblosc-dev), write the array with another compressor, or open it with "
    "volumehaptics.open_large() in Python, which uses zarr.");
}
#endif

#if defined(VOLUME_HAPTICS_HAS_ZSTD)
void UnpackZstdChunk(std::vector<char>& bytes, std::size_t most)
{
  // The size is unknown if the data were written as a stream.
  const unsigned long long told = ZSTD_getFrameContentSize(bytes.data(), bytes.size());
  if (told == ZSTD_CONTENTSIZE_ERROR || (told != ZSTD_CONTENTSIZE_UNKNOWN && told > most))
  {
    ThrowDamaged("zstd");
  }
  std::vector<char> plain(told == ZSTD_CONTENTSIZE_UNKNOWN
      ? std::min(std::max<std::size_t>(4 * bytes.size(), 4096), most)
      : static_cast<std::size_t>(told));
  const std::unique_ptr<ZSTD_DCtx, std::size_t (*)(ZSTD_DCtx*)> context(
    ZSTD_createDCtx(), ZSTD_freeDCtx);
  ZSTD_inBuffer in{ bytes.data(), bytes.size(), 0 };
  ZSTD_outBuffer out{ plain.data(), plain.size(), 0 };
  while (true)
  {
    const std::size_t had = in.pos + out.pos;
    const std::size_t left = ZSTD_decompressStream(context.get(), &out, &in);
    if (left == 0 && in.pos == in.size)
    {
      break;
    }
    const bool isFull = out.pos == out.size;
    if (ZSTD_isError(left) || (!isFull && in.pos + out.pos == had) ||
      (isFull && plain.size() >= most))
    {
      ThrowDamaged("zstd");
    }
    if (isFull)
    {
      plain.resize(std::min(2 * plain.size() + 1, most));
      out = { plain.data(), plain.size(), out.pos };
    }
  }
  plain.resize(out.pos);
  bytes = std::move(plain);
}
#else
void UnpackZstdChunk(std::vector<char>&, std::size_t)
{
  throw std::runtime_error(
    "its chunks are compressed by Zstandard, which this build can't unpack. Build it with zstd "
    "(package libzstd-dev), write the array with another compressor, or open it with "
    "volumehaptics.open_large() in Python, which uses zarr.");
}
#endif

void CheckChunkSum(std::vector<char>& bytes)
{
  constexpr std::size_t sumSize = 4;
  constexpr std::uint32_t castagnoli = 0x82f63b78; // reversed polynomial of RFC 3720
  if (bytes.size() < sumSize)
  {
    ThrowDamaged("crc32c");
  }
  const std::size_t size = bytes.size() - sumSize;
  std::uint32_t sum = 0xffffffff;
  for (std::size_t i = 0; i < size; ++i)
  {
    sum ^= static_cast<unsigned char>(bytes[i]);
    for (int bit = 0; bit < 8; ++bit)
    {
      sum = (sum >> 1) ^ ((sum & 1) != 0 ? castagnoli : 0);
    }
  }
  if (~sum != ReadWord(reinterpret_cast<const unsigned char*>(bytes.data() + size)))
  {
    ThrowDamaged("crc32c");
  }
  bytes.resize(size);
}

void CheckFletcher(std::vector<char>& bytes)
{
  // Computes Fletcher's checksum as in "HDF5 File Format Specification", Data Object Header Message
  // 0x000B, filter 3, and in HDF5's library: sums of 16-bit big-endian words, folded. An odd last
  // byte counts as a high byte.
  constexpr std::size_t sumSize = 4;
  const std::size_t size = bytes.size() - std::min(bytes.size(), sumSize);
  const auto* const from = reinterpret_cast<const unsigned char*>(bytes.data());
  std::uint64_t first = 0;
  std::uint64_t second = 0;
  const auto fold = [](std::uint64_t& sum)
  {
    while (sum > 0xffff)
    {
      sum = (sum & 0xffff) + (sum >> 16);
    }
  };
  for (std::size_t i = 0; i < size; i += 2)
  {
    first += std::uint64_t{ from[i] } << 8 | (i + 1 < size ? from[i + 1] : 0);
    fold(first);
    second += first;
    fold(second);
  }
  const auto sum = static_cast<std::uint32_t>(second << 16 | first);
  // HDF5 before 1.6.3 swapped the bytes of each half.
  const std::uint32_t old = (sum & 0x00ff00ff) << 8 | (sum >> 8 & 0x00ff00ff);
  const std::uint32_t told = bytes.size() < sumSize ? ~sum : ReadWord(from + size);
  if (bytes.size() < sumSize || (told != sum && told != old))
  {
    ThrowDamaged("fletcher32");
  }
  bytes.resize(size);
}

std::size_t GetMostPackedBytes(std::size_t plain)
{
  // Upper bound: deflate, LZ4, Blosc and Zstandard add less than an eighth, and headers of less
  // than a kilobyte.
  return plain + plain / 8 + 4096;
}

void UnshuffleChunk(std::vector<char>& bytes, std::size_t sampleSize)
{
  const std::size_t count = sampleSize > 1 ? bytes.size() / sampleSize : 0;
  if (count < 2)
  {
    return;
  }
  std::vector<char> plain = bytes; // leaves a remainder smaller than a sample unchanged
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
