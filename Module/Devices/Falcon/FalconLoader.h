// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Loads the Novint Falcon's firmware: a state machine for the protocol, without a transport.
 *
 * The firmware must not be part of this project, so the user names a file. A device whose firmware
 * already runs needs no loading, so check this first: send FalconRunRequests and a run packet, and
 * wait for a report.
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
/** Number of bytes of the firmware image per packet: 64 bytes less the two status bytes. */
constexpr std::size_t FalconBlockSize = 62;
constexpr int FalconMostGreetings = 100;

/** Requests to send before run packets are exchanged. */
constexpr std::array<FtdiRequest, 4> FalconRunRequests = { FtdiLatency(1), FtdiBaud(FalconRunBaud),
  FtdiPurgeTransmit, FtdiPurgeReceive };

enum class FalconLoaderFault : std::uint8_t
{
  None,
  NoImage,        ///< the image is empty
  Refused,        ///< a request or a write failed
  NoGreeting,     ///< FalconMostGreetings greetings were sent without an answer to the last one
  WrongGreeting,  ///< the answer to the last greeting was wrong
  NoHandshake,    ///< there was no answer at the loading rate
  WrongHandshake, ///< the answer at the loading rate was wrong
  NoEcho,         ///< a block of the image was not echoed in time
  WrongEcho       ///< the echo of a block differed, or was too long
};

/** Returns a description of the fault. */
const char* FalconLoaderFaultText(FalconLoaderFault fault) noexcept;

/** The next step for the transport. */
struct FalconLoaderStep
{
  enum class Kind : std::uint8_t
  {
    Request, ///< send Request, then call Done()
    Write,   ///< write Size bytes, then call Done()
    Read,    ///< read, then call Receive() or TimeOut(); Size is the number of bytes still expected
    Finished,
    Failed
  };
  Kind What = Kind::Failed;
  FtdiRequest Request = {};
  const std::uint8_t* Bytes = nullptr;
  std::size_t Size = 0;
  /**
   * Whether an answer may be missing, as to a greeting, which is repeated. The transport may then
   * end a Read early with TimeOut().
   */
  bool MayStayOpen = false;
};

class FalconLoader
{
public:
  /** Begins with the first step. The image must stay in memory until the last step. */
  FalconLoader(const std::uint8_t* image, std::size_t size) noexcept;

  FalconLoaderStep GetStep() const noexcept;

  ///@{
  /** Report the result of the step. Calls that don't match the step are ignored. */
  void Done() noexcept;
  void Refuse() noexcept;
  /**
   * Processes received bytes, without the converter's status bytes. The answer may arrive in parts
   * of any size.
   */
  void Receive(const std::uint8_t* bytes, std::size_t size) noexcept;
  void TimeOut() noexcept;
  ///@}

  FalconLoaderFault GetFault() const noexcept { return this->Fault; }
  /** Returns the number of bytes of the image that were echoed correctly. */
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
  std::size_t Offset = 0;  ///< offset of the block in the image
  std::size_t Matched = 0; ///< number of received bytes of the answer that match
  std::size_t Confirmed = 0;
  int Greetings = 0;
  bool Reading = false;
  /** Whether the optional byte before the answer to a greeting or a handshake was received. */
  bool LeadTaken = false;
  Stage Now = Stage::Prepare;
  FalconLoaderFault Fault = FalconLoaderFault::None;
};

} // namespace VolumeHaptics

#endif
