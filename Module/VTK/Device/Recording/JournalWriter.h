// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Writes the journal of a running recording.
 */
#ifndef JournalWriter_h
#define JournalWriter_h

#include "VTK/Device/Recording/HapticJournal.h"

#include <cstdint>
#include <string>
#include <vector>

namespace VolumeHaptics
{

class JournalWriter
{
public:
  ~JournalWriter() { this->Close(); }
  JournalWriter() = default;
  JournalWriter(const JournalWriter&) = delete;
  JournalWriter& operator=(const JournalWriter&) = delete;

  /**
   * Creates the journal of a file, with the permissions of the file if that exists. Returns false,
   * with the reason and the cure in `error`, if it can't be created or if another program is
   * writing it. Renames a journal that an earlier recording left. On a file system without locks,
   * nothing shows whether the earlier journal is still being written, so the new journal gets
   * another name. `warning` reports both cases.
   */
  bool Create(
    const std::string& file, const RecordingAbout& about, std::string& error, std::string& warning);
  const std::string& GetName() const { return this->Name; }
  /** Deletes the journal that Create() made. */
  void Remove();
  ///@{
  /** Write chunks. Return 0, or the errno of a failure, after which no more is written. */
  int WriteHashes(const RecordingHashes& hashes);
  int WriteBegin(const RecordingBegin& begin);
  int WriteContacts(const std::vector<ContactRow>& contacts);
  int WriteTissue(const std::vector<BrickTissue>& shares);
  int WritePlacements(const std::vector<PlacementRow>& placements);
  int WriteTicks(const RecordingRow* rows, std::size_t count, std::uint64_t lost);
  ///@}
  void Close();

private:
  friend class JournalReader; // reads through the descriptor of this writer
  bool OpenNew(const std::string& file, std::string& error, std::string& warning);
  int WriteChunk(std::uint32_t kind, const std::string& payload);
  /** Writes rows as chunks of a kind. Writes nothing if there are no rows. */
  template <typename Row>
  int WriteRows(std::uint32_t kind, const std::vector<Row>& rows);

  std::string Name;
  int Descriptor = -1;
  int Failure = 0;
  BlockCompressor Compressor;
};

} // namespace VolumeHaptics

#endif
