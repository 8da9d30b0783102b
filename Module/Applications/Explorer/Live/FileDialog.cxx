// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/Explorer/Live/FileDialog.h"

#if !defined(_WIN32)
#include <cerrno>
#include <chrono>
#include <csignal>
#include <thread>
#include <vector>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;
#endif

namespace Explore
{
#if defined(_WIN32)

bool FileDialog::Open(const std::string&)
{
  return false;
}

FileDialog::State FileDialog::Poll(std::string&)
{
  return State::Failed;
}

void FileDialog::Close() {}

#else

namespace
{
/// Starts a program from the PATH, with its output sent to a file descriptor. Returns the process
/// id, or -1.
pid_t StartProgram(std::vector<std::string> words, int output)
{
  std::vector<char*> pointers;
  for (std::string& word : words)
  {
    pointers.push_back(word.data());
  }
  pointers.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawnattr_t attributes;
  sigset_t signals;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, output, STDOUT_FILENO);
  posix_spawnattr_init(&attributes);
  sigemptyset(&signals);
  posix_spawnattr_setsigmask(&attributes, &signals);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK);
  pid_t process = -1;
  const int error =
    posix_spawnp(&process, pointers[0], &actions, &attributes, pointers.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  return error == 0 ? process : -1;
}
} // namespace

bool FileDialog::Open(const std::string& folder)
{
  this->Close();
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0)
  {
    return false;
  }
  this->Pipe = ends[0];
  fcntl(this->Pipe, F_SETFL, O_NONBLOCK);
  this->Process = StartProgram(
    { "zenity", "--file-selection", "--title=Open a volume", "--filename=" + folder + "/" },
    ends[1]);
  if (this->Process < 0)
  {
    this->Process =
      StartProgram({ "kdialog", "--title", "Open a volume", "--getopenfilename", folder }, ends[1]);
  }
  close(ends[1]);
  if (this->Process < 0)
  {
    this->Close();
  }
  this->Begin = this->Seen = Clock::now();
  return this->IsOpen();
}

FileDialog::State FileDialog::Poll(std::string& path)
{
  this->Read();
  int status = 0;
  const pid_t ended = waitpid(this->Process, &status, WNOHANG);
  if (ended == 0 || (ended < 0 && errno == EINTR))
  {
    this->Seen = Clock::now();
    return State::Open;
  }
  this->Process = -1;
  this->Read(); // output from before the program ended
  path = this->Output.substr(0, this->Output.find_last_not_of("\r\n") + 1);
  this->Close();
  const int code = ended > 0 && WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  // The programs exit with 1 if the user cancels, but also if they can't open a window. In the
  // latter case they end sooner than any user cancels.
  constexpr std::chrono::milliseconds soon(500);
  const bool isCancelled = code == 1 && this->Seen - this->Begin > soon;
  return code == 0 && !path.empty() ? State::Chosen
    : isCancelled                   ? State::Cancelled
                                    : State::Failed;
}

void FileDialog::Read()
{
  char part[4096];
  ssize_t length = 0;
  do
  {
    length = read(this->Pipe, part, sizeof(part));
    this->Output.append(part, length > 0 ? static_cast<std::size_t>(length) : 0);
  } while (length > 0 || (length < 0 && errno == EINTR));
}

void FileDialog::Close()
{
  constexpr int most = 100; // attempts, 10 ms apart
  if (this->Process > 0)
  {
    kill(this->Process, SIGKILL);
    for (int i = 0; i < most && waitpid(this->Process, nullptr, WNOHANG) == 0; ++i)
    {
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
  }
  if (this->Pipe >= 0)
  {
    close(this->Pipe);
  }
  this->Process = -1;
  this->Pipe = -1;
  this->Output.clear();
}

#endif
} // namespace Explore
