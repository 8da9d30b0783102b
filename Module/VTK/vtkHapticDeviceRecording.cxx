// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
// The part of vtkHapticDevice that limits, records and measures.
#include "VTK/Session/HapticDeviceSettings.h"
#include "VTK/Trace/HapticFiles.h"
#include "VTK/Trace/HapticRecordingFile.h"
#include "vtkHapticDeviceInternals.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cstring>
#include <new>
#include <sstream>
#include <sys/stat.h>

using namespace VolumeHaptics;

namespace
{
/** Time to write a tick to a .vtp and to a .csv (s), as measured. */
constexpr double SecondsPerTick = 2e-6;
constexpr double SecondsPerLine = 2e-5;

/** In a journal, at least, while the tip moves: 80 to 180 were measured. */
constexpr double BytesPerTick = 80;

double EstimateWriting(const std::string& file, double ticks)
{
  return ticks * (GetTraceEnding(file) == ".csv" ? SecondsPerLine : SecondsPerTick);
}

/** The session that can be recorded into a file of that name; null after an error. */
HapticSession* FindRecordable(
  vtkHapticDevice* self, const HapticDeviceHolder& holder, const std::string& name)
{
  HapticSession* const session = holder.GetSession();
  const char* error = nullptr;
  if (!session)
  {
    error = "There is nothing to record: Start() the servo first.";
  }
  else if (session->IsRecording())
  {
    error = "A recording is under way: StopRecording() it first.";
  }
  else if (!session->GetLatestModel())
  {
    error = "There is nothing to record: SetVolumeHaptics() a filter first, as recordings are "
            "of what is felt.";
  }
  else if (!session->GetLatestModel()->Resident.IsWhole())
  {
    error = "A region of a larger volume can't be recorded: the forces depend on when each region "
            "arrived, so that no single image could replay them. Connect the whole "
            "volume to the filter and Publish() it, or keep the states with DrainStates().";
  }
  if (error)
  {
    vtkErrorWithObjectMacro(self, << error);
    return nullptr;
  }
  std::string reason;
  if (GetTraceEnding(name).empty())
  {
    reason = "\"" + Printable(name) + "\" has an unknown ending: name it .vtp or .csv.";
  }
  else if (!CheckWritable(name, reason) ||
    (GetTraceEnding(name) == ".csv" && !CheckWritable(name + ".json", reason)))
  {
    reason = Printable(name) + " can't be written: " + reason;
  }
  if (!reason.empty())
  {
    vtkErrorWithObjectMacro(self, "The recording " << reason);
    return nullptr;
  }
  return session;
}
} // namespace

