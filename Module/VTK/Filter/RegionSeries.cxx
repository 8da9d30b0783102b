// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Filter/RegionSeries.h"

#include "VTK/Filter/HapticFilterSettings.h"
#include "VTK/Material/HapticPropertySettings.h"

#include <algorithm>
#include <iterator>

namespace VolumeHaptics
{
namespace
{

bool IsSameMaterial(const HapticMaterial& a, const HapticMaterial& b)
{
  return std::all_of(std::begin(PropertyFunctions), std::end(PropertyFunctions),
           [&](const PropertyFunction& f) { return IsSameLine(a.*f.Baked, b.*f.Baked); }) &&
    IsSameLine(a.ScalarVisibility, b.ScalarVisibility) &&
    IsSameLine(a.GradientVisibility, b.GradientVisibility) &&
    a.IsSeenByNearest == b.IsSeenByNearest;
}

template <typename Settings>
bool IsSameIn(
  const Settings& settings, const HapticModelDescription& a, const HapticModelDescription& b)
{
  return std::all_of(std::begin(settings), std::end(settings),
    [&](const auto& setting) { return !setting.IsSame || setting.IsSame(a, b); });
}

template <typename Shape>
bool AreSame(const std::shared_ptr<Shape>& a, const std::shared_ptr<Shape>& b)
{
  return a == b || (a && b && a->IsSame(*b));
}

bool IsSameMode(const ModeDescription& a, const ModeDescription& b)
{
  return a.Kind == b.Kind && a.IsActive == b.IsActive && a.Axes == b.Axes && a.IsDark == b.IsDark &&
    a.SnapDistance == b.SnapDistance && a.View.Components == b.View.Components &&
    a.View.Volume.Type == b.View.Volume.Type && IsSameLine(a.First, b.First) &&
    IsSameLine(a.Second, b.Second) && AreSame(a.Guide, b.Guide) &&
    AreSame(a.GuideSurface, b.GuideSurface) && a.Side == b.Side;
}

bool IsSameSetup(const HapticModelDescription& a, const HapticModelDescription& b)
{
  return IsSameIn(FilterSettings, a, b) && IsSameIn(PropertySettings, a, b) &&
    a.Settings.TickPeriod == b.Settings.TickPeriod && a.Settings.Caps == b.Settings.Caps &&
    a.Settings.HasIsoSurface == b.Settings.HasIsoSurface && AreSame(a.Tool, b.Tool) &&
    std::equal(a.Modes.begin(), a.Modes.end(), b.Modes.begin(), b.Modes.end(), IsSameMode);
}

} // namespace

bool RegionSeries::IsSame(const Entry& entry, const HapticModelDescription& e,
  const WholeFacts& facts, const std::string& array)
{
  const HapticModelDescription& d = entry.Description;
  const bool isSameWhole = std::equal(entry.Facts.Extent, entry.Facts.Extent + 6, facts.Extent) &&
    entry.Facts.Noise == facts.Noise && entry.Facts.BorderValue == facts.BorderValue &&
    entry.Facts.Time == facts.Time && entry.Facts.Share == facts.Share && entry.Array == array &&
    d.View.Type == e.View.Type && IsIdentical(d.IndexToWorld, e.IndexToWorld);
  return isSameWhole && IsSameMaterial(d.Material, e.Material) && IsSameSetup(d, e) &&
    (d.Settings.HasIsoSurface || d.Mesh == e.Mesh) && d.Labels == e.Labels &&
    AreSame(d.Cut, e.Cut) && d.Removal == e.Removal && d.AirValue == e.AirValue;
}

std::uint64_t RegionSeries::Find(
  const HapticModelDescription& d, const WholeFacts& facts, const std::string& array) const
{
  if (!facts.IsThere)
  {
    return 0;
  }
  const auto found = std::find_if(this->Last.begin(), this->Last.end(),
    [&](const Entry& entry) { return IsSame(entry, d, facts, array); });
  return found == this->Last.end() ? 0 : found->Number;
}

void RegionSeries::Record(const HapticModelDescription& d, const WholeFacts& facts,
  const std::string& array, std::uint64_t number)
{
  if (!facts.IsThere)
  {
    return;
  }
  constexpr std::size_t most = 4;
  Entry entry{ d, facts, array, number };
  // Release the samples: an entry is only compared, so it should keep nothing in memory except a
  // surface that the user has connected.
  entry.Description.Samples.reset();
  entry.Description.View.Data = nullptr;
  for (ModeDescription& mode : entry.Description.Modes)
  {
    mode.Samples.reset();
    mode.View.Volume.Data = nullptr;
  }
  if (d.Settings.HasIsoSurface)
  {
    entry.Description.Mesh.reset();
  }
  const auto old = std::find_if(this->Last.begin(), this->Last.end(),
    [&](const Entry& other) { return other.Number == number; });
  if (old != this->Last.end() || this->Last.size() == most)
  {
    this->Last.erase(old != this->Last.end() ? old : this->Last.begin());
  }
  this->Last.push_back(std::move(entry));
}

} // namespace VolumeHaptics
