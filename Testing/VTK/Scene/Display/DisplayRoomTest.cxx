// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests the head-up display in narrow windows, and beside objects that other renderers draw over
 * it.
 */

#include "Rigs/ScriptedStates.h"

#include "Rigs/DeviceRig.h"
#include "VTK/Scene/Base/HapticPixels.h"

#include <vtkActor.h>
#include <vtkHapticHeadUpDisplay.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkRenderingContext2DModule.h> // for autoinit
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

using namespace devicetest;

namespace
{
/** Bright pixels of a text on black, and their bounding rectangle. */
struct Ink
{
  double Sum = 0.0; ///< sum of the red values of all pixels
  int Left = 100000, Right = -1, Bottom = 100000, Top = -1;
};

class DisplayRoom : public DeviceTest
{
protected:
  DisplayRoom()
  {
    this->Window->SetOffScreenRendering(1);
    this->Window->SetMultiSamples(0);
    this->Window->AddRenderer(this->Renderer);
    this->Renderer->AddViewProp(this->Display);
  }
  vtkSmartPointer<vtkUnsignedCharArray> Draw(int width, int height)
  {
    this->Window->SetSize(width, height);
    this->Window->Render();
    return this->Pixels(0, width, 0, height);
  }
  vtkSmartPointer<vtkUnsignedCharArray> Pixels(int left, int right, int bottom, int top)
  {
    const auto pixels = vtkSmartPointer<vtkUnsignedCharArray>::New();
    this->Window->GetPixelData(left, bottom, right - 1, top - 1, 0, pixels);
    return pixels;
  }
  Ink Read(int width, int height)
  {
    const auto pixels = this->Draw(width, height);
    Ink ink;
    for (int y = 0; y < height; ++y)
    {
      for (int x = 0; x < width; ++x)
      {
        const int red = pixels->GetValue(3 * (static_cast<vtkIdType>(y) * width + x));
        ink.Sum += red;
        if (red > 20)
        {
          ink.Left = std::min(ink.Left, x);
          ink.Right = std::max(ink.Right, x);
          ink.Bottom = std::min(ink.Bottom, y);
          ink.Top = std::max(ink.Top, y);
        }
      }
    }
    return ink;
  }
  static void ExpectInside(const Ink& ink, int width, int height)
  {
    EXPECT_GT(ink.Left, 0);
    EXPECT_LT(ink.Right, width - 1);
    EXPECT_GT(ink.Bottom, 0);
    EXPECT_LT(ink.Top, height - 1);
  }

  vtkNew<vtkHapticHeadUpDisplay> Display;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkRenderWindow> Window;
};
} // namespace

TEST_F(DisplayRoom, EveryWordOfAFaultIsSeen)
{
  this->BeginFast();
  this->Device->GetVirtualHand()->SetPosition(7.0, 600.0, 5.0);
  ASSERT_TRUE(this->Wait([this] { return this->Device->GetStatus() == vtkHapticDevice::FAULT; }));
  this->Display->SetDevice(this->Device);
  this->Display->SetNotice("The folder of the recording is full. Remove what you do not need.");
  this->Display->PlotVisibilityOff();
  const Ink whole = this->Read(3000, 300); // in a window too wide for line breaks
  ASSERT_GT(whole.Right, 400) << this->Display->GetText();
  ASSERT_LT(whole.Right, 2900);
  for (const auto& [width, height] : { std::pair(700, 560), std::pair(400, 300) })
  {
    const Ink ink = this->Read(width, height);
    ExpectInside(ink, width, height);
    EXPECT_NEAR(ink.Sum, whole.Sum, 0.03 * whole.Sum) << width << " x " << height;
  }
}

TEST_F(DisplayRoom, LettersBecomeSmallerThanLinesNeed)
{
  std::string text;
  for (int i = 0; i < 80; ++i)
  {
    text += "A fault has many words, ";
  }
  this->Display->SetNotice((text + "end").c_str());
  const Ink ink = this->Read(400, 300);
  ExpectInside(ink, 400, 300);
  this->Display->SetNotice((text + "end, MMM").c_str());
  const Ink longer = this->Read(400, 300);
  ExpectInside(longer, 400, 300);
  EXPECT_GT(longer.Sum, ink.Sum) << "the last word is not seen";
}

TEST_F(DisplayRoom, AWordThatIsLongerThanALineIsBroken)
{
  this->Display->PlotVisibilityOff();
  this->Display->SetNotice(("/" + std::string(120, 'm') + "/\xc3\xa4\xc3\xb6\xc3\xbc.vtp").c_str());
  const Ink whole = this->Read(3000, 300);
  const Ink ink = this->Read(300, 300);
  ExpectInside(ink, 300, 300);
  EXPECT_NEAR(ink.Sum, whole.Sum, 0.03 * whole.Sum);
}

TEST_F(DisplayRoom, TextKeepsClearOfAMarkerBesideIt)
{
  vtkNew<vtkRenderer> marker;
  vtkNew<vtkActor> cube;
  marker->AddViewProp(cube);
  marker->SetViewport(0.84, 0.8, 1.0, 1.0);
  marker->SetLayer(1);
  this->Window->SetNumberOfLayers(2);
  this->Window->AddRenderer(marker);
  this->Display->PlotVisibilityOff();
  this->Display->SetNotice("The force was cut off, because the tip was faster than a hand may be.");
  EXPECT_LT(this->Read(400, 300).Right, 336);
  cube->VisibilityOff();
  EXPECT_GT(this->Read(400, 300).Right, 336);
}

