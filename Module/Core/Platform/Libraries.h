// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Loads shared libraries at run time, and finds the files that contain code.
 */
#ifndef Libraries_h
#define Libraries_h

#include <string>

namespace VolumeHaptics
{
namespace Libraries
{

/**
 * Loads a library by its full path. Also looks in the library's own folder for the libraries that
 * it needs. On failure, returns null and writes the loader's message to `error`. The library is
 * never unloaded.
 */
void* Load(const std::string& path, std::string& error);
/**
 * Returns a function of a loaded library, or null if the library has no function with that name.
 */
void* Find(void* library, const char* name);
/**
 * Returns the path of the library or program that contains the function at `code`, or an empty path
 * if it is not known.
 */
std::string FindFileOf(const void* code);
/** Returns the path of the running program. */
std::string FindOwnProgram();

/** The file name extension of libraries, and the separator of search paths. */
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
