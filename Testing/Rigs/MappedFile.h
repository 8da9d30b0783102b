// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Maps a file into memory, and reads the kernel's information about it: mincore(2), VmLck of
 * /proc/self/status, and Locked of /proc/self/smaps.
 */
#ifndef MappedFile_h
#define MappedFile_h

#include <gtest/gtest.h>

#include <cinttypes>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

#include <sys/mman.h>
#include <unistd.h>

namespace servotest
{
/// Whether memory can be locked. The sanitizers disable mlock().
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool CanLock = false;
#else
constexpr bool CanLock = true;
#endif

inline const std::size_t PageSize = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));

/// Returns the number of bytes that this process has locked in memory.
inline std::size_t LockedBytes()
{
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
  {
    if (line.compare(0, 6, "VmLck:") == 0)
    {
      return 1024 * std::stoul(line.substr(6));
    }
  }
  ADD_FAILURE() << "no VmLck";
  return 0;
}

/// A mapped sparse file, which takes no space on the disk.
class MappedFile
{
public:
  explicit MappedFile(std::size_t size)
    : Size(size)
  {
    std::string name = testing::TempDir() + "MappedXXXXXX";
    const int file = mkstemp(name.data());
    EXPECT_EQ(ftruncate(file, static_cast<off_t>(size)), 0);
    this->Begin = mmap(nullptr, size, PROT_READ, MAP_SHARED, file, 0);
    EXPECT_NE(this->Begin, MAP_FAILED);
    close(file);
    unlink(name.c_str());
  }
  ~MappedFile() { munmap(this->Begin, this->Size); }

  /// Returns how many bytes of the file are in memory.
  std::size_t Resident() const
  {
    std::vector<unsigned char> pages(this->Size / PageSize);
    EXPECT_EQ(mincore(this->Begin, this->Size, pages.data()), 0);
    std::size_t resident = 0;
    for (const unsigned char page : pages)
    {
      resident += page & 1;
    }
    return resident * PageSize;
  }

  /// Returns how many bytes of the file are locked, according to the file's rows in
  /// /proc/self/smaps.
  std::size_t Locked() const
  {
    const auto begin = reinterpret_cast<std::uintptr_t>(this->Begin);
    std::ifstream maps("/proc/self/smaps");
    bool isOurs = false;
    std::size_t locked = 0;
    for (std::string line; std::getline(maps, line);)
    {
      std::uintptr_t first = 0;
      std::uintptr_t end = 0;
      std::size_t kib = 0;
      if (std::sscanf(line.c_str(), "%" SCNxPTR "-%" SCNxPTR " ", &first, &end) == 2)
      {
        isOurs = first >= begin && end <= begin + this->Size;
      }
      else if (isOurs && std::sscanf(line.c_str(), "Locked: %zu kB", &kib) == 1)
      {
        locked += 1024 * kib;
      }
    }
    return locked;
  }

  const std::size_t Size;
  void* Begin = nullptr;
};
} // namespace servotest

#endif
