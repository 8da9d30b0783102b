// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Writes and reads files of measurements. The ending selects the format: .csv, .vtp, or .json for
 * markups.
 */
#ifndef MeasurementFiles_h
#define MeasurementFiles_h

#include "VTK/Measure/MarkupsJson.h"
#include "VTK/Measure/Measurement.h"

#include <string>
#include <vector>

namespace VolumeHaptics
{

/** Writes the file completely or not at all; false, with the reason and the cure, on failure. */
bool WriteMeasurements(const std::string& file, const std::vector<Measurement>& measurements,
  const MarkupsFrame& frame, std::string& error);

/**
 * Reads a file. False, with the reason and the cure, if it can't be read. The notes say what was
 * left out.
 */
bool ReadMeasurements(const std::string& file, const MarkupsFrame& frame,
  std::vector<Measurement>& measurements, std::string& notes, std::string& error);

} // namespace VolumeHaptics

#endif
