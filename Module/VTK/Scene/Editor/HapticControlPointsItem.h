// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   HapticControlPointsItem
 * @brief   VTK's control points for functions whose values may exceed 1
 *
 * vtkControlPointsItem shows and edits values from 0 to 1. This one shows Scale as 1. A value above
 * the scale is shown at the top, and is kept until its point is dragged down. An empty function is
 * shown without points. The first point that is added also adds one at both ends of the range, with
 * the value of the empty function.
 */
#ifndef HapticControlPointsItem_h
#define HapticControlPointsItem_h

#include "vtkPiecewiseControlPointsItem.h"

#include <string>

class HapticControlPointsItem : public vtkPiecewiseControlPointsItem
{
public:
  static HapticControlPointsItem* New();
  vtkTypeMacro(HapticControlPointsItem, vtkPiecewiseControlPointsItem);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** Places the points between two x, and between 0 and the scale (above 0). */
  void SetRange(double from, double to, double scale);

  /** The value of an empty function. Unselects the current point. */
  void SetEmptyValue(double value);

  /** The value and position of the current point, such as "800 at 70"; empty if there is none. */
  std::string DescribeCurrentPoint();

  /** A function's value divided by the scale, limited to -1 to 1. */
  static double ToShare(double value, double scale);

  vtkIdType AddPoint(double* newPos) override;

protected:
  HapticControlPointsItem();
  ~HapticControlPointsItem() override = default;

  void GetControlPoint(vtkIdType index, double* point) const override;
  void SetControlPoint(vtkIdType index, double* point) override;
  void DrawPoint(vtkContext2D* painter, vtkIdType index) override;

  double From = 0.0;
  double To = 1.0;
  double Scale = 1.0;
  double EmptyValue = 0.0;

private:
  HapticControlPointsItem(const HapticControlPointsItem&) = delete;
  void operator=(const HapticControlPointsItem&) = delete;
};

#endif
