// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Base/FileReplacement.h"

#include "VTK/Base/HapticFiles.h"

#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <random>
#include <sys/stat.h>
#include <unistd.h>

namespace VolumeHaptics
{
namespace
{

constexpr std::size_t BufferSize = 1 << 16;

/**
 * Creates a file with a random name in the folder of `file`. Returns its descriptor, or -1 with
 * errno.
 */
int CreateBeside(const std::string& file, mode_t mode, std::string& name)
{
  std::random_device random;
  int descriptor = -1;
  constexpr int most = 100; // attempts; two random names of 64 bits are hardly ever equal
  for (int i = 0; i < most && descriptor < 0 && (i == 0 || errno == EEXIST); ++i)
  {
    char text[40];
    std::snprintf(text, sizeof(text), "VolumeHaptics%08x%08x.tmp", random(), random());
    name = GetFolder(file);
    name += (name.back() == '/' ? "" : "/") + std::string(text);
    descriptor = OpenFile(name, O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW, mode);
  }
  return descriptor;
}

} // namespace

FileReplacement::~FileReplacement()
{
  this->Discard();
}

void FileReplacement::Discard()
{
  if (this->Descriptor >= 0)
  {
    close(this->Descriptor);
    this->Descriptor = -1;
  }
  if (this->IsThere)
  {
    unlink(this->Temporary.c_str());
    this->IsThere = false;
  }
}

bool FileReplacement::Open(const std::string& file, std::string& error)
{
  if (!CheckWritable(file, error))
  {
    return false;
  }
  this->Target = ResolveLinks(file);
  struct stat status;
  const bool isOld = stat(this->Target.c_str(), &status) == 0;
  constexpr mode_t everybody = 0666; // the user's mask removes some of these
  this->Descriptor =
    CreateBeside(this->Target, isOld ? status.st_mode & 0600 : everybody, this->Temporary);
  if (this->Descriptor < 0)
  {
    error = ExplainWriteError(errno, this->Target);
    return false;
  }
  this->IsThere = true;
  this->IsInPlace = isOld && !CopyPermissions(this->Descriptor, status);
  return true;
}

void FileReplacement::Write(const void* data, std::size_t size)
{
  this->Size += size;
  this->Buffer.append(static_cast<const char*>(data), size);
  if (this->Buffer.size() >= BufferSize)
  {
    this->Flush();
  }
}

void FileReplacement::Flush()
{
  if (this->Failure == 0)
  {
    this->Failure = WriteAll(this->Descriptor, this->Buffer.data(), this->Buffer.size());
  }
  this->Buffer.clear();
}

void FileReplacement::WriteAt(std::uint64_t position, const std::string& text)
{
  this->Flush();
  if (this->Failure == 0 && lseek(this->Descriptor, static_cast<off_t>(position), SEEK_SET) < 0)
  {
    this->Failure = errno;
  }
  if (this->Failure == 0)
  {
    this->Failure = WriteAll(this->Descriptor, text.data(), text.size());
  }
  if (this->Failure == 0 && lseek(this->Descriptor, 0, SEEK_END) < 0)
  {
    this->Failure = errno;
  }
}

bool FileReplacement::Finish(std::string& error)
{
  if (this->Descriptor >= 0)
  {
    this->Flush();
    // A full disk may not be reported before this call.
    if (this->Failure == 0)
    {
      this->Failure = SyncFile(this->Descriptor);
    }
    if (close(this->Descriptor) != 0 && errno != EINTR && this->Failure == 0)
    {
      this->Failure = errno;
    }
    this->Descriptor = -1;
  }
  if (this->Failure != 0)
  {
    error = ExplainWriteError(this->Failure, this->Target);
    this->Discard();
  }
  return this->Failure == 0;
}

int FileReplacement::CopyInPlace()
{
  const int from = OpenToRead(this->Temporary);
  int failure = from < 0 ? errno : 0;
  const int to = failure ? -1 : OpenFile(this->Target, O_WRONLY | O_TRUNC);
  failure = failure == 0 && to < 0 ? errno : failure;
  std::string buffer(BufferSize, '\0');
  for (ssize_t got = 1; failure == 0 && got != 0;)
  {
    got = read(from, &buffer[0], buffer.size());
    if (got < 0)
    {
      failure = errno == EINTR ? 0 : errno;
    }
    else
    {
      failure = WriteAll(to, buffer.data(), static_cast<std::size_t>(got));
    }
  }
  failure = failure ? failure : SyncFile(to);
  for (const int descriptor : { from, to })
  {
    if (descriptor >= 0)
    {
      close(descriptor);
    }
  }
  return failure;
}

bool FileReplacement::Commit(std::string& error)
{
  if (!this->Finish(error))
  {
    return false;
  }
  if (this->IsInPlace)
  {
    this->Failure = this->CopyInPlace();
    if (this->Failure != 0)
    {
      error = ExplainWriteError(this->Failure, this->Target) + " All of it is in " +
        Printable(this->Temporary) + ".";
      this->IsThere = false; // the destructor keeps the file
      return false;
    }
    this->Discard();
    return true;
  }
  if (rename(this->Temporary.c_str(), this->Target.c_str()) != 0)
  {
    error = ExplainWriteError(errno, this->Target);
    this->Discard();
    return false;
  }
  this->IsThere = false;
  this->Failure = SyncFolder(this->Target);
  if (this->Failure != 0)
  {
    error = ExplainWriteError(this->Failure, this->Target);
  }
  return this->Failure == 0;
}

} // namespace VolumeHaptics
