// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Handles the keys that measure where the hand touches: see vtkInteractorStyleHaptic.
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

  /**
   * Executes the action of a key. Returns false if the key measures nothing, or if there is no list
   * of measurements.
   */
  bool Press(const std::string& key);
  /** Adds the states of an update to the path or the area in progress. */
  void Update(vtkTable* states);
  /** Ends a path or an area, and discards the points of an incomplete distance or angle. */
  void End();

private:
  /** Adds a point measurement, or sets the next point of a distance or an angle. */
  void SetPoint(MeasuredKind kind);
  void Undo();
  void BeginOrEnd(MeasuredKind kind);
  /** Adds the finished measurement to the list. */
  void Finish();
  /**
   * Makes the brush on the touched surface. Returns null if there is no 3D image with point
   * scalars.
   */
  std::unique_ptr<PaintedPatch> MakeBrush(const Vector3& proxy, double surfaceValue);
  void PaintTo(const Vector3& proxy, double surfaceValue);
  /** Shows the measurement in progress in displays. */
  void Show();
  void Report(const std::string& notice);

  TouchedScene& Scene;
  SceneFrames& Frames;
  Measurement Begun;        ///< the measurement in progress; the points of an area are in Brush
  bool IsFollowing = false; ///< whether a path or an area is in progress
  std::unique_ptr<PaintedPatch> Brush;
  Vector3 Painted; ///< last position of the brush (world)
  double BrushStep = 0.0;
  /** time when the growing area is next cut out for displays */
  std::chrono::steady_clock::time_point NextCut;
  std::string Told;
};

} // namespace VolumeHaptics

#endif
