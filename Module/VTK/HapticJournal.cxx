// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "HapticJournalChunks.h"

#include "HapticFiles.h"

#include "vtkNew.h"
#include "vtkZLibDataCompressor.h"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace VolumeHaptics
{

std::uint64_t SumOf(const std::string& payload)
{
  // FNV-1a.
  std::uint64_t sum = 0xCBF29CE484222325ULL;
  for (const char c : payload)
  {
    sum = (sum ^ static_cast<unsigned char>(c)) * 0x100000001B3ULL;
  }
  return sum;
}

std::string SignatureOfColumns()
{
  std::string signature;
  for (const TraceColumn& column : GetRecordingColumns())
  {
    signature += std::string(column.Name) + ":" + std::to_string(static_cast<int>(column.Type)) +
      ":" + std::to_string(column.Components) + " ";
  }
  return signature;
}

//------------------------------------------------------------------------------
struct BlockCompressor::Library
{
  vtkNew<vtkZLibDataCompressor> ZLib;
};

BlockCompressor::BlockCompressor()
  : Used(new Library)
{
  // What a tick finds has few patterns: higher levels take longer and save 0.4 percent.
  this->Used->ZLib->SetCompressionLevel(1);
}

BlockCompressor::~BlockCompressor()
{
  delete this->Used;
}

std::size_t BlockCompressor::Compress(const void* data, std::size_t size, std::string& to)
{
  const std::size_t begin = to.size();
  const std::size_t most = this->Used->ZLib->GetMaximumCompressionSpace(size);
  to.resize(begin + most);
  const std::size_t used = this->Used->ZLib->Compress(static_cast<const unsigned char*>(data), size,
    reinterpret_cast<unsigned char*>(&to[begin]), most);
  to.resize(begin + used);
  return used;
}

bool BlockCompressor::Expand(const std::string& block, void* data, std::size_t size)
{
  return this->Used->ZLib->Uncompress(reinterpret_cast<const unsigned char*>(block.data()),
           block.size(), static_cast<unsigned char*>(data), size) == size;
}

//------------------------------------------------------------------------------
namespace
{

/** Gives a journal that an earlier recording left a name that is free. */
bool PutAside(const std::string& journal, std::string& error, std::string& renamed)
{
  const int descriptor = open(journal.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  if (descriptor < 0)
  {
    return errno == ENOENT; // else the error of creating it tells more
  }
  const bool isFree = flock(descriptor, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK;
  close(descriptor);
  if (!isFree)
  {
    error = "it is being recorded already. Give another name.";
    return false;
  }
  for (int i = 1;; ++i)
  {
    const std::string free = journal + "." + std::to_string(i);
    if (access(free.c_str(), F_OK) != 0 && rename(journal.c_str(), free.c_str()) == 0)
    {
      renamed = free;
      return true;
    }
    constexpr int most = 1000;
    if (i == most)
    {
      error = "there are too many unfinished recordings of that name beside it. Remove some, or "
              "give another name.";
      return false;
    }
  }
}

} // namespace

bool JournalWriter::Create(
  const std::string& journal, const RecordingAbout& about, std::string& error, std::string& renamed)
{
  this->Close();
  error.clear();
  if (!PutAside(journal, error, renamed) && !error.empty())
  {
    return false;
  }
  constexpr mode_t everybody = 0666; // less what the user's mask takes
  this->Descriptor = open(journal.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, everybody);
  this->Failure = this->Descriptor < 0 ? errno : 0;
  if (this->Failure == 0)
  {
    // Some file systems have no locks; the journal does without.
    (void)flock(this->Descriptor, LOCK_EX | LOCK_NB);
    std::string payload(JournalMark, sizeof(JournalMark));
    for (const std::string& text :
      { SignatureOfColumns(), about.DeviceId, about.Settings, about.VolumeHash })
    {
      Put(payload, static_cast<std::uint64_t>(text.size()));
      payload += text;
    }
    this->Failure = this->WriteChunk(AboutChunk, payload);
    if (this->Failure != 0)
    {
      unlink(journal.c_str());
    }
  }
  if (this->Failure != 0)
  {
    error = ExplainWriteError(this->Failure, journal);
    this->Close();
    return false;
  }
  return true;
}

void JournalWriter::Close()
{
  if (this->Descriptor >= 0)
  {
    // A forked child has the descriptor, too, and with it the lock.
    (void)flock(this->Descriptor, LOCK_UN);
    close(this->Descriptor);
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

int JournalWriter::WriteBegin(const RecordingBegin& begin)
{
  std::string payload;
  Put(payload, begin);
  return this->WriteChunk(BeginChunk, payload);
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
