// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Device/DeviceOrders.h"

#include "Core/Platform/HapticFiles.h"

#include "vtkCommand.h"
#include "vtkHapticDevice.h"
#include "vtkSmartPointer.h"
#include "vtkVolumeHapticsFilter.h"

#include <algorithm>
#include <exception>
#include <memory>
#include <new>
#include <system_error>
#include <utility>

namespace VolumeHaptics
{
namespace
{

const char* const CureForNoGuard = ". Close files or end threads of this program, or raise its "
                                   "limits (ulimit -n, ulimit -u), and try again.";

} // namespace

void DeviceOrders::ReportError(const std::string& error)
{
  if (!error.empty())
  {
    vtkErrorWithObjectMacro(this->Device, << error);
  }
}

void DeviceOrders::ReportMemoryTrouble()
{
  this->ReportError(Printable(this->Session.DrainMemoryTrouble()));
}

bool DeviceOrders::Open(const std::string& id, const DeviceOptions& options)
{
  std::string error;
  if (!this->Session.Open(id, options, error))
  {
    vtkErrorWithObjectMacro(this->Device, << Printable(error));
    return false;
  }
  this->ReportMemoryTrouble();
  return true;
}

void DeviceOrders::ForgetConfirmation()
{
  if (!this->Session.IsOpen() || this->Session.IsRunning())
  {
    this->ReportError("ForgetConfirmation() is for an open device whose servo does not run: Open() "
                      "it and Stop() it first.");
    return;
  }
  this->Session.ForgetConfirmation();
  this->ReportMemoryTrouble();
}

bool DeviceOrders::CalibrateForce(double scale)
{
  if (!this->Session.HasFacts() || this->Session.IsRunning())
  {
    this->ReportError(
      "CalibrateForce() is for an open real device that gives force and whose servo "
      "does not run: Open() it and Stop() it first.");
    return false;
  }
  if (!(scale >= DeviceFacts::LeastScale && scale <= DeviceFacts::MostScale))
  {
    vtkErrorWithObjectMacro(this->Device,
      << "The device can't give " << scale << " N for each newton: the scale has to be "
      << DeviceFacts::LeastScale << " to " << DeviceFacts::MostScale << ". Measure it again.");
    return false;
  }
  this->Session.SetForceScale(scale);
  return true;
}

SafetyLimits DeviceOrders::MakeLimits() const
{
  SafetyLimits limits;
  limits.MaximumForce = this->Device->GetMaximumForce();
  limits.MaximumForceRate = this->Device->GetMaximumForceRate();
  limits.MaximumTorque = this->Device->GetMaximumTorque();
  limits.TransientGain = this->Device->GetTransientGain();
  limits.AttentionTime = this->Device->GetAttentionTime();
  limits.MaximumSpeed = this->Session.GetLimits().MaximumSpeed;
  limits.MovesTip = this->Session.GetLimits().MovesTip;
  limits.MaximumDamping = this->Session.GetLimits().MaximumDamping;
  return limits;
}

void DeviceOrders::SendLimits()
{
  if (ServoLoop* const loop = this->Session.GetLoop())
  {
    loop->Attend();
    loop->SetLimits(this->MakeLimits());
  }
}

bool DeviceOrders::Start()
{
  const bool isStarted = this->StartServo();
  if (!this->Session.IsRunning())
  {
    this->Models.LetRemovalsGo();
  }
  return isStarted;
}

bool DeviceOrders::StartServo()
{
  const vtkSmartPointer<vtkHapticDevice> device(this->Device);
  if (this->Session.IsRunning())
  {
    return true;
  }
  const int opening = this->Session.GetOpening();
  const double rate = device->GetServoRate();
  std::shared_ptr<const HapticModel> model;
  // Leave slow work to the background; Poll() publishes its result.
  const char* const awaited = this->Session.IsOpen() ? this->Models.Prepare(rate) : nullptr;
  if (this->Session.IsOpen() && !awaited && !this->Models.Make(rate, model))
  {
    return false;
  }
  // Observers of the progress events may have started or closed the device, or opened another one.
  if (this->Session.IsRunning())
  {
    return true;
  }
  if (!this->Session.IsOpen())
  {
    vtkErrorWithObjectMacro(
      device, "No device is open. Open one first, for example with Open(\"virtual\").");
    return false;
  }
  if (this->Session.GetOpening() != opening)
  {
    vtkErrorWithObjectMacro(
      device, "The device was closed or replaced while it was being started: Start() again.");
    return false;
  }
  const Affine3 placement = model ? model->DeviceToWorld : this->Models.GetPlacement();
  try
  {
    this->Session.Start(device->GetServoRate(), this->MakeLimits(), std::move(model), placement);
    this->Models.GetPlayback().Begin();
    this->Models.TakeLead();
    this->SetAwaited(awaited);
  }
  catch (const std::bad_alloc&)
  {
    vtkErrorWithObjectMacro(device,
      "There is not enough memory to start the servo. Close other programs that need memory.");
    return false;
  }
  catch (const std::system_error& error)
  {
    vtkErrorWithObjectMacro(device,
      << "The servo does not start, since a crash of this program would leave the force on: "
      << error.what() << CureForNoGuard);
    return false;
  }
  return true;
}

bool DeviceOrders::Publish()
{
  const vtkSmartPointer<vtkHapticDevice> device(this->Device);
  this->Session.Attend();
  const double rate = this->Session.IsRunning() ? this->Session.GetRate() : device->GetServoRate();
  const char* const awaited = this->Models.Prepare(rate);
  this->SetAwaited(awaited);
  if (awaited)
  {
    this->PublishRegion(rate);
    return true; // Poll() will publish the model
  }
  std::shared_ptr<const HapticModel> model;
  if (!this->Models.Make(rate, model))
  {
    return false;
  }
  if (TickCollector* const ticks = this->Session.GetTicks())
  {
    if (ticks->IsRecording() && model && !model->Resident.IsWhole())
    {
      vtkErrorWithObjectMacro(device,
        "A recording is under way, and recordings can't be of a region of a larger "
        "volume: no single image could replay them. Stop() the recorder first.");
      return false;
    }
    if (ticks->IsRecording() && model && model->Baked->IsForAPoint)
    {
      vtkErrorWithObjectMacro(device,
        "A recording is under way, and the filter can't replay a hand that feels with a point "
        "while another one holds its tool. Stop() the recorder first.");
      return false;
    }
    ticks->Publish(std::move(model));
  }
  else
  {
    this->Models.LetRemovalsGo();
  }
  return true;
}

void DeviceOrders::PublishRegion(double rate)
{
  TickCollector* const ticks = this->Session.GetTicks();
  if (ticks && !ticks->IsRecording()) // do not replace the model during a recording: recordings
                                      // contain no regions
  {
    if (std::shared_ptr<const HapticModel> model = this->Models.MakeRegion(rate))
    {
      ticks->Publish(std::move(model));
    }
  }
}

void DeviceOrders::SetAwaited(const char* work)
{
  if (this->Awaited)
  {
    this->Session.SetBackgroundWork(this->Awaited, WorkEnded);
  }
  this->Awaited = work;
  if (work)
  {
    this->Session.SetBackgroundWork(work, FractionUnknown);
  }
}

void DeviceOrders::EndPreparing()
{
  this->SetAwaited(nullptr);
  this->Models.EndPreparing();
}

void DeviceOrders::Poll()
{
  this->Models.LetUnusedRemovalsGo();
  if (this->Models.IsAwaited() && this->Session.IsRunning())
  {
    this->Publish();
  }
}

void DeviceOrders::PollTimeSteps()
{
  const vtkSmartPointer<vtkHapticDevice> device(this->Device);
  TickCollector* const ticks = this->Session.GetTicks();
  if (ticks && !this->Models.IsAwaited() && // Poll() publishes the awaited model instead
    (this->Models.LacksTimeSteps() || this->Models.IsBehind()))
  {
    this->Publish();
  }
  else if (ticks)
  {
    // Observers of the time steps' source may have stopped the servo.
    std::shared_ptr<const HapticModel> model = this->Models.PollTimeSteps();
    if (model && ticks == this->Session.GetTicks())
    {
      ticks->Publish(std::move(model));
    }
  }
  this->Session.SetTimeStepsStatus(this->Models.GetPlayback().Describe());
}

void DeviceOrders::PollRegion()
{
  std::string status;
  const bool hasCome = this->Session.IsRunning() && this->Models.PollRegion(status);
  this->Session.SetRegionStatus(status);
  if (hasCome)
  {
    this->Publish();
  }
}

bool DeviceOrders::LetForceThrough(const std::function<void()>& order)
{
  if (!this->Session.IsReady())
  {
    vtkErrorWithObjectMacro(
      this->Device, << "It can't be armed yet. " << this->Session.GetStatus().MakeText());
    return false;
  }
  try
  {
    order();
    return true;
  }
  catch (const std::exception& error)
  {
    vtkErrorWithObjectMacro(this->Device,
      << "The device is not armed, since a crash of this program would leave the force on: "
      << error.what() << CureForNoGuard);
    return false;
  }
}

void DeviceOrders::Arm()
{
  this->LetForceThrough([this] { this->Session.Arm(true); });
}

void DeviceOrders::SetClutch(bool on)
{
  if (on == this->Session.IsClutched())
  {
    return;
  }
  if (on)
  {
    this->Session.SetClutched(true);
    this->AnnounceDisarmed();
  }
  else if (!this->Session.ReturnsAfterClutch())
  {
    this->Session.SetClutched(false);
  }
  else if (!this->LetForceThrough([this] { this->Session.SetClutched(false); }))
  {
    this->Session.Arm(false);
    this->Session.SetClutched(false);
  }
}

void DeviceOrders::AnnounceDisarmed()
{
  // Guard against endless recursion: observers may disarm the device again, by Stop, Close, Open or
  // Home.
  if (this->IsAnnouncing || !this->Device->HasObserver(vtkCommand::DisableEvent))
  {
    return;
  }
  const vtkSmartPointer<vtkHapticDevice> device(this->Device);
  this->IsAnnouncing = true;
  device->InvokeEvent(vtkCommand::DisableEvent);
  this->IsAnnouncing = false;
}

void DeviceOrders::Disarm()
{
  this->Session.Arm(false);
  this->AnnounceDisarmed();
}

void DeviceOrders::FadeOut()
{
  this->Session.FadeOut();
  this->AnnounceDisarmed();
}

void DeviceOrders::Home()
{
  this->Session.Home();
  this->AnnounceDisarmed();
}

void DeviceOrders::BeginLongWork(const char* what, double expectedSeconds)
{
  // Announce only work that may take longer than a slow frame. The margin allows for a machine that
  // is eight times slower than expected.
  constexpr double shortest = 0.25;
  constexpr double margin = 8.0;
  const double attention = this->Device->GetAttentionTime();
  const double limit = attention > 0.0 ? std::min(shortest, attention / margin) : shortest;
  this->Session.Attend();
  const bool isLong = !(expectedSeconds < limit);
  const bool begins = this->Session.BeginWork(what && *what ? what : "the program works", isLong);
  if (begins && this->Device->HasObserver(vtkCommand::StartEvent))
  {
    const vtkSmartPointer<vtkHapticDevice> device(this->Device);
    device->InvokeEvent(vtkCommand::StartEvent);
  }
}

void DeviceOrders::EndLongWork()
{
  if (!this->Session.HasWork())
  {
    vtkErrorWithObjectMacro(this->Device, "No long work is under way: BeginLongWork() first.");
    return;
  }
  if (this->Session.EndWork() && this->Device->HasObserver(vtkCommand::EndEvent))
  {
    const vtkSmartPointer<vtkHapticDevice> device(this->Device);
    device->InvokeEvent(vtkCommand::EndEvent);
  }
}

} // namespace VolumeHaptics
