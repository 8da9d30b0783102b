// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Experimental/XRActions.h"

#include "VTK/Base/FileReplacement.h"
#include "VTK/Base/HapticFiles.h"
#include "VTK/Base/JsonText.h"

#include "vtksys/SystemTools.hxx"

#include <algorithm>
#include <array>
#include <iterator>

namespace VolumeHaptics
{
namespace
{

constexpr std::size_t LargestManifest = 1 << 20; // bytes; VTK's manifests have some thousand

/** Profiles of OpenXR 1.0 and its extensions with an output/haptic in each hand. */
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

/** Returns a member of an object as an array or an object; empties it if it is something else. */
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

} // namespace

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

} // namespace VolumeHaptics
