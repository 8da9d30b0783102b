// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Baking/HapticHash.h"

#include "vtkDataArray.h"
#include "vtkSmartPointer.h"
#include "vtksys/MD5.h"

#include <algorithm>

namespace VolumeHaptics
{
namespace
{
/**
 * Measured on a desktop computer of 2023; for other layouts, the values are copied.
 */
constexpr double SecondsPerByte = 1.6e-9;
constexpr double SecondsPerValue = 30e-9;
} // namespace

double EstimateHashTime(vtkDataArray* array)
{
  const auto values = static_cast<double>(array->GetNumberOfValues());
  return values *
    (array->HasStandardMemoryLayout() ? SecondsPerByte * array->GetDataTypeSize()
                                      : SecondsPerValue);
}

std::string HashArray(vtkDataArray* array, const int dimensions[3])
{
  vtksysMD5* const md5 = vtksysMD5_New();
  vtksysMD5_Initialize(md5);
  const auto append = [md5](const void* bytes, vtkIdType size)
  {
    // The hash takes int sizes.
    constexpr vtkIdType most = 1 << 30;
    const auto* from = static_cast<const unsigned char*>(bytes);
    for (vtkIdType done = 0; done < size; done += most)
    {
      vtksysMD5_Append(md5, from + done, static_cast<int>(std::min(most, size - done)));
    }
  };
  const int shape[] = { dimensions[0], dimensions[1], dimensions[2], array->GetNumberOfComponents(),
    array->GetDataType() };
  append(shape, sizeof(shape));
  if (array->HasStandardMemoryLayout())
  {
    append(array->GetVoidPointer(0), array->GetNumberOfValues() * array->GetDataTypeSize());
  }
  else
  {
    // The same bytes as above, one block of tuples at a time.
    constexpr vtkIdType block = 4096;
    const auto tuples =
      vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(array->GetDataType()));
    tuples->SetNumberOfComponents(array->GetNumberOfComponents());
    for (vtkIdType from = 0; from < array->GetNumberOfTuples(); from += block)
    {
      const vtkIdType size = std::min(block, array->GetNumberOfTuples() - from);
      tuples->SetNumberOfTuples(size);
      tuples->InsertTuples(0, size, from, array);
      append(tuples->GetVoidPointer(0), tuples->GetNumberOfValues() * tuples->GetDataTypeSize());
    }
  }
  char digest[33] = {};
  vtksysMD5_FinalizeHex(md5, digest);
  vtksysMD5_Delete(md5);
  return digest;
}

} // namespace VolumeHaptics
