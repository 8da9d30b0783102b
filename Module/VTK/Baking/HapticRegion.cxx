// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Baking/HapticRegion.h"

#include "VTK/Baking/HapticSettingLists.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkHapticRegionFilter.h"
#include "vtkImageData.h"

#include <algorithm>
#include <iterator>
#include <sstream>

namespace VolumeHaptics
{
namespace
{

const char* const Cure = " Make the region with vtkHapticRegionFilter, which writes all field "
                         "arrays that it needs, or remove the "
                         "field arrays HapticWholeExtent, HapticNoise and HapticBorderValue to "
                         "touch the image as a volume of its own.";

bool IsSameLine(const Polyline& a, const Polyline& b)
{
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
    [](const Vertex& v, const Vertex& w) { return v.X == w.X && v.Y == w.Y; });
}

bool IsSameMaterial(const HapticMaterial& a, const HapticMaterial& b)
{
  return std::all_of(std::begin(PropertyFunctions), std::end(PropertyFunctions),
           [&](const PropertyFunction& f) { return IsSameLine(a.*f.Baked, b.*f.Baked); }) &&
    IsSameLine(a.ScalarVisibility, b.ScalarVisibility) &&
    IsSameLine(a.GradientVisibility, b.GradientVisibility);
}

template <typename Settings>
bool IsSameIn(
  const Settings& settings, const HapticModelDescription& a, const HapticModelDescription& b)
{
  return std::all_of(std::begin(settings), std::end(settings),
    [&](const auto& setting) { return !setting.IsSame || setting.IsSame(a, b); });
}

bool IsSameSetup(const HapticModelDescription& a, const HapticModelDescription& b)
{
  return IsSameIn(FilterSettings, a, b) && IsSameIn(PropertySettings, a, b) &&
    a.Settings.TickPeriod == b.Settings.TickPeriod && a.Settings.Caps == b.Settings.Caps &&
    a.Settings.HasIsoSurface == b.Settings.HasIsoSurface;
}

/**
 * A numeric field array of at least `least` finite numbers; null, with an error, where it is not
 * one.
 */
vtkDataArray* FindNumbers(
  vtkFieldData* fields, const char* name, vtkIdType least, std::string& error)
{
  vtkDataArray* const array = fields->GetArray(name);
  std::ostringstream message;
  if (!array)
  {
    message << "The input image says that it is a region of a larger volume, but its field array \""
            << name << "\" is " << (fields->HasArray(name) ? "not of numbers." : "missing.");
  }
  else
  {
    const vtkIdType count = array->GetNumberOfTuples() * array->GetNumberOfComponents();
    if (count < least)
    {
      message << "The field array \"" << name << "\" of the input image has " << count
              << " number(s), and " << least << " are needed.";
    }
    for (vtkIdType i = 0; i < count && message.str().empty(); ++i)
    {
      const double value = array->GetComponent(
        i / array->GetNumberOfComponents(), static_cast<int>(i % array->GetNumberOfComponents()));
      if (!std::isfinite(value))
      {
        message << "The field array \"" << name << "\" of the input image has the value " << value
                << ", which is not finite.";
      }
    }
  }
  error = message.str();
  error += error.empty() ? "" : Cure;
  return error.empty() ? array : nullptr;
}

double NumberOf(vtkDataArray* array, int i)
{
  const int components = array->GetNumberOfComponents();
  return array->GetComponent(i / components, i % components);
}

} // namespace

