// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Two settings of a filter, A and B, felt in turn at one spot.
 */
#ifndef ComparedSettings_h
#define ComparedSettings_h

#include "VTK/Scene/Interaction/TouchedScene.h"

#include "vtkWeakPointer.h"

#include <functional>
#include <memory>
#include <string>

class vtkVolumeHapticsFilter;

namespace VolumeHaptics
{

class FilterPublisher;
class KeptSettings;

class ComparedSettings
{
public:
  ComparedSettings(TouchedScene& scene, FilterPublisher& publisher);
  ~ComparedSettings() = default;
  ComparedSettings(const ComparedSettings&) = delete;
  ComparedSettings& operator=(const ComparedSettings&) = delete;

  /** See vtkInteractorStyleHaptic::SwapSettings. The function shows a notice; "" removes it. */
  bool Swap(const std::function<void(const std::string&)>& notify);

  /** "A" or "B", or nothing if none are compared. */
  std::string GetName() const;

  /** Forgets the settings that are not felt; call this for a new device, too. */
  void End();

  /** Sets the name of the felt settings in the head-up display; call it in each update. */
  void Tell();

private:
  /** The filter of the device; null without one. */
  vtkVolumeHapticsFilter* FindFilter() const;

  TouchedScene& Scene;
  FilterPublisher& Publisher;
  vtkWeakPointer<vtkVolumeHapticsFilter> Filter; ///< the filter with the compared settings
  std::shared_ptr<const KeptSettings> Other;     ///< the settings that are not felt
  bool IsB = false;                              ///< whether B is felt
  bool IsTold = false;
};

} // namespace VolumeHaptics

#endif
