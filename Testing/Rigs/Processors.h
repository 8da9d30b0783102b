// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Lists the processors on which the calling thread may run. Linux only.
 */
#ifndef Processors_h
#define Processors_h

#include <sched.h>

namespace devicetest
{
/// Reads the thread's processors. Returns true if there are at least two, and the kernel lets the
/// thread choose among them.
inline bool MayChooseProcessor(cpu_set_t& processors)
{
  return sched_getaffinity(0, sizeof(processors), &processors) == 0 && CPU_COUNT(&processors) > 1 &&
    sched_setaffinity(0, sizeof(processors), &processors) == 0;
}
} // namespace devicetest

#endif
