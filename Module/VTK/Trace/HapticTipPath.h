// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The tip path of the offline filter: one position per tick.
 */
#ifndef HapticTipPath_h
#define HapticTipPath_h

#include "Core/Servo/ResidentServo.h"
#include "Core/Servo/ServoTick.h"

#include <memory>
#include <string>
#include <utility>
#include <vector>

class vtkPolyData;

namespace VolumeHaptics
{

/** Names of what a recording carries beyond a trace, so that it can be replayed to the bit. */
namespace RecordingNames
{
constexpr const char* DeviceTip = "DeviceTip"; ///< point array: the tip in device space (m)
constexpr const char* Enabled = "Enabled";     ///< point array: 1 where the tick enabled
constexpr const char* Placement = "Placement"; ///< point array: tuple of DeviceToWorld
constexpr const char* Renewed = "Renewed";     ///< point array: 1 where a local surface came
constexpr const char* DeviceToWorld = "DeviceToWorld"; ///< field array: 16 numbers, row by row
constexpr const char* TickPeriod = "TickPeriod";       ///< field array: s
constexpr const char* Caps = "Caps";                   ///< field array: N/m, N s/m; 0: no cap
constexpr const char* InitialState = "InitialState";   ///< field array: the ServoState
} // namespace RecordingNames

struct TipPath
{
  std::vector<Vector3> Tips; ///< world; in device space for a recording
  double StartTime = 0.0;    ///< s, of the first tick
  std::vector<double> Times; ///< s, of every tick; empty where they are evenly spaced
  bool IsRecording = false;  ///< whether the following hold
  std::vector<Affine3> Placements;
  std::vector<int> PlacementOf; ///< per tick
  std::vector<bool> Enabled;    ///< per tick
  std::vector<bool> Renewed;    ///< per tick
  ServoState InitialState;
  double TickPeriod = 0.0; ///< s, of the servo that recorded
  ForceCaps Caps;          ///< of the device that recorded
};

/**
 * Reads the points of a path in order. Without a point array `Time` every point is a tick; with it,
 * the path is resampled linearly to one tick every `period` seconds from its first time on (of
 * points with the same time, the last counts; a point whose time is a tick's is taken as it is, to
 * the bit). A recording of vtkHapticDevice is taken tick by tick, in device space. False, with an
 * error, for numbers that are not finite, time that runs backwards, recordings that are not whole,
 * several lines, or more ticks than there is memory for.
 */
bool ReadTipPath(vtkPolyData* path, double period, TipPath& result, std::string& error);

/** The error where there is no memory for so many ticks and their trace. */
std::string DescribeLackOfMemory(double ticks);

/**
 * How many strokes of a pen draw the line cells of a path: 1 for a polyline and for segments that
 * continue one another, in whatever order and direction they are stored; 0 without line cells.
 * Points have to be finite.
 */
std::size_t CountLines(vtkPolyData* path);

/**
 * Where the points of the line cells, in the order in which they are stored, go on without a cell
 * that joins them: the last point before such a leap, and the first after it; -1, -1 if there is
 * none. Points at one place need no cell. Points have to be finite.
 */
std::pair<long long, long long> FindLeap(vtkPolyData* path);

/** The part of ReadTipPath for recordings: what is wrong with one, or nothing. */
std::string ReadRecordedPath(vtkPolyData* path, TipPath& result);

/** Walks a path tick by tick. */
class TipPathWalk
{
public:
  TipPathWalk(const TipPath& path, double period);

  /** The next tick, in the model that is returned: the given one, placed as a recording says. */
  std::shared_ptr<const HapticModel> Tick(
    std::shared_ptr<const HapticModel> model, TickRecord& record);
  /** Time of the last tick (s). */
  double GetTime() const;

private:
  void Step(const HapticModel& model, const Vector3& tip, TickRecord& record,
    const LocalSurfaceResult& result);

  const TipPath& Path;
  const double Period;
  std::size_t Next = 0;
  ServoState State;
  ResidentServo Servo;
  TickRecord Whole; ///< of the last tick, with the force before the residency takes its share
};

} // namespace VolumeHaptics

#endif
