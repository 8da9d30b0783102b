// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The keys of a scene's parts: display, editor, modes and moving volume.
 */
#ifndef SceneKeys_h
#define SceneKeys_h

#include "VTK/Scene/Interaction/TouchedScene.h"

#include "vtkWeakPointer.h"

#include <string>
#include <vector>

namespace VolumeHaptics
{

class KeyMap;
class SceneFrames;
class ToolTurn;
class TouchMode;

/** The keys of the head-up display, see vtkInteractorStyleHaptic, and its hints for newcomers. */
class DisplayKeys
{
public:
  DisplayKeys(TouchedScene& scene, const TouchMode& touch, const ToolTurn& turn, const KeyMap& keys)
    : Scene(scene)
    , Touch(touch)
    , Turn(turn)
    , Keys(keys)
  {
  }

  /** Carries out a key. False for a key of other parts, and without a display. */
  bool Press(const std::string& key);
  void HideKeys();
  /** Returns the list of keys for the current scene. */
  std::string ListKeys() const;
  /** Shows what to do next, until something is touched. */
  void UpdateHint();

  std::string ApplicationKeys; ///< keys of the application, listed after the style's

private:
  std::string ChooseHint();
  /**
   * Returns a line about the key of an action, by its default key; empty if the action has no key.
   */
  std::string DescribeKey(const char* before, const char* defaultKey, const char* after) const;

  TouchedScene& Scene;
  const TouchMode& Touch;
  const ToolTurn& Turn;
  const KeyMap& Keys;
  bool WasTouching = false; ///< state at the last call of UpdateHint
  bool HasTouched = false;  ///< whether something was touched since touch mode or arming began
  std::string Shown;        ///< the last hint
};

/** The keys of the function editor, see vtkInteractorStyleHaptic, and its search for functions. */
class EditorKeys
{
public:
  EditorKeys(TouchedScene& scene, SceneFrames& frames)
    : Scene(scene)
    , Frames(frames)
  {
  }

  /** Carries out a key. False for a key of other parts, and without an editor. */
  bool Press(const std::string& key);
  /** Reports the end of the search for functions; call it in each update. */
  void PollProposal();

private:
  /**
   * Whether undo and redo belong to the editor: the pointer is over it, or nothing else uses these
   * keys.
   */
  bool HasPointer() const;
  /** Shows a notice if nothing was done. */
  void Report(bool isDone, const char* notice);
  /** Searches for a proposal in the editor, or accepts the proposal that it shows. */
  void Propose();
  /** Replaces the notice about the search by another one; null for none. */
  void EndProposing(const char* notice);
  /** Shows the labels in the editor, with the touched label selected, or hides the editor. */
  void ToggleLabels();

  TouchedScene& Scene;
  SceneFrames& Frames;
  bool IsProposing = false;
  vtkWeakPointer<vtkHapticFunctionEditor> ProposingEditor;
};

/** Chooses which modes of PRIMITIVES are felt: by a key, and by clicks on their list. */
class ModeKeys
{
public:
  explicit ModeKeys(TouchedScene& scene)
    : Scene(scene)
  {
  }

  /**
   * Feels the next mode alone; after the last one all modes, unless they are too many for a tick.
   * False if PRIMITIVES is not felt.
   */
  bool Next();
  /**
   * Switches the mode at a position in the head-up display's list on or off. False if none is
   * there.
   */
  bool Click(int x, int y);

private:
  vtkVolumeHapticsFilter* GetFilter() const;
  /** Undoes all changes, with a notice, if they can't be felt. */
  void Set(vtkVolumeHapticsFilter* filter, const std::vector<bool>& active);

  TouchedScene& Scene;
};

/** The keys of a volume that moves: see vtkInteractorStyleHaptic. */
class PlaybackKeys
{
public:
  explicit PlaybackKeys(TouchedScene& scene)
    : Scene(scene)
  {
  }

  /** Carries out a key. False for a key of other parts, and without a moving volume. */
  bool Press(const std::string& key);

private:
  TouchedScene& Scene;
};

} // namespace VolumeHaptics

#endif
