// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Hands the servo the changes of the filter, and changes the method that is felt.
 */
#ifndef FilterPublisher_h
#define FilterPublisher_h

#include "VTK/Scene/TouchedScene.h"

#include "vtkType.h"

#include <functional>
#include <string>

namespace VolumeHaptics
{

class FilterPublisher
{
public:
  explicit FilterPublisher(TouchedScene& scene)
    : Scene(scene)
  {
  }

  /** For another device, whose servo has nothing yet. */
  void Reset() { this->Published = 0; }

  /**
   * Publishes if the filter, its image or its surface has changed, or if the workspace was placed
   * anew. Each change is tried once, as a change that fails will not succeed later.
   */
  void Update(bool isPlaced);

  /** See vtkInteractorStyleHaptic::NextMethod. The function shows a notice; "" for none. */
  bool NextMethod(const std::function<void(const std::string&)>& notify);

private:
  /** When the filter, its image or its surface changed last. */
  vtkMTimeType GetChangeTime() const;

  TouchedScene& Scene;
  vtkMTimeType Published = 0; ///< the change time that was published last, or could not be
  std::string Unfelt;         ///< the name of the method that could not be felt when last tried
  std::string FeltInstead;    ///< and the text of the one that stayed
};

} // namespace VolumeHaptics

#endif
