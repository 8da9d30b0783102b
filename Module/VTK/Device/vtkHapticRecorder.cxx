// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHapticRecorder.h"

#include "Core/Platform/Files.h"
#include "Core/Platform/HapticFiles.h"
#include "Core/Realtime/BackgroundWork.h"
#include "VTK/Base/HapticHash.h"
#include "VTK/Base/TouchedArray.h"
#include "VTK/Device/DeviceParts.h"
#include "VTK/Device/HapticLongWork.h"
#include "VTK/Device/Recording/HapticJournal.h"
#include "VTK/Device/Recording/HapticRecordingFile.h"
#include "VTK/Filter/HapticBaker.h"
#include "VTK/Trace/RecordingNames.h"

#include "vtkHapticDevice.h"
#include "vtkHapticLabelTable.h"
#include "vtkObjectFactory.h"
#include "vtkSmartPointer.h"
#include "vtkVolumeHapticsFilter.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <locale>
#include <memory>
#include <new>
#include <optional>
#include <sstream>
#include <string>
#include <utility>

vtkStandardNewMacro(vtkHapticRecorder);

using namespace VolumeHaptics;

namespace
{
/** Measured times (s) to write one tick to a .vtp and to a .csv. */
constexpr double SecondsPerTick = 2e-6;
constexpr double SecondsPerLine = 2e-5;

/**
 * Smallest expected size (bytes) of a tick in a journal while the tip moves; 80 to 180 were
 * measured.
 */
constexpr double BytesPerTick = 80;

/**
 * ShortHashing: the start of a recording waits for the hashes if they are expected to take at most
 * this time (s), so that the journal of a small volume has them from its beginning. ShortHashWait:
 * longest duration of this wait (s).
 */
constexpr double ShortHashing = 5e-3;
constexpr double ShortHashWait = 20e-3;
/** Longest time (s) that the end of a recording without force waits for the hashes. */
constexpr double LongestHashWait = 10.0;

constexpr const char* HashingWork = "the recorded volume is hashed";

using TouchedArrays = std::array<TouchedArray, 2>;

double EstimateHashing(const TouchedArrays& touched)
{
  double time = 0.0;
  for (const TouchedArray& one : touched)
  {
    time += one.Array ? EstimateHashTime(one.Array) : 0.0;
  }
  return time;
}

/** Hashes all arrays on the worker thread. Returns nothing if the work is cancelled. */
std::optional<RecordingHashes> HashAll(const TouchedArrays& touched, WorkMonitor& monitor)
{
  const double all = EstimateHashing(touched);
  double before = 0.0;
  std::array<std::string, 2> hashes;
  for (std::size_t i = 0; i < touched.size(); ++i)
  {
    vtkDataArray* const array = touched[i].Array;
    if (!array)
    {
      continue;
    }
    const double share = EstimateHashTime(array) / std::max(all, 1e-12);
    hashes[i] = HashArray(array, touched[i].Dimensions.data(),
      [&](double done) { return monitor.GoesOn(before + share * done); });
    if (hashes[i].empty())
    {
      return std::nullopt;
    }
    before += share;
  }
  return RecordingHashes{ hashes[0], hashes[1] };
}

double EstimateWriting(const std::string& file, double ticks)
{
  return ticks * (GetTraceEnding(file) == ".csv" ? SecondsPerLine : SecondsPerTick);
}

/** Writes the table of labels, which a replay needs, as text. */
void DescribeLabels(vtkVolumeHapticsFilter* filter, std::ostream& os)
{
  vtkHapticLabelTable* const table = filter->GetLabelTable();
  constexpr vtkIdType most = 1000; // largest number of labels that are listed individually
  if (table && table->GetNumberOfLabels() <= most)
  {
    os << "LabelTable:\n";
    table->PrintSelf(os, vtkIndent(2));
  }
  else if (table)
  {
    os << "LabelTable: of " << table->GetNumberOfLabels() << " labels\n";
  }
}

} // namespace

/**
 * Starts, ends and recovers recordings. Reports errors and warnings through the device, which also
 * announces long work.
 */
class vtkHapticRecorder::vtkInternals
{
public:
  vtkInternals(vtkHapticDevice* device, DeviceSession& session)
    : Device(device)
    , Session(session)
  {
  }

  vtkHapticDevice* GetDevice() const { return this->Device; }

  ///@{
  /** See the public functions of vtkHapticRecorder. */
  bool Start(const std::string& file, vtkVolumeHapticsFilter* filter);
  bool Recover(const std::string& part, const std::string& file);
  ///@}

