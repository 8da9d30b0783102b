// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Writes and reads the settings of a setup with the same code, so that both always agree.
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

/** A kind of JSON file that states its format and version. */
struct SetupFileKind
{
  const char* Format; ///< the value of the key "Format"
  int Version;        ///< version that is written; earlier versions can be read, too
  const char* Noun;   ///< name of the file's content, such as "setup"
  const char* Cure;   ///< where such files come from, as in the error text "that vtkHapticSetup
                      ///< saved"
  const char* Again;  ///< cure for a broken file, as in the error text "save the setup again"
};

/** Returns the root of a new file of a kind, with its format and version. */
Json::Value NewSetupFile(const SetupFileKind& kind);

/**
 * Parses a file. Returns false, with the fault and the cure in `error`, if the text is not a file
 * of this kind.
 */
bool ParseSetupFile(
  const std::string& text, const SetupFileKind& kind, Json::Value& root, std::string& error);

/**
 * State of one pass over the settings. A reading pass collects the changes, which are applied only
 * if there was no error.
 */
struct SetupPass
{
  bool Writing = false;
  std::vector<std::function<void()>> Changes;
  std::string Error; ///< first error of the pass; empty if there was none
};

struct NumberRange
{
  double Minimum;
  double Maximum;
};

/** Allows all finite numbers. */
NumberRange AnyNumber();
NumberRange NotNegative();

/** Row of numbers: a point of a function, or a vector. */
using NumberRow = std::vector<double>;

/**
 * A JSON object and its path in the file. A writing pass stores the results of the getters in the
 * object. A reading pass checks the values and queues a change for each setter. A setting whose key
 * is missing stays unchanged.
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
   * Reads or writes a text. `check` returns the fault of a text, with the cure; empty if it is
   * valid.
   */
  void Text(const char* key, const std::function<std::string()>& get,
    const std::function<void(const std::string&)>& set,
    const std::function<std::string(const std::string&)>& check = {});
  /**
   * Reads or writes a choice by its name; the value is the index of the name. Returns the index
   * that was read, or -1 if there is none.
   */
  int Choice(const char* key, const std::vector<const char*>& names,
    const std::function<int()>& get, const std::function<void(int)>& set);
  /**
   * Reads or writes a fixed number of numbers. Returns the numbers that were read, or an empty row.
   */
  NumberRow Row(const char* key, std::size_t size, const std::function<NumberRow()>& get,
    const std::function<void(const NumberRow&)>& set);
  /**
   * Reads or writes rows of numbers. `columns` has the allowed range of each column. The numbers in
   * the first column must ascend.
   */
  void Table(const char* key, const std::vector<NumberRange>& columns,
    const std::function<std::vector<NumberRow>()>& get,
    const std::function<void(const std::vector<NumberRow>&)>& set);

  /** Reports an error about a key unless `holds`, a condition on all values read. */
  void Require(const char* key, bool holds, const std::string& wanted);
  /** Queues a change after those of the values read so far. Does nothing in a writing pass. */
  void Then(std::function<void()> change);

  /**
   * Returns the node of a nested object. If the object is missing, the returned node reads nothing.
   */
  SetupNode Child(const std::string& key);

private:
  /** Returns the value of a key; null if the file lacks it. */
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

/** Reads or writes a setting of an owner, which must exist until the changes are applied. */
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
 * Reads or writes one key for each setting of an owner, which must exist until the changes are
 * applied.
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
