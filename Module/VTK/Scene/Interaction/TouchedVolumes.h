// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The volumes that a hand can touch, each with a filter of its own, and which of them it feels.
 */
#ifndef TouchedVolumes_h
#define TouchedVolumes_h

#include "VTK/Scene/Base/HapticViewRay.h"
#include "VTK/Scene/Interaction/TouchedScene.h"
#include "VTK/Scene/Volumes/TouchedVolume.h"

#include "vtkSmartPointer.h"
#include "vtkVolumeHapticsFilter.h"

#include <memory>
#include <vector>

class vtkRenderer;

namespace VolumeHaptics
{

/**
 * The servo feels one volume at a time: that whose surface is the first one ahead of the tip, along
 * the line of sight, or that whose surface ahead pushes back most strongly, as the style's
 * FeltVolume says. It changes only while there is no force and the next surface ahead is more
 * than a voxel away, so that no force steps; the device's rate limits a drag that begins. Volumes
 * that are not seen are not chosen, and not felt.
 */
class TouchedVolumes
{
public:
  TouchedVolumes(
    TouchedScene& scene, const HapticShownFrames& pictures, const CarvedPictures& carved)
    : Scene(scene)
    , Pictures(pictures)
    , Carved(carved)
  {
  }

  ///@{
  /** See TouchVolume and AddTouchedVolume of the style. */
  bool Set(vtkVolume* volume);
  bool Add(vtkVolume* volume, vtkVolumeHapticsFilter* filter);
  ///@}
  /** The volume that is felt; null if there is none. */
  vtkVolume* Get() const;
  int GetCount() const { return static_cast<int>(this->All.size()); }

  /** What tools have removed, by the filters of the volumes and that of the device. */
  std::vector<CarvedArray> FindCarved() const;
  /**
   * Gives the filters what their volumes show now. TouchedScene::Hidden tells if the one that is
   * felt is not shown.
   */
  void Follow();
  /** Feels the first volume that is shown instead of one that is not, if there is any. */
  void FeelShown();
  /** Chooses among the volumes along the line of sight through a position. */
  void ChooseAt(vtkRenderer* renderer, const Vector3& through);
  /** Chooses among the volumes ahead of the tip, if nothing is touched. */
  void ChooseAhead(vtkRenderer* renderer);

private:
  struct Entry
  {
    std::unique_ptr<TouchedVolume> Volume;
    vtkSmartPointer<vtkVolumeHapticsFilter> Filter; ///< null: the device's
    bool IsShown = true;
  };
  /** The one that is felt; null if there is none. */
  const Entry* FindFelt() const;
  /** Whether a volume can be touched; if not, tells why. */
  bool CanTouch(vtkVolume* volume) const;
  /** The press by which surfaces are compared: four of the smallest voxels deep. */
  Press FindPress() const;
  /** The device feels by this filter from now on. */
  void Feel(vtkVolumeHapticsFilter* filter);
  vtkVolumeHapticsFilter* FilterOf(const Entry& entry) const
  {
    return entry.Filter ? entry.Filter.Get() : this->Scene.Device->GetVolumeHaptics();
  }

  TouchedScene& Scene;
  const HapticShownFrames& Pictures;
  const CarvedPictures& Carved;
  std::vector<Entry> All;
  Vector3 ChosenTip; ///< the tip when it was chosen last
  double ChosenTime = 0.0;
};

} // namespace VolumeHaptics

#endif
