// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Reports that a proxy has to release the hand: an object that it needs is removed from the
 * pipeline, the session is closed, or the server is lost.
 */
#ifndef HapticSessionWatch_h
#define HapticSessionWatch_h

#include "vtkObject.h"
#include "vtkWeakPointer.h"

#include <functional>
#include <utility>
#include <vector>

class vtkSMProxy;
class vtkSMSession;

namespace VolumeHapticsLive
{

/**
 * A proxy that is no longer registered counts as deleted: a variable in a script keeps it alive, so
 * destructors come too late.
 */
class HapticSessionWatch
{
public:
  struct Calls
  {
    std::function<void(vtkSMProxy*)> Unregistered; ///< any proxy of the session
    std::function<void()> Closed;                  ///< the session is about to end
    std::function<void()> Lost;                    ///< the server does not answer any more
  };

  explicit HapticSessionWatch(Calls calls);
  ~HapticSessionWatch();
  HapticSessionWatch(const HapticSessionWatch&) = delete;
  void operator=(const HapticSessionWatch&) = delete;

  /** Watch this session only. */
  void Watch(vtkSMSession* session);

private:
  void NoteUnregistered(vtkObject*, unsigned long, void* data);
  void NoteClosed(vtkObject*, unsigned long, void* data);
  void NoteLost();
  void LetGo();

  Calls Call;
  vtkWeakPointer<vtkObject> Session;
  std::vector<std::pair<vtkWeakPointer<vtkObject>, unsigned long>> Observers;
};

} // namespace VolumeHapticsLive

#endif
