// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_MovieFile_h
#define Explore_MovieFile_h

#include "vtkImageData.h"
#include "vtkSmartPointer.h"

#include <memory>
#include <string>

namespace Explore
{
/// Writes a movie to an Ogg Theora file (.ogv) on a separate thread. The owner adds pictures
/// without waiting; only the destructor waits until the file is complete.
class MovieFile
{
public:
  virtual ~MovieFile() = default;

  /// Number of pictures per second.
  static constexpr int RATE = 20;

  /// Returns whether this program can write movies.
  static bool IsAvailable();

  /// Opens a file. Returns null, with the reason, if it can't be written.
  static std::unique_ptr<MovieFile> Open(const std::string& file, std::string& error);

  /// Adds a picture that is shown for count / RATE seconds. Returns false if the thread is too
  /// slow: the picture is then dropped, and the next one must have a larger count. All pictures
  /// must have the same size.
  virtual bool Add(vtkImageData* picture, int count) = 0;

  /// Ends the movie. The thread writes the remaining pictures, and then ends.
  virtual void End() = 0;

  enum class State
  {
    Writing,
    Written,
    Empty, // ended without pictures, so there is no file
    Failed
  };
  virtual State GetState() const = 0;
};
} // namespace Explore

#endif
