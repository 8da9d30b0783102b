// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The reports of a force-feedback stick or wheel, after the USB PID 1.0 specification (usage page
 * 0x0F): which of a device's reports and fields are which, and how they are filled.
 *
 * Report ids, sizes and ranges differ from device to device, so that everything is found by its
 * usage. PID knows no newtons: magnitudes are parts of a full scale that the user has to say. The
 * sequence in which reports go is in PidDialogue.h. What the servo calls is noexcept and does not
 * allocate.
 */
#ifndef PidProtocol_h
#define PidProtocol_h

#include "Devices/Transport/Hid/HidReportDescriptor.h"

#include <array>

namespace VolumeHaptics
{

/** Usages of the page 0x0F. */
enum class PidUsage : std::uint16_t
{
  SetEffectReport = 0x21,
  EffectBlockIndex = 0x22,
  EffectType = 0x25,
  ConstantForce = 0x26,
  Duration = 0x50,
  Gain = 0x52,
  AxesEnable = 0x55,
  DirectionEnable = 0x56,
  Direction = 0x57,
  Magnitude = 0x70,
  SetConstantForceReport = 0x73,
  EffectOperationReport = 0x77,
  EffectStart = 0x79,
  EffectStop = 0x7B,
  LoopCount = 0x7C,
  DeviceGainReport = 0x7D,
  DeviceGain = 0x7E,
  PoolReport = 0x7F,
  SimultaneousEffects = 0x83,
  BlockLoadReport = 0x89,
  BlockLoadSuccess = 0x8C,
  BlockLoadFull = 0x8D,
  BlockLoadError = 0x8E,
  DeviceControlReport = 0x95,
  DeviceControl = 0x96,
  EnableActuators = 0x97,
  StopAllEffects = 0x99,
  DeviceReset = 0x9A,
  CreateNewEffect = 0x9E,
  CreateNewEffectReport = 0xAB
};

/** Bytes to send, or to have filled by the device. */
struct HidReport
{
  static constexpr std::size_t Capacity = 64; ///< bytes of the payload

  HidReportKind Kind = HidReportKind::Output;
  std::size_t Size = 0; ///< bytes of the payload
  /// The id (0 without ids), then the payload: as hidapi wants it, Size + 1 bytes.
  std::array<std::uint8_t, Capacity + 1> Bytes{};
  std::uint8_t* Payload() noexcept { return this->Bytes.data() + 1; }
};

/** How forces become magnitudes, for each axis: x, y. */
struct PidSettings
{
  /// N at full magnitude, which only the user knows; below zero it turns the sign; 0: no force.
  std::array<double, 2> NewtonsPerFullScale{ 1.0, 1.0 };
  /// s, 0.05 to 0.1: how long a force acts when the host sends nothing more.
  double Duration = 0.1;
};

enum class BlockLoadStatus : std::uint8_t
{
  Waiting, ///< nothing known yet, or not understood
  Success,
  Full,
  Error
};

class PidDevice
{
public:
  /**
   * Finds the reports. False, with all that is missing, where no constant forces can be made with
   * them.
   */
  bool Map(const HidReportDescriptor& descriptor, std::string& error);

  bool HasPool() const noexcept { return this->Pool.Known; }
  bool HasDeviceGain() const noexcept { return this->Gain.Known; }
  /** 1, or 2 where the second axis can be told from the first. */
  int GetNumberOfAxes() const noexcept { return this->Axes; }
  /**
   * The device has no second axis that a hand could move: a wheel whose descriptor is that of a
   * stick.
   */
  void UseOneAxis() noexcept { this->Axes = 1; }

  ///@{
  /** What to send. The effects' block indices are the device's, from 1 on; axes are 0 and 1. */
  HidReport Control(PidUsage command) const noexcept;
  HidReport FullGain() const noexcept;
  HidReport CreateConstant() const noexcept;
  /**
   * A constant effect from 90 degrees for axis 0, from 180 for axis 1. A direction is where the
   * force comes from, here as in DirectInput and in Linux' hid-pidff.c: a positive magnitude pushes
   * an axis towards its negative end. So does OpenFFBoard (EffectsCalculator.cpp, commit 160af910).
   * Compared with its own springs, ArduinoJoystickWithFFBLibrary pushes the other way (YukMingLaw's
   * Joystick.cpp, commit ed86e27, and roger-hujin's FFB.cpp, commit 46d8a8c): such devices need a
   * NewtonsPerFullScale below zero.
   */
  HidReport SetEffect(std::int64_t block, int axis, double duration) const noexcept;
  HidReport Operate(std::int64_t block, PidUsage operation) const noexcept;
  /**
   * A magnitude: newtons over newtons per full scale, at most the full scale; 0 for what is not
   * finite.
   */
  HidReport SetConstant(
    std::int64_t block, double newtons, double newtonsPerFullScale) const noexcept;
  ///@}

  ///@{
  /** What to fetch: feature reports, empty so far. */
  HidReport AskPool() const noexcept;
  HidReport AskBlockLoad() const noexcept;
  ///@}

  ///@{
  /** What came: payloads. Zero effects: the device did not say. */
  int ReadPool(const std::uint8_t* payload, std::size_t size) const noexcept;
  BlockLoadStatus ReadBlockLoad(
    const std::uint8_t* payload, std::size_t size, std::int64_t& block) const noexcept;
  ///@}

private:
  friend class PidMapper;

  struct Shape
  {
    bool Known = false;
    HidReportKind Kind = HidReportKind::Output;
    std::uint8_t Id = 0;
    std::size_t Size = 0;
  };
  /** A field, and the value that stands for a usage where it chooses one. */
  struct Slot
  {
    bool Known = false;
    HidField Field;
    std::int64_t Value = 0;
  };

  static HidReport Begin(const Shape& shape) noexcept;
  static void Put(HidReport& report, const Slot& slot, std::int64_t value) noexcept;
  static void Choose(HidReport& report, const Slot& slot) noexcept;
  static bool IsChosen(const Slot& slot, const std::uint8_t* payload, std::size_t size) noexcept;

  Shape ControlShape, Gain, Create, Effect, Constant, Operation, Pool, Load;
  Slot Enable, StopAll, Reset, DeviceGain, CreateType;
  Slot EffectBlock, EffectType, Duration, EffectGain, DirectionEnable;
  std::array<Slot, 2> AxisEnable;
  Slot Direction;
  Slot ConstantBlock, Magnitude, OperationBlock, Start, Stop, Loops;
  Slot Simultaneous, LoadBlock, Success, Full, LoadError;
  int Axes = 1;
};

} // namespace VolumeHaptics

#endif
