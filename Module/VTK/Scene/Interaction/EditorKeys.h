// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The keys of the function editor, see vtkInteractorStyleHaptic, and its search for functions.
 */
#ifndef EditorKeys_h
#define EditorKeys_h

#include "VTK/Scene/Interaction/TouchedScene.h"

#include "vtkWeakPointer.h"

#include <string>

namespace VolumeHaptics
{

class SceneFrames;

class EditorKeys
{
public:
  EditorKeys(TouchedScene& scene, SceneFrames& frames)
    : Scene(scene)
    , Frames(frames)
  {
  }

  /** False if the key is none of them, or without an editor. */
  bool Press(const std::string& key);
  /** Reports the end of the search for functions; call it in each update. */
  void FollowProposal();

private:
  /**
   * Whether undo and redo belong to the editor: the pointer is over it, or nothing else uses these
   * keys.
   */
  bool HasPointer() const;
  /** Shows a notice if nothing was done. */
  void Tell(bool isDone, const char* notice);
  /** Searches for a proposal in the editor, or accepts the proposal that it shows. */
  void Propose();
  /** Replaces the notice about the search by another notice, or by none. */
  void EndProposing(const char* notice);
  /** Shows the labels in the editor, with the touched label selected, or hides the editor. */
  void ToggleLabels();

  TouchedScene& Scene;
  SceneFrames& Frames;
  bool IsProposing = false;
  vtkWeakPointer<vtkHapticFunctionEditor> ProposingEditor;
};

} // namespace VolumeHaptics

#endif
