# Completion for ghostforce.
function __ghostforce_complete
    set -l typed (commandline -opc)
    set -l current (commandline -ct)
    set -l program (string replace -r '^~' ~ -- $typed[1])
    set -l answer ($program __complete $typed[2..] "$current" 2>/dev/null)
    string join -- \n $answer[2..]
    set -l kind (string split -m 1 ' ' -- $answer[1])
    set -l before $kind[2]
    set -l value (string sub -s (math 1 + (string length -- "$before")) -- "$current")
    switch "$kind[1]"
        case any
            printf '%s\n' $before(__fish_complete_path $value)
        case toml
            printf '%s\n' $before(__fish_complete_path $value | string match -r -- '^.*(?:/|[.]toml)(?:\t.*)?$')
        case folders
            printf '%s\n' $before(__fish_complete_path $value | string match -r -- '^.*/(?:\t.*)?$')
    end
end

complete -c ghostforce -f -a '(__ghostforce_complete)'
