// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHapticDevice.h"

#include "Devices/Common/DeviceMemory.h"
#include "Devices/Kinds/DeviceRegistry.h"
#include "VTK/Device/DeviceParts.h"
#include "VTK/Device/DevicePlacement.h"
#include "VTK/Device/HapticDeviceSettings.h"

#include "vtkCommand.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkVolumeHapticsFilter.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkHapticDevice);

using namespace VolumeHaptics;

namespace
{
std::vector<DeviceListing> ListAll()
{
  std::vector<DeviceListing> all{ { "virtual", "A stylus without hardware: the mouse",
    "available" } };
  std::vector<DeviceListing> plugged = VolumeHaptics::ListDevices();
  std::move(plugged.begin(), plugged.end(), std::back_inserter(all));
  return all;
}

vtkSmartPointer<vtkStringArray> AddColumn(vtkTable* table, const char* name)
{
  const auto column = vtkSmartPointer<vtkStringArray>::New();
  column->SetName(name);
  table->AddColumn(column);
  return column;
}
} // namespace

//------------------------------------------------------------------------------
vtkHapticDevice::vtkHapticDevice()
  : Parts(new DeviceParts(this))
{
  const char* const file = std::getenv("VOLUMEHAPTICS_FALCON_FIRMWARE");
  this->FirmwareFile = file ? file : "";
}

//------------------------------------------------------------------------------
vtkHapticDevice::~vtkHapticDevice()
{
  // Remove the observers first, so that they do not receive a device that is being deleted.
  this->RemoveAllObservers();
  this->Shut();
}

//------------------------------------------------------------------------------
bool vtkHapticDevice::Open(const char* id)
{
  const vtkSmartPointer<vtkHapticDevice> self(this); // keeps the device alive: see Close
  this->Close();
  if (!this->Parts->Orders.Open(id ? id : "", this->MakeOptions()))
  {
    return false;
  }
  this->UpdateLimits();
  return true;
}

//------------------------------------------------------------------------------
bool vtkHapticDevice::CalibrateForce(double scale)
{
  auto& d = *this->Parts;
  if (!d.Orders.CalibrateForce(scale))
  {
    return false;
  }
  this->UpdateLimits();
  d.Orders.ReportMemoryTrouble();
  return true;
}

