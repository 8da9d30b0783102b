// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Reads the tip path of a recording, which may have been changed since it was written.
 */
#ifndef RecordedPathReader_h
#define RecordedPathReader_h

#include "VTK/Trace/Paths/RecordedPath.h"

#include "vtkType.h"

#include <string>

class vtkDataArray;
class vtkFieldData;
class vtkPolyData;

namespace VolumeHaptics
{

/**
 * Reads a recording and checks every number: the servo's tick gets only numbers that it could have
 * computed itself.
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
   * Returns an array of this shape. If it is missing or has another shape, stores a fault and
   * returns null.
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
