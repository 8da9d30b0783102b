// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * One row of a list of settings, such as those in HapticFilterSettings.h.
 *
 * A row has everything about a setting: its name, range, default, unit and documentation, the names
 * of its choices, its getter and setter, and the member of a model that stores it. PrintSelf, setup
 * files, baking and the comparison of models walk the lists; a test compares the public headers and
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

/** One choice of a setting. Its value is its index in the list. */
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

/** Facts about a setting that do not depend on its class. */
struct SettingFacts
{
  SettingKind Kind;
  const char* Name; ///< name without Get and Set, such as "Method"
  double Minimum;
  double Maximum;
  double Default;
  const char* Unit;             ///< empty for a number without a unit
  const SettingChoice* Choices; ///< Maximum + 1 choices of a SettingKind::Choice
  /**
   * The sentence that ParaView shows. The comment in the public header begins with the same words,
   * but has the names of constants instead of those of choices.
   */
  const char* Documentation;
};

/**
 * Returns the allowed value that is nearest to `value`. Maps NaN to the minimum, which is the safe
 * value.
 */
inline double Clamp(const SettingFacts& setting, double value)
{
  return value > setting.Minimum ? std::min(value, setting.Maximum) : setting.Minimum;
}

/** A setting of the class Owner whose values can all be stored as a double. */
template <typename Owner>
struct HapticSetting : SettingFacts
{
  double (*Get)(Owner*);
  void (*Set)(Owner*, double);
  ///@{
  /**
   * Copies the setting to the description of a model; null if a model does not store it unchanged.
   */
  void (*Bake)(Owner*, HapticModelDescription&);
  bool (*IsSame)(const HapticModelDescription&, const HapticModelDescription&);
  ///@}
};

/** Largest number of components of a vector setting: a 3 x 3 direction matrix. */
constexpr int LongestVector = 9;
using SettingVector = std::array<double, LongestVector>;

/** A setting of the class Owner that consists of several numbers, such as a position. */
template <typename Owner>
struct HapticVectorSetting
{
  const char* Name; ///< name without Get and Set
  int Size;
  ///@{
  /** Smallest and largest value of each component. */
  double Minimum;
  double Maximum;
  ///@}
  SettingVector Default; ///< only the first `Size` numbers are valid, here and in Get and Set
  const char* Unit;      ///< empty for numbers without a unit
  const char* Documentation;
  SettingVector (*Get)(Owner*);
  void (*Set)(Owner*, const SettingVector&);
};

/** A text setting of the class Owner. */
template <typename Owner>
struct HapticTextSetting
{
  const char* Name; ///< name without Get and Set
  const char* Default;
  const char* Documentation;
  std::string (*Get)(Owner*);
  void (*Set)(Owner*, const std::string&);
  std::string (*Check)(const std::string&); ///< returns what is wrong with a text; empty if it is
                                            ///< valid
};

/** A transfer function of the class Owner, with values of at least 0. */
template <typename Owner, typename Function>
struct HapticFunctionSetting
{
  const char* Name;
  double Maximum;
  double Default; ///< constant value of a function without points
  const char* Unit;
  Function* (Owner::*Get)();
  Polyline HapticMaterial::*Baked;
  const char* Documentation;
};

/** Marks a setting that a model does not store unchanged. */
constexpr std::nullptr_t NotBaked = nullptr;

/** Makes the accessors of a setting from its class's getter and setter and the model's member. */
template <auto Getter, auto Setter, auto Baked>
struct SettingAccess;

template <typename Owner, typename Value, Value (Owner::*Getter)(), void (Owner::*Setter)(Value),
  auto Baked>
struct SettingAccess<Getter, Setter, Baked>
{
  static double Get(Owner* owner) { return static_cast<double>((owner->*Getter)()); }
  static void Set(Owner* owner, double value) { (owner->*Setter)(static_cast<Value>(value)); }

  /**
   * Returns a reference to a member of a model's description, or of the settings in the
   * description.
   */
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

/** Makes the accessors of a vector setting from its class's getter and setter. */
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

// Each macro makes one row for the class `Owner`. `baked` is the member of HapticSettings or
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
// Makes the row of a choice. The array NAMENames has the names of its values.
#define HapticChoiceMacro(name, standard, baked, text)         \
  HapticRowMacro(name, baked, SettingKind::Choice, #name, 0.0, \
    static_cast<double>(std::size(name##Names) - 1), standard, "", name##Names, text)
// Makes the row of a vector. `type` is the type of its components; the last arguments are their
// defaults.
#define HapticVectorMacro(name, type, size, minimum, maximum, unit, text, ...)                   \
  VectorAccess<Owner, type, size, static_cast<type* (Owner::*)()>(&Owner::Get##name),            \
    static_cast<void (Owner::*)(const type*)>(&Owner::Set##name)>::Make(#name, minimum, maximum, \
    unit, text, { __VA_ARGS__ })

/**
 * Limits of settings without a limit of their own. Settings whose macros clamp to 0 or more have
 * the upper limit VTK_DOUBLE_MAX (1e299) instead.
 */
inline constexpr double LargestNumber = std::numeric_limits<double>::max();
inline constexpr double LargestInteger = std::numeric_limits<int>::max();

///@{
/** Prints settings for PrintSelf, one per line. */
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
