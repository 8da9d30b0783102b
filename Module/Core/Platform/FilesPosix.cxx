// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#if !defined(_WIN32)
#include "Core/Platform/Files.h"

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <sys/file.h>
#include <unistd.h>

namespace VolumeHaptics
{
namespace Files
{

int Open(const std::string& name, For what, Mode mode)
{
  const int flags = what == For::Reading ? O_RDONLY | O_NONBLOCK
    : what == For::Writing               ? O_WRONLY | O_TRUNC
    : what == For::ReadingFolder         ? O_RDONLY | O_DIRECTORY
                                         : O_RDWR | O_CREAT | O_EXCL | O_NOFOLLOW;
  int descriptor = -1;
  do
  {
    descriptor = open(name.c_str(), flags | O_CLOEXEC, mode);
  } while (descriptor < 0 && errno == EINTR);
  return descriptor;
}

void Close(int descriptor) noexcept
{
  close(descriptor);
}

bool CloseWritten(int descriptor) noexcept
{
  return close(descriptor) == 0 || errno == EINTR;
}

int Duplicate(int descriptor) noexcept
{
  return fcntl(descriptor, F_DUPFD_CLOEXEC, 0);
}

std::int64_t Read(int descriptor, void* data, std::size_t size) noexcept
{
  return read(descriptor, data, size);
}

std::int64_t ReadAt(int descriptor, void* data, std::size_t size, std::int64_t from) noexcept
{
  return pread(descriptor, data, size, static_cast<off_t>(from));
}

std::int64_t Write(int descriptor, const void* data, std::size_t size) noexcept
{
  return write(descriptor, data, size);
}

bool Seek(int descriptor, std::int64_t position) noexcept
{
  return lseek(descriptor, static_cast<off_t>(position), SEEK_SET) >= 0;
}

bool SeekEnd(int descriptor) noexcept
{
  return lseek(descriptor, 0, SEEK_END) >= 0;
}

int Sync(int descriptor) noexcept
{
  int failure = 0;
  do
  {
    failure = fsync(descriptor) == 0 || errno == EINVAL ? 0 : errno;
  } while (failure == EINTR);
  return failure;
}

bool LockAlone(int descriptor) noexcept
{
  return flock(descriptor, LOCK_EX | LOCK_NB) == 0;
}

bool LockShared(int descriptor) noexcept
{
  return flock(descriptor, LOCK_SH | LOCK_NB) == 0;
}

void Unlock(int descriptor) noexcept
{
  (void)flock(descriptor, LOCK_UN);
}

bool GetStatus(const std::string& name, Status& status)
{
  return stat(name.c_str(), &status) == 0;
}

bool GetStatus(int descriptor, Status& status) noexcept
{
  return fstat(descriptor, &status) == 0;
}

bool IsRegular(const Status& status) noexcept
{
  return S_ISREG(status.st_mode);
}

bool IsFolder(const Status& status) noexcept
{
  return S_ISDIR(status.st_mode);
}

bool IsPipe(const Status& status) noexcept
{
  return S_ISFIFO(status.st_mode);
}

bool Exists(const std::string& name)
{
  Status status;
  return lstat(name.c_str(), &status) == 0;
}

bool IsSame(int descriptor, const std::string& name)
{
  Status here;
  Status there;
  return GetStatus(descriptor, here) && GetStatus(name, there) && here.st_dev == there.st_dev &&
    here.st_ino == there.st_ino;
}

bool Rename(const std::string& from, const std::string& to)
{
  return rename(from.c_str(), to.c_str()) == 0;
}

bool Remove(const std::string& name)
{
  return unlink(name.c_str()) == 0;
}

bool MayWrite(const std::string& name)
{
  return faccessat(AT_FDCWD, name.c_str(), W_OK, AT_EACCESS) == 0;
}

bool MayWriteFolder(const std::string& name)
{
  return faccessat(AT_FDCWD, name.c_str(), W_OK | X_OK, AT_EACCESS) == 0;
}

bool CopyPermissions(int descriptor, const Status& other) noexcept
{
  Status status;
  const bool isKept = fchown(descriptor, other.st_uid, other.st_gid) == 0 ||
    fchown(descriptor, static_cast<uid_t>(-1), other.st_gid) == 0 ||
    (fstat(descriptor, &status) == 0 && status.st_gid == other.st_gid);
  // A file with another owner must not get set-user-ID and similar bits.
  (void)!fchmod(descriptor, isKept ? other.st_mode & 0777 : (other.st_mode & 0700) | 0600);
  return isKept;
}

std::int64_t CountStored(int descriptor, std::int64_t enough) noexcept
{
  std::int64_t stored = 0;
  bool hasMore = true;
  for (off_t at = 0; hasMore && stored < enough;)
  {
    const off_t data = lseek(descriptor, at, SEEK_DATA);
    at = data < 0 ? data : lseek(descriptor, data, SEEK_HOLE);
    hasMore = at >= 0;
    // ENXIO means that no data follow. Any other error means that the file system does not report
    // holes.
    stored = hasMore ? stored + (at - data) : errno == ENXIO ? stored : enough;
  }
  return stored;
}

std::string GetFolder(const std::string& name)
{
  const std::size_t slash = name.rfind('/');
  return slash == std::string::npos ? "." : slash == 0 ? "/" : name.substr(0, slash);
}

bool IsAbsolute(const std::string& name) noexcept
{
  return !name.empty() && name[0] == '/';
}

std::string GetWorkingFolder()
{
  const std::unique_ptr<char, void (*)(void*)> here(getcwd(nullptr, 0), std::free);
  return here ? here.get() : "";
}

std::string ResolveLinks(const std::string& file)
{
  std::string name = file;
  constexpr int most = 40; // limit on the number of links, as in Linux
  for (int i = 0; i < most; ++i)
  {
    const std::unique_ptr<char, void (*)(void*)> real(realpath(name.c_str(), nullptr), std::free);
    if (real)
    {
      return real.get();
    }
    // The file does not exist, but a link to it may.
    char target[4096];
    const ssize_t size = readlink(name.c_str(), target, sizeof(target));
    if (size <= 0)
    {
      return name;
    }
    const std::string next(target, static_cast<std::size_t>(size));
    name = next[0] == '/' ? next : GetFolder(name).append("/").append(next);
  }
  return file;
}

std::string GetVariable(const char* name)
{
  const char* const value = std::getenv(name);
  return value ? value : "";
}

std::string GetSettingsFolder()
{
  const std::string home = GetVariable("HOME");
  const std::string folder = GetVariable("XDG_CONFIG_HOME");
  return !folder.empty() || home.empty() ? folder : home + "/.config";
}

} // namespace Files
} // namespace VolumeHaptics
#endif