//------------------------------------------------------------------------------
void vtkHapticDevice::UpdateLimits()
{
  const DeviceLimits limits = this->Parts->Session.GetLimits();
  const auto choose = [](double wanted, double most, double byDefault)
  { return wanted < 0.0 ? byDefault : std::min(wanted, most); };
  const double half = 0.5 * limits.MaximumForce;
  const double lasting = limits.ContinuousForce > 0.0 ? limits.ContinuousForce : half;
  this->MaximumForce = choose(this->WantedForce, limits.MaximumForce, std::min(half, lasting));
  this->MaximumTorque =
    choose(this->WantedTorque, limits.MaximumTorque, 0.5 * limits.MaximumTorque);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkHapticDevice::ResetMaximumForce()
{
  this->WantedForce = -1.0;
  this->UpdateLimits();
  this->SendLimits();
}

//------------------------------------------------------------------------------
void vtkHapticDevice::ResetMaximumTorque()
{
  this->WantedTorque = -1.0;
  this->UpdateLimits();
  this->SendLimits();
}

//------------------------------------------------------------------------------
void vtkHapticDevice::Close()
{
  // Keep a reference: an observer of the following events may release the last one.
  const vtkSmartPointer<vtkHapticDevice> self(this);
  this->Shut();
}

//------------------------------------------------------------------------------
void vtkHapticDevice::Shut()
{
  this->Halt();
  if (this->Parts->Session.IsOpen())
  {
    this->Parts->Session.Close();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkHapticDevice::SetVolumeHaptics(vtkVolumeHapticsFilter* filter)
{
  if (this->Parts->Models.SetFilter(filter))
  {
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkHapticDevice::SetDeviceToWorld(vtkMatrix4x4* matrix)
{
  if (this->Parts->Models.SetDeviceToWorld(matrix))
  {
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkHapticDevice::SetUseTool(bool on)
{
  if (this->UseTool != on)
  {
    this->UseTool = on;
    this->Parts->Models.Outdate();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkHapticDevice::Stop()
{
  const vtkSmartPointer<vtkHapticDevice> self(this); // keeps the device alive: see Close
  this->Halt();
}

//------------------------------------------------------------------------------
void vtkHapticDevice::Halt()
{
  auto& d = *this->Parts;
  d.Orders.Disarm(); // disarm before writing a recording, which takes time
  d.Recorder->Finish();
  d.Orders.EndPreparing();
  d.Session.Stop();
  d.Models.LetRemovalsGo();
}

//------------------------------------------------------------------------------
bool vtkHapticDevice::UpdateState()
{
  this->Parts->Recorder->Update();
  this->Parts->Orders.Poll();
  const bool wasForbidden = this->GetState()->IsAtForbiddenLabel();
  const bool isNew = this->Parts->Session.Update(this->Parts->Models.GetPlacement());
  this->Parts->Orders.ReportMemoryTrouble();
  this->Parts->Orders.PollRegion();
  this->Parts->Orders.PollTimeSteps();
  if (!wasForbidden && this->GetState()->IsAtForbiddenLabel())
  {
    this->InvokeEvent(vtkCommand::UserEvent);
  }
  return isNew;
}

//------------------------------------------------------------------------------
bool vtkHapticDevice::IsOpen()
{
  return this->Parts->Session.IsOpen();
}

//------------------------------------------------------------------------------
std::string vtkHapticDevice::GetDeviceId()
{
  return this->Parts->Session.GetId();
}

//------------------------------------------------------------------------------
bool vtkHapticDevice::IsRunning()
{
  return this->Parts->Session.IsRunning();
}

//------------------------------------------------------------------------------
int vtkHapticDevice::GetStatus()
{
  return this->Parts->Session.GetStatus().GetType();
}

//------------------------------------------------------------------------------
std::string vtkHapticDevice::GetStatusText()
{
  return this->Parts->Session.GetStatus().MakeText();
}

//------------------------------------------------------------------------------
bool vtkHapticDevice::IsArmOrdered()
{
  return this->Parts->Session.HasArmOrder();
}

//------------------------------------------------------------------------------
bool vtkHapticDevice::GetClutch()
{
  return this->Parts->Session.IsClutched();
}

//------------------------------------------------------------------------------
bool vtkHapticDevice::ArmsAfterClutch()
{
  return this->Parts->Session.ReturnsAfterClutch();
}

//------------------------------------------------------------------------------
bool vtkHapticDevice::GetSignsConfirmed()
{
  return this->Parts->Session.AreSignsConfirmed();
}

//------------------------------------------------------------------------------
bool vtkHapticDevice::IsRemembered()
{
  return this->Parts->Session.IsRemembered();
}

//------------------------------------------------------------------------------
double vtkHapticDevice::GetForceScale()
{
  return this->Parts->Session.GetFacts().Scale;
}

//------------------------------------------------------------------------------
std::string vtkHapticDevice::GetCalibrationText()
{
  return this->Parts->Session.DescribeCalibration();
}

//------------------------------------------------------------------------------
void vtkHapticDevice::SetLights(int lights)
{
  this->Parts->Session.SetLights(lights);
}

//------------------------------------------------------------------------------
vtkVolumeHapticsFilter* vtkHapticDevice::GetVolumeHaptics()
{
  return this->Parts->Models.GetFilter();
}

//------------------------------------------------------------------------------
double vtkHapticDevice::FitDeviceToWorld(vtkPoints* touched, vtkPoints* known, double scale)
{
  vtkNew<vtkMatrix4x4> matrix;
  double largest = 0.0;
  const std::string flaw = ComputePlacement(touched, known, scale, matrix, largest);
  if (!flaw.empty())
  {
    vtkErrorMacro(<< flaw);
    return -1.0;
  }
  this->SetDeviceToWorld(matrix);
  return largest;
}

//------------------------------------------------------------------------------
vtkMatrix4x4* vtkHapticDevice::GetDeviceToWorld()
{
  return this->Parts->Models.GetDeviceToWorld();
}

//------------------------------------------------------------------------------
std::string vtkHapticDevice::GetMethodText()
{
  return this->Parts->Models.GetMethodText();
}

//------------------------------------------------------------------------------
bool vtkHapticDevice::IsPublished()
{
  return this->Parts->Models.IsUpToDate();
}

//------------------------------------------------------------------------------
bool vtkHapticDevice::Start()
{
  return this->Parts->Orders.Start();
}

//------------------------------------------------------------------------------
bool vtkHapticDevice::Publish()
{
  return this->Parts->Orders.Publish();
}

//------------------------------------------------------------------------------
void vtkHapticDevice::Arm()
{
  this->Parts->Orders.Arm();
}

//------------------------------------------------------------------------------
void vtkHapticDevice::Disarm()
{
  this->Parts->Orders.Disarm();
}

//------------------------------------------------------------------------------
void vtkHapticDevice::FadeOut()
{
  this->Parts->Orders.FadeOut();
}

//------------------------------------------------------------------------------
void vtkHapticDevice::Home()
{
  this->Parts->Orders.Home();
}

//------------------------------------------------------------------------------
void vtkHapticDevice::SetClutch(bool on)
{
  this->Parts->Orders.SetClutch(on);
}

//------------------------------------------------------------------------------
void vtkHapticDevice::ForgetConfirmation()
{
  this->Parts->Orders.ForgetConfirmation();
}

//------------------------------------------------------------------------------
void vtkHapticDevice::BeginLongWork(const char* what, double expectedSeconds)
{
  this->Parts->Orders.BeginLongWork(what, expectedSeconds);
}

//------------------------------------------------------------------------------
void vtkHapticDevice::EndLongWork()
{
  this->Parts->Orders.EndLongWork();
}

//------------------------------------------------------------------------------
vtkHapticState* vtkHapticDevice::GetState()
{
  return this->Parts->Session.GetLatest();
}

//------------------------------------------------------------------------------
vtkHapticPlayback* vtkHapticDevice::GetPlayback()
{
  return this->Parts->Playback;
}

//------------------------------------------------------------------------------
vtkHapticRecorder* vtkHapticDevice::GetRecorder()
{
  return this->Parts->Recorder;
}

//------------------------------------------------------------------------------
vtkHapticVirtualHand* vtkHapticDevice::GetVirtualHand()
{
  return this->Parts->Hand;
}

//------------------------------------------------------------------------------
double vtkHapticDevice::GetStiffnessCap()
{
  return this->Parts->Session.GetCaps().Stiffness;
}

//------------------------------------------------------------------------------
double vtkHapticDevice::GetDampingCap()
{
  return this->Parts->Session.GetCaps().Damping;
}

//------------------------------------------------------------------------------
double vtkHapticDevice::GetTickRate()
{
  ServoLoop* const loop = this->Parts->Session.GetLoop();
  return loop ? loop->GetTickRate() : 0.0;
}

//------------------------------------------------------------------------------
double vtkHapticDevice::GetTickPercentile(double p)
{
  ServoLoop* const loop = this->Parts->Session.GetLoop();
  return loop ? loop->GetTickCost().GetPercentile(p / 100.0) * 1e-9 : 0.0;
}

//------------------------------------------------------------------------------
double vtkHapticDevice::GetWakePercentile(double p)
{
  ServoLoop* const loop = this->Parts->Session.GetLoop();
  return loop ? loop->GetWakeLatency().GetPercentile(p / 100.0) * 1e-9 : 0.0;
}

//------------------------------------------------------------------------------
vtkIdType vtkHapticDevice::GetMissedTicks()
{
  ServoLoop* const loop = this->Parts->Session.GetLoop();
  return loop ? static_cast<vtkIdType>(loop->GetMissedTicks()) : 0;
}

//------------------------------------------------------------------------------
vtkIdType vtkHapticDevice::GetAbsentTicks()
{
  ServoLoop* const loop = this->Parts->Session.GetLoop();
  return loop ? static_cast<vtkIdType>(loop->GetAbsentTicks()) : 0;
}

//------------------------------------------------------------------------------
vtkIdType vtkHapticDevice::GetUnfinishedTicks()
{
  ServoLoop* const loop = this->Parts->Session.GetLoop();
  return loop ? static_cast<vtkIdType>(loop->GetUnfinishedTicks()) : 0;
}

//------------------------------------------------------------------------------
double vtkHapticDevice::GetReportPeriod()
{
  ServoLoop* const loop = this->Parts->Session.GetLoop();
  return loop ? loop->GetTiming().GetReportPeriod() : 0.0;
}

//------------------------------------------------------------------------------
double vtkHapticDevice::GetRoundTripTime()
{
  ServoLoop* const loop = this->Parts->Session.GetLoop();
  return loop ? loop->GetTiming().GetRoundTrip() : 0.0;
}

//------------------------------------------------------------------------------
void vtkHapticDevice::SendLimits()
{
  this->Parts->Orders.SendLimits();
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
  auto& session = this->Parts->Session;
  const double most = session.IsOpen() ? session.GetLimits().MaximumForce : VTK_DOUBLE_MAX;
  this->WantedForce = Clamp(DeviceSettingRows::MaximumForce, force);
  const double clamped = std::min(this->WantedForce, most);
  if (clamped != this->MaximumForce)
  {
    this->MaximumForce = clamped;
    this->SendLimits();
  }
}

//------------------------------------------------------------------------------
void vtkHapticDevice::SetMaximumTorque(double torque)
{
  auto& session = this->Parts->Session;
  const double most = session.IsOpen() ? session.GetLimits().MaximumTorque : VTK_DOUBLE_MAX;
  this->WantedTorque = Clamp(DeviceSettingRows::MaximumTorque, torque);
  const double clamped = std::min(this->WantedTorque, most);
  if (clamped != this->MaximumTorque)
  {
    this->MaximumTorque = clamped;
    this->SendLimits();
  }
}

//------------------------------------------------------------------------------
void vtkHapticDevice::SetMaximumForceRate(double rate)
{
  // The minimum is above 0: with a rate of 0 the force could never grow.
  const double clamped = Clamp(DeviceSettingRows::MaximumForceRate, rate);
  if (clamped != this->MaximumForceRate)
  {
    this->MaximumForceRate = clamped;
    this->SendLimits();
  }
}

//------------------------------------------------------------------------------
void vtkHapticDevice::SetStiffnessGain(double gain)
{
  const double clamped = Clamp(DeviceSettingRows::StiffnessGain, gain);
  if (clamped != this->StiffnessGain)
  {
    this->StiffnessGain = clamped;
    this->Parts->Session.SetStiffnessGain(clamped);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkHapticDevice::SetTransientGain(double gain)
{
  const double clamped = Clamp(DeviceSettingRows::TransientGain, gain);
  if (clamped != this->TransientGain)
  {
    this->TransientGain = clamped;
    this->SendLimits();
    this->Modified();
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
void vtkHapticDevice::ResetStatistics()
{
  if (ServoLoop* const loop = this->Parts->Session.GetLoop())
  {
    loop->ResetStatistics();
  }
}

//------------------------------------------------------------------------------
vtkStringArray* vtkHapticDevice::EnumerateDevices()
{
  static const vtkSmartPointer<vtkStringArray> ids = vtkSmartPointer<vtkStringArray>::New();
  ids->Reset();
  for (const DeviceListing& device : ListAll())
  {
    ids->InsertNextValue(device.Id);
  }
  return ids;
}

//------------------------------------------------------------------------------
void vtkHapticDevice::ListDevices(vtkTable* devices)
{
  if (!devices)
  {
    return;
  }
  devices->Initialize();
  const auto ids = AddColumn(devices, "Id");
  const auto names = AddColumn(devices, "Name");
  const auto states = AddColumn(devices, "State");
  const auto forces = AddColumn(devices, "Force");
  for (const DeviceListing& device : ListAll())
  {
    ids->InsertNextValue(device.Id);
    names->InsertNextValue(device.Name);
    states->InsertNextValue(device.State);
    std::string error;
    forces->InsertNextValue(device.Identity.empty()
        ? std::string()
        : DeviceMemory::Read(device.Identity, error).DescribeScale());
  }
}

//------------------------------------------------------------------------------
void vtkHapticDevice::ListMissingKinds(vtkTable* kinds)
{
  if (!kinds)
  {
    return;
  }
  kinds->Initialize();
  const auto names = AddColumn(kinds, "Kind");
  const auto states = AddColumn(kinds, "State");
  for (const DeviceObstacle& obstacle : VolumeHaptics::ListMissingKinds())
  {
    names->InsertNextValue(obstacle.Kind);
    states->InsertNextValue(obstacle.Text);
  }
}

//------------------------------------------------------------------------------
bool vtkHapticDevice::AddDeviceKind(const DeviceKind& kind)
{
  std::string error;
  const bool isAdded = VolumeHaptics::AddDeviceKind(kind, error);
  if (!isAdded)
  {
    vtkGenericWarningMacro(<< error);
  }
  return isAdded;
}

//------------------------------------------------------------------------------
void vtkHapticDevice::SetFirmwareFile(const std::string& file)
{
  if (file != this->FirmwareFile)
  {
    this->FirmwareFile = file;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkHapticDevice::SetVendorPath(const std::string& path)
{
  if (path != this->VendorPath)
  {
    this->VendorPath = path;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkHapticDevice::SetNewtonsPerFullScale(double x, double y)
{
  if (!std::isfinite(x) || !std::isfinite(y))
  {
    vtkErrorMacro("NewtonsPerFullScale must be finite; it stays as it was.");
    return;
  }
  const DeviceVector& row = DeviceSettingRows::NewtonsPerFullScale;
  const double newtons[2] = { std::clamp(x, row.Minimum, row.Maximum),
    std::clamp(y, row.Minimum, row.Maximum) };
  if (newtons[0] != this->NewtonsPerFullScale[0] || newtons[1] != this->NewtonsPerFullScale[1])
  {
    std::copy(newtons, newtons + 2, this->NewtonsPerFullScale);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkHapticDevice::SetNewtonsPerFullScale(const double newtons[2])
{
  if (!newtons)
  {
    vtkErrorMacro(
      "NewtonsPerFullScale needs two numbers, but got a null pointer; it stays as it was.");
    return;
  }
  this->SetNewtonsPerFullScale(newtons[0], newtons[1]);
}

//------------------------------------------------------------------------------
DeviceOptions vtkHapticDevice::MakeOptions() const
{
  DeviceOptions options;
  options.FirmwareFile = this->FirmwareFile;
  options.VendorPath = this->VendorPath;
  options.HomingTime = this->HomingTime;
  options.UseGuard = this->UseGuard;
  options.NewtonsPerFullScale = { this->NewtonsPerFullScale[0], this->NewtonsPerFullScale[1] };
  return options;
}

//------------------------------------------------------------------------------
void vtkHapticDevice::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  auto& d = *this->Parts;
  const std::string& id = d.Session.GetId();
  os << indent << "Device: " << (id.empty() ? "(none)" : id.c_str()) << "\n";
  os << indent << "Status: " << this->GetStatusText() << "\n";
  os << indent << "Clutch: " << (this->GetClutch() ? "On" : "Off") << "\n";
  os << indent << "VolumeHaptics: " << d.Models.GetFilter() << "\n";
  os << indent << "DeviceToWorld: " << d.Models.GetDeviceToWorld() << "\n";
  os << indent << "FirmwareFile: " << (this->FirmwareFile.empty() ? "(none)" : this->FirmwareFile)
     << "\n";
  os << indent << "VendorPath: "
     << (this->VendorPath.empty() ? "(VOLUMEHAPTICS_VENDOR_PATH)" : this->VendorPath) << "\n";
  PrintSettings(os, indent, this, DeviceSettings);
  PrintSettings(os, indent, this, DeviceVectors);
  os << indent << "State:\n";
  this->GetState()->PrintSelf(os, indent.GetNextIndent());
  os << indent << "Playback:\n";
  d.Playback->PrintSelf(os, indent.GetNextIndent());
  os << indent << "Recorder:\n";
  d.Recorder->PrintSelf(os, indent.GetNextIndent());
  os << indent << "VirtualHand:\n";
  d.Hand->PrintSelf(os, indent.GetNextIndent());
}
