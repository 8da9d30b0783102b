// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The parts behind vtkHapticDevice: the open back end, its running servo, and the latest state.
 */
#ifndef DeviceSession_h
#define DeviceSession_h

#include "Core/Servo/RoundTripInUse.h"
#include "Devices/Common/DeviceKind.h"
#include "Devices/Common/DeviceMemory.h"
#include "Devices/Virtual/VirtualDevice.h"
#include "Devices/Xr/XrDevice.h"
#include "VTK/Device/DeviceStatus.h"
#include "VTK/Device/ServoThreads.h"
#include "VTK/Trace/HapticTraceFiles.h"

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

class vtkTable;

namespace VolumeHaptics
{

/** Shares of work in the background: see DeviceSession::NoteBackgroundWork. */
constexpr double WorkEnded = -1.0;
constexpr double ShareUnknown = -2.0;

class DeviceSession
{
public:
  ~DeviceSession() { this->Close(); }

  bool Open(const std::string& id, const DeviceOptions& options, std::string& error);
  void Close();
  bool IsOpen() const { return this->Backend != nullptr; }
  /** A number that changes with each Open or Close. */
  int GetOpening() const { return this->Opening; }
  const std::string& GetId() const { return this->Id; }
  DeviceLimits GetLimits() const
  {
    return this->Backend ? this->Backend->GetLimits() : DeviceLimits{};
  }
  /** The back end if the program leads its tip; else null. */
  VirtualDevice* GetVirtual() const { return this->Virtual; }
  /** See vtkHapticDevice::TakeVibration. */
  double TakeVibration() { return this->Xr ? this->Xr->TakeAmplitude() : 0.0; }

  ///@{
  /**
   * The facts of the device: those that the user's file remembers (DeviceMemory.h), or if it is not
   * remembered, those since Open. And the error of that file since the last call; empty if there is
   * none.
   */
  const DeviceFacts& GetFacts() const { return this->Facts; }
  std::string TakeMemoryTrouble() { return std::exchange(this->MemoryTrouble, {}); }
  /** Whether it is a device with facts: one with force and an identity. */
  bool HasFacts() const { return !this->Identity.empty(); }
  /** Whether the user's file remembers them: no other device has its identity. */
  bool IsRemembered() const { return this->HasFacts() && this->Backend->KeepsIdentity(); }
  /** Its calibration as text; empty if it has no facts. */
  std::string DescribeCalibration() const
  {
    return this->HasFacts() ? this->Facts.DescribeScale() : std::string();
  }
  /** Whether its signs have to be confirmed before anything is felt. */
  bool NeedsConfirmation() const;
  /** Whether it is open and needs no confirmation. */
  bool AreSignsConfirmed() const { return this->IsOpen() && !this->NeedsConfirmation(); }
  /** From the next Start on, its signs have to be confirmed again. While the servo does not run. */
  void ForgetConfirmation();
  /** From now on the device gives so many newtons for each one that it is asked for. */
  void SetForceScale(double scale);
  ///@}

  /** Starts the servo; the placement maps the world positions of a replay. */
  void Start(double rate, const SafetyLimits& limits, std::shared_ptr<const HapticModel> model,
    const Affine3& deviceToWorld);
  void Stop();
  bool IsRunning() const { return this->Servo != nullptr; }
  /** False in a process that was forked from the one that the servo belongs to. */
  bool IsOurs() const { return !this->Servo || this->Servo->IsOurs(); }
  ///@{
  /** Null if the servo does not run. */
  ServoLoop* GetLoop() const { return this->Servo ? &this->Servo->GetLoop() : nullptr; }
  /**
   * How the hand holds its tool, in the device's space, if the device measures no orientation, for
   * this and later servos: see HandTurn.h. Nothing takes it away.
   */
  void TurnHand(const std::optional<Quaternion>& orientation);
  ///@{
  /** See vtkHapticDevice::SetSpinning. */
  void Spin(bool on);
  bool IsSpinOrdered() const { return this->Spinning; }
  ///@}
  TickCollector* GetTicks() const { return this->Servo ? &this->Servo->GetTicks() : nullptr; }
  ///@}

  /** The caps of the device for the round trip in use, or a period of the rate (Hz). */
  ForceCaps FindCaps(double rate) const;
  /** The caps of the model that is felt: those of the user, too. All 0 without a model. */
  ForceCaps GetCaps() const;

  /** Ticks per second of the running servo. */
  double GetRate() const { return this->Rate; }

