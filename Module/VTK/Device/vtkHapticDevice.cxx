// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHapticDevice.h"

#include "VTK/Device/DeviceOrders.h"
#include "VTK/Device/DeviceRecorder.h"
#include "VTK/Device/DeviceSession.h"
#include "VTK/Device/FollowedPolyData.h"
#include "VTK/Device/HapticDeviceSettings.h"
#include "VTK/Device/ModelSource.h"
#include "VTK/Device/VirtualTip.h"
#include "VTK/Tools/NeedleTrace.h"

#include "vtkCommand.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkVolumeHapticsFilter.h"

#include <algorithm>
#include <cmath>

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
  // Observers must not receive a device that is being deleted.
  this->RemoveAllObservers();
  this->Shut();
}

//------------------------------------------------------------------------------
bool vtkHapticDevice::Open(const char* id)
{
  const vtkSmartPointer<vtkHapticDevice> self(this); // see Close
  this->Close();
  if (!this->Internals->Orders.Open(id ? id : "", this->MakeOptions()))
  {
    return false;
  }
  this->TakeLimits();
  return true;
}

//------------------------------------------------------------------------------
bool vtkHapticDevice::CalibrateForce(double scale)
{
  auto& d = *this->Internals;
  if (!d.Orders.CalibrateForce(scale))
  {
    return false;
  }
  this->TakeLimits();
  d.Orders.TellMemoryTrouble();
  return true;
}

