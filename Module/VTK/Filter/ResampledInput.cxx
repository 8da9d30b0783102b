// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Filter/ResampledInput.h"

#include "VTK/Base/HapticFiles.h"

#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkHapticRegionSource.h"
#include "vtkImageData.h"

#include <algorithm>
#include <sstream>
#include <utility>

namespace VolumeHaptics
{

//------------------------------------------------------------------------------
vtkHapticRegionSource* ResampledInput::Find(vtkDataObject* data, std::vector<std::string>&& arrays)
{
  const bool isSet = vtkDataSet::SafeDownCast(data) || vtkCompositeDataSet::SafeDownCast(data);
  if (!isSet || vtkImageData::SafeDownCast(data))
  {
    *this = {};
    return nullptr;
  }
  arrays.erase(std::remove(arrays.begin(), arrays.end(), std::string()), arrays.end());
  if (this->Of != data || this->Time != data->GetMTime() || this->Arrays != arrays)
  {
    this->Source = vtkSmartPointer<vtkHapticRegionSource>::New();
    this->Of = data;
    this->Time = data->GetMTime();
    this->Arrays = std::move(arrays);
    this->Error.clear();
    if (!this->Source->OpenDataSet(data, 0.0, this->Arrays, this->Error))
    {
      this->Source = nullptr;
    }
  }
  return this->Source;
}

//------------------------------------------------------------------------------
std::string ResampledInput::DescribeFault(vtkDataObject* data) const
{
  if (!this->Error.empty())
  {
    return Printable(this->Error);
  }
  return data ? std::string("A ") + data->GetClassName() +
      " can't be touched. Connect a vtkImageData, or a data set with cells, to input port 0."
              : "There is no image to touch. Connect a vtkImageData to input port 0.";
}

//------------------------------------------------------------------------------
std::string ResampledInput::DescribeStillSteps(
  vtkDataObject* data, const std::vector<double>& steps)
{
  if (!data || steps.empty() || steps == this->ToldSteps)
  {
    return {};
  }
  this->ToldSteps = steps;
  std::ostringstream text;
  text << "The " << data->GetClassName() << " on port 0 has " << steps.size()
       << " time steps, of which only the first one, " << steps.front()
       << ", is felt: what is resampled around the tip stands still. For a volume that moves put "
          "vtkResampleToImage between source and filter, which gives an image of each step. Else "
          "choose one step: SetTimeUnitsPerSecond(0), and UpdateTimeStep().";
  return text.str();
}

} // namespace VolumeHaptics
