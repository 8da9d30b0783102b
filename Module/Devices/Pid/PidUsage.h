// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The usages of the USB PID 1.0 specification that this back end uses.
 */
#ifndef PidUsage_h
#define PidUsage_h

#include <cstdint>

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

} // namespace VolumeHaptics

#endif
