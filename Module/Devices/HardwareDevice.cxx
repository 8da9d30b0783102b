// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "HardwareDevice.h"

#include "ServoClock.h"

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
}

bool HardwareDevice::Open(std::string& error)
{
  this->Close();
  if (!this->Driver->Connect(error))
  {
    return false;
  }
  this->Exchange.Begin();
  try
  {
    this->Thread = std::thread([this] { this->Run(); });
  }
  catch (const std::system_error& e)
  {
    error = std::string("No thread could be started for the device: ") + e.what() + ".";
    this->Driver->Disconnect();
    return false;
  }
  return true;
}

void HardwareDevice::Run()
{
  ServoClock::BlockSignals();
  ServoClock::RaisePriority();
  try
  {
    this->Driver->Serve(this->Exchange);
  }
  catch (const std::exception& e)
  {
    // Such as no memory: the device's own watchdog is what is left.
    this->Exchange.SetCondition(DeviceStage::Lost, e.what());
  }
}

void HardwareDevice::Close()
{
  if (this->Thread.joinable())
  {
    this->Exchange.Quench();
    this->Exchange.RequestStop();
    this->Thread.join();
    this->Driver->Disconnect();
  }
}

} // namespace VolumeHaptics
