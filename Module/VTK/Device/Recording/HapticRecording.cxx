// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Device/Recording/HapticRecording.h"

#include "Core/Platform/HapticFiles.h"
#include "Core/Servo/ServoLoop.h"
#include "Core/State/ServoStateNumbers.h"
#include "Core/Tools/PointShell/BakedShell.h"
#include "VTK/Device/Recording/HapticRecordingFile.h"
#include "VTK/Device/Recording/JournalReader.h"
#include "VTK/Trace/HapticTraceFiles.h"

#include <algorithm>
#include <cmath>
#include <new>
#include <system_error>

namespace VolumeHaptics
{
namespace
{

/**
 * Interval (ns) at which the writer polls for ticks. It is shorter than the 25 ms that a group
 * takes at 10 kHz.
 */
constexpr std::int64_t WriterPeriod = 10000000;

PlacementRow ToRow(const HapticModel& model)
{
  const Affine3& map = model.DeviceToWorld;
  const double offset[3] = { map.Offset.X, map.Offset.Y, map.Offset.Z };
  PlacementRow placement{ { 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1 },
    { model.Caps.Stiffness, model.Caps.Damping } };
  std::array<double, 16>& m = placement.Matrix;
  for (std::size_t row = 0; row < 3; ++row)
  {
    m[4 * row] = map.Linear.Row[row].X;
    m[4 * row + 1] = map.Linear.Row[row].Y;
    m[4 * row + 2] = map.Linear.Row[row].Z;
    m[4 * row + 3] = offset[row];
  }
  return placement;
}

} // namespace

HapticRecording::HapticRecording()
  : Writer(new JournalWriter)
{
}

HapticRecording::~HapticRecording()
{
  if (!this->IsOurs())
  {
    // In a forked child, the journal, its lock and the thread belong to the parent.
    (void)this->Writer.release();
    (void)this->WriterThread.release();
    return;
  }
  this->StopWriter(); // stop the writer first, because it uses the journal that is closed here
}

bool HapticRecording::Start(
  const std::string& file, const RecordingAbout& about, std::string& error, std::string& warning)
{
  this->File = MakeAbsolute(file);
  bool isGood = false;
  try
  {
    isGood = CheckWritable(this->File, error) &&
      (GetTraceEnding(file) != ".csv" || CheckWritable(this->File + ".json", error)) &&
      this->Writer->Create(this->File, about, error, warning);
    if (isGood)
    {
      this->WriterThread = std::make_unique<std::thread>([this] { this->WriteUntilStopped(); });
    }
  }
  catch (const std::system_error& problem)
  {
    error = "no thread could be started to write it (" + Printable(problem.code().message()) +
      "). End other programs, or raise the limits of threads and memory.";
    this->Writer->Remove();
    isGood = false;
  }
  catch (const std::bad_alloc&)
  {
    this->Writer->Remove();
    throw;
  }
  if (!isGood)
  {
    error = "The recording " + Printable(file) + " can't be written: " + error;
  }
  return isGood;
}

void HapticRecording::AddModel(std::uint64_t generation, std::shared_ptr<const HapticModel> model,
  std::shared_ptr<const ToolMemory> tool)
{
  // Ticks arrive in the order of their generations, so earlier models are no longer needed.
  this->Models.erase(this->Models.begin(), this->Models.lower_bound(this->LastGeneration));
  if (this->Failure.load() != 0)
  {
    this->Models.clear(); // no more ticks will be recorded, so no model is needed
    return;
  }
  this->Models[generation] = { std::move(model), std::move(tool) };
}

bool HapticRecording::Append(const ServoSnapshot& snapshot)
{
  this->LastGeneration = snapshot.Generation;
  const auto found = this->Models.find(snapshot.Generation);
  if (found == this->Models.end() || !found->second.Model || this->Failure.load() != 0)
  {
    return true;
  }
  const HapticModel& model = *found->second.Model;
  const ToolMemory* const tool = found->second.Tool.get();
  TissueRemoval* const removal = model.Baked->Removal.get();
  if (this->IsAwaited() && (tool || removal) && !snapshot.IsKept)
  {
    return true;
  }
  const std::lock_guard<std::mutex> lock(this->QueueMutex);
  if (this->Waiting.size() >= MostWaiting)
  {
    ++this->Dropped;
    return false;
  }
  const bool isFirst = this->LastPlacement < 0;
  if (isFirst)
  {
    this->Begin.reset(
      new RecordingBegin{ ToNumbers(snapshot.Before), model.Baked->Settings.TickPeriod,
        removal ? model.Baked->Field.GetCarved().Air : std::nan("") });
    const ShellContacts* const contacts = FindKeptContacts(tool);
    if (contacts && snapshot.Before.Shell.Enabled)
    {
      this->BeginContacts = ToRows(*contacts);
    }
    if (removal)
    {
      this->BeginTissue = removal->EndSnapshot();
    }
  }
  // Write a placement for every generation, even if it is unchanged, because the servo transfers
  // its state from each generation to the next.
  if (isFirst || snapshot.Generation != this->PlacedGeneration)
  {
    this->NewPlacements.push_back(ToRow(model));
    this->PlacedGeneration = snapshot.Generation;
    ++this->LastPlacement;
  }
  this->Waiting.push_back(MakeRecordingRow(model, snapshot, this->LastPlacement, this->Work));
  return true;
}

void HapticRecording::SetHashes(const RecordingHashes& hashes)
{
  const std::lock_guard<std::mutex> lock(this->QueueMutex);
  this->Hashes.reset(new RecordingHashes(hashes));
}

void HapticRecording::WriteHashes()
{
  std::unique_ptr<RecordingHashes> hashes;
  {
    const std::lock_guard<std::mutex> lock(this->QueueMutex);
    hashes.swap(this->Hashes);
  }
  if (hashes && this->Failure.load() == 0)
  {
    this->Failure.store(this->Writer->WriteHashes(*hashes));
  }
}

void HapticRecording::WriteUntilStopped()
{
  ServoClock::BlockSignals();
  while (!this->StopRequested.load() && this->Failure.load() == 0)
  {
    const std::int64_t now = ServoClock::Now();
    this->WriteHashes();
    while (this->WriteGroup(false))
    {
    }
    ServoClock::SleepUntil(now + WriterPeriod);
  }
  this->WriteHashes();
  while (this->WriteGroup(true))
  {
  }
  if (this->Failure.load() == 0 && this->GetLostTicks() > 0)
  {
    // Write the number of lost ticks again, because ticks may have been lost after the last tick of
    // the queue.
    this->Failure.store(this->Writer->WriteTicks(nullptr, 0, this->GetLostTicks()));
  }
}

bool HapticRecording::WriteGroup(bool isEnd)
{
  std::vector<RecordingRow> rows;
  std::vector<PlacementRow> placements;
  std::unique_ptr<RecordingBegin> begin;
  std::vector<ContactRow> contacts;
  std::vector<BrickTissue> shares;
  {
    const std::lock_guard<std::mutex> lock(this->QueueMutex);
    const std::size_t least = isEnd ? 1 : GroupSize;
    if (this->Waiting.size() < least || this->Failure.load() != 0)
    {
      return false;
    }
    const auto count = static_cast<std::ptrdiff_t>(std::min(GroupSize, this->Waiting.size()));
    rows.assign(this->Waiting.begin(), this->Waiting.begin() + count);
    this->Waiting.erase(this->Waiting.begin(), this->Waiting.begin() + count);
    placements.swap(this->NewPlacements);
    begin.swap(this->Begin);
    contacts.swap(this->BeginContacts);
    shares.swap(this->BeginTissue);
  }
  int failure = begin ? this->Writer->WriteBegin(*begin) : 0;
  failure = failure ? failure : this->Writer->WriteContacts(contacts);
  failure = failure ? failure : this->Writer->WriteTissue(shares);
  failure = failure ? failure : this->Writer->WritePlacements(placements);
  failure =
    failure ? failure : this->Writer->WriteTicks(rows.data(), rows.size(), this->GetLostTicks());
  if (failure == 0)
  {
    this->Written += rows.size();
  }
  this->Failure.store(failure);
  return failure == 0;
}

void HapticRecording::StopWriter()
{
  if (this->WriterThread)
  {
    this->StopRequested.store(true);
    this->WriterThread->join();
    this->WriterThread.reset();
  }
}

std::string HapticRecording::GetTrouble() const
{
  const int failure = this->Failure.load();
  return failure == 0 ? std::string()
                      : "The recording " + Printable(this->File) + " ends after " +
      std::to_string(this->Written.load()) +
      " ticks: " + ExplainWriteError(failure, this->Writer->GetName());
}

bool HapticRecording::Finish(std::string& error)
{
  error.clear();
  if (!this->IsOurs())
  {
    error = "The recording " + Printable(this->File) +
      " is of the process that this one was forked from: stop it there.";
    return false;
  }
  this->StopWriter();
  // Read through the writer's descriptor, because another file may have the journal's name now.
  JournalReader reader;
  if (!reader.Open(*this->Writer, error))
  {
    error = "The unfinished recording " + Printable(this->Writer->GetName()) + " " + error + ".";
    return false;
  }
  reader.Expect(this->Written.load());
  WriteRecording(reader, this->Writer->GetName(), this->File, this->GetTrouble(), error);
  this->Writer->Close(); // also releases the lock, which a recovery needs
  return error.empty();
}

} // namespace VolumeHaptics
