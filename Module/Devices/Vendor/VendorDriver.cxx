// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/Vendor/VendorDriver.h"

#include "Core/Platform/Libraries.h"
#include "Core/Platform/OwnFile.h"
#include "Core/Realtime/ServoClock.h"
#include "Devices/Common/DeviceTexts.h"
#include "Devices/Vendor/VendorFolder.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <map>

namespace VolumeHaptics
{
namespace
{

constexpr int MostDevices = 64;

bool IsWhole(const VolumeHapticsVendorPlugin& table)
{
  return table.Count && table.Describe && table.Open && table.GetLimits && table.GetSerial &&
    table.Read && table.Write && table.LastError && table.Close;
}

/**
 * Loads the function table of the plug-in in a file. On failure, returns null and writes the reason
 * and the cure to `error`. Even a refused library stays loaded, because the vendor's library may
 * have started threads.
 */
const VolumeHapticsVendorPlugin* LoadTable(const std::string& real, std::string& error)
{
  std::string reason;
  void* const library = Libraries::Load(real, reason);
  if (!library)
  {
    // The loader's message names the missing part, usually the vendor's own library.
    error = "\"" + real + "\" can't be loaded: " + reason +
#if defined(_WIN32)
      ". Install the vendor's SDK, or put its libraries into the plug-in's folder.";
#else
      ". Install the vendor's SDK, and name the folder of its libraries in LD_LIBRARY_PATH if they "
      "are not in a folder of the system.";
#endif
    return nullptr;
  }
  using Getter = const VolumeHapticsVendorPlugin* (*)(std::uint32_t);
  const auto get =
    reinterpret_cast<Getter>(Libraries::Find(library, "VolumeHapticsVendorGetPlugin"));
  if (!get)
  {
    error = "\"" + real +
      "\" is no plug-in: it does not export VolumeHapticsVendorGetPlugin (VendorPlugin.h).";
    return nullptr;
  }
  for (std::uint32_t version = VOLUME_HAPTICS_VENDOR_VERSION; version > 0; --version)
  {
    const VolumeHapticsVendorPlugin* const table = get(version);
    if (table && table->Version == version && IsWhole(*table))
    {
      return table;
    }
  }
  error = "\"" + real + "\" is a plug-in for a later version than " +
    std::to_string(VOLUME_HAPTICS_VENDOR_VERSION) +
    ", or leaves functions out. Build it again with the VendorPlugin.h of this version.";
  return nullptr;
}

constexpr int VendorRoundPause = 1; // longest time between two rounds (ms)
constexpr int VendorLostPause = 10; // ms
constexpr double Farthest = 10.;    // distance (m) above which a position is invalid
constexpr std::uint32_t AllAxes = 7;
constexpr double PeakFade = 2.5;    // time (s) in which a force fades to the continuous force
constexpr double LongestStep = 0.1; // longest time (s) between two forces that counts

bool IsLimit(double limit)
{
  return std::isfinite(limit) && limit >= 0.0;
}

} // namespace

std::shared_ptr<VendorLibrary> VendorLibrary::LoadFile(const std::string& path, std::string& error)
{
  static std::mutex mutex;
  static std::map<std::string, std::shared_ptr<VendorLibrary>> loaded;
  const std::string real = FindOwnFile(path, NoGroup, error);
  if (real.empty())
  {
    return nullptr;
  }
  const std::lock_guard<std::mutex> lock(mutex);
  const auto known = loaded.find(real);
  if (known != loaded.end())
  {
    return known->second;
  }
  const VolumeHapticsVendorPlugin* const table = LoadTable(real, error);
  if (!table)
  {
    return nullptr;
  }
  std::shared_ptr<VendorLibrary> library(new VendorLibrary(table));
  loaded[real] = library;
  return library;
}

std::shared_ptr<VendorLibrary> VendorLibrary::Load(
  const std::string& plugin, const std::string& path, std::string& error)
{
  const std::vector<std::string> folders = VendorFolder::Split(path);
  std::vector<std::string> obstacles;
  const std::vector<VendorFile> files = VendorFolder::List(folders, obstacles);
  const auto file = std::find_if(files.begin(), files.end(),
    [&plugin](const VendorFile& candidate) { return candidate.Plugin == plugin; });
  if (file != files.end())
  {
    return LoadFile(file->Path, error);
  }
  error = "There is no plug-in \"" + plugin + "\", the file libvolumehaptics-" + plugin +
    Libraries::Ending;
  if (folders.empty())
  {
    error += std::string(": no folder is searched. Name the plug-in's folder in ") +
      VendorFolder::Variable + " or by SetVendorPath().";
    return nullptr;
  }
  error += ", in ";
  for (const std::string& folder : folders)
  {
    error += (&folder == &folders.front() ? "\"" : ", \"") + folder + "\"";
  }
  error += ". Build it (Examples/Vendor), and name its folder in ";
  error += std::string(VendorFolder::Variable) + " or by SetVendorPath().";
  for (const std::string& obstacle : obstacles)
  {
    error += " " + obstacle;
  }
  return nullptr;
}

std::string VendorLibrary::LastError(void* device) const
{
  const char* const text = this->Table->LastError(device);
  return text && *text ? text : "did not say why.";
}

bool VendorLibrary::Look(std::string& error)
{
  const int count = this->Table->Count();
  if (count < 0)
  {
    error = this->LastError(nullptr);
    return false;
  }
  this->Known.clear();
  for (int number = 0; number < std::min(count, MostDevices); ++number)
  {
    char name[128] = "";
    char serial[128] = "";
    if (this->Table->Describe(number, name, sizeof(name), serial, sizeof(serial)) < 0)
    {
      error = this->LastError(nullptr);
      return false;
    }
    name[sizeof(name) - 1] = serial[sizeof(serial) - 1] = '\0';
    this->Known.push_back({ name, serial });
  }
  return true;
}

bool VendorLibrary::Describe(std::vector<Description>& devices, std::string& error)
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  const bool isKnown = this->OpenCount > 0 || this->Look(error);
  devices = this->Known;
  return isKnown;
}