bool ReadWholeFacts(vtkImageData* image, int component, WholeFacts& facts, std::string& error)
{
  using Names = vtkHapticRegionFilter;
  vtkFieldData* const fields = image->GetFieldData();
  facts = {};
  facts.IsThere = fields->HasArray(Names::GetWholeExtentName()) ||
    fields->HasArray(Names::GetNoiseName()) || fields->HasArray(Names::GetBorderValueName());
  if (!facts.IsThere)
  {
    return true;
  }
  vtkDataArray* const whole = FindNumbers(fields, Names::GetWholeExtentName(), 6, error);
  vtkDataArray* const noise =
    whole ? FindNumbers(fields, Names::GetNoiseName(), component + 1, error) : nullptr;
  vtkDataArray* const border =
    noise ? FindNumbers(fields, Names::GetBorderValueName(), component + 1, error) : nullptr;
  if (!border)
  {
    return false;
  }
  vtkDataArray* const time = fields->GetArray(Names::GetWholeTimeName());
  facts.Time = time && time->GetNumberOfTuples() > 0 ? time->GetComponent(0, 0) : 0.0;
  facts.Noise = NumberOf(noise, component);
  facts.BorderValue = NumberOf(border, component);
  int extent[6];
  image->GetExtent(extent);
  std::ostringstream message;
  if (facts.Noise < 0.0)
  {
    message << "The field array \"" << Names::GetNoiseName()
            << "\" of the input image has the value " << facts.Noise
            << ": a standard deviation is 0 or more." << Cure;
  }
  bool isWithin = true;
  for (int i = 0; i < 6; ++i)
  {
    const double bound = NumberOf(whole, i);
    isWithin = isWithin && bound == std::floor(bound) && std::abs(bound) < VTK_INT_MAX &&
      (i % 2 == 0 ? bound <= extent[i] : bound >= extent[i]);
    facts.Extent[i] = isWithin ? static_cast<int>(bound) : 0;
  }
  if (!isWithin)
  {
    message
      << "The input image has the extent (" << extent[0] << ", " << extent[1] << ", " << extent[2]
      << ", " << extent[3] << ", " << extent[4] << ", " << extent[5]
      << "), which is not within the whole volume that its field array \""
      << Names::GetWholeExtentName()
      << "\" tells of. A region keeps the indices that it has in the whole, with the origin and "
         "spacing of the whole."
      << Cure;
  }
  error = message.str();
  return error.empty();
}

void PlaceInWhole(vtkImageData* image, const WholeFacts& facts, VolumeView& view)
{
  const int* const extent = image->GetExtent();
  for (int a = 0; a < 3; ++a)
  {
    view.First[a] = std::int64_t{ extent[2 * a] } - facts.Extent[2 * a];
    view.Whole[a] = std::int64_t{ facts.Extent[2 * a + 1] } - facts.Extent[2 * a] + 1;
  }
  view.BorderValue = facts.BorderValue;
}

bool RegionSeries::IsSame(const Entry& a, const Entry& b)
{
  const HapticModelDescription& d = a.Description;
  const HapticModelDescription& e = b.Description;
  const bool isSameWhole = a.Facts.IsThere && b.Facts.IsThere &&
    std::equal(a.Facts.Extent, a.Facts.Extent + 6, b.Facts.Extent) &&
    a.Facts.Noise == b.Facts.Noise && a.Facts.BorderValue == b.Facts.BorderValue &&
    a.Facts.Time == b.Facts.Time && a.Array == b.Array && d.View.Type == e.View.Type &&
    IsIdentical(d.IndexToWorld, e.IndexToWorld);
  return isSameWhole && IsSameMaterial(d.Material, e.Material) && IsSameSetup(d, e) &&
    (d.Settings.HasIsoSurface || d.Mesh == e.Mesh);
}

std::uint64_t RegionSeries::Find(
  const HapticModelDescription& d, const WholeFacts& facts, const std::string& array) const
{
  const Entry wanted{ d, facts, array };
  const auto found = std::find_if(this->Last.begin(), this->Last.end(),
    [&](const Entry& entry) { return IsSame(entry, wanted); });
  return found == this->Last.end() ? 0 : found->Number;
}

void RegionSeries::Note(const HapticModelDescription& d, const WholeFacts& facts,
  const std::string& array, std::uint64_t number)
{
  if (!facts.IsThere)
  {
    return;
  }
  constexpr std::size_t most = 4;
  Entry entry{ d, facts, array, number };
  // Nothing is kept alive for a comparison, but a surface that is the user's own.
  entry.Description.Samples.reset();
  entry.Description.View.Data = nullptr;
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
