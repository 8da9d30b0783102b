// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Reads the journal of a recording, even if a crash or a full disk ended it.
 */
#ifndef JournalReader_h
#define JournalReader_h

#include "VTK/Device/Recording/HapticJournal.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace VolumeHaptics
{

class JournalWriter;

class JournalReader
{
public:
  JournalReader() = default;
  ~JournalReader();
  JournalReader(const JournalReader&) = delete;
  JournalReader& operator=(const JournalReader&) = delete;

  ///@{
  /**
   * Scans the journal. Returns false, and the reason in `error`, if the file is no journal or is
   * still being written. With a writer, reads the file that this writer wrote, even if another file
   * has its name now.
   */
  bool Open(const std::string& journal, std::string& error);
  bool Open(const JournalWriter& writer, std::string& error);
  ///@}
  /** Sets the number of ticks that were written, so that a missing end is detected. */
  void Expect(std::uint64_t ticks);
  /**
   * Explains with numbers why a part of the journal can't be read. Empty if everything was read, or
   * if a crash cut off only the last chunk.
   */
  const std::string& GetDamage() const { return this->Damage; }
  bool IsAt(const std::string& file) const;
  /**
   * Removes the journal if the file still has that name and a lock shows that no program writes to
   * it.
   */
  void Remove(const std::string& journal) const;

  const RecordingAbout& GetAbout() const { return this->About; }
  /** Returns the state at the beginning of a replay; null if there is no tick. */
  const RecordingBegin* GetBegin() const { return this->HasBegin ? &this->Begin : nullptr; }
  std::uint64_t GetNumberOfTicks() const { return this->Ticks; }
  /** Returns the number of contacts of a tool with a shape in the first state. */
  std::uint64_t GetNumberOfContacts() const { return this->Contacts; }
  /** Returns the number of bricks whose tissue had been removed at the first state. */
  std::uint64_t GetNumberOfBricks() const { return this->Bricks; }
  std::uint64_t GetNumberOfPlacements() const { return this->Placements; }
  std::uint64_t GetLostTicks() const { return this->Lost; }

  /**
   * Reads the caps of all placements one after the other, or only one pair if all are the same.
   * Returns false if reading failed.
   */
  bool ReadCaps(std::vector<double>& caps);
  ///@{
  /**
   * Read the contacts and the removed tissue of the first state. Returns false if reading failed.
   */
  bool ReadContacts(std::vector<ContactRow>& contacts);
  bool ReadTissue(std::vector<BrickTissue>& shares);
  ///@}
  ///@{
  /** Visit all placements, or all rows, in turn. Returns false if reading failed. */
  bool ForEachPlacement(const std::function<void(const PlacementRow&)>& visit);
  /**
   * Visits the compressed blocks of one of GetRecordingColumns' columns in turn. Returns false if
   * reading failed.
   */
  bool ForEachBlock(std::size_t column, const std::function<void(const std::string&)>& visit);
  bool ForEachRow(const std::function<void(const RecordingRow&)>& visit);
  ///@}

private:
  struct Chunk
  {
    std::uint32_t Kind = 0;
    std::uint64_t Payload = 0; ///< position of the payload
    std::uint64_t Size = 0;
    std::uint64_t Sum = 0;
  };
  bool Scan(std::string& error);
  /** Examines the bytes after the last whole chunk. */
  void DetectDamage();
  bool IsCutOff(std::uint64_t size);
  bool ReadAt(std::uint64_t position, void* data, std::size_t size);
  bool ReadHead(std::uint64_t position, Chunk& chunk);
  bool ApplyChunk(const Chunk& chunk, const std::string& payload, std::string& error);
  bool ReadHashes(const std::string& payload);
  bool ReadAbout(const std::string& payload, std::string& error);
  template <typename Row>
  bool ReadRows(std::uint32_t kind, std::vector<Row>& rows);
  bool ForEachChunk(std::uint32_t kind, const std::function<bool(const Chunk&)>& visit);

  int Descriptor = -1;
  int Failure = 0; ///< errno of the last ReadAt, 0 at the end of the file
  bool IsLocked = false;
  std::uint64_t End = 0; ///< end of the last whole chunk
  std::string Damage;
  RecordingAbout About;
  bool HasAbout = false;
  RecordingBegin Begin;
  bool HasBegin = false;
  bool HasLastGroup = false;
  std::uint64_t Ticks = 0;
  std::uint64_t Contacts = 0;
  std::uint64_t Bricks = 0;
  std::uint64_t Placements = 0;
  std::uint64_t Lost = 0;
};

} // namespace VolumeHaptics

#endif
