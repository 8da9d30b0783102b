// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The interface of the kinds of vtkHapticTool, and their list.
 *
 * A kind says how a tool is checked and described to a model, kept in setups, printed and drawn.
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

/** A function of a tool against the scalar value. The function's values are 0 or more. */
struct ToolFunction
{
  const char* Name; ///< name as in Get... and Set...
  const char* Unit;
  vtkPiecewiseFunction* (*Get)(vtkHapticTool*);
  double Default = 0.0; ///< value of a function without points
};

/** What Describe() needs to make a tool for a model, and the result. */
struct ToolPlan
{
  vtkHapticProperty* Property;           ///< property with the material
  const HapticModelDescription& Model;   ///< with settings, material, time steps and geometry
  std::shared_ptr<const BakedTool> Tool; ///< result, set by Describe(); null before
  std::string Error;                     ///< reason and cure, if the tool can't be felt
};

/** A kind of tool; its class is vtkHapticNAME. */
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
  /** Prints the settings that no other class has, for PrintSelf. */
  virtual void Print(std::ostream& os, vtkIndent indent, vtkHapticTool* tool) const = 0;
  /** Writes or reads all settings of a setup. */
  virtual void Pass(SetupNode& node, vtkHapticTool* tool) const = 0;
  /** Sets a number by its name, as in setups. Returns false if the tool has no such number. */
  virtual bool Set(vtkHapticTool* tool, const std::string& name, double value) const = 0;
  /** Copies from the earlier tool what setups do not hold, such as a mesh. */
  virtual void TakeOver(vtkHapticTool* /*tool*/, vtkHapticTool* /*before*/) const {}
  virtual std::vector<ToolFunction> GetFunctions() const { return {}; }

  /**
   * Makes the tool of a model. Checks every number of the tool; if the tool can't be felt, there is
   * an error instead.
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
   * Say how the scene shows a tool: the mesh relative to the hand, in world units (null: a stylus
   * is drawn); and the distance of the farthest touching point from the hand (0 for a point).
   */
  virtual vtkSmartPointer<vtkPolyData> MakeShape(vtkHapticTool* /*tool*/) const { return nullptr; }
  virtual double ComputeReach(vtkHapticTool* /*tool*/) const { return 0.0; }
  /**
   * Whether the tool's mesh turns with the stylus, and spins, instead of with the felt orientation.
   */
  virtual bool TurnsWithStylus() const { return false; }
  /** Whether the tool looks different when it is turned. */
  virtual bool IsTurnable() const { return false; }
  ///@}

  const char* const Name; ///< name in files
  const char* const Text; ///< name for the user

protected:
  /**
   * Reads a function in units of the scalars; 0 everywhere, with an error in the plan, if it has a
   * fault.
   */
  Polyline ReadFunction(const ToolFunction& function, vtkHapticTool* tool, ToolPlan& plan) const;
};

/** Sets the setting of this name. Returns false if the list has no such setting. */
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

/** A kind whose class is Tool, with its list of settings. */
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
/** Returns the kind of a tool; null for null, and for an application's own class. */
const ToolKind* FindToolKind(vtkHapticTool* tool);

/** Prints the settings and functions of a tool, for PrintSelf. */
void PrintTool(std::ostream& os, vtkIndent indent, vtkHapticTool* tool);

/**
 * Adds a tool to a model's description, which already has its settings and time steps. A null tool
 * stands for a point. Returns false, with the reason and the cure in `error`, if it can't be felt.
 */
bool DescribeTool(vtkHapticTool* tool, vtkHapticProperty* property,
  HapticModelDescription& description, std::string& error);

} // namespace VolumeHaptics

#endif
