// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * One row of a list of settings, such as those in HapticFilterSettings.h.
 *
 * A row holds everything about a setting: its name, range, default, unit and documentation, the
 * names of its choices, its getter and setter, and its member of a model. PrintSelf, setup files,
 * baking and the comparison of models walk the lists; a test compares the public headers and
 * ParaView's XML with them.
 */
#ifndef HapticSetting_h
#define HapticSetting_h

#include "Core/Model/HapticModel.h"

#include "vtkIndent.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <limits>
#include <ostream>
#include <string>
#include <type_traits>

namespace VolumeHaptics
{

/** One value of a setting that is a choice. The value is the index of the choice in the list. */
struct SettingChoice
{
  const char* Name; ///< name in files
  const char* Text; ///< name for the user
};

enum class SettingKind
{
  Number,
  Integer,
  Flag,
  Choice
};

/** Facts that do not depend on the class that has the setting. */
struct SettingFacts
{
  SettingKind Kind;
  const char* Name; ///< name as in Get... and Set...
  double Minimum;
  double Maximum;
  double Default;
  const char* Unit;             ///< empty if the setting has none
  const SettingChoice* Choices; ///< Maximum + 1 choices of a SettingKind::Choice
  /**
   * The sentence that ParaView shows. The comment in the public header begins with the same words,
   * but has the names of constants instead of those of choices.
   */
  const char* Documentation;
};

/**
 * Returns the nearest value that a setting may have. For NaN returns the minimum, because it is the
 * safe one.
 */
inline double Clamp(const SettingFacts& setting, double value)
{
  return value > setting.Minimum ? std::min(value, setting.Maximum) : setting.Minimum;
}

/** A setting of the class Owner. Every value that a setting can have can be stored as a double. */
template <typename Owner>
struct HapticSetting : SettingFacts
{
  double (*Get)(Owner*);
  void (*Set)(Owner*, double);
  ///@{
  /** Copies the setting to a model's description; null if a model does not store it unchanged. */
  void (*Bake)(Owner*, HapticModelDescription&);
  bool (*IsSame)(const HapticModelDescription&, const HapticModelDescription&);
  ///@}
};

/** Largest number of components of a vector setting, which a direction matrix has. */
constexpr int LongestVector = 9;
using SettingVector = std::array<double, LongestVector>;

/** A setting of the class Owner that is several numbers, such as a position. */
template <typename Owner>
struct HapticVectorSetting
{
  const char* Name; ///< name as in Get... and Set...
  int Size;
  ///@{
  /** Range of each number. */
  double Minimum;
  double Maximum;
  ///@}
  SettingVector Default; ///< only the first `Size` numbers count, here and in Get and Set
  const char* Unit;      ///< empty for a setting that has none
  const char* Documentation;
  SettingVector (*Get)(Owner*);
  void (*Set)(Owner*, const SettingVector&);
};

/** A setting of the class Owner that is a text. */
template <typename Owner>
struct HapticTextSetting
{
  const char* Name; ///< name as in Get... and Set...
  const char* Default;
  const char* Documentation;
  std::string (*Get)(Owner*);
  void (*Set)(Owner*, const std::string&);
  std::string (*Check)(const std::string&); ///< returns the fault in a text; empty if there is none
};

/** A transfer function of the class Owner. Its values are 0 or more. */
template <typename Owner, typename Function>
struct HapticFunctionSetting
{
  const char* Name;
  double Maximum;
  double Default; ///< value of a function without points
  const char* Unit;
  Function* (Owner::*Get)();
  Polyline HapticMaterial::*Baked;
  const char* Documentation;
};

/** Stands for the model's member of a setting that a model does not store unchanged. */
constexpr std::nullptr_t NotBaked = nullptr;

/**
 * Makes the access functions of a setting from its class's getter and setter and the model's
 * member.
 */
template <auto Getter, auto Setter, auto Baked>
struct SettingAccess;

template <typename Owner, typename Value, Value (Owner::*Getter)(), void (Owner::*Setter)(Value),
  auto Baked>
struct SettingAccess<Getter, Setter, Baked>
{
  static double Get(Owner* owner) { return static_cast<double>((owner->*Getter)()); }
  static void Set(Owner* owner, double value) { (owner->*Setter)(static_cast<Value>(value)); }

  /** Returns the member of a model's description, or of the description's settings. */
  template <typename Description>
  static auto& Get(Description& description)
  {
    if constexpr (std::is_invocable_v<decltype(Baked), HapticSettings&>)
    {
      return description.Settings.*Baked;
    }
    else
    {
      return description.*Baked;
    }
  }
  static void Bake(Owner* owner, HapticModelDescription& description)
  {
    auto& value = Get(description);
    value = static_cast<std::remove_reference_t<decltype(value)>>((owner->*Getter)());
  }
  static bool IsSame(const HapticModelDescription& a, const HapticModelDescription& b)
  {
    return Get(a) == Get(b);
  }

