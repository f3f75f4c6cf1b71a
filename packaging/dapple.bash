# Completion of dapple's and dapple-lab's words in bash; what there is, the program says itself.
_dapple() {
    # Words that bash takes apart at colons are put together again; of them it wants what follows the last colon.
    local word before= words=()
    for word in "${COMP_WORDS[@]:1:COMP_CWORD}"; do
        if [[ ${#words[@]} -gt 0 && ( $word == : || $before == : ) ]]; then words[-1]+=$word; else words+=("$word"); fi
        before=$word
    done
    mapfile -t COMPREPLY < <("$1" complete -- "${words[@]}" 2>/dev/null)
    COMPREPLY=("${COMPREPLY[@]%%$'\t'*}")
    local last=${words[-1]}
    COMPREPLY=("${COMPREPLY[@]#"${last%"${last##*:}"}"}")
}
# Where the program says nothing, files.
complete -o default -F _dapple dapple dapple-lab
