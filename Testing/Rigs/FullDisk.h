// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Simulates a full disk: beyond RLIMIT_FSIZE, write(2) fails with EFBIG, as it fails with ENOSPC on
 * a full disk (setrlimit(2), SIGXFSZ in signal(7)).
 */
#ifndef FullDisk_h
#define FullDisk_h

#include <csignal>
#include <sys/resource.h>

namespace devicetest
{

/// Limits the size (bytes) of files that this process writes, during the object's lifetime.
class FullDisk
{
public:
  explicit FullDisk(rlim_t bytes)
  {
    this->Before = std::signal(SIGXFSZ, SIG_IGN);
    getrlimit(RLIMIT_FSIZE, &this->Limit);
    const rlimit limit{ bytes, this->Limit.rlim_max };
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FullDisk()
  {
    setrlimit(RLIMIT_FSIZE, &this->Limit);
    std::signal(SIGXFSZ, this->Before);
  }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;

private:
  rlimit Limit;
  void (*Before)(int);
};

} // namespace devicetest

#endif
