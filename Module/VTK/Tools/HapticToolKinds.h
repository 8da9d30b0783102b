// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The kinds of vtkHapticTool.
 */
#ifndef HapticToolKinds_h
#define HapticToolKinds_h

#include "Core/Model/HapticModel.h"

#include "vtkHapticTool.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <string>
#include <vector>

class vtkPiecewiseFunction;

namespace VolumeHaptics
{

///@{
/** The ContactArea that a tool begins with (square world units). */
constexpr double ShellContactArea = 25.0;
constexpr double BurrContactArea = 0.1;
///@}

/** A function of a tool against the scalar value. Its values are 0 or more. */
struct ToolFunction
{
  const char* Name; ///< as in Get... and Set...
  const char* Unit;
  vtkPiecewiseFunction* (*Get)(vtkHapticTool*);
  double Default = 0.0; ///< without points
};

/** A kind of tool; its class is vtkHapticNAME. */
struct ToolKindRow
{
  const char* Name; ///< as in files
  const char* Text; ///< as the user sees it
  vtkSmartPointer<vtkHapticTool> (*Make)();
  std::vector<ToolFunction> Functions;
};

const std::vector<ToolKindRow>& GetToolKinds();
/** Whether a tool is of one of these kinds. An application's own class of tools is of none. */
bool HasToolKind(vtkHapticTool* tool);
/** The kind of a tool that has one. */
const ToolKindRow& FindToolKind(vtkHapticTool* tool);

/** A tool as the user sees it. */
std::string GetToolText(vtkHapticTool* tool);

/** Prints the settings and functions of a tool, for PrintSelf. */
void PrintTool(std::ostream& os, vtkIndent indent, vtkHapticTool* tool);

/**
 * Describes a tool to a model's description that has its settings and frames already. Null is a
 * point. False, with the reason and the cure in `error`, if it can't be felt.
 */
bool DescribeTool(vtkHapticTool* tool, HapticModelDescription& description, std::string& error);

} // namespace VolumeHaptics

#endif
