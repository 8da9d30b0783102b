// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Expects that every deviation from the loader's protocol ends in a fault that names it. */

#include "FalconLoaderRig.h"

#include <set>

using namespace hardwaretest;

namespace
{
class FalconDoesNotLoad : public LoaderTest
{
protected:
  void ReachShake()
  {
    this->Prepare();
    this->Greet();
    this->SpeedUp();
  }
  void ReachSecondBlock()
  {
    this->ReachShake();
    this->Shake();
    this->ExpectWrite(this->Block(0, 62));
    this->Receive(this->Block(0, 62));
    this->ExpectWrite(this->Block(62, 62));
  }
};
} // namespace

TEST_F(FalconDoesNotLoad, WithoutAnImage)
{
  this->Loader = { this->Image.data(), 0 };
  this->ExpectFault(FalconLoaderFault::NoImage);
}

TEST_F(FalconDoesNotLoad, WhenTheLoaderDoesNotGreet)
{
  this->Prepare();
  for (int i = 0; i < 100; ++i)
  {
    this->ExpectWrite(Greeting);
    this->Loader.TimeOut();
    i < 99 ? this->ExpectRequest(0, 2) : void();
  }
  this->ExpectFault(FalconLoaderFault::NoGreeting);
}

TEST_F(FalconDoesNotLoad, WhenTheGreetingIsAnother)
{
  const std::string wrong[] = { "\x41", "\x0A\x44\x2C\x0A", GreetingAnswer + "\x0D" };
  this->Prepare();
  for (int i = 0; i < 100; ++i)
  {
    this->ExpectWrite(Greeting);
    this->Receive(wrong[i % 3]);
    i < 99 ? this->ExpectRequest(0, 2) : void();
  }
  this->ExpectFault(FalconLoaderFault::WrongGreeting);
}

TEST_F(FalconDoesNotLoad, WithoutTheHandshake)
{
  this->ReachShake();
  this->ExpectWrite("\x41");
  this->Loader.TimeOut();
  this->ExpectFault(FalconLoaderFault::NoHandshake);
  this->Loader = { this->Image.data(), this->Image.size() };
  this->ReachShake();
  this->ExpectWrite("\x41");
  this->Receive("\x42");
  this->ExpectFault(FalconLoaderFault::WrongHandshake);
}

TEST_F(FalconDoesNotLoad, WhenABlockDoesNotComeBackWhole)
{
  this->ReachSecondBlock();
  this->Receive(this->Block(62, 61));
  this->Loader.TimeOut();
  EXPECT_EQ(this->Loader.GetConfirmed(), 62u + 61u);
  this->ExpectFault(FalconLoaderFault::NoEcho);
}

TEST_F(FalconDoesNotLoad, WhenAByteComesBackDifferent)
{
  for (const std::size_t place : { 0, 30, 61 })
  {
    this->Loader = { this->Image.data(), this->Image.size() };
    this->ReachSecondBlock();
    std::string block = this->Block(62, 62);
    block[place] ^= 0x01;
    this->Receive(block);
    EXPECT_EQ(this->Loader.GetConfirmed(), 62u + place);
    this->ExpectFault(FalconLoaderFault::WrongEcho);
  }
}

TEST_F(FalconDoesNotLoad, WhenMoreComesBackThanWasSent)
{
  this->ReachSecondBlock();
  this->Receive(this->Block(62, 63));
  this->ExpectFault(FalconLoaderFault::WrongEcho);
}

TEST_F(FalconDoesNotLoad, WhenTheTransportRefuses)
{
  this->Loader.Refuse();
  this->ExpectFault(FalconLoaderFault::Refused);
  this->Loader = { this->Image.data(), this->Image.size() };
  this->ReachSecondBlock();
  this->Loader.Refuse();
  this->ExpectFault(FalconLoaderFault::Refused);
}

TEST(FalconLoaderFaultText, IsDifferentForEach)
{
  std::set<std::string> texts;
  for (int fault = 0; fault <= static_cast<int>(FalconLoaderFault::WrongEcho); ++fault)
  {
    texts.insert(FalconLoaderFaultText(static_cast<FalconLoaderFault>(fault)));
  }
  EXPECT_EQ(texts.size(), 9u);
}
