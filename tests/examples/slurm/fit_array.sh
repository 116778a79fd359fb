#!/bin/sh
# Fits an archive of experiments on many machines: sbatch --array=1-10 fit_array.sh, and then
# mixity merge parts/*.json --out=fits.json. MIXITY is the program, FILES what to fit, PARTS where the parts go.
#SBATCH --job-name=mixity
#SBATCH --array=1-10
set -eu
: "${MIXITY:=mixity}" "${FILES:=experiments/*.csv}" "${PARTS:=parts}"
mkdir -p "$PARTS"
part=$(printf '%s/%04d.json' "$PARTS" "$SLURM_ARRAY_TASK_ID")
# 1: a fit is not ok, which its status says; what is broken ends the task
# shellcheck disable=SC2086 # a pattern
"$MIXITY" fit $FILES --shard="$SLURM_ARRAY_TASK_ID/$SLURM_ARRAY_TASK_COUNT" --format=json >"$part.tmp" || [ $? -eq 1 ]
mv "$part.tmp" "$part"
