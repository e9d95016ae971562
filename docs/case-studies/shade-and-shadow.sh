#!/usr/bin/env bash
# The paper's second case study (section 8.2) on the sample: wanted shade against unwanted shadow over a year,
# 8 hours a day, with the paper's monthly weights, for the park and three quarters of different density.
#   docs/case-studies/shade-and-shadow.sh [FOLDER]      NOONMARK_CLI: the program, if it is not on the PATH
set -euo pipefail
cli=${NOONMARK_CLI:-noonmark-cli}
out=${1:-shade-and-shadow}
project="$out/shade-and-shadow.noonmark.gpkg"

mkdir -p "$out"
"$cli" project new "$project" sample:central-park-south --overwrite \
    --region "Midtown=-73.9837,40.7608,-73.9779,40.7652" \
    --region "Upper West Side=-73.9847,40.7711,-73.9788,40.7756" \
    --region "Upper East Side=-73.9698,40.7648,-73.9639,40.7693"
for region in "Park" "Midtown" "Upper West Side" "Upper East Side"; do
    printf '\n== %s\n' "$region"
    "$cli" score "$project" --weights default --region "$region" --start 2026-01-01 --days 365 --at 08:00 --hours 8 \
        --zone America/New_York --cell 2 --out "$out/$region" --overwrite --keep "$region"
done
