# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause

# Changes the build of VTK 9.2 for MinGW, at the end of its configuration.
function (volume_haptics_set_sources)
  # Import the inline functions of classes that derive from exported templates from the library, too.
  foreach (module IN ITEMS CommonCore CommonDataModel CommonExecutionModel ImagingCore)
    get_target_property(folder ${module} SOURCE_DIR)
    get_target_property(sources ${module} SOURCES)
    list(FILTER sources INCLUDE REGEX
      "(Instantiate.*|IteratorTemplate|(Char|Short|Int|Long|LongLong|Float|Double|IdType)Array|Image.*Iterator)[.]cxx$")
    foreach (source IN LISTS sources)
      get_filename_component(source "${source}" ABSOLUTE BASE_DIR "${folder}")
      set_property(SOURCE "${source}" TARGET_DIRECTORY ${module} APPEND PROPERTY
        COMPILE_OPTIONS -fkeep-inline-dllexport)
    endforeach ()
  endforeach ()

  # Compile several sources of VTK's larger modules at once, which takes half the time. VTK isn't designed for unity
  # builds, so sources that clash with others are compiled separately.
  set(modules ChartsCore FiltersExtraction FiltersFlowPaths FiltersHybrid FiltersHyperTree FiltersModeling
    FiltersStatistics IOCore IOGeometry IOImage IOInfovis IOLegacy IOXML ImagingColor ImagingCore ImagingGeneral
    ImagingHybrid ImagingMath ImagingMorphological InfovisCore InteractionStyle InteractionWidgets ParallelCore
    RenderingAnnotation RenderingContext2D RenderingCore RenderingFreeType RenderingOpenGL2 RenderingVolume
    RenderingVolumeOpenGL2)
  set(alone IO/Geometry/vtkGLTFReader IO/Legacy/vtkCompositeDataReader Filters/HyperTree/vtkHyperTreeGridContour
    Filters/Modeling/vtkCookieCutter Filters/Statistics/vtkMultiCorrelativeStatistics
    Filters/Statistics/vtkOrderStatistics Imaging/Core/vtkGenericImageInterpolator
    Rendering/OpenGL2/vtkEDLShading Rendering/OpenGL2/vtkHiddenLineRemovalPass
    Rendering/OpenGL2/vtkOpenGLPolyDataMapper Rendering/Volume/vtkUnstructuredGridPartialPreIntegration)
  list(TRANSFORM alone REPLACE "(.+)" "${CMAKE_SOURCE_DIR}/\\1.cxx")
  foreach (module IN LISTS modules)
    if (TARGET ${module})
      set_target_properties(${module} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 10)
      set_source_files_properties(${alone} TARGET_DIRECTORY ${module} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
    endif ()
  endforeach ()
endfunction ()
cmake_language(DEFER CALL volume_haptics_set_sources)
