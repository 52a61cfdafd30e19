# The .deb: `cpack --config build/release/CPackConfig.cmake` after a build of the program. dpkg-shlibdeps finds what it
# depends on.
set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY ON)  # tests are not needed for it
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME amiss)
set(CPACK_PACKAGE_CONTACT "amiss maintainers <maintainers@amiss.invalid>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_RESOURCE_FILE_LICENSE ${CMAKE_SOURCE_DIR}/LICENSE)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# Films are made by ffmpeg, figures drawn by gnuplot.
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "ffmpeg, gnuplot-nox | gnuplot")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "bash-completion, parallel, slurm-client")
install(FILES ${CMAKE_SOURCE_DIR}/LICENSE DESTINATION share/doc/amiss RENAME copyright)
include(CPack)
