// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Finds the volumes that a window shows, and their renderers and transforms.
 */
#ifndef WindowVolumes_h
#define WindowVolumes_h

#include "vtkAbstractVolumeMapper.h"
#include "vtkAssemblyNode.h"
#include "vtkAssemblyPath.h"
#include "vtkCollection.h"
#include "vtkDataObject.h"
#include "vtkMatrix4x4.h"
#include "vtkMultiVolume.h"
#include "vtkPropCollection.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkRendererCollection.h"
#include "vtkSmartPointer.h"
#include "vtkVolume.h"
#include "vtkVolumeCollection.h"

#include <vector>

namespace VolumeHaptics
{

/** Calls `visit` for each visible volume with a mapper and the renderer that draws it. */
template <typename Visit>
void ForEachVolume(vtkRenderWindow* window, Visit&& visit)
{
  vtkRendererCollection* const renderers = window->GetRenderers();
  vtkCollectionSimpleIterator at;
  renderers->InitTraversal(at);
  while (vtkRenderer* const renderer = renderers->GetNextRenderer(at))
  {
    vtkVolumeCollection* const volumes = renderer->GetVolumes();
    for (int i = 0; i < volumes->GetNumberOfItems(); ++i)
    {
      auto* const volume = vtkVolume::SafeDownCast(volumes->GetItemAsObject(i));
      if (volume && volume->GetVisibility() && volume->GetMapper())
      {
        visit(renderer, volume);
      }
    }
  }
}

/** A volume drawn by a renderer: alone, or as a part of an assembly or of a vtkMultiVolume. */
struct DrawnVolume
{
  vtkVolume* Volume = nullptr;
  vtkAbstractVolumeMapper* Mapper = nullptr;
  int Port = 0;                         ///< input port of the mapper
  vtkSmartPointer<vtkMatrix4x4> Matrix; ///< transform from the data to the world
  vtkVolume* Whole = nullptr;           ///< the prop in the renderer: the volume itself, or the
                                        ///< vtkMultiVolume that contains it

  /** Returns the input data of the mapper; null without a mapper or an input. */
  vtkDataObject* GetData() const
  {
    return this->Mapper && this->Mapper->GetNumberOfInputConnections(this->Port) > 0
      ? this->Mapper->GetInputDataObject(this->Port, 0)
      : nullptr;
  }
};

namespace Detail
{

inline bool IsVisible(vtkAssemblyPath* path)
{
  vtkCollectionSimpleIterator it;
  path->InitTraversal(it);
  while (vtkAssemblyNode* const node = path->GetNextNode(it))
  {
    if (!node->GetViewProp() || !node->GetViewProp()->GetVisibility())
    {
      return false;
    }
  }
  return true;
}

inline void AppendDrawn(vtkVolume* volume, vtkMatrix4x4* matrix, std::vector<DrawnVolume>& all)
{
  vtkAbstractVolumeMapper* const mapper = volume->GetMapper();
  auto* const multi = vtkMultiVolume::SafeDownCast(volume);
  if (!multi)
  {
    auto copy = vtkSmartPointer<vtkMatrix4x4>::New();
    copy->DeepCopy(matrix);
    all.push_back({ volume, mapper, 0, copy, volume });
    return;
  }
  for (int port = 0; mapper && port < mapper->GetNumberOfInputPorts(); ++port)
  {
    // Skip an unused port, because GetVolume() would report an error for it.
    const bool isUsed = mapper->GetNumberOfInputConnections(port) > 0;
    if (vtkVolume* const part = isUsed ? multi->GetVolume(port) : nullptr)
    {
      part->ComputeMatrix();
      auto copy = vtkSmartPointer<vtkMatrix4x4>::New();
      copy->DeepCopy(part->GetMatrix());
      all.push_back({ part, mapper, port, copy, multi });
    }
  }
}

} // namespace Detail

/** Collects the visible volumes of a renderer. The parts of a hidden assembly count as hidden. */
inline std::vector<DrawnVolume> CollectDrawnVolumes(vtkRenderer* renderer)
{
  std::vector<DrawnVolume> all;
  vtkPropCollection* const props = renderer->GetViewProps();
  vtkCollectionSimpleIterator it;
  props->InitTraversal(it);
  while (vtkProp* const prop = renderer->GetDraw() ? props->GetNextProp(it) : nullptr)
  {
    if (!prop->GetVisibility())
    {
      continue;
    }
    if (auto* const volume = vtkVolume::SafeDownCast(prop))
    {
      volume->ComputeMatrix();
      Detail::AppendDrawn(volume, volume->GetMatrix(), all);
    }
    else if (prop->IsA("vtkAssembly") || prop->IsA("vtkPropAssembly"))
    {
      prop->InitPathTraversal();
      while (vtkAssemblyPath* const path = prop->GetNextPath())
      {
        vtkAssemblyNode* const node = path->GetLastNode();
        auto* const part = vtkVolume::SafeDownCast(node->GetViewProp());
        if (part && node->GetMatrix() && Detail::IsVisible(path))
        {
          Detail::AppendDrawn(part, node->GetMatrix(), all);
        }
      }
    }
  }
  return all;
}

} // namespace VolumeHaptics

#endif
