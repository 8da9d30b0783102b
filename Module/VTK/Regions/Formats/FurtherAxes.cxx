// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Regions/Formats/FurtherAxes.h"

#include "Core/Platform/HapticFiles.h"
#include "VTK/Regions/Formats/LargeFile.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace VolumeHaptics
{
namespace
{

/** Splits the index of a volume, counted from 0, into indices along the axes. */
std::vector<std::size_t> SplitNumber(const std::vector<FurtherAxis>& axes, std::size_t number)
{
  std::vector<std::size_t> indices;
  for (const FurtherAxis& axis : axes)
  {
    indices.push_back(number % axis.Count);
    number /= axis.Count;
  }
  return indices;
}

/** Returns the name of a volume, such as "channel 2 of 3 (DAPI), time 1 of 5". */
std::string NameVolume(
  const std::vector<FurtherAxis>& axes, const std::vector<std::size_t>& indices)
{
  std::string name;
  for (std::size_t a = 0; a < axes.size(); ++a)
  {
    const FurtherAxis& axis = axes[a];
    if (axis.Count > 1)
    {
      const std::string label =
        indices[a] < axis.Labels.size() ? Printable(axis.Labels[indices[a]]) : std::string();
      name += (name.empty() ? "" : ", ") + axis.Name + " " + std::to_string(indices[a] + 1) +
        " of " + std::to_string(axis.Count) + (label.empty() ? "" : " (" + label + ")");
    }
  }
  return name;
}

/** Describes the sizes of the axes, such as "3 channels and 5 times". */
std::string CountVolumes(const std::vector<FurtherAxis>& axes)
{
  std::string text;
  for (const FurtherAxis& axis : axes)
  {
    if (axis.Count > 1)
    {
      text += (text.empty() ? "" : " and ") + std::to_string(axis.Count) + " " + axis.Name + "s";
    }
  }
  return text;
}

} // namespace

std::vector<std::size_t> ChooseVolume(
  const std::vector<FurtherAxis>& axes, int number, LargeFile& file)
{
  constexpr std::size_t most = std::numeric_limits<int>::max();
  constexpr std::size_t mostListed = 4096;
  std::size_t count = 1;
  for (const FurtherAxis& axis : axes)
  {
    if (axis.Count == 0 || axis.Count > most / count)
    {
      throw std::runtime_error("it has more volumes than can be counted. Check its header.");
    }
    count *= axis.Count;
  }
  const std::string last = std::to_string(count);
  if (number != 0 && count == 1)
  {
    throw std::runtime_error("it has one volume only, which needs no number. Leave Series out.");
  }
  if (number < 0 || number > static_cast<int>(count))
  {
    throw std::runtime_error("it has " + CountVolumes(axes) + ", and none with the number " +
      std::to_string(number) + ". Take Series = 1 to Series = " + last + ".");
  }
  const auto chosen = static_cast<std::size_t>(std::max(number, 1) - 1);
  std::vector<std::size_t> indices = SplitNumber(axes, chosen);
  file.Volumes.clear();
  for (std::size_t i = 0; i < count && count > 1 && count <= mostListed; ++i)
  {
    file.Volumes.push_back(std::to_string(i + 1) + " " + NameVolume(axes, SplitNumber(axes, i)));
  }
  file.Volume = static_cast<int>(chosen) + 1;
  if (count > 1)
  {
    file.Notes.push_back(number > 0 ? NameVolume(axes, indices) + " is used"
                                    : "of " + CountVolumes(axes) +
          " the first one is used; Series = 1 to Series = " + last + " choose one of them");
  }
  return indices;
}

} // namespace VolumeHaptics
