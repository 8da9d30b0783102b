// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Base/WholeFacts.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"

#include <cmath>
#include <sstream>

namespace VolumeHaptics
{
namespace
{

const char* const Cure = " Make the region with vtkHapticRegionFilter, which writes all field "
                         "arrays that it needs, or remove the "
                         "field arrays HapticWholeExtent, HapticNoise and HapticBorderValue to "
                         "touch the image as a volume of its own.";

/**
 * Number of values of a BackgroundLevel per component. The first two values are equal if there is
 * no level.
 */
constexpr vtkIdType NumbersOfSolid = 4;

/**
 * Number of values of a StoredShift: the shift, the value of air, whether the values can't be
 * Hounsfield units, and the two ends of the range.
 */
constexpr int NumbersOfShift = 5;
constexpr int NumbersOfOutside = 4;

/** Returns the i-th number of an array, counted through the components of tuple after tuple. */
double NumberOf(vtkDataArray* array, vtkIdType i)
{
  const int components = array->GetNumberOfComponents();
  return array->GetComponent(i / components, static_cast<int>(i % components));
}

/**
 * Returns a numeric field array with at least `least` finite numbers. If it is missing or invalid,
 * returns null, with the reason in `error`.
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
      const double value = NumberOf(array, i);
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

template <typename Array, typename Numbers>
void AddField(vtkImageData* image, const char* name, const Numbers& numbers)
{
  const vtkNew<Array> array;
  array->SetName(name);
  for (const auto number : numbers)
  {
    array->InsertNextValue(number);
  }
  image->GetFieldData()->AddArray(array);
}

} // namespace

bool ReadWholeFacts(vtkImageData* image, int component, WholeFacts& facts, std::string& error)
{
  using Names = WholeFactNames;
  vtkFieldData* const fields = image->GetFieldData();
  facts = {};
  facts.IsThere = fields->HasArray(Names::WholeExtent) || fields->HasArray(Names::Noise) ||
    fields->HasArray(Names::BorderValue);
  if (!facts.IsThere)
  {
    return true;
  }
  vtkDataArray* const whole = FindNumbers(fields, Names::WholeExtent, 6, error);
  vtkDataArray* const noise =
    whole ? FindNumbers(fields, Names::Noise, component + 1, error) : nullptr;
  vtkDataArray* const border =
    noise ? FindNumbers(fields, Names::BorderValue, component + 1, error) : nullptr;
  if (!border)
  {
    return false;
  }
  vtkDataArray* const time = fields->GetArray(Names::WholeTime);
  facts.Time = time && time->GetNumberOfTuples() > 0 ? time->GetComponent(0, 0) : 0.0;
  vtkDataArray* const share = fields->GetArray(Names::Share);
  facts.Share = share && share->GetNumberOfTuples() > 0 ? share->GetComponent(0, 0) : 1.0;
  vtkDataArray* const outside = fields->GetArray(Names::Outside);
  if (outside && outside->GetNumberOfComponents() == NumbersOfOutside &&
    outside->GetNumberOfTuples() > component)
  {
    const auto at = [&](int i) { return outside->GetComponent(component, i); };
    facts.Outside = { at(0) != 0.0, at(1), at(2), at(3) };
  }
  facts.Noise = NumberOf(noise, component);
  facts.BorderValue = NumberOf(border, component);
  if (fields->HasArray(Names::Solid))
  {
    const vtkIdType first = NumbersOfSolid * static_cast<vtkIdType>(component);
    vtkDataArray* const solid = FindNumbers(fields, Names::Solid, first + NumbersOfSolid, error);
    if (!solid)
    {
      return false;
    }
    facts.Solid = { NumberOf(solid, first) < NumberOf(solid, first + 1), NumberOf(solid, first),
      NumberOf(solid, first + 1), NumberOf(solid, first + 2), NumberOf(solid, first + 3) };
  }
  vtkDataArray* const shift = fields->GetArray(Names::Shift);
  if (shift && shift->GetNumberOfComponents() == NumbersOfShift &&
    shift->GetNumberOfTuples() > component)
  {
    const auto at = [&](int i) { return shift->GetComponent(component, i); };
    facts.Shift = { at(0), at(1), at(2) != 0.0, { at(3), at(4) } };
  }
  int extent[6];
  image->GetExtent(extent);
  std::ostringstream message;
  if (facts.Noise < 0.0)
  {
    message << "The field array \"" << Names::Noise << "\" of the input image has the value "
            << facts.Noise << ": a standard deviation is 0 or more." << Cure;
  }
  if (!(facts.Share > 0.0 && facts.Share <= 1.0))
  {
    message << "The field array \"" << Names::Share << "\" of the input image has the value "
            << facts.Share << ": it is a share of the force, above 0 and at most 1." << Cure;
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
      << "), which is not within the whole volume that its field array \"" << Names::WholeExtent
      << "\" tells of. A region keeps the indices that it has in the whole, with the origin and "
         "spacing of the whole."
      << Cure;
  }
  error = message.str();
  return error.empty();
}

void WriteWholeFacts(const WholeFields& facts, vtkImageData* region)
{
  using Names = WholeFactNames;
  AddField<vtkIntArray>(region, Names::WholeExtent, facts.Extent);
  AddField<vtkDoubleArray>(region, Names::Noise, facts.Noise);
  AddField<vtkDoubleArray>(region, Names::BorderValue, facts.BorderValues);
  std::vector<double> solids;
  for (const BackgroundLevel& solid : facts.Solids)
  {
    solids.insert(solids.end(), { solid.Threshold, solid.Full, solid.Dark, solid.Bright });
  }
  AddField<vtkDoubleArray>(region, Names::Solid, solids);
  const vtkNew<vtkDoubleArray> shifts;
  shifts->SetName(Names::Shift);
  shifts->SetNumberOfComponents(NumbersOfShift);
  for (const StoredShift& shift : facts.Shifts)
  {
    const double numbers[NumbersOfShift] = { shift.Shift, shift.Air, shift.IsStrange ? 1.0 : 0.0,
      shift.Range[0], shift.Range[1] };
    shifts->InsertNextTuple(numbers);
  }
  region->GetFieldData()->AddArray(shifts);
  const double share[] = { facts.Share };
  if (facts.Share < 1.0)
  {
    AddField<vtkDoubleArray>(region, Names::Share, share);
  }
  const vtkNew<vtkDoubleArray> outside;
  outside->SetName(Names::Outside);
  outside->SetNumberOfComponents(NumbersOfOutside);
  bool isAny = false;
  for (const OutsideSamples& component : facts.Outside)
  {
    outside->InsertNextTuple4(
      component.AreNonFinite ? 1.0 : 0.0, component.Missing, component.Fill, component.Holes);
    isAny = isAny || component.HasAny() || component.Holes > 0.0;
  }
  if (isAny)
  {
    region->GetFieldData()->AddArray(outside);
  }
  const double time[] = { facts.Time };
  AddField<vtkDoubleArray>(region, Names::WholeTime, time);
}

} // namespace VolumeHaptics
