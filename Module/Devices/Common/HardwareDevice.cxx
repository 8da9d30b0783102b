// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/Common/HardwareDevice.h"

#include "Core/Realtime/ServoClock.h"

#include <exception>
#include <system_error>

namespace VolumeHaptics
{

HardwareDevice::HardwareDevice(std::unique_ptr<HardwareDriver> driver)
  : Driver(std::move(driver))
{
}

HardwareDevice::~HardwareDevice()
{
  this->Close();
  if (this->IsAbandoned)
  {
    static_cast<void>(this->Driver.release()); // its destructor would end the parent's connection
  }
}

bool HardwareDevice::Open(std::string& error)
{
  this->Close();
  if (this->IsAbandoned)
  {
    error = "The device is in use by the process that this one was forked from. Open() it before "
            "or after, not in both.";
    return false;
  }
  if (!this->Driver->Connect(error))
  {
    return false;
  }
  this->Exchange.Begin();
  try
  {
    this->Process = ServoClock::GetProcess();
    this->Priority = std::make_unique<ServoPriority>();
    this->Thread = std::thread([this] { this->Run(); });
  }
  catch (const std::system_error& e)
  {
    error = std::string("No thread could be started for the device: ") + e.what() + ".";
    this->Driver->Disconnect();
    return false;
  }
  this->SeekPriority();
  return true;
}

void HardwareDevice::SeekPriority()
{
  try
  {
    this->Request = std::thread(
      [this]
      {
        ServoClock::BlockSignals();
        this->Priority->AskRealtimeKit();
      });
  }
  catch (const std::system_error&) // the device works without the request
  {
  }
}

void HardwareDevice::Run()
{
  ServoClock::BlockSignals();
  this->Priority->Raise();
  try
  {
    this->Driver->Serve(this->Exchange);
  }
  catch (const std::exception& e)
  {
    // Memory may have run out, for example. Then only the device's own watchdog can end the force.
    this->Exchange.SetCondition(DeviceStage::Lost, e.what());
  }
}

void HardwareDevice::Close()
{
  if (this->Thread.joinable() && this->Process != ServoClock::GetProcess())
  {
    // The threads do not exist in this process, so they can neither be joined nor detached: leak
    // them.
    static_cast<void>(new std::thread(std::move(this->Thread)));
    static_cast<void>(new std::thread(std::move(this->Request)));
    this->IsAbandoned = true;
  }
  if (this->Thread.joinable())
  {
    this->Exchange.Quench();
    this->Exchange.RequestStop();
    this->Priority->RequestStop();
    this->Thread.join();
    if (this->Request.joinable())
    {
      this->Request.join();
    }
    this->Driver->Disconnect();
  }
}

} // namespace VolumeHaptics
