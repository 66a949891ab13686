# cmake --install BUILD --prefix P: the programs in P/bin, and in P/share/tessera what goes with them, in the repository's
# own layout, so that the links between the documents hold. Nothing in it knows where it was built or installed: it can be
# moved as a whole. Another program of the build is one more target here.
include(GNUInstallDirs)

set(TESSERA_SHARE ${CMAKE_INSTALL_DATADIR}/tessera)
install(TARGETS tessera RUNTIME)
install(TARGETS tessera-bench RUNTIME OPTIONAL)  # where it was built
install(FILES README.md ARCHITECTURE.md LICENSE DESTINATION ${TESSERA_SHARE})
install(DIRECTORY docs jobs examples DESTINATION ${TESSERA_SHARE})
install(DIRECTORY slurm DESTINATION ${TESSERA_SHARE} USE_SOURCE_PERMISSIONS)
