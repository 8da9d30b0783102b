// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Chooses one of the volumes in a file with more than three axes.
 */
#ifndef FurtherAxes_h
#define FurtherAxes_h

#include <cstddef>
#include <string>
#include <vector>

namespace VolumeHaptics
{

struct LargeFile;

/** An axis of a file in addition to x, y and z. */
struct FurtherAxis
{
  std::string Name; ///< quantity that changes along the axis, such as "channel"
  std::size_t Count = 1;
  std::vector<std::string> Labels = {}; ///< names along the axis in the file, such as "DAPI"; empty
                                        ///< if there are none
};

/**
 * Chooses a volume by its number, counted from 1, with the first axis varying fastest; 0 stands for
 * the first volume. Lists the volumes in the file, with a note on the one that is read. Returns the
 * index along each axis. Throws std::runtime_error if there is no such volume.
 */
std::vector<std::size_t> ChooseVolume(
  const std::vector<FurtherAxis>& axes, int number, LargeFile& file);

} // namespace VolumeHaptics

#endif
