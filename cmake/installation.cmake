# What `cmake --install` puts beside the program, its plugins and the headers for plugins: completion and manual pages,
# the documentation and the experiments that it takes its examples from.
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
