// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The reports of a force-feedback stick or wheel, after the USB PID 1.0 specification (usage page
 * 0x0F): the places of the fields in a device's reports, and the values for them.
 *
 * Report ids, sizes and ranges differ from device to device: PidMapper locates everything by its
 * usage. PID has no newtons: magnitudes are fractions of a full scale that the user states. The
 * order of the reports is in PidDialogue.h. All functions that the servo calls are noexcept and do
 * not allocate.
 */
#ifndef PidDevice_h
#define PidDevice_h

#include "Devices/Transport/Hid/HidReport.h"
#include "Devices/Transport/Hid/HidReportDescriptor.h"

#include <array>
#include <cstdint>

namespace VolumeHaptics
{

/** The usages of the USB PID 1.0 specification (page 0x0F) that this back end uses. */
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

/** Settings that turn forces into magnitudes. */
struct PidSettings
{
  /// N at full magnitude, for x and y. Only the user knows this number. A value below zero reverses
  /// the force; 0 means no force.
  std::array<double, 2> NewtonsPerFullScale{ 1.0, 1.0 };
  /// s, 0.05 to 0.1: how long a force acts after the last report of the host
  double Duration = 0.1;
};

enum class BlockLoadStatus : std::uint8_t
{
  Waiting, ///< the state is not known yet, or not understood
  Success,
  Full,
  Error
};

class PidDevice
{
public:
  /**
   * Finds the reports. If they don't allow constant forces, returns false and writes a list of the
   * missing parts to `error`.
   */
  bool Map(const HidReportDescriptor& descriptor, std::string& error);

  bool HasPool() const noexcept { return this->Pool.Known; }
  bool HasDeviceGain() const noexcept { return this->Gain.Known; }
  /** Returns 2 if the second axis can be distinguished from the first, else 1. */
  int GetNumberOfAxes() const noexcept { return this->Axes; }
  /**
   * Uses only the first axis, for a device without a motor on its second axis, although its
   * descriptor has one.
   */
  void UseOneAxis() noexcept { this->Axes = 1; }
  /** Makes directions shares of the enabled axis: see PidFirmware. */
  void UseShares() noexcept { this->HasShares = true; }

  ///@{
  /**
   * Make the reports to send. The device numbers the blocks of its effects from 1; axes are 0 and
   * 1.
   */
  HidReport Control(PidUsage command) const noexcept;
  HidReport FullGain() const noexcept;
  HidReport CreateConstant() const noexcept;
  /**
   * Sets a constant effect, from 90 degrees for axis 0 and from 0 degrees for axis 1: a positive
   * magnitude pushes to the left, or towards the hand, if a force comes from its direction (see
   * PidFirmware). Firmwares with angles of 8 bits leak 0.6 % of axis 0 into axis 1, and nothing the
   * other way.
   */
  HidReport SetEffect(std::int64_t block, int axis, double duration) const noexcept;
  HidReport Operate(std::int64_t block, PidUsage operation) const noexcept;
  /**
   * Sets a magnitude: newtons over newtons per full scale, at most the full scale; 0 if either
   * number is not finite.
   */
  HidReport SetConstant(
    std::int64_t block, double newtons, double newtonsPerFullScale) const noexcept;
  ///@}

  ///@{
  /** Make the feature reports to fetch, still empty. */
  HidReport AskPool() const noexcept;
  HidReport AskBlockLoad() const noexcept;
  ///@}

  ///@{
  /** Read the received payloads. If ReadPool returns zero effects, the device did not say. */
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
  /** A field, and the value that means a usage if the field is a choice of usages. */
  struct Slot
  {
    bool Known = false;
    HidField Field;
    std::int64_t Value = 0;
  };

  static HidReport Begin(const Shape& shape) noexcept;
  static void Put(HidReport& report, const Slot& slot, std::int64_t value) noexcept;
  static void Choose(HidReport& report, const Slot& slot) noexcept;
  static void SwitchOn(HidReport& report, const Slot& slot) noexcept;
  static bool IsChosen(const Slot& slot, const std::uint8_t* payload, std::size_t size) noexcept;

  Shape ControlShape, Gain, Create, Effect, Constant, Operation, Pool, Load;
  Slot Enable, StopAll, Reset, DeviceGain, CreateType;
  Slot EffectBlock, EffectType, Duration, EffectGain, DirectionEnable;
  std::array<Slot, 2> AxisEnable;
  Slot Direction;
  Slot ConstantBlock, Magnitude, OperationBlock, Start, Stop, Loops;
  Slot Simultaneous, LoadBlock, Success, Full, LoadError;
  int Axes = 1;
  bool HasShares = false;
};

} // namespace VolumeHaptics

#endif
