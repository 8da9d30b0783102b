// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * An Inverse3, Inverse3x or Minverse, through Haply's Inverse service on this computer.
 *
 * The service answers each message with one state. The thread of the device sends one when the
 * servo gives a force, or after 2 ms without one, and waits for its state: so the servo sets the
 * pace, and it never waits. At most one message waits for its state. After the time of the servo's
 * watchdog, one more message is sent, with zero force; when both are answered, work continues. If
 * more states come than messages were sent, the newest state counts, so that positions never fall
 * behind.
 *
 * The arm is ready after the service has reported it as calibrated and ready. A flag that the
 * service omits keeps its last value.
 *
 * The first message and the last one have zero force. The documentation says that a force holds for
 * a tick and that a device becomes idle if no more come, but neither after how long, nor what
 * happens if the program ends or stands still between two messages. So the limits are low: 2 N is
 * the limit in NVIDIA Isaac Lab's published driver (isaaclab/devices/haply, HaplyDeviceCfg); the
 * default force here is half of it. The radii of the workspaces come from Haply's tutorials 05 and
 * 06. The stiffness and the speed are WoodenHaptics', a device of the same size. Not verified on a
 * device.
 *
 * If the service is of 3.5 or later, the session's origin is the middle of the workspace. Before
 * that it is a fixed place in front of the arm's base.
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
  /** How long (s) the service may omit the arm's position. */
  static constexpr double SilenceTime = 0.1;
  /** The least number of waits in SilenceTime: if this computer was late, the service was not. */
  static constexpr int SilentWaits = 4;
  /** m; a hand leads the tip, so it never makes a longer step */
  static constexpr double FarthestStep = 0.02;
  /**
   * The number of positions in a row without a longer step before the device is ready, because
   * presets move the origin.
   */
  static constexpr int SettledStates = 50;
  /** The origin in Haply's axes (m) if there are no presets. */
  static constexpr Vector3 Centre{ 0.0, -0.12, 0.15 };

  /** `id` is the service's name of a device, such as "049D"; empty: the first device. */
  explicit HaplyDriver(std::string id)
    : Wanted(std::move(id))
  {
  }

  std::string GetName() const override { return this->Label; }
  DeviceLimits GetLimits() const override;
  std::string GetIdentity() const override { return this->Id.empty() ? "" : "haply:" + this->Id; }
  bool Connect(std::string& error) override;
  void Serve(HardwareExchange& exchange) override;
  void Disconnect() noexcept override;

private:
  /** Opens the connection and reads the inventory. */
  bool OpenConnection(std::string& error);
  bool Choose(std::string& error);
  /** Returns whether a session has the arm, judging by the last message. */
  bool IsTaken() const;
  /** Begins the session of the chosen arm, if it is free. */
  bool SendFirstMessage(std::string& error);
  void Restart(HardwareExchange& exchange);
  void Work(HardwareExchange& exchange);
  void Send(const Vector3& force);
  void ReceiveStates(HardwareExchange& exchange);
  void ReceiveState(HardwareExchange& exchange, const HaplyArm& arm);
  void CopyGrips(DeviceSample& sample) const;
  void ReceiveEvents(HardwareExchange& exchange);
  /** Copies the flags of the arm; flags that the message omits keep their values. */
  void CopyFlags(const HaplyArm& arm);
  void UpdateStatus(HardwareExchange& exchange, const HaplyArm& arm);
  void CheckSilence(HardwareExchange& exchange);
  void Rest() noexcept;
  /** Stops all work until homing is requested; the text follows the device's name. */
  void Lose(HardwareExchange& exchange, const std::string& text);
  void Report(HardwareExchange& exchange, DeviceStage stage, const std::string& text) const;

  const std::string Wanted;
  ///@{
  /** Set by Connect, not by the device's thread. */
  std::string Label = "Haply";
  std::string Id;
  std::string Type;
  ///@}
  HaplyPorts Ports;
  HaplyAddress Address;
  WebSocketClient States;
  WebSocketClient Events;
  bool HasEvents = false; ///< whether the end of the events is yet to be reported

  HaplyMessage Message; ///< the last message
  std::string Text;
  std::string Newest; ///< the newest state, as text
  bool IsLost = false;
  bool IsReady = false; ///< whether the device may give force
  ///@{
  /** The flags as the service reported them last; false before. */
  bool IsCalibrated = false;
  bool IsArmReady = false;
  ///@}
  bool HasSentRelief = false; ///< whether a message of zero force follows an unanswered one
  int Awaited = 0;            ///< number of messages without a state
  std::int64_t SentAt = 0;
  std::int64_t ToldAt = 0; ///< the time at which the last position came
  int EmptyWaits = 0;
  int Settled = 0; ///< positions in a row without a step
  Vector3 Tip;     ///< last position, in the device's axes
  bool HasTip = false;
  HaplyTransform Transform;      ///< the last transform received
  std::string Note;              ///< the last warning of the service
  const char* Request = nullptr; ///< last request to the hand
};

} // namespace VolumeHaptics

#endif
