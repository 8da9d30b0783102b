// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The settings of vtkHapticProperty, one row each: see HapticSetting.h.
 */
#ifndef HapticPropertySettings_h
#define HapticPropertySettings_h

#include "VTK/Base/HapticSetting.h"

#include "vtkHapticProperty.h"

namespace VolumeHaptics
{

using PropertySetting = HapticSetting<vtkHapticProperty>;
using PropertyFunction = HapticFunctionSetting<vtkHapticProperty, vtkPiecewiseFunction>;

inline constexpr SettingChoice SurfaceSideNames[] = { { "Higher", "Higher" }, { "Lower", "Lower" },
  { "Both", "Both" } };

namespace PropertySettingRows
{
using Owner = vtkHapticProperty;

inline constexpr PropertyFunction Functions[] = {
  { "Stiffness", LargestNumber, 500.0, "N/m", &Owner::GetStiffness, &HapticMaterial::Stiffness,
    "Stiffness k of the spring between proxy and tip, against the data value just inside the "
    "surface" },
  { "Friction", LargestNumber, 0.0, "", &Owner::GetFriction, &HapticMaterial::Friction,
    "Coefficient of friction mu (eqs. 8 to 10), against the data value just inside the surface" },
  { "SurfaceStrength", LargestNumber, 2.0, "N", &Owner::GetSurfaceStrength,
    &HapticMaterial::SurfaceStrength,
    "Surface strength T_N: the normal force at which a surface is penetrated (eq. 12), against the "
    "data value just inside the surface" },
  { "Viscosity", LargestNumber, 0.0, "N", &Owner::GetViscosity, &HapticMaterial::Viscosity,
    "Drag R of the medium against any motion (eq. 14), against the data value just outside the "
    "surface" },
  { "Distinctness", 1.0, 1.0, "", &Owner::GetDistinctness, &HapticMaterial::Distinctness,
    "Distinctness W_d (0 to 1), which scales the surface strength (eq. 13), against the gradient "
    "magnitude in scalar units per world unit" },
};

inline constexpr PropertySetting All[] = {
  HapticIntegerMacro(Component, 0, LargestInteger, 0, "", NotBaked,
    "The component of the array that is touched, 0 or more. Default 0."),
  HapticChoiceMacro(SurfaceSide, Owner::HIGHER, &HapticSettings::Side,
    "Which way a structure lies from its surface: towards Higher values (default; bone in CT), "
    "towards Lower values (lung seen from tissue), or Both, whichever way one pushes (MRI). "
    "Surfaces resist the way in, never the way out."),
  HapticFlagMacro(DistinctnessFromNoise, true, NotBaked,
    "Whether distinctness (W_d, eq. 13) keeps the noise of the image from being felt as surfaces. "
    "On (default): it is 0 up to 3.4 times the noise of the gradient, and 1 from twice that on; "
    "the noise is estimated from the flattest blocks of the image."),
  HapticFlagMacro(DistinctnessPerMillimeter, false, NotBaked,
    "Whether the gradient magnitudes of Distinctness are in scalar units per millimetre of the "
    "hand."),
  HapticFlagMacro(ScalarsAreLabels, false, NotBaked,
    "Whether the scalars are labels, a segmentation that is touched itself. Off (default): they "
    "are values, and what lies between two of them is a value, too."),
  HapticFlagMacro(SolidFromImage, false, NotBaked,
    "Whether the image tells what is solid: the background, darker than Otsu's threshold between "
    "the darkest two materials that are apart, then has no surface strength, however steep its "
    "noise and its streaks are."),
  HapticFlagMacro(ShiftFromImage, false, NotBaked,
    "Whether the functions are in Hounsfield units and the image tells how they are stored: as "
    "they are, or as whole numbers from 0 on, 1000, 1024 or 32768 higher, which is told."),
  HapticNumberMacro(ScalarShift, -1e30, 1e30, 0.0, "", NotBaked,
    "What is added to a scalar for the value that the functions and tissues are of: -1024 for "
    "Hounsfield units that are stored 1024 higher. Default 0."),
  HapticNumberMacro(ScalarScale, 1e-12, 1e12, 1.0, "", NotBaked,
    "What that sum is multiplied by, 1e-12 to 1e12, for data of another unit than the functions. "
    "Default 1."),
};
} // namespace PropertySettingRows

inline constexpr const auto& PropertySettings = PropertySettingRows::All;
inline constexpr const auto& PropertyFunctions = PropertySettingRows::Functions;

} // namespace VolumeHaptics

#endif
