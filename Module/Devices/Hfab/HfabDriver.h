// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Arms with an hfab controller, through a serial port: WoodenHaptics, Polhem, and PHANToMs with new
 * electronics.
 *
 * The driver sends currents for each force of the servo, or every 2 ms without a force. The
 * controller answers each message with its encoder counts and the model of its arm. Its firmware
 * sets the currents to zero after 100 ms without a message.
 *
 * The controller can't measure the absolute pose of its arm: its counts restart at 0 when it is
 * switched on and when its button is pushed, without a report. It is therefore calibrated whenever
 * it is opened, and after every fault: with the arm in its calibration pose, Home() stores the
 * counts, as the published host program does when the button is pushed. A jump that is too fast for
 * a hand is a fault, as is a push of the button in another pose.
 *
 * Without a force, no current flows: unlike the published host program, the driver does not
 * compensate the weight of the arm. Not verified on a device.
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
   * The USB names of published controllers' boards contain `Board`. The names of Haply's arms,
   * which use another protocol, do so, too, but also contain `OtherBoard`: ID_VENDOR Teensyduino,
   * ID_MODEL Haply_inverse3 (chohh7391/lerobot_teleoperator_inverse3 99063dc, SETUP.md).
   */
  static constexpr const char* Board = "Teensyduino";
  static constexpr const char* OtherBoard = "Haply";
  ///@}
  /** Longest wait (s) for the first answer. */
  static constexpr double HandshakeTime = 1.5;
  /**
   * Time (s) without an answer after which the device is lost. The force has ended before: the
   * servo ends it after 30 ms without positions, and the firmware after 100 ms without messages.
   */
  static constexpr double SilenceTime = 0.5;
  ///@{
  /**
   * Longest plausible motion of the tip (m) from one answer to the next, and its largest speed
   * (m/s) over a longer pause.
   */
  static constexpr double FarthestStep = 0.02;
  static constexpr double FastestHand = 2.5;
  ///@}
  /**
   * Time (s) for which the arm must be at rest for calibration, and number of counts that it may
   * move in this time.
   */
  static constexpr double StillTime = 0.2;
  static constexpr int StillCounts = 40;

  /** @param port path of the port, such as /dev/ttyACM0; if empty, the port of the only board */
  explicit HfabDriver(std::string port, std::string folder = SerialPort::NamesFolder);

  std::string GetName() const override { return this->Label; }
  DeviceLimits GetLimits() const override;
  std::string GetIdentity() const override { return this->Identity; }
  bool Connect(std::string& error) override;
  bool Reconnect(const std::string& identity, const std::function<bool()>& mustStop,
    std::string& error) override;
  void Serve(HardwareExchange& exchange) override;
  void SendLastZero() noexcept override { this->Rest(); }
  void Disconnect() noexcept override;

  /** Lists the ports of boards that may be controllers. */
  static std::vector<SerialPortInfo> ListBoardPorts(
    const std::string& folder = SerialPort::NamesFolder);
  /** Returns the identity of the board at a port, as used in the user's device file. */
  static std::string MakeIdentity(const SerialPortInfo& port);

private:
  enum class Phase : std::uint8_t
  {
    Waiting,     ///< waits until the user has moved the arm to its pose and calls Home()
    Calibrating, ///< waits until the arm is at rest
    Ready
  };
  enum class Reply : std::uint8_t
  {
    Answer,
    None,
    Gone
  };

  bool Choose(SerialPortInfo& port, std::string& error) const;
  bool Take(const SerialPortInfo& port, const std::function<bool()>& mustStop, std::string& error);
  bool Shake(const std::function<bool()>& mustStop, std::string& error);
  /** Sends currents (mA) and waits for the answer. */
  Reply Ask(const std::array<int, 3>& milliamperes) noexcept;
  /**
   * Returns whether the firmware waits for its button: instead of counts, it then answers with the
   * requested currents (woody_teensy_mini.ino, calibration_needed).
   */
  bool EchoesCurrents() noexcept;
  void Restart(HardwareExchange& exchange);
  void Round(HardwareExchange& exchange);
  bool ReceiveAnswer(HardwareExchange& exchange);
  void Calibrate(HardwareExchange& exchange);
  void UpdateHand(HardwareExchange& exchange);
  void Rest() noexcept;
  void Lose(HardwareExchange& exchange, const char* text) noexcept;
  void Report(HardwareExchange& exchange, DeviceStage stage, const char* text) const noexcept;

  const std::string Wanted;
  const std::string Folder; ///< folder with the names of ports
  std::string Label = "hfab controller";
  std::string Identity;
  SerialPort Port;
  HfabReader Reader;
  const HfabGeometry* Geometry = nullptr;
  int Model = 0;

  Phase Now = Phase::Waiting;
  bool Lost = false;
  bool Gone = false;        ///< whether the board is unplugged
  HfabModel::Counts Zero{}; ///< counts in the calibration pose minus the nominal counts
  HfabModel::Counts Raw{};
  HfabModel::Counts StillAt{};
  std::int64_t StillSince = 0;
  bool HandleMoves = false; ///< whether the handle's encoders have moved since the calibration
  bool HasTip = false;
  Vector3 Tip; ///< position of the tip along the arm's axes
  HfabModel::Angles JointAngles{};
  int Refusals = 0; ///< number of consecutive messages that the controller has refused
  std::int64_t LastAnswer = 0;
  double Pause = 0.0; ///< time (s) between the last two answers
};

} // namespace VolumeHaptics

#endif
