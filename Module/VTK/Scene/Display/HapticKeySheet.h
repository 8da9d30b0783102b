// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   HapticKeySheet
 * @brief   draws a list of keys in groups on a dark panel in the middle of a viewport
 */
#ifndef HapticKeySheet_h
#define HapticKeySheet_h

#include "vtkContextItem.h"

#include <string>
#include <vector>

class HapticKeySheet : public vtkContextItem
{
public:
  static HapticKeySheet* New();
  vtkTypeMacro(HapticKeySheet, vtkContextItem);

  /**
   * Sets the text (titles, and lines that consist of a key, a tab and the key's meaning), and the
   * size of the viewport (pixels). The letters are as large as possible, up to 14 points.
   */
  void Show(const std::string& text, int width, int height, double scale = 1.0);

  /**
   * Scrolls a list that is too long for the viewport up by some lines, or down (negative). Returns
   * false if all lines are shown.
   */
  bool Scroll(int lines);

  bool Paint(vtkContext2D* painter) override;

protected:
  HapticKeySheet();
  ~HapticKeySheet() override;

private:
  HapticKeySheet(const HapticKeySheet&) = delete;
  void operator=(const HapticKeySheet&) = delete;

  struct Line
  {
    std::string Key; ///< name of a key, or a title
    std::string Meaning;
    bool IsTitle;
  };
  /** A column with the lines from Begin up to End, which is excluded. */
  struct Column
  {
    std::size_t Begin;
    std::size_t End;
    float KeyWidth; ///< pixels, like the next two members
    float Width;
    float Height;
  };
  std::vector<Column> Divide(std::size_t count) const;
  /**
   * Finds the largest letters that fit, and the columns for them. If not even the smallest letters
   * fit, shows a part of the lines.
   */
  void Fit(vtkContext2D* painter);
  /** Computes the columns for letters of this size. Returns whether they fit. */
  bool FitAll(vtkContext2D* painter, int letters);
  /** Makes a single column with as many lines as fit. */
  void FitPart(vtkContext2D* painter);
  void Measure(vtkContext2D* painter, Column& column) const;
  void PaintColumn(vtkContext2D* painter, const Column& column, float left, float top) const;
  void SetLetters(vtkContext2D* painter, bool isBold) const;
  /** Returns the height of letters (pixels). */
  float GetLetterHeight() const { return this->Scale * static_cast<float>(this->Letters); }

  std::vector<Line> Lines;
  std::string Text; ///< text that Lines were made from
  int Viewport[2] = { 0, 0 };
  float Scale = 1.0f; ///< pixels per point
  int Letters = 0;    ///< size of the letters (points); 0 before Fit
  std::vector<Column> Columns;
  bool IsPart = false;   ///< whether only a part of the lines is shown
  std::size_t First = 0; ///< index of the first line of that part
};

#endif
