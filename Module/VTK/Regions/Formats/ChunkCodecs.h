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

/** The most bytes of a chunk that is unpacked: more comes of damage. */
constexpr std::size_t MostChunkBytes = std::size_t{ 1 } << 30;

///@{
/** Each replaces packed bytes by the plain ones. Throws std::runtime_error if they are damaged. */
void InflateChunk(std::vector<char>& bytes);     ///< of zlib or gzip
void UnpackLz4Chunk(std::vector<char>& bytes);   ///< as numcodecs writes it: the size comes first
void UnpackBloscChunk(std::vector<char>& bytes); ///< of Blosc 1, with lz4, zlib or no compressor
///@}

/** Undoes the shuffle filter: the first bytes of all samples came first, then the second ones. */
void UnshuffleChunk(std::vector<char>& bytes, std::size_t sampleSize);

} // namespace VolumeHaptics

#endif
