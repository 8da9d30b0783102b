// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHapticDevice.h"

#include "VTK/Baking/HapticMethods.h"
#include "VTK/Files/HapticFiles.h"
#include "VTK/Session/DeviceOrders.h"
#include "VTK/Session/DeviceRecorder.h"
#include "VTK/Session/DeviceSession.h"
#include "VTK/Session/HapticDeviceSettings.h"
#include "VTK/Session/ModelSource.h"
#include "VTK/Session/VirtualTip.h"

#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkSmartPointer.h"
#include "vtkVolumeHapticsFilter.h"

#include <algorithm>

vtkStandardNewMacro(vtkHapticDevice);

using namespace VolumeHaptics;

//------------------------------------------------------------------------------
struct vtkHapticDevice::vtkInternals
{
  explicit vtkInternals(vtkHapticDevice* self)
    : Models(self, Session)
    , Orders(self, Session, Models)
    , Recorder(self, Session)
    , Tip(Session)
  {
  }

  DeviceSession Session;
  ModelSource Models;
  DeviceOrders Orders;
  DeviceRecorder Recorder;
  VirtualTip Tip;
};

//------------------------------------------------------------------------------
vtkHapticDevice::vtkHapticDevice()
  : Internals(new vtkInternals(this))
{
}

//------------------------------------------------------------------------------
vtkHapticDevice::~vtkHapticDevice()
{
  // Observers must not get a device that is being deleted.
  this->RemoveAllObservers();
  this->Shut();
}

//------------------------------------------------------------------------------
bool vtkHapticDevice::Open(const char* id)
{
  const vtkSmartPointer<vtkHapticDevice> self(this); // see Close
  std::string error;
  auto& session = this->Internals->Session;
  this->Close();
  if (!session.Open(id ? id : "", this->MakeOptions(), error))
  {
    vtkErrorMacro(<< Printable(error));
    return false;
  }
  this->TellMemoryTrouble();
  this->TakeLimits();
  return true;
}

//------------------------------------------------------------------------------
void vtkHapticDevice::TellMemoryTrouble()
{
  const std::string trouble = this->Internals->Session.TakeMemoryTrouble();
  if (!trouble.empty())
  {
    vtkErrorMacro(<< Printable(trouble));
  }
}

//------------------------------------------------------------------------------
bool vtkHapticDevice::GetSignsConfirmed()
{
  return this->IsOpen() && !this->Internals->Session.NeedsConfirmation();
}

//------------------------------------------------------------------------------
void vtkHapticDevice::ForgetConfirmation()
{
  auto& session = this->Internals->Session;
  if (!session.IsOpen() || session.IsRunning())
  {
    vtkErrorMacro("ForgetConfirmation() is for an open device whose servo does not run: Open() it "
                  "and Stop() it first.");
    return;
  }
  session.ForgetConfirmation();
  this->TellMemoryTrouble();
}

//------------------------------------------------------------------------------
bool vtkHapticDevice::CalibrateForce(double scale)
{
  auto& session = this->Internals->Session;
  if (!session.IsRemembered() || session.IsRunning())
  {
    vtkErrorMacro(
      "CalibrateForce() is for an open real device that gives force and whose servo does "
      "not run: Open() it and Stop() it first.");
    return false;
  }
  if (!(scale >= DeviceFacts::LeastScale && scale <= DeviceFacts::MostScale))
  {
    vtkErrorMacro(<< "The device can't give " << scale << " N for each newton: the scale has to be "
                  << DeviceFacts::LeastScale << " to " << DeviceFacts::MostScale
                  << ". Measure it again.");
    return false;
  }
  session.SetForceScale(scale);
  this->TakeLimits();
  this->TellMemoryTrouble();
  return true;
}

//------------------------------------------------------------------------------
double vtkHapticDevice::GetForceScale()
{
  return this->Internals->Session.GetFacts().Scale;
}

//------------------------------------------------------------------------------
std::string vtkHapticDevice::GetCalibrationText()
{
  const auto& session = this->Internals->Session;
  return session.IsRemembered() ? session.GetFacts().DescribeScale() : std::string();
}

