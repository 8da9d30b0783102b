// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A recording in the form in which the offline filter replays it, tick by tick.
 */
#ifndef RecordedPath_h
#define RecordedPath_h

#include "Core/Servo/ServoTick.h"
#include "Core/Tools/PointShell/ShellContacts.h"

#include "vtkType.h"

#include <limits>
#include <string>
#include <vector>

class vtkDataArray;
class vtkFieldData;
class vtkPolyData;

namespace VolumeHaptics
{

struct RecordedPath
{
  std::vector<Vector3> Tips; ///< tips in device space
  std::vector<double> Times; ///< time of every tick (s)
  std::vector<Affine3> Placements;
  std::vector<int> PlacementOf;  ///< number of the placement, for each tick
  std::vector<bool> Enabled;     ///< whether the tick enabled the servo
  std::vector<bool> Renewed;     ///< whether a new local surface arrived in the tick
  std::vector<double> DataTimes; ///< data time of each tick; empty if the volume did not move
  /// orientation of the stylus in each tick, in device space; NoOrientation for a tick without one;
  /// empty if no tick has one
  std::vector<Quaternion> Orientations;
  std::vector<bool> Spinning; ///< whether a burr spun, for each tick; empty if none ever spun
  /** request of each tick about removed tissue; empty if there was none */
  std::vector<RemovalRequest> Requests;
  ServoState InitialState;
  ///@{
  /**
   * The tissue that was removed at the beginning, and the value of a sample without tissue; NaN if
   * none could be removed. Both belong to InitialState.
   */
  std::vector<BrickTissue> InitialTissue;
  double AirValue = std::numeric_limits<double>::quiet_NaN();
  ///@}
  ///@{
  /** Contacts of a tool with a shape at the beginning. They belong to InitialState. */
  std::vector<ShellContact> InitialContacts;
  double ContactFraction = 1.0; ///< fraction of the contacts' energies that counts
  ///@}
  double TickPeriod = 0.0;     ///< period of the recorded servo (s)
  std::vector<ForceCaps> Caps; ///< caps of the recorded device, for each placement
};

/**
 * Reads the tip path of a recording. The recording may have been changed since it was written, so
 * every number is checked: the servo's tick gets only numbers that it could have computed itself.
 */
class RecordedPathReader
{
public:
  RecordedPathReader(vtkPolyData* path, RecordedPath& result);

  /**
   * Reads the recording. Returns the first fault as the end of a sentence, or an empty text if
   * there is none.
   */
  std::string Read();

private:
  /**
   * Return an array of this shape. If it is missing or has another shape, record that and return
   * null.
   */
  vtkDataArray* Find(
    vtkFieldData* data, const char* kind, const char* name, int components, vtkIdType tuples);
  vtkDataArray* FindOfTicks(const char* name, int components);
  vtkDataArray* FindField(const char* name, int components, vtkIdType tuples);
  void Require(bool holds, const char* array, vtkIdType tuple, const char* wanted);
  void ReadPlacements();
  void ReadCaps();
  void ReadBegin();
  void ReadTicks();
  void ReadOrientations();
  void ReadContacts();
  void ReadRemoval();

  vtkPolyData* const Path;
  RecordedPath& Result;
  const vtkIdType Ticks;
  std::string Flaw;
};

} // namespace VolumeHaptics

#endif
