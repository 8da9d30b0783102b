// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * An emulated Novint Falcon with its serial converter: loader, firmware, homing, and a grip in a
 * hand. It is written from published facts alone. Every run packet advances its time by a
 * millisecond.
 *
 * Homing: include/falcon/firmware/FalconFirmwareNovintSDK.h of libnifalcon/libnifalcon (commit
 * 0cf9f06) describes the three bits of homed encoders as "(If homing mode on)". While that mode is
 * on, formatInput() in src/firmware/FalconFirmwareNovintSDK.cpp sends its bit (0x01) with every
 * packet. No source states how a packet without this bit affects a known zero. This model assumes
 * the worst case: the zero is lost until the mode is on again and the grip has been at both ends. A
 * driver that omits the bit thus fails here, even if a real device would accept it.
 *
 * Converter: in libftdi 1.5, src/ftdi.h, 2 drops data that the device has sent (SIO_TCIFLUSH), and
 * 1 drops data on their way to the device (SIO_TCOFLUSH). The older SIO_RESET_PURGE_RX and _TX, 1
 * and 2, are deprecated there because they are swapped.
 *
 * Loader and answers, as libnifalcon (commit f7c727a) handles them:
 * - setFirmwareMode() in src/comm/FalconCommLibUSB.cpp accepts the greeting's answer with and
 *   without a leading 0x00, and greets up to 100 times.
 * - nifalcon_load_firmware() in boneyard/c_driver/nifalcon_ftd2xx.c (commit 28347c2) expects 13 41
 *   as the first answer to 41, and 41 alone as later answers.
 * - openDevice() in src/util/FalconCLIBase.cpp tries ten times to load. Between two attempts, it
 *   "completely" closes the device and opens it again: a loader may be stuck until then, or a load
 *   may fail by a wrong echo or no echo.
 * - The answer to the greeting may come after the host has stopped waiting for it.
 * - isFirmwareLoaded() in src/core/FalconFirmware.cpp says "Sometimes we need to kick out another
 *   write to get a proper return". Such an answer is late: it comes after the next packet was sent,
 *   and before that packet's own answer.
 */
#ifndef FalconModel_h
#define FalconModel_h

#include "DeviceModels.h"
#include "FalconMechanics.h"
#include "ModelClock.h"

#include <deque>
#include <memory>
#include <mutex>
#include <utility>

namespace emulated
{

/** Faults that a test can inject into the device. */
enum class FalconFault
{
  None,
  ShortPacket, ///< an answer without its last bytes
  Garbage,     ///< an answer that is not a packet
  Silence,     ///< no answer
  LateAnswer,  ///< an answer that arrives after the next packet
  StallOut,
  StallIn,
  BadCable,     ///< OUT transfers fail with EPROTO
  StuckOut,     ///< OUT transfers never end
  Nowhere,      ///< encoder counts that correspond to no position
  Jump,         ///< encoder counts of a position 25 mm away
  LostZero,     ///< an encoder that loses its homing
  NoGreeting,   ///< no answer from the loader
  LateGreeting, ///< an answer to a greeting that arrives just before the host's next request
  LeadingZero,  ///< a 0x00 before the answer to a greeting
  LeadingShake, ///< a 0x13 before the answer at the loading rate
  StuckLoader,  ///< no answer until the device has been reopened the given number of times
  WrongEcho,    ///< a byte of the image that is echoed incorrectly
  NoEcho,       ///< a block of the image that is not echoed
  DeadImage     ///< an image that is accepted, but does not run
};

class FalconModel : public UsbModel
{
public:
  explicit FalconModel(bool runs = true)
    : Runs(runs)
  {
  }

  std::vector<std::uint8_t> GetDescriptors() const override;
  int Control(const std::uint8_t setup[8], std::uint8_t* data, int size) override;
  int Out(std::uint8_t endpoint, const std::uint8_t* bytes, int size) override;
  int In(std::uint8_t endpoint, std::uint8_t* bytes, int size) override;
  void Released() override;

