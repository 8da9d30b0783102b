// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The dialogue that loads the Novint Falcon's firmware, as a state machine without a transport.
 *
 * The firmware is not part of this project and must not be: the user names a file. A device that
 * already runs the firmware needs no loading, so probe first: send FalconRunRequests and a run
 * packet, and see whether a report comes back.
 *
 * Not verified on hardware.
 */
#ifndef FalconLoader_h
#define FalconLoader_h

#include "Devices/Transport/Usb/FtdiSerial.h"

#include <array>

namespace VolumeHaptics
{

constexpr std::uint16_t FalconGreetingBaud = 0x4138; ///< 9600 baud
constexpr std::uint16_t FalconLoadingBaud = 0x0015;  ///< about 140 000 baud
constexpr std::uint16_t FalconRunBaud = 0x0002;
constexpr std::size_t FalconBlockSize = 62; ///< bytes of the image that fit beside the status bytes
constexpr int FalconMostGreetings = 100;

/** The steps before run packets go back and forth. */
constexpr std::array<FtdiRequest, 4> FalconRunRequests = { FtdiLatency(1), FtdiBaud(FalconRunBaud),
  FtdiPurgeTransmit, FtdiPurgeReceive };

enum class FalconLoaderFault : std::uint8_t
{
  None,
  NoImage,        ///< the image is empty
  Refused,        ///< a request or a write did not go through
  NoGreeting,     ///< FalconMostGreetings were sent, and the last one had no answer
  WrongGreeting,  ///< wrong answer to the last greeting
  NoHandshake,    ///< no answer at the loading rate
  WrongHandshake, ///< wrong answer at the loading rate
  NoEcho,         ///< a block of the image did not come back in time
  WrongEcho       ///< a block came back different, or with more bytes behind it
};

/** Returns the fault in words. */
const char* FalconLoaderFaultText(FalconLoaderFault fault) noexcept;

/** The transport's next step. */
struct FalconLoaderStep
{
  enum class Kind : std::uint8_t
  {
    Request, ///< send Request, then call Done
    Write,   ///< write Size Bytes, then call Done
    Read,    ///< read; Size bytes are still due; call Receive or TimeOut
    Finished,
    Failed
  };
  Kind What = Kind::Failed;
  FtdiRequest Request = {};
  const std::uint8_t* Bytes = nullptr;
  std::size_t Size = 0;
  bool MayStayOpen = false; ///< true for a Read whose message is repeated: call TimeOut early
};

class FalconLoader
{
public:
  /** Begins the dialogue. The image has to stay in memory. */
  FalconLoader(const std::uint8_t* image, std::size_t size) noexcept;

  FalconLoaderStep GetStep() const noexcept;

  ///@{
  /** Reports the result of the step; ignored if the step has no such result. */
  void Done() noexcept;
  void Refuse() noexcept;
  /** Takes bytes without the converter's status bytes; they may be any part of the answer. */
  void Receive(const std::uint8_t* bytes, std::size_t size) noexcept;
  void TimeOut() noexcept;
  ///@}

  FalconLoaderFault GetFault() const noexcept { return this->Fault; }
  /** Returns how many bytes of the image came back unchanged. */
  std::size_t GetConfirmed() const noexcept { return this->Confirmed; }

private:
  enum class Stage : std::uint8_t
  {
    Prepare,
    Greet,
    GreetAgain,
    SpeedUp,
    Shake,
    Load,
    Run,
    Finished,
    Failed
  };
  struct Requests
  {
    const FtdiRequest* First = nullptr;
    std::size_t Count = 0;
  };
  Requests GetRequests() const noexcept;
  FtdiPayload GetMessage() const noexcept;
  FtdiPayload GetAnswer() const noexcept;
  void Enter(Stage stage) noexcept;
  void Answered() noexcept;
  void Deviate(
    FalconLoaderFault greeting, FalconLoaderFault shake, FalconLoaderFault echo) noexcept;
  void Fail(FalconLoaderFault fault) noexcept;

  FtdiPayload Image;
  std::size_t NextRequest = 0;
  std::size_t Offset = 0;  ///< the block's place in the image
  std::size_t Matched = 0; ///< bytes of the answer so far
  std::size_t Confirmed = 0;
  int Greetings = 0;
  bool Reading = false;
  bool ZeroTaken = false; ///< the zero that may precede the answer to a greeting
  Stage Now = Stage::Prepare;
  FalconLoaderFault Fault = FalconLoaderFault::None;
};

} // namespace VolumeHaptics

#endif
