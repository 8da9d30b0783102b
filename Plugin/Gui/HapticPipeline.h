// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Finds or makes the device that feels the active object of the pipeline browser.
 */
#ifndef HapticPipeline_h
#define HapticPipeline_h

class pqPipelineSource;
class vtkSMHapticDeviceProxy;

namespace HapticPipeline
{

///@{
/** The kind of a pipeline object. */
bool IsDevice(pqPipelineSource* source);
bool IsTouch(pqPipelineSource* source);
bool IsVolume(pqPipelineSource* source);
///@}

/**
 * The HapticDevice for a source: the source itself, or the device that feels it, through a
 * VolumeHaptics filter. Missing objects are made. There is one hand, so a device that feels
 * something else is disarmed and used for this source from now on. nullptr if the source can't be
 * felt.
 */
pqPipelineSource* FindOrMakeDevice(pqPipelineSource* source);

///@{
/**
 * The objects upstream: the filter of a device, and the input of the filter. nullptr if there is
 * none.
 */
pqPipelineSource* GetTouch(pqPipelineSource* device);
pqPipelineSource* GetVolume(pqPipelineSource* touch);
///@}

/**
 * The VolumeHaptics filter: the source itself, or the filter of its device or of a volume; or
 * nullptr.
 */
pqPipelineSource* FindTouch(pqPipelineSource* source);

} // namespace HapticPipeline

#endif
