// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Arms with an hfab controller: WoodenHaptics, Polhem, re-driven PHANToMs, through a serial port.
 *
 * The controller answers each message with its counts and the model of its arm. It gets currents
 * with each force of the servo, or every 2 ms without one; its firmware sets them to zero after 100
 * ms without a message.
 *
 * The controller does not know where its arm is: its counts begin at 0 at power-up, and when its
 * button is pushed, and it never reports either. So it is calibrated whenever it is opened, and
 * after every fault: with the arm in its pose for calibration, Home() stores the counts, as the
 * published host does when the button is pushed. A jump that no hand makes is a fault; so is a push
 * of the button in another pose.
 *
 * No current flows without a force: unlike the published host, the driver does not compensate the
 * weight of the arm. Not verified on a device.
 */
#ifndef HfabDriver_h
#define HfabDriver_h

#include "Devices/Common/HardwareDevice.h"
#include "Devices/Hfab/HfabModel.h"
#include "Devices/Hfab/HfabProtocol.h"
#include "Devices/Transport/Serial/SerialPort.h"

namespace VolumeHaptics
{

class HfabDriver final : public HardwareDriver
{
public:
  ///@{
  /**
   * The names of published controllers' boards contain this word. So do the names of Haply's arms,
   * which need other messages, but these also contain the second word: ID_VENDOR Teensyduino,
   * ID_MODEL Haply_inverse3 (chohh7391/lerobot_teleoperator_inverse3 99063dc, SETUP.md).
   */
  static constexpr const char* Board = "Teensyduino";
  static constexpr const char* OtherBoard = "Haply";
  ///@}
  /** The wait (s) for the first answer. */
  static constexpr double HandshakeTime = 1.5;
  /**
   * The time (s) without an answer after which the device is lost. Force has ended long before,
   * since the servo ends it after 30 ms without positions, and the firmware after 100 ms without
   * messages.
   */
  static constexpr double SilenceTime = 0.5;
  ///@{
  /**
   * The longest way of the tip (m) from one answer to the next, and its largest speed (m/s) in a
   * longer pause: no hand is as fast.
   */
  static constexpr double FarthestStep = 0.02;
  static constexpr double FastestHand = 2.5;
  ///@}
  /**
   * How long (s) the arm has to be still to be calibrated, and the counts by which it may move
   * meanwhile.
   */
  static constexpr double StillTime = 0.2;
  static constexpr int StillCounts = 40;

  /** `port` is the port, such as /dev/ttyACM0; empty: the port of the only board. */
  explicit HfabDriver(std::string port, std::string folder = SerialPort::NamesFolder);

  std::string GetName() const override { return this->Label; }
  DeviceLimits GetLimits() const override;
  std::string GetIdentity() const override { return this->Identity; }
  bool Connect(std::string& error) override;
  void Serve(HardwareExchange& exchange) override;
  void Disconnect() noexcept override;

  /** Lists the ports of boards that may be controllers. */
  static std::vector<SerialPortInfo> ListBoardPorts(
    const std::string& folder = SerialPort::NamesFolder);
  /** Makes the identity of the board at a port for the user's file of devices. */
  static std::string MakeIdentity(const SerialPortInfo& port);

private:
  enum class Phase : std::uint8_t
  {
    Waiting,     ///< waits for the hand to put the arm into its pose, and for Home()
    Calibrating, ///< waits until the arm is still
    Ready
  };
  enum class Reply : std::uint8_t
  {
    Answer,
    None,
    Gone
  };

  bool Choose(SerialPortInfo& port, std::string& error) const;
  bool Shake(std::string& error);
  /** Sends currents and waits for the answer. */
  Reply Ask(const std::array<int, 3>& milliamperes) noexcept;
  void Restart(HardwareExchange& exchange);
  void Round(HardwareExchange& exchange);
  bool ReceiveAnswer(HardwareExchange& exchange);
  void Calibrate(HardwareExchange& exchange);
  void UpdateHand(HardwareExchange& exchange);
  void Rest() noexcept;
  void Lose(HardwareExchange& exchange, const char* text) noexcept;
  void Report(HardwareExchange& exchange, DeviceStage stage, const char* text) const noexcept;

  const std::string Wanted;
  const std::string Folder; ///< the folder that names ports
  std::string Label = "hfab controller";
  std::string Identity;
  SerialPort Port;
  HfabReader Reader;
  const HfabGeometry* Geometry = nullptr;
  int Model = 0;

  Phase Now = Phase::Waiting;
  bool Lost = false;
  bool Gone = false;        ///< whether the board is unplugged
  HfabModel::Counts Zero{}; ///< counts in the pose for calibration, less the nominal counts
  HfabModel::Counts Raw{};
  HfabModel::Counts StillAt{};
  std::int64_t StillSince = 0;
  bool HasTip = false;
  Vector3 Tip; ///< the tip in the arm's axes
  HfabModel::Angles JointAngles{};
  int Refusals = 0; ///< number of messages in a row that the controller refused
  std::int64_t LastAnswer = 0;
  double Pause = 0.0; ///< s, the time between the last two answers
};

} // namespace VolumeHaptics

#endif
