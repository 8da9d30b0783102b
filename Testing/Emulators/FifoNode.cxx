// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "FifoNode.h"

#include "Testbed.h"

#include <cerrno>
#include <cstring>
#include <stdexcept>

#include <fcntl.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace emulated
{
namespace
{

void Require(bool holds, const char* what)
{
  if (!holds)
  {
    throw std::runtime_error(std::string(what) + ": " + std::strerror(errno));
  }
}

gboolean Complete(UMockdevIoctlClient* client, int result)
{
  umockdev_ioctl_client_complete(client, result < 0 ? -1 : result, result < 0 ? -result : 0);
  return TRUE;
}

std::string RootOfTestbed()
{
  char* const root = umockdev_testbed_get_root_dir(Testbed());
  std::string text = root;
  g_free(root);
  return text;
}

} // namespace

FifoNode::FifoNode(const std::string& node, const Device& device, const Answers& answers)
  : Node(node)
  , Root(RootOfTestbed())
  , SysPaths(device.SysPaths)
  , Answer(answers)
  , Base(umockdev_ioctl_base_new())
{
  g_signal_connect(this->Base, "handle-ioctl", G_CALLBACK(&FifoNode::OnIoctl), this);
  g_signal_connect(this->Base, "handle-write", G_CALLBACK(&FifoNode::OnWrite), this);
  g_signal_connect(this->Base, "handle-read", G_CALLBACK(&FifoNode::OnRead), this);
  Require(umockdev_testbed_add_from_string(Testbed(), device.Entries.c_str(), nullptr), "add");
  const std::string file = this->Root + node;
  unlink(file.c_str());
  Require(mkfifo(file.c_str(), 0666) == 0, "mkfifo");
  // Open the FIFO first and then switch it to packet mode, because it can't be opened in that mode.
  this->Fifo = open(file.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC);
  Require(this->Fifo >= 0 && fcntl(this->Fifo, F_SETFL, O_NONBLOCK | O_DIRECT) == 0, "fifo");
  // Attach the ioctls only now. Until then, the node is a pseudo-terminal: a program that searches
  // for devices may open it, finds it unusable without ioctls, and tries again.
  Require(umockdev_testbed_attach_ioctl(Testbed(), node.c_str(), this->Base, nullptr), "attach");
}

FifoNode::~FifoNode()
{
  this->Unplug();
  close(this->Fifo);
  g_object_unref(this->Base);
}

void FifoNode::Unplug()
{
  if (this->IsGone.exchange(true))
  {
    return;
  }
  // Send several bytes, so that a poll wakes up and its read fails even if earlier reads consume
  // some of the bytes.
  const std::uint8_t byte = 0;
  for (int i = 0; i < 4; ++i)
  {
    this->Send(&byte, 1);
  }
  umockdev_testbed_detach_ioctl(Testbed(), this->Node.c_str(), nullptr);
  for (const std::string& path : this->SysPaths)
  {
    umockdev_testbed_uevent(Testbed(), path.c_str(), "remove");
    umockdev_testbed_remove_device(Testbed(), path.c_str());
  }
  unlink((this->Root + this->Node).c_str());
}

void FifoNode::Send(const void* bytes, std::size_t size)
{
  [[maybe_unused]] const auto written = write(this->Fifo, bytes, size);
}

void FifoNode::SetPermissions(unsigned mode)
{
  chmod((this->Root + this->Node).c_str(), mode);
  // Give all users access to the folders and to the socket of the node.
  chmod(this->Root.c_str(), 0777);
  const std::string socket = this->Root + "/ioctl" + this->Node;
  for (std::size_t end = this->Root.size(); end != std::string::npos;)
  {
    end = socket.find('/', end + 1);
    chmod(socket.substr(0, end).c_str(), 0777);
  }
}

int FifoNode::WithTarget(UMockdevIoctlClient* client, std::size_t size,
  const std::function<int(std::uint8_t* bytes)>& answer)
{
  UMockdevIoctlData* const target =
    umockdev_ioctl_data_resolve(umockdev_ioctl_client_get_arg(client), 0, size, nullptr);
  if (target == nullptr)
  {
    return -EIO; // the program has ended
  }
  const int result = answer(target->data);
  g_object_unref(target);
  return result;
}

gboolean FifoNode::OnIoctl(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer node)
{
  const FifoNode& self = *static_cast<FifoNode*>(node);
  const unsigned long request = umockdev_ioctl_client_get_request(client);
  if (_IOC_TYPE(request) != self.Answer.IoctlType)
  {
    return FALSE;
  }
  return Complete(client, self.IsGone ? -ENODEV : self.Answer.Ioctl(client, request));
}

gboolean FifoNode::OnWrite(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer node)
{
  const FifoNode& self = *static_cast<FifoNode*>(node);
  const UMockdevIoctlData* const bytes = umockdev_ioctl_client_get_arg(client);
  return Complete(
    client, self.IsGone ? self.Answer.GoneResult : self.Answer.Write(bytes->data, bytes->data_len));
}

gboolean FifoNode::OnRead(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer node)
{
  const FifoNode& self = *static_cast<FifoNode*>(node);
  // Leave the read unhandled, so that the kernel reads from the FIFO.
  return self.IsGone ? Complete(client, self.Answer.GoneResult) : FALSE;
}

} // namespace emulated
