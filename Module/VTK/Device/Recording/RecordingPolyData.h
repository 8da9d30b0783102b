// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Writes the .vtp of a recording block by block; vtkXMLPolyDataWriter would need the whole
 * recording in memory.
 */
#ifndef RecordingPolyData_h
#define RecordingPolyData_h

namespace VolumeHaptics
{

class FileReplacement;
class JournalReader;

/** Writes the file. False if the journal can't be read to its end. */
bool WriteRecordingPolyData(JournalReader& journal, FileReplacement& file);

} // namespace VolumeHaptics

#endif
