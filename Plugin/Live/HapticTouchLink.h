// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Makes a filter in the client with the settings of a filter proxy whose data may be elsewhere.
 */
#ifndef HapticTouchLink_h
#define HapticTouchLink_h

#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

class vtkObject;
class vtkSMProxy;
class vtkSMSourceProxy;
class vtkVolumeHapticsFilter;

namespace VolumeHapticsLive
{

/**
 * The tissue that a burr in the hand has removed belongs to the followed filter, if that filter is
 * in this process: its paths begin with what the hand has left. Otherwise the second filter stores
 * removed tissue itself, and also gets the commands to undo, redo and restore.
 *
 * The settings are in a second proxy of the same kind, whose objects exist in the client only. It
 * copies every property of the first proxy, except the inputs; functions are shared, because
 * ParaView's piecewise functions are on the client, too.
 */
class HapticTouchLink
{
public:
  HapticTouchLink() = default;
  ~HapticTouchLink();
  HapticTouchLink(const HapticTouchLink&) = delete;
  void operator=(const HapticTouchLink&) = delete;

  /** Follow the changes of the proxy's settings; nullptr ends that. */
  void Follow(vtkSMProxy* touch);

  /** Null without a proxy, or if it is no vtkVolumeHapticsFilter. */
  vtkVolumeHapticsFilter* GetFilter() const;
  vtkSMProxy* GetTouch() const;

  /**
   * The source to which an input of the followed proxy is connected, and its port; or null.
   */
  vtkSMSourceProxy* GetInput(const char* name, unsigned int& port) const;

private:
  void NoteChange() { this->IsDirty = true; }
  /** Called with the name of a chosen command. */
  void PassCommand(vtkObject* touch, unsigned long event, void* name);
  void ShareRemoval();
  /** The followed filter, if it is in this process; else null. */
  vtkVolumeHapticsFilter* FindTouched() const;
  void LetGo();
  void CopySettings();

  vtkWeakPointer<vtkSMProxy> Touch;
  vtkSmartPointer<vtkSMProxy> Twin;
  unsigned long Observer = 0;
  unsigned long CommandObserver = 0;
  bool IsDirty = false;
};

} // namespace VolumeHapticsLive

#endif
