# refuses(<program> <what the line must contain> <arguments>...): the program must end with status 2, one line on stderr
# that begins with its name, and nothing on stdout. It runs in `folder`. The program may be a list with a subcommand.
function(refuses program expected)
  list(GET program 0 path)
  get_filename_component(name "${path}" NAME)
  string(REPLACE "${path}" "${name}" name "${program}")
  string(REPLACE ";" " " name "${name}")
  execute_process(
    COMMAND ${program} ${ARGN}
    WORKING_DIRECTORY "${folder}"
    TIMEOUT 60
    RESULT_VARIABLE status
    OUTPUT_VARIABLE output
    ERROR_VARIABLE error)
  if(NOT status EQUAL 2)
    message(SEND_ERROR "${name} ${ARGN}: exit status ${status} instead of 2: ${error}")
  endif()
  if(NOT error MATCHES "^${name}: error: [^\n]*\n$")
    message(SEND_ERROR "${name} ${ARGN}: not one line: ${error}")
  endif()
  string(FIND "${error}" "${expected}" position)
  if(position EQUAL -1)
    message(SEND_ERROR "${name} ${ARGN}: \"${expected}\" is not in: ${error}")
  endif()
  if(NOT output STREQUAL "")
    message(SEND_ERROR "${name} ${ARGN}: wrote to stdout: ${output}")
  endif()
endfunction()
