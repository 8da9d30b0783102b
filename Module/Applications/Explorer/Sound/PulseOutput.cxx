// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/Explorer/Sound/SoundOutput.h"
#include "Applications/Explorer/Sound/SoundStream.h"

#include <pulse/pulseaudio.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <mutex>
#include <thread>
#include <utility>

namespace
{
using Explore::SoundStream;

constexpr std::uint32_t LATENCY = 25; // ms, requested from the server
/// Longest wait for the fade at the end, so that a server that hangs can't delay the program.
constexpr std::chrono::milliseconds FADE(60);

class PulseOutput : public Explore::SoundOutput
{
public:
  explicit PulseOutput(SoundStream& stream);
  ~PulseOutput() override;
  std::string DrainTrouble() override;

private:
  // Called on the thread of the main loop.
  static void HandleContext(pa_context* context, void* self);
  static void HandleStream(pa_stream* stream, void* self);
  static void Write(pa_stream* stream, std::size_t bytes, void* self);
  void Connect();
  void Report(const std::string& what);

  SoundStream& Source;
  pa_threaded_mainloop* Loop;
  pa_context* Context = nullptr;
  pa_stream* Stream = nullptr;
  bool Plays = false; // guarded by the main loop's lock
  std::mutex Mutex;
  std::string Trouble; // guarded by the mutex
};

PulseOutput::PulseOutput(SoundStream& stream)
  : Source(stream)
  , Loop(pa_threaded_mainloop_new())
{
  if (this->Loop)
  {
    this->Context = pa_context_new(pa_threaded_mainloop_get_api(this->Loop), "VTK Volume Haptics");
  }
  if (!this->Context)
  {
    this->Report("the library is out of memory");
    return;
  }
  pa_context_set_state_callback(this->Context, &PulseOutput::HandleContext, this);
  if (pa_context_connect(this->Context, nullptr, PA_CONTEXT_NOFLAGS, nullptr) < 0)
  {
    this->Report(pa_strerror(pa_context_errno(this->Context)));
  }
  else if (pa_threaded_mainloop_start(this->Loop) < 0)
  {
    this->Report("no thread could be started");
  }
}

PulseOutput::~PulseOutput()
{
  if (this->Context)
  {
    pa_threaded_mainloop_lock(this->Loop);
    const bool plays = this->Plays;
    pa_threaded_mainloop_unlock(this->Loop);
    if (plays)
    {
      this->Source.SetMuted(true);
      std::this_thread::sleep_for(FADE);
    }
    pa_threaded_mainloop_stop(this->Loop);
    // The library's thread has ended, so no callback can follow.
    if (this->Stream)
    {
      pa_stream_set_state_callback(this->Stream, nullptr, nullptr);
      pa_stream_set_write_callback(this->Stream, nullptr, nullptr);
      pa_stream_disconnect(this->Stream);
      pa_stream_unref(this->Stream);
    }
    pa_context_set_state_callback(this->Context, nullptr, nullptr);
    pa_context_disconnect(this->Context);
    pa_context_unref(this->Context);
  }
  if (this->Loop)
  {
    pa_threaded_mainloop_free(this->Loop);
  }
}

std::string PulseOutput::DrainTrouble()
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  return std::exchange(this->Trouble, {});
}

void PulseOutput::Report(const std::string& what)
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  if (this->Trouble.empty())
  {
    this->Trouble = what;
  }
}

void PulseOutput::HandleContext(pa_context* context, void* self)
{
  auto* const output = static_cast<PulseOutput*>(self);
  const pa_context_state_t state = pa_context_get_state(context);
  if (state == PA_CONTEXT_READY)
  {
    output->Connect();
  }
  else if (state == PA_CONTEXT_FAILED)
  {
    output->Report(pa_strerror(pa_context_errno(context)));
    output->Plays = false;
  }
}

void PulseOutput::Connect()
{
  pa_sample_spec format;
  format.format = PA_SAMPLE_FLOAT32NE;
  format.rate = static_cast<std::uint32_t>(this->Source.GetSampleRate());
  format.channels = 1;
  this->Stream = pa_stream_new(this->Context, "Touch", &format, nullptr);
  if (!this->Stream)
  {
    this->Report(pa_strerror(pa_context_errno(this->Context)));
    return;
  }
  pa_stream_set_state_callback(this->Stream, &PulseOutput::HandleStream, this);
  pa_stream_set_write_callback(this->Stream, &PulseOutput::Write, this);
  constexpr auto automatic = static_cast<std::uint32_t>(-1);
  pa_buffer_attr buffer{ automatic, automatic, automatic, automatic, automatic };
  buffer.tlength =
    static_cast<std::uint32_t>(pa_usec_to_bytes(LATENCY * PA_USEC_PER_MSEC, &format));
  if (pa_stream_connect_playback(
        this->Stream, nullptr, &buffer, PA_STREAM_ADJUST_LATENCY, nullptr, nullptr) < 0)
  {
    this->Report(pa_strerror(pa_context_errno(this->Context)));
  }
}

void PulseOutput::HandleStream(pa_stream* stream, void* self)
{
  auto* const output = static_cast<PulseOutput*>(self);
  const pa_stream_state_t state = pa_stream_get_state(stream);
  output->Plays = state == PA_STREAM_READY;
  // Report only the context's error if the stream has failed together with its context.
  if (state == PA_STREAM_FAILED && pa_context_get_state(output->Context) == PA_CONTEXT_READY)
  {
    output->Report(pa_strerror(pa_context_errno(output->Context)));
  }
}

void PulseOutput::Write(pa_stream* stream, std::size_t bytes, void* self)
{
  auto* const output = static_cast<PulseOutput*>(self);
  while (bytes >= sizeof(float))
  {
    void* memory = nullptr;
    std::size_t size = bytes;
    if (pa_stream_begin_write(stream, &memory, &size) < 0 || !memory || size < sizeof(float))
    {
      return;
    }
    const std::size_t count = std::min(size, bytes) / sizeof(float);
    output->Source.Render(static_cast<float*>(memory), count);
    const std::size_t written = count * sizeof(float);
    if (pa_stream_write(stream, memory, written, nullptr, 0, PA_SEEK_RELATIVE) < 0)
    {
      return; // HandleStream reports the reason
    }
    bytes -= written;
  }
}
} // namespace

namespace Explore
{
bool SoundOutput::IsAvailable()
{
  return true;
}

std::unique_ptr<SoundOutput> SoundOutput::Open(SoundStream& stream)
{
  return std::make_unique<PulseOutput>(stream);
}
} // namespace Explore
