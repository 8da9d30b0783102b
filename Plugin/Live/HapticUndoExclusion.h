// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Excludes changes of proxies from ParaView's undo stack.
 */
#ifndef HapticUndoExclusion_h
#define HapticUndoExclusion_h

#include "vtkSMProxyManager.h"
#include "vtkSMUndoStackBuilder.h"
#include "vtkSmartPointer.h"

namespace VolumeHapticsLive
{

/**
 * While this object exists, changes can't be undone. Use it for changes that result from the device
 * or from the user's changes. With entries of their own on the undo stack, they would be undone
 * instead of the user's change, and would delete the entries for redo.
 */
class HapticUndoExclusion
{
public:
  HapticUndoExclusion()
    : Builder(vtkSMProxyManager::GetProxyManager()->GetUndoStackBuilder())
  {
    if (this->Builder)
    {
      this->IgnoredBefore = this->Builder->GetIgnoreAllChanges();
      this->Builder->SetIgnoreAllChanges(true);
    }
  }
  ~HapticUndoExclusion()
  {
    if (this->Builder)
    {
      this->Builder->SetIgnoreAllChanges(this->IgnoredBefore);
    }
  }
  HapticUndoExclusion(const HapticUndoExclusion&) = delete;
  void operator=(const HapticUndoExclusion&) = delete;

private:
  const vtkSmartPointer<vtkSMUndoStackBuilder> Builder; ///< null if there is no undo stack
  bool IgnoredBefore = false;
};

} // namespace VolumeHapticsLive

#endif
