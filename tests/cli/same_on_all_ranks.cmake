# cmake -DTESSERA=binary -DMPIRUN=mpirun -DFOLDER=new-folder -P same_on_all_ranks.cmake
# The whole way, as a user goes it: drawings, library, job, collage; and the same pieces on 1, 2, 3 and 4 ranks, on two
# devices in one rank, and from the effective job.
set(ENV{OMPI_ALLOW_RUN_AS_ROOT} 1)
set(ENV{OMPI_ALLOW_RUN_AS_ROOT_CONFIRM} 1)
file(REMOVE_RECURSE ${FOLDER})
file(MAKE_DIRECTORY ${FOLDER})

function(draw name path)
  file(WRITE ${FOLDER}/drawings/${name}.svg
       "<svg xmlns='http://www.w3.org/2000/svg' width='100' height='100'><path fill='teal' d='${path}'/></svg>")
endfunction()
draw(bean "M10 50 C10 10 90 10 90 50 C90 90 70 60 50 60 C30 60 10 90 10 50Z")
draw(star "M50 5 L61 38 L95 38 L67 59 L78 93 L50 72 L22 93 L33 59 L5 38 L39 38Z")
draw(corner "M10 10 H90 V45 H45 V90 H10Z")
draw(leaf "M10 90 C10 30 50 10 90 10 C90 60 60 90 10 90Z")
draw(drop "M50 5 C60 40 85 50 85 70 A35 25 0 0 1 15 70 C15 50 40 40 50 5Z")
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

run(${TESSERA} library build drawings -o own.h5)
run(${TESSERA} collage small.toml --out first)
foreach(ranks 2 3 4)
  run(${MPIRUN} --oversubscribe --bind-to none -n ${ranks} ${TESSERA} collage small.toml --out ranks_${ranks})
endforeach()
set(ENV{POCL_DEVICES} "pthread pthread")
run(${TESSERA} collage small.toml --out two_devices)
unset(ENV{POCL_DEVICES})
run(${TESSERA} collage first/job.toml --out again)

file(READ ${FOLDER}/first/card.txt card)
if(NOT card MATCHES "stopped by +full")
  message(FATAL_ERROR "unexpected end:\n${card}")
endif()
if(NOT card MATCHES "of it improving[^\n]* [1-9][0-9]* of 12 ")
  message(FATAL_ERROR "no trial was kept, or not 12 were made:\n${card}")
endif()
foreach(other ranks_2 ranks_3 ranks_4 two_devices again)
  foreach(name pieces.geojson job.toml collage.png)
    file(SHA256 ${FOLDER}/first/${name} expected)
    file(SHA256 ${FOLDER}/${other}/${name} found)
    if(NOT found STREQUAL expected)
      message(FATAL_ERROR "${other}/${name} differs from first/${name}")
    endif()
  endforeach()
endforeach()
