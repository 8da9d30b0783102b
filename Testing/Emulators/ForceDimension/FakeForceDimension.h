// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * A stand-in for Force Dimension's library, with a device in a hand. It follows the SDK's public
 * documentation (Haptic and Robotic SDK 3.14): IDs of devices that are not open are errors; results
 * above zero are not errors; x points towards the user, y to the right, and z up; units are metres
 * and newtons; forces have no effect while they are switched off.
 *
 * The search for the zero position is a regulation of the robotic library, which continues until
 * drdStop(). Programs for the SDK assume this: sawForceDimensionSDK (jhu-saw),
 * mtsForceDimensionDevice::Startup(), and CHAI3D, CDeltaDevices.cpp, call drdStop(true) after
 * drdAutoInit(). Until then, this library accepts no force. drdStop(false) also switches the force
 * off.
 *
 * Numbers of device types are those of forcedimension_core, test/test_constants.py.
 * dhdGetMaxForce() and dhdGetMaxTorque() return the limit in use, or a negative number if the limit
 * is disabled (documentation of the SDK, as forcedimension_core quotes it).
 */
#ifndef FakeForceDimension_h
#define FakeForceDimension_h

#include "Emulators/EmulatedHand.h"

#include <array>
#include <mutex>
#include <string>
#include <vector>

namespace emulated
{

struct FakeForceDimensionState
{
  int Count = 1;
  int Type = 34; ///< an omega.6
  ///@{
  double MaxForce = -1.0;  ///< N, a limit set in the SDK; negative: none
  double MaxTorque = -1.0; ///< N m, a limit set in the SDK; negative: none
  ///@}
  bool HasWrist = true;
  bool HasGripper = false;
  bool IsGripperClosed = false;
  bool EmulatesButton = false; ///< whether the gripper acts as a button; off unless requested
  bool IsOpen = false;
  bool IsInitialised = true;
  bool IsPluggedIn = true;
  bool HasPower = true;
  bool ForceIsOn = false;
  /// whether the device regulates itself; from the search for its zero until drdStop()
  bool IsRegulating = false;
  bool FailsToInit = false;
  bool FailsToOpen = false;
  bool FailsToRead = false;
  bool FailsToWrite = false;
  bool FailsToEnable = false;
  bool TellsNonsense = false;
  unsigned Buttons = 0;
  std::array<std::array<double, 3>, 3> Frame{ { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } } };
  EmulatedHand Hand;
  Triple Force{};           ///< N, force set last
  Triple Torque{};          ///< N m, torque set last
  int ForcesBeforeZero = 0; ///< number of nonzero forces before the zero was known
  /// names of the calls, without reads and repeated writes of the same force
  std::vector<std::string> Calls;
};

struct FakeForceDimension : FakeForceDimensionState
{
  std::mutex Mutex;

  /** Resets the state for the next test. The device must be closed. */
  void Reset() { static_cast<FakeForceDimensionState&>(*this) = {}; }
  /** Returns the fake library's state, if the program is linked to the library. */
  static FakeForceDimension& Get();
};

} // namespace emulated

#endif
