# fish completion for lasius: the program says what may follow, from the tables of its --help.
function __lasius_complete
    set -l words (commandline --tokenize --current-process --cut-at-cursor)
    set -l current (commandline --current-token --cut-at-cursor)
    set -l program (string replace --regex '^~' $HOME -- $words[1])
    set -l before (string match --regex '^.*=' -- $current)
    set -l end (string replace --regex '^.*=' '' -- $current)
    for line in ($program complete $words[2..] "$current" 2>/dev/null)
        set -l parts (string split --max 1 \t -- $line)
        switch $parts[1]
            case :files
                set -l endings (string split --no-empty ' ' -- $parts[2])
                set -l wanted (string join '|' -- (string escape --style=regex -- $endings))
                test -n "$wanted" || set wanted '.'
                string match --regex --ignore-case ".*/\$|.*($wanted)\$" -- (__fish_complete_path $end | string replace --regex '\t.*' '') | string match --entire --regex '[./]' | string replace --regex '^' "$before"
            case :folders
                __fish_complete_directories $end '' | string replace --regex '^' "$before"
            case '*'
                echo $line
        end
    end
end
complete --command lasius --command lasius_mpi --no-files --arguments '(__lasius_complete)'
