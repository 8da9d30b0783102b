// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Sends changes of the filter to the servo, and switches the felt method and settings. Keeps copies
 * of settings.
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
   * Copies the settings to a filter. The filter keeps the objects of its property and its label
   * table, so that an editor keeps editing the same functions.
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

  /** Forgets the published settings. Call this for a new device, whose servo has no model yet. */
  void Reset();

  /**
   * Publishes if the filter, its image or its surface has changed, or if the workspace was placed
   * again. Each change is tried only once, because a change that has failed would fail again. If a
   * method was prepared in the background and turns out not to work, restores the previous method.
   */
  void Update(bool isPlaced);

  /**
   * Changes the filter and publishes it. If the change can't be felt, undoes it and reports an
   * error; this may happen later, if the change is prepared in the background. `name` is the name
   * of the new settings.
   */
  bool Try(const std::function<void()>& change, const std::function<void()>& undo,
    const std::string& name, const std::function<void(const std::string&)>& notify);

  /** See vtkInteractorStyleHaptic::NextMethod. `notify` shows a notice; "" removes it. */
  bool NextMethod(const std::function<void(const std::string&)>& notify);

private:
  /** Returns the time of the last change of the filter, its image or its surface. */
  vtkMTimeType GetChangeTime() const;

  /**
   * A change of the method that is being prepared in the background. `Wanted` is empty if there is
   * none.
   */
  struct MethodChange
  {
    int Method = 0; ///< the previous method; its solver and its text are the next two members
    int Solver = 0;
    std::string Before;
    std::string Wanted; ///< text of the new method
    /**
     * Undoes the change, if it is a change to settings called Name; null if only the method
     * changes.
     */
    std::function<void()> Undo = nullptr;
    std::string Name = {};
  };
  using Notify = std::function<void(const std::string&)>;

  /**
   * Restores the previous settings, because the new settings can't be felt. `wasPublished`
   * says whether the servo already had the previous settings.
   */
  void TakeBack(const std::function<void()>& undo, const std::string& name, bool wasPublished,
    const Notify& notify);
  /**
   * Restores the previous method, because the new method can't be felt. `wasPublished` says whether
   * the servo already had the previous method.
   */
  void GoBack(const MethodChange& change, vtkVolumeHapticsFilter* filter, bool wasPublished,
    const Notify& notify);
  /** Checks whether the awaited change is ready, and if so, finishes it. */
  void PollAwaited();
  /** Shows a notice in the head-up display, if there is one. */
  void SetNotice(const std::string& notice);

  TouchedScene& Scene;
  vtkMTimeType Published = 0; ///< change time at the last attempt to publish
  bool IsFirst = true;        ///< whether none was made
  std::string Unfelt;         ///< name of the method that the last attempt failed to make felt
  std::string FeltInstead;    ///< text of the method that was kept instead
  MethodChange Awaited;
};

/** Two settings of a filter, A and B, which are felt in turn at the same position. */
class ComparedSettings
{
public:
  ComparedSettings(TouchedScene& scene, FilterPublisher& publisher);
  ~ComparedSettings() = default;
  ComparedSettings(const ComparedSettings&) = delete;
  ComparedSettings& operator=(const ComparedSettings&) = delete;

  /** See vtkInteractorStyleHaptic::SwapSettings. `notify` shows a notice; "" removes it. */
  bool Swap(const std::function<void(const std::string&)>& notify);

  /** Returns "A" or "B"; empty if nothing is compared. */
  std::string GetName() const;

  /**
   * Ends the comparison and discards the settings that are not felt. Call this for a new device,
   * too.
   */
  void End();

  /** Sets the name of the felt settings in the head-up display. Call this in each update. */
  void Report();

private:
  /** Returns the filter of the device; null without a device or a filter. */
  vtkVolumeHapticsFilter* GetFilter() const;

  TouchedScene& Scene;
  FilterPublisher& Publisher;
  vtkWeakPointer<vtkVolumeHapticsFilter> Filter; ///< the filter with the compared settings
  std::shared_ptr<const KeptSettings> Other;     ///< the settings that are not felt
  bool IsB = false;                              ///< whether B is felt
  bool IsTold = false;
};

} // namespace VolumeHaptics

#endif
