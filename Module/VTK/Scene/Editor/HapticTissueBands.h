// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   HapticTissueBands
 * @brief   the tissues of a property, as bands with names behind a function
 *
 * The first tissue reaches to the left end of the axis, and the last one to the right, as functions
 * go on there. A name stands upright where its band is narrow, and is left out where the band is
 * too narrow even for that.
 */
#ifndef HapticTissueBands_h
#define HapticTissueBands_h

#include "VTK/Scene/Editor/HapticValueScale.h"

#include "vtkPlot.h"

#include <array>
#include <string>
#include <vector>

class vtkContext2D;
class vtkHapticProperty;
class vtkRectf;

class HapticTissueBands : public vtkPlot
{
public:
  static HapticTissueBands* New();
  vtkTypeMacro(HapticTissueBands, vtkPlot);

  /**
   * Sets the tissues of a property, or none; the axis' values for scalars; the ends of the axis;
   * the size of letters.
   */
  void Show(vtkHapticProperty* property, const VolumeHaptics::ValueScale& toValue,
    const double range[2], int letters);

  ///@{
  /** Called by the chart. */
  bool Paint(vtkContext2D* painter) override;
  void GetBounds(double bounds[4]) override;
  ///@}

protected:
  HapticTissueBands();
  ~HapticTissueBands() override;

private:
  HapticTissueBands(const HapticTissueBands&) = delete;
  void operator=(const HapticTissueBands&) = delete;

  struct Band
  {
    std::string Name;
    double Low;
    double High;
    std::array<double, 3> Color;
  };
  void PaintName(vtkContext2D* painter, const Band& band, const vtkRectf& place) const;

  std::vector<Band> Bands;
  double Range[2] = { 0.0, 1.0 };
  int Letters = 10;
};

#endif
