// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A pipeline stage that passes its input on unchanged.
 */
#ifndef GivenImage_h
#define GivenImage_h

#include <vtkImageAlgorithm.h>
#include <vtkImageData.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>

namespace apitest
{

/**
 * Passes on its input with its time steps, like a file reader. Behind a source that uses time steps
 * without a copy, this filter makes the pipeline copy each time step when the time reaches it.
 */
class GivenImage : public vtkImageAlgorithm
{
public:
  static GivenImage* New() { VTK_STANDARD_NEW_BODY(GivenImage); }
  vtkTypeMacro(GivenImage, vtkImageAlgorithm);

protected:
  int RequestData(
    vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override
  {
    vtkImageData::GetData(outputs)->ShallowCopy(vtkImageData::GetData(inputs[0]));
    return 1;
  }
};

} // namespace apitest

#endif
