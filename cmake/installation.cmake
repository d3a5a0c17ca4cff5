# What `cmake --install` puts beside the program, its plugins and the headers for plugins: completion and manual pages,
# the documentation and the experiments that it takes its examples from. And the Debian package that CPack makes of all
# that is installed (tools/package).
include(shell_files)

set(documents ${CMAKE_INSTALL_DATADIR}/doc/lacuna)
install(FILES README.md DESTINATION ${documents})
install(FILES LICENSE DESTINATION ${documents} RENAME copyright)
install(DIRECTORY docs schema DESTINATION ${documents})

set(examples ${CMAKE_INSTALL_DATADIR}/lacuna/experiments)
install(FILES experiments/first-steps.toml experiments/servo-pendulum.toml experiments/damped-flap.toml experiments/lifting-servo.toml
  DESTINATION ${examples})
install(DIRECTORY experiments/robots experiments/smoke DESTINATION ${examples})
install(DIRECTORY experiments/data DESTINATION ${examples} FILES_MATCHING PATTERN "*.csv" PATTERN "README.md")

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME lacuna)
set(CPACK_PACKAGE_CONTACT "Lacuna")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "finds the physical effect that a robot model is missing")
set(CPACK_PACKAGE_DESCRIPTION
  "Fits a rigid-body model to recordings of a robot, says how far its predictions are off in multiples of the noise, and names the physical effect that is missing. With plugins for robots, effects, metrics and searches, and headers for further ones.")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)  # the libraries that program and plugins are linked to, with their versions
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS gnuplot-nox)                  # pictures
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "cmake, g++, libeigen3-dev, python3")  # plugins of one's own; the Python package
set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY ON)  # tools/package has built what is installed; the tests are not
include(CPack)
