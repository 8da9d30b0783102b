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

  /** Carries out a key. False for a key of other parts, and without a list of measurements. */
  bool Press(const std::string& key);
  /** Adds an update's states to the path, or to the brushed area. */
  void Update(vtkTable* states);
  /** Ends a path or an area, and discards the points of an incomplete distance or angle. */
  void End();

private:
  /** Adds a point, or the next point of a distance or angle. */
  void SetPoint(MeasuredKind kind);
  void Undo();
  void BeginOrEnd(MeasuredKind kind);
  /** Adds the measurement in progress to the list. */
  void Finish();
  /** Makes the brush on the touched surface; null without a 3D image that has point scalars. */
  std::unique_ptr<PaintedPatch> MakeBrush(const Vector3& proxy, double surfaceValue);
  void PaintTo(const Vector3& proxy, double surfaceValue);
  /** Shows the measurement in progress in displays. */
  void Show();
  void Report(const std::string& notice);

  TouchedScene& Scene;
  SceneFrames& Frames;
  Measurement Begun;        ///< measurement in progress; an area has no points here
  bool IsFollowing = false; ///< whether a path or an area is under way
  std::unique_ptr<PaintedPatch> Brush;
  Vector3 Painted; ///< last position of the brush
  double BrushStep = 0.0;
  std::chrono::steady_clock::time_point NextCut; ///< next cut of the growing area for displays
  std::string Told;
};

} // namespace VolumeHaptics

#endif
