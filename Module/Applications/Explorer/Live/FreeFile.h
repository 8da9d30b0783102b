// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_FreeFile_h
#define Explore_FreeFile_h

#include <string>

namespace Explore
{
/// Returns the name of a numbered file or folder, such as name-001.png.
std::string NumberFile(const std::string& name, int number, const std::string& ending);

/// Returns the first name of name-001.png, name-002.png and so on that does not exist yet.
std::string FindFreeFile(const std::string& name, const std::string& ending);

/// Like FindFreeFile(), but returns the full path.
std::string FindFreePath(const std::string& name, const std::string& ending);

/// Returns the folder in which programs store state between runs, $XDG_STATE_HOME or
/// ~/.local/state; empty if the user has no such folder.
std::string FindStateFolder();
} // namespace Explore

#endif
