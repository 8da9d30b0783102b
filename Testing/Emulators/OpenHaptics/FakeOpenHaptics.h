// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * A stand-in for OpenHaptics' libHD, with a device in a hand. It follows the toolkit's public
 * documentation (OpenHaptics Toolkit 3.5, API Reference and Programmer's Guide): callbacks run on
 * the scheduler's thread; setting a force outside hdBeginFrame and hdEndFrame is an error;
 * hdGetError pops faults from a stack; units are millimetres, newtons and millinewton metres;
 * matrices are stored column by column.
 *
 * HD_CALIBRATION_STYLE is a mask of the ways to calibrate a device; hdUpdateCalibration() takes one
 * of them. 3D Systems' example prefers automatic calibration to the inkwell, and the inkwell to a
 * reset of the encoders (Geomagic_Touch_ROS_Drivers, HHD_Auto_Calibration(), copies it). The
 * nominal forces of a Touch are 3.3 N, and 0.88 N continuously, as its library prints them in
 * published programs. A device may answer only to its own name ("Default Device", or "Default
 * PHANToM" before; pyOpenHaptics issue 10).
 *
 * A second arm answers only to the name "Right". As in jhu-saw/sawSensablePhantom
 * (components/code/mtsSensableHD.cpp, 0f16f47), all arms are initialized before the one scheduler
 * starts. Reading and setting use the current device, which hdMakeCurrentDevice() sets and
 * hdBeginFrame() does not. Initializing or disabling an arm while the scheduler runs is an error
 * here.
 */
#ifndef FakeOpenHaptics_h
#define FakeOpenHaptics_h

#include "Emulators/EmulatedHand.h"

#include <array>
#include <atomic>
#include <mutex>
#include <string>
#include <vector>

namespace emulated
{

struct FakeArm
{
  bool IsOpen = false;
  bool IsForceEnabled = false;
  bool IsInFrame = false;
  std::vector<unsigned> Faults; ///< stack of the errors that were not read yet
  EmulatedHand Hand;            ///< m
  Triple Force{};               ///< N, force of the last frame
  Triple Torque{};              ///< mN m, torque of the last frame
  ///@{
  /// Force and torque set in the current frame. hdEndFrame() sends them.
  Triple FrameForce{};
  Triple FrameTorque{};
  ///@}
};

/// The state of the library: the first arm, and a second arm in `Right`.
struct FakeOpenHapticsState : FakeArm
{
  FakeArm Right;
  bool IsPluggedIn = true;
  bool StandsStill = false; ///< whether the scheduler stops running its callbacks
  int OutputDof = 3;
  unsigned Calibration = 301;    ///< HD_CALIBRATION_OK
  int Styles = 5;                ///< bits of the ways to calibrate the device; here those of a
                                 ///< Touch
  std::string Name;              ///< name of the only device; empty: the default device
  double ContinuousForce = 0.88; ///< N; 0: unknown to the library
  int Buttons = 0;
  bool TellsNonsense = false;
  /// Orientation of the stylus: the three columns of a rotation matrix.
  std::array<double, 9> Turn{ 1, 0, 0, 0, 1, 0, 0, 0, 1 };
  int ForcesBeforeZero = 0; ///< number of forces in frames before the zero was known
  int ForcesAtTheEnd = 0;   ///< number of times that the scheduler stopped while any arm had
                            ///< force
  /// N, largest decrease of the first arm's upward force between two frames
  double LargestFall = 0.0;
  std::vector<std::string> Calls; ///< names of the calls outside frames
};

struct FakeOpenHaptics : FakeOpenHapticsState
{
  std::mutex Mutex;
  std::atomic<long> Frames{ 0 };

  /** Resets the state for the next test. The scheduler must not run. */
  void Reset() { static_cast<FakeOpenHapticsState&>(*this) = {}; }
  /** Returns the fake library's state, if the program is linked to the library. */
  static FakeOpenHaptics& Get();
};

} // namespace emulated

#endif
