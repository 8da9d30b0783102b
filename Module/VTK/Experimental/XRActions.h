// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The manifest of actions that vtkOpenXRRenderWindowInteractor reads, with its vibration bound.
 *
 * The manifest of VTK 9.2 to 9.7 has an action "haptic", but none of the bindings beside it binds
 * this action to a motor: OpenXR then accepts each vibration, and nothing vibrates.
 */
#ifndef XRActions_h
#define XRActions_h

#include <string>

namespace VolumeHaptics
{

/**
 * Copies a manifest and its bindings into a folder, which is made if it is missing, and binds the
 * action to the motors of both hands' controllers wherever OpenXR's specification gives a profile
 * such motors and nothing else is bound to them. False, with the reason and the cure, if a file
 * can't be read or written; some of the files may then be written.
 */
bool BindVibration(const std::string& manifest, const std::string& action,
  const std::string& folder, std::string& error);

} // namespace VolumeHaptics

#endif
