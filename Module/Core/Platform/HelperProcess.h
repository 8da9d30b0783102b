// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A program of this project that works for this process, in a process of its own, such as one that
 * reads files.
 */
#ifndef HelperProcess_h
#define HelperProcess_h

#if !defined(_WIN32)
#include <string>

#include <sys/types.h>

namespace VolumeHaptics
{

/**
 * The process, and the socket to it, which is its standard input. It gets no output, none of the
 * signals of this process, and of its files only those that are not closed on exec.
 */
class HelperProcess
{
public:
  HelperProcess() = default;
  ~HelperProcess() { this->End(); }
  HelperProcess(const HelperProcess&) = delete;
  HelperProcess& operator=(const HelperProcess&) = delete;

  /**
   * Starts a program, with an argument, if it does not run. It is looked for near the library that
   * has a function at `code`. Returns false on failure; `obstacle` receives the reason if the
   * program was found but may not be run.
   */
  bool Start(const char* program, const void* code, std::string& obstacle,
    const std::string& argument = std::string());
  /** Ends the process. */
  void End();
  /** Returns the socket. */
  int GetLink() const { return this->Link; }

private:
  pid_t Owner = -1; ///< process that has started it
  pid_t Process = -1;
  int Link = -1;
};

} // namespace VolumeHaptics
#endif

#endif
