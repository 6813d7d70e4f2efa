# SPDX-License-Identifier: GPL-3.0-or-later
# Found by find_package(ToileMesher); gives toile::toile_meshing.
include(CMakeFindDependencyMacro)
find_dependency(Threads)
find_dependency(nlohmann_json)
find_dependency(fmt)
find_dependency(tl-expected)
include(${CMAKE_CURRENT_LIST_DIR}/ToileMesherTargets.cmake)