void* VendorLibrary::Open(int number, std::string& error)
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  if (this->OpenCount == 0 && !this->Look(error))
  {
    return nullptr;
  }
  const std::size_t count = this->Known.size();
  if (static_cast<std::size_t>(number) >= count)
  {
    error = count == 0
      ? "has no device. Plug it in, switch it on, and close programs that use it."
      : "has no device " + std::to_string(number) + ". Count from 0, as EnumerateDevices() does.";
    return nullptr;
  }
  Description& description = this->Known[static_cast<std::size_t>(number)];
  if (description.IsOpen)
  {
    error = "is in use by this program. Close() it there.";
    return nullptr;
  }
  void* const device = this->Table->Open(number);
  if (!device)
  {
    error = this->LastError(nullptr);
    return nullptr;
  }
  description.IsOpen = true;
  ++this->OpenCount;
  return device;
}

void VendorLibrary::Close(void* device, int number) noexcept
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  this->Table->Close(device);
  this->Known[static_cast<std::size_t>(number)].IsOpen = false;
  --this->OpenCount;
}

std::string VendorLibrary::MakeIdentity(
  const std::string& plugin, int number, const std::string& serial)
{
  std::string word = serial.empty() ? "number:" + std::to_string(number) : serial;
  // Replace spaces and '=', which separate words in the user's device file.
  std::replace_if(
    word.begin(), word.end(), [](unsigned char c) { return std::isgraph(c) == 0 || c == '='; },
    '_');
  return "vendor:" + plugin + ":" + word;
}

VendorDriver::VendorDriver(std::string plugin, int number, std::string path)
  : Plugin(std::move(plugin))
  , Number(number)
  , Path(std::move(path))
  , Label("vendor:" + this->Plugin + ":" + std::to_string(number))
{
}

