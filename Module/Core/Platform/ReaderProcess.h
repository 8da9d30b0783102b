// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Reads files, in a separate process, with libraries that do not check them. The process has limits
 * of memory and time. If such a library ends it, neither the window nor the servo notices.
 *
 * The process is the program volumehaptics-read, which loads the library that asks, and reads each
 * file in a copy of itself. There is none on Windows, nor if that library is linked into a program
 * as a whole: then files are read in the asking process.
 */
#ifndef ReaderProcess_h
#define ReaderProcess_h

#include <cstdint>
#include <string>

#if defined(_WIN32)
#define VOLUME_HAPTICS_SERVES
#else
#define VOLUME_HAPTICS_SERVES __attribute__((visibility("default")))
#endif

/**
 * Answers requests that come through a socket. The library that asks defines this function, and the
 * program volumehaptics-read calls it.
 */
extern "C" VOLUME_HAPTICS_SERVES void vtkHapticServeReading(int link);

namespace VolumeHaptics
{

/** Kinds of requests. The caller knows the layout of each answer. */
enum class ReadTask : std::uint32_t
{
  Grid,    ///< a grid, resampled to an image
  VtkHdf,  ///< where the samples are in a VTKHDF file
  Surface, ///< a mesh
  Case,    ///< a grid, from files that this file names, wherever they are
  Tiff,    ///< the pages in a TIFF file or a folder of TIFF files
  TiffBox, ///< samples of TIFF pages
};

enum class ReadResult : std::uint8_t
{
  Answered,
  Ended, ///< the file has ended the process, or taken more memory or time than it may: see `answer`
  NoProcess ///< there is no such process: read the file in this one
};

/**
 * Asks the process to read a file, or the part of it that `detail` describes. Starts the process if
 * it does not run. If there is none because another user could have written its program, `answer`
 * receives a note of that for the user; if the process ended, it says why. `unpacked` is the number
 * of bytes that the file may unpack to, if the asker knows it.
 */
ReadResult AskReader(ReadTask task, const std::string& path, std::string& answer,
  const std::string& detail = std::string(), std::uint64_t unpacked = 0);

/** Returns the answer, or throws. */
using ReadAnswer = std::string(ReadTask task, const std::string& path, const std::string& detail);

/** The work of vtkHapticServeReading(): answers until the other side closes the socket. */
void ServeReading(int link, ReadAnswer* read);

} // namespace VolumeHaptics

#endif
