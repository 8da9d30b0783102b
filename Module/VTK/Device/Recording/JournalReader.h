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
   * Opens and scans a journal. Returns false, with the reason in `error`, if the file is not a
   * journal or is still being written. The overload with a writer reads the writer's own file, even
   * if another file has its name now.
   */
  bool Open(const std::string& journal, std::string& error);
  bool Open(const JournalWriter& writer, std::string& error);
  ///@}
  /** Sets how many ticks were written, so that the reader can detect a missing end. */
  void Expect(std::uint64_t ticks);
  /**
   * Explains with numbers why part of the journal can't be read. Empty if everything was read, or
   * if a crash only cut off the last chunk.
   */
  const std::string& GetDamage() const { return this->Damage; }
  bool IsAt(const std::string& file) const;
  /**
   * Removes the journal, provided that this name still refers to it and a lock shows that no
   * program is writing it.
   */
  void Remove(const std::string& journal) const;

  const RecordingAbout& GetAbout() const { return this->About; }
  /** Returns the state from which a replay starts; null if the journal has no ticks. */
  const RecordingBegin* GetBegin() const { return this->HasBegin ? &this->Begin : nullptr; }
  std::uint64_t GetNumberOfTicks() const { return this->Ticks; }
  /** Returns the number of contacts of the tool's shape in the first state. */
  std::uint64_t GetNumberOfContacts() const { return this->Contacts; }
  /** Returns the number of bricks with removed tissue in the first state. */
  std::uint64_t GetNumberOfBricks() const { return this->Bricks; }
  std::uint64_t GetNumberOfPlacements() const { return this->Placements; }
  std::uint64_t GetLostTicks() const { return this->Lost; }

  /**
   * Reads the caps of all placements one after the other; only one pair if all are equal. Returns
   * false if reading failed.
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
  /** Call `visit` for each placement or row in turn. Return false if reading failed. */
  bool ForEachPlacement(const std::function<void(const PlacementRow&)>& visit);
  /**
   * Calls `visit` for each compressed block of a column of GetRecordingColumns(). Returns false if
   * reading failed.
   */
  bool ForEachBlock(std::size_t column, const std::function<void(const std::string&)>& visit);
  bool ForEachRow(const std::function<void(const RecordingRow&)>& visit);
  ///@}

private:
  struct Chunk
  {
    std::uint32_t Kind = 0;
    std::uint64_t Payload = 0; ///< offset (bytes) of the payload in the file
    std::uint64_t Size = 0;
    std::uint64_t Sum = 0;
  };
  bool Scan(std::string& error);
  /** Examines the bytes after the last whole chunk and describes damage. */
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
  int Failure = 0; ///< errno of the last ReadAt; 0 at the end of the file
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
