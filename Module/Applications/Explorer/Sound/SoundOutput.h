// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_SoundOutput_h
#define Explore_SoundOutput_h

#include <memory>
#include <string>

namespace Explore
{
class SoundStream;

/// Plays a stream on the computer's loudspeakers until the object is deleted, on a thread of its
/// own. A program that was built without a sound library has a substitute that plays nothing.
///
/// The library is PulseAudio's libpulse: PulseAudio and PipeWire both serve it, so that it reaches
/// every desktop of Debian 12 and needs only one small package. Its asynchronous functions never
/// wait for a server, which may hang, and report when the server has gone. SDL2 and PortAudio
/// support other systems as well, but the project is not built for these; on Linux, they call such
/// a library in turn.
class SoundOutput
{
public:
  virtual ~SoundOutput() = default;
  SoundOutput(const SoundOutput&) = delete;
  SoundOutput& operator=(const SoundOutput&) = delete;

  /// Returns whether the program was built with the library.
  static bool IsAvailable();
  /// Returns at once, and connects to the server in the background. The stream must outlive the
  /// output.
  static std::unique_ptr<SoundOutput> Open(SoundStream& stream);

  /// Returns the reason why nothing is played, in one line, once for each fault; empty if there is
  /// none.
  virtual std::string DrainTrouble() = 0;

protected:
  SoundOutput() = default;
};
} // namespace Explore

#endif