VendorDriver::~VendorDriver()
{
  this->Disconnect();
}

bool VendorDriver::Connect(std::string& error)
{
  this->Library = VendorLibrary::Load(this->Plugin, this->Path, error);
  if (!this->Library)
  {
    return false;
  }
  return this->Take(this->Number, error);
}

bool VendorDriver::Take(int number, std::string& error)
{
  std::string reason;
  const std::string id = "vendor:" + this->Plugin + ":" + std::to_string(number);
  this->Place = number;
  this->Device = this->Library->Open(number, reason);
  if (!this->Device)
  {
    error = id + " " + reason;
    return false;
  }
  std::vector<VendorLibrary::Description> devices;
  char serial[128] = "";
  if (!this->ReadLimits(reason) || !this->Library->Describe(devices, reason) ||
    this->Library->Functions().GetSerial(this->Device, serial, sizeof(serial)) < 0 ||
    this->Write({}, {}) < 0)
  {
    error = id + " " + (reason.empty() ? this->Library->LastError(this->Device) : reason);
    this->Disconnect();
    return false;
  }
  serial[sizeof(serial) - 1] = '\0';
  this->Label = devices[static_cast<std::size_t>(number)].Name + " (" + id + ")";
  this->Identity = VendorLibrary::MakeIdentity(this->Plugin, number, serial);
  this->HasSerial = serial[0] != '\0';
  return true;
}

bool VendorDriver::Reconnect(
  const std::string& identity, const std::function<bool()>& mustStop, std::string& error)
{
  std::vector<VendorLibrary::Description> devices;
  std::string ignored;
  if (!this->Library->Describe(devices, ignored))
  {
    return false;
  }
  if (this->Others.size() != devices.size())
  {
    this->Others.assign(devices.size(), false);
  }
  const std::string label = this->Label;
  const DeviceLimits limits = this->Limits;
  for (std::size_t place = 0; place < devices.size() && !mustStop(); ++place)
  {
    // Some libraries report serial numbers only of open devices, so open each device to read its
    // number. Do this only once, because another program may need the device.
    const auto number = static_cast<int>(place);
    const std::string& serial = devices[place].Serial;
    const bool isOther =
      !serial.empty() && VendorLibrary::MakeIdentity(this->Plugin, number, serial) != identity;
    if (devices[place].IsOpen || isOther || this->Others[place] || !this->Take(number, error))
    {
      continue;
    }
    if (this->Identity == identity)
    {
      return true;
    }
    this->Others[place] = true;
    this->Disconnect();
  }
  error.clear(); // a missing device can't be opened, which is not an error here
  this->Label = label;
  this->Identity = identity;
  this->HasSerial = true;
  this->Limits = limits;
  return false;
}

bool VendorDriver::ReadLimits(std::string& error)
{
  // zero, because a plug-in of version 1 does not fill in all members
  VolumeHapticsVendorLimits limits{};
  if (this->Library->Functions().GetLimits(this->Device, &limits) < 0)
  {
    error = this->Library->LastError(this->Device);
    return false;
  }
  const bool isValid = IsLimit(limits.MaximumForce) && limits.MaximumForce > 0.0 &&
    IsLimit(limits.MaximumTorque) && IsLimit(limits.MaximumStiffness) &&
    IsLimit(limits.MaximumDamping) && IsLimit(limits.MaximumSpeed) && IsLimit(limits.OwnDamping) &&
    IsLimit(limits.WorkspaceRadius) && IsLimit(limits.ContinuousForce) && IsLimit(limits.PeakTime);
  const bool hasAxis = limits.ForceAxes == 0 || (limits.ForceAxes & AllAxes) != 0;
  if (!isValid || !hasAxis)
  {
    error = "does not say its largest force, has limits that are no numbers, or has no axis. Its "
            "plug-in has to be changed.";
    return false;
  }
  this->Limits = {};
  this->Limits.MaximumForce = limits.MaximumForce;
  this->Limits.MaximumStiffness = limits.MaximumStiffness;
  this->Limits.MaximumDamping = limits.MaximumDamping;
  this->Limits.MaximumSpeed = limits.MaximumSpeed;
  this->Limits.Damping = limits.OwnDamping;
  this->Limits.WorkspaceRadius = limits.WorkspaceRadius;
  this->Limits.ForceAxes = limits.ForceAxes == 0 ? AllAxes : limits.ForceAxes & AllAxes;
  this->Limits.MaximumTorque = limits.MaximumTorque;
  const bool hasPeak = limits.ContinuousForce > 0.0 && limits.ContinuousForce < limits.MaximumForce;
  this->Limits.ContinuousForce = hasPeak ? limits.ContinuousForce : 0.0;
  this->PeakTime = limits.PeakTime;
  this->Spent = 0.0;
  return true;
}