//------------------------------------------------------------------------------
void vtkHapticDevice::SendLimits()
{
  auto& d = *this->Internals;
  if (HapticSession* session = d.Holder.GetSession())
  {
    session->GetLoop().Attend();
    session->GetLoop().SetLimits(d.MakeLimits(this));
  }
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkHapticDevice::SetServoRate(double rate)
{
  const double clamped = Clamp(DeviceSettingRows::ServoRate, rate);
  if (clamped != this->ServoRate)
  {
    this->ServoRate = clamped;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkHapticDevice::SetMaximumForce(double force)
{
  auto& holder = this->Internals->Holder;
  const double most = holder.IsOpen() ? holder.GetLimits().MaximumForce : VTK_DOUBLE_MAX;
  this->WantedForce = Clamp(DeviceSettingRows::MaximumForce, force);
  const double clamped = std::min(this->WantedForce, most);
  if (clamped != this->MaximumForce)
  {
    this->MaximumForce = clamped;
    this->SendLimits();
  }
}

//------------------------------------------------------------------------------
void vtkHapticDevice::SetMaximumForceRate(double rate)
{
  // A rate of 0 would hold the force of now in the hand for ever.
  const double clamped = Clamp(DeviceSettingRows::MaximumForceRate, rate);
  if (clamped != this->MaximumForceRate)
  {
    this->MaximumForceRate = clamped;
    this->SendLimits();
  }
}

//------------------------------------------------------------------------------
void vtkHapticDevice::SetAttentionTime(double seconds)
{
  const double clamped = seconds > 0.0 ? std::max(seconds, 0.05) : 0.0;
  if (clamped != this->AttentionTime)
  {
    this->AttentionTime = clamped;
    this->SendLimits();
  }
}

//------------------------------------------------------------------------------
bool vtkHapticDevice::StartRecording(const char* file)
{
  const vtkSmartPointer<vtkHapticDevice> self(this); // see Close
  const std::string name = file ? file : "";
  try
  {
    return this->BeginRecording(name);
  }
  catch (const std::bad_alloc&)
  {
    this->Internals->RecordingFile.clear();
    vtkErrorMacro(<< "There is not enough memory to begin the recording " << Printable(name)
                  << ", which takes about 5 MB. Close other programs that need memory.");
    return false;
  }
}

//------------------------------------------------------------------------------
bool vtkHapticDevice::BeginRecording(const std::string& name)
{
  auto& d = *this->Internals;
  if (!FindRecordable(this, d.Holder, name))
  {
    return false;
  }
  RecordingAbout about;
  about.DeviceId = d.Holder.GetId();
  if (const vtkSmartPointer<vtkVolumeHapticsFilter> filter = d.Filter)
  {
    std::ostringstream settings;
    filter->PrintSettings(settings, vtkIndent());
    settings << "ServoRate of the device: " << d.Holder.GetRate() << " Hz\n";
    about.Settings = settings.str();
    const LongWork work(this, "the volume is hashed", HapticBaker(filter).EstimateHashTime());
    about.VolumeHash = filter->HashScalars();
  }
  // Observers of the long work may have stopped the servo, or begun a recording.
  HapticSession* const session = FindRecordable(this, d.Holder, name);
  if (!session)
  {
    return false;
  }
  auto recording = std::make_unique<HapticRecording>();
  std::string error;
  std::string warning;
  if (!recording->Start(name, about, error, warning))
  {
    vtkErrorMacro(<< error);
    return false;
  }
  session->StartRecording(std::move(recording));
  d.RecordingFile = name;
  d.IsRecordingTroubleTold = false;
  if (!warning.empty())
  {
    vtkWarningMacro(<< warning);
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkHapticDevice::StopRecording()
{
  const vtkSmartPointer<vtkHapticDevice> self(this); // see Close
  return this->EndRecording(true);
}

//------------------------------------------------------------------------------
bool vtkHapticDevice::EndRecording(bool isAnnounced)
{
  auto& d = *this->Internals;
  HapticSession* const session = d.Holder.GetSession();
  std::unique_ptr<HapticRecording> recording = session ? session->StopRecording() : nullptr;
  if (!recording)
  {
    vtkErrorMacro("No recording is under way: StartRecording() first.");
    return false;
  }
  const std::string file = std::move(d.RecordingFile);
  d.RecordingFile.clear();
  if (const std::uint64_t lost = recording->GetLostTicks())
  {
    vtkWarningMacro(<< lost << " ticks are missing from the recording " << Printable(file)
                    << ": the machine was too busy to collect them. Its forces can't be replayed "
                       "beyond the first gap. Record to a local disk, with less else running.");
  }
  std::string error;
  std::unique_ptr<LongWork> work;
  if (isAnnounced)
  {
    work.reset(new LongWork(this, "the recording is written",
      EstimateWriting(file, static_cast<double>(recording->GetNumberOfTicks()))));
  }
  if (!recording->Finish(error))
  {
    vtkErrorMacro(<< error);
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkHapticDevice::RecoverRecording(const char* part, const char* file)
{
  const std::string from = part ? part : "";
  std::string error;
  if (from.size() <= std::strlen(JournalEnding))
  {
    vtkErrorMacro(
      "There is no recording to recover: give the name of an unfinished recording, FILE.part.");
    return false;
  }
  const std::string to = file ? file : "";
  struct stat status;
  const double bytes = stat(from.c_str(), &status) == 0 ? static_cast<double>(status.st_size) : 0.0;
  const LongWork work(
    this, "the recording is recovered", EstimateWriting(to, bytes / BytesPerTick));
  if (!WriteRecording(from, to, error))
  {
    vtkErrorMacro(<< error);
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkHapticDevice::TellRecordingTrouble()
{
  auto& d = *this->Internals;
  const HapticSession* const session = d.Holder.GetSession();
  if (!session || !session->IsRecording() || d.IsRecordingTroubleTold)
  {
    return;
  }
  const std::string trouble = session->GetRecordingTrouble();
  if (!trouble.empty())
  {
    d.IsRecordingTroubleTold = true;
    vtkErrorMacro(<< trouble);
  }
}

//------------------------------------------------------------------------------
double vtkHapticDevice::GetTickRate()
{
  HapticSession* const session = this->Internals->Holder.GetSession();
  return session ? session->GetLoop().GetTickRate() : 0.0;
}

//------------------------------------------------------------------------------
double vtkHapticDevice::GetTickPercentile(double p)
{
  HapticSession* const session = this->Internals->Holder.GetSession();
  return session ? 1e-9 * session->GetLoop().GetTickCost().GetPercentile(p / 100.0) : 0.0;
}

//------------------------------------------------------------------------------
double vtkHapticDevice::GetWakePercentile(double p)
{
  HapticSession* const session = this->Internals->Holder.GetSession();
  return session ? 1e-9 * session->GetLoop().GetWakeLatency().GetPercentile(p / 100.0) : 0.0;
}

//------------------------------------------------------------------------------
vtkIdType vtkHapticDevice::GetMissedTicks()
{
  HapticSession* const session = this->Internals->Holder.GetSession();
  return session ? static_cast<vtkIdType>(session->GetLoop().GetMissedTicks()) : 0;
}

//------------------------------------------------------------------------------
vtkIdType vtkHapticDevice::GetAbsentTicks()
{
  HapticSession* const session = this->Internals->Holder.GetSession();
  return session ? static_cast<vtkIdType>(session->GetLoop().GetAbsentTicks()) : 0;
}

//------------------------------------------------------------------------------
vtkIdType vtkHapticDevice::GetUnfinishedTicks()
{
  HapticSession* const session = this->Internals->Holder.GetSession();
  return session ? static_cast<vtkIdType>(session->GetLoop().GetUnfinishedTicks()) : 0;
}

//------------------------------------------------------------------------------
void vtkHapticDevice::ResetStatistics()
{
  if (HapticSession* session = this->Internals->Holder.GetSession())
  {
    session->GetLoop().ResetStatistics();
  }
}

//------------------------------------------------------------------------------
void vtkHapticDevice::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  auto& d = *this->Internals;
  const std::string& id = d.Holder.GetId();
  os << indent << "Device: " << (id.empty() ? "(none)" : id.c_str()) << "\n";
  os << indent << "Status: " << this->GetStatusText() << "\n";
  os << indent << "VolumeHaptics: " << d.Filter.GetPointer() << "\n";
  os << indent << "DeviceToWorld: " << d.DeviceToWorld.GetPointer() << "\n";
  PrintSettings(os, indent, this, DeviceSettings);
  os << indent << "Recording: " << (d.RecordingFile.empty() ? "(none)" : d.RecordingFile.c_str())
     << "\n";
}
