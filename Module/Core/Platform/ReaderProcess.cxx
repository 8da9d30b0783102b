// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Platform/ReaderProcess.h"

#if !defined(_WIN32)
#include "Core/Platform/ControlGroup.h"
#include "Core/Platform/Files.h"
#include "Core/Platform/HelperProcess.h"
#include "Core/Platform/Libraries.h"
#include "Core/Platform/SocketBytes.h"

#include <algorithm>
#include <csignal>
#include <exception>
#include <filesystem>
#include <mutex>
#include <new>
#include <system_error>

#if defined(__linux__)
#include <sys/prctl.h>
#endif
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#define VOLUME_HAPTICS_SANITIZED
#endif
#endif
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define VOLUME_HAPTICS_SANITIZED
#endif
#endif

namespace VolumeHaptics
{
#if defined(_WIN32)
ReadResult AskReader(ReadTask, const std::string&, std::string&, const std::string&, std::uint64_t)
{
  return ReadResult::NoProcess;
}
void ServeReading(int, ReadAnswer*) {}
#else
namespace
{

/** A request. The folder, the path and the detail follow it in the socket. */
struct Request
{
  ReadTask Task = ReadTask::Grid;
  std::uint32_t FolderLength = 0; ///< length of the asking process's working folder
  std::uint32_t PathLength = 0;
  std::uint32_t DetailLength = 0;
  std::uint64_t Unpacked = 0;
};

enum class End : std::uint64_t
{
  Broken,
  Read,
  TookTooMuch ///< memory or time
};

/** An answer. Its bytes follow it in the socket. */
struct Answer
{
  End State = End::Broken;
  std::uint64_t ByteCount = 0;
};

bool IsServing = false; ///< whether this process reads files for another one

std::uint64_t GetPhysicalMemory()
{
  return static_cast<std::uint64_t>(std::max(sysconf(_SC_PHYS_PAGES), 0L)) *
    static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}

/** Limits memory and time to the amounts that a file of this size can need. */
void SetLimits(ReadTask task, const std::string& path, std::uint64_t unpacked)
{
  constexpr std::uint64_t leastSeconds = 120;
  alarm(leastSeconds); // set first, because a network folder may never report the size
  constexpr std::uint64_t most = std::uint64_t{ 1 } << 40; // a file of holes may be larger
  std::error_code failure;
  std::uint64_t size = std::filesystem::file_size(Files::ToPath(path), failure);
  size = failure ? 0 : std::min(size, most);
  unpacked = std::min(unpacked, most);
  constexpr std::uint64_t perByte = 64;
  constexpr std::uint64_t slowest = 256 << 10; // bytes a second
  // A grid's image has up to 2^25 samples, with several values each.
  const bool isGrid = task == ReadTask::Grid || task == ReadTask::Case;
  std::uint64_t bytes = (std::uint64_t{ isGrid ? 4U : 1U } << 30) + perByte * size + 4 * unpacked;
  std::uint64_t seconds = leastSeconds + (size + unpacked) / slowest;
  // The size of a case file does not include the files that it names, nor does a folder's size
  // include its files.
  if (task == ReadTask::Case || std::filesystem::is_directory(Files::ToPath(path), failure))
  {
    bytes = std::max(bytes, GetPhysicalMemory() / 2);
    seconds = std::max<std::uint64_t>(seconds, 3600);
  }
#if !defined(VOLUME_HAPTICS_SANITIZED) // sanitizers reserve terabytes
  rlimit memory = {};
  getrlimit(RLIMIT_DATA, &memory);
  memory.rlim_cur = std::min<rlim_t>(memory.rlim_cur, bytes);
  setrlimit(RLIMIT_DATA, &memory);
#endif
  alarm(static_cast<unsigned>(seconds));
}

/** Receives bytes as they arrive, because the reader may announce any size. */
bool ReceiveBytes(int link, std::uint64_t size, std::string& bytes)
{
  const auto most = std::min(static_cast<double>(GetPhysicalMemory()) / 2, ReadGroupMemory());
  if (static_cast<double>(size) > most)
  {
    return false;
  }
  bytes.reserve(static_cast<std::size_t>(size));
  bool isReceived = true;
  while (isReceived && bytes.size() < size)
  {
    constexpr std::uint64_t piece = 16 << 20;
    const std::size_t at = bytes.size();
    bytes.resize(at + static_cast<std::size_t>(std::min(piece, size - at)));
    isReceived = ReceiveAll(link, &bytes[at], bytes.size() - at);
  }
  return isReceived;
}

bool ReceiveText(int link, std::uint32_t size, std::string& text)
{
  text.resize(size);
  return ReceiveAll(link, &text[0], text.size());
}

/** Reads a file, and sends the result. */
void Serve(int link, const Request& request, const std::string& folder, const std::string& path,
  const std::string& detail, ReadAnswer* read, volatile bool& isSending)
{
#if defined(__linux__)
  prctl(PR_SET_PDEATHSIG, SIGKILL);
#endif
  Answer answer;
  std::string bytes;
  try
  {
    if (folder.empty() || chdir(folder.c_str()) == 0)
    {
      SetLimits(request.Task, path, request.Unpacked);
      bytes = read(request.Task, path, detail);
      answer.State = End::Read;
    }
  }
  catch (const std::bad_alloc&)
  {
    answer.State = End::TookTooMuch;
  }
  catch (...) // the read function failed
  {
    bytes.clear();
  }
  alarm(0);
  answer.ByteCount = bytes.size();
  isSending = true;
  const bool isSent =
    SendAll(link, &answer, sizeof(answer)) && SendAll(link, bytes.data(), bytes.size());
  _exit(isSent ? 0 : 1);
}

} // namespace

ReadResult AskReader(ReadTask task, const std::string& path, std::string& answer,
  const std::string& detail, std::uint64_t unpacked)
{
  const void* const code = reinterpret_cast<const void*>(&vtkHapticServeReading);
  // Boxes have separate processes, because their readers must wait neither for whole files nor for
  // each other. There are only a few processes, because each has a copy of the library's data. If
  // none is free, a thread waits for the last one.
  constexpr std::size_t boxProcesses = 4;
  static HelperProcess processes[1 + boxProcesses];
  static std::mutex accesses[1 + boxProcesses];
  const bool isBox = task == ReadTask::TiffBox;
  std::size_t number = isBox ? 1 : 0;
  std::unique_lock<std::mutex> lock(accesses[number], std::try_to_lock);
  while (!lock && isBox && number < boxProcesses)
  {
    lock = std::unique_lock<std::mutex>(accesses[++number], std::try_to_lock);
  }
  lock ? void() : lock.lock();
  HelperProcess& process = processes[number];
  answer.clear();
  const std::string library = Libraries::FindFileOf(code);
  const std::string folder = Files::GetWorkingFolder();
  const Request request{ task, static_cast<std::uint32_t>(folder.size()),
    static_cast<std::uint32_t>(path.size()), static_cast<std::uint32_t>(detail.size()), unpacked };
  std::string obstacle;
  const auto send = [&]
  {
    char isReady = 0; // the process first reports whether it has loaded the library
    const int link = process.GetLink();
    return SendAll(link, &request, sizeof(request)) &&
      SendAll(link, folder.data(), folder.size()) && SendAll(link, path.data(), path.size()) &&
      SendAll(link, detail.data(), detail.size()) && ReceiveAll(link, &isReady, 1);
  };
  bool isSent = false;
  // If the process has ended since the last file, start a new one.
  for (int tries = 0; tries < 2 && !isSent && !IsServing && !library.empty(); ++tries)
  {
    isSent = process.Start("volumehaptics-read", code, obstacle, library) && send();
    isSent ? void() : process.End();
  }
  if (!isSent)
  {
    if (!obstacle.empty())
    {
      answer = "read without limits of memory and time, since another user could have written "
               "volumehaptics-read (" +
        obstacle + ")";
    }
    return ReadResult::NoProcess;
  }
  const int link = process.GetLink();
  Answer head;
  bool isRead = ReceiveAll(link, &head, sizeof(head));
  try
  {
    isRead = isRead && ReceiveBytes(link, head.ByteCount, answer);
  }
  catch (const std::exception&) // the answer announces more bytes than fit into memory
  {
    isRead = false;
  }
  isRead ? void() : process.End();
  if (isRead && head.State == End::Read)
  {
    return ReadResult::Answered;
  }
  answer = head.State == End::Broken
    ? "its reader ended, as damaged files make it"
    : "its reader took more memory or time than such a file may need";
  return ReadResult::Ended;
}

void ServeReading(int link, ReadAnswer* read)
{
  IsServing = true;
  const rlimit none = {};
  setrlimit(RLIMIT_CORE, &none);
  auto* const isSending = static_cast<volatile bool*>(
    mmap(nullptr, sizeof(bool), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0));
  Request request;
  std::string folder;
  std::string path;
  std::string detail;
  constexpr char ready = 1;
  while (isSending != MAP_FAILED && ReceiveAll(link, &request, sizeof(request)) &&
    ReceiveText(link, request.FolderLength, folder) &&
    ReceiveText(link, request.PathLength, path) &&
    ReceiveText(link, request.DetailLength, detail) && SendAll(link, &ready, 1))
  {
    *isSending = false;
    const pid_t reader = fork();
    if (reader == 0)
    {
      Serve(link, request, folder, path, detail, read, *isSending);
    }
    int state = 0;
    const bool hasEnded = reader > 0 && waitpid(reader, &state, 0) == reader;
    const bool isFine = hasEnded && WIFEXITED(state) && WEXITSTATUS(state) == 0;
    Answer refusal;
    refusal.State =
      hasEnded && WIFSIGNALED(state) && WTERMSIG(state) == SIGALRM ? End::TookTooMuch : End::Broken;
    if (!isFine && (*isSending || !SendAll(link, &refusal, sizeof(refusal))))
    {
      return;
    }
  }
}
#endif

} // namespace VolumeHaptics
