// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_SoundOutput_h
#define Explore_SoundOutput_h

#include <memory>
#include <string>

namespace Explore
{
class SoundStream;

/// Plays a stream on the computer's loudspeakers, on its own thread, until the object is deleted. A
/// program built without a sound library gets a substitute that plays nothing.
///
/// The library is PulseAudio's libpulse. It works with PulseAudio and PipeWire, and thus on every
/// desktop of Debian 12, and needs only one small package. Its asynchronous functions never wait
/// for a server, which may hang, and report when the server has gone. SDL2 and PortAudio also
/// support other systems, but the project is not built for them; on Linux, they use such a library
/// themselves.
class SoundOutput
{
public:
  virtual ~SoundOutput() = default;
  SoundOutput(const SoundOutput&) = delete;
  SoundOutput& operator=(const SoundOutput&) = delete;

  /// Returns whether the program was built with the library.
  static bool IsAvailable();
  /// Returns at once; the connection to the server is made in the background. The stream must
  /// outlive the output.
  static std::unique_ptr<SoundOutput> Open(SoundStream& stream);

  /// Returns the reason why nothing is played, in one line. Each fault is returned only once; empty
  /// if there is no new one.
  virtual std::string DrainTrouble() = 0;

protected:
  SoundOutput() = default;
};
} // namespace Explore

#endif
