// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Filter/FilterSources.h"

#include "vtkAlgorithm.h"
#include "vtkAlgorithmOutput.h"
#include "vtkExecutive.h"
#include "vtkImageData.h"

#include <sstream>

namespace VolumeHaptics
{

//------------------------------------------------------------------------------
bool UpdateSources(vtkAlgorithm* filter)
{
  bool hasRun = true;
  for (const int port : { 0, 2, 3 }) // port 1, the path, is not needed
  {
    if (vtkAlgorithm* const source = filter->GetInputAlgorithm(port, 0))
    {
      try
      {
        const int output = filter->GetInputConnection(port, 0)->GetIndex();
        hasRun = source->GetExecutive()->Update(output) != 0 && hasRun;
      }
      catch (const std::bad_alloc&)
      {
        throw SourceLacksMemory(port);
      }
    }
  }
  return hasRun;
}

//------------------------------------------------------------------------------
std::string DescribeLackOfMemory(vtkImageData* image)
{
  std::ostringstream message;
  message << "There is not enough memory to make the image on input port 0 ready to be touched";
  if (image && image->GetNumberOfPoints() > 0)
  {
    const int* const n = image->GetDimensions();
    message << ": it is of " << n[0] << " x " << n[1] << " x " << n[2] << " points and takes "
            << image->GetActualMemorySize() / 1024 << " MiB itself";
  }
  message << ". Use a smaller image, or a region of it with vtkHapticRegionFilter; of the methods, "
             "SURFACE_PROXY takes the most.";
  return message.str();
}

} // namespace VolumeHaptics
