// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Manages the volumes that a hand can touch, each with its own filter, and chooses which one is
 * felt.
 */
#ifndef TouchedVolumes_h
#define TouchedVolumes_h

#include "VTK/Scene/Base/HapticViewRay.h"
#include "VTK/Scene/Interaction/TouchedScene.h"
#include "VTK/Scene/Volumes/TouchedVolume.h"

#include "vtkMultiVolume.h"
#include "vtkSmartPointer.h"
#include "vtkVolumeHapticsFilter.h"

#include <memory>
#include <vector>

class vtkRenderer;

namespace VolumeHaptics
{

/**
 * Manages the touched volumes, one of which is felt at a time. Depending on the style's FeltVolume,
 * this is the volume whose surface is nearest ahead of the tip along the line of sight, or whose
 * surface ahead pushes back most strongly. The felt volume changes only while there is no force and
 * the next surface ahead is more than a voxel away, so that the force never jumps. If drag begins
 * with the new volume, the device's rate limit makes it grow gradually. Invisible volumes are
 * neither chosen nor felt.
 */
class TouchedVolumes
{
public:
  TouchedVolumes(
    TouchedScene& scene, const HapticShownTimeSteps& pictures, const CarvedPictures& carved)
    : Scene(scene)
    , Pictures(pictures)
    , Carved(carved)
  {
  }

  ///@{
  /** See the style's TouchVolume and AddTouchedVolume. */
  bool Set(vtkVolume* volume);
  bool Add(vtkVolume* volume, vtkVolumeHapticsFilter* filter);
  ///@}
  /**
   * Adds a volume that feels like the first one: whenever the settings of the first volume's filter
   * change, they are copied to this volume's filter. Call Set() before and Update() afterwards.
   */
  void AddAlike(vtkVolume* volume);
  /** Returns the felt volume; null if there is none. */
  vtkVolume* Get() const;
  int GetCount() const { return static_cast<int>(this->All.size()); }

  /**
   * Collects the tissue that tools have removed from the volumes' filters and the device's filter.
   */
  std::vector<CarvedArray> CollectCarved() const;
  /**
   * Updates the filters to what their volumes show. Sets TouchedScene::Hidden if the felt volume is
   * not shown.
   */
  void Update();
  /** Makes the first shown volume the felt one, if any volume is shown. */
  void FeelShown();
  /** Chooses the felt volume along the line of sight through a position. */
  void ChooseAt(vtkRenderer* renderer, const Vector3& through);
  /** Chooses the felt volume ahead of the tip, unless something is touched. */
  void ChooseAhead(vtkRenderer* renderer);

private:
  struct Entry
  {
    std::unique_ptr<TouchedVolume> Volume;
    /** Filter of the volume; null stands for the device's filter. */
    vtkSmartPointer<vtkVolumeHapticsFilter> Filter;
    bool IsShown = true;
    bool IsAlike = false; ///< whether to copy the settings of the first volume's filter
  };
  /** Returns the felt volume; null if there is none. */
  const Entry* FindFelt() const;
  /** Returns whether a volume can be touched. If not, reports an error with the reason. */
  bool CanTouch(vtkVolume* volume) const;
  void Append(vtkVolume* volume, vtkVolumeHapticsFilter* filter);
  /** Adds volumes at new ports of the touched vtkMultiVolume. */
  void FollowPorts();
  void CopySettings();
  /** Returns the press for comparing surfaces: four of the smallest voxels deep. */
  Press ComputePress() const;
  /** Sets the device's filter. */
  void Feel(vtkVolumeHapticsFilter* filter);
  /** Returns the filter of the device, or, without a device, of the second hand's device. */
  vtkVolumeHapticsFilter* GetFeltFilter() const;
  vtkVolumeHapticsFilter* FilterOf(const Entry& entry) const
  {
    return entry.Filter ? entry.Filter.Get() : this->GetFeltFilter();
  }

  TouchedScene& Scene;
  const HapticShownTimeSteps& Pictures;
  const CarvedPictures& Carved;
  std::vector<Entry> All;
  vtkSmartPointer<vtkMultiVolume> Multi; ///< vtkMultiVolume whose ports are touched; null for other
                                         ///< volumes
  /** Change time of the first volume's filter when its settings were copied. */
  vtkMTimeType CopiedTime = 0;
  Vector3 ChosenTip; ///< tip at the last choice
  double ChosenTime = 0.0;
};

} // namespace VolumeHaptics

#endif
