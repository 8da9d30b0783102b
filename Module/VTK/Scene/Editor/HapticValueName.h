// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The name of an array's values.
 */
#ifndef HapticValueName_h
#define HapticValueName_h

#include "vtkDataArray.h"
#include "vtkInformation.h"
#include "vtkInformationStringKey.h"

#include <algorithm>
#include <iterator>
#include <string>

namespace VolumeHaptics
{

/**
 * The title of a chart's axis: the array's name, its unit (vtkDataArray::UNITS_LABEL), or both.
 * Leaves out names that VTK's readers give to all arrays: they describe the storage, not the
 * meaning. "Value" if nothing is known.
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

} // namespace VolumeHaptics

#endif
