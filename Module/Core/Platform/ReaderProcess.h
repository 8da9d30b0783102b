// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Reads files in a separate process, for libraries that do not check files well. The process has
 * limits of memory and time. If such a library crashes, neither the window nor the servo is
 * affected.
 *
 * The process runs the program volumehaptics-read, which loads the library that asks, and reads
 * each file in a forked copy of itself. It does not exist on Windows, nor if the library is linked
 * into a program. Files are then read in the asking process.
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
 * Answers requests that arrive through a socket. The asking library defines this function, and the
 * program volumehaptics-read calls it.
 */
extern "C" VOLUME_HAPTICS_SERVES void vtkHapticServeReading(int link);

namespace VolumeHaptics
{

/** Kinds of requests. Only the caller knows the layout of an answer. */
enum class ReadTask : std::uint32_t
{
  Grid,    ///< a grid, resampled to an image
  VtkHdf,  ///< where the samples are in a VTKHDF file
  Surface, ///< a mesh
  Case,    ///< a grid, from files that the given file names, wherever they are
  Tiff,    ///< the pages in a TIFF file or a folder of TIFF files
  TiffBox, ///< samples of TIFF pages
};

enum class ReadResult : std::uint8_t
{
  Answered,
  Ended, ///< the file made the process crash, or use more memory or time than allowed: see `answer`
  NoProcess ///< there is no such process: read the file in the calling process
};

/**
 * Asks the process to read a file, or the part of the file that `detail` describes. Starts the
 * process unless it runs already. If it must not be started because another user could have written
 * its program, `answer` receives a note for the user. If the process ended, `answer` receives the
 * reason. `unpacked` is the number of bytes to which the file may unpack, if the caller knows it.
 */
ReadResult AskReader(ReadTask task, const std::string& path, std::string& answer,
  const std::string& detail = std::string(), std::uint64_t unpacked = 0);

/** Reads a file and returns the answer, or throws. */
using ReadAnswer = std::string(ReadTask task, const std::string& path, const std::string& detail);

/** Implements vtkHapticServeReading(): answers requests until the other side closes the socket. */
void ServeReading(int link, ReadAnswer* read);

} // namespace VolumeHaptics

#endif