//------------------------------------------------------------------------------
void vtkHapticDevice::TakeLimits()
{
  const double most = this->Internals->Session.GetLimits().MaximumForce;
  this->MaximumForce = this->WantedForce < 0.0 ? 0.5 * most : std::min(this->WantedForce, most);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkHapticDevice::ResetMaximumForce()
{
  this->WantedForce = -1.0;
  this->TakeLimits();
  this->SendLimits();
}

//------------------------------------------------------------------------------
void vtkHapticDevice::Close()
{
  // An observer of the following events may hold the last reference, and release it.
  const vtkSmartPointer<vtkHapticDevice> self(this);
  this->Shut();
}

//------------------------------------------------------------------------------
void vtkHapticDevice::Shut()
{
  this->Halt();
  if (this->Internals->Session.IsOpen())
  {
    this->Internals->Session.Close();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
bool vtkHapticDevice::IsOpen()
{
  return this->Internals->Session.IsOpen();
}

//------------------------------------------------------------------------------
std::string vtkHapticDevice::GetDeviceId()
{
  return this->Internals->Session.GetId();
}

//------------------------------------------------------------------------------
void vtkHapticDevice::SetVolumeHaptics(vtkVolumeHapticsFilter* filter)
{
  if (this->Internals->Models.SetFilter(filter))
  {
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkVolumeHapticsFilter* vtkHapticDevice::GetVolumeHaptics()
{
  return this->Internals->Models.GetFilter();
}

//------------------------------------------------------------------------------
std::string vtkHapticDevice::GetMethodText()
{
  auto& d = *this->Internals;
  const TickCollector* const ticks = d.Session.GetTicks();
  const HapticModel* const model = ticks ? ticks->GetLatestModel() : nullptr;
  if (!model)
  {
    vtkVolumeHapticsFilter* const filter = d.Models.GetFilter();
    return filter ? filter->GetMethodText() : std::string();
  }
  const HapticSettings& settings = model->Baked->Settings;
  return GetMethodChoice(static_cast<int>(settings.Method), static_cast<int>(settings.Solver)).Text;
}

//------------------------------------------------------------------------------
void vtkHapticDevice::SetDeviceToWorld(vtkMatrix4x4* matrix)
{
  if (this->Internals->Models.SetDeviceToWorld(matrix))
  {
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkMatrix4x4* vtkHapticDevice::GetDeviceToWorld()
{
  return this->Internals->Models.GetDeviceToWorld();
}

//------------------------------------------------------------------------------
bool vtkHapticDevice::Publish()
{
  return this->Internals->Orders.Publish();
}

//------------------------------------------------------------------------------
bool vtkHapticDevice::IsPublished()
{
  return this->Internals->Models.IsUpToDate();
}

//------------------------------------------------------------------------------
bool vtkHapticDevice::Start()
{
  return this->Internals->Orders.Start();
}

//------------------------------------------------------------------------------
void vtkHapticDevice::Stop()
{
  const vtkSmartPointer<vtkHapticDevice> self(this); // see Close
  this->Halt();
}

//------------------------------------------------------------------------------
void vtkHapticDevice::Halt()
{
  auto& d = *this->Internals;
  d.Orders.Disarm(); // at once, because writing a recording takes time
  if (d.Recorder.IsUnderWay())
  {
    d.Recorder.Stop(false); // the force is gone, and perhaps the owner as well
  }
  d.Session.Stop();
}

//------------------------------------------------------------------------------
bool vtkHapticDevice::IsRunning()
{
  return this->Internals->Session.IsRunning();
}

//------------------------------------------------------------------------------
void vtkHapticDevice::Arm()
{
  this->Internals->Orders.Arm();
}

//------------------------------------------------------------------------------
void vtkHapticDevice::Disarm()
{
  this->Internals->Orders.Disarm();
}

//------------------------------------------------------------------------------
void vtkHapticDevice::FadeOut()
{
  this->Internals->Orders.FadeOut();
}

//------------------------------------------------------------------------------
void vtkHapticDevice::BeginLongWork(const char* what, double expectedSeconds)
{
  this->Internals->Orders.BeginLongWork(what, expectedSeconds);
}

//------------------------------------------------------------------------------
void vtkHapticDevice::EndLongWork()
{
  this->Internals->Orders.EndLongWork();
}

//------------------------------------------------------------------------------
void vtkHapticDevice::Home()
{
  this->Internals->Orders.Home();
}

//------------------------------------------------------------------------------
void vtkHapticDevice::SetClutch(bool on)
{
  this->Internals->Orders.SetClutch(on);
}

//------------------------------------------------------------------------------
bool vtkHapticDevice::GetClutch()
{
  return this->Internals->Session.IsClutched();
}

//------------------------------------------------------------------------------
bool vtkHapticDevice::ArmsAfterClutch()
{
  return this->Internals->Session.ReturnsAfterClutch();
}

//------------------------------------------------------------------------------
void vtkHapticDevice::SetLights(int lights)
{
  this->Internals->Session.SetLights(lights);
}

//------------------------------------------------------------------------------
int vtkHapticDevice::GetStatus()
{
  return this->Internals->Session.GetStatus().FindType();
}

//------------------------------------------------------------------------------
std::string vtkHapticDevice::GetStatusText()
{
  return this->Internals->Session.GetStatus().MakeText();
}

//------------------------------------------------------------------------------
bool vtkHapticDevice::UpdateState()
{
  this->Internals->Recorder.TellTrouble();
  const bool isNew = this->Internals->Session.Update(this->Internals->Models.GetPlacement());
  this->TellMemoryTrouble();
  return isNew;
}

//------------------------------------------------------------------------------
#define vtkHapticDeviceStateMacro(type, name, value)          \
  type vtkHapticDevice::Get##name()                           \
  {                                                           \
    return static_cast<type>(this->Internals->Session.value); \
  }

vtkHapticDeviceStateMacro(double*, TipPosition, Tip);
vtkHapticDeviceStateMacro(double*, ProxyPosition, Proxy);
vtkHapticDeviceStateMacro(double*, Force, Force);
vtkHapticDeviceStateMacro(double*, ComputedForce, ComputedForce);
vtkHapticDeviceStateMacro(int, Buttons, GetState().Buttons);
vtkHapticDeviceStateMacro(double*, TurnRate, TurnRate);
vtkHapticDeviceStateMacro(int, Contact, GetState().Record.Contact);
vtkHapticDeviceStateMacro(double, SurfaceValue, GetState().Record.SurfaceValue);
vtkHapticDeviceStateMacro(double, NormalForce, GetState().Record.NormalForce);
vtkHapticDeviceStateMacro(double, FrictionForce, GetState().Record.FrictionForce);
vtkHapticDeviceStateMacro(double, DragForce, GetState().Record.DragForce);
vtkHapticDeviceStateMacro(double*, Normal, Normal);
vtkHapticDeviceStateMacro(double*, SurfacePosition, SurfacePosition);
vtkHapticDeviceStateMacro(double*, MediumPosition, MediumPosition);
vtkHapticDeviceStateMacro(double, Residency, GetState().Residency);
vtkHapticDeviceStateMacro(vtkIdType, Tick, GetState().Tick);
vtkHapticDeviceStateMacro(double, Time, GetState().Time);

//------------------------------------------------------------------------------
void vtkHapticDevice::DrainStates(vtkTable* states, int reader)
{
  auto& d = *this->Internals;
  d.Session.DrainStates(d.Models.GetPlacement(), states, reader);
}

//------------------------------------------------------------------------------
int vtkHapticDevice::AddReader()
{
  return this->Internals->Session.AddReader();
}

//------------------------------------------------------------------------------
void vtkHapticDevice::RemoveReader(int reader)
{
  this->Internals->Session.RemoveReader(reader);
}

//------------------------------------------------------------------------------
void vtkHapticDevice::SendLimits()
{
  this->Internals->Orders.SendLimits();
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
  auto& session = this->Internals->Session;
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
void vtkHapticDevice::SetMaximumForceRate(double rate)
{
  // A rate of 0 would never let the force grow.
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
void vtkHapticDevice::SetVirtualTip(double x, double y, double z)
{
  auto& d = *this->Internals;
  this->TellError(d.Tip.Lead({ x, y, z }, d.Models.GetPlacement()));
}

//------------------------------------------------------------------------------
void vtkHapticDevice::PlaceVirtualTip(double x, double y, double z)
{
  auto& d = *this->Internals;
  this->TellError(d.Tip.Place({ x, y, z }, d.Models.GetPlacement()));
}

//------------------------------------------------------------------------------
void vtkHapticDevice::SetVirtualTip(const double x[3])
{
  if (!x)
  {
    vtkErrorMacro(
      "SetVirtualTip() needs three numbers, but got a null pointer; the tip stays where it is.");
    return;
  }
  this->SetVirtualTip(x[0], x[1], x[2]);
}

//------------------------------------------------------------------------------
void vtkHapticDevice::SetVirtualButtons(int buttons)
{
  this->Internals->Tip.SetButtons(buttons);
}

//------------------------------------------------------------------------------
void vtkHapticDevice::SetVirtualDynamics(
  double mass, double damping, double handStiffness, double encoderQuantum, int forceDelay)
{
  this->TellError(
    this->Internals->Tip.SetDynamics(mass, damping, handStiffness, encoderQuantum, forceDelay));
}

//------------------------------------------------------------------------------
void vtkHapticDevice::SetVirtualLimits(
  double maximumForce, double maximumStiffness, double maximumDamping, double friction)
{
  const std::string error =
    this->Internals->Tip.SetLimits(maximumForce, maximumStiffness, maximumDamping, friction);
  if (error.empty())
  {
    this->TakeLimits();
  }
  this->TellError(error);
}

//------------------------------------------------------------------------------
void vtkHapticDevice::TellError(const std::string& error)
{
  if (!error.empty())
  {
    vtkErrorMacro(<< error);
  }
}

//------------------------------------------------------------------------------
bool vtkHapticDevice::StartRecording(const char* file)
{
  const vtkSmartPointer<vtkHapticDevice> self(this); // see Close
  return this->Internals->Recorder.Start(file ? file : "", this->GetVolumeHaptics());
}

//------------------------------------------------------------------------------
bool vtkHapticDevice::StopRecording()
{
  const vtkSmartPointer<vtkHapticDevice> self(this); // see Close
  return this->Internals->Recorder.Stop(true);
}

//------------------------------------------------------------------------------
bool vtkHapticDevice::RecoverRecording(const char* part, const char* file)
{
  return this->Internals->Recorder.Recover(part ? part : "", file ? file : "");
}

//------------------------------------------------------------------------------
#define vtkHapticDeviceStatisticMacro(type, name, parameters, value) \
  type vtkHapticDevice::Get##name parameters                         \
  {                                                                  \
    ServoLoop* const loop = this->Internals->Session.GetLoop();      \
    return loop ? static_cast<type>(loop->value) : 0;                \
  }

vtkHapticDeviceStatisticMacro(double, TickRate, (), GetTickRate());
vtkHapticDeviceStatisticMacro(
  double, TickPercentile, (double p), GetTickCost().GetPercentile(p / 100.0) * 1e-9);
vtkHapticDeviceStatisticMacro(
  double, WakePercentile, (double p), GetWakeLatency().GetPercentile(p / 100.0) * 1e-9);
vtkHapticDeviceStatisticMacro(vtkIdType, MissedTicks, (), GetMissedTicks());
vtkHapticDeviceStatisticMacro(vtkIdType, AbsentTicks, (), GetAbsentTicks());
vtkHapticDeviceStatisticMacro(vtkIdType, UnfinishedTicks, (), GetUnfinishedTicks());
vtkHapticDeviceStatisticMacro(double, ReportPeriod, (), GetTiming().GetReportPeriod());
vtkHapticDeviceStatisticMacro(double, RoundTripTime, (), GetTiming().GetRoundTrip());
vtkHapticDeviceStateMacro(double, StiffnessCap, GetCaps().Stiffness);
vtkHapticDeviceStateMacro(double, DampingCap, GetCaps().Damping);

//------------------------------------------------------------------------------
void vtkHapticDevice::ResetStatistics()
{
  if (ServoLoop* const loop = this->Internals->Session.GetLoop())
  {
    loop->ResetStatistics();
  }
}

//------------------------------------------------------------------------------
void vtkHapticDevice::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  auto& d = *this->Internals;
  const std::string& id = d.Session.GetId();
  os << indent << "Device: " << (id.empty() ? "(none)" : id.c_str()) << "\n";
  os << indent << "Status: " << this->GetStatusText() << "\n";
  os << indent << "Clutch: " << (this->GetClutch() ? "On" : "Off") << "\n";
  os << indent << "VolumeHaptics: " << d.Models.GetFilter() << "\n";
  os << indent << "DeviceToWorld: " << d.Models.GetDeviceToWorld() << "\n";
  PrintSettings(os, indent, this, DeviceSettings);
  const std::string& file = d.Recorder.GetFile();
  os << indent << "Recording: " << (file.empty() ? "(none)" : file.c_str()) << "\n";
}
