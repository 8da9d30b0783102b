// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests that props drawn without a window, missing arrays, and editors of extreme sizes do not
 * crash.
 */

#include "Rigs/ApiRig.h"

#include <vtkContextDevice2D.h> // lets OpenGL draw the charts
#include <vtkHapticDevice.h>
#include <vtkHapticFunctionEditor.h>
#include <vtkHapticHeadUpDisplay.h>
#include <vtkHapticPathSource.h>
#include <vtkHapticRepresentation.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <limits>

using namespace apitest;

namespace
{
void ExpectNothingDrawn(vtkProp* prop)
{
  vtkNew<vtkRenderer> alone;
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkRenderWindow> window;
  window->AddRenderer(renderer);
  for (vtkViewport* viewport : std::initializer_list<vtkViewport*>{ nullptr, alone, renderer })
  {
    EXPECT_EQ(prop->RenderOpaqueGeometry(viewport), 0);
    EXPECT_EQ(prop->RenderOverlay(viewport), 0);
  }
  prop->ReleaseGraphicsResources(nullptr);
  prop->ReleaseGraphicsResources(window);
}
} // namespace

TEST(Undrawn, PropsWithoutAWindowThatRenders)
{
  vtkNew<vtkHapticDevice> device;
  ASSERT_TRUE(device->Open("virtual"));
  ASSERT_TRUE(device->Start());
  vtkNew<vtkHapticFunctionEditor> editor;
  ExpectNothingDrawn(editor);
  vtkNew<vtkHapticHeadUpDisplay> display;
  ExpectNothingDrawn(display);
  display->SetDevice(device);
  ExpectNothingDrawn(display);
  vtkNew<vtkHapticRepresentation> representation;
  ExpectNothingDrawn(representation);
  representation->SetDevice(device);
  representation->SetTrail(MakePath(Line({ 0, 0, 0 }, { 1, 1, 1 }, 5)));
  ExpectNothingDrawn(representation);
}

TEST(Undrawn, NumbersThatAreMissing)
{
  const auto expectError = [](auto* object, auto&& call)
  {
    MessageLog log(object);
    call();
    ASSERT_EQ(log.Errors.size(), 1U);
    EXPECT_NE(log.Errors[0].find("number"), std::string::npos) << log.Errors[0];
  };
  vtkNew<vtkHapticDevice> device;
  expectError(device.Get(), [&] { device->GetVirtualHand()->SetPosition(nullptr); });
  expectError(device.Get(), [&] { device->SetNewtonsPerFullScale(nullptr); });
  vtkNew<vtkHapticPathSource> source;
  expectError(source.Get(), [&] { source->SetBoxBounds(nullptr); });
  vtkNew<vtkHapticFunctionEditor> editor;
  expectError(editor.Get(), [&] { editor->SetRectangle(nullptr); });
}

TEST(Undrawn, EditorsOfAbsurdSizes)
{
  constexpr int most = std::numeric_limits<int>::max();
  constexpr int least = std::numeric_limits<int>::min();
  const std::array<int, 4> rectangles[] = { { 7, most, -1, least }, { most, most, most, most },
    { least, least, least, least }, { least, 0, most, 0 } };
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkRenderWindow> window;
  window->SetSize(100, 80);
  window->AddRenderer(renderer);
  vtkNew<vtkHapticFunctionEditor> editor;
  vtkNew<vtkHapticProperty> property;
  editor->SetProperty(property);
  renderer->AddViewProp(editor);
  for (const auto& r : rectangles)
  {
    editor->SetRectangle(r[0], r[1], r[2], r[3]);
    const int* const is = editor->GetRectangle();
    EXPECT_TRUE(is[2] >= 1 && is[2] <= 16384 && is[3] >= 1 && is[3] <= 16384);
    editor->Contains(most, least);
    window->Render();
  }
  MessageLog log(editor);
  editor->SetRectangle(nullptr);
  EXPECT_EQ(log.Errors.size(), 1U);
  editor->SetRectangle(10, 20, 30, 40);
  EXPECT_TRUE(editor->Contains(10, 20) && editor->Contains(39, 59) && !editor->Contains(40, 59));
}
