// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "FfbHandle.h"

#include <algorithm>
#include <cerrno>

namespace emulated
{

int FfbHandle::Output(const std::uint8_t* report, int size)
{
  const std::lock_guard<std::mutex> lock(this->Guard);
  if (this->Fault == FfbFault::WriteError)
  {
    return -EIO;
  }
  this->Last[report[0]].assign(report, report + size);
  ++this->Outputs;
  return this->ReceiveOutput(report, size);
}

int FfbHandle::SetFeature(const std::uint8_t* report, int size)
{
  const std::lock_guard<std::mutex> lock(this->Guard);
  this->Last[report[0]].assign(report, report + size);
  return this->ReceiveFeature(report, size);
}

int FfbHandle::GetFeature(std::uint8_t* report, int size)
{
  const std::lock_guard<std::mutex> lock(this->Guard);
  return this->Fault == FfbFault::NoBlockLoad ? -EPIPE : this->GiveFeature(report, size);
}

Triple FfbHandle::Push() const
{
  const std::array<double, 2> torques = this->ComputeTorques();
  // HID's y axis points towards the hand, so the sign changes.
  const double second = this->Motors > 1 ? this->SecondSign.load() : 0.0;
  return { FullScale * torques[0], -second * FullScale * torques[1], 0.0 };
}

void FfbHandle::Step()
{
  const std::lock_guard<std::mutex> lock(this->Guard);
  this->Hand.Step(1e-3, this->Push());
  ++this->Time;
  if (this->Time % this->ReportPeriod == 0)
  {
    this->Report();
  }
}

void FfbHandle::Report()
{
  const FfbFault fault = this->Fault;
  double x = std::clamp(this->Hand.Tip[0] / Travel, -1.0, 1.0);
  double y = -std::clamp(this->Hand.Tip[1] / Travel, -1.0, 1.0);
  if (fault == FfbFault::Garbage)
  {
    this->Noise = this->Noise * 1664525U + 1013904223U;
    x = static_cast<std::int16_t>(this->Noise >> 8) / 32768.0;
    y = static_cast<std::int16_t>(this->Noise >> 16) / 32768.0;
  }
  const Bytes report = this->BuildReport(x, y);
  const bool isReminder = (this->SinceSent += this->ReportPeriod) > this->GetReminderTime();
  const bool isDue = this->Streams || (isReminder && !this->OnlySaysNews);
  if (fault == FfbFault::ShortReport)
  {
    this->Input(report.data(), 3);
  }
  else if (fault != FfbFault::Silence && (isDue || report != this->Sent))
  {
    this->Input(report.data(), static_cast<int>(report.size()));
    this->Sent = report;
    this->SinceSent = 0;
  }
}

void FfbHandle::PowerUp()
{
  const std::lock_guard<std::mutex> lock(this->Guard);
  this->ForgetEffects();
  this->Hand.Place({});
  this->Fault = FfbFault::None;
}

void FfbHandle::SetGoal(double right, double away)
{
  const std::lock_guard<std::mutex> lock(this->Guard);
  this->Hand.Goal = { right, away, 0.0 };
}

Triple FfbHandle::GetTip() const
{
  const std::lock_guard<std::mutex> lock(this->Guard);
  return this->Hand.Tip;
}

Triple FfbHandle::GetForce() const
{
  const std::lock_guard<std::mutex> lock(this->Guard);
  return this->Push();
}

int FfbHandle::CountPlaying() const
{
  const std::lock_guard<std::mutex> lock(this->Guard);
  return this->CountAll(true);
}

int FfbHandle::CountEffects() const
{
  const std::lock_guard<std::mutex> lock(this->Guard);
  return this->CountAll(false);
}

std::vector<std::uint8_t> FfbHandle::GetLast(std::uint8_t id) const
{
  const std::lock_guard<std::mutex> lock(this->Guard);
  const auto last = this->Last.find(id);
  return last == this->Last.end() ? Bytes() : last->second;
}

} // namespace emulated
