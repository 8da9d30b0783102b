// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Realtime/RealtimeKit.h"

#if defined(__linux__)
#include "Core/Realtime/ServoClock.h"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <dlfcn.h>
#include <sys/resource.h>
#include <type_traits>
#endif

namespace VolumeHaptics
{
namespace RealtimeKit
{

#if defined(__linux__)

namespace
{

constexpr const char* Service = "org.freedesktop.RealtimeKit1";
constexpr const char* Path = "/org/freedesktop/RealtimeKit1";
constexpr const char* BusService = "org.freedesktop.DBus";
constexpr const char* BusPath = "/org/freedesktop/DBus";

/** Longest time (ns) to wait for one answer, and the interval (ms) at which `stop` is polled. */
constexpr std::int64_t LongestWait = 10000000000;
constexpr int LookPeriod = 10;
constexpr int NoTimeLimit = 0x7fffffff;
/**
 * Largest priority to request. It is below the kernel's interrupt threads (50), so that these run
 * first.
 */
constexpr std::int64_t HighestPriority = 40;
/**
 * Shortest limit (us) of a thread's computing time for which a real-time class is requested. A
 * shorter limit would do more harm than the class does good.
 */
constexpr std::int64_t LeastTime = 20000;

/** Types of arguments in messages, as letters of D-Bus signatures. */
constexpr int None = 0;
constexpr int Text = 's';
constexpr int Variant = 'v';
constexpr int Int32 = 'i';
constexpr int Int64 = 'x';
constexpr int UInt32 = 'u';
constexpr int UInt64 = 't';
/** Message type of a reply to a call. */
constexpr int MethodReturn = 2;

struct Connection;
struct Message;
struct PendingCall;
/** An object large enough for a DBusMessageIter, whose members are private. */
struct Iterator
{
  alignas(std::max_align_t) unsigned char Memory[256];
};

/**
 * The libdbus functions that this file calls, with the names and types of its public interface.
 */
struct Library
{
  Connection* (*Open)(const char* address, void* error) = nullptr;
  void (*Close)(Connection*) = nullptr;
  void (*ReleaseConnection)(Connection*) = nullptr;
  void (*ChangeSigpipe)(unsigned) = nullptr;
  unsigned (*Send)(Connection*, Message*, PendingCall**, int timeout) = nullptr;
  unsigned (*Dispatch)(Connection*, int timeout) = nullptr;
  unsigned (*IsCompleted)(PendingCall*) = nullptr;
  Message* (*ReceiveReply)(PendingCall*) = nullptr;
  void (*Cancel)(PendingCall*) = nullptr;
  void (*ReleaseCall)(PendingCall*) = nullptr;
  Message* (*NewCall)(
    const char* service, const char* path, const char* interface, const char* method) = nullptr;
  unsigned (*Append)(Message*, int type, ...) = nullptr;
  int (*GetType)(Message*) = nullptr;
  const char* (*GetErrorName)(Message*) = nullptr;
  unsigned (*Begin)(Message*, Iterator*) = nullptr;
  int (*GetArgumentType)(Iterator*) = nullptr;
  void (*Enter)(Iterator*, Iterator* inner) = nullptr;
  void (*GetValue)(Iterator*, void* value) = nullptr;
  void (*ReleaseMessage)(Message*) = nullptr;

