// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Makes and reads the reports of a force-feedback stick or wheel according to the USB PID 1.0
 * specification (usage page 0x0F): finds the fields in a device's reports, and converts their
 * values.
 *
 * Report ids, sizes and ranges differ from device to device, so PidMapper finds everything by its
 * usage. PID has no unit of force: magnitudes are fractions of a full scale whose force the user
 * sets. PidDialogue.h defines the order of the reports. Functions that the servo calls neither
 * allocate nor throw.
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

/** Settings that convert forces to magnitudes. */
struct PidSettings
{
  /// Force (N) at full magnitude along x and y, which only the user knows. A negative value
  /// reverses the force; 0 means no force.
  std::array<double, 2> NewtonsPerFullScale{ 1.0, 1.0 };
  /// Time (s, 0.05 to 0.1) for which a force persists after the last report of the host.
  double Duration = 0.1;
};

enum class BlockLoadStatus : std::uint8_t
{
  Waiting, ///< the state is unknown, or the answer was not understood
  Success,
  Full,
  Error
};

class PidDevice
{
public:
  /**
   * Finds the reports. If they do not suffice for constant forces, returns false and lists the
   * missing parts in `error`.
   */
  bool Map(const HidReportDescriptor& descriptor, std::string& error);

  bool HasPool() const noexcept { return this->Pool.Known; }
  /** Returns whether the pool reports the number of simultaneous effects. */
  bool HasPoolSize() const noexcept { return this->Simultaneous.Known; }
  /** Returns the smallest number of an effect's block. */
  std::int64_t GetFirstBlock() const noexcept { return this->LoadBlock.Field.LogicalMinimum; }
  bool HasDeviceGain() const noexcept { return this->Gain.Known; }
  /** Returns 2 if the second axis can exert a force, otherwise 1. */
  int GetNumberOfAxes() const noexcept { return this->Axes; }
  /** Largest number of effects. */
  static constexpr int MostEffects = 4;
  /**
   * Returns the number of constant effects, which are numbered from 0: one for each axis or, if
   * magnitudes have no sign, two with opposite directions for each axis.
   */
  int GetNumberOfEffects() const noexcept { return this->Axes * (this->IsSigned ? 1 : 2); }
  /** Returns the axis of an effect, 0 or 1. */
  int GetAxis(int effect) const noexcept { return this->IsSigned ? effect : effect / 2; }
  /**
   * Uses only the first axis: for a device without a motor on the second axis of its descriptor.
   */
  void UseOneAxis() noexcept { this->Axes = 1; }
  /** Makes the direction field a fraction of the force on the enabled axis instead of an angle. */
  void UseShares() noexcept { this->HasShares = true; }

  ///@{
  /** Make reports to send. The device numbers the blocks of its effects from 1. */
  HidReport Control(PidUsage command) const noexcept;
  HidReport FullGain() const noexcept;
  HidReport CreateConstant() const noexcept;
  /**
   * Makes the report that sets a constant effect. Its direction is 90 degrees for axis 0 and 0
   * degrees for axis 1; the second effect of an axis is turned by 180 degrees. If the firmware
   * takes the direction as that from which the force comes (see PidFirmware), a positive magnitude
   * pushes to the left, or towards the hand. In firmwares with 8-bit angles, 0.6 % of axis 0 also
   * acts on axis 1, but not vice versa.
   */
  HidReport SetEffect(std::int64_t block, int effect, double duration) const noexcept;
  HidReport Operate(std::int64_t block, PidUsage operation) const noexcept;
  /**
   * Makes the report that sets the magnitude of an effect: the newtons of its axis divided by
   * newtons per full scale, limited to the full scale. The magnitude is 0 if the other effect of
   * the axis pushes, or if either number is not finite.
   */
  HidReport SetConstant(
    std::int64_t block, int effect, double newtons, double newtonsPerFullScale) const noexcept;
  ///@}

  ///@{
  /** Make the feature reports to fetch, without content. */
  HidReport AskPool() const noexcept;
  HidReport AskBlockLoad() const noexcept;
  ///@}

  ///@{
  /**
   * Read received payloads. ReadPool() returns the number of effects, or 0 if the device has not
   * reported it.
   */
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
  /** A field and, if it is a choice of usages, the value that stands for the usage. */
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
  bool IsSigned = true; ///< whether magnitudes have a sign
};

} // namespace VolumeHaptics

#endif
