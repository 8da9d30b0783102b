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

#include "vtkHapticState.h"
#include "vtkNew.h"

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

/** Values of `share` in DeviceSession::SetBackgroundWork. */
constexpr double WorkEnded = -1.0;
constexpr double FractionUnknown = -2.0;

class DeviceSession
{
public:
  ~DeviceSession() { this->Close(); }

  bool Open(const std::string& id, const DeviceOptions& options, std::string& error);
  void Close();
  bool IsOpen() const { return this->Backend != nullptr; }
  /** Returns a number that changes with each Open or Close. */
  int GetOpening() const { return this->Opening; }
  const std::string& GetId() const { return this->Id; }
  DeviceLimits GetLimits() const
  {
    return this->Backend ? this->Backend->GetLimits() : DeviceLimits{};
  }
  /** Returns the back end if the program leads its tip; null otherwise. */
  VirtualDevice* GetVirtual() const { return this->Virtual; }
  /**
   * Returns whether the mouse may lead the tip. The tip of an XR device is led by a headset
   * instead.
   */
  bool MayMouseLead() const { return this->Virtual && !this->Xr; }
  /** Returns how strongly to vibrate: see vtkHapticVirtualHand::TakeVibration. */
  double TakeVibration() { return this->Xr ? this->Xr->DrainAmplitude() : 0.0; }

  ///@{
  /**
   * GetFacts() returns the facts of the device: those in the user's file (DeviceMemory.h), or, if
   * the file does not remember the device, the facts since Open. DrainMemoryTrouble() returns an
   * error of that file that occurred since its last call; empty if there was none.
   */
  const DeviceFacts& GetFacts() const { return this->Facts; }
  std::string DrainMemoryTrouble() { return std::exchange(this->MemoryTrouble, {}); }
  /** Returns whether the device has facts: it gives force and has an identity. */
  bool HasFacts() const { return !this->Identity.empty(); }
  /** Returns whether the user's file remembers its facts: no other device has its identity. */
  bool IsRemembered() const { return this->HasFacts() && this->Backend->KeepsIdentity(); }
  /** Describes the device's calibration; empty if the device has no facts. */
  std::string DescribeCalibration() const
  {
    return this->HasFacts() ? this->Facts.DescribeScale() : std::string();
  }
  /** Returns whether the device's signs have to be confirmed before anything is felt. */
  bool NeedsConfirmation() const;
  /** Returns whether the device is open and needs no confirmation. */
  bool AreSignsConfirmed() const { return this->IsOpen() && !this->NeedsConfirmation(); }
  /**
   * Makes the next Start require that the signs are confirmed again. Call it while the servo does
   * not run.
   */
  void ForgetConfirmation();
  /** Sets how many newtons the device gives for each newton that it is asked for. */
  void SetForceScale(double scale);
  ///@}

  /** Starts the servo; the placement maps the world positions of a replay. */
  void Start(double rate, const SafetyLimits& limits, std::shared_ptr<const HapticModel> model,
    const Affine3& deviceToWorld);
  void Stop();
  bool IsRunning() const { return this->Servo != nullptr; }
  /**
   * Returns whether this process itself started the servo, or no servo runs; false in a fork of the
   * process that started it.
   */
  bool IsOurs() const { return !this->Servo || this->Servo->IsOurs(); }
  ///@{
  /** Returns the loop of the servo; null if the servo does not run. */
  ServoLoop* GetLoop() const { return this->Servo ? &this->Servo->GetLoop() : nullptr; }
  /**
   * Sets how the hand holds its tool, in the device's space, if the device measures no orientation:
   * see HandTurn.h. Holds for this and later servos. An empty `orientation` removes it.
   */
  void TurnHand(const std::optional<Quaternion>& orientation);
  ///@{
  /** Starts or stops the spinning of a burr: see vtkHapticVirtualHand::SetSpinning. */
  void Spin(bool on);
  bool IsSpinOrdered() const { return this->Spinning; }
  ///@}
  TickCollector* GetTicks() const { return this->Servo ? &this->Servo->GetTicks() : nullptr; }
  ///@}

  /**
   * Computes the device's caps for the measured round trip or the period of this rate (Hz),
   * whichever is longer.
   */
  ForceCaps ComputeCaps(double rate) const;
  /**
   * Sets vtkHapticDevice::SetStiffnessGain. A larger gain takes effect when nothing is felt and the
   * round trip is known.
   */
  void SetStiffnessGain(double gain) { this->WantedGain = gain; }
  /**
   * Returns the caps of the felt model, which include the user's caps. All are 0 without a model.
   */
  ForceCaps GetCaps() const;

  /** Returns the ticks per second of the running servo. */
  double GetRate() const { return this->Rate; }

