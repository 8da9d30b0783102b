# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The public names are there, and help() explains them with their units."""

import pydoc

import volumehaptics
from volumehaptics import (
    vtkHapticBurr,
    vtkHapticGuideMode,
    vtkHapticMode,
    vtkHapticNeedle,
    vtkHapticPointShell,
    vtkHapticProperty,
    vtkVolumeHapticsFilter,
)

# Public names, and words that each name's documentation must contain. Each Set... method must have a getter.
PROPERTY = {
    "SetStiffness": ("N/m", "500"),
    "SetFriction": ("friction", "0"),
    "SetViscosity": ("(N)", "eq. 14"),
    "SetSurfaceStrength": ("(N)", "2", "eq. 12"),
    "SetDistinctness": ("0 to 1", "world", "eq."),
    "SetComponent": ("component", "Default 0"),
    "SetSurfaceSide": ("higher", "lower", "default"),
    "SetVisibilityFrom": ("opacity", "nullptr"),
    "ApplyPreset": ("CT contrast", "CT physical", "CT angiography", "CT chest", "MRI", "Micro-CT", "Labels"),
    "GetPresetNames": ("ApplyPreset",),
    "DeepCopy": ("Copy",),
    "GetMTime": ("function",),
}
PROPERTY_PLAIN = ("SetSurfaceSideToHigher", "SetSurfaceSideToLower", "SetSurfaceSideToBoth")
FILTER = {
    "SetProperty": ("material",),
    "SetMethod": ("PROXY", "FORCE_FIELD", "eq. 1", "SURFACE_PROXY", "Ruspini", "LOCAL_SURFACE", "Mark"),
    "SetSolver": ("PAPER", "PRECISE", "default"),
    "SetContactAlignment": ("DISTINCTNESS", "default", "EDGE"),
    "SetTimeUnitsPerSecond": ("Default 1", "plays backwards"),
    "SetFrames": ("TIME_STEPS (default)", "COMPONENTS", "TimeAsVectorOn"),
    "SetFrameSpacing": ("Default 1",),
    "SetDisplacementArrayName": ("world", "default", "three components"),
    "SetSameShape": ("stiffness", "CouplingStiffness", "Default off"),
    "SetCouplingStiffness": ("(N/m)", "Default 500"),
    "SetGeometry": ("FROM_SCALARS (default)", "FROM_LABELS", "FROM_BOTH"),
    "SetMaterialPlacement": ("KERNEL", "FAR_SIDE (default)", "plateau"),
    "SetGradientEstimator": ("CENTRAL_DIFFERENCE", "GAUSSIAN", "CUBIC_BSPLINE"),
    "SetKernelRadius": ("voxels", "Default 2"),
    "SetServoRate": ("(Hz)", "1000"),
    "SetMetersPerWorldUnit": ("Metres", "0.001"),
    "SetForceFieldGain": ("(N per scalar unit per world unit)", "eq. 1", "Default"),
    "SetForceFieldDamping": ("(N s/m)", "eq. 1", "Default 0"),
    "SetTraceArrays": ("Default", "all", "none", "nullptr", "lists the arrays"),
    "GetMethodNames": ("NextMethod",),
    "SetMethodByName": ("GetMethodNames", "false"),
    "NextMethod": ("GetMethodNames",),
    "GetMethodText": ("users",),
    "SetIsoValue": ("isosurface", "Default 0"),
    "SetProxyRadius": ("world units", "0 (default)"),
    "SetForceShading": ("normals", "Default on"),
    "SetLocalSurfaceShape": ("PLANE (default)", "QUADRIC"),
    "SetLocalSurfaceRate": ("Hz", "Default 60"),
    "SetRecoveryTime": ("(s)", "Default 0.015"),
    "SetReleaseTime": ("(s)", "PRECISE", "Default 0.005"),
    "SetMaximumForce": ("(N)", "0 (default)"),
    "SetPathConnection": ("path", "port 1"),
    "SetSurfaceConnection": ("surface", "port 2"),
}
FILTER_PLAIN = (
    "SetMethodToProxy",
    "SetMethodToForceField",
    "SetMethodToSurfaceProxy",
    "SetMethodToLocalSurface",
    "SetMethodToPrimitives",
    "AddMode",
    "RemoveMode",
    "SetLocalSurfaceShapeToPlane",
    "SetLocalSurfaceShapeToQuadric",
    "SetSolverToPaper",
    "SetSolverToPrecise",
    "SetContactAlignmentToDistinctness",
    "SetContactAlignmentToEdge",
    "SetFramesToTimeSteps",
    "SetFramesToComponents",
    "SetGeometryFromScalars",
    "SetGeometryFromLabels",
    "SetGeometryFromBoth",
    "SetMaterialPlacementToKernel",
    "SetMaterialPlacementToFarSide",
    "SetGradientEstimatorToCentralDifference",
    "SetGradientEstimatorToGaussian",
    "SetGradientEstimatorToCubicBSpline",
    "SetPathData",
    "SetLabelData",
    "SetLabelConnection",
    "SetLabelTable",
    "GetLabelTable",
    "SetInputArrayToProcess",
)
NO_GETTER = ("SetMethodByName", "SetPathConnection", "SetSurfaceConnection")
ARRAYS = {
    "Time": "s",
    "Tip": "world",
    "Force": "N",
    "NormalForce": "N",
    "FrictionForce": "N",
    "DragForce": "N",
    "Normal": "unit",
    "Value": "scalar",
    "GradientMagnitude": "scalar per world",
    "SurfaceValue": "x_s",
    "MediumValue": "x_v",
    "Stiffness": "N/m",
    "Friction": "mu",
    "Viscosity": "N",
    "SurfaceStrength": "T_N W_d",
    "Contact": "penetrating",
    "Unfinished": "PRECISE",
    "Renewed": "LOCAL_SURFACE",
    "Energy": "J",
    "ModeForce_i": "N",
    "Orientation": "world",
    "Torque": "N m",
    "Depth": "world units",
    "ShaftForce": "N",
}
# Arrays that only one tool produces, and words that the documentation of the tool's class must contain.
TOOL_ARRAYS = {
    vtkHapticPointShell: {"ToolOrientation": "w, x, y, z"},
    vtkHapticBurr: {"RemovedVolume": "mm^3"},
    vtkHapticNeedle: {"ForbiddenTouches": "forbidden label"},
}
MODES = ("VectorFollow", "VectorFront", "Vortex", "Shear", "TensorFollow", "Ridge", "Guide", "Surface")
MODE_PLAIN = ("SetTwoSided", "SetPolarityToDark", "SetSnapDistance", "HasSecondStrength", "GetText")
GUIDE_PLAIN = ("SetPath", "GetPath", "SetSurface", "SetDistanceField", "SetSide", "SetDistance")


