// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Writes a file completely or not at all.
 */
#ifndef FileReplacement_h
#define FileReplacement_h

#include <cstddef>
#include <cstdint>
#include <string>

namespace VolumeHaptics
{

/**
 * Writes a file under a temporary name in the same folder, and renames it when it is completely on
 * the disk. Until then, an existing file stays unchanged, even after a crash. Its owner and
 * permissions are kept. If this user may not give the file's group to a new file, the existing file
 * is overwritten at the end.
 */
class FileReplacement
{
public:
  FileReplacement() = default;
  /** Removes the temporary file, if it exists. */
  ~FileReplacement();
  FileReplacement(const FileReplacement&) = delete;
  FileReplacement& operator=(const FileReplacement&) = delete;

  bool Open(const std::string& file, std::string& error);
  ///@{
  /** Appends bytes. Commit() reports errors. */
  void Write(const void* data, std::size_t size);
  void Write(const std::string& text) { this->Write(text.data(), text.size()); }
  /** Overwrites bytes that were written before. */
  void WriteAt(std::uint64_t position, const std::string& text);
  ///@}
  std::uint64_t GetSize() const { return this->Size; }
  bool HasFailed() const { return this->Failure != 0; }
  /**
   * Writes all bytes to the disk, without renaming the file. Commit() calls this function if
   * needed. Returns false on failure, with an error as Commit() does.
   */
  bool Finish(std::string& error);
  /**
   * Replaces the file: renames the temporary file, or copies it over the existing file if the
   * file's group could not be kept. On failure, returns false, with the reason and the remedy in
   * `error`. The existing file is then unchanged, except after a failed copy, when it may be
   * incomplete. In that case, the temporary file is kept, and the error names it.
   */
  bool Commit(std::string& error);

private:
  void Flush();
  void Discard();
  /** Copies the temporary file into the existing file. Returns 0, or the errno of the failure. */
  int CopyInPlace();

  std::string Target;
  std::string Temporary;
  std::string Buffer;
  std::uint64_t Size = 0;
  int Descriptor = -1;
  bool IsThere = false; ///< whether the temporary file exists
  bool IsInPlace = false;
  int Failure = 0; ///< errno of the first error
};

} // namespace VolumeHaptics

#endif
