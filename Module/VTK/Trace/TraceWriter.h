// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Writes a trace that is in memory, completely or not at all. A recording, which need not fit into
 * memory, is written from its journal (HapticRecordingFile.h), to files of the same form.
 */
#ifndef TraceWriter_h
#define TraceWriter_h

#include <string>

class vtkPolyData;

namespace VolumeHaptics
{

///@{
/**
 * Write a .vtp with everything, and a .csv with a line for each tick. False, with the reason and
 * the cure, on failure.
 */
bool WriteTracePolyData(vtkPolyData* trace, const std::string& file, std::string& error);
bool WriteTraceTable(vtkPolyData* trace, const std::string& file, std::string& error);
///@}

} // namespace VolumeHaptics

#endif
