// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The paths in a polydata. If they are several, each is resampled when it is felt.
 */
#ifndef TipPaths_h
#define TipPaths_h

#include "VTK/Trace/HapticTipPath.h"
#include "VTK/Trace/TipPathLines.h"

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <cstddef>
#include <string>
#include <vector>

class vtkPoints;
class vtkPolyData;

namespace VolumeHaptics
{

/**
 * TipPathLines.h says which lines are paths. Without a point array `Time` every point is a tick.
 * With it, a path is resampled linearly to one tick every `period` seconds, starting at its first
 * time. If points have the same time, the last counts; a point whose time is a tick's is taken
 * unchanged, to the bit. A recording of vtkHapticDevice is one path, taken tick by tick, in device
 * space.
 */
class TipPaths
{
public:
  /**
   * Reads what all paths have in common. False, with an error, for numbers that are not finite,
   * time that runs backwards, incomplete recordings, a line that does not follow the order of the
   * points, or more ticks than fit into memory.
   */
  bool Read(vtkPolyData* path, double period, std::string& error);

  std::size_t GetNumberOfPaths() const { return this->FirstTicks.size() - 1; }
  /** Of all paths. */
  vtkIdType GetNumberOfTicks() const { return this->FirstTicks.back(); }
  /** The number of ticks of the paths before this one. */
  vtkIdType GetFirstTick(std::size_t path) const { return this->FirstTicks[path]; }
  vtkIdType GetNumberOfTicks(std::size_t path) const
  {
    return this->FirstTicks[path + 1] - this->FirstTicks[path];
  }
  /** Whether each path has a line of its own, whatever its length. */
  bool AreSeveral() const { return !this->Divided.Begins.empty(); }
  /** The path if it is one, which may be a recording; null if they are several. */
  const TipPath* GetOnly() const { return this->AreSeveral() ? nullptr : &this->Only; }

  /** One of several paths; may be called by several threads at once. Throws std::bad_alloc. */
  TipPath Get(std::size_t path) const;

private:
  /** The points of a path are At(0) to At(GetSize() - 1) in the polydata. */
  class Members
  {
  public:
    Members(const TipPaths& paths, std::size_t path);
    vtkIdType GetSize() const { return this->Size; }
    vtkIdType At(vtkIdType i) const { return this->Ids ? this->Ids[i] : i; }

  private:
    const vtkIdType* Ids = nullptr; ///< null if they are all, in order
    vtkIdType Size;
  };

  bool CheckPoints(std::string& error) const;
  bool DivideLines(vtkPolyData* path, std::string& error);
  bool ReadTimes(vtkPolyData* path, std::string& error);
  bool CheckTimes(std::size_t path, std::string& error) const;
  bool CountTicks(std::string& error);
  Vector3 GetPoint(vtkIdType point) const;
  void Resample(const Members& members, vtkIdType ticks, TipPath& result) const;

  vtkSmartPointer<vtkPoints> Points;
  const double* Doubles = nullptr;           ///< of the points, if they are such
  const float* Floats = nullptr;             ///< of the points, if they are such
  std::vector<double> Times;                 ///< s, of each point; empty if each is a tick
  double Period = 0.0;                       ///< s
  DividedPoints Divided;                     ///< empty if all points are one path, in order
  std::vector<vtkIdType> FirstTicks = { 0 }; ///< of each path; then the number of all
  TipPath Only;
};

/** The error for so many ticks that they and their trace do not fit into memory. */
std::string DescribeLackOfMemory(double ticks);

} // namespace VolumeHaptics

#endif
