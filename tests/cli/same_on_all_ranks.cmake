# cmake -DTESSERA=binary -DMPIRUN=mpirun -DFOLDER=new-folder -P same_on_all_ranks.cmake
# The whole way as a user goes it: drawings, library, job, collage.
# The pieces are the same on 1, 2, 3, 4, 8 and 16 ranks (with 16 the master asks 8, which ask the others).
# They are also the same on 2 and 8 devices in one rank, on 2 devices in each of 3 ranks, and from the effective job.
set(ENV{OMPI_ALLOW_RUN_AS_ROOT} 1)
set(ENV{OMPI_ALLOW_RUN_AS_ROOT_CONFIRM} 1)
file(REMOVE_RECURSE ${FOLDER})
file(MAKE_DIRECTORY ${FOLDER})

file(WRITE ${FOLDER}/small.toml
     "[library]\nfile = 'own.h5'\n[canvas]\nsize_px = [160, 120]\n"
     "[pieces]\nscale_px = [14, 60]\n[improve]\ntrials = 12\n[output]\nwidth_px = 160\n")

function(run)
  execute_process(COMMAND ${ARGN} WORKING_DIRECTORY ${FOLDER}
                  RESULT_VARIABLE code OUTPUT_VARIABLE out ERROR_VARIABLE out)
  if(NOT code EQUAL 0)
    message(FATAL_ERROR "exit code ${code} of ${ARGN}\n${out}")
  endif()
endfunction()

run(bash -c ". ${CMAKE_CURRENT_LIST_DIR}/../support/drawings.sh && make_drawings drawings")
run(${TESSERA} library build drawings -o own.h5)
run(${TESSERA} collage small.toml --out first)
foreach(ranks 2 3 4 8 16)
  run(${MPIRUN} --oversubscribe --bind-to none -n ${ranks} ${TESSERA} collage small.toml --out ranks_${ranks})
endforeach()
set(ENV{POCL_DEVICES} "pthread pthread")
run(${TESSERA} collage small.toml --out devices_2)
run(${MPIRUN} --oversubscribe --bind-to none -n 3 ${TESSERA} collage small.toml --out ranks_3_devices_2)
run(${MPIRUN} --oversubscribe --bind-to none -n 3 ${TESSERA} collage small.toml --set devices.per_worker=1
    --out own_devices)
set(ENV{POCL_DEVICES} "pthread pthread pthread pthread pthread pthread pthread pthread")
run(${TESSERA} collage small.toml --out devices_8)
unset(ENV{POCL_DEVICES})
run(${TESSERA} collage first/job.toml --out again)

file(READ ${FOLDER}/first/card.txt card)
if(NOT card MATCHES "stopped by +full")
  message(FATAL_ERROR "unexpected end:\n${card}")
endif()
if(NOT card MATCHES "of it improving[^\n]* [1-9][0-9]* of 12 ")
  message(FATAL_ERROR "no trial was kept, or not 12 were made:\n${card}")
endif()
file(SHA256 ${FOLDER}/first/job.toml expected)
foreach(other ranks_16 again)
  file(SHA256 ${FOLDER}/${other}/job.toml found)
  if(NOT found STREQUAL expected)
    message(FATAL_ERROR "${other}/job.toml differs from first/job.toml")
  endif()
endforeach()
foreach(other ranks_2 ranks_3 ranks_4 ranks_8 ranks_16 devices_2 ranks_3_devices_2 own_devices devices_8 again)
  foreach(name pieces.geojson collage.png)
    file(SHA256 ${FOLDER}/first/${name} expected)
    file(SHA256 ${FOLDER}/${other}/${name} found)
    if(NOT found STREQUAL expected)
      message(FATAL_ERROR "${other}/${name} differs from first/${name}")
    endif()
  endforeach()
endforeach()
