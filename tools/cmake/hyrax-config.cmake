# The package `hyrax`: hyrax::physics, the core library; hyrax::hyrax-sim, the program; hyrax_add_scenarios.
include(${CMAKE_CURRENT_LIST_DIR}/hyrax-targets.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/hyrax_add_scenarios.cmake)
