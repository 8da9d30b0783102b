// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   HapticControlPointsItem
 * @brief   VTK's control points for functions whose values are not shares of 1
 *
 * vtkControlPointsItem shows and edits values from 0 to 1. This one shows Scale as 1. A value above
 * it is shown at the top, and stays as it is until its point is dragged down. An empty function is
 * shown without points; the first one that is added brings one at both ends of the range with it,
 * which have the value that the empty function stood for.
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

  /** The place of the points: from x to x, and from 0 to the scale (above 0). */
  void SetRange(double from, double to, double scale);

  /** The meaning of an empty function. No point is the current one any more. */
  void SetEmptyValue(double value);

  /** The value of the current point and its place, such as "800 at 70", or nothing. */
  std::string DescribeCurrentPoint();

  /** A function's value as a share of the scale, -1 to 1, whatever it is. */
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
