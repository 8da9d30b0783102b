// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * A node under /dev in the kernel that umockdev plays, from when its device is plugged in until it
 * is unplugged. Open files of it may outlast that: keep the node until they are closed.
 *
 * Data to programs come through a FIFO in packet mode in the place of the node: one write is one
 * read, poll() tells the truth, and what is not read in time is dropped, as by the kernel. Writes
 * and ioctls of programs are answered on umockdev's own thread.
 */
#ifndef FifoNode_h
#define FifoNode_h

#include <umockdev.h>

#include <atomic>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace emulated
{

class FifoNode
{
public:
  /** How a program's calls are answered; results are 0 or more, or -errno. */
  struct Answers
  {
    unsigned IoctlType; ///< of _IOC(); others are not handled
    int GoneResult;     ///< of reads and writes after it was unplugged; ioctls have -ENODEV
    std::function<int(const std::uint8_t* bytes, std::size_t size)> Write;
    std::function<int(UMockdevIoctlClient* client, unsigned long request)> Ioctl;
  };

  /** The entries of udev as umockdev reads them, and their devices, the innermost first. */
  struct Device
  {
    std::string Entries;
    std::vector<std::string> SysPaths;
  };

  /** Plugs it in; `node` is as programs see it, such as /dev/hidraw8. */
  FifoNode(const std::string& node, const Device& device, const Answers& answers);
  ~FifoNode();
  FifoNode(const FifoNode&) = delete;
  FifoNode& operator=(const FifoNode&) = delete;

  /** Calls of open files fail from then on. */
  void Unplug();
  /** From any thread: to the program that reads. If the FIFO is full, it is lost. */
  void Send(const void* bytes, std::size_t size);

  const std::string& GetNode() const { return this->Node; }
  /** The mode of the node, such as 0000. */
  void SetPermissions(unsigned mode);

  /**
   * Calls `answer` with what the argument of a client's ioctl points to, and returns its result.
   */
  static int WithTarget(UMockdevIoctlClient* client, std::size_t size,
    const std::function<int(std::uint8_t* bytes)>& answer);

private:
  static gboolean OnIoctl(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer node);
  static gboolean OnWrite(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer node);
  static gboolean OnRead(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer node);

  const std::string Node;
  const std::string Root; ///< of the played file system
  const std::vector<std::string> SysPaths;
  const Answers Answer;
  UMockdevIoctlBase* const Base;
  int Fifo = -1;
  std::atomic<bool> IsGone{ false };
};

} // namespace emulated

#endif
