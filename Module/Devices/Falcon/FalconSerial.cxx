// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/Falcon/FalconSerial.h"

#include "Core/Realtime/ServoClock.h"
#include "Devices/Falcon/FalconLoader.h"
#include "Devices/Falcon/FalconStream.h"

#include <algorithm>
#include <cstdio>

namespace VolumeHaptics
{
namespace
{

// Times in ms.
constexpr unsigned int RequestTime = 500;
constexpr unsigned int ReportTime = 50;
constexpr unsigned int GreetingTime = 30; // sufficient at 9600 baud with a latency of 16 ms
constexpr unsigned int AnswerTime = 500;
// Number of packets (2 s) within which newly loaded firmware should answer.
constexpr int PacketsAfterLoading = 40;
constexpr std::int64_t NanosecondsPerMillisecond = 1000000;

/** Reports the progress. `trouble` is the reason why the last attempt failed. */
void ReportProgress(
  HardwareExchange& exchange, int attempt, const std::string& trouble, int percent)
{
  char text[160];
  if (attempt == 1)
  {
    std::snprintf(text, sizeof(text), "Loading the firmware: %d %%", percent);
  }
  else
  {
    std::snprintf(text, sizeof(text), "Loading the firmware, try %d of %d since %s: %d %%", attempt,
      FalconLoadingTries, trouble.c_str(), percent);
  }
  exchange.SetCondition(DeviceStage::Firmware, text);
}

/** Executes a step of the loader. Returns false if the device is gone. */
bool Advance(FalconSerial& serial, FalconLoader& loader)
{
  const FalconLoaderStep step = loader.GetStep();
  bool done = true;
  if (step.What == FalconLoaderStep::Kind::Request)
  {
    done = serial.Request(step.Request);
    done ? loader.Done() : loader.Refuse();
  }
  else if (step.What == FalconLoaderStep::Kind::Write)
  {
    done = serial.Write(step.Bytes, step.Size);
    done ? loader.Done() : loader.Refuse();
  }
  else if (step.What == FalconLoaderStep::Kind::Read)
  {
    std::array<std::uint8_t, FtdiPacketSize> bytes;
    const int size = serial.Read(bytes, step.MayStayOpen ? GreetingTime : AnswerTime);
    done = size >= 0;
    !done         ? loader.Refuse()
      : size == 0 ? loader.TimeOut()
                  : loader.Receive(bytes.data(), static_cast<std::size_t>(size));
  }
  return done || serial.GetError() != LIBUSB_ERROR_NO_DEVICE;
}

bool IsOver(const FalconLoader& loader) noexcept
{
  const FalconLoaderStep::Kind what = loader.GetStep().What;
  return what == FalconLoaderStep::Kind::Finished || what == FalconLoaderStep::Kind::Failed;
}

/**
 * Makes one attempt to load the firmware. Loaded means that the whole image was echoed, but not yet
 * that the firmware runs.
 */
FalconLoading TryToLoad(FalconSerial& serial, const std::vector<std::uint8_t>& image, int attempt,
  HardwareExchange& exchange, std::string& trouble)
{
  FalconLoader loader(image.data(), image.size());
  int told = -1;
  while (!IsOver(loader))
  {
    if (exchange.MustStop() || exchange.HasSlept())
    {
      return FalconLoading::Stopped;
    }
    const auto percent = static_cast<int>(100 * loader.GetConfirmed() / image.size());
    if (percent != told)
    {
      told = percent;
      ReportProgress(exchange, attempt, trouble, percent);
    }
    if (!Advance(serial, loader))
    {
      return FalconLoading::Gone;
    }
  }
  if (loader.GetFault() != FalconLoaderFault::None)
  {
    trouble = FalconLoaderFaultText(loader.GetFault());
    return FalconLoading::Failed;
  }
  return FalconLoading::Loaded;
}

FalconLoading WaitUntilItRuns(
  FalconSerial& serial, HardwareExchange& exchange, std::string& trouble)
{
  for (int i = 0; i < PacketsAfterLoading && !exchange.MustStop(); ++i)
  {
    if (serial.Runs(1))
    {
      return FalconLoading::Loaded;
    }
    if (serial.GetError() == LIBUSB_ERROR_NO_DEVICE)
    {
      return FalconLoading::Gone;
    }
  }
  trouble = "failed: the firmware was loaded, but does not answer";
  return exchange.MustStop() ? FalconLoading::Stopped : FalconLoading::Failed;
}

} // namespace

bool FalconSerial::Reopen() noexcept
{
  this->Error = this->Usb.Reopen();
  return this->Error >= 0;
}

bool FalconSerial::Request(const FtdiRequest& request) noexcept
{
  this->Error = this->Usb.Control(
    request.RequestType, request.Request, request.Value, request.Index, RequestTime);
  return this->Error >= 0;
}

bool FalconSerial::Write(const std::uint8_t* bytes, std::size_t size) noexcept
{
  std::array<std::uint8_t, FtdiPacketSize> copy;
  size = std::min(size, copy.size());
  std::copy(bytes, bytes + size, copy.begin());
  const int done = this->Usb.Transfer(FalconOut, copy.data(), size, RequestTime);
  this->Error = std::min(done, 0);
  return done == static_cast<int>(size);
}

int FalconSerial::Read(std::array<std::uint8_t, FtdiPacketSize>& bytes, unsigned int time) noexcept
{
  const std::int64_t end = ServoClock::Now() + time * NanosecondsPerMillisecond;
  for (std::int64_t left = 1; left > 0;)
  {
    left = end - ServoClock::Now();
    const auto wait =
      static_cast<unsigned int>(std::max<std::int64_t>(left, 0) / NanosecondsPerMillisecond + 1);
    std::array<std::uint8_t, FtdiPacketSize> packet;
    const int done = this->Usb.Transfer(FalconIn, packet.data(), packet.size(), wait);
    this->Error = std::min(done, 0);
    if (done < 0)
    {
      return done == LIBUSB_ERROR_TIMEOUT ? 0 : done;
    }
    const std::uint8_t* place = packet.data();
    auto size = static_cast<std::size_t>(done);
    const FtdiPayload payload = DrainFtdiPacket(place, size);
    if (payload.Size > 0)
    {
      std::copy(payload.Bytes, payload.Bytes + payload.Size, bytes.begin());
      return static_cast<int>(payload.Size);
    }
  }
  return 0;
}

bool FalconSerial::Runs(int packets) noexcept
{
  for (const FtdiRequest& request : FalconRunRequests)
  {
    if (!this->Request(request))
    {
      return false;
    }
  }
  const FalconPacket zero = FalconRunPacket({});
  FalconStream stream;
  for (int i = 0; i < packets; ++i)
  {
    if (!this->Write(zero.data(), zero.size()))
    {
      return false;
    }
    std::array<std::uint8_t, FtdiPacketSize + FtdiStatusSize> transfer{};
    std::array<std::uint8_t, FtdiPacketSize> bytes;
    FalconReport report;
    // Limit the time even if the device keeps sending bytes that form no report.
    const std::int64_t end = ServoClock::Now() + ReportTime * NanosecondsPerMillisecond;
    for (int size = 1; size > 0 && ServoClock::Now() < end;)
    {
      size = this->Read(bytes, ReportTime);
      if (size < 0)
      {
        return false;
      }
      std::copy(bytes.begin(), bytes.begin() + size, transfer.begin() + FtdiStatusSize);
      if (stream.Receive(transfer.data(), static_cast<std::size_t>(size) + FtdiStatusSize, report) >
        0)
      {
        return true;
      }
    }
  }
  return false;
}

FalconLoading LoadFalcon(FalconSerial& serial, const std::vector<std::uint8_t>& image,
  HardwareExchange& exchange, std::string& trouble)
{
  FalconLoading loading = FalconLoading::Failed;
  for (int attempt = 1; attempt <= FalconLoadingTries && loading == FalconLoading::Failed;
       ++attempt)
  {
    const bool isFresh = attempt == 1 && serial.IsOpen();
    if (!isFresh && !serial.Reopen())
    {
      trouble = "failed: the device can't be opened again";
      return serial.GetError() == LIBUSB_ERROR_NO_DEVICE ? FalconLoading::Gone
                                                         : FalconLoading::Failed;
    }
    loading = TryToLoad(serial, image, attempt, exchange, trouble);
  }
  if (loading == FalconLoading::Loaded)
  {
    return WaitUntilItRuns(serial, exchange, trouble);
  }
  trouble =
    "failed " + std::to_string(FalconLoadingTries) + " times, the last time because " + trouble;
  return loading;
}

} // namespace VolumeHaptics
