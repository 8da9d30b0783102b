// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/Falcon/FalconDriver.h"

#include "Core/Math/NumberText.h"
#include "Core/Realtime/ServoClock.h"
#include "Devices/Common/DeviceTexts.h"
#include "Devices/Common/HardwareExchange.h"
#include "Devices/Falcon/FalconController.h"
#include "Devices/Falcon/FalconFirmware.h"
#include "Devices/Falcon/FalconSerial.h"
#include "Devices/Falcon/FalconStream.h"
#include "Devices/Falcon/FalconTurns.h"
#include "Devices/Transport/Usb/UsbEvents.h"
#include "Devices/Transport/Usb/UsbTransfer.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

namespace VolumeHaptics
{
namespace
{

/**
 * Exchanges run packets with a Novint Falcon at the servo's pace.
 *
 * A packet is sent as soon as the servo has a force, provided that it is the host's turn
 * (FalconTurns.h). Without a force, a packet is sent every 2 ms, so that homing continues and zero
 * is renewed. IN transfers are always pending. All memory is allocated before the first round.
 */
class FalconRounds final : public UsbTransferOwner
{
public:
  /** Longest time (ns) without a packet. */
  static constexpr std::int64_t IdleTime = 2000000;

  /** The interface and the exchange must outlive this object. */
  FalconRounds(UsbInterface& usb, HardwareExchange& exchange);
  /**
   * If the device is connected, sends zero commands, and waits for a fraction of a second at most
   * until they are sent.
   */
  ~FalconRounds();

  /** Waits until an event arrives or a deadline expires. */
  void Wait() noexcept;

  ///@{
  /** Return the event that has ended the last Wait(). */
  bool HasReport() const noexcept { return this->Reported; }
  const FalconReport& GetReport() const noexcept { return this->Report; }
  /**
   * HasMissed() returns whether a packet was not answered in time. GetGarbage() returns why
   * received bytes were dropped, or nullptr.
   */
  bool HasMissed() const noexcept { return this->Missed; }
  const char* GetGarbage() const noexcept;
  /**
   * Returns the worst result of the transfers during the last Wait(), and of submitting transfers
   * since the previous Wait().
   */
  UsbOutcome GetTrouble() const noexcept { return this->Trouble; }
  ///@}

  /** Returns whether a packet must be sent now. */
  bool IsDue() noexcept;
  void Send(const FalconOrder& order) noexcept;

private:
  struct Transfers
  {
    Transfers(UsbInterface& usb, UsbTransferOwner& owner);
    bool AreFlying() const noexcept;

    UsbTransfer Out;
    UsbTransfer First;
    UsbTransfer Second;
  };

  void TransferEnded(UsbTransfer& transfer, UsbOutcome outcome) noexcept override;
  bool Submit(UsbTransfer& transfer, std::size_t size) noexcept;
  void PostReceivers() noexcept;
  void Record(UsbOutcome outcome) noexcept;
  bool IsPending() noexcept;
  template <typename F>
  void WaitWhile(F&& holds, std::int64_t time) noexcept;
  void Finish() noexcept;

