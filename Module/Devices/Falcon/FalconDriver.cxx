// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/Falcon/FalconDriver.h"

#include "Core/Math/NumberText.h"
#include "Core/Realtime/ServoClock.h"
#include "Devices/Falcon/FalconController.h"
#include "Devices/Falcon/FalconFirmware.h"
#include "Devices/Falcon/FalconRounds.h"
#include "Devices/Falcon/FalconSerial.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace VolumeHaptics
{
namespace
{

/** Packets, 50 ms each. If none is answered, the device has no firmware. */
constexpr int ProbePackets = 5;
constexpr double MicrosecondsPerSecond = 1e6;
constexpr std::int64_t QuietTime = 20000000; // ns

const char* const GoneText =
  "The device was unplugged. Plug it in, then Close(), Open(), Start() and Arm() it again.";

const char* TroubleText(UsbOutcome trouble) noexcept
{
  return trouble == UsbOutcome::Stalled
    ? "The device refused a transfer (a stall). Home() and Arm() again; if that does not help, "
      "plug it in again."
    : "A transfer to or from the device failed. Check its cable, then Home() and Arm() again.";
}

} // namespace

FalconDriver::FalconDriver(int number, DeviceOptions options)
  : Number(number)
  , Options(std::move(options))
  , Name(FalconProduct.Name)
{
}

std::vector<std::string> FalconDriver::MakeWords(int number, const DeviceOptions& options)
{
  // Integers are written alike in all locales. Centuries are as good as for ever.
  const double time = std::clamp(options.HomingTime, 0.0, 1e9) * MicrosecondsPerSecond;
  return { "falcon", std::to_string(number), std::to_string(std::llround(time)),
    options.FirmwareFile };
}

std::unique_ptr<HardwareDriver> FalconDriver::MakeFromWords(
  const std::vector<std::string>& words, std::string& error)
{
  if (words.size() != 4 || words[0] != "falcon")
  {
    error = "This is not a Novint Falcon.";
    return nullptr;
  }
  DeviceOptions options;
  options.HomingTime = ParseNumber(words[2]).value_or(0.0) / MicrosecondsPerSecond;
  options.FirmwareFile = words[3];
  return std::make_unique<FalconDriver>(std::atoi(words[1].c_str()), options);
}

DeviceLimits FalconDriver::GetLimits() const
{
  return FalconLimits();
}

std::string FalconDriver::GetIdentity() const
{
  // A guard may have the device: look for it anew.
  std::string error;
  const UsbContext context = MakeUsbContext(error);
  const std::vector<UsbDevice> devices =
    context ? FindUsbDevices(context.get(), FalconProduct) : std::vector<UsbDevice>();
  const auto number = static_cast<std::size_t>(this->Number);
  return number < devices.size() ? UsbIdentityOf(devices[number].get(), "falcon") : "falcon";
}

bool FalconDriver::Connect(std::string& error)
{
  if (!this->Usb.Open(FalconProduct, this->Number, error))
  {
    return false;
  }
  this->Name = UsbNameOf(libusb_get_device(this->Usb.GetHandle()), FalconProduct);
  this->Firmware.clear();
  FalconSerial serial(this->Usb);
  bool isFine = serial.Runs(ProbePackets);
  if (!isFine && serial.GetError() < 0 && serial.GetError() != LIBUSB_ERROR_TIMEOUT)
  {
    error =
      "The " + this->Name + " can't be opened: " + UsbTroubleText(serial.GetError(), FalconProduct);
  }
  else if (!isFine)
  {
    isFine = ReadFalconFirmware(this->Options.FirmwareFile, this->Firmware, error);
  }
  if (!isFine)
  {
    this->Usb.Close();
  }
  return isFine;
}

void FalconDriver::Serve(HardwareExchange& exchange)
{
  while (!exchange.MustStop())
  {
    End end = this->Firmware.empty() ? End::Done : this->Load(exchange);
    if (end == End::Done)
    {
      end = this->Talk(exchange);
    }
    if (end == End::Gone)
    {
      exchange.SetCondition(DeviceStage::Lost, GoneText);
    }
    // Homing does not bring back an unplugged device.
    while (!exchange.MustStop() && (end == End::Gone || !exchange.TakeHomeRequest()))
    {
      if (end == End::Gone)
      {
        exchange.RefuseHomeRequest(GoneText);
      }
      ServoClock::SleepUntil(ServoClock::Now() + QuietTime);
    }
  }
}

FalconDriver::End FalconDriver::Load(HardwareExchange& exchange)
{
  FalconSerial serial(this->Usb);
  std::string trouble;
  switch (LoadFalcon(serial, this->Firmware, exchange, trouble))
  {
    case FalconLoading::Loaded:
      this->Firmware.clear();
      return End::Done;
    case FalconLoading::Gone:
      return End::Gone;
    case FalconLoading::Stopped:
      return End::Failed;
    case FalconLoading::Failed:
      break;
  }
  const std::string text = "Loading the firmware " + trouble +
    ". Check that the file is this device's image, switch the device off and on, and Home() to try "
    "again.";
  exchange.SetCondition(DeviceStage::Lost, text.c_str());
  return End::Failed;
}

FalconDriver::End FalconDriver::Talk(HardwareExchange& exchange)
{
  FalconController controller(exchange, this->Options.HomingTime);
  FalconRounds rounds(this->Usb, exchange);
  std::int64_t last = ServoClock::Now();
  while (!exchange.MustStop())
  {
    rounds.Wait();
    if (rounds.GetTrouble() == UsbOutcome::Gone)
    {
      return End::Gone;
    }
    if (rounds.GetTrouble() > UsbOutcome::Cancelled)
    {
      controller.Lose(TroubleText(rounds.GetTrouble()));
    }
    if (exchange.HasSlept())
    {
      controller.Stop();
    }
    if (exchange.TakeHomeRequest())
    {
      controller.Restart();
    }
    if (rounds.HasReport() || rounds.HasMissed())
    {
      const std::int64_t now = ServoClock::Now();
      const double elapsed = static_cast<double>(now - last) * ServoClock::SecondsPerNanosecond;
      last = now;
      rounds.HasReport() ? controller.Take(rounds.GetReport(), elapsed)
                         : controller.Miss(elapsed, rounds.GetGarbage());
    }
    if (rounds.IsDue())
    {
      rounds.Send(controller.GetOrder());
    }
  }
  return End::Done;
}

} // namespace VolumeHaptics
