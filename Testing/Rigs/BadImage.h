// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests that an image that can't be touched causes one error, which names the input, the array and
 * the remedy, and an empty output, even after a valid output. With a valid image, the filter works
 * again.
 */
#ifndef BadImage_h
#define BadImage_h

#include "ApiRig.h"

namespace apitest
{
struct BadImage
{
  const char* Name;
  std::function<void(vtkImageData*, vtkVolumeHapticsFilter*)> Break;
  std::vector<std::string> Words;
};

inline std::ostream& operator<<(std::ostream& os, const BadImage& image)
{
  return os << image.Name;
}

inline void NameArray(vtkVolumeHapticsFilter* filter, const char* name)
{
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, name);
}

class BadImageTest
  : public ApiTest
  , public testing::WithParamInterface<BadImage>
{
protected:
  /// Damages the image, and expects one error with the parameter's words. Repairs the image, and
  /// expects no error.
  void ExpectErrorAndRecovery()
  {
    this->Run(51);
    this->GetParam().Break(this->Image, this->Filter);
    this->Image->Modified();
    this->ExpectError(this->GetParam().Words);

    NameArray(this->Filter, "Density");
    this->Filter->SetKernelRadius(2);
    this->Property->SetComponent(0);
    this->Filter->SetInputDataObject(0, MakeRamp());
    this->Run(51);
  }
};

inline std::string NameOf(const testing::TestParamInfo<BadImage>& info)
{
  return info.param.Name;
}
} // namespace apitest

#endif
