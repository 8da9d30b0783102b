// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The implementation behind vtkHapticDevice: the open back end, its running servo, and the latest
 * state.
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

/** Special values of `share` in DeviceSession::SetBackgroundWork. */
constexpr double WorkEnded = -1.0;
constexpr double FractionUnknown = -2.0;

class DeviceSession
{
public:
  ~DeviceSession() { this->Close(); }

  bool Open(const std::string& id, const DeviceOptions& options, std::string& error);
  void Close();
  bool IsOpen() const { return this->Backend != nullptr; }
  /** Returns a counter that changes with each Open or Close. */
  int GetOpening() const { return this->Opening; }
  const std::string& GetId() const { return this->Id; }
  DeviceLimits GetLimits() const
  {
    return this->Backend ? this->Backend->GetLimits() : DeviceLimits{};
  }
  /** Returns the back end if the program moves its tip; null otherwise. */
  VirtualDevice* GetVirtual() const { return this->Virtual; }
  /**
   * Returns whether the mouse may move the tip. The tip of an XR device follows the headset's
   * controller instead.
   */
  bool MayMouseLead() const { return this->Virtual && !this->Xr; }
  /** Returns the strength of vibration: see vtkHapticVirtualHand::TakeVibration. */
  double TakeVibration() { return this->Xr ? this->Xr->DrainAmplitude() : 0.0; }

  ///@{
  /**
   * GetFacts() returns the device's stored facts from the user's file (DeviceMemory.h), or, for a
   * device that the file does not store, the facts found since Open. DrainMemoryTrouble() returns
   * an error of that file that occurred since the last call; empty if there was none.
   */
  const DeviceFacts& GetFacts() const { return this->Facts; }
  std::string DrainMemoryTrouble() { return std::exchange(this->MemoryTrouble, {}); }
  /** Returns whether facts are kept, as for a device that gives force and has an identity. */
  bool HasFacts() const { return !this->Identity.empty(); }
  /**
   * Returns whether the user's file stores the device's facts: its identity must be unique to it.
   */
  bool IsRemembered() const { return this->HasFacts() && this->Backend->KeepsIdentity(); }
  /** Describes the device's calibration; empty if no facts are kept about the device. */
  std::string DescribeCalibration() const
  {
    return this->HasFacts() ? this->Facts.DescribeScale() : std::string();
  }
  /**
   * Returns whether the user has to confirm the signs of the device's axes before anything is felt.
   */
  bool NeedsConfirmation() const;
  /** Returns whether the device is open and needs no confirmation. */
  bool AreSignsConfirmed() const { return this->IsOpen() && !this->NeedsConfirmation(); }
  /**
   * Makes the next Start require a new confirmation of the signs. Call this only while the servo is
   * stopped.
   */
  void ForgetConfirmation();
  /** Sets the ratio of the force that the device gives to the force that is commanded. */
  void SetForceScale(double scale);
  ///@}

  /**
   * Starts the servo. The placement of the model maps the world positions of a replay to the
   * device.
   */
  void Start(double rate, const SafetyLimits& limits, std::shared_ptr<const HapticModel> model,
    const Affine3& deviceToWorld);
  void Stop();
  bool IsRunning() const { return this->Servo != nullptr; }
  /** Returns whether no servo runs or this process started it; false in a fork of that process. */
  bool IsOurs() const { return !this->Servo || this->Servo->IsOurs(); }
  ///@{
  /** Returns the loop of the servo; null if the servo does not run. */
  ServoLoop* GetLoop() const { return this->Servo ? &this->Servo->GetLoop() : nullptr; }
  /**
   * Sets the orientation of the tool in the hand, in the device's space, for a device that measures
   * no orientation: see HandTurn.h. Applies to this and later servos. An empty `orientation`
   * removes it.
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
   * Computes the force caps of the device for the measured round trip or the period of this rate
   * (Hz), whichever is longer.
   */
  ForceCaps ComputeCaps(double rate) const;
  /**
   * Sets the gain of vtkHapticDevice::SetStiffnessGain. A larger gain takes effect once nothing is
   * felt and the round trip is known.
   */
  void SetStiffnessGain(double gain) { this->WantedGain = gain; }
  /** Returns the caps of the felt model, including the user's caps; all are 0 without a model. */
  ForceCaps GetCaps() const;

  /** Returns the rate (Hz) of the running servo. */
  double GetRate() const { return this->Rate; }

