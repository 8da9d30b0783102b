// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHapticXRController.h"

#include "Core/Platform/FileReplacement.h"
#include "Core/Platform/HapticFiles.h"
#include "Core/Realtime/ServoClock.h"
#include "Devices/Pad/Vibration.h"
#include "VTK/Base/JsonText.h"
#include "VTK/Experimental/HapticXRControllerSettings.h"

#include "vtkCallbackCommand.h"
#include "vtkEventData.h"
#include "vtkHapticDevice.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderWindowInteractor3D.h"
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"
#include "vtksys/SystemTools.hxx"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <string>

#if defined(VOLUME_HAPTICS_HAS_OPENXR)
#include "vtkOpenXRRenderWindowInteractor.h"
#endif

namespace VolumeHaptics
{
namespace
{

// Controllers vibrate through VTK's module RenderingOpenXR. Without this module, none of this
// works.
#if defined(VOLUME_HAPTICS_HAS_OPENXR)

vtkOpenXRRenderWindowInteractor* GetHeadset(vtkRenderWindowInteractor* interactor)
{
  return vtkOpenXRRenderWindowInteractor::SafeDownCast(interactor);
}

#else

struct Headset
{
  bool ApplyVibration(const std::string&, int, float, float, float) { return false; }
};

Headset* GetHeadset(vtkRenderWindowInteractor*)
{
  return nullptr;
}

#endif

/**
 * Makes a controller vibrate through an action of type "vibration" in the manifest. Hand: 0 is
 * left, 1 right. Amplitude: 0 to 1. Duration: s; the next vibration may end this one earlier.
 * Returns false if the interactor can't make controllers vibrate, or if the OpenXR runtime refuses;
 * VTK reports a refusal as an error.
 */
bool ApplyVibration(vtkRenderWindowInteractor* interactor, const std::string& action, int hand,
  double amplitude, double duration)
{
  auto* const headset = GetHeadset(interactor);
  constexpr double nanoseconds = 1e9;
  constexpr float anyFrequency = 0.0F; // XR_FREQUENCY_UNSPECIFIED: the runtime chooses
  return headset &&
    headset->ApplyVibration(action, hand, static_cast<float>(amplitude),
      static_cast<float>(nanoseconds * duration), anyFrequency);
}

// The manifest of actions in VTK 9.2 to 9.7 has an action "haptic", but none of its binding files
// connects that action to a motor. OpenXR then accepts each vibration without any effect.

constexpr std::size_t LargestManifest = 1 << 20; // bytes; VTK's manifests have a few thousand

/**
 * Interaction profiles of OpenXR 1.0 and its extensions that have an output/haptic path for each
 * hand.
 */
constexpr std::array<const char*, 8> ProfilesWithMotors{
  "/interaction_profiles/bytedance/pico_neo3_controller",
  "/interaction_profiles/hp/mixed_reality_controller", "/interaction_profiles/htc/vive_controller",
  "/interaction_profiles/htc/vive_cosmos_controller", "/interaction_profiles/khr/simple_controller",
  "/interaction_profiles/microsoft/motion_controller",
  "/interaction_profiles/oculus/touch_controller", "/interaction_profiles/valve/index_controller"
};

constexpr std::array<const char*, 2> Motors{ "/user/hand/left/output/haptic",
  "/user/hand/right/output/haptic" };

bool Read(const std::string& file, Json::Value& root, std::string& error)
{
  std::string text;
  if (!ReadSmallFile(file, LargestManifest, text, error))
  {
    error = "\"" + Printable(file) + "\" can't be read: it " + error +
      ". Give VTK's vtk_openxr_actions.json, with the files of its bindings beside it.";
    return false;
  }
  std::string fault;
  if (ParseJson(text, root, fault) && root.isObject())
  {
    return true;
  }
  error = "\"" + Printable(file) + "\" is no manifest of actions or bindings in JSON" +
    (fault.empty() ? "." : ": " + Printable(fault)) + " Give VTK's vtk_openxr_actions.json.";
  return false;
}

bool Write(const std::string& file, const Json::Value& root, std::string& error)
{
  FileReplacement replacement;
  if (!replacement.Open(file, error))
  {
    return false;
  }
  replacement.Write(Json::writeString(Json::StreamWriterBuilder(), root) + "\n");
  return replacement.Commit(error);
}

/**
 * Returns a member of a JSON object. A member that is not of `type`, an array or an object, is
 * replaced by an empty one.
 */
Json::Value& Member(Json::Value& object, const char* name, Json::ValueType type)
{
  Json::Value& member = object[name];
  if (member.type() != type)
  {
    member = Json::Value(type);
  }
  return member;
}

void AddAction(Json::Value& manifest, const std::string& action)
{
  Json::Value& actions = Member(manifest, "actions", Json::arrayValue);
  const bool isThere = std::any_of(actions.begin(), actions.end(),
    [&action](const Json::Value& other) { return other.isObject() && other["name"] == action; });
  if (!isThere)
  {
    Json::Value added;
    added["name"] = action;
    added["type"] = "vibration";
    actions.append(added);
    for (Json::Value& language : Member(manifest, "localization", Json::arrayValue))
    {
      if (language.isObject())
      {
        language[action] = "Vibration";
      }
    }
  }
}

void Bind(Json::Value& binding, const std::string& action)
{
  const Json::Value& profile = binding["interaction_profile"];
  const bool hasMotors = std::any_of(ProfilesWithMotors.begin(), ProfilesWithMotors.end(),
    [&profile](const char* name) { return profile == name; });
  if (!hasMotors)
  {
    return;
  }
  Json::Value& sets = Member(binding, "bindings", Json::objectValue);
  for (Json::Value& set : sets)
  {
    if (!set.isObject())
    {
      continue;
    }
    Json::Value& haptics = Member(set, "haptics", Json::arrayValue);
    for (const char* const motor : Motors)
    {
      const bool isBound = std::any_of(haptics.begin(), haptics.end(),
        [motor](const Json::Value& other) { return other.isObject() && other["path"] == motor; });
      if (!isBound)
      {
        Json::Value added;
        added["path"] = motor;
        added["output"] = action;
        haptics.append(added);
      }
    }
  }
}

/**
 * Copies a manifest and its binding files into a folder, and binds the action to the motors of both
 * hands' controllers. Binds a motor only if OpenXR's specification lists it in the controller's
 * profile and nothing else is bound to it. Creates the folder if necessary. Returns false, with the
 * reason and the cure in `error`, if a file can't be read or written; some files may have been
 * written by then.
 */
bool BindVibration(const std::string& manifest, const std::string& action,
  const std::string& folder, std::string& error)
{
  Json::Value root;
  if (!Read(manifest, root, error))
  {
    return false;
  }
  if (!vtksys::SystemTools::MakeDirectory(folder))
  {
    error = "The folder \"" + Printable(folder) +
      "\" for the manifest of actions can't be made. Name one that you may write.";
    return false;
  }
  AddAction(root, action);
  for (Json::Value& entry : Member(root, "default_bindings", Json::arrayValue))
  {
    if (!entry.isObject() || !entry["binding_url"].isString())
    {
      error = "\"" + Printable(manifest) +
        "\" has a binding without a binding_url. Give VTK's vtk_openxr_actions.json.";
      return false;
    }
    const std::string url = entry["binding_url"].asString();
    const std::string name = vtksys::SystemTools::GetFilenameName(url);
    Json::Value binding;
    if (!Read(GetFolder(manifest) + "/" + url, binding, error))
    {
      return false;
    }
    Bind(binding, action);
    if (!Write(folder + "/" + name, binding, error))
    {
      return false;
    }
    entry["binding_url"] = name;
  }
  return Write(folder + "/" + vtksys::SystemTools::GetFilenameName(manifest), root, error);
}

} // namespace
} // namespace VolumeHaptics

