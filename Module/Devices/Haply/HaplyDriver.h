// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * An Inverse3, Inverse3x or Minverse, through Haply's Inverse service on this computer.
 *
 * The service answers each message with a state. The device's thread sends a message when the servo
 * has a force, or after 2 ms without one, and waits for the state. The servo thus sets the rate and
 * never waits. At most one message is unanswered. If its answer is later than the servo's watchdog
 * time, one more message is sent, with zero force; work continues when both are answered. If more
 * states arrive than messages were sent, only the newest one is used, so that positions never fall
 * behind.
 *
 * The arm is ready when the service has reported it as calibrated and ready. A flag that the
 * service omits keeps its last value.
 *
 * The first and the last message have zero force. According to the documentation, a force lasts for
 * a tick, and a device becomes idle without further forces. It states neither the time nor what
 * happens if the program ends or stops between two messages. Therefore the limits are low: 2 N is
 * the limit in NVIDIA Isaac Lab's published driver (isaaclab/devices/haply, HaplyDeviceCfg), and
 * the default force here is half of it. The radii of the workspaces are from Haply's tutorials 05
 * and 06. Stiffness and speed are those of WoodenHaptics, a device of the same size. Not verified
 * on a device.
 *
 * Services of version 3.5 or later are asked to place the session's origin at the centre of the
 * workspace, and report the preset in use; messages repeat the request until the arm is ready.
 * Presets with the origin at the arm's base, and services before 3.5, have the centre at a fixed
 * position. Presets with other axes are refused.
 */
#ifndef HaplyDriver_h
#define HaplyDriver_h

#include "Devices/Common/HardwareDevice.h"
#include "Devices/Haply/HaplyMessages.h"
#include "Devices/Haply/HaplyService.h"
#include "Devices/Transport/WebSocket/WebSocketClient.h"

namespace VolumeHaptics
{

class HaplyDriver final : public HardwareDriver
{
public:
  /** Longest time (s) for which the service may omit the arm's position. */
  static constexpr double SilenceTime = 0.1;
  /**
   * Smallest number of waits within SilenceTime before the service counts as silent, because this
   * computer itself may have been delayed.
   */
  static constexpr int SilentWaits = 4;
  /**
   * Longest plausible distance (m) between two successive positions of the tip, which a hand moves.
   */
  static constexpr double FarthestStep = 0.02;
  /**
   * Number of consecutive positions without a longer step after which the device is ready. A preset
   * moves the origin, which causes such a step.
   */
  static constexpr int SettledStates = 50;
  /** The centre of the workspace in Haply's axes (m), relative to the arm's base. */
  static constexpr Vector3 Centre{ 0.0, -0.12, 0.15 };

  /**
   * @param id the service's name of a device, such as "049D"; if empty, the first device is used
   */
  explicit HaplyDriver(std::string id)
    : Wanted(std::move(id))
  {
  }

  std::string GetName() const override { return this->Label; }
  DeviceLimits GetLimits() const override;
  std::string GetIdentity() const override { return this->Id.empty() ? "" : "haply:" + this->Id; }
  bool Connect(std::string& error) override;
  bool Reconnect(const std::string& identity, const std::function<bool()>& mustStop,
    std::string& error) override;
  void Serve(HardwareExchange& exchange) override;
  void SendLastZero() noexcept override { this->States.WriteLastWord(); }
  void Disconnect() noexcept override;

private:
  /**
   * Opens the connection and reads the inventory. Each step takes at most `time` (s); no step
   * begins after `mustStop` has returned true.
   */
  bool OpenConnection(double time, const std::function<bool()>& mustStop, std::string& error);
  bool Choose(std::string& error);
  /** Returns whether a session controls the arm, according to the last message. */
  bool IsTaken() const;
  /** Begins a session with the chosen arm unless another session controls it. */
  bool SendFirstMessage(std::string& error);
  void Restart(HardwareExchange& exchange);
  void Work(HardwareExchange& exchange);
  void Send(const Vector3& force);
  void ReceiveStates(HardwareExchange& exchange);
  void ReceiveState(HardwareExchange& exchange, const HaplyArm& arm);
  /**
   * Returns whether the origin is known: the service has reported it, or it is at the arm's base.
   */
  bool KnowsOrigin() const noexcept;
  void CopyGrips(DeviceSample& sample) const;
  void ReceiveEvents(HardwareExchange& exchange);
  /** Copies the flags of the arm. A flag that the message omits keeps its last value. */
  void CopyFlags(const HaplyArm& arm);
  void UpdateStatus(HardwareExchange& exchange, const HaplyArm& arm);
  void CheckSilence(HardwareExchange& exchange);
  void Rest() noexcept;
  /**
   * Reports the device as lost, and stops all work until homing is requested. The reported text
   * begins with the device's name.
   */
  void Lose(HardwareExchange& exchange, const std::string& text);
  void Report(HardwareExchange& exchange, DeviceStage stage, const std::string& text) const;

  const std::string Wanted;
  ///@{
  /** Members that Connect() sets, on the owner's thread. */
  std::string Label = "Haply";
  std::string Id;
  std::string Type;
  ///@}
  HaplyPorts Ports;
  HaplyAddress Address;
  WebSocketClient States;
  WebSocketClient Events;
  bool HasEvents = false; ///< whether the end of the event channel still has to be reported

  HaplyMessage Message; ///< last message, parsed
  std::string Text;
  std::string Newest; ///< text of the newest state
  bool IsLost = false;
  bool IsGone = false;  ///< whether the arm was unplugged or the service has ended
  bool IsReady = false; ///< whether the device may exert a force
  ///@{
  /** The flags as the service last reported them; false before the first report. */
  bool IsCalibrated = false;
  bool IsArmReady = false;
  ///@}
  /** Whether a message with zero force was sent after an unanswered one. */
  bool HasSentRelief = false;
  int Awaited = 0; ///< number of unanswered messages
  std::int64_t SentAt = 0;
  std::int64_t HeardAt = 0; ///< time at which the last state was received
  std::int64_t ToldAt = 0;  ///< time at which the last state with a position was received
  int EmptyWaits = 0;
  int Settled = 0; ///< number of consecutive positions without a long step
  Vector3 Tip;     ///< last position along the device's axes
  bool HasTip = false;
  HaplyTransform Transform; ///< last received transform
  std::string Preset;       ///< last preset received in this session
  int Untold = 0;   ///< number of states without a preset before the first one with a preset
  std::string Note; ///< last warning of the service
  const char* Request = nullptr; ///< last instruction to the user
};

} // namespace VolumeHaptics

#endif
