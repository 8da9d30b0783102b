// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Interface of the kinds of vtkHapticTool, and the list of kinds.
 *
 * A kind defines how a tool is checked, described to a model, stored in setups, printed and drawn.
 * Its list of settings comes from Module/VTK/Settings.json.
 */
#ifndef ToolKind_h
#define ToolKind_h

#include "Core/Model/HapticModel.h"
#include "VTK/Base/HapticSetupNode.h"
#include "VTK/Tools/HapticToolSettings.h"

#include "vtkHapticShapedTool.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <memory>
#include <ostream>
#include <string>
#include <type_traits>
#include <vector>

class vtkHapticProperty;
class vtkPiecewiseFunction;

namespace VolumeHaptics
{

/** A function of a tool that maps scalar values to numbers of at least 0. */
struct ToolFunction
{
  const char* Name; ///< name without Get and Set
  const char* Unit;
  vtkPiecewiseFunction* (*Get)(vtkHapticTool*);
  double Default = 0.0; ///< value of a function without points
};

/** Input and result of Describe(), which makes the tool for a model. */
struct ToolPlan
{
  vtkHapticProperty* Property;           ///< property with the material
  const HapticModelDescription& Model;   ///< the model's settings, material, time steps and
                                         ///< geometry
  std::shared_ptr<const BakedTool> Tool; ///< result of Describe(); null before
  std::string Error;                     ///< reason and cure if the tool can't be felt
};

/** Interface of a kind of tool, whose class is vtkHapticNAME. */
class ToolKind
{
public:
  ToolKind(const char* name, const char* text)
    : Name(name)
    , Text(text)
  {
  }
  virtual ~ToolKind() = default;

  virtual bool Is(vtkHapticTool* tool) const = 0;
  virtual vtkSmartPointer<vtkHapticTool> Make() const = 0;
  /** Prints the settings that only this class has, for PrintSelf. */
  virtual void Print(std::ostream& os, vtkIndent indent, vtkHapticTool* tool) const = 0;
  /** Writes or reads all settings in a setup. */
  virtual void Pass(SetupNode& node, vtkHapticTool* tool) const = 0;
  /** Sets a number by its name in setups. Returns false if the tool has no such number. */
  virtual bool Set(vtkHapticTool* tool, const std::string& name, double value) const = 0;
  /** Copies data that setups do not contain, such as a mesh, from the previous tool. */
  virtual void TakeOver(vtkHapticTool* /*tool*/, vtkHapticTool* /*before*/) const {}
  virtual std::vector<ToolFunction> GetFunctions() const { return {}; }

  /**
   * Makes the tool for a model, after checking all of its numbers. If the tool can't be felt, sets
   * an error in the plan instead.
   */
  virtual void Describe(vtkHapticTool* tool, ToolPlan& plan) const = 0;
  /** Returns the arrays that only traces of this tool have. */
  virtual const ToolColumns& GetColumns() const
  {
    static const ToolColumns none;
    return none;
  }

  ///@{
  /**
   * Define how the scene shows a tool. MakeShape returns the mesh relative to the hand, in world
   * units; null: show a stylus. ComputeReach returns the distance from the hand to the farthest
   * touching point; 0 for a point.
   */
  virtual vtkSmartPointer<vtkPolyData> MakeShape(vtkHapticTool* /*tool*/) const { return nullptr; }
  virtual double ComputeReach(vtkHapticTool* /*tool*/) const { return 0.0; }
  /**
   * Returns whether the tool's mesh turns with the stylus and spins. Otherwise it is shown with the
   * felt orientation.
   */
  virtual bool TurnsWithStylus() const { return false; }
  /** Returns whether the tool is a shaft with a hub. */
  virtual bool HasShaft() const { return false; }
  /** Returns whether turning the tool changes what is drawn. */
  virtual bool IsTurnable() const { return false; }
  ///@}

  const char* const Name; ///< name in files
  const char* const Text; ///< name for the user

protected:
  /**
   * Converts a function to the units of the scalars. If it has a fault, returns a function that is
   * 0 everywhere, and sets an error in the plan.
   */
  Polyline ReadFunction(const ToolFunction& function, vtkHapticTool* tool, ToolPlan& plan) const;
};

/** Sets a setting by its name. Returns false if the list has no such setting. */
template <typename Owner, std::size_t Size>
bool SetSetting(
  Owner* owner, const HapticSetting<Owner> (&settings)[Size], const std::string& name, double value)
{
  const auto found = std::find_if(std::begin(settings), std::end(settings),
    [&name](const HapticSetting<Owner>& setting) { return name == setting.Name; });
  if (found == std::end(settings))
  {
    return false;
  }
  found->Set(owner, value);
  return true;
}

/** Implements ToolKind for the class Tool and its list of settings. */
template <typename Tool, const auto& Settings>
class ToolKindOf : public ToolKind
{
public:
  using ToolKind::ToolKind;

  bool Is(vtkHapticTool* tool) const override { return Tool::SafeDownCast(tool) != nullptr; }
  vtkSmartPointer<vtkHapticTool> Make() const override
  {
    return vtkSmartPointer<vtkHapticTool>(vtkSmartPointer<Tool>::New());
  }
  void Print(std::ostream& os, vtkIndent indent, vtkHapticTool* tool) const override
  {
    PrintSettings(os, indent, Tool::SafeDownCast(tool), Settings);
  }
  void Pass(SetupNode& node, vtkHapticTool* tool) const override
  {
    if constexpr (std::is_base_of_v<vtkHapticShapedTool, Tool>)
    {
      PassSettings(node, vtkHapticShapedTool::SafeDownCast(tool), ShapedToolSettings);
    }
    PassSettings(node, Tool::SafeDownCast(tool), Settings);
  }
  bool Set(vtkHapticTool* tool, const std::string& name, double value) const override
  {
    if constexpr (std::is_base_of_v<vtkHapticShapedTool, Tool>)
    {
      if (SetSetting(vtkHapticShapedTool::SafeDownCast(tool), ShapedToolSettings, name, value))
      {
        return true;
      }
    }
    return SetSetting(Tool::SafeDownCast(tool), Settings, name, value);
  }
};

/** Returns all kinds, in the order of their arrays in traces. */
const std::vector<const ToolKind*>& GetToolKinds();
/** Returns the kind of a tool; null for null, or for a tool of an application's own class. */
const ToolKind* FindToolKind(vtkHapticTool* tool);

/** Prints the settings and functions of a tool, for PrintSelf. */
void PrintTool(std::ostream& os, vtkIndent indent, vtkHapticTool* tool);

/**
 * Adds a tool to a model's description, which must have its settings and time steps already. A null
 * tool stands for a point. Returns false, with the reason and the cure in `error`, if the tool
 * can't be felt.
 */
bool DescribeTool(vtkHapticTool* tool, vtkHapticProperty* property,
  HapticModelDescription& description, std::string& error);

} // namespace VolumeHaptics

#endif
