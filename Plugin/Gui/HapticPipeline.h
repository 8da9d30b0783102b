// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Finds or makes the device that feels the active object of the pipeline browser, and sets the look
 * of the felt data in a view.
 */
#ifndef HapticPipeline_h
#define HapticPipeline_h

class QString;
class pqPipelineSource;
class pqView;
class vtkSMHapticDeviceProxy;

namespace HapticPipeline
{

///@{
/** Tell the kind of a pipeline object: a device, a VolumeHaptics filter, or a volume. */
bool IsDevice(pqPipelineSource* source);
bool IsTouch(pqPipelineSource* source);
bool IsVolume(pqPipelineSource* source);
///@}

/**
 * Returns the HapticDevice for a source: the source itself, or the device that feels it through a
 * VolumeHaptics filter. Missing objects are made. There is one hand, so a device that feels
 * something else is disarmed, and used for this source from now on. nullptr if the source can't be
 * felt.
 */
pqPipelineSource* FindOrMakeDevice(pqPipelineSource* source);

///@{
/**
 * Return the objects upstream: the filter of a device, and the input of the filter. nullptr if
 * there is none.
 */
pqPipelineSource* GetTouch(pqPipelineSource* device);
pqPipelineSource* GetVolume(pqPipelineSource* touch);
///@}

/**
 * Returns the VolumeHaptics filter: the source itself, or the filter of its device or of a volume;
 * or nullptr.
 */
pqPipelineSource* FindTouch(pqPipelineSource* source);

} // namespace HapticPipeline

namespace HapticVolumeLook
{

/** Whether the view renders a source visibly as a volume. */
bool IsShown(pqPipelineSource* volume, pqView* view);

/**
 * Renders a source as a volume that is opaque from the skin on, where a hand meets it. Colours are
 * those of skin and bone by Hounsfield units (CTLook), as in the explorer. `array` is the point
 * array; if it is empty, the first one. False if there is none.
 */
bool ShowAsCT(pqPipelineSource* volume, pqView* view, const QString& array);

} // namespace HapticVolumeLook

#endif
