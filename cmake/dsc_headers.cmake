# SPDX-License-Identifier: GPL-3.0-or-later
# Precompiled headers: what nearly every source includes takes longer to read than the source itself. A source still
# includes what it uses; CMAKE_DISABLE_PRECOMPILE_HEADERS=ON builds without, as the unity builds of the presets `ci` and
# `asan` do, where every header is read only a few times per target anyway.
include_guard()

# dsc_headers(NAME HEADERS ... [LINKS ...]): compiles the headers once, for all targets that
# `target_precompile_headers(TARGET REUSE_FROM NAME)`. These have to have the same compiler options as LINKS give.
function(dsc_headers name)
  cmake_parse_arguments(ARG "" "" "HEADERS;LINKS" ${ARGN})
  add_library(${name} OBJECT "${PROJECT_SOURCE_DIR}/cmake/headers.cpp")
  target_link_libraries(${name} PRIVATE dsc_compile_options dsc_warnings Eigen3::Eigen ${ARG_LINKS})
  target_precompile_headers(${name} PRIVATE ${ARG_HEADERS})
endfunction()

# Without <filesystem>: it brings in <iomanip>, whose std::quoted would be found for every call of a `quoted` of ours.
set(DSC_COMMON_HEADERS <Eigen/Core> <Eigen/Geometry> <algorithm> <array> <cmath> <cstdint> <functional> <map> <memory>
                       <numbers> <optional> <span> <string> <vector>)

# CGAL asks for compiler options of its own, so that the libraries that use it need headers compiled in the same way.
# (In a function, since CGAL's package brings finders of other packages which only its own users shall see.)
function(dsc_library_headers)
  find_package(CGAL REQUIRED)
  dsc_headers(dsc_library_headers HEADERS ${DSC_COMMON_HEADERS})
  dsc_headers(dsc_cgal_library_headers HEADERS ${DSC_COMMON_HEADERS} LINKS CGAL::CGAL)
  set_target_properties(dsc_library_headers dsc_cgal_library_headers PROPERTIES POSITION_INDEPENDENT_CODE ON)
endfunction()
dsc_library_headers()
