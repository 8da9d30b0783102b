// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Decompresses chunks of samples.
 */
#ifndef ChunkCodecs_h
#define ChunkCodecs_h

#include <cstddef>
#include <functional>
#include <vector>

namespace VolumeHaptics
{

class OpenedFile;

/**
 * Largest accepted size (bytes) of a decompressed chunk. A header that declares more is probably
 * damaged.
 */
constexpr std::size_t MostChunkBytes = std::size_t{ 1 } << 30;

///@{
/**
 * Decompress `bytes` in place. Throw std::runtime_error, before allocating memory, if the result is
 * larger than `most`; also throw it if the bytes are damaged. Safe on several threads at once.
 */
void InflateChunk(std::vector<char>& bytes, std::size_t most); ///< zlib or gzip
/** LZ4 in numcodecs' format, with the size first. */
void UnpackLz4Chunk(std::vector<char>& bytes, std::size_t most);
/** Blosc 1, if this build has c-blosc. */
void UnpackBloscChunk(std::vector<char>& bytes, std::size_t most);
/** Zstandard, if this build has libzstd. */
void UnpackZstdChunk(std::vector<char>& bytes, std::size_t most);
///@}

///@{
/**
 * Verify and remove the checksum at the end: CRC-32C (RFC 3720), and Fletcher's checksum of HDF5.
 * Throw std::runtime_error if it is wrong.
 */
void CheckChunkSum(std::vector<char>& bytes);
void CheckFletcher(std::vector<char>& bytes);
///@}

/**
 * Returns the largest size (bytes) of a chunk between two codecs. A codec can enlarge a chunk by
 * its header and by data that do not compress.
 */
std::size_t GetMostPackedBytes(std::size_t plain);

/**
 * Decompresses zlib or gzip data from an offset to the end of a file, and passes on the first
 * `size` bytes in parts. Returns the number of bytes that were passed on. Throws std::runtime_error
 * if the data are damaged or cut off.
 */
std::size_t InflateFile(const OpenedFile& file, std::size_t offset, std::size_t size,
  const std::function<void(const char* part, std::size_t size)>& take);

/**
 * Undoes the shuffle filter, which stores the first bytes of all samples, then all second bytes,
 * and so on.
 */
void UnshuffleChunk(std::vector<char>& bytes, std::size_t sampleSize);

} // namespace VolumeHaptics

#endif
