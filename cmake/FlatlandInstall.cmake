# SPDX-License-Identifier: GPL-3.0-or-later
# What `cmake --install` puts where. Two components, which become two Debian packages: "flatland" (the
# program, its desktop files and documents) and "dev" (headers, library and CMake package of
# flatland/, for other programs to use).
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

# The program.
install(TARGETS flatland_app RUNTIME COMPONENT flatland)
if(FLATLAND_GUI)
  install(FILES packaging/flatland.desktop
          DESTINATION ${CMAKE_INSTALL_DATADIR}/applications COMPONENT flatland)
  install(FILES packaging/flatland.metainfo.xml RENAME org.flatland_curves.flatland.metainfo.xml
          DESTINATION ${CMAKE_INSTALL_DATADIR}/metainfo COMPONENT flatland)
  install(FILES packaging/flatland.svg
          DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps COMPONENT flatland)
  install(FILES packaging/flatland-mime.xml
          DESTINATION ${CMAKE_INSTALL_DATADIR}/mime/packages RENAME flatland.xml COMPONENT flatland)
endif()

# Documents and licences.
install(FILES README.md CHANGELOG.md LICENSE packaging/copyright DESTINATION ${CMAKE_INSTALL_DOCDIR}
        COMPONENT flatland)
install(FILES flatland/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} RENAME LICENSE.flatland-core
        COMPONENT flatland)
install(DIRECTORY docs DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT flatland)

# The library of flatland/. Installed headers are included as in the tree, "flatland/view/view.h".
set_target_properties(flatland_core PROPERTIES EXPORT_NAME core)
# The inline arithmetic of roots/double_double.h is compiled by whoever includes it, and needs the same
# care there; see flatland_target.
target_compile_options(flatland_core INTERFACE $<INSTALL_INTERFACE:-ffp-contract=off>)
target_compile_features(flatland_core PUBLIC cxx_std_20)
install(TARGETS flatland_core EXPORT flatland ARCHIVE COMPONENT dev
        INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(DIRECTORY flatland DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT dev
        FILES_MATCHING PATTERN "*.h" REGEX "io/(json_text|json_node|curve_json|surface_json)\\.h$" EXCLUDE)
install(FILES flatland/LICENSE packaging/copyright
        DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/libflatland-dev COMPONENT dev)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/flatland)
install(EXPORT flatland NAMESPACE flatland:: FILE flatland-targets.cmake
        DESTINATION ${package_dir} COMPONENT dev)
configure_package_config_file(
  ${CMAKE_CURRENT_LIST_DIR}/flatland-config.cmake.in
  ${PROJECT_BINARY_DIR}/cmake/flatland-config.cmake INSTALL_DESTINATION ${package_dir})
# Before 1.0 a new minor version may change the interface.
write_basic_package_version_file(${PROJECT_BINARY_DIR}/cmake/flatland-config-version.cmake
                                 COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/cmake/flatland-config.cmake
              ${PROJECT_BINARY_DIR}/cmake/flatland-config-version.cmake
        DESTINATION ${package_dir} COMPONENT dev)
