// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "TouchPad.h"

#include "Dealer.h"
#include "Devices/Pad/DualSense.h"
#include "Devices/Pad/EvdevReader.h"
#include "Devices/Pad/Vibration.h"
#include "Devices/Transport/Evdev/EvdevNode.h"

#include <climits>
#include <cmath>
#include <string>
#include <vector>

using namespace VolumeHaptics;

namespace
{
bool IsIn(double value, double least, double most)
{
  return value >= least && value <= most;
}

void CheckState(const PadState& state)
{
  for (const double stick : { state.LeftX, state.LeftY, state.RightX, state.RightY })
  {
    Check(IsIn(stick, -1.0, 1.0), "sticks are of -1 to 1");
  }
  Check(IsIn(state.LeftTrigger, 0.0, 1.0) && IsIn(state.RightTrigger, 0.0, 1.0),
    "triggers are of 0 to 1");
  const PadMotion motion = Steer(state);
  Check(Norm(motion.Push) <= 1.0 + 1e-12 && Norm(motion.Turn) <= 1.0, "nothing is too fast");
}

/** Returns the result of HasEvdevBit() by reading word by word, as a reference. */
bool SearchBit(std::string text, unsigned bit)
{
  while (!text.empty() && text.back() == '\n')
  {
    text.pop_back();
  }
  std::vector<std::string> words(1);
  for (const char c : text)
  {
    if (c == ' ')
    {
      words.emplace_back();
      continue;
    }
    words.back() += c;
  }
  for (const std::string& word : words)
  {
    if (word.size() > 2 * sizeof(long) ||
      word.find_first_not_of("0123456789abcdef") != std::string::npos)
    {
      return false;
    }
  }
  const unsigned width = sizeof(long) * CHAR_BIT;
  const std::size_t place = bit / width;
  if (place >= words.size() || words[words.size() - 1 - place].empty())
  {
    return false;
  }
  const unsigned long value = std::stoul(words[words.size() - 1 - place], nullptr, 16);
  return (value >> bit % width & 1) != 0;
}

void TouchText(Dealer& dealer)
{
  const std::string letters = "0123456789abcdef  0f\n";
  std::string text;
  for (int count = dealer.Choose(200); count > 0; --count)
  {
    text += dealer.Choose(64) == 0
      ? static_cast<char>(dealer.Byte())
      : letters[static_cast<std::size_t>(dealer.Choose(static_cast<int>(letters.size())))];
  }
  for (int i = 0; i < 20; ++i)
  {
    const auto bit = static_cast<unsigned>(dealer.Choose(4) * 256 + dealer.Byte());
    Check(HasEvdevBit(text, bit) == SearchBit(text, bit), "bits are found where they are");
  }
}

int DealInt(Dealer& dealer)
{
  int value = 0;
  dealer.Fill(&value, sizeof(value));
  const int some[] = { value, 0, 127, 128, 255, -32768, 32767, INT_MAX, INT_MIN };
  return some[dealer.Choose(9)];
}

void TouchEvents(Dealer& dealer)
{
  EvdevReader reader;
  for (int count = dealer.Choose(12); count > 0; --count)
  {
    input_absinfo axis{};
    axis.value = DealInt(dealer);
    axis.minimum = DealInt(dealer);
    axis.maximum = DealInt(dealer);
    axis.flat = DealInt(dealer);
    reader.SetAxis(static_cast<unsigned>(dealer.Choose(70)), axis);
  }
  bool isDropping = false;
  while (dealer.HasMore())
  {
    input_event event{};
    event.type = static_cast<__u16>(dealer.Choose(4));
    event.code =
      static_cast<__u16>(event.type == EV_KEY ? BTN_SOUTH + dealer.Choose(16)
                                              : dealer.Choose(event.type == EV_SYN ? 4 : 80));
    event.value = DealInt(dealer);
    const EvdevReader::News news = reader.Receive(event);
    const bool isEnd = event.type == EV_SYN && event.code == SYN_REPORT;
    Check(
      (news == EvdevReader::News::MustRead) == (isDropping && isEnd), "what is lost is asked for");
    isDropping = event.type == EV_SYN && event.code == SYN_DROPPED ? true : isDropping && !isEnd;
    CheckState(reader.Get());
  }
}

void TouchReports(Dealer& dealer)
{
  DualSense::Link link = DualSense::Link::Unknown;
  PadState state;
  while (dealer.HasMore())
  {
    const int sizes[] = { 0, 10, 63, 64, 77, 78, 79, dealer.Choose(256) };
    std::vector<std::uint8_t> report(static_cast<std::size_t>(sizes[dealer.Choose(8)]));
    dealer.Fill(report.data(), report.size());
    const bool isWireless = dealer.Choose(2) == 0;
    if (!report.empty())
    {
      report[0] = isWireless ? 0x31 : 0x01;
    }
    const bool isWhole = isWireless && report.size() == 78;
    if (isWhole && dealer.Choose(2) == 0)
    {
      const std::uint32_t crc = DualSense::ComputeCrc(0xA1, report.data(), 74);
      for (unsigned i = 0; i < 4; ++i)
      {
        report[74 + i] = static_cast<std::uint8_t>(crc >> 8 * i);
      }
      const bool isRight = dealer.Choose(2) != 0;
      if (!isRight)
      {
        // Flip one bit, which the checksum always detects.
        report[1 + static_cast<std::size_t>(dealer.Choose(77))] ^=
          static_cast<std::uint8_t>(1U << dealer.Choose(8));
      }
      Check((DualSense::Decode(report.data(), report.size(), link, state) == nullptr) == isRight,
        "checksums count");
    }
    else
    {
      DualSense::Decode(report.data(), report.size(), link, state);
    }
    CheckState(state);
    const DualSense::Report answer = DualSense::Encode(
      link, dealer.Choose(2) == 0, DealInt(dealer), DealInt(dealer), dealer.Byte());
    Check(answer.Size ==
        (link == DualSense::Link::Unknown    ? 0U
            : link == DualSense::Link::Cable ? 63U
                                             : 78U),
      "answers have their sizes");
    DualSense::HasNewerVibration(0x0CE6, report.data(), report.size());
  }
}

void TouchForces(Dealer& dealer)
{
  constexpr double sizes[] = { 1e-3, 1.0, 30.0, 1e5, 1e308, HUGE_VAL };
  Vibration vibration;
  VibrationLevels before;
  while (dealer.HasMore())
  {
    const double most = sizes[dealer.Choose(6)];
    const Vector3 force{ most * dealer.Between(-1.0, 1.0), most * dealer.Between(-1.0, 1.0),
      dealer.Choose(32) == 0 ? std::nan("") : dealer.Between(-1.0, 1.0) };
    const double elapsed = std::pow(10.0, dealer.Between(-6.0, 3.0)) * dealer.Choose(2);
    const VibrationLevels levels = vibration.Advance(force, elapsed);
    const bool isSilence = levels.Strong == 0.0 && levels.Weak == 0.0;
    Check(IsIn(levels.Strong, 0.0, 1.0) && IsIn(levels.Weak, 0.0, 1.0), "levels are of 0 to 1");
    Check(IsFinite(force) || isSilence, "what is no number is silence");
    Check(levels.Weak - before.Weak <= Vibration::RiseRate * elapsed + 1e-9 &&
        levels.Strong - before.Strong <= Vibration::RiseRate * elapsed + 1e-9,
      "levels rise no faster than they may");
    Check(isSilence ||
        (before.Weak - levels.Weak <= Vibration::FallRate * elapsed + 1e-9 &&
          before.Strong - levels.Strong <= Vibration::FallRate * elapsed + 1e-9),
      "levels fall no faster than they may");
    before = levels;
  }
}
} // namespace

void TouchPad(const std::uint8_t* bytes, std::size_t size)
{
  Dealer dealer(bytes, size);
  void (*const targets[])(Dealer&) = { TouchText, TouchEvents, TouchReports, TouchForces };
  targets[dealer.Choose(4)](dealer);
}
