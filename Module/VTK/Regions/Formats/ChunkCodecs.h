// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Unpacks compressed chunks of samples.
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
 * Largest size of an unpacked chunk that is read (bytes). A header that promises more is often
 * damaged.
 */
constexpr std::size_t MostChunkBytes = std::size_t{ 1 } << 30;

///@{
/**
 * Replace packed bytes by plain bytes. Throw std::runtime_error if the bytes are damaged, or if the
 * plain ones are more than `most`, before memory is taken for them. Several threads may call them
 * at once.
 */
void InflateChunk(std::vector<char>& bytes, std::size_t most); ///< unpacks zlib or gzip
/** Unpacks LZ4 as numcodecs writes it, with the size first. */
void UnpackLz4Chunk(std::vector<char>& bytes, std::size_t most);
/** Unpacks Blosc 1, if this build has c-blosc. */
void UnpackBloscChunk(std::vector<char>& bytes, std::size_t most);
/** Unpacks Zstandard, if this build has libzstd. */
void UnpackZstdChunk(std::vector<char>& bytes, std::size_t most);
///@}

///@{
/**
 * Check and remove the checksum at the end: CRC-32C (RFC 3720), and Fletcher's of HDF5. Throw
 * std::runtime_error if it is wrong.
 */
void CheckChunkSum(std::vector<char>& bytes);
void CheckFletcher(std::vector<char>& bytes);
///@}

/**
 * Returns the largest size (bytes) of a chunk between two codecs: packed bytes may be more than the
 * plain ones, by the head of a codec and by what can't be packed.
 */
std::size_t GetMostPackedBytes(std::size_t plain);

/**
 * Unpacks the bytes of zlib or gzip from an offset to the end of a file, and passes on the first
 * `size` bytes in parts. Returns the number of bytes that were passed on. Throws std::runtime_error
 * if the packed bytes are damaged or cut off.
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
