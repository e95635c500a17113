# Where everything goes with `cmake --install`, and what `cpack -G DEB` puts into the Debian package.
#
#   component program      glisson, glisson-cli, their resources, desktop entry, manual pages: the Debian package
#   component python       the package for Python: the Debian package python3-glisson
#   component development  the core's headers and libraries, for find_package(Glisson)
set(CMAKE_INSTALL_DOCDIR share/doc/glisson)
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(share ${PROJECT_SOURCE_DIR}/packaging)

# Debian wants manual pages and change logs compressed, without a time in them.
function(install_compressed file destination name)
  set(compressed ${PROJECT_BINARY_DIR}/installed/${name}.gz)
  add_custom_command(OUTPUT ${compressed} DEPENDS ${file}
    COMMAND ${CMAKE_COMMAND} -E make_directory ${PROJECT_BINARY_DIR}/installed
    COMMAND sh -c "gzip -9n <'${file}' >'${compressed}'" VERBATIM)
  add_custom_target(compressed_${name} ALL DEPENDS ${compressed})
  install(FILES ${compressed} DESTINATION ${destination} COMPONENT program)
endfunction()

# --- the program
install(TARGETS glisson-cli COMPONENT program)
set(resources ${PROJECT_SOURCE_DIR}/resources)
install(DIRECTORY ${resources}/devices ${resources}/examples ${resources}/manual ${resources}/studies
  DESTINATION ${CMAKE_INSTALL_DATADIR}/glisson/resources COMPONENT program)
install(FILES ${resources}/ATTRIBUTION.md DESTINATION ${CMAKE_INSTALL_DATADIR}/glisson/resources COMPONENT program)
install(FILES ${share}/completion/glisson-cli DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions
  COMPONENT program)
install_compressed(${share}/man/glisson-cli.1 ${CMAKE_INSTALL_MANDIR}/man1 glisson-cli.1)
install_compressed(${PROJECT_SOURCE_DIR}/CHANGELOG.md ${CMAKE_INSTALL_DOCDIR} changelog)
install(FILES ${PROJECT_SOURCE_DIR}/README.md DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program)
install(FILES ${share}/debian-copyright DESTINATION ${CMAKE_INSTALL_DOCDIR} RENAME copyright COMPONENT program)
if(TARGET glisson)
  install(TARGETS glisson COMPONENT program)
  install_compressed(${share}/man/glisson.1 ${CMAKE_INSTALL_MANDIR}/man1 glisson.1)
  install(FILES ${share}/desktop/io.glisson.Glisson.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications
    COMPONENT program)
  install(FILES ${share}/desktop/io.glisson.Glisson.metainfo.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/metainfo
    COMPONENT program)
  install(FILES ${share}/desktop/io.glisson.Glisson.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/mime/packages
    COMPONENT program)
  install(FILES ${PROJECT_SOURCE_DIR}/resources/icons/glisson.svg RENAME io.glisson.Glisson.svg
    DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps COMPONENT program)
endif()

# --- the package for Python
set(CPACK_COMPONENTS_ALL program)
if(TARGET glisson_python)
  list(APPEND CPACK_COMPONENTS_ALL python)
  set(python_packages lib/python3/dist-packages)  # Debian's place for what comes as a package
  install(DIRECTORY ${PROJECT_BINARY_DIR}/python/glisson DESTINATION ${python_packages} COMPONENT python
    FILES_MATCHING PATTERN "*.py" PATTERN "*.pyi" PATTERN "py.typed")
  install(TARGETS glisson_python LIBRARY DESTINATION ${python_packages}/glisson COMPONENT python)
  install(FILES ${share}/debian-copyright DESTINATION share/doc/python3-glisson RENAME copyright COMPONENT python)
endif()

# --- the core, to build on
get_property(rooms GLOBAL PROPERTY GLISSON_ROOMS)
set_target_properties(glisson_options PROPERTIES EXPORT_NAME options)
set(exported glisson_options)
foreach(room IN LISTS rooms)
  set_target_properties(glisson_${room} PROPERTIES EXPORT_NAME ${room})
  list(APPEND exported glisson_${room})
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/core/${room} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/glisson
    COMPONENT development FILES_MATCHING PATTERN "*.h" PATTERN "internal" EXCLUDE)
endforeach()
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/Glisson)
install(TARGETS ${exported} EXPORT GlissonTargets COMPONENT development
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
install(EXPORT GlissonTargets NAMESPACE glisson:: DESTINATION ${package_folder} COMPONENT development)
configure_package_config_file(${share}/cmake/GlissonConfig.cmake.in ${PROJECT_BINARY_DIR}/GlissonConfig.cmake
  INSTALL_DESTINATION ${package_folder})
# Until 1.0 a minor version may change what headers promise.
write_basic_package_version_file(${PROJECT_BINARY_DIR}/GlissonConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/GlissonConfig.cmake ${PROJECT_BINARY_DIR}/GlissonConfigVersion.cmake
  DESTINATION ${package_folder} COMPONENT development)

# --- the Debian package
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME glisson)
set(CPACK_PACKAGE_CONTACT "Glisson maintainers <maintainers@users.noreply.github.com>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "planning and reviewing liver surgery (research software)")
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION
"A liver comes in as DICOM, is segmented, meshed, given the patient's own
stiffness from MR elastography, and pulled aside by a retractor; tumours and
vessels are followed, and displacements of 5 mm or more are flagged.
.
Not a medical device: nothing it shows may guide the treatment of a patient.")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME glisson)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# What the programs load by name while they run, and dpkg-shlibdeps cannot see: Mesa, letters, Qt's reader of icons and
# its own words in other languages; and a BLAS that factorises 13 times faster than the one that would be chosen otherwise.
set(CPACK_DEBIAN_PACKAGE_DEPENDS "libegl-mesa0, libgl1-mesa-dri, fonts-dejavu-core, libqt6svg6, qt6-translations-l10n, libopenblas0-pthread")
set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-glisson)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_DESCRIPTION
"the core of Glisson for Python: livers as numpy arrays
Images, segmentation, meshes, mechanics, registration and its quality as
functions over numpy arrays.
.
Not a medical device: nothing it shows may guide the treatment of a patient.")
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "python3 (>= ${GLISSON_PYTHON_VERSION}), python3 (<< ${GLISSON_NEXT_PYTHON}), python3-numpy, libopenblas0-pthread, libegl-mesa0, libgl1-mesa-dri, fonts-dejavu-core")
set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS glisson)
include(CPack)
