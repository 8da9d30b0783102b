// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
// Expects that a second volume in the same window is drawn where the hand is. The renderers of the
// second scene use the memory of the first scene's, as may happen after F2, and each must have the
// aspect ratio of its own size. VTK 9.1 does not initialise the members that tell whether the ratio
// is up to date.
#include "Applications/Explorer/Live/TouchScene.h"
#include "Applications/Explorer/View/LoadingScreen.h"
#include "HeadExploration.h"

#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderer.h"
#include "vtkRendererCollection.h"
#include "vtkVersion.h"

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <vector>

#ifndef VTK_FUTURE_CONST // VTK 9.1
#define VTK_FUTURE_CONST
#endif

namespace
{
/// A renderer that is created in the memory of the last deleted renderer, whose content it finds.
class ReusedRenderer : public vtkOpenGLRenderer
{
public:
  static ReusedRenderer* New();
  vtkTypeMacro(ReusedRenderer, vtkOpenGLRenderer);
  ReusedRenderer(const ReusedRenderer&) = delete;
  void operator=(const ReusedRenderer&) = delete;

  static void* operator new(std::size_t size)
  {
    if (Deleted.empty())
    {
      return std::calloc(1, size);
    }
    void* const memory = Deleted.back();
    Deleted.pop_back();
    return memory;
  }
  static void operator delete(void* memory) { Deleted.push_back(memory); }
  static std::vector<void*> Deleted;

protected:
  ReusedRenderer() = default;
  ~ReusedRenderer() override = default;
};
vtkStandardNewMacro(ReusedRenderer);
std::vector<void*> ReusedRenderer::Deleted;

VTK_CREATE_CREATE_FUNCTION(ReusedRenderer);

class ReusedRendererFactory : public vtkObjectFactory
{
public:
  static ReusedRendererFactory* New();
  vtkTypeMacro(ReusedRendererFactory, vtkObjectFactory);
  ReusedRendererFactory(const ReusedRendererFactory&) = delete;
  void operator=(const ReusedRendererFactory&) = delete;

  const char* GetVTKSourceVersion() VTK_FUTURE_CONST override { return VTK_SOURCE_VERSION; }
  const char* GetDescription() VTK_FUTURE_CONST override { return "renderers in used memory"; }

protected:
  ReusedRendererFactory()
  {
    this->RegisterOverride(
      "vtkRenderer", "ReusedRenderer", "", 1, vtkObjectFactoryCreateReusedRenderer);
  }
  ~ReusedRendererFactory() override = default;
};
vtkStandardNewMacro(ReusedRendererFactory);

/// Counts the window's renderers whose aspect ratio differs from that of their size in pixels.
int CountWrong(vtkRenderWindow* window)
{
  int wrong = 0;
  vtkRendererCollection* const all = window->GetRenderers();
  vtkCollectionSimpleIterator at;
  all->InitTraversal(at);
  while (vtkRenderer* const renderer = all->GetNextRenderer(at))
  {
    renderer->ComputeAspect();
    const double* const aspect = renderer->GetAspect();
    const int* const size = renderer->GetSize();
    const double expected = static_cast<double>(size[0]) / size[1];
    if (std::abs(aspect[0] / aspect[1] - expected) > 0.02 * expected) // rounded to pixels
    {
      std::cerr << size[0] << " x " << size[1] << " has the aspect ratio " << aspect[0] / aspect[1]
                << "\n";
      ++wrong;
    }
  }
  return wrong;
}

/// Builds the scene off screen as Explore::RunTouchWindow() does, and counts the renderers with a
/// wrong aspect ratio.
int CountWrongInScene(vtkRenderWindow* window, const Explore::Exploration& exploration)
{
  window->SetOffScreenRendering(1);
  window->SetSize(390, 300);
  int wrong = 0;
  {
    Explore::LoadingScreen loading(window);
    loading.Report("Reading", 0.5);
    wrong += CountWrong(window);
  }
  Explore::SceneOptions options;
  options.Width = 390;
  options.Height = 300;
  options.Mapper = Explore::MapperChoice::CPU;
  options.Interactive = true;
  options.SliceShare = Explore::SLICE_SHARE;
  Explore::TouchScene touch;
  touch.Scene.Window = window;
  Explore::BuildTouchScene(touch, exploration, options, {});
  touch.Editor->VisibilityOn();
  touch.Editor->DockedOn();
  window->Render();
  wrong += CountWrong(window);
  touch.Device->Close();
  return wrong;
}
} // namespace

int TestTouchAgain(int argc, char* argv[])
{
  vtkNew<ReusedRendererFactory> factory;
  vtkObjectFactory::SetAllEnableFlags(0, "vtkRenderer", "vtkOpenGLRenderer");
  vtkObjectFactory::RegisterFactory(factory);
  const Explore::Exploration exploration = ExploreHead(argc, argv);
  for (int scene = 0; scene < 3; ++scene)
  {
    vtkNew<vtkRenderWindow> window;
    const int wrong = CountWrongInScene(window, exploration);
    if (wrong > 0 || (scene > 0 && ReusedRenderer::Deleted.empty()))
    {
      std::cerr << wrong << " renderers of scene " << scene << " are distorted\n";
      return EXIT_FAILURE;
    }
  }
  return EXIT_SUCCESS;
}
