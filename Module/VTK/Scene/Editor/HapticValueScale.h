// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Converts between the scalars of an image and the values on a chart's axis.
 */
#ifndef HapticValueScale_h
#define HapticValueScale_h

#include "vtkDataArray.h"
#include "vtkInformation.h"
#include "vtkInformationStringKey.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>

namespace VolumeHaptics
{

/**
 * The scale of a vtkHapticProperty: value = (scalar + Shift) * Scale. Default: values are the
 * scalars themselves.
 */
struct ValueScale
{
  double Shift = 0.0;
  double Scale = 1.0;

  double operator()(double scalar) const { return (scalar + this->Shift) * this->Scale; }
  friend bool operator==(const ValueScale& a, const ValueScale& b)
  {
    return a.Shift == b.Shift && a.Scale == b.Scale;
  }
};

/**
 * Returns the title of a chart's axis: the array's name, its unit (vtkDataArray::UNITS_LABEL), or
 * both; "Value" if neither is known. Omits names that VTK's readers give to all arrays, because
 * they say nothing about the quantity.
 */
inline std::string NameValues(vtkDataArray* values)
{
  constexpr const char* ofReaders[] = { "MetaImage", "ImageFile", "NIFTI", "DICOM", "DICOMImage",
    "PNGImage", "JPEGImage", "BMPImage", "Tiff Scalars", "ImageScalars" };
  const char* const given = values ? values->GetName() : nullptr;
  const std::string name = given ? given : "";
  const bool isMeant = !name.empty() &&
    std::find(std::begin(ofReaders), std::end(ofReaders), name) == std::end(ofReaders);
  const bool hasUnit = values && values->HasInformation() &&
    values->GetInformation()->Has(vtkDataArray::UNITS_LABEL());
  const std::string unit =
    hasUnit ? values->GetInformation()->Get(vtkDataArray::UNITS_LABEL()) : std::string();
  if (!isMeant)
  {
    return unit.empty() ? "Value" : unit;
  }
  return unit.empty() || unit == name ? name : name + " (" + unit + ")";
}

/** Returns the smallest round number that is at least `value`. */
inline double RoundUp(double value)
{
  const double decade = std::pow(10.0, std::floor(std::log10(value)));
  for (const double step : { 1.0, 1.2, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0 })
  {
    if (value <= step * decade * (1.0 + 1e-9))
    {
      return step * decade;
    }
  }
  return 10.0 * decade;
}

} // namespace VolumeHaptics

#endif
