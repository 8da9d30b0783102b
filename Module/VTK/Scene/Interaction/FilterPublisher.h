// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Hands the servo the changes of the filter, and changes the method that is felt.
 */
#ifndef FilterPublisher_h
#define FilterPublisher_h

#include "VTK/Scene/Interaction/TouchedScene.h"

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
  void Reset();

  /**
   * Publishes if the filter, its image or its surface has changed, or if the workspace was placed
   * again. Each change is tried once: a change that fails will not succeed later. A method that was
   * made ready in the background, and can't be felt, gives way to the one before.
   */
  void Update(bool isPlaced);

  /**
   * Changes the filter and publishes it; undoes the change, with an error, if it can't be felt,
   * later if it is made ready in the background. `name` is that of the settings that are tried.
   */
  bool Try(const std::function<void()>& change, const std::function<void()>& undo,
    const std::string& name, const std::function<void(const std::string&)>& notify);

  /** See vtkInteractorStyleHaptic::NextMethod. The function shows a notice, or none for "". */
  bool NextMethod(const std::function<void(const std::string&)>& notify);

private:
  /** When the filter, its image or its surface last changed. */
  vtkMTimeType GetChangeTime() const;

  /** A change of the method that is made ready in the background; no text if there is none. */
  struct MethodChange
  {
    int Method = 0; ///< the one before, with its solver and its text
    int Solver = 0;
    std::string Before;
    std::string Wanted; ///< the text of the new one
    /** Of more than the method; with the name of the settings. */
    std::function<void()> Undo = nullptr;
    std::string Name = {};
  };
  using Notify = std::function<void(const std::string&)>;

  /** Takes settings back that can't be felt. */
  void TakeBack(const std::function<void()>& undo, const std::string& name, bool wasPublished,
    const Notify& notify);
  /** Goes back to the method before, after an error. */
  void GoBack(const MethodChange& change, vtkVolumeHapticsFilter* filter, bool wasPublished,
    const Notify& notify);
  /** Ends the change that is awaited, if it is ready. */
  void FollowAwaited();
  /** In the head-up display, if there is one. */
  void SetNotice(const std::string& notice);

  TouchedScene& Scene;
  vtkMTimeType Published = 0; ///< the change time of the last attempt to publish
  std::string Unfelt;         ///< the name of the method that the last attempt found untouchable
  std::string FeltInstead;    ///< the text of the method that stayed instead
  MethodChange Awaited;
};

} // namespace VolumeHaptics

#endif