  /**
   * Ends the recording: see vtkHapticRecorder::Stop. Announces the writing as long work only if
   * `isAnnounced`.
   */
  bool Stop(bool isAnnounced);

  /** Returns whether a recording of this process is in progress. */
  bool IsUnderWay() const;

  /** Returns the file of the recording in progress; empty without one. */
  const std::string& GetFile() const { return this->File; }

  /**
   * Adds the volume's hashes to the recording once they are computed; call this often while
   * recording. Reports an error, once per recording, if the recording fails, for example on a full
   * disk.
   */
  void Update();

private:
  using HashKey = std::array<TouchedArray::Key, 2>; ///< keys of scalars and labels

  bool Begin(const std::string& file, vtkVolumeHapticsFilter* filter);
  /** Returns the hashes of the data that a filter touches now; null until they are computed. */
  const RecordingHashes* GetHashes(vtkVolumeHapticsFilter* filter);
  /**
   * Adds the hashes at the end of a recording. Waits for them only while the device is not
   * armed; otherwise, the hand would have to wait, too.
   */
  void AwaitHashes(HapticRecording& recording);
  void ReportTrouble();
  TickCollector* GetRecordable(const std::string& file) const;

  vtkHapticDevice* const Device;
  DeviceSession& Session;
  std::string File;
  vtkSmartPointer<vtkVolumeHapticsFilter> Felt; ///< felt filter, until its hashes are added to the
                                                ///< recording
  KeyedWork<HashKey, RecordingHashes> Hashing;
  bool IsTroubleTold = false;
};

/**
 * Returns the collector of ticks if a recording into this file can start. Otherwise reports an
 * error and returns null.
 */
TickCollector* vtkHapticRecorder::vtkInternals::GetRecordable(const std::string& name) const
{
  TickCollector* const ticks = this->Session.GetTicks();
  const char* error = nullptr;
  if (!ticks)
  {
    error = "There is nothing to record: Start() the servo first.";
  }
  else if (ticks->IsRecording())
  {
    error = "A recording is under way: Stop() it first.";
  }
  else if (!ticks->GetLatestModel())
  {
    error = "There is nothing to record: SetVolumeHaptics() a filter first, as recordings are "
            "of what is felt. If there is one, wait until IsPublished().";
  }
  else if (!ticks->GetLatestModel()->Resident.IsWhole())
  {
    error = "A region of a larger volume can't be recorded: the forces depend on when each region "
            "arrived, so that no single image could replay them. Connect the whole "
            "volume to the filter, Publish() it and, if its surface is being meshed, wait until "
            "IsPublished(); or keep the states with vtkHapticState::Drain().";
  }
  else if (ticks->GetLatestModel()->Baked->IsForAPoint)
  {
    error = "This hand feels with a point while another one holds the filter's tool, so that the "
            "filter could not replay its recording. Record the hand with the tool, or put the tool "
            "away with SetTool(nullptr) and SetRemoval(nullptr) of the filter, and Publish().";
  }
  if (error)
  {
    vtkErrorWithObjectMacro(this->Device, << error);
    return nullptr;
  }
  std::string reason;
  if (GetTraceEnding(name).empty())
  {
    reason = "\"" + Printable(name) + "\" has an unknown extension: name it .vtp or .csv.";
  }
  else if (!CheckWritable(name, reason) ||
    (GetTraceEnding(name) == ".csv" && !CheckWritable(name + ".json", reason)))
  {
    reason = Printable(name) + " can't be written: " + reason;
  }
  if (!reason.empty())
  {
    vtkErrorWithObjectMacro(this->Device, "The recording " << reason);
    return nullptr;
  }
  return ticks;
}

bool vtkHapticRecorder::vtkInternals::Start(const std::string& name, vtkVolumeHapticsFilter* filter)
{
  try
  {
    return this->Begin(name, filter);
  }
  catch (const std::bad_alloc&)
  {
    this->File.clear();
    vtkErrorWithObjectMacro(
      this->Device, << "There is not enough memory to begin the recording " << Printable(name)
                    << ", which takes about 7 MB. Close other programs that need memory.");
    return false;
  }
}

