// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * JSON files that state their format and its version.
 */
#ifndef SetupFile_h
#define SetupFile_h

#include "VTK/Base/JsonText.h"

#include <string>

namespace VolumeHaptics
{

struct SetupFileKind
{
  const char* Format; ///< the value of the key "Format"
  int Version;        ///< version that is written; this and earlier ones are read
  const char* Noun;   ///< such as "setup"
  const char* Cure;   ///< where such files come from: "that vtkHapticSetup saved"
  const char* Again;  ///< what else helps: "save the setup again"
};

/** Begins a file of a kind. */
Json::Value NewSetupFile(const SetupFileKind& kind);

/** Parses a file. False, with the fault and the cure, if the text is no file of the kind. */
bool ParseSetupFile(
  const std::string& text, const SetupFileKind& kind, Json::Value& root, std::string& error);

} // namespace VolumeHaptics

#endif