  /** Reports that the owner is present: see vtkHapticDevice::SetAttentionTime. */
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
  /** See vtkHapticDevice::SetClutch. The clutch outlives the servo and the open device. */
  void SetClutched(bool on);
  bool IsClutched() const { return this->Clutched; }
  /** Returns whether force returns when the clutch ends, as far as the orders so far decide. */
  bool ReturnsAfterClutch() const
  {
    return this->Servo ? this->Servo->GetLoop().ReturnsAfterClutch()
                       : this->Clutched && this->ArmsAtStart;
  }
  ///@}
  /** Returns whether the last order was Arm, clutched or not. */
  bool HasArmOrder() const { return this->IsArmOrdered() || this->ReturnsAfterClutch(); }
  ///@{
  /**
   * Announce the beginning and the end of work of the owner: see vtkHapticDevice::BeginLongWork.
   * BeginWork returns true if the force ends because of the work. EndWork returns true if the force
   * may come back. Works nest and outlive the servo.
   */
  bool BeginWork(const std::string& what, bool isLong);
  bool EndWork();
  bool HasWork() const { return !this->Works.empty(); }
  ///@}
  /**
   * Stores for the status background work that nothing waits for, such as "the volume is hashed".
   * `share` is the fraction that is done, or FractionUnknown, or WorkEnded.
   */
  void SetBackgroundWork(const std::string& what, double share);
  /**
   * Stores, for the status, the data for which a volume that is read by regions waits; empty if it
   * does not wait.
   */
  void SetRegionStatus(const std::string& status) { this->RegionStatus = status; }
  /**
   * Stores for the status which time steps a moving volume waits for; empty if it does not wait.
   */
  void SetTimeStepsStatus(const std::string& status) { this->TimeStepsStatus = status; }
  /** Returns whether the device is open and its last reported condition is ready. */
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

  /**
   * Reads the latest state from the servo. Uses `deviceToWorld` if the state has no model. Returns
   * false if there is no new state.
   */
  bool Update(const Affine3& deviceToWorld);
  const ServoSnapshot& GetState() const { return this->State; }
  /** Returns the model of the latest state; null without one. */
  const HapticModel* FindModel()
  {
    return this->Servo ? this->Servo->GetTicks().FindModel(this->State.Generation) : nullptr;
  }

  /** Writes all states since a reader's last call as rows of a table: see vtkHapticState::Drain. */
  void DrainStates(const Affine3& deviceToWorld, vtkTable* table, int reader);
  ///@{
  /** Reserve and release a reader's number for DrainStates(): see vtkHapticState::AddReader. */
  int AddReader();
  void RemoveReader(int reader);
  ///@}

  /** Returns the status as of the last Update. The result points into this object. */
  DeviceStatus GetStatus() const;

  /** Returns the latest state as users of vtkHapticDevice see it. */
  vtkHapticState* GetLatest() const { return this->Latest; }

private:
  struct Work
  {
    std::string What;
    bool IsLong;
  };
  /** Returns the outermost work that is long; null if there is none. */
  const Work* FindLongWork() const;
  /** Copies to GetLatest() the numbers of the latest state that do not depend on the placement. */
  void ShowNumbers();
  /**
   * If the measured round trip requires other force caps, publishes the latest model again with
   * these caps.
   */
  void PollRoundTrip();
  /** Writes the facts to the user's file if the device is remembered. */
  void Remember();
  void RequireConfirmation();

  std::string Id;
  std::unique_ptr<DeviceBackend> Backend;
  std::string Identity; ///< identity of the device; empty if it has no facts
  DeviceFacts Facts;
  std::string MemoryTrouble;
  int Opening = 0;
  VirtualDevice* Virtual = nullptr;
  XrDevice* Xr = nullptr; ///< set for an XR device; Virtual is set, too
  bool IsReplay = false;
  RecordedTips Replay;
  std::unique_ptr<ServoThreads> Servo;
  ServoSnapshot State;
  const vtkNew<vtkHapticState> Latest;
  bool ArmsAtStart = false;           ///< whether Arm was ordered before the servo ran
  bool Clutched = false;              ///< last order of SetClutched
  std::optional<Quaternion> HandTurn; ///< see TurnHand
  bool Spinning = false;              ///< last order of Spin
  double Rate = 0.0;
  RoundTripInUse RoundTrip;
  double WantedGain = 1.0;
  double Gain = 1.0;                             ///< gain of ForceAugmentation.h in use
  std::map<std::string, double> BackgroundWorks; // fraction that is done, by the work's name
  std::string RegionStatus;
  std::string TimeStepsStatus;
  std::vector<Work> Works;
  std::set<int> Readers; ///< numbers that AddReader has reserved
};

} // namespace VolumeHaptics

#endif