bool vtkHapticRecorder::vtkInternals::Begin(const std::string& name, vtkVolumeHapticsFilter* felt)
{
  TickCollector* const ticks = this->GetRecordable(name);
  if (!ticks)
  {
    return false;
  }
  RecordingAbout about;
  about.DeviceId = this->Session.GetId();
  if (felt)
  {
    const TouchedArrays touched = felt->GetBaker().GetTouched();
    std::ostringstream settings;
    settings.imbue(std::locale::classic()); // writes numbers with a decimal point, as the replay
                                            // expects
    felt->PrintSettings(settings, vtkIndent());
    settings << RecordingNames::DeviceRate << this->Session.GetRate() << " Hz\n";
    const BakedLabels* const labels = ticks->GetLatestModel()->Baked->Labels.get();
    if (labels && labels->Fine)
    {
      const Vector3& steps = labels->Fine->GetSteps();
      settings << RecordingNames::LabelGrid << steps.X << " x " << steps.Y << " x " << steps.Z
               << "\n";
    }
    if (touched[1].Array)
    {
      DescribeLabels(felt, settings);
    }
    about.Settings = settings.str();
    if (!this->GetHashes(felt) && EstimateHashing(touched) <= ShortHashing)
    {
      this->Hashing.WaitFor(ShortHashWait);
    }
  }
  auto recording = std::make_unique<HapticRecording>();
  std::string error;
  std::string warning;
  if (!recording->Start(name, about, error, warning))
  {
    vtkErrorWithObjectMacro(this->Device, << error);
    return false;
  }
  ticks->StartRecording(std::move(recording));
  this->Felt = felt;
  this->Update();
  this->File = name;
  this->IsTroubleTold = false;
  if (!warning.empty())
  {
    vtkWarningWithObjectMacro(this->Device, << warning);
  }
  return true;
}

const RecordingHashes* vtkHapticRecorder::vtkInternals::GetHashes(vtkVolumeHapticsFilter* filter)
{
  const TouchedArrays touched = filter->GetBaker().GetTouched();
  return this->Hashing.Poll({ touched[0].GetKey(), touched[1].GetKey() },
    [touched](WorkMonitor& monitor) { return HashAll(touched, monitor); });
}

void vtkHapticRecorder::vtkInternals::Update()
{
  TickCollector* const ticks = this->Session.GetTicks();
  if (!ticks || !ticks->IsRecording())
  {
    return;
  }
  ticks->PollRecording();
  if (const RecordingHashes* const hashes = this->Felt ? this->GetHashes(this->Felt) : nullptr)
  {
    ticks->SetRecordingHashes(*hashes);
    this->Felt = nullptr;
  }
  this->Session.SetBackgroundWork(
    HashingWork, this->Felt ? this->Hashing.GetProgress() : WorkEnded);
  this->ReportTrouble();
}

void vtkHapticRecorder::vtkInternals::AwaitHashes(HapticRecording& recording)
{
  this->Session.SetBackgroundWork(HashingWork, WorkEnded);
  const vtkSmartPointer<vtkVolumeHapticsFilter> felt = std::exchange(this->Felt, nullptr);
  if (!felt)
  {
    return;
  }
  const RecordingHashes* hashes = this->GetHashes(felt);
  if (!hashes && !this->Session.HasArmOrder())
  {
    this->Hashing.WaitFor(LongestHashWait);
    hashes = this->GetHashes(felt);
  }
  if (hashes)
  {
    recording.SetHashes(*hashes);
  }
  else
  {
    this->Hashing.Abandon(); // the hashes are no longer needed
    vtkWarningWithObjectMacro(this->Device,
      << "The recording " << Printable(recording.GetFile())
      << " has no hash of its volume, as it ended before that was known: nothing tells later which "
         "volume it is of. Disarm() before Stop(), which then waits for the hash, or go "
         "on until GetStatusText() no longer tells of it.");
  }
}

bool vtkHapticRecorder::vtkInternals::Stop(bool isAnnounced)
{
  TickCollector* const ticks = this->Session.GetTicks();
  std::unique_ptr<HapticRecording> recording = ticks ? ticks->StopRecording() : nullptr;
  if (!recording)
  {
    vtkErrorWithObjectMacro(this->Device, "No recording is under way: Start() the recorder first.");
    return false;
  }
  const std::string file = std::exchange(this->File, std::string());
  this->AwaitHashes(*recording);
  if (const std::uint64_t lost = recording->GetLostTicks())
  {
    vtkWarningWithObjectMacro(this->Device,
      << lost << " ticks are missing from the recording " << Printable(file)
      << ": the machine was too busy to collect them. Its forces can't be replayed beyond the "
         "first gap. Record to a local disk, with less else running.");
  }
  std::string error;
  std::unique_ptr<LongWork> work;
  if (isAnnounced)
  {
    work.reset(new LongWork(this->Device, "the recording is written",
      EstimateWriting(file, static_cast<double>(recording->GetNumberOfTicks()))));
  }
  if (!recording->Finish(error))
  {
    vtkErrorWithObjectMacro(this->Device, << error);
    return false;
  }
  return true;
}