//------------------------------------------------------------------------------
void vtkHapticDevice::TakeLimits()
{
  const DeviceLimits limits = this->Internals->Session.GetLimits();
  const auto choose = [](double wanted, double most)
  { return wanted < 0.0 ? 0.5 * most : std::min(wanted, most); };
  this->MaximumForce = choose(this->WantedForce, limits.MaximumForce);
  this->MaximumTorque = choose(this->WantedTorque, limits.MaximumTorque);
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
void vtkHapticDevice::ResetMaximumTorque()
{
  this->WantedTorque = -1.0;
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
void vtkHapticDevice::SetVolumeHaptics(vtkVolumeHapticsFilter* filter)
{
  if (this->Internals->Models.SetFilter(filter))
  {
    this->Modified();
  }
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
    d.Recorder.Stop(false); // the force is off, and the owner may be gone
  }
  d.Orders.EndPreparing();
  d.Session.Stop();
  d.Models.LetRemovalsGo();
}

//------------------------------------------------------------------------------
bool vtkHapticDevice::UpdateState()
{
  this->Internals->Recorder.Follow();
  this->Internals->Orders.Follow();
  const bool wasForbidden = this->IsAtForbiddenLabel();
  const bool isNew = this->Internals->Session.Update(this->Internals->Models.GetPlacement());
  this->Internals->Orders.TellMemoryTrouble();
  this->Internals->Orders.FollowRegion();
  this->Internals->Orders.FollowFrames();
  if (!wasForbidden && this->IsAtForbiddenLabel())
  {
    this->InvokeEvent(vtkCommand::UserEvent);
  }
  return isNew;
}

//------------------------------------------------------------------------------
bool vtkHapticDevice::IsAtForbiddenLabel()
{
  return this->Internals->Session.IsAtForbidden;
}

//------------------------------------------------------------------------------
// Functions that are those of a part.
#define vtkHapticDevicePartMacro(type, name, parameters, call) \
  type vtkHapticDevice::name parameters                        \
  {                                                            \
    return this->Internals->call;                              \
  }

vtkHapticDevicePartMacro(bool, IsOpen, (), Session.IsOpen());
vtkHapticDevicePartMacro(std::string, GetDeviceId, (), Session.GetId());
vtkHapticDevicePartMacro(bool, IsRunning, (), Session.IsRunning());
vtkHapticDevicePartMacro(int, GetStatus, (), Session.GetStatus().FindType());
vtkHapticDevicePartMacro(std::string, GetStatusText, (), Session.GetStatus().MakeText());
vtkHapticDevicePartMacro(bool, IsArmOrdered, (), Session.HasArmOrder());
vtkHapticDevicePartMacro(bool, HasTipOrientation, (), Session.GetState().HasOrientation);
vtkHapticDevicePartMacro(bool, GetClutch, (), Session.IsClutched());
vtkHapticDevicePartMacro(bool, ArmsAfterClutch, (), Session.ReturnsAfterClutch());
vtkHapticDevicePartMacro(bool, GetSignsConfirmed, (), Session.AreSignsConfirmed());
vtkHapticDevicePartMacro(bool, IsRemembered, (), Session.IsRemembered());
vtkHapticDevicePartMacro(double, GetForceScale, (), Session.GetFacts().Scale);
vtkHapticDevicePartMacro(std::string, GetCalibrationText, (), Session.DescribeCalibration());
vtkHapticDevicePartMacro(void, SetLights, (int lights), Session.SetLights(lights));
vtkHapticDevicePartMacro(int, AddReader, (), Session.AddReader());
vtkHapticDevicePartMacro(void, RemoveReader, (int reader), Session.RemoveReader(reader));

vtkHapticDevicePartMacro(vtkVolumeHapticsFilter*, GetVolumeHaptics, (), Models.GetFilter());
vtkHapticDevicePartMacro(vtkMatrix4x4*, GetDeviceToWorld, (), Models.GetDeviceToWorld());
vtkHapticDevicePartMacro(std::string, GetMethodText, (), Models.GetMethodText());
vtkHapticDevicePartMacro(bool, IsPublished, (), Models.IsUpToDate());

vtkHapticDevicePartMacro(bool, Start, (), Orders.Start());
vtkHapticDevicePartMacro(bool, Publish, (), Orders.Publish());
vtkHapticDevicePartMacro(void, Arm, (), Orders.Arm());
vtkHapticDevicePartMacro(void, Disarm, (), Orders.Disarm());
vtkHapticDevicePartMacro(void, FadeOut, (), Orders.FadeOut());
vtkHapticDevicePartMacro(void, Home, (), Orders.Home());
vtkHapticDevicePartMacro(void, SetClutch, (bool on), Orders.SetClutch(on));
vtkHapticDevicePartMacro(void, ForgetConfirmation, (), Orders.ForgetConfirmation());
vtkHapticDevicePartMacro(void, BeginLongWork, (const char* what, double expectedSeconds),
  Orders.BeginLongWork(what, expectedSeconds));
vtkHapticDevicePartMacro(void, EndLongWork, (), Orders.EndLongWork());

vtkHapticDevicePartMacro(void, Play, (), Models.GetPlayback().SetPlays(true));
vtkHapticDevicePartMacro(void, Hold, (), Models.GetPlayback().SetPlays(false));
vtkHapticDevicePartMacro(bool, IsPlaying, (), Models.GetPlayback().IsPlaying());
vtkHapticDevicePartMacro(double, GetDataTime, (), Models.GetPlayback().GetTime());
vtkHapticDevicePartMacro(bool, IsWaitingForData, (), Models.GetPlayback().IsWaiting());
vtkHapticDevicePartMacro(double, GetPlaybackSpeed, (), Models.GetPlayback().GetSpeed());
vtkHapticDevicePartMacro(bool, HasFrames, (), Models.HasFrames());
vtkHapticDevicePartMacro(vtkImageData*, GetFrameImage, (), Models.GetFrameImage());
vtkHapticDevicePartMacro(double, GetFrameTime, (), Models.GetFrameTime());

vtkHapticDevicePartMacro(void, SetVirtualButtons, (int buttons), Tip.SetButtons(buttons));
vtkHapticDevicePartMacro(double, TakeVibration, (), Session.TakeVibration());

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
vtkHapticDeviceStateMacro(double*, TipOrientation, Orientation.data());
vtkHapticDeviceStateMacro(double*, Torque, Torque);
vtkHapticDeviceStateMacro(double*, ComputedTorque, ComputedTorque);
vtkHapticDeviceStateMacro(double*, ToolOrientation, ToolOrientation.data());
vtkHapticDeviceStateMacro(int, Buttons, GetState().Buttons);
vtkHapticDeviceStateMacro(double*, TurnRate, TurnRate);
vtkHapticDeviceStateMacro(int, Contact, GetState().Record.Contact);
vtkHapticDeviceStateMacro(double, SurfaceValue, GetState().Record.SurfaceValue);
vtkHapticDeviceStateMacro(vtkTypeInt64, Label, Label);
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
bool vtkHapticDevice::IsTipOrientationMeasured()
{
  const ServoSnapshot& state = this->Internals->Session.GetState();
  return state.HasOrientation && !state.IsOrdered;
}

//------------------------------------------------------------------------------
double vtkHapticDevice::GetSlack()
{
  const DeviceSession& session = this->Internals->Session;
  const bool isHeld = session.GetState().Record.Contact != ContactState::Free;
  // Tension of the spring at the beginning of the last tick; solvers other than PRECISE leave it at
  // 1.
  const double tension = session.GetState().Before.Precise.Spring.Tension;
  return isHeld ? std::clamp(1.0 - tension, 0.0, 1.0) *
      std::sqrt(vtkMath::Distance2BetweenPoints(session.Tip, session.Proxy))
                : 0.0;
}

//------------------------------------------------------------------------------
double* vtkHapticDevice::GetModeForce(int mode)
{
  const bool isThere = mode >= 0 && mode < MostPrimitives;
  return this->Internals->Session.ModeForces[isThere ? mode : MostPrimitives];
}

//------------------------------------------------------------------------------
void vtkHapticDevice::GetFollowed(vtkPolyData* shapes, double reach)
{
  DeviceSession& session = this->Internals->Session;
  const HapticModel* const model = session.FindModel();
  if (!shapes)
  {
    vtkErrorMacro("GetFollowed() needs a polydata to write to, but got a null pointer.");
  }
  else if (model && session.GetState().Time > 0.0)
  {
    WriteFollowed(*model, session.GetState().Record.Proxy, reach, shapes);
  }
  else
  {
    shapes->Initialize();
  }
}

//------------------------------------------------------------------------------
void vtkHapticDevice::GetNeedleTrack(vtkPolyData* track)
{
  DeviceSession& session = this->Internals->Session;
  const HapticModel* const model = session.FindModel();
  if (!track)
  {
    vtkErrorMacro("GetNeedleTrack() needs a polydata to write to, but got a null pointer.");
  }
  else if (model && session.GetState().Time > 0.0)
  {
    const ServoState& before = session.GetState().Before;
    WriteNeedleTrack(*model, before.Needle, before.Proxy, track);
  }
  else
  {
    track->Initialize();
  }
}

//------------------------------------------------------------------------------
double vtkHapticDevice::GetNeedleDepth()
{
  DeviceSession& session = this->Internals->Session;
  const HapticModel* const model = session.FindModel();
  return model ? model->WorldUnitsPerMeter * session.GetState().Record.Depth : 0.0;
}

//------------------------------------------------------------------------------
void vtkHapticDevice::DrainStates(vtkTable* states, int reader)
{
  auto& d = *this->Internals;
  d.Session.DrainStates(d.Models.GetPlacement(), states, reader);
}

//------------------------------------------------------------------------------
void vtkHapticDevice::SetPlayback(int playback)
{
  const int mode = std::clamp<int>(playback, ONCE, PING_PONG);
  if (mode != this->GetPlayback())
  {
    this->Internals->Models.GetPlayback().SetMode(static_cast<Playback>(mode));
    this->Modified();
  }
}

//------------------------------------------------------------------------------
int vtkHapticDevice::GetPlayback()
{
  return static_cast<int>(this->Internals->Models.GetPlayback().GetMode());
}

//------------------------------------------------------------------------------
void vtkHapticDevice::SetPlaybackSpeed(double factor)
{
  constexpr double most = 1e6;
  if (!std::isfinite(factor))
  {
    vtkErrorMacro("The playback speed has to be a finite number, and is "
      << factor << ": it stays " << this->GetPlaybackSpeed() << ".");
    return;
  }
  const double clamped = std::clamp(factor, -most, most);
  if (clamped != this->GetPlaybackSpeed())
  {
    this->Internals->Models.GetPlayback().SetSpeed(clamped);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkHapticDevice::SetDataTime(double time)
{
  if (!std::isfinite(time))
  {
    vtkErrorMacro("The data time has to be a finite number, in the units of the source's time "
                  "steps, and is "
      << time << ": it stays " << this->GetDataTime() << ".");
    return;
  }
  this->Internals->Models.GetPlayback().SetTime(time);
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
void vtkHapticDevice::SetMaximumTorque(double torque)
{
  auto& session = this->Internals->Session;
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
  d.Orders.TellError(d.Tip.Lead({ x, y, z }, d.Models.GetPlacement()));
}

//------------------------------------------------------------------------------
void vtkHapticDevice::PlaceVirtualTip(double x, double y, double z)
{
  auto& d = *this->Internals;
  d.Orders.TellError(d.Tip.Place({ x, y, z }, d.Models.GetPlacement()));
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
void vtkHapticDevice::SetVirtualTipOrientation(double w, double x, double y, double z)
{
  auto& d = *this->Internals;
  d.Orders.TellError(d.Tip.Turn({ w, x, y, z }, d.Models.GetPlacement()));
}

//------------------------------------------------------------------------------
void vtkHapticDevice::SetVirtualTipOrientation(const double wxyz[4])
{
  if (!wxyz)
  {
    vtkErrorMacro("SetVirtualTipOrientation() needs four numbers, but got a null pointer; the "
                  "stylus stays as it is.");
    return;
  }
  this->SetVirtualTipOrientation(wxyz[0], wxyz[1], wxyz[2], wxyz[3]);
}

//------------------------------------------------------------------------------
void vtkHapticDevice::SetTipOrientation(double w, double x, double y, double z)
{
  auto& d = *this->Internals;
  d.Orders.TellError(d.Tip.TurnHand({ w, x, y, z }, d.Models.GetPlacement()));
}

//------------------------------------------------------------------------------
void vtkHapticDevice::SetSpinning(bool spinning)
{
  this->Internals->Session.Spin(spinning);
}

//------------------------------------------------------------------------------
bool vtkHapticDevice::GetSpinning()
{
  return this->Internals->Session.IsSpinOrdered();
}

//------------------------------------------------------------------------------
bool vtkHapticDevice::IsSpinning()
{
  return this->Internals->Session.GetState().Before.IsSpinning;
}

//------------------------------------------------------------------------------
void vtkHapticDevice::SetVirtualDynamics(
  double mass, double damping, double handStiffness, double encoderQuantum, int forceDelay)
{
  auto& d = *this->Internals;
  d.Orders.TellError(d.Tip.SetDynamics(mass, damping, handStiffness, encoderQuantum, forceDelay));
}

//------------------------------------------------------------------------------
void vtkHapticDevice::SetVirtualLimits(
  double maximumForce, double maximumStiffness, double maximumDamping, double friction)
{
  auto& d = *this->Internals;
  const std::string error =
    d.Tip.SetLimits(maximumForce, maximumStiffness, maximumDamping, friction);
  if (error.empty())
  {
    this->TakeLimits();
  }
  d.Orders.TellError(error);
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
  os << indent << "Playback: " << this->GetPlayback() << "\n";
  os << indent << "PlaybackSpeed: " << this->GetPlaybackSpeed() << "\n";
  os << indent << "DataTime: " << this->GetDataTime() << "\n";
  const std::string& file = d.Recorder.GetFile();
  os << indent << "Recording: " << (file.empty() ? "(none)" : file.c_str()) << "\n";
}
