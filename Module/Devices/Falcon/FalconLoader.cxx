// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/Falcon/FalconLoader.h"

#include <algorithm>

namespace VolumeHaptics
{

namespace
{
constexpr FtdiRequest PrepareRequests[] = { FtdiPurgeTransmit, FtdiPurgeReceive, FtdiLatency(16),
  FtdiBaud(FalconGreetingBaud), Ftdi8N1, FtdiNoFlowControl, FtdiRtsLow, FtdiDtrLow, FtdiDtrHigh };
// Purge first, so that a late answer to one greeting does not count as the answer to the next.
constexpr FtdiRequest GreetAgainRequests[] = { FtdiPurgeReceive };
constexpr FtdiRequest SpeedUpRequests[] = { FtdiDtrLow, FtdiBaud(FalconLoadingBaud) };

constexpr std::uint8_t Greeting[] = { 0x0A, 0x43, 0x0D };
constexpr std::uint8_t GreetingAnswer[] = { 0x0A, 0x44, 0x2C, 0x0D };
constexpr std::uint8_t Handshake[] = { 0x41 };
} // namespace

const char* FalconLoaderFaultText(FalconLoaderFault fault) noexcept
{
  switch (fault)
  {
    case FalconLoaderFault::None:
      return "nothing is wrong";
    case FalconLoaderFault::NoImage:
      return "the firmware image is empty";
    case FalconLoaderFault::Refused:
      return "the device rejected a request or a write";
    case FalconLoaderFault::NoGreeting:
      return "the device's loader does not answer";
    case FalconLoaderFault::WrongGreeting:
      return "the device's loader answers otherwise than expected";
    case FalconLoaderFault::NoHandshake:
      return "the device's loader does not answer at the loading rate";
    case FalconLoaderFault::WrongHandshake:
      return "the device's loader answers otherwise than expected at the loading rate";
    case FalconLoaderFault::NoEcho:
      return "a block of the firmware did not come back";
    case FalconLoaderFault::WrongEcho:
      return "a block of the firmware came back different";
  }
  return "unknown";
}

FalconLoader::FalconLoader(const std::uint8_t* image, std::size_t size) noexcept
  : Image{ image, size }
{
  if (image == nullptr || size == 0)
  {
    this->Fail(FalconLoaderFault::NoImage);
  }
}

FalconLoader::Requests FalconLoader::GetRequests() const noexcept
{
  switch (this->Now)
  {
    case Stage::Prepare:
      return { PrepareRequests, std::size(PrepareRequests) };
    case Stage::GreetAgain:
      return { GreetAgainRequests, std::size(GreetAgainRequests) };
    case Stage::SpeedUp:
      return { SpeedUpRequests, std::size(SpeedUpRequests) };
    case Stage::Run:
      return { FalconRunRequests.data(), FalconRunRequests.size() };
    default:
      return {};
  }
}

FtdiPayload FalconLoader::GetMessage() const noexcept
{
  switch (this->Now)
  {
    case Stage::Greet:
      return { Greeting, std::size(Greeting) };
    case Stage::Shake:
      return { Handshake, std::size(Handshake) };
    case Stage::Load:
      return { this->Image.Bytes + this->Offset,
        std::min(FalconBlockSize, this->Image.Size - this->Offset) };
    default:
      return {};
  }
}

FtdiPayload FalconLoader::GetAnswer() const noexcept
{
  return this->Now == Stage::Greet ? FtdiPayload{ GreetingAnswer, std::size(GreetingAnswer) }
                                   : this->GetMessage();
}

FalconLoaderStep FalconLoader::GetStep() const noexcept
{
  FalconLoaderStep step;
  const Requests requests = this->GetRequests();
  if (requests.Count > 0)
  {
    step.What = FalconLoaderStep::Kind::Request;
    step.Request = requests.First[this->NextRequest];
  }
  else if (this->Reading)
  {
    step.What = FalconLoaderStep::Kind::Read;
    step.Size = this->GetAnswer().Size - this->Matched;
    step.MayStayOpen = this->Now == Stage::Greet;
  }
  else if (this->Now == Stage::Finished)
  {
    step.What = FalconLoaderStep::Kind::Finished;
  }
  else if (this->Now != Stage::Failed)
  {
    const FtdiPayload message = this->GetMessage();
    step.What = FalconLoaderStep::Kind::Write;
    step.Bytes = message.Bytes;
    step.Size = message.Size;
  }
  return step;
}

void FalconLoader::Enter(Stage stage) noexcept
{
  this->Now = stage;
  this->NextRequest = 0;
  this->Matched = 0;
  this->Reading = false;
  this->LeadTaken = false;
}

void FalconLoader::Fail(FalconLoaderFault fault) noexcept
{
  this->Enter(Stage::Failed);
  this->Fault = fault;
}

void FalconLoader::Done() noexcept
{
  switch (this->GetStep().What)
  {
    case FalconLoaderStep::Kind::Request:
      if (++this->NextRequest < this->GetRequests().Count)
      {
        return;
      }
      switch (this->Now)
      {
        case Stage::SpeedUp:
          return this->Enter(Stage::Shake);
        case Stage::Run:
          return this->Enter(Stage::Finished);
        default:
          return this->Enter(Stage::Greet);
      }
    case FalconLoaderStep::Kind::Write:
      this->Reading = true;
      return;
    default:
      return;
  }
}

void FalconLoader::Refuse() noexcept
{
  if (this->Now != Stage::Finished && this->Now != Stage::Failed)
  {
    this->Fail(FalconLoaderFault::Refused);
  }
}

void FalconLoader::Answered() noexcept
{
  switch (this->Now)
  {
    case Stage::Greet:
      return this->Enter(Stage::SpeedUp);
    case Stage::Shake:
      return this->Enter(Stage::Load);
    default:
      this->Offset += this->GetMessage().Size;
      return this->Enter(this->Offset < this->Image.Size ? Stage::Load : Stage::Run);
  }
}

void FalconLoader::Deviate(
  FalconLoaderFault greeting, FalconLoaderFault shake, FalconLoaderFault echo) noexcept
{
  switch (this->Now)
  {
    case Stage::Greet:
      return ++this->Greetings < FalconMostGreetings ? this->Enter(Stage::GreetAgain)
                                                     : this->Fail(greeting);
    case Stage::Shake:
      return this->Fail(shake);
    default:
      return this->Fail(echo);
  }
}

void FalconLoader::Receive(const std::uint8_t* bytes, std::size_t size) noexcept
{
  if (!this->Reading || size == 0)
  {
    return;
  }
  // A line that was just pulled up may look like an additional byte to the converter: some devices
  // answer the handshake with 13 41. Skip this byte.
  const bool mayLead = this->Matched == 0 && !this->LeadTaken;
  if (mayLead &&
    ((this->Now == Stage::Greet && *bytes == 0) || (this->Now == Stage::Shake && *bytes == 0x13)))
  {
    this->LeadTaken = true;
    return this->Receive(bytes + 1, size - 1);
  }
  const FtdiPayload answer = this->GetAnswer();
  const std::size_t due = answer.Size - this->Matched;
  const std::uint8_t* const expected = answer.Bytes + this->Matched;
  const std::uint8_t* const end = bytes + std::min(size, due);
  const auto same = static_cast<std::size_t>(std::mismatch(bytes, end, expected).first - bytes);
  this->Matched += same;
  this->Confirmed += this->Now == Stage::Load ? same : 0;
  if (same < size)
  {
    this->Deviate(FalconLoaderFault::WrongGreeting, FalconLoaderFault::WrongHandshake,
      FalconLoaderFault::WrongEcho);
  }
  else if (same == due)
  {
    this->Answered();
  }
}

void FalconLoader::TimeOut() noexcept
{
  if (this->Reading)
  {
    this->Deviate(
      FalconLoaderFault::NoGreeting, FalconLoaderFault::NoHandshake, FalconLoaderFault::NoEcho);
  }
}

} // namespace VolumeHaptics
