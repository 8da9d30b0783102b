// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_DicomProcess_h
#define Explore_DicomProcess_h

#include "VTK/Reading/Dicom/DicomMessage.h"

#include <string>

namespace Explore
{
/// Returns whether a file has the DICOM prefix behind its preamble.
bool HasDicomMark(const std::string& path);

/// Sends a request about a file to volumehaptics-dicom, a separate process that reads DICOM with
/// GDCM. Starts the process if necessary. `bytes` receives the data that follow the answer. Returns
/// false if the file can't be read; the process may then have ended, and the next call starts a new
/// one. If the program is missing, or on Windows, throws an InputError for a file with the DICOM
/// prefix.
bool AskDicom(DicomRequest::Kind what, const std::string& path, std::uint64_t mostBytes,
  DicomAnswer& answer, std::string& bytes);
} // namespace Explore

#endif
