// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_DicomProcess_h
#define Explore_DicomProcess_h

#include "VTK/Reading/Dicom/DicomMessage.h"

#include <string>

namespace Explore
{
/// Returns whether a file has the mark of DICOM, behind its preamble.
bool HasDicomMark(const std::string& path);

/// Asks volumehaptics-dicom, which reads DICOM by GDCM in a process of its own, about a file.
/// Starts the process if it does not run. Returns false if the file can't be read: then the process
/// may have ended, and the next call starts a new one. `bytes` receives what follows the answer. If
/// the program is missing, or on Windows, throws an InputError for a file with the mark of DICOM.
bool AskDicom(DicomRequest::Kind what, const std::string& path, std::uint64_t mostBytes,
  DicomAnswer& answer, std::string& bytes);
} // namespace Explore

#endif
