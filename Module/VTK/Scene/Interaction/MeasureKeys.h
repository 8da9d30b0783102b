// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The keys that measure where the hand touches: see vtkInteractorStyleHaptic.
 */
#ifndef MeasureKeys_h
#define MeasureKeys_h

#include "Core/Math/Vector3.h"
#include "VTK/Measure/Measurement.h"
#include "VTK/Measure/PaintedPatch.h"
#include "VTK/Scene/Interaction/TouchedScene.h"

#include <chrono>
#include <memory>
#include <string>

class vtkTable;

namespace VolumeHaptics
{

class SceneFrames;

class MeasureKeys
{
public:
  MeasureKeys(TouchedScene& scene, SceneFrames& frames)
    : Scene(scene)
    , Frames(frames)
  {
  }

  /** False if it is none of them, or there is no list of measurements. */
  bool Press(const std::string& key);
  /** Takes the states of an update into the path, or under the brush. */
  void Follow(vtkTable* states);
  /** Ends a path or an area, and discards the points of an incomplete distance or angle. */
  void End();

private:
  /** A point, or the next one of a distance or angle. */
  void SetPoint(MeasuredKind kind);
  void Undo();
  void BeginOrEnd(MeasuredKind kind);
  /** Adds what was begun to the list. */
  void Finish();
  /** The brush on the touched surface; null without a 3D image that has point scalars. */
  std::unique_ptr<PaintedPatch> MakeBrush(const Vector3& proxy, double surfaceValue);
  void PaintTo(const Vector3& proxy, double surfaceValue);
  /** Lets displays show what was begun. */
  void Show();
  void Tell(const std::string& notice);

  TouchedScene& Scene;
  SceneFrames& Frames;
  Measurement Begun;        ///< without points for an area
  bool IsFollowing = false; ///< a path or an area is under way
  std::unique_ptr<PaintedPatch> Brush;
  Vector3 Painted; ///< the last position of the brush
  double BrushStep = 0.0;
  std::chrono::steady_clock::time_point NextCut; ///< of the area for displays
  std::string Told;
};

} // namespace VolumeHaptics

#endif
