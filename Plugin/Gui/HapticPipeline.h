// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Finds or makes the device for the active source of the pipeline browser, and sets the look of the
 * felt data in a view.
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
/**
 * Return whether a pipeline source is a device, a VolumeHaptics filter, or a volume: an image or
 * another grid, or composite data of these.
 */
bool IsDevice(pqPipelineSource* source);
bool IsTouch(pqPipelineSource* source);
bool IsVolume(pqPipelineSource* source);
///@}

/**
 * Returns the HapticDevice for a source: the source itself, or the device that feels it through a
 * VolumeHaptics filter. Missing objects are made. Because there is only one hand, a device that
 * feels another source is disarmed and then used for this source. Returns nullptr if the source
 * can't be felt.
 */
pqPipelineSource* FindOrMakeDevice(pqPipelineSource* source);
/** Returns a HapticDevice for the other hand, which feels the same as the first one. */
pqPipelineSource* FindOrMakeSecondDevice(pqPipelineSource* first);

/**
 * Returns the suitable preset for a volume: "CT contrast" for Hounsfield units, otherwise "Custom".
 */
QString ProposePreset(pqPipelineSource* volume);

///@{
/**
 * Return the source upstream: the filter of a device, or the input of a filter; nullptr if there is
 * none.
 */
pqPipelineSource* GetTouch(pqPipelineSource* device);
pqPipelineSource* GetVolume(pqPipelineSource* touch);
///@}

/**
 * Returns the VolumeHaptics filter of a source: the source itself, or the filter of a device or of
 * a volume; nullptr if there is none.
 */
pqPipelineSource* FindTouch(pqPipelineSource* source);

} // namespace HapticPipeline

namespace HapticVolumeLook
{

/** Returns whether a view shows a source by volume rendering. */
bool IsShown(pqPipelineSource* volume, pqView* view);

/**
 * Shows a source as a volume that is opaque from the skin inwards, where a hand touches it. The
 * colours are those of skin and bone by Hounsfield units (CTLook), as in the explorer. `array` is
 * the point array; if empty, the first array is used. Returns false if there is no array.
 */
bool ShowAsCT(pqPipelineSource* volume, pqView* view, const QString& array);

} // namespace HapticVolumeLook

#endif
