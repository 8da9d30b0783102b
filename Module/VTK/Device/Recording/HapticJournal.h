// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The journal of a running recording: FILE.part, from which FILE is made at the end.
 *
 * A journal is written from beginning to end, in chunks that each carry a checksum: facts about the
 * recording, the first state with its contacts and removed tissue, placements, and groups of ticks.
 * A group holds the columns one after the other, each compressed as a block of VTK's XML format, so
 * that a .vtp can be made by copying blocks. If a full disk or a crash ends a journal, all chunks
 * before its end can be read. A journal is only for the machine that wrote it: numbers are stored
 * as in memory.
 */
#ifndef HapticJournal_h
#define HapticJournal_h

#include "Core/Carving/TissueSnapshot.h"
#include "Core/State/ServoStateNumbers.h"
#include "VTK/Trace/HapticTraceColumns.h"
#include "VTK/Trace/TraceRow.h"

#include <array>
#include <cstddef>
#include <cstring>
#include <string>
#include <type_traits>

namespace VolumeHaptics
{

/** Facts about a whole recording. */
struct RecordingAbout
{
  std::string DeviceId;
  std::string Settings;   ///< the filter's PrintSelf when the recording began
  std::string VolumeHash; ///< hash of the touched scalars; empty while it is not known
};

/**
 * Hashes that may become known after a recording began. A text is empty if there is nothing to
 * hash.
 */
struct RecordingHashes
{
  std::string Volume;
  std::string Labels;
};

/** The state and the settings at the beginning of a replay. */
struct RecordingBegin
{
  std::array<double, ServoStateSize> State;
  double TickPeriod; ///< s
  double AirValue;   ///< air value of a volume whose tissue may be removed; otherwise NaN
};

/** Placement and caps of the device while a generation of ticks is made. */
struct PlacementRow
{
  std::array<double, 16> Matrix; ///< DeviceToWorld, row by row
  std::array<double, 2> Caps;    ///< stiffness and damping (N/m and N s/m)
};

/** Number of ticks in a group; only the last group may have fewer. */
constexpr std::size_t GroupSize = 256;

/** Suffix of a journal's file name. */
constexpr const char* JournalEnding = ".part";

// Format of a journal, for its writer and its reader. A chunk is a head (kind, 0, size and checksum
// of the payload) and a payload. Payloads by kind:
// - About: JournalMark, then texts, each after its length: the columns, and the texts of
//   RecordingAbout
// - Hashes: the texts of RecordingHashes, each after its length, once they are known
// - Begin: a RecordingBegin
// - Contacts: ContactRows, after Begin
// - Tissue: BrickTissue of removed tissue, after Begin
// - Placements: PlacementRows
// - Ticks: the number of lost ticks so far (64 bits), the number of ticks in the chunk (32 bits),
//   the size of each column's block (32 bits), and the blocks

/** Mark at the beginning of a journal. The last byte is the version of the format. */
constexpr char JournalMark[16] = { 'V', 'o', 'l', 'u', 'm', 'e', 'H', 'a', 'p', 't', 'i', 'c', 's',
  'J', '\0', '\4' };

constexpr std::uint32_t AboutChunk =
  0x41744856; // no chunk begins with zeros, because files may end with zeros after a power cut
constexpr std::uint32_t HashesChunk = 0x48744856;
constexpr std::uint32_t BeginChunk = 0x42744856;
constexpr std::uint32_t ContactsChunk = 0x43744856;
constexpr std::uint32_t TissueChunk = 0x53744856;
constexpr std::uint32_t PlacementsChunk = 0x50744856;
constexpr std::uint32_t TicksChunk = 0x54744856;

constexpr std::size_t HeadSize = 24;
constexpr std::size_t TicksHeadSize = 12;

std::uint64_t SumOf(const std::string& payload);
/** Lists names, types and components of the columns. A journal with other columns can't be read. */
std::string SignatureOfColumns();

/** Appends a text's length, then the text. */
void PutText(std::string& bytes, const std::string& text);
/** Reads a text's length, then the text. Returns false if there are not enough bytes. */
bool GetText(const std::string& bytes, std::size_t& position, std::string& text);

template <typename T>
void Put(std::string& bytes, const T& value)
{
  static_assert(std::is_trivially_copyable<T>::value, "bytes are all that there is of it");
  bytes.append(reinterpret_cast<const char*>(&value), sizeof(value));
}

/** Reads a value. Returns false if there are not enough bytes. */
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

/** Compresses bytes in the format of VTK's XML files. */
class BlockCompressor
{
public:
  BlockCompressor();
  ~BlockCompressor();
  BlockCompressor(const BlockCompressor&) = delete;
  BlockCompressor& operator=(const BlockCompressor&) = delete;

  /** Appends the compressed bytes and returns their number. */
  std::size_t Compress(const void* data, std::size_t size, std::string& to);
  /** Expands a block to `size` bytes. Returns false if it does not have exactly this size. */
  bool Expand(const std::string& block, void* data, std::size_t size);

private:
  struct Library;
  Library* const Used;
};

} // namespace VolumeHaptics

#endif
