// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The reports of a force-feedback stick or wheel according to the USB PID 1.0 specification (usage
 * page 0x0F): the places of fields in a device's reports, and their values.
 *
 * Report ids, sizes and ranges differ from device to device, so PidMapper finds everything by its
 * usage. PID does not know newtons: magnitudes are fractions of a full scale that the user sets.
 * The order of the reports is in PidDialogue.h. No function that the servo calls allocates or
 * throws.
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
  /// N at full magnitude for x and y, which only the user knows. A negative value reverses the
  /// force; 0 means no force.
  std::array<double, 2> NewtonsPerFullScale{ 1.0, 1.0 };
  /// Time in s, 0.05 to 0.1, for which a force lasts after the last report of the host.
  double Duration = 0.1;
};

enum class BlockLoadStatus : std::uint8_t
{
  Waiting, ///< the state is not known yet, or was not understood
  Success,
  Full,
  Error
};

class PidDevice
{
public:
  /**
   * Finds the reports. Returns false and lists the missing parts in `error` if they do not suffice
   * for constant forces.
   */
  bool Map(const HidReportDescriptor& descriptor, std::string& error);

  bool HasPool() const noexcept { return this->Pool.Known; }
  /** Returns whether the pool has the number of effects that play at a time. */
  bool HasPoolSize() const noexcept { return this->Simultaneous.Known; }
  /** Returns the least number of an effect's block. */
  std::int64_t GetFirstBlock() const noexcept { return this->LoadBlock.Field.LogicalMinimum; }
  bool HasDeviceGain() const noexcept { return this->Gain.Known; }
  /** Returns 2 if a force can be given along a second axis, otherwise 1. */
  int GetNumberOfAxes() const noexcept { return this->Axes; }
  /** Largest number of effects. */
  static constexpr int MostEffects = 4;
  /**
   * Returns the number of constant effects, which are numbered from 0: one for each axis or, if
   * magnitudes have no sign, two for each axis, from opposite directions.
   */
  int GetNumberOfEffects() const noexcept { return this->Axes * (this->IsSigned ? 1 : 2); }
  /** Returns the axis of an effect, 0 or 1. */
  int GetAxis(int effect) const noexcept { return this->IsSigned ? effect : effect / 2; }
  /**
   * Uses only the first axis. For a device without a motor on its second axis, although its
   * descriptor has one.
   */
  void UseOneAxis() noexcept { this->Axes = 1; }
  /** Makes the direction field a fraction of the force on the enabled axis, not an angle. */
  void UseShares() noexcept { this->HasShares = true; }

  ///@{
  /**
   * Make the reports to send. The device numbers the blocks of its effects, beginning with 1.
   */
  HidReport Control(PidUsage command) const noexcept;
  HidReport FullGain() const noexcept;
  HidReport CreateConstant() const noexcept;
  /**
   * Makes the report that sets a constant effect, from 90 degrees for axis 0 and from 0 degrees for
   * axis 1; the second effect of an axis is turned by 180 degrees. If a force comes from its
   * direction (see PidFirmware), a positive magnitude pushes to the left, or towards the hand. In
   * firmwares with angles of 8 bits, 0.6 % of axis 0 also acts on axis 1, and nothing the other way
   * round.
   */
  HidReport SetEffect(std::int64_t block, int effect, double duration) const noexcept;
  HidReport Operate(std::int64_t block, PidUsage operation) const noexcept;
  /**
   * Makes the report that sets the magnitude of an effect: newtons of its axis divided by newtons
   * per full scale, limited to the full scale, and 0 if another effect of the axis pushes. The
   * magnitude is 0 if either number is not finite.
   */
  HidReport SetConstant(
    std::int64_t block, int effect, double newtons, double newtonsPerFullScale) const noexcept;
  ///@}

  ///@{
  /** Make the feature reports to fetch. They are still empty. */
  HidReport AskPool() const noexcept;
  HidReport AskBlockLoad() const noexcept;
  ///@}

  ///@{
  /**
   * Read payloads that were received. ReadPool() returns the number of effects, or 0 if the device
   * did not report it.
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
  /** A field and, if it is a choice of usages, the value that means the usage. */
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
