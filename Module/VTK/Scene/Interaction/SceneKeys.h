// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Handles the keys of a scene's parts: display, editor, modes and moving volume.
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
   * Executes the action of a key. Returns false if the display has no action for the key, or if
   * there is no display.
   */
  bool Press(const std::string& key);
  void HideKeys();
  /** Returns the list of keys for the current scene. */
  std::string ListKeys() const;
  /** Returns which parts with keys the scene has. */
  KeyedParts FindParts() const;
  /** Shows hints on the user's next step, until something is touched. */
  void UpdateHint();

  /** keys of the application, which are listed after the keys of the style */
  std::string ApplicationKeys;

private:
  std::string ChooseHint();
  /**
   * Returns a line with the name of an action's key between two texts; empty if the action has no
   * key.
   */
  std::string DescribeKey(const char* before, const char* defaultKey, const char* after) const;

  TouchedScene& Scene;
  const TouchMode& Touch;
  const ToolTurn& Turn;
  const KeyMap& Keys;
  bool WasTouching = false; ///< whether something was touched at the last call of UpdateHint
  bool HasTouched = false;  ///< whether something was touched since touch mode or arming began
  std::string Shown;        ///< the last hint that was shown
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
   * Executes the action of a key. Returns false if the editor has no action for the key, or if
   * there is no editor. If a key was pressed, undo and redo are the editor's under the pointer.
   */
  bool Press(const std::string& key, bool isPressed);
  /** Reports the end of the search for functions. Call this in each update. */
  void PollProposal();

private:
  /** Shows a notice if an action did nothing. */
  void Report(bool isDone, const char* notice);
  /** Starts the search for a proposal in the editor, or accepts the proposal that is shown. */
  void Propose();
  /** Ends the search, and replaces its notice by another notice; null for none. */
  void EndProposing(const char* notice);
  /**
   * Shows the labels in the editor and selects the touched label, or hides the editor if it shows
   * the labels.
   */
  void ToggleLabels();

  TouchedScene& Scene;
  SceneFrames& Frames;
  bool IsProposing = false;
  vtkWeakPointer<vtkHapticFunctionEditor> ProposingEditor;
};

/** Chooses which modes of PRIMITIVES are active, by a key and by clicks on their list. */
class ModeKeys
{
public:
  explicit ModeKeys(TouchedScene& scene)
    : Scene(scene)
  {
  }

  /**
   * Makes the next mode the only active one; after the last mode, makes all modes active, unless
   * they are too many for a tick. Returns false if the method is not PRIMITIVES.
   */
  bool Next();
  /**
   * Switches the mode at a position in the head-up display's list on or off. Returns false if there
   * is no mode.
   */
  bool Click(int x, int y);

private:
  vtkVolumeHapticsFilter* GetFilter() const;
  /** Sets which modes are active. If they can't be felt, undoes the changes and shows a notice. */
  void Set(vtkVolumeHapticsFilter* filter, const std::vector<bool>& active);

  TouchedScene& Scene;
};

/** Handles the keys of a moving volume: see vtkInteractorStyleHaptic. */
class PlaybackKeys
{
public:
  explicit PlaybackKeys(TouchedScene& scene)
    : Scene(scene)
  {
  }

  /**
   * Executes the action of a key. Returns false if playback has no action for the key, or if no
   * volume moves.
   */
  bool Press(const std::string& key);

private:
  TouchedScene& Scene;
};

} // namespace VolumeHaptics

#endif
