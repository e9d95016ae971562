#!/usr/bin/env bash
# The paper's first case study (section 8.1) on the sample: seven towers south of Central Park, Time Warner
# Center as the baseline, and the same floor area in shorter, wider towers. About a minute on two cores.
#   docs/case-studies/central-park.sh [FOLDER]      NOONMARK_CLI: the program, if it is not on the PATH
set -euo pipefail
cli=${NOONMARK_CLI:-noonmark-cli}
out=${1:-central-park}
project="$out/central-park.noonmark.gpkg"
towers=("One57" "432 Park Avenue" "111 West 57th Street" "Central Park Tower" "220 Central Park South"
        "53 West 53rd Street" "520 Park Avenue")

mkdir -p "$out"
"$cli" project new "$project" sample:central-park-south --overwrite
# The city without the seven, and the same without Time Warner Center.
"$cli" project add-scenario "$project" "Before"
"$cli" project demolish "$project" "${towers[@]}" --scenario "Before"
"$cli" project add-scenario "$project" "Before, without Time Warner Center" --base "Before"
"$cli" project demolish "$project" "Time Warner Center" --scenario "Before, without Time Warner Center"
# Twice the floor plate where the lot allows it, else the whole lot; the same floor area.
"$cli" project add-scenario "$project" "Shorter towers"
"$cli" project variant "$project" "${towers[@]}" --scenario "Shorter towers" --plate 2

impact() {  # season, start, from, to, folder
    printf '\n== %s: %s -> %s\n' "$1" "$3" "$4"
    "$cli" impact "$project" --from "$3" --to "$4" --region Park --start "$2" --days 61 --at 08:00 --hours 8 \
        --zone America/New_York --cell 2 --threshold 30 60 --by-building --out "$out/$5" --overwrite --keep "$1: $4"
}
impact "November and December" 2026-11-01 "Before, without Time Warner Center" "Before" winter-time-warner
impact "November and December" 2026-11-01 "Before" "Existing" winter-towers
impact "November and December" 2026-11-01 "Before" "Shorter towers" winter-shorter
impact "June and July" 2026-06-01 "Before, without Time Warner Center" "Before" summer-time-warner
impact "June and July" 2026-06-01 "Before" "Existing" summer-towers
impact "June and July" 2026-06-01 "Before" "Shorter towers" summer-shorter
