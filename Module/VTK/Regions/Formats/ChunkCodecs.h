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

/** Size limit of an unpacked chunk (bytes); only damaged chunks exceed it. */
constexpr std::size_t MostChunkBytes = std::size_t{ 1 } << 30;

///@{
/**
 * Replace packed bytes by the plain bytes. Throw std::runtime_error if the bytes are damaged.
 * Several threads may call them at once.
 */
void InflateChunk(std::vector<char>& bytes);     ///< unpacks zlib or gzip
void UnpackLz4Chunk(std::vector<char>& bytes);   ///< LZ4 of numcodecs, size first
void UnpackBloscChunk(std::vector<char>& bytes); ///< Blosc 1, if this build has c-blosc
///@}

/**
 * Undoes the shuffle filter, which puts the first bytes of all samples first, then the second ones.
 */
void UnshuffleChunk(std::vector<char>& bytes, std::size_t sampleSize);

} // namespace VolumeHaptics

#endif
