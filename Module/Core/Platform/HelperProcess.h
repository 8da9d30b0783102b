// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Runs one of the project's programs in a separate process that works for this one, for example to
 * read files.
 */
#ifndef HelperProcess_h
#define HelperProcess_h

#if !defined(_WIN32)
#include <string>

#include <sys/types.h>

namespace VolumeHaptics
{

/**
 * A helper process, and the socket that connects it. The socket is the helper's standard input. The
 * helper has no output and receives no signals of this process. Of this process's files, it gets
 * only those that stay open on exec.
 */
class HelperProcess
{
public:
  HelperProcess() = default;
  ~HelperProcess() { this->End(); }
  HelperProcess(const HelperProcess&) = delete;
  HelperProcess& operator=(const HelperProcess&) = delete;

  /**
   * Starts a program, with an argument, unless it runs already. Looks for the program near the
   * library that contains the function at `code`. Returns false on failure; if the program was
   * found but may not be run, `obstacle` receives the reason.
   */
  bool Start(const char* program, const void* code, std::string& obstacle,
    const std::string& argument = std::string());
  void End();
  int GetLink() const { return this->Link; }

private:
  pid_t Owner = -1; ///< process that has started the helper
  pid_t Process = -1;
  int Link = -1;
};

} // namespace VolumeHaptics
#endif

#endif
