// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Device/Recording/JournalReader.h"

#include "Core/Platform/Files.h"
#include "Core/Platform/HapticFiles.h"
#include "VTK/Device/Recording/HapticJournal.h"
#include "VTK/Device/Recording/JournalWriter.h"
#include "VTK/Trace/HapticTraceColumns.h"
#include "VTK/Trace/RecordingNames.h"

#include <algorithm>
#include <cerrno>

namespace VolumeHaptics
{
namespace
{

/**
 * Largest accepted payload (bytes). The largest payloads are a group of random numbers and the
 * placements of a group.
 */
constexpr std::uint64_t MostPayload = 1 << 24;

bool IsKind(std::uint32_t kind)
{
  return kind == AboutChunk || kind == HashesChunk || kind == BeginChunk || kind == ContactsChunk ||
    kind == TissueChunk || kind == PlacementsChunk || kind == TicksChunk;
}

/**
 * Returns whether a whole chunk starts anywhere after the first byte. Also returns true if so many
 * bytes look like heads that checking all their checksums would take too long; compressed numbers
 * do not look like that.
 */
bool HoldsChunk(const std::string& bytes)
{
  constexpr std::uint64_t mostOften = 8; // average number of checksums that include the same byte
  std::uint64_t summed = 0;
  for (std::size_t begin = 1; begin + HeadSize <= bytes.size(); ++begin)
  {
    std::size_t at = begin;
    std::uint32_t kind = 0;
    std::uint32_t zero = 0;
    std::uint64_t size = 0;
    std::uint64_t sum = 0;
    if (Get(bytes, at, kind) && IsKind(kind) && Get(bytes, at, zero) && Get(bytes, at, size) &&
      Get(bytes, at, sum) && zero == 0 && size <= bytes.size() - at)
    {
      summed += size;
      if (summed > mostOften * bytes.size() || SumOf(bytes.substr(at, size)) == sum)
      {
        return true;
      }
    }
  }
  return false;
}

} // namespace

JournalReader::~JournalReader()
{
  if (this->Descriptor >= 0)
  {
    Files::Close(this->Descriptor);
  }
}

bool JournalReader::ReadAt(std::uint64_t position, void* data, std::size_t size)
{
  char* to = static_cast<char*>(data);
  while (size > 0)
  {
    const std::int64_t got =
      Files::ReadAt(this->Descriptor, to, size, static_cast<std::int64_t>(position));
    if (got == 0 || (got < 0 && errno != EINTR))
    {
      this->Failure = got == 0 ? 0 : errno;
      return false;
    }
    if (got > 0)
    {
      to += got;
      position += static_cast<std::uint64_t>(got);
      size -= static_cast<std::size_t>(got);
    }
  }
  return true;
}

bool JournalReader::ReadHead(std::uint64_t position, Chunk& chunk)
{
  std::string head(HeadSize, '\0');
  if (!this->ReadAt(position, &head[0], HeadSize))
  {
    return false;
  }
  std::size_t at = 0;
  std::uint32_t zero = 0;
  chunk.Payload = position + HeadSize;
  return Get(head, at, chunk.Kind) && Get(head, at, zero) && Get(head, at, chunk.Size) &&
    Get(head, at, chunk.Sum) && zero == 0 && chunk.Size <= MostPayload;
}

bool JournalReader::Open(const std::string& journal, std::string& error)
{
  if (!CheckRegular(journal, error))
  {
    return false;
  }
  this->Descriptor = Files::Open(journal, Files::For::Reading);
  if (this->Descriptor < 0)
  {
    error = "can't be read (" + DescribeError(errno) + "): check that it may be read by you";
    return false;
  }
  this->IsLocked = Files::LockShared(this->Descriptor);
  if (!this->IsLocked && errno == EWOULDBLOCK)
  {
    error = "is of a recording that is still under way: stop that one first";
    return false;
  }
  return this->Scan(error);
}

bool JournalReader::Open(const JournalWriter& writer, std::string& error)
{
  this->Descriptor = Files::Duplicate(writer.Descriptor);
  if (this->Descriptor < 0)
  {
    error = "can't be read (" + DescribeError(errno) + ")";
    return false;
  }
  // This process's writer holds the lock, so the reader needs none, even on a file system without
  // locks.
  this->IsLocked = true;
  return this->Scan(error);
}

bool JournalReader::IsAt(const std::string& file) const
{
  return this->Descriptor >= 0 && Files::IsSame(this->Descriptor, file);
}

void JournalReader::Remove(const std::string& journal) const
{
  if (this->IsLocked && this->IsAt(journal))
  {
    Files::Remove(journal);
  }
}

bool JournalReader::Scan(std::string& error)
{
  std::string payload;
  Chunk chunk;
  error.clear();
  this->Failure = 0;
  while (this->ReadHead(this->End, chunk))
  {
    payload.resize(chunk.Size);
    if (!this->ReadAt(chunk.Payload, &payload[0], payload.size()) || SumOf(payload) != chunk.Sum ||
      !this->ApplyChunk(chunk, payload, error))
    {
      break;
    }
    this->End = chunk.Payload + chunk.Size;
  }
  if (!this->HasAbout && error.empty())
  {
    error = this->Failure ? "can't be read (" + DescribeError(this->Failure) + ")"
                          : "is not the unfinished recording of a vtkHapticDevice";
  }
  if (error.empty())
  {
    this->DetectDamage();
  }
  return error.empty();
}

void JournalReader::DetectDamage()
{
  int failure = this->Failure;
  Files::Status status;
  failure = failure == 0 && !Files::GetStatus(this->Descriptor, status) ? errno : failure;
  const auto size = failure ? this->End : static_cast<std::uint64_t>(status.st_size);
  if (failure == 0 && this->IsCutOff(size))
  {
    return;
  }
  failure = failure ? failure : this->Failure;
  this->Damage = "can't be read beyond byte " + std::to_string(this->End) +
    (failure ? " (" + DescribeError(failure) + ")"
             : " of " + std::to_string(size) + ", as bytes there have changed") +
    ": the " + std::to_string(this->Ticks) + " ticks before are all that can be";
}

void JournalReader::Expect(std::uint64_t ticks)
{
  if (ticks != this->Ticks && this->Damage.empty())
  {
    this->Damage = "was cut off by another program: it holds " + std::to_string(this->Ticks) +
      " of " + std::to_string(ticks) + " ticks";
  }
}

bool JournalReader::IsCutOff(std::uint64_t size)
{
  // A file that was growing during a power cut may end with zeros.
  constexpr std::uint64_t most = HeadSize + MostPayload;
  std::string tail(std::min(size - std::min(size, this->End), most), '\0');
  if (!this->ReadAt(this->End, &tail[0], tail.size()))
  {
    return false;
  }
  std::string block;
  for (std::uint64_t position = this->End + tail.size(); position < size; position += block.size())
  {
    block.resize(std::min(size - position, most));
    if (!this->ReadAt(position, &block[0], block.size()) ||
      block.find_first_not_of('\0') != std::string::npos)
    {
      return false;
    }
  }
  tail.resize(tail.find_last_not_of('\0') + 1);
  if (tail.size() < HeadSize)
  {
    return true;
  }
  Chunk chunk;
  return this->ReadHead(this->End, chunk) && IsKind(chunk.Kind) &&
    tail.size() < HeadSize + chunk.Size && !HoldsChunk(tail);
}

/**
 * Stores the contents of a chunk. Returns false if the chunk is out of order; the bytes after it
 * are then ignored.
 */
bool JournalReader::ApplyChunk(const Chunk& chunk, const std::string& payload, std::string& error)
{
  std::size_t at = 0;
  if (!this->HasAbout || chunk.Kind == AboutChunk)
  {
    return !this->HasAbout && chunk.Kind == AboutChunk && this->ReadAbout(payload, error);
  }
  if (chunk.Kind == HashesChunk)
  {
    return this->ReadHashes(payload);
  }
  if (chunk.Kind == BeginChunk)
  {
    const bool isWhole = !this->HasBegin && payload.size() == sizeof(this->Begin);
    this->HasBegin = this->HasBegin || isWhole;
    return isWhole && Get(payload, at, this->Begin);
  }
  if (chunk.Kind == ContactsChunk)
  {
    this->Contacts += payload.size() / sizeof(ContactRow);
    return this->HasBegin && payload.size() % sizeof(ContactRow) == 0;
  }
  if (chunk.Kind == TissueChunk)
  {
    this->Bricks += payload.size() / sizeof(BrickTissue);
    return this->HasBegin && payload.size() % sizeof(BrickTissue) == 0;
  }
  if (chunk.Kind == PlacementsChunk)
  {
    this->Placements += payload.size() / sizeof(PlacementRow);
    return payload.size() % sizeof(PlacementRow) == 0;
  }
  std::uint64_t lost = 0;
  std::uint32_t ticks = 0;
  if (chunk.Kind != TicksChunk || !Get(payload, at, lost) || !Get(payload, at, ticks) ||
    ticks > GroupSize || (ticks > 0 && (this->HasLastGroup || !this->HasBegin)))
  {
    return false;
  }
  std::uint64_t blocks = 0;
  for (std::size_t i = 0; i < GetRecordingColumns().size(); ++i)
  {
    std::uint32_t size = 0;
    if (!Get(payload, at, size))
    {
      return false;
    }
    blocks += size;
  }
  if (at + blocks != payload.size())
  {
    return false;
  }
  this->Ticks += ticks;
  this->Lost = lost;
  // after a group that is not full, only the number of lost ticks may follow
  this->HasLastGroup = ticks < GroupSize;
  return true;
}

bool JournalReader::ReadAbout(const std::string& payload, std::string& error)
{
  if (payload.size() < sizeof(JournalMark) ||
    std::memcmp(payload.data(), JournalMark, sizeof(JournalMark) - 1) != 0)
  {
    return false;
  }
  std::size_t at = sizeof(JournalMark);
  std::string signature;
  for (std::string* const text :
    { &signature, &this->About.DeviceId, &this->About.Settings, &this->About.VolumeHash })
  {
    if (!GetText(payload, at, *text))
    {
      return false;
    }
  }
  if (payload[sizeof(JournalMark) - 1] != JournalMark[sizeof(JournalMark) - 1] ||
    signature != SignatureOfColumns())
  {
    error = "is of another version of VTK Volume Haptics: recover it with that version";
    return false;
  }
  this->HasAbout = true;
  return true;
}

bool JournalReader::ReadHashes(const std::string& payload)
{
  std::size_t at = 0;
  RecordingHashes hashes;
  if (!GetText(payload, at, hashes.Volume) || !GetText(payload, at, hashes.Labels) ||
    at != payload.size())
  {
    return false;
  }
  this->About.VolumeHash = hashes.Volume;
  if (!hashes.Labels.empty())
  {
    std::string& settings = this->About.Settings;
    settings += settings.empty() || settings.back() == '\n' ? "" : "\n";
    settings += RecordingNames::LabelHash + hashes.Labels + "\n";
  }
  return true;
}

bool JournalReader::ForEachChunk(std::uint32_t kind, const std::function<bool(const Chunk&)>& visit)
{
  Chunk chunk;
  for (std::uint64_t position = 0; position < this->End; position = chunk.Payload + chunk.Size)
  {
    if (!this->ReadHead(position, chunk) || (chunk.Kind == kind && !visit(chunk)))
    {
      return false;
    }
  }
  return true;
}

bool JournalReader::ReadCaps(std::vector<double>& caps)
{
  caps.clear();
  bool areSame = true;
  const bool isRead = this->ForEachPlacement(
    [&](const PlacementRow& row)
    {
      caps.insert(caps.end(), row.Caps.begin(), row.Caps.end());
      areSame = areSame && std::equal(row.Caps.begin(), row.Caps.end(), caps.begin());
    });
  caps.resize(areSame ? std::min(caps.size(), std::tuple_size<decltype(PlacementRow::Caps)>::value)
                      : caps.size());
  return isRead;
}

template <typename Row>
bool JournalReader::ReadRows(std::uint32_t kind, std::vector<Row>& rows)
{
  rows.clear();
  return this->ForEachChunk(kind,
    [&](const Chunk& chunk)
    {
      const std::size_t before = rows.size();
      rows.resize(before + chunk.Size / sizeof(Row));
      return this->ReadAt(chunk.Payload, rows.data() + before, chunk.Size);
    });
}

bool JournalReader::ReadContacts(std::vector<ContactRow>& contacts)
{
  return this->ReadRows(ContactsChunk, contacts);
}

bool JournalReader::ReadTissue(std::vector<BrickTissue>& shares)
{
  return this->ReadRows(TissueChunk, shares);
}

bool JournalReader::ForEachPlacement(const std::function<void(const PlacementRow&)>& visit)
{
  return this->ForEachChunk(PlacementsChunk,
    [&](const Chunk& chunk)
    {
      std::vector<PlacementRow> rows(chunk.Size / sizeof(PlacementRow));
      if (!this->ReadAt(chunk.Payload, rows.data(), chunk.Size))
      {
        return false;
      }
      for (const PlacementRow& row : rows)
      {
        visit(row);
      }
      return true;
    });
}

bool JournalReader::ForEachBlock(
  std::size_t column, const std::function<void(const std::string&)>& visit)
{
  std::vector<std::uint32_t> sizes(GetRecordingColumns().size());
  std::string block;
  return this->ForEachChunk(TicksChunk,
    [&](const Chunk& chunk)
    {
      const std::size_t sizesSize = sizes.size() * sizeof(sizes[0]);
      std::uint32_t ticks = 0;
      if (!this->ReadAt(chunk.Payload + TicksHeadSize - sizeof(ticks), &ticks, sizeof(ticks)) ||
        !this->ReadAt(chunk.Payload + TicksHeadSize, sizes.data(), sizesSize))
      {
        return false;
      }
      std::uint64_t position = chunk.Payload + TicksHeadSize + sizesSize;
      for (std::size_t i = 0; i < column; ++i)
      {
        position += sizes[i];
      }
      block.resize(sizes[column]);
      if (ticks > 0 && !this->ReadAt(position, &block[0], block.size()))
      {
        return false;
      }
      ticks > 0 ? visit(block) : void();
      return true;
    });
}

bool JournalReader::ForEachRow(const std::function<void(const RecordingRow&)>& visit)
{
  const std::vector<TraceColumn>& columns = GetRecordingColumns();
  BlockCompressor compressor;
  std::vector<RecordingRow> rows;
  std::vector<unsigned char> tuples;
  return this->ForEachChunk(TicksChunk,
    [&](const Chunk& chunk)
    {
      std::string payload(chunk.Size, '\0');
      if (!this->ReadAt(chunk.Payload, &payload[0], payload.size()))
      {
        return false;
      }
      std::size_t at = TicksHeadSize - sizeof(std::uint32_t);
      std::uint32_t ticks = 0;
      Get(payload, at, ticks);
      rows.assign(ticks, RecordingRow{});
      std::size_t begin = TicksHeadSize + columns.size() * sizeof(std::uint32_t);
      for (const TraceColumn& column : columns)
      {
        std::uint32_t size = 0;
        Get(payload, at, size);
        const std::size_t width = column.GetWidth();
        tuples.resize(ticks * width);
        if (ticks > 0 &&
          !compressor.Expand(payload.substr(begin, size), tuples.data(), tuples.size()))
        {
          return false;
        }
        for (std::size_t i = 0; i < ticks; ++i)
        {
          std::memcpy(reinterpret_cast<unsigned char*>(rows.data() + i) + column.Offset,
            tuples.data() + i * width, width);
        }
        begin += size;
      }
      for (const RecordingRow& row : rows)
      {
        visit(row);
      }
      return true;
    });
}

} // namespace VolumeHaptics
