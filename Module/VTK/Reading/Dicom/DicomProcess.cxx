// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Reading/Dicom/DicomProcess.h"

#include "VTK/Reading/InputError.h"

#include <vtksys/FStream.hxx>
#include <vtksys/SystemTools.hxx>

#include <cerrno>
#include <csignal>
#include <mutex>

#include <dlfcn.h>
#include <fcntl.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;

namespace
{
using Explore::DicomAnswer;
using Explore::DicomRequest;

/// The process, and the socket to it.
class DicomProcess
{
public:
  DicomProcess() = default;
  ~DicomProcess() { this->End(); }
  DicomProcess(const DicomProcess&) = delete;
  DicomProcess& operator=(const DicomProcess&) = delete;

  bool Start();
  /// Ends the process, which it does by itself when the socket is closed, unless it is at work.
  void End();
  bool Ask(const DicomRequest& request, const std::string& path, std::uint64_t mostAnswer,
    DicomAnswer& answer, std::string& bytes);

  std::mutex Access;

private:
  bool Send(const void* from, std::size_t size) const;
  bool Receive(void* to, std::size_t size) const;

  pid_t Process = -1;
  int Link = -1;
};

/// Searches volumehaptics-dicom in and above the folder of a file, and in a folder "bin" there. A
/// file that another user could have written is skipped. Returns an empty path if there is none.
std::string FindProgramNear(const std::string& file)
{
  constexpr int mostFoldersUp = 6;
  std::string folder = vtksys::SystemTools::GetRealPath(file);
  for (int up = 0; up <= mostFoldersUp && !folder.empty(); ++up)
  {
    folder = vtksys::SystemTools::GetFilenamePath(folder);
    for (const char* const name : { "/volumehaptics-dicom", "/bin/volumehaptics-dicom" })
    {
      struct stat info = {};
      const std::string program = folder + name;
      if (lstat(program.c_str(), &info) == 0 && S_ISREG(info.st_mode) &&
        (info.st_uid == 0 || info.st_uid == geteuid()) && (info.st_mode & S_IWOTH) == 0 &&
        access(program.c_str(), X_OK) == 0)
      {
        return program;
      }
    }
  }
  return {};
}

/// The program is near this library, or near the program that the library is a part of.
std::string FindProgram()
{
  Dl_info info{};
  std::string program;
  if (dladdr(reinterpret_cast<const void*>(&Explore::AskDicom), &info) != 0)
  {
    program = FindProgramNear(info.dli_fname);
  }
  return program.empty() ? FindProgramNear("/proc/self/exe") : program;
}

bool DicomProcess::Start()
{
  if (this->Link >= 0)
  {
    return true;
  }
  std::string program = FindProgram();
  int links[2];
  if (program.empty() || socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, links) != 0)
  {
    return false;
  }
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, links[1], STDIN_FILENO);
  // What GDCM says of damaged files is not for the user.
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  sigset_t signals;
  sigemptyset(&signals);
  posix_spawnattr_setsigmask(&attributes, &signals);
  sigfillset(&signals);
  posix_spawnattr_setsigdefault(&attributes, &signals);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
  char* words[] = { program.data(), nullptr };
  const int result =
    posix_spawn(&this->Process, program.c_str(), &actions, &attributes, words, environ);
  posix_spawn_file_actions_destroy(&actions);
  posix_spawnattr_destroy(&attributes);
  close(links[1]);
  if (result != 0)
  {
    close(links[0]);
    this->Process = -1;
    return false;
  }
  this->Link = links[0];
  return true;
}

void DicomProcess::End()
{
  if (this->Link >= 0)
  {
    close(this->Link);
    this->Link = -1;
    kill(this->Process, SIGKILL);
    while (waitpid(this->Process, nullptr, 0) < 0 && errno == EINTR)
    {
    }
    this->Process = -1;
  }
}

bool DicomProcess::Send(const void* from, std::size_t size) const
{
  const char* at = static_cast<const char*>(from);
  while (size > 0)
  {
    const ssize_t sent = send(this->Link, at, size, MSG_NOSIGNAL);
    if (sent <= 0 && errno != EINTR)
    {
      return false;
    }
    at += sent > 0 ? sent : 0;
    size -= static_cast<std::size_t>(sent > 0 ? sent : 0);
  }
  return true;
}

bool DicomProcess::Receive(void* to, std::size_t size) const
{
  char* at = static_cast<char*>(to);
  while (size > 0)
  {
    const ssize_t got = recv(this->Link, at, size, MSG_WAITALL);
    if (got == 0 || (got < 0 && errno != EINTR))
    {
      return false;
    }
    at += got > 0 ? got : 0;
    size -= static_cast<std::size_t>(got > 0 ? got : 0);
  }
  return true;
}

bool DicomProcess::Ask(const DicomRequest& request, const std::string& path,
  std::uint64_t mostAnswer, DicomAnswer& answer, std::string& bytes)
{
  // The process is as trustworthy as the file that it reads.
  bool isRead = this->Send(&request, sizeof(request)) && this->Send(path.data(), path.size()) &&
    this->Receive(&answer, sizeof(answer)) && answer.ByteCount <= mostAnswer;
  if (isRead)
  {
    bytes.resize(static_cast<std::size_t>(answer.ByteCount));
    isRead = this->Receive(&bytes[0], bytes.size());
  }
  if (!isRead)
  {
    this->End();
  }
  return isRead && answer.IsRead != 0;
}
} // namespace

namespace Explore
{
bool HasDicomMark(const std::string& path)
{
  char mark[4] = {};
  vtksys::ifstream file(path.c_str(), std::ios::binary);
  file.seekg(128);
  return file.read(mark, sizeof(mark)) && std::string(mark, sizeof(mark)) == "DICM";
}
bool AskDicom(DicomRequest::Kind what, const std::string& path, std::uint64_t mostBytes,
  DicomAnswer& answer, std::string& bytes)
{
  static DicomProcess process;
  const std::lock_guard<std::mutex> lock(process.Access);
  answer = {};
  bytes.clear();
  if (!process.Start())
  {
    if (HasDicomMark(path))
    {
      throw InputError(path,
        "is DICOM, and the program volumehaptics-dicom that reads it is missing",
        "build it with GDCM (package libgdcm-dev)");
    }
    return false;
  }
  DicomRequest request;
  request.What = what;
  request.PathLength = static_cast<std::uint32_t>(path.size());
  request.MostBytes = mostBytes;
  constexpr std::uint64_t least = 1 << 20;
  const std::uint64_t mostAnswer =
    what == DicomRequest::Values ? least + 4 * vtksys::SystemTools::FileLength(path) : mostBytes;
  return process.Ask(request, path, mostAnswer, answer, bytes);
}
} // namespace Explore
