# Run at every build: writes OUT, which has the commit that SOURCE stands at, anew where that has changed.
execute_process(COMMAND git -C ${SOURCE} rev-parse --short HEAD OUTPUT_VARIABLE commit RESULT_VARIABLE failed
  OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
execute_process(COMMAND git -C ${SOURCE} diff --quiet HEAD -- src include RESULT_VARIABLE changed ERROR_QUIET)
if(failed)
  set(commit "")
elseif(changed)
  string(APPEND commit "+")
endif()
file(CONFIGURE OUTPUT ${OUT} CONTENT "#include \"app/version.h\"\n\nconst char version_commit[] = \"${commit}\";\n")