  static constexpr HapticSetting<Owner> Make(const SettingFacts& facts)
  {
    if constexpr (std::is_null_pointer_v<decltype(Baked)>)
    {
      return { facts, &Get, &Set, nullptr, nullptr };
    }
    else
    {
      return { facts, &Get, &Set, &Bake, &IsSame };
    }
  }
};

/** Makes the access functions of a vector setting from its class's getter and setter. */
template <typename Owner, typename Value, int Size, Value* (Owner::*Getter)(),
  void (Owner::*Setter)(const Value*)>
struct VectorAccess
{
  static_assert(Size <= LongestVector);

  static SettingVector Get(Owner* owner)
  {
    SettingVector values{};
    const Value* const found = (owner->*Getter)();
    std::copy(found, found + Size, values.begin());
    return values;
  }
  static void Set(Owner* owner, const SettingVector& values)
  {
    Value wanted[Size];
    std::transform(values.begin(), values.begin() + Size, wanted,
      [](double value) { return static_cast<Value>(value); });
    (owner->*Setter)(wanted);
  }

  static constexpr HapticVectorSetting<Owner> Make(const char* name, double minimum, double maximum,
    const char* unit, const char* text, const SettingVector& standard)
  {
    return { name, Size, minimum, maximum, standard, unit, text, &Get, &Set };
  }
};

// Each macro makes one row for the class `Owner`. `baked` is the member of HapticSettings or of
// HapticModelDescription that stores the setting, or NotBaked.
#define HapticRowMacro(name, baked, ...) \
  SettingAccess<&Owner::Get##name, &Owner::Set##name, baked>::Make({ __VA_ARGS__ })
#define HapticNumberMacro(name, minimum, maximum, standard, unit, baked, text) \
  HapticRowMacro(                                                              \
    name, baked, SettingKind::Number, #name, minimum, maximum, standard, unit, nullptr, text)
#define HapticIntegerMacro(name, minimum, maximum, standard, unit, baked, text) \
  HapticRowMacro(                                                               \
    name, baked, SettingKind::Integer, #name, minimum, maximum, standard, unit, nullptr, text)
#define HapticFlagMacro(name, standard, baked, text) \
  HapticRowMacro(name, baked, SettingKind::Flag, #name, 0.0, 1.0, standard, "", nullptr, text)
// Makes the row of a choice. The names of its values are in an array that is called NAMENames.
#define HapticChoiceMacro(name, standard, baked, text)         \
  HapticRowMacro(name, baked, SettingKind::Choice, #name, 0.0, \
    static_cast<double>(std::size(name##Names) - 1), standard, "", name##Names, text)
// Makes the row of a vector. `type` is the type of its numbers; the last arguments are its default.
#define HapticVectorMacro(name, type, size, minimum, maximum, unit, text, ...)                   \
  VectorAccess<Owner, type, size, static_cast<type* (Owner::*)()>(&Owner::Get##name),            \
    static_cast<void (Owner::*)(const type*)>(&Owner::Set##name)>::Make(#name, minimum, maximum, \
    unit, text, { __VA_ARGS__ })

/**
 * Limits of settings that have no limit of their own. Settings whose macros clamp them to 0 or more
 * have the upper limit VTK_DOUBLE_MAX (1e299) instead.
 */
inline constexpr double LargestNumber = std::numeric_limits<double>::max();
inline constexpr double LargestInteger = std::numeric_limits<int>::max();

///@{
/** Prints settings for PrintSelf, one on each line. */
template <typename Owner, std::size_t Size>
void PrintSettings(
  std::ostream& os, vtkIndent indent, Owner* owner, const HapticSetting<Owner> (&settings)[Size])
{
  for (const HapticSetting<Owner>& setting : settings)
  {
    const double value = setting.Get(owner);
    os << indent << setting.Name << ": ";
    switch (setting.Kind)
    {
      case SettingKind::Number:
        os << value;
        break;
      case SettingKind::Integer:
        os << static_cast<int>(value);
        break;
      case SettingKind::Flag:
        os << (value != 0.0 ? "On" : "Off");
        break;
      case SettingKind::Choice:
        os << setting.Choices[static_cast<int>(value)].Name;
        break;
    }
    os << (*setting.Unit ? " " : "") << setting.Unit << "\n";
  }
}
template <typename Owner, std::size_t Size>
void PrintSettings(std::ostream& os, vtkIndent indent, Owner* owner,
  const HapticVectorSetting<Owner> (&settings)[Size])
{
  for (const HapticVectorSetting<Owner>& setting : settings)
  {
    const SettingVector values = setting.Get(owner);
    os << indent << setting.Name << ": (" << values[0];
    for (int i = 1; i < setting.Size; ++i)
    {
      os << ", " << values[static_cast<std::size_t>(i)];
    }
    os << ")" << (*setting.Unit ? " " : "") << setting.Unit << "\n";
  }
}
template <typename Owner, std::size_t Size>
void PrintSettings(std::ostream& os, vtkIndent indent, Owner* owner,
  const HapticTextSetting<Owner> (&settings)[Size])
{
  for (const HapticTextSetting<Owner>& setting : settings)
  {
    os << indent << setting.Name << ": " << setting.Get(owner) << "\n";
  }
}
///@}

} // namespace VolumeHaptics

#endif
