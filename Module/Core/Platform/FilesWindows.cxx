// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#if defined(_WIN32)
#include "Core/Platform/Files.h"
#include "Core/Platform/WindowsApi.h"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <io.h>
#include <limits>

namespace VolumeHaptics
{
namespace Files
{
namespace
{

/**
 * LockFileEx makes the locked bytes unreadable to others, so lock a byte beyond the end of any
 * file.
 */
constexpr DWORD FarAway = 0x7fffffff;

int ToErrno(DWORD error) noexcept
{
  switch (error)
  {
    case ERROR_FILE_NOT_FOUND:
    case ERROR_PATH_NOT_FOUND:
    case ERROR_BAD_PATHNAME:
    case ERROR_INVALID_NAME:
    case ERROR_INVALID_DRIVE:
    case ERROR_BAD_NETPATH:
      return ENOENT;
    case ERROR_DIRECTORY:
      return ENOTDIR;
    case ERROR_FILE_EXISTS:
    case ERROR_ALREADY_EXISTS:
      return EEXIST;
    case ERROR_ACCESS_DENIED:
    case ERROR_SHARING_VIOLATION:
    case ERROR_WRITE_PROTECT:
    case ERROR_PRIVILEGE_NOT_HELD:
      return EACCES;
    case ERROR_DISK_FULL:
    case ERROR_HANDLE_DISK_FULL:
      return ENOSPC;
    case ERROR_LOCK_VIOLATION:
    case ERROR_IO_PENDING:
      return EWOULDBLOCK;
    case ERROR_FILENAME_EXCED_RANGE:
      return ENAMETOOLONG;
    case ERROR_NOT_ENOUGH_MEMORY:
    case ERROR_OUTOFMEMORY:
      return ENOMEM;
    case ERROR_TOO_MANY_OPEN_FILES:
      return EMFILE;
    case ERROR_INVALID_HANDLE:
      return EBADF;
    default:
      return EIO;
  }
}

bool SetErrno(bool isGood) noexcept
{
  if (!isGood)
  {
    errno = ToErrno(GetLastError());
  }
  return isGood;
}

HANDLE ToHandle(int descriptor) noexcept
{
  return reinterpret_cast<HANDLE>(_get_osfhandle(descriptor));
}

/** Opens a file to query its properties, even if it may not be read. */
HANDLE OpenToAsk(const std::string& name)
{
  return CreateFileW(ToWide(name).c_str(), FILE_READ_ATTRIBUTES,
    FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE, nullptr, OPEN_EXISTING,
    FILE_FLAG_BACKUP_SEMANTICS, nullptr);
}

bool Lock(int descriptor, DWORD flags) noexcept
{
  OVERLAPPED place{};
  place.OffsetHigh = FarAway;
  return SetErrno(
    LockFileEx(ToHandle(descriptor), flags | LOCKFILE_FAIL_IMMEDIATELY, 0, 1, 0, &place) != FALSE);
}

} // namespace

int Open(const std::string& name, For what, Mode mode)
{
  const bool writes = what == For::Writing || what == For::MakingNew;
  const DWORD access = what == For::Writing ? GENERIC_WRITE
    : what == For::MakingNew                ? GENERIC_READ | GENERIC_WRITE
                                            : GENERIC_READ;
  const DWORD disposition = what == For::Writing ? TRUNCATE_EXISTING
    : what == For::MakingNew                     ? CREATE_NEW
                                                 : OPEN_EXISTING;
  (void)mode; // the folder's access list applies to the new file
  const HANDLE handle = CreateFileW(ToWide(name).c_str(), access,
    FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE, nullptr, disposition,
    what == For::ReadingFolder ? FILE_FLAG_BACKUP_SEMANTICS : FILE_ATTRIBUTE_NORMAL, nullptr);
  if (!SetErrno(handle != INVALID_HANDLE_VALUE))
  {
    return -1;
  }
  const int descriptor = _open_osfhandle(reinterpret_cast<std::intptr_t>(handle),
    (writes ? _O_RDWR : _O_RDONLY) | _O_BINARY | _O_NOINHERIT);
  if (descriptor < 0)
  {
    CloseHandle(handle);
  }
  return descriptor;
}

void Close(int descriptor) noexcept
{
  _close(descriptor);
}

bool CloseWritten(int descriptor) noexcept
{
  return _close(descriptor) == 0;
}

int Duplicate(int descriptor) noexcept
{
  return _dup(descriptor);
}

std::int64_t Read(int descriptor, void* data, std::size_t size) noexcept
{
  return _read(descriptor, data,
    static_cast<unsigned>(std::min<std::size_t>(size, std::numeric_limits<int>::max())));
}

std::int64_t ReadAt(int descriptor, void* data, std::size_t size, std::int64_t from) noexcept
{
  OVERLAPPED place{};
  place.Offset = static_cast<DWORD>(from);
  place.OffsetHigh = static_cast<DWORD>(from >> 32);
  DWORD got = 0;
  const bool isRead =
    ReadFile(ToHandle(descriptor), data, static_cast<DWORD>(std::min<std::size_t>(size, 1u << 30)),
      &got, &place) != FALSE;
  if (!isRead && GetLastError() == ERROR_HANDLE_EOF)
  {
    return 0;
  }
  return SetErrno(isRead) ? std::int64_t{ got } : -1;
}

std::int64_t Write(int descriptor, const void* data, std::size_t size) noexcept
{
  return _write(descriptor, data,
    static_cast<unsigned>(std::min<std::size_t>(size, std::numeric_limits<int>::max())));
}

bool Seek(int descriptor, std::int64_t position) noexcept
{
  return _lseeki64(descriptor, position, SEEK_SET) >= 0;
}

bool SeekEnd(int descriptor) noexcept
{
  return _lseeki64(descriptor, 0, SEEK_END) >= 0;
}

int Sync(int descriptor) noexcept
{
  // Windows can't flush folders, and files that are open for reading only. They need no flush.
  return FlushFileBuffers(ToHandle(descriptor)) || GetLastError() == ERROR_ACCESS_DENIED
    ? 0
    : ToErrno(GetLastError());
}

bool LockAlone(int descriptor) noexcept
{
  return Lock(descriptor, LOCKFILE_EXCLUSIVE_LOCK);
}

bool LockShared(int descriptor) noexcept
{
  return Lock(descriptor, 0);
}

void Unlock(int descriptor) noexcept
{
  OVERLAPPED place{};
  place.OffsetHigh = FarAway;
  UnlockFileEx(ToHandle(descriptor), 0, 1, 0, &place);
}

bool GetStatus(const std::string& name, Status& status)
{
  return _wstat64(ToWide(name).c_str(), &status) == 0;
}

bool GetStatus(int descriptor, Status& status) noexcept
{
  return _fstat64(descriptor, &status) == 0;
}

bool IsRegular(const Status& status) noexcept
{
  return (status.st_mode & _S_IFMT) == _S_IFREG;
}

bool IsFolder(const Status& status) noexcept
{
  return (status.st_mode & _S_IFMT) == _S_IFDIR;
}

bool IsPipe(const Status& status) noexcept
{
  return (status.st_mode & _S_IFMT) == _S_IFIFO;
}

bool Exists(const std::string& name)
{
  return GetFileAttributesW(ToWide(name).c_str()) != INVALID_FILE_ATTRIBUTES;
}

bool IsSame(int descriptor, const std::string& name)
{
  const WindowsHandle other(OpenToAsk(name));
  BY_HANDLE_FILE_INFORMATION here{};
  BY_HANDLE_FILE_INFORMATION there{};
  return other.Get() && GetFileInformationByHandle(ToHandle(descriptor), &here) &&
    GetFileInformationByHandle(other.Get(), &there) &&
    here.dwVolumeSerialNumber == there.dwVolumeSerialNumber &&
    here.nFileIndexHigh == there.nFileIndexHigh && here.nFileIndexLow == there.nFileIndexLow;
}

bool Rename(const std::string& from, const std::string& to)
{
  return SetErrno(MoveFileExW(ToWide(from).c_str(), ToWide(to).c_str(),
                    MOVEFILE_REPLACE_EXISTING | MOVEFILE_WRITE_THROUGH) != FALSE);
}

bool Remove(const std::string& name)
{
  return SetErrno(DeleteFileW(ToWide(name).c_str()) != FALSE);
}

bool MayWrite(const std::string& name)
{
  // Opening a file for attributes would not check whether it may be written.
  const WindowsHandle file(CreateFileW(ToWide(name).c_str(), GENERIC_WRITE,
    FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE, nullptr, OPEN_EXISTING,
    FILE_ATTRIBUTE_NORMAL, nullptr));
  return SetErrno(file.Get() != nullptr);
}

bool MayWriteFolder(const std::string& name)
{
  const WindowsHandle folder(CreateFileW(ToWide(name).c_str(), FILE_ADD_FILE,
    FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE, nullptr, OPEN_EXISTING,
    FILE_FLAG_BACKUP_SEMANTICS, nullptr));
  return SetErrno(folder.Get() != nullptr);
}

bool CopyPermissions(int descriptor, const Status& other) noexcept
{
  (void)descriptor;
  (void)other;
  return true; // a new file gets the access list of its folder, as the existing one did
}

std::int64_t CountStored(int descriptor, std::int64_t enough) noexcept
{
  FILE_STANDARD_INFO info{};
  return GetFileInformationByHandleEx(ToHandle(descriptor), FileStandardInfo, &info, sizeof(info))
    ? std::int64_t{ info.AllocationSize.QuadPart }
    : enough;
}

std::string GetFolder(const std::string& name)
{
  const std::size_t end = name.find_last_of("/\\:");
  if (end == std::string::npos)
  {
    return ".";
  }
  const bool isRoot = end == 0 || name[end] == ':' || name[end - 1] == ':';
  return name[end] == ':' ? name.substr(0, end + 1) + "." : name.substr(0, isRoot ? end + 1 : end);
}

bool IsAbsolute(const std::string& name) noexcept
{
  const auto isSlash = [&name](std::size_t at)
  { return at < name.size() && (name[at] == '/' || name[at] == '\\'); };
  return (isSlash(0) && isSlash(1)) || (name.size() > 2 && name[1] == ':' && isSlash(2));
}

std::string GetWorkingFolder()
{
  std::error_code error;
  const std::filesystem::path here = std::filesystem::current_path(error);
  return error ? std::string() : here.generic_u8string();
}

std::string ResolveLinks(const std::string& file)
{
  std::error_code error;
  const std::filesystem::path path = ToPath(file);
  if (!std::filesystem::is_symlink(std::filesystem::symlink_status(path, error)))
  {
    return file;
  }
  const std::filesystem::path real = std::filesystem::weakly_canonical(path, error);
  return error ? file : ToName(real);
}

std::string GetVariable(const char* name)
{
  const std::wstring wide = ToWide(name);
  std::wstring value(GetEnvironmentVariableW(wide.c_str(), nullptr, 0), L'\0');
  value.resize(
    GetEnvironmentVariableW(wide.c_str(), value.data(), static_cast<DWORD>(value.size())));
  return FromWide(value);
}

std::string GetSettingsFolder()
{
  return GetVariable("APPDATA");
}

} // namespace Files
} // namespace VolumeHaptics
#endif
