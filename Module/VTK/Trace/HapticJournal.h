// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The journal of a recording that is under way: FILE.part, from which FILE is made when it ends.
 *
 * A journal is written from its beginning to its end, in chunks that each carry a checksum: what
 * the recording is about, the first state, placements, and groups of ticks. A group holds the
 * columns one after the other, each compressed as a block of VTK's XML format is, so that a .vtp is
 * made by copying blocks. Whatever ends a journal, a full disk or the death of the program, all
 * chunks before are read. It is for the machine that wrote it: numbers are as in memory.
 */
#ifndef HapticJournal_h
#define HapticJournal_h

#include "Core/Solvers/ServoStateNumbers.h"
#include "VTK/Trace/HapticTraceColumns.h"

#include <array>
#include <functional>
#include <string>
#include <vector>

namespace VolumeHaptics
{

/** Facts about a whole recording. */
struct RecordingAbout
{
  std::string DeviceId;
  std::string Settings;   ///< what the filter printed when the recording began
  std::string VolumeHash; ///< of the scalars that were touched
};

/** The state and the settings from which a replay begins. */
struct RecordingBegin
{
  std::array<double, ServoStateSize> State;
  double TickPeriod; ///< s
  double Caps[2];    ///< N/m and N s/m
};

/** DeviceToWorld, row by row. */
using PlacementRow = std::array<double, 16>;

/** Ticks in a group, but for the last one. */
constexpr std::size_t GroupSize = 256;

/** The ending of a journal's name. */
constexpr const char* JournalEnding = ".part";

/** Compresses bytes as VTK's XML files do. */
class BlockCompressor
{
public:
  BlockCompressor();
  ~BlockCompressor();
  BlockCompressor(const BlockCompressor&) = delete;
  BlockCompressor& operator=(const BlockCompressor&) = delete;

  /** Appends the compressed bytes; returns how many. */
  std::size_t Compress(const void* data, std::size_t size, std::string& to);
  /** False where that is no block of this size. */
  bool Expand(const std::string& block, void* data, std::size_t size);

private:
  struct Library;
  Library* const Used;
};

class JournalWriter
{
public:
  ~JournalWriter() { this->Close(); }
  JournalWriter() = default;
  JournalWriter(const JournalWriter&) = delete;
  JournalWriter& operator=(const JournalWriter&) = delete;

  /**
   * Creates the journal of a file, with the file's permissions where it exists. False, with the
   * reason and the cure; where another program writes to it, too. One that an earlier recording
   * left is renamed, or where the file system has no locks, which would tell whether it is still
   * written, this one gets another name; the warning says so.
   */
  bool Create(
    const std::string& file, const RecordingAbout& about, std::string& error, std::string& warning);
  const std::string& GetName() const { return this->Name; }
  /** Removes what was created. */
  void Remove();
  ///@{
  /** 0, or the errno of what went wrong; nothing is written after that. */
  int WriteBegin(const RecordingBegin& begin);
  int WritePlacements(const std::vector<PlacementRow>& placements);
  int WriteTicks(const RecordingRow* rows, std::size_t count, std::uint64_t lost);
  ///@}
  void Close();

private:
  friend class JournalReader;
  bool OpenNew(const std::string& file, std::string& error, std::string& warning);
  int WriteChunk(std::uint32_t kind, const std::string& payload);

  std::string Name;
  int Descriptor = -1;
  int Failure = 0;
  BlockCompressor Compressor;
};

class JournalReader
{
public:
  JournalReader() = default;
  ~JournalReader();
  JournalReader(const JournalReader&) = delete;
  JournalReader& operator=(const JournalReader&) = delete;

  ///@{
  /**
   * Looks through all of it; false, with the reason, where it is no journal, or is being written.
   * That of a writer is the file that it wrote, whatever has its name now.
   */
  bool Open(const std::string& journal, std::string& error);
  bool Open(const JournalWriter& writer, std::string& error);
  ///@}
  /** Expects as many ticks as were written. */
  void Expect(std::uint64_t ticks);
  /**
   * Why there is more than could be read, with the numbers; empty where all was read, or where the
   * last chunk alone was cut off, as a crash does it.
   */
  const std::string& GetDamage() const { return this->Damage; }
  bool IsAt(const std::string& file) const;
  /** Removes the journal, if it still has that name, and if locks tell that it is not written. */
  void Remove(const std::string& journal) const;

  const RecordingAbout& GetAbout() const { return this->About; }
  /** Null where there is no tick. */
  const RecordingBegin* GetBegin() const { return this->HasBegin ? &this->Begin : nullptr; }
  std::uint64_t GetNumberOfTicks() const { return this->Ticks; }
  std::uint64_t GetNumberOfPlacements() const { return this->Placements; }
  std::uint64_t GetLostTicks() const { return this->Lost; }

  ///@{
  /** One after the other; false where reading failed. */
  bool ForEachPlacement(const std::function<void(const PlacementRow&)>& visit);
  /** The compressed blocks of a column of GetRecordingColumns. */
  bool ForEachBlock(std::size_t column, const std::function<void(const std::string&)>& visit);
  bool ForEachRow(const std::function<void(const RecordingRow&)>& visit);
  ///@}

private:
  struct Chunk
  {
    std::uint32_t Kind = 0;
    std::uint64_t Payload = 0; ///< where it begins
    std::uint64_t Size = 0;
    std::uint64_t Sum = 0;
  };
  bool Scan(std::string& error);
  /** Looks at what follows the last chunk that is whole. */
  void FindDamage();
  bool IsCutOff(std::uint64_t size);
  bool ReadAt(std::uint64_t position, void* data, std::size_t size);
  bool ReadHead(std::uint64_t position, Chunk& chunk);
  bool TakeIn(const Chunk& chunk, const std::string& payload, std::string& error);
  bool TakeAbout(const std::string& payload, std::string& error);
  bool ForEachChunk(std::uint32_t kind, const std::function<bool(const Chunk&)>& visit);

  int Descriptor = -1;
  int Failure = 0; ///< the errno of the last ReadAt, 0 at the end of the file
  bool IsLocked = false;
  std::uint64_t End = 0; ///< of the last chunk that is whole
  std::string Damage;
  RecordingAbout About;
  bool HasAbout = false;
  RecordingBegin Begin;
  bool HasBegin = false;
  bool HasLastGroup = false;
  std::uint64_t Ticks = 0;
  std::uint64_t Placements = 0;
  std::uint64_t Lost = 0;
};

} // namespace VolumeHaptics

#endif
