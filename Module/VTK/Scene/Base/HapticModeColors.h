// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Colours of modes by their index, for curves, names, and the shapes that hold the hand.
 */
#ifndef HapticModeColors_h
#define HapticModeColors_h

#include <cstddef>

namespace VolumeHaptics
{

constexpr std::size_t ModeColorCount = 8;

/** Colours for a dark background. People with colour blindness can distinguish the first five. */
constexpr unsigned char ModeColors[ModeColorCount][3] = { { 86, 180, 233 }, { 255, 160, 60 },
  { 70, 215, 150 }, { 240, 228, 66 }, { 225, 130, 185 }, { 160, 150, 255 }, { 255, 110, 90 },
  { 200, 200, 200 } };

/** The same colours for a white page. */
constexpr unsigned char ModePageColors[ModeColorCount][3] = { { 0, 92, 175 }, { 222, 110, 0 },
  { 0, 140, 95 }, { 165, 145, 0 }, { 175, 60, 125 }, { 95, 80, 200 }, { 190, 40, 30 },
  { 90, 90, 90 } };

} // namespace VolumeHaptics

#endif