  /** Restarts the attention time: see vtkHapticDevice::SetAttentionTime. */
  void Attend();
  void Arm(bool on);
  void FadeOut();
  /** Returns whether Arm was the last order: see ServoLoop::IsArmOrdered. */
  bool IsArmOrdered() const
  {
    return this->Servo ? this->Servo->GetLoop().IsArmOrdered()
                       : this->ArmsAtStart && !this->Clutched;
  }
  ///@{
  /**
   * See vtkHapticDevice::SetClutch. The clutch persists when the servo stops or the device is
   * closed.
   */
  void SetClutched(bool on);
  bool IsClutched() const { return this->Clutched; }
  /** Returns whether the orders so far make force return when the clutch ends. */
  bool ReturnsAfterClutch() const
  {
    return this->Servo ? this->Servo->GetLoop().ReturnsAfterClutch()
                       : this->Clutched && this->ArmsAtStart;
  }
  ///@}
  /** Returns whether the last order was Arm, even if the clutch suspends it. */
  bool HasArmOrder() const { return this->IsArmOrdered() || this->ReturnsAfterClutch(); }
  ///@{
  /**
   * Announce the beginning and the end of work of the owner: see vtkHapticDevice::BeginLongWork.
   * BeginWork returns true if the force is switched off because of the work. EndWork returns true
   * if the force may come back. Work may be nested and may continue after the servo has stopped.
   */
  bool BeginWork(const std::string& what, bool isLong);
  bool EndWork();
  bool HasWork() const { return !this->Works.empty(); }
  ///@}
  /**
   * Stores, for the status, background work that blocks nothing, such as "the volume is hashed".
   * `share` is the fraction that is done, FractionUnknown, or WorkEnded.
   */
  void SetBackgroundWork(const std::string& what, double share);
  /**
   * Stores, for the status, which data a volume that is read by regions waits for; empty if it is
   * not waiting.
   */
  void SetRegionStatus(const std::string& status) { this->RegionStatus = status; }
  /**
   * Stores, for the status, which time steps a moving volume waits for; empty if it is not waiting.
   */
  void SetTimeStepsStatus(const std::string& status) { this->TimeStepsStatus = status; }
  /** Returns whether the device is open and last reported that it is ready. */
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
   * Reads the latest state from the servo. A state without a model is placed by `deviceToWorld`.
   * Returns false if there is no new state.
   */
  bool Update(const Affine3& deviceToWorld);
  const ServoSnapshot& GetState() const { return this->State; }
  /** Returns the model of the latest state; null if it has none. */
  const HapticModel* FindModel()
  {
    return this->Servo ? this->Servo->GetTicks().FindModel(this->State.Generation) : nullptr;
  }

  /** Writes all states since a reader's last call as rows of a table: see vtkHapticState::Drain. */
  void DrainStates(const Affine3& deviceToWorld, vtkTable* table, int reader);
  ///@{
  /**
   * Reserve and release the number of a reader for DrainStates(): see vtkHapticState::AddReader.
   */
  int AddReader();
  void RemoveReader(int reader);
  ///@}

  /**
   * Returns the status as of the last Update. The result points into this object, so do not keep
   * it.
   */
  DeviceStatus GetStatus() const;

  /** Returns the latest state as users of vtkHapticDevice see it. */
  vtkHapticState* GetLatest() const { return this->Latest; }

private:
  struct Work
  {
    std::string What;
    bool IsLong;
  };
  /** Returns the outermost work in progress that is long; null if there is none. */
  const Work* FindLongWork() const;
  /** Copies the numbers of the latest state that do not depend on the placement to GetLatest(). */
  void ShowNumbers();
  /** Publishes the latest model with new force caps if the measured round trip requires them. */
  void PollRoundTrip();
  /** Writes the facts to the user's file if that file stores the device. */
  void Remember();
  void RequireConfirmation();

  std::string Id;
  std::unique_ptr<DeviceBackend> Backend;
  std::string Identity; ///< identity of the device; empty if no facts are kept about it
  DeviceFacts Facts;
  std::string MemoryTrouble;
  int Opening = 0;
  VirtualDevice* Virtual = nullptr;
  XrDevice* Xr = nullptr; ///< null unless it is an XR device; Virtual is then set, too
  bool IsReplay = false;
  RecordedTips Replay;
  std::unique_ptr<ServoThreads> Servo;
  ServoSnapshot State;
  const vtkNew<vtkHapticState> Latest;
  bool ArmsAtStart = false;           ///< whether Arm was ordered before the servo started
  bool Clutched = false;              ///< last value of SetClutched
  std::optional<Quaternion> HandTurn; ///< see TurnHand
  bool Spinning = false;              ///< last value of Spin
  double Rate = 0.0;
  RoundTripInUse RoundTrip;
  double WantedGain = 1.0;
  double Gain = 1.0;                             ///< gain in effect (ForceAugmentation.h)
  std::map<std::string, double> BackgroundWorks; // fraction done, by the name of the work
  std::string RegionStatus;
  std::string TimeStepsStatus;
  std::vector<Work> Works;
  std::set<int> Readers; ///< numbers in use, reserved by AddReader
};

} // namespace VolumeHaptics

#endif
