// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Makes the volumes of a scene show what a tool has left of them.
 */
#ifndef CarvedPictures_h
#define CarvedPictures_h

#include "VTK/Scene/Volumes/CarvedPicture.h"

#include <memory>
#include <vector>

class vtkAlgorithmOutput;
class vtkImageData;
class vtkRenderer;
class vtkVolumeMapper;

namespace VolumeHaptics
{

class CarvedPictures
{
public:
  /**
   * Updates the volumes that show the arrays, in all renderers of a renderer's window. Returns
   * whether a frame should be drawn. Other volumes show all of their tissue again.
   */
  bool Update(vtkRenderer* renderer, const std::vector<CarvedArray>& arrays);
  /** Makes all volumes show all of their tissue again. */
  void Clear() { this->All.clear(); }

  ///@{
  /** The first input of a mapper, as the application has set it. Null if there is none. */
  vtkAlgorithmOutput* FindInput(vtkVolumeMapper* mapper) const;
  vtkImageData* FindImage(vtkVolumeMapper* mapper) const;
  ///@}

private:
  void Find(vtkRenderer* renderer, const CarvedArray& array,
    std::vector<std::unique_ptr<CarvedPicture>>& now);

  std::vector<std::unique_ptr<CarvedPicture>> All;
};

} // namespace VolumeHaptics

#endif
