// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * A node under /dev in umockdev's simulated kernel, from plugging in its device to unplugging it.
 * Open files may exist longer: keep this object until they are closed.
 *
 * A FIFO in packet mode replaces the node for data to programs: each write becomes one read, poll()
 * works as on a device, and data that are not read in time are dropped, as in the kernel.
 * umockdev's own thread answers the writes and ioctls of programs.
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
  /** The node's answers to a program's calls. Results are nonnegative, or -errno. */
  struct Answers
  {
    unsigned IoctlType; ///< type in _IOC() of the ioctls that are handled
    int GoneResult;     ///< result of reads and writes after unplugging; ioctls return -ENODEV
    std::function<int(const std::uint8_t* bytes, std::size_t size)> Write;
    std::function<int(UMockdevIoctlClient* client, unsigned long request)> Ioctl;
  };

  /**
   * The device's udev entries in umockdev's format, and the paths of its devices, innermost first.
   */
  struct Device
  {
    std::string Entries;
    std::vector<std::string> SysPaths;
  };

  /**
   * Plugs a device in.
   * @param node path that programs see, such as /dev/hidraw8
   */
  FifoNode(const std::string& node, const Device& device, const Answers& answers);
  ~FifoNode();
  FifoNode(const FifoNode&) = delete;
  FifoNode& operator=(const FifoNode&) = delete;

  /** Unplugs the device. From then on, calls on open files fail. */
  void Unplug();
  /**
   * Sends data to the reading program. Any thread may call it. The data are lost if the FIFO is
   * full.
   */
  void Send(const void* bytes, std::size_t size);

  const std::string& GetNode() const { return this->Node; }
  /** Sets the permissions of the node, such as 0000. */
  void SetPermissions(unsigned mode);

  /**
   * Calls `answer` with the memory that the client's ioctl argument points to. Returns its result.
   */
  static int WithTarget(UMockdevIoctlClient* client, std::size_t size,
    const std::function<int(std::uint8_t* bytes)>& answer);

private:
  static gboolean OnIoctl(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer node);
  static gboolean OnWrite(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer node);
  static gboolean OnRead(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer node);

  const std::string Node;
  const std::string Root; ///< root folder of the simulated file system
  const std::vector<std::string> SysPaths;
  const Answers Answer;
  UMockdevIoctlBase* const Base;
  int Fifo = -1;
  std::atomic<bool> IsGone{ false };
};

} // namespace emulated

#endif
