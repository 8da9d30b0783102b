// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Files that are written whole or not at all, files that are read without hanging, and how errors
 * name them.
 */
#ifndef HapticFiles_h
#define HapticFiles_h

#include <cstddef>
#include <cstdint>
#include <string>

#include <sys/stat.h>

namespace VolumeHaptics
{

/**
 * A text for a message. Names of files may hold any bytes; those that are not UTF-8 become \xNN,
 * since Python drops a message that is not UTF-8.
 */
std::string Printable(const std::string& text);

/** The name of a file that stays right when the program changes its folder. */
std::string MakeAbsolute(const std::string& file);

/** The folder of a file, "." where its name has none. */
std::string GetFolder(const std::string& file);

/** Says why a file can't be written, and the cure, from an errno. */
std::string ExplainWriteError(int number, const std::string& file);

/**
 * False, with the reason and the cure, where a file can't be written, as far as that shows before
 * it is.
 */
bool CheckWritable(const std::string& file, std::string& error);

/** Text of an errno. */
std::string DescribeError(int number);

///@{
/**
 * open(2) and fsync(2), again where a signal interrupted them. A file system that has no fsync is
 * no error.
 */
int OpenFile(const std::string& file, int flags, mode_t mode = 0);
int SyncFile(int descriptor);
///@}
/** Takes the names in the folder of a file to the disk; 0, or the errno. */
int SyncFolder(const std::string& file);

/** Where links lead to, also where nothing is there yet. */
std::string FollowLinks(const std::string& file);

/** Whether a name stands for the file that is open. */
bool IsSameFile(int descriptor, const std::string& file);

/**
 * Gives a new file the owner, the group and the permissions of another one, as far as the system
 * allows. False where the group is another one; that one then gets no permissions.
 */
bool TakePermissions(int descriptor, const struct stat& other);

/**
 * False, with what it is instead, for everything but regular files: to read a FIFO or a terminal
 * may take for ever.
 */
bool CheckRegular(const std::string& file, std::string& error);

/** Reads a regular file of at most so many bytes; else false, with the reason and the cure. */
bool ReadSmallFile(
  const std::string& file, std::size_t most, std::string& text, std::string& error);

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
   * where it was not.
   */
  bool Finish(std::string& error);
  /**
   * False, with the reason and the cure, where anything could not be written; the file is then as
   * it was.
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

/** Writes all of it; 0, or the errno of what went wrong. */
int WriteAll(int descriptor, const void* data, std::size_t size);

} // namespace VolumeHaptics

#endif
