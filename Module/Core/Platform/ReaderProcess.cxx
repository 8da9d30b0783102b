// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Platform/ReaderProcess.h"

#if !defined(_WIN32)
#include "Core/Platform/Files.h"
#include "Core/Platform/HelperProcess.h"
#include "Core/Platform/Libraries.h"
#include "Core/Platform/SocketBytes.h"

#include <algorithm>
#include <csignal>
#include <exception>
#include <filesystem>
#include <mutex>
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
ReadResult AskReader(ReadTask, const std::string&, std::string&)
{
  return ReadResult::NoProcess;
}
void ServeReading(int, std::string (*)(ReadTask, const std::string&)) {}
#else
namespace
{

/** The two texts follow. */
struct Request
{
  ReadTask Task = ReadTask::Grid;
  std::uint32_t FolderLength = 0; ///< length of the folder in which the asker works
  std::uint32_t PathLength = 0;
};

/** The bytes follow. */
struct Answer
{
  std::uint64_t IsRead = 0;
  std::uint64_t ByteCount = 0;
};

bool IsServing = false; ///< whether this process reads for another one

/** Returns the size of a file, or that of the files in its folder for a task that reads several. */
std::uint64_t CountBytes(ReadTask task, const std::string& path)
{
  namespace fs = std::filesystem;
  std::error_code failure;
  std::uint64_t size = 0;
  if (task != ReadTask::Grid)
  {
    size = fs::file_size(Files::ToPath(path), failure);
    return failure ? 0 : size;
  }
  constexpr int most = 100000; // files, which are counted in less than a second
  int count = 0;
  const auto skip = fs::directory_options::skip_permission_denied;
  for (fs::recursive_directory_iterator at(Files::ToPath(Files::GetFolder(path)), skip, failure);
       !failure && at != fs::recursive_directory_iterator() && count < most;
       at.increment(failure), ++count)
  {
    std::error_code none;
    const std::uint64_t one = at->is_regular_file(none) ? at->file_size(none) : 0;
    size += none ? 0 : one;
  }
  return size;
}

/** Limits memory and time to what files of this size can need. */
void SetLimits(ReadTask task, std::uint64_t size)
{
#if !defined(VOLUME_HAPTICS_SANITIZED) // sanitizers map terabytes
  // The image of a grid has up to 2^25 samples, with several values each.
  const std::uint64_t least = std::uint64_t{ task == ReadTask::Grid ? 4U : 1U } << 30;
  constexpr std::uint64_t perByte = 64;
  rlimit memory = {};
  getrlimit(RLIMIT_DATA, &memory);
  memory.rlim_cur = std::min<rlim_t>(memory.rlim_max, least + perByte * size);
  setrlimit(RLIMIT_DATA, &memory);
#endif
  constexpr std::uint64_t leastSeconds = 120;
  constexpr std::uint64_t slowest = 256 << 10; // bytes a second
  alarm(static_cast<unsigned>(leastSeconds + size / slowest));
}

bool ReceiveText(int link, std::uint32_t size, std::string& text)
{
  text.resize(size);
  return ReceiveAll(link, &text[0], text.size());
}

/** Reads a file, and sends what was read. */
void Serve(int link, const Request& request, const std::string& folder, const std::string& path,
  std::string (*read)(ReadTask, const std::string&), volatile bool& isSending)
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
      SetLimits(request.Task, CountBytes(request.Task, path));
      bytes = read(request.Task, path);
      answer.IsRead = 1;
    }
  }
  catch (...) // there is too little memory
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

ReadResult AskReader(ReadTask task, const std::string& path, std::string& answer)
{
  const void* const code = reinterpret_cast<const void*>(&vtkHapticServeReading);
  static HelperProcess process;
  static std::mutex access;
  const std::lock_guard<std::mutex> lock(access);
  answer.clear();
  const std::string library = Libraries::FindFileOf(code);
  std::string obstacle;
  static bool mayStart = true;
  static bool hasStarted = false;
  if (IsServing || library.empty() || !mayStart ||
    !process.Start("volumehaptics-read", code, obstacle, library))
  {
    return ReadResult::NoProcess;
  }
  // It tells first whether it has loaded the library.
  char isReady = 0;
  const int link = process.GetLink();
  const std::string folder = Files::GetWorkingFolder();
  const Request request{ task, static_cast<std::uint32_t>(folder.size()),
    static_cast<std::uint32_t>(path.size()) };
  if (!SendAll(link, &request, sizeof(request)) || !SendAll(link, folder.data(), folder.size()) ||
    !SendAll(link, path.data(), path.size()) || !ReceiveAll(link, &isReady, 1))
  {
    process.End();
    mayStart = hasStarted; // else it can't load the library
    return ReadResult::NoProcess;
  }
  hasStarted = true;
  Answer head;
  bool isRead = ReceiveAll(link, &head, sizeof(head));
  try
  {
    answer.resize(isRead ? static_cast<std::size_t>(head.ByteCount) : 0);
    isRead = isRead && ReceiveAll(link, &answer[0], answer.size());
  }
  catch (const std::exception&) // the answer promises more than there is memory
  {
    isRead = false;
  }
  if (!isRead)
  {
    answer.clear();
    process.End();
  }
  return isRead && head.IsRead != 0 ? ReadResult::Answered : ReadResult::Ended;
}

void ServeReading(int link, std::string (*read)(ReadTask task, const std::string& path))
{
  IsServing = true;
  const rlimit none = {};
  setrlimit(RLIMIT_CORE, &none);
  auto* const isSending = static_cast<volatile bool*>(
    mmap(nullptr, sizeof(bool), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0));
  Request request;
  std::string folder;
  std::string path;
  constexpr char ready = 1;
  while (isSending != MAP_FAILED && ReceiveAll(link, &request, sizeof(request)) &&
    ReceiveText(link, request.FolderLength, folder) &&
    ReceiveText(link, request.PathLength, path) && SendAll(link, &ready, 1))
  {
    *isSending = false;
    const pid_t reader = fork();
    if (reader == 0)
    {
      Serve(link, request, folder, path, read, *isSending);
    }
    int state = 0;
    const bool hasEnded = reader > 0 && waitpid(reader, &state, 0) == reader;
    const bool isFine = hasEnded && WIFEXITED(state) && WEXITSTATUS(state) == 0;
    const Answer refusal;
    if (!isFine && (*isSending || !SendAll(link, &refusal, sizeof(refusal))))
    {
      return;
    }
  }
}
#endif

} // namespace VolumeHaptics