TEST_F(DisplayRoom, PlotKeepsClearOfOrientationAxes)
{
  this->Display->TextVisibilityOff();
  this->Display->AddStates(scenetest::MakeStates(0.0, 5.0, [](double) { return 1.0; }));
  // This renderer represents the orientation axes of ParaView and of vtkOrientationMarkerWidget.
  vtkNew<vtkRenderer> axes;
  vtkNew<vtkActor> arrows;
  axes->AddViewProp(arrows);
  axes->SetViewport(0.0, 0.0, 0.25, 0.25);
  axes->SetLayer(1);
  this->Window->SetNumberOfLayers(2);
  this->Window->AddRenderer(axes);
  for (const auto& [width, height] :
    { std::pair(700, 560), std::pair(510, 505), std::pair(400, 300), std::pair(270, 300) })
  {
    const double box[4] = { 0.0, 0.25 * width, 0.0, 0.25 * height };
    const auto look = [&] { return this->Pixels(0, width / 4, 0, height / 4); };
    arrows->VisibilityOn();
    this->Draw(width, height);
    const auto beside = look();
    EXPECT_FALSE(this->Display->Covers(box)) << width;
    EXPECT_EQ(beside->GetRange(-1)[1], 0.0) << "something is drawn there, at " << width;
    const double whole[4] = { 0.0, 1.0 * width, 0.0, 1.0 * height };
    EXPECT_TRUE(this->Display->Covers(whole)) << "the plot is gone, at " << width;
    arrows->VisibilityOff();
    this->Draw(width, height);
    EXPECT_TRUE(this->Display->Covers(box)) << width;
    EXPECT_GT(look()->GetRange(-1)[1], 0.0) << "the plot is not in its corner, at " << width;
  }
}

/// Limits the renderer to the upper 65 % of the window, as a function editor does. The plot must
/// have as many pixels as in a window of that size.
TEST_F(DisplayRoom, PlotHasItsCurvesInAPartOfTheWindow)
{
  this->Display->TextVisibilityOff();
  this->Display->AddStates(
    scenetest::MakeStates(0.0, 5.0, [](double t) { return 1.0 + std::sin(3.0 * t); }));
  this->Draw(700, 560);
  const auto sum = [](vtkUnsignedCharArray* pixels)
  {
    double all = 0.0;
    for (vtkIdType i = 0; i < pixels->GetNumberOfValues(); ++i)
    {
      all += pixels->GetValue(i);
    }
    return all;
  };
  const double alone = sum(this->Draw(700, 364));
  ASSERT_GT(alone, 0.0);
  this->Draw(700, 560);
  this->Renderer->SetViewport(0.0, 0.35, 1.0, 1.0);
  this->Draw(700, 560);
  EXPECT_NEAR(sum(this->Pixels(0, 700, 196, 560)), alone, 1e-3 * alone);
}

// A window with twice the pixels must look the same on a screen with twice the dots per inch.
TEST_F(DisplayRoom, TwiceTheDotsPerInchDrawTwiceAsLarge)
{
  this->Display->SetHint("Put the pointer on the volume and press t to touch it");
  const auto panelRight = [this]
  {
    int right = 0;
    for (double box[4] = { 0.0, 1.0, 30.0, 31.0 }; this->Display->Covers(box); ++right)
    {
      box[0] = right + 1.0;
      box[1] = right + 2.0;
    }
    return right;
  };
  const Ink small = this->Read(700, 560);
  const int panel = panelRight();
  ASSERT_GT(panel, 200);
  this->Window->SetDPI(2 * this->Window->GetDPI());
  const Ink large = this->Read(1400, 1120);
  // Tolerance (pixels): margins have a constant width, and letters have an integer size.
  constexpr double rounding = 16.0;
  EXPECT_NEAR(panelRight(), 2 * panel, 2 * rounding);
  EXPECT_NEAR(large.Left, 2 * small.Left, rounding);
  EXPECT_NEAR(large.Right, 2 * small.Right, rounding);
  EXPECT_NEAR(large.Top, 2 * small.Top, rounding);
  ExpectInside(large, 1400, 1120);
}

/// Fits letters to a slice in a third of a window of 700 pixels, and to a list over the window.
/// With 144 dots per inch, letters must have more pixels than with 72, although the window has the
/// same size.
TEST_F(DisplayRoom, LettersOfSlicesAndListsGrowWithTheDots)
{
  using VolumeHaptics::FitLetters;
  EXPECT_GT(2 * FitLetters(233, 15, 2.0, 9, 14), FitLetters(233, 15, 1.0, 9, 14));
  EXPECT_GT(2 * FitLetters(700, 34, 2.0, 11, 18), FitLetters(700, 34, 1.0, 11, 18));
  // If the width is sufficient for a few letters only, they become smaller.
  EXPECT_EQ(FitLetters(100, 15, 2.0, 9, 14), 6);
}
