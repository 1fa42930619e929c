# Options are offered to who begins one; a word that stands in the line already says that the place of its kind is taken.
# Where nothing is left, bash offers files.
_mavc_words() {
    _mavc "$@"
    local offer earlier kept=()
    if [[ $2 != -* ]]; then
        for offer in "${COMPREPLY[@]}"; do
            for earlier in "${COMP_WORDS[@]:1:COMP_CWORD-1}"; do
                [[ ${offer} == "${earlier}" ]] && { COMPREPLY=(); return 0; }
            done
            [[ ${offer} == -* ]] || kept+=("${offer}")
        done
        COMPREPLY=("${kept[@]}")
    fi
}