vtkStandardNewMacro(vtkHapticXRController);

using namespace VolumeHaptics;

namespace
{

constexpr int AmplitudeSteps = 255;

/** Reads a controller's pose from an event. Returns false if any number is not finite. */
bool ReadPose(const vtkEventDataDevice3D& event, double reach, double tip[3], double wxyz[4])
{
  double direction[3];
  double turn[4]; // angle (degrees) and axis
  event.GetWorldPosition(tip);
  event.GetWorldDirection(direction);
  event.GetWorldOrientation(turn);
  vtkMath::Normalize(direction);
  vtkMath::Normalize(turn + 1);
  const double half = 0.5 * vtkMath::RadiansFromDegrees(turn[0]);
  wxyz[0] = std::cos(half);
  bool isFinite = std::isfinite(wxyz[0]);
  for (int i = 0; i < 3; ++i)
  {
    tip[i] += reach * direction[i];
    wxyz[i + 1] = std::sin(half) * turn[i + 1];
    isFinite = isFinite && std::isfinite(tip[i]) && std::isfinite(wxyz[i + 1]);
  }
  return isFinite;
}

} // namespace

//------------------------------------------------------------------------------
struct vtkHapticXRController::vtkInternals
{
  vtkSmartPointer<vtkHapticDevice> Device;
  vtkWeakPointer<vtkRenderWindowInteractor> Interactor;
  vtkNew<vtkCallbackCommand> Observer;
  double Pending = 0.0; ///< largest amplitude since the last amplitude that was sent
  std::int64_t SentAt = 0;
  bool WasRefused = false; ///< whether a refusal was already reported
};

