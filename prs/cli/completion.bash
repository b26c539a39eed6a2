# Completion of prs in bash. `prs completion bash` wrote it.
_prs_words() { mapfile -t COMPREPLY < <(compgen -W "$*" -- "$current"); }
_prs_list() { _prs_words "$(prs list "$1" 2>/dev/null | @SED@)"; }
_prs_settings() {
  compopt -o nospace
  mapfile -t COMPREPLY < <(compgen -S = -W "$(prs list inputs 2>/dev/null | @SED@)" -- "$current")
}
_prs_files() {
  compopt -o filenames
  mapfile -t COMPREPLY < <(compgen -f -- "$current")
}
_prs_folders() {
  compopt -o filenames
  mapfile -t COMPREPLY < <(compgen -d -- "$current")
}
_prs_cases() {
  compopt -o filenames
  mapfile -t COMPREPLY < <(compgen -W "$*" -- "$current"; compgen -d -- "$current"
                           compgen -f -X '!*.yaml' -- "$current"
                           compgen -f -X '!*.yml' -- "$current")
}
_prs() {
  local current=${COMP_WORDS[COMP_CWORD]} before='' command='' word action=: i at=0
  COMPREPLY=()
  for ((i = 1; i < COMP_CWORD; ++i)); do
    word=${COMP_WORDS[i]}
    case "$command $before" in
      @VALUES@) before=''; continue ;;
    esac
    before=$word
    case "$command/$word" in
@COMMANDS@
      */-*) ;;
      *) ((++at)) ;;
    esac
  done
  case "$command $before" in
@OPTIONS@
    *)
      case "$command" in
@ARGUMENTS@
      esac
      if [[ $current == -* ]]; then
        case "$command" in
@NAMES@
        esac
      fi ;;
  esac
  [[ $action == : ]] || _prs_$action
}
complete -F _prs prs
