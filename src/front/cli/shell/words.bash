# Options are offered to who begins one; a word that stands in the line already says that the place of its kind is taken.
# Where nothing is left, bash offers files. It parts words at colons, and completes the last part: a code is put together,
# and what stands of it taken off the offers.
_mavc_words() {
    local offer earlier kept=() typed=${COMP_LINE:0:COMP_POINT}
    typed=${typed##*[[:space:]]}
    [[ ${typed} == *:* ]] || typed=$2
    _mavc "$1" "${typed}" "$3"
    if [[ $2 != -* ]]; then
        for offer in "${COMPREPLY[@]}"; do
            for earlier in "${COMP_WORDS[@]:1:COMP_CWORD-1}"; do
                [[ ${offer} == "${earlier}" ]] && { COMPREPLY=(); return 0; }
            done
            [[ ${offer} == -* ]] || kept+=("${offer}")
        done
        COMPREPLY=("${kept[@]}")
    fi
    [[ ${typed} == *:* ]] && COMPREPLY=("${COMPREPLY[@]#"${typed%:*}:"}")
    return 0
}

