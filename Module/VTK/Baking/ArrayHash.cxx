// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Baking/ArrayHash.h"

#include "VTK/Base/HapticHash.h"

#include <optional>

namespace VolumeHaptics
{
namespace
{

constexpr double LookInterval = 0.02; // s

} // namespace

std::string ArrayHash::Get(const TouchedArray& array)
{
  if (!array.Array)
  {
    return {};
  }
  const std::string* const known = this->Work.Find(array.GetKey());
  return known ? *known : HashArray(array.Array, array.Dimensions.data());
}

std::string ArrayHash::Await(const TouchedArray& array, const std::function<bool(double)>& goesOn)
{
  if (!array.Array)
  {
    return {};
  }
  const TouchedArray::Key key = array.GetKey();
  const std::string* known = this->Work.Follow(key,
    [array](WorkMonitor& monitor) -> std::optional<std::string>
    {
      std::string hash = HashArray(array.Array, array.Dimensions.data(),
        [&monitor](double share) { return monitor.GoesOn(share); });
      return hash.empty() ? std::nullopt : std::optional<std::string>(std::move(hash));
    });
  while (!known && this->Work.IsUnderWay() && !this->Work.WaitFor(LookInterval))
  {
    if (!goesOn(this->Work.GetProgress()))
    {
      this->Work.Forget();
      return {};
    }
  }
  known = this->Work.Find(key);
  // The worker lacked memory, or belongs to the process that this one was forked from.
  return known ? *known : HashArray(array.Array, array.Dimensions.data());
}

} // namespace VolumeHaptics
