# fish complete.fish SCRIPT LINE...: for each line, "> LINE" and what the completion script offers at its end.
source $argv[1]
for line in $argv[2..]
    echo "> $line"
    complete -C $line | string replace -r '\t.*' ''
end
