# cmake --install BUILD --prefix P: installs the programs into P/bin, and their data into P/share/tessera.
# The data keep the repository's layout, so that the links between the documents work.
# No installed file holds the path of the build or the installation, so the whole can be moved. A further program is one more target here.
include(GNUInstallDirs)

set(TESSERA_SHARE ${CMAKE_INSTALL_DATADIR}/tessera)
install(TARGETS tessera RUNTIME)
install(TARGETS tessera-bench RUNTIME OPTIONAL)  # if it was built
install(FILES README.md ARCHITECTURE.md LICENSE DESTINATION ${TESSERA_SHARE})
install(DIRECTORY docs jobs examples DESTINATION ${TESSERA_SHARE})
install(DIRECTORY slurm DESTINATION ${TESSERA_SHARE} USE_SOURCE_PERMISSIONS)