  /** Returns the functions, or null if libdbus is not installed or lacks one of them. */
  static const Library* Get() noexcept
  {
    static Library functions;
    static const bool loaded = functions.Load();
    return loaded ? &functions : nullptr;
  }

private:
  bool Load() noexcept
  {
    void* const library = dlopen("libdbus-1.so.3", RTLD_NOW | RTLD_LOCAL); // is never unloaded
    const auto find = [library](auto& function, const char* name)
    {
      function = reinterpret_cast<std::decay_t<decltype(function)>>(dlsym(library, name));
      return function != nullptr;
    };
    return library && find(this->Open, "dbus_connection_open_private") &&
      find(this->Close, "dbus_connection_close") &&
      find(this->ReleaseConnection, "dbus_connection_unref") &&
      find(this->ChangeSigpipe, "dbus_connection_set_change_sigpipe") &&
      find(this->Send, "dbus_connection_send_with_reply") &&
      find(this->Dispatch, "dbus_connection_read_write_dispatch") &&
      find(this->IsCompleted, "dbus_pending_call_get_completed") &&
      find(this->ReceiveReply, "dbus_pending_call_steal_reply") &&
      find(this->Cancel, "dbus_pending_call_cancel") &&
      find(this->ReleaseCall, "dbus_pending_call_unref") &&
      find(this->NewCall, "dbus_message_new_method_call") &&
      find(this->Append, "dbus_message_append_args") &&
      find(this->GetType, "dbus_message_get_type") &&
      find(this->GetErrorName, "dbus_message_get_error_name") &&
      find(this->Begin, "dbus_message_iter_init") &&
      find(this->GetArgumentType, "dbus_message_iter_get_arg_type") &&
      find(this->Enter, "dbus_message_iter_recurse") &&
      find(this->GetValue, "dbus_message_iter_get_basic") &&
      find(this->ReleaseMessage, "dbus_message_unref");
  }
};

/** The reply to a call. Empty if none came in time. */
class Reply
{
public:
  Reply(const Library& library, Message* message)
    : Functions(library)
    , Content(message)
  {
  }
  ~Reply()
  {
    if (this->Content)
    {
      this->Functions.ReleaseMessage(this->Content);
    }
  }
  Reply(const Reply&) = delete;
  Reply& operator=(const Reply&) = delete;

  bool Returned() const
  {
    return this->Content && this->Functions.GetType(this->Content) == MethodReturn;
  }

  /** Returns whether the bus replied that the service does not exist. */
  bool IsAbsent() const
  {
    const char* const name = this->Content ? this->Functions.GetErrorName(this->Content) : nullptr;
    for (const char* const absence : { "org.freedesktop.DBus.Error.ServiceUnknown",
           "org.freedesktop.DBus.Error.NameHasNoOwner", "org.freedesktop.DBus.Error.Spawn." })
    {
      if (name && std::strncmp(name, absence, std::strlen(absence)) == 0)
      {
        return true;
      }
    }
    return false;
  }

  /** Returns the number in a property's variant, or 0 if there is none. */
  std::int64_t GetNumber() const
  {
    Iterator outer;
    Iterator inner;
    if (!this->Returned() || !this->Functions.Begin(this->Content, &outer) ||
      this->Functions.GetArgumentType(&outer) != Variant)
    {
      return 0;
    }
    this->Functions.Enter(&outer, &inner);
    std::int32_t small = 0;
    std::int64_t large = 0;
    switch (this->Functions.GetArgumentType(&inner))
    {
      case Int32:
        this->Functions.GetValue(&inner, &small);
        return small;
      case Int64:
        this->Functions.GetValue(&inner, &large);
        return large;
      default:
        return 0;
    }
  }

private:
  const Library& Functions;
  Message* const Content;
};

/** A connection to the bus. All waits end when `stop` is set. */
class Bus
{
public:
  Bus(const Library& library, const char* address, const std::atomic<bool>& stop)
    : Functions(library)
    , Stop(stop)
  {
    library.ChangeSigpipe(0); // keeps libdbus from changing SIGPIPE, which belongs to the program
    this->Wire = library.Open(address, nullptr);
  }
  ~Bus()
  {
    if (this->Wire)
    {
      this->Functions.Close(this->Wire);
      this->Functions.ReleaseConnection(this->Wire);
    }
  }
  Bus(const Bus&) = delete;
  Bus& operator=(const Bus&) = delete;

