// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Material/HapticTissues.h"

#include "vtkHapticProperty.h"
#include "vtkPiecewiseFunction.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace VolumeHaptics
{
namespace
{

std::string DescribeTissue(const NamedTissue& tissue)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << '"' << tissue.Name << "\", " << tissue.Low << " to " << tissue.High;
  return text.str();
}

/** Removes all points from `low` to `high`, including both ends. */
void RemovePoints(vtkPiecewiseFunction* function, double low, double high)
{
  for (int i = function->GetSize() - 1; i >= 0; --i)
  {
    double node[4];
    function->GetNodeValue(i, node);
    if (node[0] >= low && node[0] <= high)
    {
      function->RemovePointByIndex(static_cast<std::size_t>(i));
    }
  }
}

} // namespace

//------------------------------------------------------------------------------
int HapticTissues::Add(const NamedTissue& tissue, std::string& error)
{
  if (tissue.Name.empty())
  {
    error = "A tissue needs a name, but its text is empty.";
    return -1;
  }
  if (!std::isfinite(tissue.Low) || !std::isfinite(tissue.High) || tissue.Low > tissue.High)
  {
    error = "The tissue " + DescribeTissue(tissue) +
      ", is no range of values. Give two numbers, the lower one first.";
    return -1;
  }
  for (const NamedTissue& other : this->All)
  {
    if (other.Name == tissue.Name || (tissue.Low <= other.High && tissue.High >= other.Low))
    {
      error = "The tissue " + DescribeTissue(tissue) + ", has the name or values of the tissue " +
        DescribeTissue(other) + ". Give it others, or remove all tissues first.";
      return -1;
    }
  }
  const auto place = std::find_if(this->All.begin(), this->All.end(),
    [&tissue](const NamedTissue& other) { return other.Low > tissue.Low; });
  const auto number = static_cast<int>(place - this->All.begin());
  this->All.insert(place, tissue);
  return number;
}

//------------------------------------------------------------------------------
double HapticTissues::GetValue(vtkPiecewiseFunction* function, int tissue, double empty) const
{
  const NamedTissue& here = this->Get(tissue);
  return function->GetSize() == 0 ? empty : function->GetValue(0.5 * (here.Low + here.High));
}

//------------------------------------------------------------------------------
void HapticTissues::SetValue(
  vtkPiecewiseFunction* function, int tissue, double value, double empty) const
{
  const NamedTissue& here = this->Get(tissue);
  const auto valueAt = [&](double x)
  { return function->GetSize() == 0 ? empty : function->GetValue(x); };
  // Keep the neighbours' values at their ends, where the ramps begin.
  const bool hasBefore = tissue > 0;
  const bool hasBehind = tissue + 1 < this->GetSize();
  const double before = hasBefore ? this->Get(tissue - 1).High : 0.0;
  const double behind = hasBehind ? this->Get(tissue + 1).Low : 0.0;
  const double valueBefore = hasBefore ? valueAt(before) : 0.0;
  const double valueBehind = hasBehind ? valueAt(behind) : 0.0;
  // Remove the points between the tissues, because they would distort the linear ramps.
  RemovePoints(function, hasBefore ? before : here.Low, hasBehind ? behind : here.High);
  if (hasBefore)
  {
    function->AddPoint(before, valueBefore);
  }
  if (hasBehind)
  {
    function->AddPoint(behind, valueBehind);
  }
  function->AddPoint(here.Low, value);
  function->AddPoint(here.High, value);
}

//------------------------------------------------------------------------------
HapticTissues GetTissues(vtkHapticProperty* property)
{
  HapticTissues tissues;
  std::string error; // stays empty, because the property has already checked these tissues
  for (int i = 0; i < property->GetNumberOfTissues(); ++i)
  {
    double range[2];
    property->GetTissueRange(i, range);
    tissues.Add({ property->GetTissueName(i), range[0], range[1] }, error);
  }
  return tissues;
}

//------------------------------------------------------------------------------
void SetTissues(vtkHapticProperty* property, const HapticTissues& tissues)
{
  if (GetTissues(property) == tissues)
  {
    return;
  }
  property->RemoveAllTissues();
  for (int i = 0; i < tissues.GetSize(); ++i)
  {
    const NamedTissue& tissue = tissues.Get(i);
    property->AddTissue(tissue.Name.c_str(), tissue.Low, tissue.High);
  }
}

} // namespace VolumeHaptics
