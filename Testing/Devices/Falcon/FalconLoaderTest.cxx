// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Tests each byte of the loader's protocol, without faults. */

#include "FalconLoaderRig.h"

using namespace hardwaretest;

namespace
{
class FalconLoads : public LoaderTest
{
};
} // namespace

TEST_F(FalconLoads, TheWholeDialogue)
{
  this->Prepare();
  this->Greet();
  this->SpeedUp();
  this->Shake();
  for (const std::size_t first : { 0, 62, 124 })
  {
    const std::string block = this->Block(first, first == 124 ? 26 : 62);
    this->ExpectWrite(block);
    this->ExpectDue(block.size());
    EXPECT_EQ(this->Loader.GetConfirmed(), first);
    this->Receive(block);
  }
  EXPECT_EQ(this->Loader.GetConfirmed(), 150u);
  this->ExpectRequest(9, 1); // latency
  this->ExpectRequest(3, 2); // the run mode's rate
  this->ExpectRequest(0, 1);
  this->ExpectRequest(0, 2);
  EXPECT_EQ(this->Loader.GetStep().What, Kind::Finished);
  EXPECT_EQ(this->Loader.GetFault(), FalconLoaderFault::None);
  this->Loader.Refuse();
  this->Loader.TimeOut();
  this->Loader.Done();
  EXPECT_EQ(this->Loader.GetStep().What, Kind::Finished);
}

TEST_F(FalconLoads, AnswersInPieces)
{
  this->Prepare();
  this->ExpectWrite(Greeting);
  this->Receive("\x0A\x44");
  this->ExpectDue(2);
  this->Receive("");
  this->Receive("\x2C");
  this->ExpectDue(1);
  this->Receive("\x0D");
  this->SpeedUp();
  this->Shake();
  this->ExpectWrite(this->Block(0, 62));
  this->Receive(this->Block(0, 60));
  this->ExpectDue(2);
  EXPECT_EQ(this->Loader.GetConfirmed(), 60u);
  this->Receive(this->Block(60, 2));
  this->ExpectWrite(this->Block(62, 62));
}

TEST_F(FalconLoads, AZeroMayComeBeforeTheGreeting)
{
  this->Prepare();
  this->ExpectWrite(Greeting);
  this->Receive(std::string(1, '\0') + GreetingAnswer);
  this->SpeedUp();
  this->Loader = { this->Image.data(), this->Image.size() };
  this->Prepare();
  this->ExpectWrite(Greeting);
  this->Receive(std::string(1, '\0'));
  this->ExpectDue(4);
  this->Receive(GreetingAnswer);
  this->SpeedUp();
  // A single zero byte may precede the answer, and only the answer to the greeting. Two zeros are
  // refused.
  this->Loader = { this->Image.data(), this->Image.size() };
  this->Prepare();
  this->ExpectWrite(Greeting);
  this->Receive(std::string(2, '\0') + GreetingAnswer);
  this->ExpectRequest(0, 2);
  this->Greet();
  this->SpeedUp();
  this->ExpectWrite("\x41");
  this->Receive(std::string(1, '\0') + "\x41");
  this->ExpectFault(FalconLoaderFault::WrongHandshake);
}

TEST_F(FalconLoads, AThirteenMayComeBeforeTheHandshake)
{
  for (const bool inPieces : { false, true })
  {
    this->Loader = { this->Image.data(), this->Image.size() };
    this->Prepare();
    this->Greet();
    this->SpeedUp();
    this->ExpectWrite("\x41");
    this->Receive(inPieces ? "\x13" : "\x13\x41");
    if (inPieces)
    {
      this->ExpectDue(1);
      this->Receive("\x41");
    }
    this->ExpectWrite(this->Block(0, 62));
  }
}

TEST_F(FalconLoads, AWholeNumberOfBlocks)
{
  this->Loader = { this->Image.data(), 62 };
  this->Prepare();
  this->Greet();
  this->SpeedUp();
  this->Shake();
  this->ExpectWrite(this->Block(0, 62));
  this->Receive(this->Block(0, 62));
  this->ExpectRequest(9, 1);
}

TEST_F(FalconLoads, AHundredGreetings)
{
  this->Prepare();
  for (int i = 0; i < 99; ++i)
  {
    this->ExpectWrite(Greeting);
    i % 2 == 0 ? this->Loader.TimeOut() : this->Receive("\x0A\x43");
    this->ExpectRequest(0, 2); // purges, so that a late answer is not mistaken for the next one
  }
  this->Greet();
  this->SpeedUp();
}

TEST_F(FalconLoads, UnexpectedBytesAreNotTaken)
{
  this->Receive(GreetingAnswer);
  this->Loader.TimeOut();
  this->Prepare();
  this->Receive(GreetingAnswer);
  this->Greet();
  this->SpeedUp();
}

TEST(FalconRun, IsTheRunModesRequests)
{
  const int expected[4][2] = { { 9, 1 }, { 3, 2 }, { 0, 1 }, { 0, 2 } };
  for (int i = 0; i < 4; ++i)
  {
    EXPECT_EQ(FalconRunRequests[i].RequestType, 0x40);
    EXPECT_EQ(FalconRunRequests[i].Request, expected[i][0]);
    EXPECT_EQ(FalconRunRequests[i].Value, expected[i][1]);
  }
}