  /** Registers with the bus. Must be the first call. */
  bool SayHello()
  {
    return this->Wire && this->Call(BusService, BusPath, BusService, "Hello").Returned();
  }
  Reply GetProperty(const char* name)
  {
    return this->Call(
      Service, Path, "org.freedesktop.DBus.Properties", "Get", Text, &Service, Text, &name);
  }
  Reply MakeRealTime(std::uint64_t thread, std::uint32_t priority)
  {
    return this->Call(
      Service, Path, Service, "MakeThreadRealtime", UInt64, &thread, UInt32, &priority);
  }

private:
  /** Calls a method. `arguments` are pairs of a type and a pointer to the value. */
  template <typename... Arguments>
  Reply Call(const char* service, const char* path, const char* interface, const char* method,
    Arguments... arguments)
  {
    Message* const message = this->Stop.load(std::memory_order_acquire)
      ? nullptr
      : this->Functions.NewCall(service, path, interface, method);
    PendingCall* call = nullptr;
    if (message)
    {
      // Await() limits the time, because libdbus can do so only with a main loop.
      if (this->Functions.Append(message, arguments..., None))
      {
        this->Functions.Send(this->Wire, message, &call, NoTimeLimit);
      }
      this->Functions.ReleaseMessage(message);
    }
    return Reply(this->Functions, call ? this->Await(call) : nullptr);
  }

  Message* Await(PendingCall* call)
  {
    const std::int64_t latest = ServoClock::Now() + LongestWait;
    bool isConnected = true;
    while (!this->Functions.IsCompleted(call) && isConnected && ServoClock::Now() < latest &&
      !this->Stop.load(std::memory_order_acquire))
    {
      isConnected = this->Functions.Dispatch(this->Wire, LookPeriod) != 0;
    }
    Message* reply = nullptr;
    if (this->Functions.IsCompleted(call))
    {
      reply = this->Functions.ReceiveReply(call);
    }
    else
    {
      this->Functions.Cancel(call);
    }
    this->Functions.ReleaseCall(call);
    return reply;
  }

  const Library& Functions;
  const std::atomic<bool>& Stop;
  Connection* Wire = nullptr;
};

/**
 * Sets how long (us) a real-time thread of this process may compute without a pause. Returns false
 * if the system refuses.
 */
bool LimitTime(std::int64_t most) noexcept
{
  rlimit limit{};
  if (getrlimit(RLIMIT_RTTIME, &limit) != 0)
  {
    return false;
  }
  limit.rlim_max = std::min(limit.rlim_max, static_cast<rlim_t>(most));
  limit.rlim_cur = std::min(limit.rlim_cur, limit.rlim_max / 2);
  return setrlimit(RLIMIT_RTTIME, &limit) == 0;
}

} // namespace

Wish ReadEnvironment()
{
  Wish wish;
  const char* const named = std::getenv("VOLUMEHAPTICS_RTKIT");
  wish.IsAsked = !named || std::strcmp(named, "off") != 0;
  const char* const address = std::getenv("DBUS_SYSTEM_BUS_ADDRESS");
  wish.Bus = address ? address : "unix:path=/var/run/dbus/system_bus_socket";
  return wish;
}

Answer MakeRealTime(std::int64_t thread, const Wish& wish, const std::atomic<bool>& stop) noexcept
{
  const Library* const library = wish.IsAsked ? Library::Get() : nullptr;
  if (!library)
  {
    return Answer::Absent;
  }
  Bus bus(*library, wish.Bus.c_str(), stop);
  if (!bus.SayHello())
  {
    return Answer::Absent;
  }
  const Reply time = bus.GetProperty("RTTimeUSecMax");
  if (time.IsAbsent())
  {
    return Answer::Absent;
  }
  const std::int64_t priority =
    std::min(HighestPriority, bus.GetProperty("MaxRealtimePriority").GetNumber());
  const bool granted = time.GetNumber() >= LeastTime && priority > 0 &&
    LimitTime(time.GetNumber()) &&
    bus.MakeRealTime(static_cast<std::uint64_t>(thread), static_cast<std::uint32_t>(priority))
      .Returned();
  return granted ? Answer::Granted : Answer::Refused;
}

#else

Wish ReadEnvironment()
{
  return {};
}

Answer MakeRealTime(std::int64_t, const Wish&, const std::atomic<bool>&) noexcept
{
  return Answer::Absent;
}

#endif

} // namespace RealtimeKit
} // namespace VolumeHaptics