  /** The owner is present: see vtkHapticDevice::SetAttentionTime. */
  void Attend();
  void Arm(bool on);
  void FadeOut();
  /** See ServoLoop::IsArmOrdered. */
  bool IsArmOrdered() const
  {
    return this->Servo ? this->Servo->GetLoop().IsArmOrdered()
                       : this->ArmsAtStart && !this->Clutched;
  }
  ///@{
  /**
   * See vtkHapticDevice::SetClutch. The clutch outlives the servo and the device that is open.
   */
  void SetClutched(bool on);
  bool IsClutched() const { return this->Clutched; }
  /** Whether force returns with the end of the clutch, as far as orders tell. */
  bool ReturnsAfterClutch() const
  {
    return this->Servo ? this->Servo->GetLoop().ReturnsAfterClutch()
                       : this->Clutched && this->ArmsAtStart;
  }
  ///@}
  /** Whether the last order was Arm, clutched or not. */
  bool HasArmOrder() const { return this->IsArmOrdered() || this->ReturnsAfterClutch(); }
  ///@{
  /**
   * Work of the owner, long or not: see vtkHapticDevice::BeginLongWork. BeginWork returns true if
   * the force ends because of it, EndWork if the force may come back. Works nest and outlive the
   * servo.
   */
  bool BeginWork(const std::string& what, bool isLong);
  bool EndWork();
  bool HasWork() const { return !this->Works.empty(); }
  ///@}
  /**
   * Work that nothing waits for, such as "the volume is hashed", for the status: its share that is
   * done, or that this is not known, or that it has ended.
   */
  void NoteBackgroundWork(const std::string& what, double share);
  /** For the status, the news of a volume that is read by regions; empty if nothing is awaited. */
  void NoteRegion(const std::string& status) { this->RegionStatus = status; }
  /** The same of the frames of a volume that moves. */
  void NoteFrames(const std::string& status) { this->FramesStatus = status; }
  /** Whether the device is open and, as far as is known now, can be felt. */
  bool IsReady() const
  {
    return this->Backend && this->Backend->GetCondition().Stage == DeviceStage::Ready;
  }
  void Home();
  void SetLights(int lights)
  {
    if (this->Backend)
    {
      this->Backend->SetLights(lights);
    }
  }

  /** Takes the latest state; without a model, the placement is used. */
  bool Update(const Affine3& deviceToWorld);
  const ServoSnapshot& GetState() const { return this->State; }
  /** The model of the latest state; null without one. */
  const HapticModel* FindModel()
  {
    return this->Servo ? this->Servo->GetTicks().FindModel(this->State.Generation) : nullptr;
  }

  /**
   * All states since a reader's last call, as rows of a table: see vtkHapticDevice::DrainStates.
   */
  void DrainStates(const Affine3& deviceToWorld, vtkTable* table, int reader);
  ///@{
  /** Reserves a number for DrainStates, and gives it back: see vtkHapticDevice::AddReader. */
  int AddReader();
  void RemoveReader(int reader);
  ///@}

  /** The status as of the last Update. It refers to this object. */
  DeviceStatus GetStatus() const;

  ///@{
  /** World positions of the latest state. */
  double Tip[3] = {};
  double Proxy[3] = {};
  double Force[3] = {};
  double ComputedForce[3] = {};
  double Torque[3] = {};         ///< N m, world axes
  double ComputedTorque[3] = {}; ///< N m, world axes
  double Normal[3] = {};
  double SurfacePosition[3] = {};
  double MediumPosition[3] = {};
  double ModeForces[MostPrimitives + 1][3] = {}; ///< N, world axes; the last one is 0
  ///@}
  /// w, x, y, z of the latest state, in the world; not turned if the device has none
  std::array<double, 4> Orientation{ 1.0, 0.0, 0.0, 0.0 };
  /// w, x, y, z of a tool with a shape in the latest state, in the world; all 0 without one
  std::array<double, 4> ToolOrientation{};
  bool IsAtForbidden = false; ///< of the latest state: see vtkHapticDevice::IsAtForbiddenLabel
  std::int64_t Label = 0;     ///< of the latest state: see vtkHapticDevice::GetLabel
  double TurnRate[3] = {};    ///< rad/s, of the latest state, in the device's axes

private:
  struct Work
  {
    std::string What;
    bool IsLong;
  };
  /** The outermost work that is long; null if there is none. */
  const Work* FindLongWork() const;
  /** Publishes the last model with other caps if the measured round trip asks for it. */
  void FollowRoundTrip();
  /** Writes the facts to the user's file if the device is remembered. */
  void Remember();
  void RequireConfirmation();

  std::string Id;
  std::unique_ptr<DeviceBackend> Backend;
  std::string Identity; ///< of the back end; empty: it has no facts
  DeviceFacts Facts;
  std::string MemoryTrouble;
  int Opening = 0;
  VirtualDevice* Virtual = nullptr;
  XrDevice* Xr = nullptr; ///< then it is Virtual, too
  bool IsReplay = false;
  RecordedTips Replay;
  std::unique_ptr<ServoThreads> Servo;
  ServoSnapshot State;
  bool ArmsAtStart = false;           ///< Arm was ordered before the servo ran
  bool Clutched = false;              ///< as ordered
  std::optional<Quaternion> HandTurn; ///< see TurnHand
  bool Spinning = false;              ///< as ordered
  double Rate = 0.0;
  RoundTripInUse RoundTrip;
  std::map<std::string, double> BackgroundWorks; // with the share that is done
  std::string RegionStatus;
  std::string FramesStatus;
  std::vector<Work> Works;
  std::set<int> Readers; ///< numbers of AddReader
};

} // namespace VolumeHaptics

#endif
