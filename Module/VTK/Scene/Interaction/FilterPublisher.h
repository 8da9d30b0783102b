// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Publishes changes of the filter to the servo, switches the felt method, and compares settings.
 */
#ifndef FilterPublisher_h
#define FilterPublisher_h

#include "VTK/Scene/Interaction/TouchedScene.h"

#include "vtkHapticLabelTable.h"
#include "vtkHapticProperty.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"
#include "vtkWeakPointer.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

class vtkVolumeHapticsFilter;

namespace VolumeHaptics
{

class KeptSettings
{
public:
  /** Copies the filter's settings, its property and its label table. */
  explicit KeptSettings(vtkVolumeHapticsFilter* filter);

  /**
   * Copies the settings to a filter. The filter's property and label table remain the same objects,
   * so that an editor continues to edit them.
   */
  void Apply(vtkVolumeHapticsFilter* filter) const;

  vtkNew<vtkHapticProperty> Property;

private:
  std::vector<double> Values;
  std::vector<std::string> Texts;
  vtkSmartPointer<vtkHapticLabelTable> Labels; ///< null without a table
};

class KeptSettings;

class FilterPublisher
{
public:
  explicit FilterPublisher(TouchedScene& scene)
    : Scene(scene)
  {
  }

  /**
   * Resets what is known about published settings. Call this for a new device, whose servo has no
   * model yet.
   */
  void Reset();

  /**
   * Publishes if the filter, its image or its surface has changed, or if the workspace was placed
   * again. Tries each change only once, because a failed change would fail again. If a method was
   * prepared in the background and turns out not to work, restores the previous method.
   */
  void Update(bool isPlaced);

  /**
   * Changes the filter and publishes it. If the change can't be felt, undoes it and reports an
   * error, perhaps later if the change is prepared in the background. `name` is that of the new
   * settings.
   */
  bool Try(const std::function<void()>& change, const std::function<void()>& undo,
    const std::string& name, const std::function<void(const std::string&)>& notify);

  /**
   * See vtkInteractorStyleHaptic::NextMethod. `notify` shows a notice; an empty text removes it.
   */
  bool NextMethod(const std::function<void(const std::string&)>& notify);

private:
  /** Returns the time of the last change of the filter, its image or its surface. */
  vtkMTimeType GetChangeTime() const;

  /**
   * A change of the method that is being prepared in the background. Wanted is empty if there is
   * none.
   */
  struct MethodChange
  {
    int Method = 0; ///< previous method; its solver and text follow
    int Solver = 0;
    std::string Before;
    std::string Wanted; ///< text of the new method
    /**
     * Undoes the change if it is one to the settings called Name; null if only the method changes.
     */
    std::function<void()> Undo = nullptr;
    std::string Name = {};
  };
  using Notify = std::function<void(const std::string&)>;

  /**
   * Restores the previous settings, because the new ones can't be felt. `wasPublished`: whether the
   * servo already had the previous settings.
   */
  void TakeBack(const std::function<void()>& undo, const std::string& name, bool wasPublished,
    const Notify& notify);
  /**
   * Restores the previous method, because the new one can't be felt. `wasPublished`: whether the
   * servo already had the previous method.
   */
  void GoBack(const MethodChange& change, vtkVolumeHapticsFilter* filter, bool wasPublished,
    const Notify& notify);
  /** Completes the awaited change once it is ready. */
  void PollAwaited();
  /** Shows a notice in the head-up display, if there is one. */
  void SetNotice(const std::string& notice);

  TouchedScene& Scene;
  vtkMTimeType Published = 0; ///< change time at the last attempt to publish
  bool IsFirst = true;        ///< whether no attempt was made yet
  std::string Unfelt;         ///< method that the last failed attempt should have made felt
  std::string FeltInstead;    ///< text of the method that stayed instead
  MethodChange Awaited;
};

/** Compares two settings of a filter, A and B, felt in turn at the same position. */
class ComparedSettings
{
public:
  ComparedSettings(TouchedScene& scene, FilterPublisher& publisher);
  ~ComparedSettings() = default;
  ComparedSettings(const ComparedSettings&) = delete;
  ComparedSettings& operator=(const ComparedSettings&) = delete;

  /**
   * See vtkInteractorStyleHaptic::SwapSettings. `notify` shows a notice; an empty text removes it.
   */
  bool Swap(const std::function<void(const std::string&)>& notify);

  /** Returns the felt settings, "A" or "B"; empty without a comparison. */
  std::string GetName() const;

  /**
   * Ends the comparison and discards the settings that are not felt. Call this also for a new
   * device.
   */
  void End();

  /** Shows the name of the felt settings in the head-up display. Call this in each update. */
  void Report();

private:
  /** Returns the filter of the device; null without a device or a filter. */
  vtkVolumeHapticsFilter* GetFilter() const;

  TouchedScene& Scene;
  FilterPublisher& Publisher;
  vtkWeakPointer<vtkVolumeHapticsFilter> Filter; ///< filter whose settings are compared
  std::shared_ptr<const KeptSettings> Other;     ///< settings that are not felt now
  bool IsB = false;                              ///< whether B is felt
  bool IsTold = false;
};

} // namespace VolumeHaptics

#endif
