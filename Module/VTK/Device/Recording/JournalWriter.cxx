// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Device/Recording/JournalWriter.h"

#include "Core/Platform/Files.h"
#include "Core/Platform/HapticFiles.h"
#include "VTK/Device/Recording/HapticJournal.h"
#include "VTK/Trace/HapticTraceColumns.h"

#include <algorithm>
#include <cerrno>
#include <cstring>

namespace VolumeHaptics
{
namespace
{

enum class JournalPlace
{
  Free,    ///< there is no journal, or it was renamed
  Unknown, ///< there is a journal, but no lock shows whether it is still being written
  Taken
};

constexpr int MostNames = 1000;
constexpr const char* TooManyNames = "there are too many unfinished recordings of that name beside "
                                     "it. Remove some, or give another name.";

std::string Numbered(const std::string& journal, int number)
{
  return journal + "." + std::to_string(number);
}

/** Renames the open journal of an earlier recording to an unused name. */
bool Rename(int descriptor, const std::string& journal, std::string& error, std::string& warning)
{
  for (int i = 1; i <= MostNames; ++i)
  {
    const std::string free = Numbered(journal, i);
    if (Files::Exists(free))
    {
      continue;
    }
    if (Files::IsSame(descriptor, journal) && !Files::Rename(journal, free))
    {
      error = "the unfinished recording " + Printable(journal) + " can't be renamed (" +
        DescribeError(errno) + "). Remove it, or give another name.";
      return false;
    }
    warning = "An earlier recording of that name was not finished. Its ticks are now in " +
      Printable(free) + ": make a recording of it with vtkHapticRecorder::Recover, or remove it.";
    return true;
  }
  error = TooManyNames;
  return false;
}

JournalPlace PutAside(const std::string& journal, std::string& error, std::string& warning)
{
  if (!Files::Exists(journal))
  {
    return JournalPlace::Free; // another failure: creating the file will report a better error
  }
  std::string reason;
  if (!CheckRegular(journal, reason))
  {
    error = "the name of its journal, " + Printable(journal) + ", " + reason +
      ". Remove that, or give another name.";
    return JournalPlace::Taken;
  }
  const int descriptor = Files::Open(journal, Files::For::Reading);
  if (descriptor < 0)
  {
    error = "the unfinished recording " + Printable(journal) + " can't be read (" +
      DescribeError(errno) + "). Remove it, or give another name.";
    return JournalPlace::Taken;
  }
  JournalPlace place = JournalPlace::Taken;
  if (Files::LockAlone(descriptor))
  {
    place = Rename(descriptor, journal, error, warning) ? JournalPlace::Free : JournalPlace::Taken;
  }
  else if (errno == EWOULDBLOCK)
  {
    error = "it is being recorded already. Give another name.";
  }
  else
  {
    place = JournalPlace::Unknown;
  }
  Files::Close(descriptor);
  return place;
}

} // namespace

bool JournalWriter::OpenNew(const std::string& file, std::string& error, std::string& warning)
{
  const std::string journal = file + JournalEnding;
  const JournalPlace place = PutAside(journal, error, warning);
  if (place == JournalPlace::Taken)
  {
    return false;
  }
  Files::Status status;
  const bool isOld = Files::GetStatus(file, status);
  constexpr Files::Mode everybody = 0666; // the process's umask removes some of these permissions
  const Files::Mode mode = isOld ? status.st_mode & 0600 : everybody;
  this->Name = journal;
  int number = 0;
  do
  {
    this->Name = place == JournalPlace::Free ? journal : Numbered(journal, ++number);
    this->Descriptor = Files::Open(this->Name, Files::For::MakingNew, mode | 0600);
  } while (this->Descriptor < 0 && errno == EEXIST && place == JournalPlace::Unknown &&
    number < MostNames);
  if (this->Descriptor < 0)
  {
    error = errno == EEXIST ? place == JournalPlace::Free
        ? "it is being recorded already. Give another name."
        : TooManyNames
                            : ExplainWriteError(errno, this->Name);
    return false;
  }
  // Some file systems have no locks; the journal is then not locked.
  if (!Files::LockAlone(this->Descriptor) && errno == EWOULDBLOCK)
  {
    error = "it is being recorded already. Give another name.";
    return false;
  }
  if (isOld)
  {
    (void)Files::CopyPermissions(this->Descriptor, status);
  }
  if (place == JournalPlace::Unknown)
  {
    warning = "There is an unfinished recording " + Printable(journal) +
      ", and its file system has no locks, which would tell whether a program still writes to it. "
      "It stays as it is, and this recording is kept in " +
      Printable(this->Name) + " until it ends.";
  }
  return true;
}

bool JournalWriter::Create(
  const std::string& file, const RecordingAbout& about, std::string& error, std::string& warning)
{
  this->Close();
  this->Failure = 0;
  error.clear();
  bool isGood = this->OpenNew(file, error, warning);
  if (isGood)
  {
    std::string payload(JournalMark, sizeof(JournalMark));
    for (const std::string& text :
      { SignatureOfColumns(), about.DeviceId, about.Settings, about.VolumeHash })
    {
      PutText(payload, text);
    }
    isGood = this->WriteChunk(AboutChunk, payload) == 0;
    if (!isGood)
    {
      error = ExplainWriteError(this->Failure, this->Name);
      this->Remove();
    }
  }
  if (!isGood)
  {
    this->Close();
  }
  return isGood;
}

void JournalWriter::Remove()
{
  if (this->Descriptor >= 0 && Files::IsSame(this->Descriptor, this->Name))
  {
    Files::Remove(this->Name);
  }
}

void JournalWriter::Close()
{
  if (this->Descriptor >= 0)
  {
    // Unlock explicitly, because a forked child may share the descriptor and thus the lock.
    Files::Unlock(this->Descriptor);
    Files::Close(this->Descriptor);
    this->Descriptor = -1;
  }
}

int JournalWriter::WriteChunk(std::uint32_t kind, const std::string& payload)
{
  if (this->Failure == 0)
  {
    std::string chunk;
    chunk.reserve(HeadSize + payload.size());
    Put(chunk, kind);
    Put(chunk, std::uint32_t{ 0 });
    Put(chunk, static_cast<std::uint64_t>(payload.size()));
    Put(chunk, SumOf(payload));
    chunk += payload;
    this->Failure = WriteAll(this->Descriptor, chunk.data(), chunk.size());
  }
  return this->Failure;
}

int JournalWriter::WriteHashes(const RecordingHashes& hashes)
{
  std::string payload;
  PutText(payload, hashes.Volume);
  PutText(payload, hashes.Labels);
  return this->WriteChunk(HashesChunk, payload);
}

int JournalWriter::WriteBegin(const RecordingBegin& begin)
{
  std::string payload;
  Put(payload, begin);
  return this->WriteChunk(BeginChunk, payload);
}

template <typename Row>
int JournalWriter::WriteRows(std::uint32_t kind, const std::vector<Row>& rows)
{
  constexpr std::size_t most = 8000000 / sizeof(Row); // rows in a chunk of 8 MB
  for (std::size_t first = 0; first < rows.size(); first += most)
  {
    std::string payload;
    for (std::size_t i = first; i < std::min(first + most, rows.size()); ++i)
    {
      Put(payload, rows[i]);
    }
    this->WriteChunk(kind, payload);
  }
  return this->Failure;
}

int JournalWriter::WriteContacts(const std::vector<ContactRow>& contacts)
{
  return this->WriteRows(ContactsChunk, contacts);
}

int JournalWriter::WriteTissue(const std::vector<BrickTissue>& shares)
{
  return this->WriteRows(TissueChunk, shares);
}

int JournalWriter::WritePlacements(const std::vector<PlacementRow>& placements)
{
  std::string payload;
  for (const PlacementRow& placement : placements)
  {
    Put(payload, placement);
  }
  return payload.empty() ? this->Failure : this->WriteChunk(PlacementsChunk, payload);
}

int JournalWriter::WriteTicks(const RecordingRow* rows, std::size_t count, std::uint64_t lost)
{
  const std::vector<TraceColumn>& columns = GetRecordingColumns();
  std::string blocks;
  std::string payload;
  Put(payload, lost);
  Put(payload, static_cast<std::uint32_t>(count));
  std::vector<unsigned char> tuples;
  for (const TraceColumn& column : columns)
  {
    const std::size_t width = column.GetWidth();
    tuples.resize(count * width);
    for (std::size_t i = 0; i < count; ++i)
    {
      std::memcpy(tuples.data() + i * width,
        reinterpret_cast<const unsigned char*>(rows + i) + column.Offset, width);
    }
    Put(payload,
      static_cast<std::uint32_t>(this->Compressor.Compress(tuples.data(), tuples.size(), blocks)));
  }
  return this->WriteChunk(TicksChunk, payload + blocks);
}

} // namespace VolumeHaptics
