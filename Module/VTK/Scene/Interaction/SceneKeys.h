// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Handles the keys for the parts of a scene: display, editor, modes and moving volume.
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
struct KeyedParts;
class SceneFrames;
class ToolTurn;
class TouchMode;

/**
 * Handles the keys of the head-up display (see vtkInteractorStyleHaptic), and shows its hints for
 * new users.
 */
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

  /**
   * Performs the action of a key. Returns false if the key is not for the display, or without a
   * display.
   */
  bool Press(const std::string& key);
  void HideKeys();
  /** Returns the list of keys for the current scene. */
  std::string ListKeys() const;
  /** Returns which of the parts with keys the scene has. */
  KeyedParts FindParts() const;
  /** Shows hints on the next step for the user, until something is touched. */
  void UpdateHint();

  /** List of the application's keys, shown after those of the style. */
  std::string ApplicationKeys;

private:
  std::string ChooseHint();
  /**
   * Returns a line with the label of an action's key between two texts; empty if the action has no
   * key.
   */
  std::string DescribeKey(const char* before, const char* defaultKey, const char* after) const;

  TouchedScene& Scene;
  const TouchMode& Touch;
  const ToolTurn& Turn;
  const KeyMap& Keys;
  bool WasTouching = false; ///< whether something was touched at the last UpdateHint()
  bool HasTouched = false;  ///< whether something was touched since the touch mode or arming began
  std::string Shown;        ///< last hint shown
};

/**
 * Handles the keys of the function editor (see vtkInteractorStyleHaptic), and its search for
 * functions.
 */
class EditorKeys
{
public:
  EditorKeys(TouchedScene& scene, SceneFrames& frames)
    : Scene(scene)
    , Frames(frames)
  {
  }

  /**
   * Performs the action of a key. Returns false if the key is not for the editor, or without an
   * editor. With `isPressed`, undo and redo apply to the editor only if the pointer is over it.
   */
  bool Press(const std::string& key, bool isPressed);
  /** Reports the result of the search for functions. Call this in each update. */
  void PollProposal();

private:
  /** Shows a notice unless the action did anything. */
  void Report(bool isDone, const char* notice);
  /** Starts the search for a proposal, or accepts a proposal that is shown. */
  void Propose();
  /** Ends the search, and replaces its notice with another one; null for none. */
  void EndProposing(const char* notice);
  /**
   * Shows the labels in the editor and selects the touched one, or hides the editor if it already
   * shows the labels.
   */
  void ToggleLabels();

  TouchedScene& Scene;
  SceneFrames& Frames;
  bool IsProposing = false;
  vtkWeakPointer<vtkHapticFunctionEditor> ProposingEditor;
};

/** Chooses which modes of PRIMITIVES are active, with a key and with clicks on their list. */
class ModeKeys
{
public:
  explicit ModeKeys(TouchedScene& scene)
    : Scene(scene)
  {
  }

  /**
   * Makes the next mode the only active one. After the last mode, activates all modes, unless they
   * are too many for a tick. Returns false if the method is not PRIMITIVES.
   */
  bool Next();
  /**
   * Toggles the mode at a position in the head-up display's list. Returns false if there is no
   * mode.
   */
  bool Click(int x, int y);

private:
  vtkVolumeHapticsFilter* GetFilter() const;
  /**
   * Sets which modes are active. If they can't be felt, restores the previous choice and shows a
   * notice.
   */
  void Set(vtkVolumeHapticsFilter* filter, const std::vector<bool>& active);

  TouchedScene& Scene;
};

/** Handles the keys for a moving volume: see vtkInteractorStyleHaptic. */
class PlaybackKeys
{
public:
  explicit PlaybackKeys(TouchedScene& scene)
    : Scene(scene)
  {
  }

  /**
   * Performs the action of a key. Returns false if the key is not for playback, or if no volume
   * moves.
   */
  bool Press(const std::string& key);

private:
  TouchedScene& Scene;
};

} // namespace VolumeHaptics

#endif
