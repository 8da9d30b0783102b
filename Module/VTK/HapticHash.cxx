// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "HapticHash.h"

#include "vtkDataArray.h"
#include "vtksys/MD5.h"

#include <algorithm>

namespace VolumeHaptics
{
namespace
{
/** Measured on a desktop computer of 2023; where the layout is another one each value is asked for. */
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
    for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
    {
      for (int c = 0; c < array->GetNumberOfComponents(); ++c)
      {
        const double value = array->GetComponent(i, c);
        append(&value, sizeof(value));
      }
    }
  }
  char digest[33] = {};
  vtksysMD5_FinalizeHex(md5, digest);
  vtksysMD5_Delete(md5);
  return digest;
}

} // namespace VolumeHaptics