void VendorDriver::Disconnect() noexcept
{
  if (this->Device)
  {
    this->Write({}, {});
    this->Library->Close(this->Device, this->Place);
    this->Device = nullptr;
  }
}

double VendorDriver::ComputeMostForce(double wanted) noexcept
{
  const double peak = this->Limits.MaximumForce;
  const double continuous = this->Limits.ContinuousForce;
  if (continuous == 0.0)
  {
    return peak;
  }
  const double elapsed = std::min(LongestStep, ServoClock::SecondsSince(this->WrittenAt));
  this->WrittenAt = ServoClock::Now();
  // Compare the requested force, not the limited one: a force that is only kept down by the limit
  // still counts as too strong. The limit then only falls while it acts, so the hand never receives
  // back more energy than it has spent.
  const double time = wanted > continuous ? elapsed : -elapsed;
  this->Spent = std::clamp(this->Spent + time, 0.0, this->PeakTime + PeakFade);
  const double faded = std::max(0.0, (this->Spent - this->PeakTime) / PeakFade);
  return peak - faded * (peak - continuous);
}

void VendorDriver::TellOfFading(HardwareExchange& exchange, double wanted)
{
  const double continuous = this->Limits.ContinuousForce;
  const bool fades = continuous > 0.0 && wanted > continuous && this->Spent > this->PeakTime;
  const bool isOver = !this->Interruption.empty() && wanted > 0.0;
  if (fades == this->IsFading && !isOver)
  {
    return;
  }
  this->Interruption.clear(); // the user has armed the device again
  this->IsFading = fades;
  char text[96] = "";
  if (fades)
  {
    std::snprintf(text, sizeof(text),
      "gives %.3g N now, so that its motors don't get warm. Press less for some seconds.",
      continuous);
  }
  this->Report(exchange, DeviceStage::Ready, text);
}

int VendorDriver::Write(const Vector3& force, const Vector3& torque) noexcept
{
  const Vector3 f = ClampNorm(force, this->ComputeMostForce(Norm(force)));
  const Vector3 t = ClampNorm(torque, this->Limits.MaximumTorque);
  const double newtons[3] = { f.X, f.Y, f.Z };
  const double newtonMetres[3] = { t.X, t.Y, t.Z };
  return this->Library->Functions().Write(this->Device, newtons, newtonMetres);
}

void VendorDriver::Serve(HardwareExchange& exchange)
{
  /** Ends the force when leaving the scope, even by an exception. */
  struct AtEnd
  {
    VendorDriver* Driver;
    ~AtEnd() { this->Driver->Write({}, {}); }
  };
  const AtEnd atEnd{ this };
  this->Lost = this->Gone = this->IsReady = false;
  while (!exchange.MustStop() && !this->Gone)
  {
    if (exchange.HasSlept())
    {
      this->Lost = true;
      this->IsReady = false;
      this->Write({}, {});
    }
    if (exchange.DrainHomeRequest())
    {
      this->Home(exchange);
    }
    if (this->Lost)
    {
      // Quench() and Close() wait until this thread has requested the force and received zero.
      exchange.GetForce();
      exchange.WaitForWake(VendorLostPause);
      continue;
    }
    this->Round(exchange);
    exchange.WaitForWake(VendorRoundPause);
  }
}

