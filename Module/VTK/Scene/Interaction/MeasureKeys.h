// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Handles the keys for measuring where the hand touches: see vtkInteractorStyleHaptic.
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
   * Performs the action of a key. Returns false if the key is not for measuring, or without a list
   * of measurements.
   */
  bool Press(const std::string& key);
  /** Adds the states of an update to a path or area in progress. */
  void Update(vtkTable* states);
  /** Completes a path or an area, and discards the points of an incomplete distance or angle. */
  void End();

private:
  /** Measures a point, or sets the next point of a distance or an angle. */
  void SetPoint(MeasuredKind kind);
  void Undo();
  void BeginOrEnd(MeasuredKind kind);
  /** Adds the completed measurement to the list. */
  void Finish();
  /**
   * Makes a brush for the touched surface. Returns null without a 3D image that has point scalars.
   */
  std::unique_ptr<PaintedPatch> MakeBrush(const Vector3& proxy, double surfaceValue);
  void PaintTo(const Vector3& proxy, double surfaceValue);
  /** Passes the measurement in progress to displays. */
  void Show();
  void Report(const std::string& notice);

  TouchedScene& Scene;
  SceneFrames& Frames;
  Measurement Begun;        ///< measurement in progress, without an area's points, which are in
                            ///< Brush
  bool IsFollowing = false; ///< whether a path or an area is in progress
  std::unique_ptr<PaintedPatch> Brush;
  Vector3 Painted; ///< last position of the brush (world)
  double BrushStep = 0.0;
  /** Next time at which to cut out the growing area for displays. */
  std::chrono::steady_clock::time_point NextCut;
  std::string Told;
};

} // namespace VolumeHaptics

#endif
