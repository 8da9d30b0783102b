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
 * before its end can be read. A journal can only be read on the kind of machine that wrote it,
 * because numbers are stored as they are in memory.
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
  std::string Settings;   ///< output of the filter's PrintSelf at the start of the recording
  std::string VolumeHash; ///< hash of the touched scalars; empty until it is computed
};

/**
 * Hashes that may be computed only after a recording has started. A text is empty if there are no
 * data to hash.
 */
struct RecordingHashes
{
  std::string Volume;
  std::string Labels;
};

/** State and settings from which a replay starts. */
struct RecordingBegin
{
  std::array<double, ServoStateSize> State;
  double TickPeriod; ///< s
  double AirValue;   ///< value of air if tissue may be removed from the volume; otherwise NaN
};

/** Placement and force caps of the device during one generation of ticks. */
struct PlacementRow
{
  std::array<double, 16> Matrix; ///< DeviceToWorld, row by row
  std::array<double, 2> Caps;    ///< stiffness and damping (N/m and N s/m)
};

/** Number of ticks in a group. Only the last group may have fewer. */
constexpr std::size_t GroupSize = 256;

/** Suffix of a journal's file name. */
constexpr const char* JournalEnding = ".part";

// The chunks of a journal. Each has a head (kind, 0, size and checksum of the payload) and a
// payload. The payloads by kind:
// - About: JournalMark, then texts, each after its length: the columns, and the texts of
//   RecordingAbout
// - Hashes: the texts of RecordingHashes, each after its length; written once they are computed
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
  0x41744856; // not 0, because files may end with zeros after a power cut
constexpr std::uint32_t HashesChunk = 0x48744856;
constexpr std::uint32_t BeginChunk = 0x42744856;
constexpr std::uint32_t ContactsChunk = 0x43744856;
constexpr std::uint32_t TissueChunk = 0x53744856;
constexpr std::uint32_t PlacementsChunk = 0x50744856;
constexpr std::uint32_t TicksChunk = 0x54744856;

constexpr std::size_t HeadSize = 24;
constexpr std::size_t TicksHeadSize = 12;

std::uint64_t SumOf(const std::string& payload);
/**
 * Returns the names, types and components of the columns as text. A journal with another signature
 * can't be read.
 */
std::string SignatureOfColumns();

/** Appends a text's length, then the text. */
void PutText(std::string& bytes, const std::string& text);
/** Reads a text that follows its length. Returns false if there are too few bytes. */
bool GetText(const std::string& bytes, std::size_t& position, std::string& text);

template <typename T>
void Put(std::string& bytes, const T& value)
{
  static_assert(std::is_trivially_copyable<T>::value, "bytes are all that there is of it");
  bytes.append(reinterpret_cast<const char*>(&value), sizeof(value));
}

/** Reads a value as it is in memory. Returns false if there are too few bytes. */
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

/** Compresses blocks of bytes as in VTK's XML files. */
class BlockCompressor
{
public:
  BlockCompressor();
  ~BlockCompressor();
  BlockCompressor(const BlockCompressor&) = delete;
  BlockCompressor& operator=(const BlockCompressor&) = delete;

  /** Appends the compressed bytes and returns their number. */
  std::size_t Compress(const void* data, std::size_t size, std::string& to);
  /** Decompresses a block. Returns false if the result does not have exactly `size` bytes. */
  bool Expand(const std::string& block, void* data, std::size_t size);

private:
  struct Library;
  Library* const Used;
};

} // namespace VolumeHaptics

#endif
