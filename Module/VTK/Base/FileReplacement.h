// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A file that is written whole or not at all.
 */
#ifndef FileReplacement_h
#define FileReplacement_h

#include <cstddef>
#include <cstdint>
#include <string>

namespace VolumeHaptics
{

/**
 * Writes a file under another name in the same folder, and gives it its own name when all of it is
 * on the disk. So an existing file stays unchanged until then, whatever happens. Its owner and
 * permissions stay as well. If this user may not give the file's group to a new one, the existing
 * file is overwritten at the end.
 */
class FileReplacement
{
public:
  FileReplacement() = default;
  /** Removes the temporary file, unless it was committed. */
  ~FileReplacement();
  FileReplacement(const FileReplacement&) = delete;
  FileReplacement& operator=(const FileReplacement&) = delete;

  bool Open(const std::string& file, std::string& error);
  ///@{
  /** Errors are kept for Commit. */
  void Write(const void* data, std::size_t size);
  void Write(const std::string& text) { this->Write(text.data(), text.size()); }
  /** Overwrites bytes that were written before. */
  void WriteAt(std::uint64_t position, const std::string& text);
  ///@}
  std::uint64_t GetSize() const { return this->Size; }
  bool HasFailed() const { return this->Failure != 0; }
  /**
   * Writes all of it to the disk, without giving it its name. False as for Commit, which calls it
   * if needed.
   */
  bool Finish(std::string& error);
  /**
   * False, with the reason and the cure, if anything could not be written; an existing file is then
   * unchanged.
   */
  bool Commit(std::string& error);

private:
  void Flush();
  void Discard();
  /** Copies the temporary file into the existing one. Returns 0, or the errno. */
  int CopyInPlace();

  std::string Target;
  std::string Temporary;
  std::string Buffer;
  std::uint64_t Size = 0;
  int Descriptor = -1;
  bool IsThere = false; ///< the temporary file exists
  bool IsInPlace = false;
  int Failure = 0; ///< the errno of the first error
};

} // namespace VolumeHaptics

#endif