def check(cls, documented, plain):
    # help() prints pydoc's rendering, with line breaks at any place.
    text = " ".join(pydoc.render_doc(cls, renderer=pydoc.plaintext).replace("|", " ").split())
    for name, words in documented.items():
        assert name in text, f"help({cls.__name__}) lacks {name}"
        doc = " ".join(getattr(cls, name).__doc__.split())
        for word in words:
            assert word in doc, f"{cls.__name__}.{name} does not mention {word!r}: {doc}"
        if name.startswith("Set") and name not in NO_GETTER:
            assert callable(getattr(cls, "G" + name[1:])), name
    for name in plain:
        assert callable(getattr(cls, name)), name


def test_array_table():
    """Every point array has a line of its own in the class documentation, with its unit."""
    for documented, arrays in ((vtkVolumeHapticsFilter, ARRAYS), *TOOL_ARRAYS.items()):
        lines = documented.__doc__.splitlines()
        for array, unit in arrays.items():
            heads = [i for i, line in enumerate(lines) if line.strip(" |-*").startswith(array)]
            after = {i: lines[i].strip(" |-*")[len(array) :][:1] for i in heads}
            heads = [i for i in heads if after[i] in (" ", "(", ",", "")]
            assert heads, f"no line of the class documentation begins with {array}"
            assert any(unit in " ".join(lines[i : i + 2]) for i in heads), f"no {unit} with {array}"


def test_property():
    check(vtkHapticProperty, PROPERTY, PROPERTY_PLAIN)
    assert vtkHapticProperty.BOTH == 2
    assert "N/m" in vtkHapticProperty.__doc__


def test_filter():
    check(vtkVolumeHapticsFilter, FILTER, FILTER_PLAIN)
    for constant, value in (("PROXY", 0), ("FORCE_FIELD", 1), ("PAPER", 0), ("PRECISE", 1), ("GAUSSIAN", 1)):
        assert getattr(vtkVolumeHapticsFilter, constant) == value
    assert "volume" in vtkVolumeHapticsFilter.__doc__ and "2002" in vtkVolumeHapticsFilter.__doc__


