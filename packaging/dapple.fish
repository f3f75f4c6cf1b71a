# Completion of dapple's words in fish; what there is, the program says itself.
function __dapple_complete
    set -l words (commandline -opc)
    set -l word (commandline -ct)
    set -l found ($words[1] complete -- $words[2..] "$word" 2>/dev/null)
    if set -q found[1]
        printf '%s\n' $found
    else
        __fish_complete_path "$word"
    end
end
complete -c dapple -f -a '(__dapple_complete)'
complete -c dapple-lab -f -a '(__dapple_complete)'