  ///@{
  /**
   * Injects a fault that lasts for this number of packets, greetings or blocks. Any thread may call
   * it.
   */
  void Break(FalconFault fault, int packets = 1 << 30);
  /**
   * Sets whether answers take time and arrive one by one; otherwise, each answer follows its packet
   * at once.
   */
  void SetTimed(bool timed);
  /**
   * Returns the number of consecutive packets that arrived while no answer was on its way to the
   * host.
   */
  long GetInStep() const;
  /**
   * Sets the faults of the next attempts to load, in order. FalconFault::None lets an attempt
   * succeed.
   */
  void BreakAttempts(const std::vector<FalconFault>& faults);
  void SetButtons(int bits);
  void SetAim(const Numbers& aim);
  /** Sets the sign of all motors: 1, or -1 for motors with reversed wiring. */
  void SetMotorSign(double sign);
  void SetHeld(bool held); ///< clamps the grip, so that it moves exactly to its target
  Numbers GetGrip() const;
  Numbers GetHand() const;
  Numbers GetCommands() const; ///< returns the motor commands of the last packet
  Numbers GetForce() const;    ///< returns the motors' force (N) at the last packet
  int GetLights() const;       ///< returns the lights of the last packet
  long GetPackets() const;
  double DrainLargestCommand(); ///< returns the largest command since the last call
  /** Returns the number and the time of the last packet with a nonzero command. */
  std::pair<long, std::chrono::steady_clock::time_point> GetLastPush() const;
  std::vector<std::uint8_t> GetImage() const;
  void SetImageSize(std::size_t bytes); ///< sets the smallest size of an image that runs (bytes)
  bool IsRunning() const;
  /** Interrupts the power, which makes the device lose its firmware and its zero. */
  void SwitchOff();
  /**
   * Returns the transfers that the host has sent since the last call, one per line. "c 40 09 0010"
   * is a control request of type 0x40, number 9, value 0x10. "o " followed by hexadecimal bytes is
   * a data transfer.
   */
  std::vector<std::string> DrainTranscript();
  ///@}

private:
  int GetMode() const; ///< returns 0 for greeting, 1 for loading, 2 for running, -1 for none
  bool Takes(FalconFault fault);
  void Send(const std::string& bytes);
  void Deliver();
  void Greet(const std::string& bytes);
  void Load(const std::string& bytes);
  void ReceiveByte(std::uint8_t byte);
  void ReceivePacket();
  void FindZero(const Numbers& counts, bool asked);
  std::string MakeReport(Numbers counts);

  mutable std::mutex Mutex;
  FalconGrip Grip;
  double MotorSign = 1.0;
  Numbers Commands{};
  Numbers Force{};
  double LargestCommand = 0.0;
  std::array<bool, 3> SeenOut{};
  std::array<bool, 3> SeenIn{};
  int Homed = 0;
  int Buttons = 0;
  int Lights = 0;
  long Packets = 0;
  std::pair<long, std::chrono::steady_clock::time_point> LastPush{};
  FalconFault Fault = FalconFault::None;
  int FaultyPackets = 0;
  int Baud = 0;
  bool Runs;
  bool IsShaken = false;
  std::string Waiting; ///< bytes of an incomplete run packet or greeting
  std::vector<std::uint8_t> Image;
  std::size_t ImageSize = 1;
  std::deque<std::string> Replies; ///< answers, each for one transfer
  std::deque<std::string> Pending; ///< answers on their way to the host
  std::string Late;                ///< an answer that waits for the next packet or request
  long InStep = 0;
  std::deque<FalconFault> Attempts; ///< faults of the next attempts to load
  std::vector<std::string> Transcript;
  std::unique_ptr<ModelClock> Clock; ///< last member, so that its thread ends first
};

} // namespace emulated

#endif