//------------------------------------------------------------------------------
vtkHapticXRController::vtkHapticXRController()
  : Internals(new vtkInternals)
{
  this->Internals->Observer->SetClientData(this);
  this->Internals->Observer->SetCallback([](vtkObject*, unsigned long event, void* self, void* data)
    { static_cast<vtkHapticXRController*>(self)->Handle(event, data); });
}

//------------------------------------------------------------------------------
vtkHapticXRController::~vtkHapticXRController()
{
  this->SetInteractor(nullptr);
}

//------------------------------------------------------------------------------
void vtkHapticXRController::SetDevice(vtkHapticDevice* device)
{
  if (this->Internals->Device != device)
  {
    this->Internals->Device = device;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkHapticDevice* vtkHapticXRController::GetDevice()
{
  return this->Internals->Device;
}

//------------------------------------------------------------------------------
void vtkHapticXRController::SetInteractor(vtkRenderWindowInteractor* interactor)
{
  auto& d = *this->Internals;
  if (d.Interactor == interactor)
  {
    return;
  }
  if (d.Interactor)
  {
    d.Pending = 0.0;
    this->Vibrate(0.0);
    d.Interactor->RemoveObserver(d.Observer);
  }
  d.Interactor = interactor;
  d.WasRefused = false;
  if (interactor)
  {
    for (const unsigned long event : { vtkCommand::Move3DEvent, vtkCommand::Select3DEvent,
           vtkCommand::Button3DEvent, vtkCommand::RenderEvent })
    {
      interactor->AddObserver(event, d.Observer);
    }
  }
  this->Modified();
}

//------------------------------------------------------------------------------
vtkRenderWindowInteractor* vtkHapticXRController::GetInteractor()
{
  return this->Internals->Interactor;
}

//------------------------------------------------------------------------------
bool vtkHapticXRController::WriteActions(const char* manifest, const char* folder)
{
  std::string error;
  if (!manifest || !folder)
  {
    error = "WriteActions() needs the file of a manifest and a folder, but got a null pointer.";
  }
  else if (BindVibration(manifest, this->ActionName, folder, error))
  {
    return true;
  }
  vtkErrorMacro(<< error);
  return false;
}

//------------------------------------------------------------------------------
bool vtkHapticXRController::CanVibrate()
{
  return VolumeHaptics::GetHeadset(this->Internals->Interactor) != nullptr;
}

//------------------------------------------------------------------------------
void vtkHapticXRController::Handle(unsigned long event, void* data)
{
  vtkHapticDevice* const device = this->Internals->Device;
  if (event == vtkCommand::RenderEvent)
  {
    this->UpdateInFrame();
    return;
  }
  auto* const any = static_cast<vtkEventData*>(data);
  vtkEventDataDevice3D* const pose = any ? any->GetAsEventDataDevice3D() : nullptr;
  const vtkEventDataDevice hand =
    this->Hand == RIGHT ? vtkEventDataDevice::RightController : vtkEventDataDevice::LeftController;
  const std::string id = device ? device->GetDeviceId() : std::string();
  if (!pose || pose->GetDevice() != hand || (id != "vibration:xr" && id != "virtual"))
  {
    return;
  }
  if (event != vtkCommand::Move3DEvent)
  {
    device->GetVirtualHand()->SetButtons(pose->GetAction() == vtkEventDataAction::Press ? 1 : 0);
    return;
  }
  auto* const room = vtkRenderWindowInteractor3D::SafeDownCast(this->Internals->Interactor);
  double tip[3];
  double wxyz[4];
  // ReadPose() checks that all numbers are finite: a controller out of sight may report any pose.
  if (ReadPose(*pose, this->Reach * (room ? room->GetPhysicalScale() : 1.0), tip, wxyz))
  {
    device->GetVirtualHand()->SetPosition(tip);
    device->GetVirtualHand()->SetOrientation(wxyz);
  }
}

//------------------------------------------------------------------------------
void vtkHapticXRController::UpdateInFrame()
{
  auto& d = *this->Internals;
  if (d.Device)
  {
    d.Device->UpdateState();
    d.Pending = std::max(d.Pending, d.Device->GetVirtualHand()->TakeVibration());
  }
  const int steps = Vibration::Quantize(d.Pending, AmplitudeSteps);
  const double amplitude = static_cast<double>(steps) / AmplitudeSteps;
  const bool isSame = amplitude == this->Amplitude;
  const bool isDue = Vibration::IsDue(isSame, steps == 0, ServoClock::SecondsSince(d.SentAt));
  // If it is too early to send this frame's amplitude, keep it for the next frame.
  d.Pending = isSame || isDue ? 0.0 : d.Pending;
  if (isDue)
  {
    this->Vibrate(amplitude);
  }
}

//------------------------------------------------------------------------------
void vtkHapticXRController::Vibrate(double amplitude)
{
  auto& d = *this->Internals;
  const bool isNew = amplitude != this->Amplitude;
  this->Amplitude = amplitude;
  if (this->CanVibrate() && !d.WasRefused &&
    !ApplyVibration(d.Interactor, this->ActionName, this->Hand, amplitude, Vibration::ReplayTime))
  {
    d.WasRefused = true;
    vtkWarningMacro("The controller can't vibrate: the interactor refuses the action \""
      << this->ActionName
      << "\". Give the interactor the manifest that WriteActions() makes, then SetInteractor().");
  }
  d.SentAt = ServoClock::Now(); // measured after the call, which may take long
  if (isNew)
  {
    this->InvokeEvent(vtkCommand::UserEvent, &this->Amplitude);
  }
}

//------------------------------------------------------------------------------
void vtkHapticXRController::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Device: " << this->GetDevice() << "\n";
  os << indent << "Interactor: " << this->GetInteractor() << "\n";
  PrintSettings(os, indent, this, XRControllerSettings);
  os << indent << "ActionName: " << this->ActionName << "\n";
  os << indent << "Amplitude: " << this->Amplitude << "\n";
}
