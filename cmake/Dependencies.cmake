# SPDX-License-Identifier: GPL-3.0-or-later
# Every library from outside, in one place. What each does for us: docs/dependencies.md.
find_package(Threads REQUIRED)
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(nlohmann_json 3.11 REQUIRED)
find_package(fmt 9 REQUIRED)
find_package(tl-expected REQUIRED)
find_package(assimp REQUIRED)
find_package(fcl REQUIRED)
find_package(CLI11 REQUIRED)
find_package(spdlog REQUIRED)
find_package(PNG REQUIRED)
find_package(OpenGL REQUIRED COMPONENTS OpenGL EGL)

# CHOLMOD comes without a CMake or pkg-config file.
find_package(BLAS REQUIRED)
find_path(CHOLMOD_INCLUDE_DIR cholmod.h PATH_SUFFIXES suitesparse REQUIRED)
find_library(CHOLMOD_LIBRARY cholmod REQUIRED)
add_library(dep_cholmod INTERFACE)
target_include_directories(dep_cholmod SYSTEM INTERFACE ${CHOLMOD_INCLUDE_DIR})
target_link_libraries(dep_cholmod INTERFACE ${CHOLMOD_LIBRARY} BLAS::BLAS)

# Clipper 1 and MD4C's renderer come with a pkg-config file only.
find_package(PkgConfig REQUIRED)
pkg_check_modules(polyclipping REQUIRED IMPORTED_TARGET polyclipping)
pkg_check_modules(md4c-html REQUIRED IMPORTED_TARGET md4c-html)

if(TOILE_UI)
    find_package(Qt6 6.4 REQUIRED COMPONENTS Core Gui Widgets OpenGL OpenGLWidgets Svg Charts)
endif()
if(TOILE_TESTS)
    find_package(Qt6 6.4 REQUIRED COMPONENTS Core Test)
endif()
if(TOILE_BENCH)
    find_package(benchmark REQUIRED)
endif()