bool vtkHapticRecorder::vtkInternals::Recover(const std::string& from, const std::string& to)
{
  std::string error;
  if (from.size() <= std::strlen(JournalEnding))
  {
    vtkErrorWithObjectMacro(this->Device,
      "There is no recording to recover: give the name of an unfinished recording, FILE.part.");
    return false;
  }
  Files::Status status;
  const double bytes = Files::GetStatus(from, status) ? static_cast<double>(status.st_size) : 0.0;
  const LongWork work(
    this->Device, "the recording is recovered", EstimateWriting(to, bytes / BytesPerTick));
  if (!WriteRecording(from, to, error))
  {
    vtkErrorWithObjectMacro(this->Device, << error);
    return false;
  }
  return true;
}

bool vtkHapticRecorder::vtkInternals::IsUnderWay() const
{
  const TickCollector* const ticks = this->Session.GetTicks();
  return ticks && ticks->IsRecording() && this->Session.IsOurs();
}

void vtkHapticRecorder::vtkInternals::ReportTrouble()
{
  const TickCollector* const ticks = this->Session.GetTicks();
  if (!ticks || !ticks->IsRecording() || this->IsTroubleTold)
  {
    return;
  }
  const std::string trouble = ticks->GetRecordingTrouble();
  if (!trouble.empty())
  {
    this->IsTroubleTold = true;
    vtkErrorWithObjectMacro(this->Device, << trouble);
  }
}

//------------------------------------------------------------------------------
vtkHapticRecorder::vtkHapticRecorder() = default;

//------------------------------------------------------------------------------
vtkHapticRecorder::~vtkHapticRecorder() = default;

//------------------------------------------------------------------------------
void vtkHapticRecorder::Attach(DeviceParts& parts)
{
  this->Internals = std::make_unique<vtkInternals>(parts.Device, parts.Session);
}

//------------------------------------------------------------------------------
void vtkHapticRecorder::Detach()
{
  this->Internals.reset();
}

//------------------------------------------------------------------------------
void vtkHapticRecorder::Update()
{
  this->Internals->Update();
}

//------------------------------------------------------------------------------
void vtkHapticRecorder::Finish()
{
  if (this->Internals->IsUnderWay())
  {
    this->Internals->Stop(false); // not announced, because the force is off and the owner may
                                  // already be gone
  }
}

//------------------------------------------------------------------------------
vtkHapticDevice* vtkHapticRecorder::FindDevice()
{
  if (!this->Internals)
  {
    vtkErrorMacro("This recorder has no device: take it from vtkHapticDevice::GetRecorder(), and "
                  "keep the device as long as it is used.");
    return nullptr;
  }
  return this->Internals->GetDevice();
}

//------------------------------------------------------------------------------
bool vtkHapticRecorder::Start(const char* file)
{
  // Keep a reference: an observer of errors may release the last one to the device.
  const vtkSmartPointer<vtkHapticDevice> device(this->FindDevice());
  return device && this->Internals->Start(file ? file : "", device->GetVolumeHaptics());
}

//------------------------------------------------------------------------------
bool vtkHapticRecorder::Stop()
{
  const vtkSmartPointer<vtkHapticRecorder> self(this); // keeps the recorder alive: see Start
  const vtkSmartPointer<vtkHapticDevice> device(this->FindDevice());
  return device && this->Internals->Stop(true);
}

//------------------------------------------------------------------------------
bool vtkHapticRecorder::Recover(const char* part, const char* file)
{
  const vtkSmartPointer<vtkHapticDevice> device(this->FindDevice());
  return device && this->Internals->Recover(part ? part : "", file ? file : "");
}

//------------------------------------------------------------------------------
std::string vtkHapticRecorder::GetFileName()
{
  return this->Internals ? this->Internals->GetFile() : std::string();
}

//------------------------------------------------------------------------------
void vtkHapticRecorder::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const std::string file = this->GetFileName();
  os << indent << "FileName: " << (file.empty() ? "(none)" : file) << "\n";
}
