// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Base/HapticHash.h"

#include "vtkDataArray.h"
#include "vtkSmartPointer.h"
#include "vtksys/MD5.h"

#include <algorithm>
#include <optional>

namespace VolumeHaptics
{
namespace
{

/**
 * Cost of hashing on a desktop computer of 2023. SecondsPerByte holds for arrays that store tuple
 * after tuple. SecondsPerValue holds for other memory layouts, whose values are copied first.
 */
constexpr double SecondsPerByte = 1.6e-9;
constexpr double SecondsPerValue = 30e-9;

constexpr double LookInterval = 0.02; // s

} // namespace

double EstimateHashTime(vtkDataArray* array)
{
  const auto values = static_cast<double>(array->GetNumberOfValues());
  return values *
    (array->HasStandardMemoryLayout() ? SecondsPerByte * array->GetDataTypeSize()
                                      : SecondsPerValue);
}

std::string HashArray(vtkDataArray* array, const int dimensions[3], const HashProgress& progress)
{
  vtksysMD5* const md5 = vtksysMD5_New();
  vtksysMD5_Initialize(md5);
  const auto append = [md5](const void* bytes, vtkIdType size)
  { vtksysMD5_Append(md5, static_cast<const unsigned char*>(bytes), static_cast<int>(size)); };
  bool isEnded = false;
  const auto goesOn = [&](vtkIdType done, vtkIdType all)
  {
    isEnded = progress && !progress(static_cast<double>(done) / static_cast<double>(all));
    return !isEnded;
  };
  const int shape[] = { dimensions[0], dimensions[1], dimensions[2], array->GetNumberOfComponents(),
    array->GetDataType() };
  append(shape, sizeof(shape));
  if (array->HasStandardMemoryLayout())
  {
    constexpr vtkIdType piece = 1 << 20; // bytes
    const auto* const bytes = static_cast<const unsigned char*>(array->GetVoidPointer(0));
    const vtkIdType all = array->GetNumberOfValues() * array->GetDataTypeSize();
    for (vtkIdType from = 0; from < all && goesOn(from, all); from += piece)
    {
      append(bytes + from, std::min(piece, all - from));
    }
  }
  else
  {
    // Copy and hash one block of tuples at a time, which yields the same bytes as above.
    constexpr vtkIdType block = 4096;
    const auto tuples =
      vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(array->GetDataType()));
    tuples->SetNumberOfComponents(array->GetNumberOfComponents());
    const vtkIdType all = array->GetNumberOfTuples();
    for (vtkIdType from = 0; from < all && goesOn(from, all); from += block)
    {
      const vtkIdType size = std::min(block, all - from);
      tuples->SetNumberOfTuples(size);
      tuples->InsertTuples(0, size, from, array);
      append(tuples->GetVoidPointer(0), tuples->GetNumberOfValues() * tuples->GetDataTypeSize());
    }
  }
  char digest[33] = {};
  vtksysMD5_FinalizeHex(md5, digest);
  vtksysMD5_Delete(md5);
  return isEnded ? std::string() : digest;
}

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
  const std::string* known = this->Work.Poll(key,
    [array](WorkMonitor& monitor) -> std::optional<std::string>
    {
      std::string hash = HashArray(array.Array, array.Dimensions.data(),
        [&monitor](double fraction) { return monitor.GoesOn(fraction); });
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
  // Without a result, the worker lacked memory or belongs to the parent of a forked process: hash
  // here.
  return known ? *known : HashArray(array.Array, array.Dimensions.data());
}

} // namespace VolumeHaptics
