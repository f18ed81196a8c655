# bash completion for lasius: the program says what may follow, from the tables of its --help.
_lasius() {
  # Words as typed: readline parts them at "=" and ":", too.
  local words=() word bare rest=${COMP_LINE:0:COMP_POINT} i
  for ((i = 0; i <= COMP_CWORD; i++)); do
    bare=${rest#"${rest%%[![:space:]]*}"}
    word=${COMP_WORDS[i]}
    ((i < COMP_CWORD)) || word=$bare
    if ((i == 0)) || [[ $bare != "$rest" ]]; then words+=("$word"); else words[-1]+=$word; fi
    rest=${bare#"$word"}
  done
  local current=${words[-1]}
  local end=${current##*[=:]}
  local before=${current%"$end"} meaning file ending
  COMPREPLY=()
  while IFS=$'\t' read -r word meaning; do
    case $word in
      :files)
        compopt -o filenames
        while read -r file; do
          [[ -n $meaning && ! -d ${file/#\~/$HOME} ]] || { COMPREPLY+=("$file") && continue; }
          for ending in $meaning; do
            [[ ${file,,} != *"$ending" ]] || { COMPREPLY+=("$file") && break; }
          done
        done < <(compgen -f -- "$end")
        ;;
      :folders)
        compopt -o filenames
        while read -r file; do COMPREPLY+=("$file"); done < <(compgen -d -- "$end")
        ;;
      *)
        [[ $word != *= ]] || compopt -o nospace
        COMPREPLY+=("${word#"$before"}")
        ;;
    esac
  done < <("${words[0]/#\~/$HOME}" complete "${words[@]:1}" 2>/dev/null)
}
complete -F _lasius lasius lasius_mpi