void VendorDriver::Home(HardwareExchange& exchange)
{
  this->Lost = this->IsReady = false;
  this->Interruption.clear();
  const auto home = this->Library->Functions().Home;
  this->Write({}, {});
  if (home && home(this->Device) < 0)
  {
    this->Lose(exchange, this->Library->LastError(this->Device));
  }
}

void VendorDriver::Round(HardwareExchange& exchange)
{
  const std::int64_t begin = ServoClock::Now();
  VolumeHapticsVendorPose pose{};
  const int result = this->Library->Functions().Read(this->Device, &pose);
  if (result == VOLUME_HAPTICS_VENDOR_WAITS)
  {
    const std::string reason = this->Library->LastError(this->Device);
    if (this->IsReady)
    {
      this->Interruption = "lost its force: it " + reason + " Arm() it again.";
    }
    this->IsReady = false;
    this->Report(exchange, DeviceStage::Homing, reason);
    exchange.GetForce();
    this->Write({}, {});
    return;
  }
  if (result < 0)
  {
    const bool isGone = result == VOLUME_HAPTICS_VENDOR_GONE;
    // Reconnect only a device with a serial number; otherwise another device could be opened in its
    // place.
    this->Gone = isGone && this->HasSerial;
    this->Lose(exchange,
      this->Gone ? UnpluggedText
        : isGone ? OpenAgainText
                 : this->Library->LastError(this->Device));
    return;
  }
  this->ReceivePose(exchange, pose, result == VOLUME_HAPTICS_VENDOR_NEWS);
  if (this->Lost)
  {
    return;
  }
  const DeviceCommand command = exchange.GetCommand();
  if (this->Write(command.Force, command.Torque) < 0)
  {
    this->Lose(exchange, this->Library->LastError(this->Device));
    return;
  }
  exchange.RecordTaken();
  this->TellOfFading(exchange, Norm(command.Force));
  const double time = ServoClock::SecondsSince(begin);
  if (time > LongestCall)
  {
    this->Lose(exchange,
      "did not answer for " + std::to_string(static_cast<int>(1000.0 * time)) +
        " ms. Check its cable, then Home() and Arm() again.");
  }
}

void VendorDriver::ReceivePose(
  HardwareExchange& exchange, const VolumeHapticsVendorPose& pose, bool isNew)
{
  const Vector3 tip{ pose.Position[0], pose.Position[1], pose.Position[2] };
  if (!IsFinite(tip) || Norm(tip) > Farthest)
  {
    this->Lose(
      exchange, "reported an impossible position. Check its cable, then Home() and Arm() again.");
    return;
  }
  if (isNew || !this->IsReady)
  {
    DeviceSample sample;
    sample.Tip = tip;
    sample.Buttons = pose.Buttons;
    sample.HasOrientation = pose.HasOrientation != 0;
    if (sample.HasOrientation)
    {
      const double* const q = pose.Orientation;
      sample.Orientation = { q[0], q[1], q[2], q[3] };
    }
    sample.Time = ServoClock::Now() - std::max<std::int64_t>(pose.Age, 0);
    exchange.Report(sample);
  }
  else
  {
    exchange.Confirm();
  }
  if (!this->IsReady)
  {
    this->IsReady = true;
    this->IsFading = false;
    this->Report(exchange, DeviceStage::Ready, this->Interruption);
  }
}

void VendorDriver::Lose(HardwareExchange& exchange, const std::string& text)
{
  this->Lost = true;
  this->IsReady = false;
  this->Report(exchange, DeviceStage::Lost, text);
  this->Write({}, {});
}

void VendorDriver::Report(
  HardwareExchange& exchange, DeviceStage stage, const std::string& text) const
{
  exchange.SetCondition(stage, this->Label.c_str(), text.c_str());
}

} // namespace VolumeHaptics
