# Completion of dapple's words in bash; what there is, the program says itself.
_dapple() {
    mapfile -t COMPREPLY < <("$1" complete -- "${COMP_WORDS[@]:1:COMP_CWORD}" 2>/dev/null)
    COMPREPLY=("${COMPREPLY[@]%%$'\t'*}")
}
# Where the program says nothing, files.
complete -o default -F _dapple dapple
