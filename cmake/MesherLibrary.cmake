# SPDX-License-Identifier: GPL-3.0-or-later
# The mesher and the two rooms below it, to build and install without the rest: docs/how-to/use-the-mesher.md.
include(GNUInstallDirs)
find_package(Threads REQUIRED)
find_package(nlohmann_json 3.11 REQUIRED)
find_package(fmt 9 REQUIRED)
find_package(tl-expected REQUIRED)
set(mesher_rooms base geometry meshing)
foreach(room IN LISTS mesher_rooms)
    add_subdirectory(core/${room})
    install(DIRECTORY core/${room} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/toile/core FILES_MATCHING PATTERN "*.h")
    install(TARGETS toile_${room} EXPORT ToileMesher)
endforeach()
install(TARGETS toile_options EXPORT ToileMesher)
install(EXPORT ToileMesher NAMESPACE toile:: FILE ToileMesherTargets.cmake
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/ToileMesher)
install(FILES cmake/ToileMesherConfig.cmake DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/ToileMesher)
