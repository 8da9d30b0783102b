// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * A node under /dev in the kernel that umockdev simulates, from plugging in its device to
 * unplugging it. Open files may live longer: keep this object until they are closed.
 *
 * A FIFO in packet mode takes the node's place for data to programs: each write is one read, poll()
 * works as on a device, and data that are not read in time are dropped, as by the kernel.
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
  /** The node's answers to a program's calls. Results are 0 or more, or -errno. */
  struct Answers
  {
    unsigned IoctlType; ///< type in _IOC() of the handled ioctls
    int GoneResult;     ///< result of reads and writes after unplugging; ioctls return -ENODEV
    std::function<int(const std::uint8_t* bytes, std::size_t size)> Write;
    std::function<int(UMockdevIoctlClient* client, unsigned long request)> Ioctl;
  };

  /**
   * The device's entries in umockdev's format for udev, and the paths of its devices, the innermost
   * first.
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

  /** Unplugs the device. From then on, calls of open files fail. */
  void Unplug();
  /**
   * Sends data to the reading program. Any thread may call it. The data are lost if the FIFO is
   * full.
   */
  void Send(const void* bytes, std::size_t size);

  const std::string& GetNode() const { return this->Node; }
  /** Sets the permissions of the node, such as 0000. */
  void SetPermissions(unsigned mode);

  /** Calls `answer` with the target of the client's ioctl argument. Returns its result. */
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
