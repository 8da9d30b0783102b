// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/Falcon/FalconRounds.h"

#include "Core/Realtime/ServoClock.h"
#include "Devices/Falcon/FalconSerial.h"

#include <algorithm>

namespace VolumeHaptics
{
namespace
{

// ns
constexpr std::int64_t LastPacketTime = 100 * ServoClock::Millisecond;
constexpr std::int64_t CancelTime = 500 * ServoClock::Millisecond;

} // namespace

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
    // The system still uses them: only closing the device releases them.
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
  // Only once zero is on its way: a faulty device may take seconds to answer.
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
  this->Note(transfer.Submit(size));
  return transfer.IsFlying();
}

void FalconRounds::Note(UsbOutcome outcome) noexcept
{
  this->TroubleSoFar = std::max(this->TroubleSoFar, outcome);
}

void FalconRounds::TransferEnded(UsbTransfer& transfer, UsbOutcome outcome) noexcept
{
  const bool isOut = transfer.GetEndpoint() == FalconOut;
  this->Note(outcome);
  this->OutStalled = this->OutStalled || (isOut && outcome == UsbOutcome::Stalled);
  this->InStalled = this->InStalled || (!isOut && outcome == UsbOutcome::Stalled);
  if (outcome > UsbOutcome::Cancelled)
  {
    // No answer is expected: zero goes out at once.
    this->Turns.Abandon();
  }
  if (isOut && outcome == UsbOutcome::Done)
  {
    this->Exchange.NoteTaken();
  }
  if (isOut || outcome != UsbOutcome::Done)
  {
    return;
  }
  const int reports = this->Stream.Take(transfer.GetBytes(), transfer.GetSize(), this->Report);
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

} // namespace VolumeHaptics
