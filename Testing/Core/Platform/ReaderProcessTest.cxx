// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests the limits of the process that reads files. Here, this process replies with the limits that
 * are set while it reads. The test formats the bytes of requests and answers itself.
 */

#include "Core/Platform/ReaderProcess.h"
#include "Rigs/TemporaryFolder.h"

#include <gtest/gtest.h>

#if !defined(_WIN32)
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

using VolumeHaptics::ReadTask;

void vtkHapticServeReading(int) {} // replaces the module's function, which is not linked here

namespace
{
struct Limits
{
  std::uint64_t Bytes = 0;
  std::uint64_t Seconds = 0;
};

std::string TellLimits(ReadTask, const std::string&, const std::string&)
{
  rlimit memory = {};
  getrlimit(RLIMIT_DATA, &memory);
  const Limits limits{ memory.rlim_cur, alarm(0) };
  return std::string(reinterpret_cast<const char*>(&limits), sizeof(limits));
}

class Reader : public testing::Test
{
protected:
  Reader() { std::filesystem::create_directories(this->Folder); }
  ~Reader() override { std::filesystem::remove_all(this->Folder); }

  /// Writes a sparse file with a size in bytes. Returns its path.
  std::string Write(const std::string& name, std::uintmax_t size) const
  {
    const std::string path = this->Folder + "/" + name;
    std::ofstream file(path);
    file.close();
    std::filesystem::resize_file(path, size);
    return path;
  }

  /// Returns the limits that a new process sets for a task. `own` is the limit (bytes) that the
  /// process had before, or 0 for none.
  static Limits Ask(
    ReadTask task, const std::string& path, rlim_t own = 0, std::uint64_t unpacked = 0)
  {
    int links[2];
    Limits limits;
    EXPECT_EQ(socketpair(AF_UNIX, SOCK_STREAM, 0, links), 0);
    const pid_t process = fork();
    if (process == 0)
    {
      close(links[0]);
      rlimit memory = {};
      getrlimit(RLIMIT_DATA, &memory);
      memory.rlim_cur = own > 0 ? own : memory.rlim_cur;
      setrlimit(RLIMIT_DATA, &memory);
      VolumeHaptics::ServeReading(links[1], TellLimits);
      _exit(0);
    }
    close(links[1]);
    const std::uint32_t head[4] = { static_cast<std::uint32_t>(task), 0,
      static_cast<std::uint32_t>(path.size()), 0 };
    std::string request(reinterpret_cast<const char*>(head), sizeof(head));
    request.append(reinterpret_cast<const char*>(&unpacked), sizeof(unpacked));
    request += path;
    EXPECT_EQ(write(links[0], request.data(), request.size()), ssize_t(request.size()));
    char answer[1 + 2 * sizeof(std::uint64_t) + sizeof(limits)];
    EXPECT_EQ(recv(links[0], answer, sizeof(answer), MSG_WAITALL), ssize_t(sizeof(answer)));
    std::memcpy(&limits, answer + sizeof(answer) - sizeof(limits), sizeof(limits));
    close(links[0]);
    EXPECT_EQ(waitpid(process, nullptr, 0), process);
    return limits;
  }

  const std::string Folder = TemporaryPath("reader");
};

constexpr std::uint64_t gibibyte = std::uint64_t{ 1 } << 30;
} // namespace

TEST_F(Reader, OfASmallFileDoesNotCountWhatLiesBesideIt)
{
  const std::string path = this->Write("small.vtk", 300);
  this->Write("large.bin", 50 * gibibyte);
  const Limits limits = Ask(ReadTask::Grid, path);
  EXPECT_LE(limits.Seconds, 121);
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__) // sanitizers reserve terabytes
  EXPECT_LE(limits.Bytes, 5 * gibibyte);
#endif
}

TEST_F(Reader, OfACaseLeavesRoomForWhatIsElsewhere)
{
  const Limits limits = Ask(ReadTask::Case, this->Write("run.case", 300));
  const std::uint64_t pages = static_cast<std::uint64_t>(sysconf(_SC_PHYS_PAGES));
  EXPECT_GE(limits.Seconds, 3590);
  EXPECT_GE(limits.Bytes, pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE)) / 2);
}

TEST_F(Reader, OfAFolderLeavesRoomForItsFiles)
{
  EXPECT_GE(Ask(ReadTask::Tiff, this->Folder).Seconds, 3590);
}

TEST_F(Reader, LeavesRoomForWhatASmallFileUnpacksTo)
{
  const std::string path = this->Write("zeros.tif", 300);
  const Limits limits = Ask(ReadTask::TiffBox, path, 0, 2 * gibibyte);
  EXPECT_GE(limits.Seconds, 8000);           // enough to unpack 2 GiB at 256 KiB/s
  EXPECT_GE(limits.Bytes, 2 * 2 * gibibyte); // room for the unpacked page and the answer
}

TEST_F(Reader, OfAFileOfHolesHasAnEnd)
{
  const Limits limits = Ask(ReadTask::Surface, this->Write("holes.stl", 8ULL << 40));
  EXPECT_GT(limits.Seconds, 3600);
  EXPECT_LT(limits.Seconds, 60 * 24 * 3600);
}

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
TEST_F(Reader, KeepsTheLimitThatAUserHasSet)
{
  const std::string path = this->Write("small.stl", 300);
  EXPECT_EQ(Ask(ReadTask::Surface, path, gibibyte / 2).Bytes, gibibyte / 2);
}
#endif
#endif
