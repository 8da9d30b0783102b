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
 * on the disk. So a file that is there stays as it is until then, whatever happens. Its owner and
 * permissions stay as well; a file whose group this user may not give to a new one is written in
 * place at the end.
 */
class FileReplacement
{
public:
  FileReplacement() = default;
  /** Removes what was not committed. */
  ~FileReplacement();
  FileReplacement(const FileReplacement&) = delete;
  FileReplacement& operator=(const FileReplacement&) = delete;

  bool Open(const std::string& file, std::string& error);
  ///@{
  /** Errors are kept for Commit. */
  void Write(const void* data, std::size_t size);
  void Write(const std::string& text) { this->Write(text.data(), text.size()); }
  /** Over what was written before. */
  void WriteAt(std::uint64_t position, const std::string& text);
  ///@}
  std::uint64_t GetSize() const { return this->Size; }
  bool HasFailed() const { return this->Failure != 0; }
  /**
   * Takes all of it to the disk, without giving it its name; false as for Commit, which does it
   * if it was not called.
   */
  bool Finish(std::string& error);
  /**
   * False, with the reason and the cure, if anything could not be written; the file is then as it
   * was.
   */
  bool Commit(std::string& error);

private:
  void Flush();
  void Discard();
  /** Copies the temporary file into the one that is there; 0, or the errno. */
  int CopyInPlace();

  std::string Target;
  std::string Temporary;
  std::string Buffer;
  std::uint64_t Size = 0;
  int Descriptor = -1;
  bool IsThere = false; ///< the temporary file
  bool IsInPlace = false;
  int Failure = 0; ///< the errno of the first error
};

} // namespace VolumeHaptics

#endif
