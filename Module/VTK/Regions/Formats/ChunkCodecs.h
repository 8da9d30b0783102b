// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Unpacks compressed chunks of samples.
 */
#ifndef ChunkCodecs_h
#define ChunkCodecs_h

#include <cstddef>
#include <vector>

namespace VolumeHaptics
{

class OpenedFile;

/** Largest size of an unpacked chunk (bytes), which only damaged chunks exceed. */
constexpr std::size_t MostChunkBytes = std::size_t{ 1 } << 30;

///@{
/**
 * Replace packed bytes by plain bytes. Throw std::runtime_error if the bytes are damaged. Several
 * threads may call them at once.
 */
void InflateChunk(std::vector<char>& bytes);     ///< unpacks zlib or gzip
void UnpackLz4Chunk(std::vector<char>& bytes);   ///< unpacks LZ4 as numcodecs writes it, with the
                                                 ///< size first
void UnpackBloscChunk(std::vector<char>& bytes); ///< unpacks Blosc 1, if this build has c-blosc
void UnpackZstdChunk(std::vector<char>& bytes);  ///< unpacks Zstandard, if this build has libzstd
void CheckChunkSum(std::vector<char>& bytes);    ///< checks and removes the CRC-32C at the end
///@}

/**
 * Unpacks the bytes of zlib or gzip from an offset to the end of a file into memory. Returns the
 * number of bytes of memory that are filled. Throws std::runtime_error if the packed bytes are
 * damaged or cut off.
 */
std::size_t InflateFile(const OpenedFile& file, std::size_t offset, char* to, std::size_t size);

/**
 * Undoes the shuffle filter, which stores the first bytes of all samples, then all second bytes,
 * and so on.
 */
void UnshuffleChunk(std::vector<char>& bytes, std::size_t sampleSize);

} // namespace VolumeHaptics

#endif
