#!/bin/bash
# A sweep as a Slurm array: sbatch sim/ensemble/jobs/slurm.sh sweep.json
# A task that is lost runs again. Afterwards: hyrax-sim sweep --merge sweep.part-*.h5 -o sweep.h5
#SBATCH --job-name=hyrax-sweep
#SBATCH --array=0-99
#SBATCH --cpus-per-task=2
#SBATCH --mem=500M
#SBATCH --requeue
#SBATCH --open-mode=append
exec hyrax-sim sweep "$1" --threads "${SLURM_CPUS_PER_TASK:-1}"
