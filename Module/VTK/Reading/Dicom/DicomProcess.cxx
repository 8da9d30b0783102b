// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Reading/Dicom/DicomProcess.h"

#include "VTK/Base/HapticFiles.h"
#include "VTK/Reading/InputError.h"

#if !defined(_WIN32)
#include "Core/Platform/OwnFile.h"

#include <vtksys/SystemTools.hxx>

#include <cerrno>
#include <csignal>
#include <mutex>

#include <fcntl.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;

namespace
{
using Explore::DicomAnswer;
using Explore::DicomRequest;
using Explore::ReceiveAll;
using Explore::SendAll;

/// The process, and the socket to it.
class DicomProcess
{
public:
  DicomProcess() = default;
  ~DicomProcess() { this->End(); }
  DicomProcess(const DicomProcess&) = delete;
  DicomProcess& operator=(const DicomProcess&) = delete;

  /// Starts the process if it does not run. `obstacle`: why its program may not run.
  bool Start(std::string& obstacle);
  /// Ends the process, which it does by itself when the socket is closed, unless it is at work.
  void End();
  bool Ask(const DicomRequest& request, const std::string& path, std::uint64_t mostAnswer,
    DicomAnswer& answer, std::string& bytes);

  std::mutex Access;

private:
  pid_t Owner = -1; ///< process that has started it
  pid_t Process = -1;
  int Link = -1;
};

bool DicomProcess::Start(std::string& obstacle)
{
  if (this->Link >= 0 && this->Owner == getpid())
  {
    return true;
  }
  this->End();
  std::string program = VolumeHaptics::FindProgramOfLibrary(
    reinterpret_cast<const void*>(&Explore::AskDicom), "volumehaptics-dicom", obstacle);
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
  this->Owner = getpid();
  return true;
}

void DicomProcess::End()
{
  if (this->Link < 0)
  {
    return;
  }
  close(this->Link);
  this->Link = -1;
  // After a fork, the process still works for the parent.
  if (this->Owner == getpid())
  {
    kill(this->Process, SIGKILL);
    while (waitpid(this->Process, nullptr, 0) < 0 && errno == EINTR)
    {
    }
  }
  this->Process = -1;
}

bool DicomProcess::Ask(const DicomRequest& request, const std::string& path,
  std::uint64_t mostAnswer, DicomAnswer& answer, std::string& bytes)
{
  // The process is as trustworthy as the file that it reads.
  bool isRead = SendAll(this->Link, &request, sizeof(request)) &&
    SendAll(this->Link, path.data(), path.size()) &&
    ReceiveAll(this->Link, &answer, sizeof(answer)) && answer.ByteCount <= mostAnswer;
  if (isRead)
  {
    bytes.resize(static_cast<std::size_t>(answer.ByteCount));
    isRead = ReceiveAll(this->Link, &bytes[0], bytes.size());
  }
  if (!isRead)
  {
    this->End();
  }
  return isRead && answer.IsRead != 0;
}
} // namespace
#endif

namespace Explore
{
bool HasDicomMark(const std::string& path)
{
  char mark[4] = {};
  std::ifstream file = VolumeHaptics::OpenStream(path);
  file.seekg(128);
  return file.read(mark, sizeof(mark)) && std::string(mark, sizeof(mark)) == "DICM";
}
#if defined(_WIN32)
bool AskDicom(DicomRequest::Kind, const std::string& path, std::uint64_t, DicomAnswer& answer,
  std::string& bytes)
{
  answer = {};
  bytes.clear();
  if (HasDicomMark(path))
  {
    throw InputError(path, "is DICOM, which is read on Linux only",
      "make a NIfTI or NRRD file of it, such as with dcm2niix or 3D Slicer");
  }
  return false;
}
#else
bool AskDicom(DicomRequest::Kind what, const std::string& path, std::uint64_t mostBytes,
  DicomAnswer& answer, std::string& bytes)
{
  static DicomProcess process;
  const std::lock_guard<std::mutex> lock(process.Access);
  answer = {};
  bytes.clear();
  std::string obstacle;
  if (!process.Start(obstacle))
  {
    if (HasDicomMark(path))
    {
      throw InputError(path,
        "is DICOM, and the program volumehaptics-dicom that reads it is missing" +
          (obstacle.empty() ? "" : ", or another user could have written it (" + obstacle + ")"),
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
#endif
} // namespace Explore
