// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The format of a journal, for its writer and its reader.
 *
 * A chunk is a head (kind, 0, size and checksum of the payload) and a payload. Payloads:
 * - About: JournalMark, then texts, each after its length: the columns, and the texts of
 *   RecordingAbout;
 * - Hashes: the texts of RecordingHashes, each after its length, once they are known;
 * - Begin: a RecordingBegin;
 * - Contacts: ContactRows, after Begin;
 * - Shares: BrickShares of removed tissue, after Begin;
 * - Placements: PlacementRows;
 * - Ticks: the number of lost ticks so far (64 bits), the number of these (32 bits), the size of
 *   each column's block (32 bits), and the blocks.
 */
#ifndef HapticJournalChunks_h
#define HapticJournalChunks_h

#include "VTK/Device/Recording/HapticJournal.h"

#include <cstring>
#include <type_traits>

namespace VolumeHaptics
{

/** The last byte counts the changes of this format. */
constexpr char JournalMark[16] = { 'V', 'o', 'l', 'u', 'm', 'e', 'H', 'a', 'p', 't', 'i', 'c', 's',
  'J', '\0', '\4' };

constexpr std::uint32_t AboutChunk =
  0x41744856; // no chunk begins with zeros, because files may end with zeros after a power cut
constexpr std::uint32_t HashesChunk = 0x48744856;
constexpr std::uint32_t BeginChunk = 0x42744856;
constexpr std::uint32_t ContactsChunk = 0x43744856;
constexpr std::uint32_t SharesChunk = 0x53744856;
constexpr std::uint32_t PlacementsChunk = 0x50744856;
constexpr std::uint32_t TicksChunk = 0x54744856;

constexpr std::size_t HeadSize = 24;
constexpr std::size_t TicksHeadSize = 12;

std::uint64_t SumOf(const std::string& payload);
/** Lists names, types and components of the columns: a journal with other columns can't be read. */
std::string SignatureOfColumns();

/** Appends a text after its length. */
void PutText(std::string& bytes, const std::string& text);
/** Reads a text after its length. False if there are not enough bytes. */
bool GetText(const std::string& bytes, std::size_t& position, std::string& text);

template <typename T>
void Put(std::string& bytes, const T& value)
{
  static_assert(std::is_trivially_copyable<T>::value, "bytes are all that there is of it");
  bytes.append(reinterpret_cast<const char*>(&value), sizeof(value));
}

/** Reads a value. False if there are not enough bytes. */
template <typename T>
bool Get(const std::string& bytes, std::size_t& position, T& value)
{
  static_assert(std::is_trivially_copyable<T>::value, "bytes are all that there is of it");
  if (bytes.size() < sizeof(value) || position > bytes.size() - sizeof(value))
  {
    return false;
  }
  std::memcpy(&value, bytes.data() + position, sizeof(value));
  position += sizeof(value);
  return true;
}

} // namespace VolumeHaptics

#endif
