// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * A stiff dough that holds a handle where it was when it was armed.
 */
#ifndef HoldingMedium_h
#define HoldingMedium_h

class vtkVolumeHapticsFilter;

/**
 * Makes the filter a medium in which the proxy never moves: a spring of this stiffness (N/m) in all
 * directions. One world unit is a millimetre of the device.
 */
void MakeHoldingMedium(vtkVolumeHapticsFilter* filter, double stiffness);

#endif
