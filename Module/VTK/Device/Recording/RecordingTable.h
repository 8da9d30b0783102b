// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Writes the .csv of a recording, with a line for each tick, and the .csv.json with its field
 * arrays.
 */
#ifndef RecordingTable_h
#define RecordingTable_h

namespace VolumeHaptics
{

class FileReplacement;
class JournalReader;

///@{
/** Writes the files. False if the journal can't be read to its end. */
bool WriteRecordingTable(JournalReader& journal, FileReplacement& file);
bool WriteRecordingFields(JournalReader& journal, FileReplacement& file);
///@}

} // namespace VolumeHaptics

#endif