  UsbInterface& Usb;
  HardwareExchange& Exchange;
  UsbEvents Events;
  std::unique_ptr<Transfers> Flight;
  FalconStream Stream;
  FalconReport Report;
  std::uint32_t DroppedBefore = 0; ///< value of GetDropped() at the last report
  FalconTurns Turns;
  std::int64_t SentAt = 0;
  bool Woken = false;
  bool Reported = false;
  bool Missed = false;
  UsbOutcome TroubleSoFar = UsbOutcome::Done;
  UsbOutcome Trouble = UsbOutcome::Done;
  bool OutStalled = false;
  bool InStalled = false;
};

// Times in ns.
constexpr std::int64_t LastPacketTime = 100 * ServoClock::Millisecond;
constexpr std::int64_t CancelTime = 500 * ServoClock::Millisecond;

FalconRounds::Transfers::Transfers(UsbInterface& usb, UsbTransferOwner& owner)
  : Out(usb, FalconOut, owner)
  , First(usb, FalconIn, owner)
  , Second(usb, FalconIn, owner)
{
}

bool FalconRounds::Transfers::AreFlying() const noexcept
{
  return this->Out.IsFlying() || this->First.IsFlying() || this->Second.IsFlying();
}

FalconRounds::FalconRounds(UsbInterface& usb, HardwareExchange& exchange)
  : Usb(usb)
  , Exchange(exchange)
  , Events(usb, exchange)
  , Flight(std::make_unique<Transfers>(usb, *this))
{
  this->Submit(this->Flight->First, UsbTransfer::Capacity);
  this->Submit(this->Flight->Second, UsbTransfer::Capacity);
}

FalconRounds::~FalconRounds()
{
  this->Finish();
  if (this->Flight->AreFlying())
  {
    // The system still uses the transfers, and only closing the device releases them, so leak them.
    static_cast<void>(this->Flight.release());
  }
}

void FalconRounds::Wait() noexcept
{
  this->Reported = false;
  this->Missed = false;
  const std::int64_t end = this->IsPending() ? this->Turns.GetDeadline() : this->SentAt + IdleTime;
  this->Woken = this->Events.Wait(this->IsDue() ? 0 : end - ServoClock::Now()) || this->Woken;
  if (this->Reported)
  {
    this->DroppedBefore = this->Stream.GetDropped();
  }
  else if (this->Turns.CheckMissed(ServoClock::Now(), this->Flight->Out.IsFlying()))
  {
    this->Missed = true;
    this->Flight->Out.Cancel();
  }
  this->Trouble = this->TroubleSoFar;
  this->TroubleSoFar = UsbOutcome::Done;
}

const char* FalconRounds::GetGarbage() const noexcept
{
  return this->Stream.GetDropped() != this->DroppedBefore ? FalconFlawText(this->Stream.GetFlaw())
                                                          : nullptr;
}

bool FalconRounds::IsPending() noexcept
{
  return !this->Turns.MaySend(ServoClock::Now()) || this->Flight->Out.IsFlying();
}

bool FalconRounds::IsDue() noexcept
{
  return !this->IsPending() && (this->Woken || ServoClock::Now() - this->SentAt >= IdleTime);
}

void FalconRounds::Send(const FalconOrder& order) noexcept
{
  if (this->OutStalled)
  {
    this->Usb.ClearHalt(FalconOut);
  }
  if (!this->InStalled)
  {
    this->PostReceivers();
  }
  const FalconPacket packet = FalconRunPacket(order);
  std::copy(packet.begin(), packet.end(), this->Flight->Out.GetBytes());
  this->Woken = false;
  this->SentAt = ServoClock::Now();
  if (this->Submit(this->Flight->Out, packet.size()))
  {
    this->Turns.Sent(this->SentAt);
  }
  // Clear the stall only after zero has been submitted, because a faulty device may take seconds to
  // answer.
  if (this->InStalled)
  {
    this->Usb.ClearHalt(FalconIn);
    this->PostReceivers();
  }
  this->OutStalled = this->InStalled = false;
}

void FalconRounds::PostReceivers() noexcept
{
  for (UsbTransfer* const in : { &this->Flight->First, &this->Flight->Second })
  {
    if (!in->IsFlying())
    {
      this->Submit(*in, UsbTransfer::Capacity);
    }
  }
}

bool FalconRounds::Submit(UsbTransfer& transfer, std::size_t size) noexcept
{
  this->Record(transfer.Submit(size));
  return transfer.IsFlying();
}

void FalconRounds::Record(UsbOutcome outcome) noexcept
{
  this->TroubleSoFar = std::max(this->TroubleSoFar, outcome);
}

void FalconRounds::TransferEnded(UsbTransfer& transfer, UsbOutcome outcome) noexcept
{
  const bool isOut = transfer.GetEndpoint() == FalconOut;
  this->Record(outcome);
  this->OutStalled = this->OutStalled || (isOut && outcome == UsbOutcome::Stalled);
  this->InStalled = this->InStalled || (!isOut && outcome == UsbOutcome::Stalled);
  if (outcome > UsbOutcome::Cancelled)
  {
    // No answer is outstanding, so zero can be sent at once.
    this->Turns.Abandon();
  }
  if (isOut && outcome == UsbOutcome::Done)
  {
    this->Exchange.RecordTaken();
  }
  if (isOut || outcome != UsbOutcome::Done)
  {
    return;
  }
  const int reports = this->Stream.Receive(transfer.GetBytes(), transfer.GetSize(), this->Report);
  if (reports > 0)
  {
    this->Reported = true;
    this->Turns.Answered(ServoClock::Now(), reports);
  }
  this->Submit(transfer, UsbTransfer::Capacity);
}

template <typename F>
void FalconRounds::WaitWhile(F&& holds, std::int64_t time) noexcept
{
  const std::int64_t end = ServoClock::Now() + time;
  while (holds() && this->TroubleSoFar != UsbOutcome::Gone && ServoClock::Now() < end)
  {
    this->Events.WaitForTransfers(ServoClock::Millisecond);
  }
}

void FalconRounds::Finish() noexcept
{
  const auto isPending = [this] { return this->IsPending(); };
  this->WaitWhile(isPending, FalconTurns::AnswerTime);
  this->Flight->Out.Cancel();
  const auto isOutFlying = [this] { return this->Flight->Out.IsFlying(); };
  this->WaitWhile(isOutFlying, LastPacketTime);
  if (this->Trouble != UsbOutcome::Gone && this->TroubleSoFar != UsbOutcome::Gone &&
    !this->Flight->Out.IsFlying())
  {
    this->Send(FalconOrder{});
    this->WaitWhile(isPending, LastPacketTime);
  }
  for (UsbTransfer* const transfer :
    { &this->Flight->Out, &this->Flight->First, &this->Flight->Second })
  {
    transfer->Cancel();
  }
  const std::int64_t end = ServoClock::Now() + CancelTime;
  while (this->Flight->AreFlying() && ServoClock::Now() < end)
  {
    this->Events.WaitForTransfers(ServoClock::Millisecond);
  }
}

/** Number of packets, 50 ms apart, after which a silent device counts as one without firmware. */
constexpr int ProbePackets = 5;
constexpr double MicrosecondsPerSecond = 1e6;
constexpr std::int64_t QuietTime = 20000000; // ns

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
  // Pass an integer, because its text is the same in all locales. A time of decades means no limit.
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

void FalconDriver::Disconnect() noexcept
{
  this->Others.clear();
  this->Usb.Close();
}

bool FalconDriver::Connect(std::string& error)
{
  return this->Take(this->Number, nullptr, error);
}

bool FalconDriver::Take(int number, const std::string* wanted, std::string& error)
{
  if (!this->Usb.Open(FalconProduct, number, error))
  {
    return false;
  }
  const std::string identity = UsbIdentityOf(libusb_get_device(this->Usb.GetHandle()), "falcon");
  if (wanted != nullptr && identity != *wanted)
  {
    // The numbering has changed since the devices were listed. Nothing was sent to this device.
    this->Usb.Close();
    error.clear();
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
    return false;
  }
  this->Identity = identity;
  return true;
}

bool FalconDriver::Reconnect(
  const std::string& identity, const std::function<bool()>& /*mustStop*/, std::string& error)
{
  const UsbContext context = MakeUsbContext(error);
  if (!context)
  {
    return false;
  }
  // The system may have renumbered the device.
  const std::vector<UsbDevice> present = ListUsbDevices(context.get(), FalconProduct);
  std::vector<std::vector<int>> others;
  int found = -1;
  for (std::size_t number = 0; number < present.size() && found < 0; ++number)
  {
    libusb_device* const device = present[number].get();
    const std::vector<int> path = UsbPathOf(device);
    bool isSure = true;
    if (std::find(this->Others.begin(), this->Others.end(), path) != this->Others.end())
    {
      others.push_back(path);
    }
    else if (UsbIdentityOf(device, "falcon", &isSure) == identity)
    {
      found = static_cast<int>(number);
    }
    else if (isSure)
    {
      others.push_back(path);
    }
  }
  this->Others = std::move(others);
  return found >= 0 && this->Take(found, &identity, error);
}

void FalconDriver::Serve(HardwareExchange& exchange)
{
  for (End end = End::Done; !exchange.MustStop() && end != End::Gone;)
  {
    end = this->Firmware.empty() ? End::Done : this->Load(exchange);
    if (end == End::Done)
    {
      end = this->Talk(exchange);
    }
    if (end == End::Gone)
    {
      exchange.SetCondition(DeviceStage::Lost, this->Name.c_str(), UnpluggedText);
    }
    while (!exchange.MustStop() && end != End::Gone && !exchange.DrainHomeRequest())
    {
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
    if (exchange.DrainHomeRequest())
    {
      controller.Restart();
    }
    if (rounds.HasReport() || rounds.HasMissed())
    {
      const std::int64_t now = ServoClock::Now();
      const double elapsed = static_cast<double>(now - last) * ServoClock::SecondsPerNanosecond;
      last = now;
      rounds.HasReport() ? controller.Receive(rounds.GetReport(), elapsed)
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