def test_modes():
    documented = {"SetArrayName": ("components", "Empty (default)"), "SetStrength": ("(N)", "2 N"), "SetActive": ("on",)}
    documented["SetSecondStrength"] = ("(N)", "0 everywhere")
    check(vtkHapticMode, documented, MODE_PLAIN)
    check(vtkHapticGuideMode, documented, GUIDE_PLAIN)
    names = vtkHapticMode.GetKindNames()
    assert tuple(names.GetValue(i) for i in range(names.GetNumberOfValues())) == MODES
    for kind, name in enumerate(MODES):
        mode = vtkHapticGuideMode() if name == "Guide" else vtkHapticMode()
        if name != "Guide":
            getattr(mode, f"SetKindTo{name}")()
        assert mode.GetKind() == kind
        haptics = vtkVolumeHapticsFilter()
        haptics.AddMode(mode)
        assert haptics.GetMode(0).GetStrength().GetSize() == 0


def test_tools():
    documented = {"SetShaftFriction": ("N per metre", "0"), "SetCuttingForce": ("(N)", "viscosity"),
                  "SetLateralStrength": ("(N)", "1"), "ApplyPreset": ("CT contrast", "N in fat")}
    assert issubclass(volumehaptics.vtkHapticNeedle, volumehaptics.vtkHapticTool)
    check(volumehaptics.vtkHapticNeedle, documented, ("MakeTrack", "GetText"))
    documented = {"SetMesh": ("world units", "closed"), "SetNumberOfPoints": ("Default 2000",),
                  "SetContactArea": ("Default 25",), "SetCouplingStiffness": ("(N/m)", "Default 500"),
                  "SetTurningStiffness": ("(N m/rad)", "Default 0.5"), "SetContactValue": ("scalar at the surface", "Default 0"),
                  "SetSolid": ("FROM_STRENGTH (default)", "half")}
    assert issubclass(volumehaptics.vtkHapticShapedTool, volumehaptics.vtkHapticTool)
    assert issubclass(volumehaptics.vtkHapticPointShell, volumehaptics.vtkHapticShapedTool)
    check(volumehaptics.vtkHapticPointShell, documented, ("SetSolidToFromStrength", "SetSolidToAbove",
                                                          "SetSolidToBelow", "GetText"))
    documented = {"SetRadius": ("world units", "Default 2"), "SetSpeed": ("1/min", "60000"),
                  "SetFriction": ("friction", "0.3"), "SetSpecificEnergy": ("J/mm^3", "default"),
                  "SetVibration": ("0 to 1", "Default 0"), "SetSpinButton": ("button", "Default 0"),
                  "SetContactArea": ("0.1 for a vtkHapticBurr",), "SetCouplingStiffness": ("(N/m)", "Default 500"),
                  "SetContactValue": ("scalar at the surface", "Default"), "SetSolid": ("FROM_STRENGTH (default)", "half")}
    assert issubclass(volumehaptics.vtkHapticBurr, volumehaptics.vtkHapticShapedTool)
    check(volumehaptics.vtkHapticBurr, documented, ("SetSolidToFromStrength", "SetSolidToAbove", "SetSolidToBelow"))
    check(volumehaptics.vtkHapticRemoval, {"SetAutoAirValue": ("Default: on",), "SetAirValue": ("-1000",)},
          ("Undo", "Redo", "Reset", "MakeShares", "WriteFile", "ReadFile", "ReadTrace", "GetRemovedVolume",
           "TOUCHED_ARRAY"))
    haptics = vtkVolumeHapticsFilter()
    assert haptics.GetRemoval().IsEmpty()
    assert haptics.GetTool() is None
    haptics.SetTool(volumehaptics.vtkHapticNeedle())
    assert haptics.GetTool().GetText() == "needle"
    table = volumehaptics.vtkHapticLabelTable()
    assert table.GetShaftFriction(3) == -1.0
    table.SetShaftFriction(3, 60.0)
    assert table.GetShaftFriction(3) == 60.0 and table.HasMaterial(3)
    assert table.GetSpecificEnergy(4) == -1.0
    table.SetSpecificEnergy(4, 12.5)
    assert table.GetSpecificEnergy(4) == 12.5 and table.HasMaterial(4)
    assert "J/mm^3" in table.SetSpecificEnergy.__doc__


def test_method_names_are_all_documented():
    names = vtkVolumeHapticsFilter.GetMethodNames()
    for i in range(names.GetNumberOfValues()):
        assert f'"{names.GetValue(i)}"' in vtkVolumeHapticsFilter.GetMethodNames.__doc__
