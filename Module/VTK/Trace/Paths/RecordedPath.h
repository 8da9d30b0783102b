// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Reads a recording for the offline filter, which replays it tick by tick.
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
  std::vector<Vector3> Tips; ///< tip of each tick in device space (m)
  std::vector<double> Times; ///< time of each tick (s)
  std::vector<Affine3> Placements;
  std::vector<int> PlacementOf;  ///< index of the placement for each tick
  std::vector<bool> Enabled;     ///< whether the tick enabled the servo
  std::vector<bool> Renewed;     ///< whether a new local surface arrived in the tick
  std::vector<double> DataTimes; ///< data time of each tick; empty if the volume did not move
  /// Orientation of the stylus in each tick, in device space, or NoOrientation; empty if no tick
  /// has one.
  std::vector<Quaternion> Orientations;
  std::vector<bool> Spinning; ///< for each tick, whether a burr was spinning; empty if none was
  /** Request about removed tissue in each tick; empty if there were none. */
  std::vector<RemovalRequest> Requests;
  ServoState InitialState;
  ///@{
  /**
   * The tissue that was already removed at the beginning, and the value of a sample without tissue
   * (NaN if none could be removed). Both complete InitialState.
   */
  std::vector<BrickTissue> InitialTissue;
  double AirValue = std::numeric_limits<double>::quiet_NaN();
  ///@}
  ///@{
  /** Contacts of a tool with a shape at the beginning. They complete InitialState. */
  std::vector<ShellContact> InitialContacts;
  double ContactFraction = 1.0; ///< fraction of the contacts' energies that counts
  ///@}
  double TickPeriod = 0.0;     ///< period of the recorded servo (s)
  std::vector<ForceCaps> Caps; ///< force caps of the recorded device, for each placement
};

/**
 * Reads the tip path of a recording. The recording may have been changed since it was written, so
 * every number is checked: the servo's tick only gets numbers that a tick could have computed.
 */
class RecordedPathReader
{
public:
  RecordedPathReader(vtkPolyData* path, RecordedPath& result);

  /**
   * Reads the recording. Returns the first fault, as the end of a sentence; empty if there is none.
   */
  std::string Read();

private:
  /**
   * Return an array with the required shape. If it is missing or has another shape, record this as
   * a fault and return null.
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
