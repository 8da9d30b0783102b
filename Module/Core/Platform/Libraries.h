// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Shared libraries that are loaded at run time, and the files of code.
 */
#ifndef Libraries_h
#define Libraries_h

#include <string>

namespace VolumeHaptics
{
namespace Libraries
{

/**
 * Loads a library by its whole path, and the libraries that it needs, also from its own folder.
 * Returns null and writes the loader's text to `error` if this fails. It is never unloaded.
 */
void* Load(const std::string& path, std::string& error);
/** Finds a function of a loaded library. Returns null if there is none of that name. */
void* Find(void* library, const char* name);
/** Returns the path of the library or program that has a function at `code`; empty if not known. */
std::string FindFileOf(const void* code);
/** Returns the path of this process's program. */
std::string FindOwnProgram();

/** The ending of library files, ".so" or ".dll", and the separator of search paths, ':' or ';'. */
#if defined(_WIN32)
constexpr const char* Ending = ".dll";
constexpr char PathSeparator = ';';
#else
constexpr const char* Ending = ".so";
constexpr char PathSeparator = ':';
#endif

} // namespace Libraries
} // namespace VolumeHaptics

#endif
