// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Platform/FileReplacement.h"

#include "Core/Platform/Files.h"
#include "Core/Platform/HapticFiles.h"

#include <cerrno>

namespace VolumeHaptics
{
namespace
{

constexpr std::size_t BufferSize = 1 << 16;

} // namespace

FileReplacement::~FileReplacement()
{
  this->Discard();
}

void FileReplacement::Discard()
{
  if (this->Descriptor >= 0)
  {
    Files::Close(this->Descriptor);
    this->Descriptor = -1;
  }
  if (this->IsThere)
  {
    Files::Remove(this->Temporary);
    this->IsThere = false;
  }
}

bool FileReplacement::Open(const std::string& file, std::string& error)
{
  if (!CheckWritable(file, error))
  {
    return false;
  }
  this->Target = Files::ResolveLinks(file);
  Files::Status status;
  const bool isOld = Files::GetStatus(this->Target, status);
  constexpr Files::Mode everybody = 0666; // the user's mask removes some of these
  this->Descriptor =
    Files::CreateBeside(this->Target, isOld ? status.st_mode & 0600 : everybody, this->Temporary);
  if (this->Descriptor < 0)
  {
    error = ExplainWriteError(errno, this->Target);
    return false;
  }
  this->IsThere = true;
  this->IsInPlace = isOld && !Files::CopyPermissions(this->Descriptor, status);
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
  if (this->Failure == 0 && !Files::Seek(this->Descriptor, static_cast<std::int64_t>(position)))
  {
    this->Failure = errno;
  }
  if (this->Failure == 0)
  {
    this->Failure = WriteAll(this->Descriptor, text.data(), text.size());
  }
  if (this->Failure == 0 && !Files::SeekEnd(this->Descriptor))
  {
    this->Failure = errno;
  }
}

bool FileReplacement::Finish(std::string& error)
{
  if (this->Descriptor >= 0)
  {
    this->Flush();
    // Only this call may report that the disk is full.
    if (this->Failure == 0)
    {
      this->Failure = Files::Sync(this->Descriptor);
    }
    if (!Files::CloseWritten(this->Descriptor) && this->Failure == 0)
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
  const int from = Files::Open(this->Temporary, Files::For::Reading);
  int failure = from < 0 ? errno : 0;
  const int to = failure ? -1 : Files::Open(this->Target, Files::For::Writing);
  failure = failure == 0 && to < 0 ? errno : failure;
  std::string buffer(BufferSize, '\0');
  for (std::int64_t got = 1; failure == 0 && got != 0;)
  {
    got = Files::Read(from, &buffer[0], buffer.size());
    if (got < 0)
    {
      failure = errno == EINTR ? 0 : errno;
    }
    else
    {
      failure = WriteAll(to, buffer.data(), static_cast<std::size_t>(got));
    }
  }
  failure = failure ? failure : Files::Sync(to);
  for (const int descriptor : { from, to })
  {
    if (descriptor >= 0)
    {
      Files::Close(descriptor);
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
  if (!Files::Rename(this->Temporary, this->Target))
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
