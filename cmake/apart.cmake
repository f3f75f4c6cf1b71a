# apart(FILE...): files of this folder's targets that the compiler reads alone where CMAKE_UNITY_BUILD has it read twenty
# at a time, since they have a local name that another of their target has too. "redefinition of" or "is ambiguous" in
# the preset dev alone says that one is missing here, or better gets a name of its own. So does a test that fails there and not
# with CMAKE_UNITY_BUILD=OFF: a call may find the function of that name in the file before.
function(apart)
    set_source_files_properties(${ARGN} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
endfunction()
