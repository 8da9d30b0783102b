// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Simulates the device for a loader step by step: checks the loader's requests and bytes, and
 * returns the answers.
 */
#ifndef FalconLoaderRig_h
#define FalconLoaderRig_h

#include "Devices/Falcon/FalconLoader.h"

#include <gtest/gtest.h>

#include <numeric>
#include <string>
#include <vector>

namespace hardwaretest
{
using namespace VolumeHaptics;
using Kind = FalconLoaderStep::Kind;

inline const std::string Greeting = "\x0A\x43\x0D";
inline const std::string GreetingAnswer = "\x0A\x44\x2C\x0D";

class LoaderTest : public testing::Test
{
protected:
  void ExpectRequest(int request, int value)
  {
    const FalconLoaderStep step = this->Loader.GetStep();
    ASSERT_EQ(step.What, Kind::Request);
    EXPECT_EQ(step.Request.RequestType, 0x40);
    EXPECT_EQ(step.Request.Request, request);
    EXPECT_EQ(step.Request.Value, value);
    EXPECT_EQ(step.Request.Index, 0);
    this->Loader.Done();
  }
  void ExpectWrite(const std::string& bytes)
  {
    const FalconLoaderStep step = this->Loader.GetStep();
    ASSERT_EQ(step.What, Kind::Write);
    EXPECT_EQ(std::string(step.Bytes, step.Bytes + step.Size), bytes);
    this->Loader.Done();
  }
  void ExpectDue(std::size_t size)
  {
    EXPECT_EQ(this->Loader.GetStep().What, Kind::Read);
    EXPECT_EQ(this->Loader.GetStep().Size, size);
  }
  void Receive(const std::string& bytes)
  {
    const std::vector<std::uint8_t> exact(bytes.begin(), bytes.end());
    this->Loader.Receive(exact.data(), exact.size());
  }
  void ExpectFault(FalconLoaderFault fault)
  {
    EXPECT_EQ(this->Loader.GetFault(), fault);
    EXPECT_EQ(this->Loader.GetStep().What, Kind::Failed);
    // Expect that the fault persists: no later event changes it.
    this->Loader.Done();
    this->Receive(GreetingAnswer);
    this->Loader.TimeOut();
    this->Loader.Refuse();
    EXPECT_EQ(this->Loader.GetFault(), fault);
    EXPECT_EQ(this->Loader.GetStep().What, Kind::Failed);
  }

  void Prepare()
  {
    this->ExpectRequest(0, 1);      // purge data to send
    this->ExpectRequest(0, 2);      // purge received data
    this->ExpectRequest(9, 16);     // latency
    this->ExpectRequest(3, 0x4138); // 9600 baud
    this->ExpectRequest(4, 8);      // 8N1
    this->ExpectRequest(2, 0);      // no flow control
    this->ExpectRequest(1, 0x0200); // RTS low
    this->ExpectRequest(1, 0x0100); // DTR low
    this->ExpectRequest(1, 0x0101); // DTR high
  }
  void Greet()
  {
    this->ExpectWrite(Greeting);
    this->ExpectDue(4);
    this->Receive(GreetingAnswer);
  }
  void SpeedUp()
  {
    this->ExpectRequest(1, 0x0100); // DTR low
    this->ExpectRequest(3, 0x15);   // 140 000 baud
  }
  void Shake()
  {
    this->ExpectWrite("\x41");
    this->ExpectDue(1);
    this->Receive("\x41");
  }
  std::string Block(std::size_t first, std::size_t size) const
  {
    return { this->Image.begin() + first, this->Image.begin() + first + size };
  }

  /** An image of two blocks and a rest (150 bytes in all), whose values wrap around at 255. */
  std::vector<std::uint8_t> Image = []
  {
    std::vector<std::uint8_t> image(150);
    std::iota(image.begin(), image.end(), static_cast<std::uint8_t>(200));
    return image;
  }();
  FalconLoader Loader{ this->Image.data(), this->Image.size() };
};
} // namespace hardwaretest

#endif
