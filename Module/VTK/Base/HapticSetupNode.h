// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Writes and reads the settings of a setup with the same code.
 */
#ifndef HapticSetupNode_h
#define HapticSetupNode_h

#include "VTK/Base/HapticSetting.h"
#include "VTK/Base/JsonText.h"

#include "vtkType.h"
#include "vtk_jsoncpp.h"

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace VolumeHaptics
{

/** JSON files that state their format and its version. */
struct SetupFileKind
{
  const char* Format; ///< the value of the key "Format"
  int Version;        ///< the version that is written; this version and earlier ones can be read
  const char* Noun;   ///< such as "setup"
  const char* Cure;   ///< origin of such files, for errors: "that vtkHapticSetup saved"
  const char* Again;  ///< another cure, for errors: "save the setup again"
};

/** Begins a file of a kind. */
Json::Value NewSetupFile(const SetupFileKind& kind);

/**
 * Parses a file. Returns false, with the fault and the cure in `error`, if the text is no file of
 * the kind.
 */
bool ParseSetupFile(
  const std::string& text, const SetupFileKind& kind, Json::Value& root, std::string& error);

/**
 * State of one pass over the settings. When reading, collects the changes, which are made unless
 * there is an error.
 */
struct SetupPass
{
  bool Writing = false;
  std::vector<std::function<void()>> Changes;
  std::string Error; ///< the first error
};

struct NumberRange
{
  double Minimum;
  double Maximum;
};

/** Allows every number but NaN and the infinities. */
NumberRange AnyNumber();
NumberRange NotNegative();

/** Numbers of a row of a function, or of a vector. */
using NumberRow = std::vector<double>;

/**
 * A JSON object and its path in the file. Writing stores the results of the getters in it. Reading
 * checks the values and adds a change for each setter. A setting whose key is missing stays
 * unchanged.
 */
class SetupNode
{
public:
  SetupNode(SetupPass& pass, Json::Value* json, std::string path);

  bool IsWriting() const { return this->Pass.Writing; }
  bool Has(const char* key) const;
  std::vector<std::string> GetKeys() const;

  void Number(const char* key, const NumberRange& range, const std::function<double()>& get,
    const std::function<void(double)>& set);
  void Integer(const char* key, int minimum, int maximum, const std::function<int()>& get,
    const std::function<void(int)>& set);
  void Flag(
    const char* key, const std::function<bool()>& get, const std::function<void(bool)>& set);
  /**
   * Reads or writes a text. `check` returns the fault in a text, with the cure; empty if it is
   * valid.
   */
  void Text(const char* key, const std::function<std::string()>& get,
    const std::function<void(const std::string&)>& set,
    const std::function<std::string(const std::string&)>& check = {});
  /**
   * Reads or writes a choice by its name. Its value is the index of the name. Returns the index
   * that was read, or -1 if there is none.
   */
  int Choice(const char* key, const std::vector<const char*>& names,
    const std::function<int()>& get, const std::function<void(int)>& set);
  /** Reads or writes a fixed number of numbers. Returns the numbers that were read, or none. */
  NumberRow Row(const char* key, std::size_t size, const std::function<NumberRow()>& get,
    const std::function<void(const NumberRow&)>& set);
  /**
   * Reads or writes rows of numbers. `columns` has the range of each column. The first column must
   * ascend.
   */
  void Table(const char* key, const std::vector<NumberRange>& columns,
    const std::function<std::vector<NumberRow>()>& get,
    const std::function<void(const std::vector<NumberRow>&)>& set);

  /** Reports an error about a key unless a condition on all values read holds. */
  void Require(const char* key, bool holds, const std::string& wanted);
  /**
   * Adds a change that is made after those of the values read so far. Does nothing when writing.
   */
  void Then(std::function<void()> change);

  /**
   * Returns the node of an object in this one. If the object is missing, the node reads nothing.
   */
  SetupNode Child(const std::string& key);

private:
  /** Returns the value of a key; null if there is none to read. */
  const Json::Value* Find(const char* key) const;
  void Fail(const std::string& path, const Json::Value& found, const std::string& wanted);
  bool ReadNumber(
    const Json::Value& value, const std::string& path, const NumberRange& range, double& number);
  bool ReadRow(const Json::Value& value, const std::string& path,
    const std::vector<NumberRange>& columns, NumberRow& row);
  std::string PathOf(const std::string& key) const;

  SetupPass& Pass;
  Json::Value* Json;
  std::string Path;
};

/** Reads or writes a setting of an owner, which must live until the changes are made. */
template <typename Owner>
void PassSetting(SetupNode& node, Owner* owner, const HapticSetting<Owner>& setting)
{
  const auto get = [owner, get = setting.Get] { return get(owner); };
  const auto set = [owner, set = setting.Set](double value) { set(owner, value); };
  switch (setting.Kind)
  {
    case SettingKind::Number:
      node.Number(setting.Name,
        { setting.Minimum,
          setting.Maximum < VTK_DOUBLE_MAX ? setting.Maximum : NotNegative().Maximum },
        get, set);
      break;
    case SettingKind::Integer:
      node.Integer(setting.Name, static_cast<int>(setting.Minimum),
        static_cast<int>(setting.Maximum), get, set);
      break;
    case SettingKind::Flag:
      node.Flag(setting.Name, get, set);
      break;
    case SettingKind::Choice:
      std::vector<const char*> names;
      for (int i = 0; i <= static_cast<int>(setting.Maximum); ++i)
      {
        names.push_back(setting.Choices[i].Name);
      }
      node.Choice(setting.Name, names, get, set);
      break;
  }
}

///@{
/**
 * Reads or writes one key for each setting of an owner, which must live until the changes are made.
 */
template <typename Owner, std::size_t Size>
void PassSettings(SetupNode& node, Owner* owner, const HapticSetting<Owner> (&settings)[Size])
{
  for (const HapticSetting<Owner>& setting : settings)
  {
    PassSetting(node, owner, setting);
  }
}

template <typename Owner, std::size_t Size>
void PassSettings(SetupNode& node, Owner* owner, const HapticTextSetting<Owner> (&settings)[Size])
{
  for (const HapticTextSetting<Owner>& setting : settings)
  {
    node.Text(
      setting.Name, [=] { return setting.Get(owner); },
      [=](const std::string& text) { setting.Set(owner, text); }, setting.Check);
  }
}
///@}

} // namespace VolumeHaptics

#endif
