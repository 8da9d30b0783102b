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

  /** False if it is none of them, or there is no editor. */
  bool Press(const std::string& key);
  /** Tells when the search for functions has ended; call it in each update. */
  void FollowProposal();

private:
  /** Whether undo and redo are for the editor: the pointer is over it, or nothing else has them. */
  bool HasPointer() const;
  /** Shows a notice if nothing was done. */
  void Tell(bool isDone, const char* notice);
  /** Looks for a proposal in the editor, or takes the one that it shows. */
  void Propose();
  /** Shows a notice, or none, instead of that about the search. */
  void EndProposing(const char* notice);
  /** Shows the labels in the editor, the touched one selected, or hides the editor. */
  void ToggleLabels();

  TouchedScene& Scene;
  SceneFrames& Frames;
  bool IsProposing = false;
  vtkWeakPointer<vtkHapticFunctionEditor> ProposingEditor;
};

} // namespace VolumeHaptics

#endif
