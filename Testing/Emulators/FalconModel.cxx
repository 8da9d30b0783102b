// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "FalconModel.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <utility>

namespace emulated
{
namespace
{

constexpr std::size_t PacketSize = 16;
constexpr std::size_t MostLines = 1 << 16;
constexpr int HomeBit = 0x01;
// Offsets of the encoder counts before homing; they are arbitrary.
constexpr Numbers Offsets = { 700.0, -300.0, 150.0 };

using Lock = std::lock_guard<std::mutex>;

} // namespace

std::vector<std::uint8_t> FalconModel::GetDescriptors() const
{
  return { 18, 1, 0x00, 0x02, 0, 0, 0, 8, 0x03, 0x04, 0x48, 0xCB, 0x00, 0x06, 0, 0, 0, 1, //
    9, 2, 32, 0, 1, 1, 0, 0x80, 45,                                                       //
    9, 4, 0, 0, 2, 0xFF, 0xFF, 0xFF, 0,                                                   //
    7, 5, 0x81, 2, 64, 0, 0, 7, 5, 0x02, 2, 64, 0, 0 };
}

int FalconModel::GetMode() const
{
  return this->Baud == 0x4138 ? 0 : this->Baud == 0x15 ? 1 : this->Baud == 0x02 ? 2 : -1;
}

int FalconModel::Control(const std::uint8_t setup[8], std::uint8_t*, int)
{
  const Lock lock(this->Mutex);
  const int value = setup[2] | setup[3] << 8;
  const bool clearsHalt = setup[0] == 0x02 && setup[1] == 1;
  if (setup[0] != 0x40 && !clearsHalt)
  {
    return -EPIPE;
  }
  char line[40];
  std::snprintf(line, sizeof(line), "c %02x %02x %04x", setup[0], setup[1], value);
  if (this->Transcript.size() < MostLines)
  {
    this->Transcript.emplace_back(line);
  }
  if (clearsHalt)
  {
    return 0;
  }
  if (!this->Late.empty() && !this->Runs)
  {
    this->Replies.push_back(std::exchange(this->Late, {}));
  }
  if (setup[1] == 0 && value == 2)
  {
    this->Replies.clear();
  }
  else if (setup[1] == 3)
  {
    this->Baud = value;
    this->Waiting.clear();
    if (value == 0x4138 && !this->Attempts.empty())
    {
      this->Fault = this->Attempts.front();
      this->FaultyPackets = 1 << 30;
      this->Attempts.pop_front();
    }
    if (value == 0x15)
    {
      this->IsShaken = false;
      this->Image.clear();
    }
    this->Runs = this->Runs ||
      (value == 0x02 && this->Image.size() >= this->ImageSize &&
        !this->Takes(FalconFault::DeadImage));
  }
  return 0;
}

int FalconModel::Out(std::uint8_t endpoint, const std::uint8_t* bytes, int size)
{
  const Lock lock(this->Mutex);
  if (endpoint != 0x02 || this->Takes(FalconFault::StallOut))
  {
    return -EPIPE;
  }
  if (this->Takes(FalconFault::BadCable))
  {
    return -EPROTO;
  }
  if (this->Fault == FalconFault::StuckOut)
  {
    return -EAGAIN;
  }
  const std::string text(bytes, bytes + size);
  std::string line = "o";
  for (int i = 0; i < size; ++i)
  {
    char hex[8];
    std::snprintf(hex, sizeof(hex), " %02x", bytes[i]);
    line += hex;
  }
  if (this->Transcript.size() < MostLines)
  {
    this->Transcript.push_back(line);
  }
  switch (this->Runs ? 2 : this->GetMode())
  {
    case 0:
      this->Greet(text);
      break;
    case 1:
      this->Load(text);
      break;
    case 2:
      for (const char byte : this->Runs&& this->GetMode() == 2 ? text : "")
      {
        this->ReceiveByte(static_cast<std::uint8_t>(byte));
      }
      break;
    default:
      break;
  }
  return size;
}

int FalconModel::In(std::uint8_t endpoint, std::uint8_t* bytes, int size)
{
  const Lock lock(this->Mutex);
  if (endpoint != 0x81 || this->Takes(FalconFault::StallIn))
  {
    return -EPIPE;
  }
  if (this->Replies.empty() || size < 64)
  {
    return -EAGAIN;
  }
  const std::string reply = this->Replies.front();
  this->Replies.pop_front();
  bytes[0] = 0x01;
  bytes[1] = 0x60;
  std::copy(reply.begin(), reply.end(), bytes + 2);
  return static_cast<int>(reply.size()) + 2;
}

void FalconModel::Greet(const std::string& bytes)
{
  this->Waiting += bytes;
  if (this->Waiting == "\x0A\x43\x0D" && this->Fault != FalconFault::StuckLoader &&
    !this->Takes(FalconFault::NoGreeting))
  {
    const std::string answer("\0\x0A\x44\x2C\x0D", 5);
    if (this->Takes(FalconFault::LateGreeting))
    {
      this->Late = answer.substr(1);
    }
    else
    {
      this->Send(this->Takes(FalconFault::LeadingZero) ? answer : answer.substr(1));
    }
  }
  this->Waiting.clear();
}

void FalconModel::Released()
{
  const Lock lock(this->Mutex);
  this->Takes(FalconFault::StuckLoader);
}

void FalconModel::Send(const std::string& bytes)
{
  (this->Clock ? this->Pending : this->Replies).push_back(bytes);
}

void FalconModel::Deliver()
{
  {
    const Lock lock(this->Mutex);
    if (this->Pending.empty())
    {
      return;
    }
    this->Replies.push_back(this->Pending.front());
    this->Pending.pop_front();
  }
  this->Ready();
}

void FalconModel::Load(const std::string& bytes)
{
  if (!this->IsShaken)
  {
    this->IsShaken = bytes == "\x41";
    const char* const lead = this->Takes(FalconFault::LeadingShake) ? "\x13" : "";
    return this->Send(lead + (this->IsShaken ? bytes : "?"));
  }
  std::string echo = bytes;
  this->Image.insert(this->Image.end(), bytes.begin(), bytes.end());
  if (this->Image.size() > 200 && this->Takes(FalconFault::WrongEcho))
  {
    echo[1] = static_cast<char>(echo[1] ^ 1);
  }
  if (this->Image.size() <= 200 || !this->Takes(FalconFault::NoEcho))
  {
    this->Send(echo);
  }
}

void FalconModel::ReceiveByte(std::uint8_t byte)
{
  this->Waiting += static_cast<char>(byte);
  if (this->Waiting[0] != '<')
  {
    this->Waiting.clear();
  }
  if (this->Waiting.size() == PacketSize)
  {
    if (this->Waiting.back() == '>')
    {
      this->ReceivePacket();
    }
    this->Waiting.clear();
  }
}

void FalconModel::ReceivePacket()
{
  const auto payload = [this](std::size_t place)
  { return static_cast<std::uint8_t>(this->Waiting[place]) - 0x41; };
  for (std::size_t leg = 0; leg < 3; ++leg)
  {
    int word = 0;
    for (std::size_t nibble = 0; nibble < 4; ++nibble)
    {
      word |= payload(1 + 4 * leg + nibble) << (4 * nibble);
    }
    this->Commands[leg] = word >= 0x8000 ? word - 0x10000 : word;
    this->LargestCommand = std::max(this->LargestCommand, std::fabs(this->Commands[leg]));
  }
  this->Lights = payload(13);
  ++this->Packets;
  if (this->Commands != Numbers{})
  {
    this->LastPush = { this->Packets, std::chrono::steady_clock::now() };
  }
  this->InStep = this->Pending.empty() && this->Replies.empty() ? this->InStep + 1 : 0;
  if (!this->Late.empty())
  {
    this->Send(std::exchange(this->Late, {}));
  }
  this->Force = FalconMotorForce(this->Grip.Place, this->Commands);
  for (double& force : this->Force)
  {
    force *= this->MotorSign;
  }
  this->Grip.Step(this->Force);
  const Numbers counts = FalconEncoderCounts(this->Grip.Place);
  this->FindZero(counts, (this->Lights & HomeBit) != 0);
  std::string report = this->MakeReport(counts);
  if (this->Takes(FalconFault::Silence))
  {
    return;
  }
  if (this->Takes(FalconFault::ShortPacket))
  {
    report.resize(9);
  }
  else if (this->Takes(FalconFault::Garbage))
  {
    report.assign(PacketSize, '\xA5');
  }
  if (this->Takes(FalconFault::LateAnswer))
  {
    this->Late = report;
    return;
  }
  if (this->Packets % 8 == 0 && !this->Clock)
  {
    this->Send(""); // sends a transfer without data
  }
  this->Send(report);
}

/**
 * Sets a leg's zero once the leg has been at both ends. A packet without the homing bit clears all
 * zeros.
 */
void FalconModel::FindZero(const Numbers& counts, bool asked)
{
  if (!asked)
  {
    this->Homed = 0;
    this->SeenOut = {};
    this->SeenIn = {};
  }
  for (std::size_t leg = 0; asked && leg < 3; ++leg)
  {
    this->SeenOut[leg] = this->SeenOut[leg] || counts[leg] > 850.0;
    this->SeenIn[leg] = this->SeenIn[leg] || counts[leg] < -850.0;
    this->Homed |= this->SeenOut[leg] && this->SeenIn[leg] ? 1 << leg : 0;
  }
}

std::string FalconModel::MakeReport(Numbers counts)
{
  int homed = this->Homed;
  if (this->Takes(FalconFault::Nowhere))
  {
    counts = { 32767.0, -32768.0, 0.0 };
  }
  const bool jumps = this->Takes(FalconFault::Jump);
  homed &= this->Takes(FalconFault::LostZero) ? 5 : 7;
  std::string report(PacketSize, 'A');
  report.front() = '<';
  report.back() = '>';
  for (std::size_t leg = 0; leg < 3; ++leg)
  {
    const double offset = (homed >> leg & 1) == 0 ? Offsets[leg] : jumps ? -600.0 : 0.0;
    const auto count = static_cast<unsigned int>(std::lround(counts[leg] + offset));
    for (std::size_t nibble = 0; nibble < 4; ++nibble)
    {
      report[1 + 4 * leg + nibble] = static_cast<char>(0x41 + (count >> (4 * nibble) & 15));
    }
  }
  report[13] = static_cast<char>(0x41 + (homed << 4 | this->Buttons));
  return report;
}

bool FalconModel::Takes(FalconFault fault)
{
  if (this->Fault != fault)
  {
    return false;
  }
  if (--this->FaultyPackets <= 0)
  {
    this->Fault = FalconFault::None;
  }
  return true;
}

} // namespace emulated
