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

  /** Call it for another device: its servo has no model yet. */
  void Reset() { this->Published = 0; }

  /**
   * Publishes if the filter, its image or its surface has changed, or if the workspace was placed
   * again. Each change is tried once: a change that fails will not succeed later.
   */
  void Update(bool isPlaced);

  /** See vtkInteractorStyleHaptic::NextMethod. The function shows a notice, or none for "". */
  bool NextMethod(const std::function<void(const std::string&)>& notify);

private:
  /** When the filter, its image or its surface last changed. */
  vtkMTimeType GetChangeTime() const;

  TouchedScene& Scene;
  vtkMTimeType Published = 0; ///< the change time of the last attempt to publish
  std::string Unfelt;         ///< the name of the method that the last attempt found untouchable
  std::string FeltInstead;    ///< the text of the method that stayed instead
};

} // namespace VolumeHaptics

#endif
