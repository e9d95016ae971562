# The tasks of a plan on one machine, or on several that share a folder, with GNU parallel:
#
#   make -f packaging/parallel.mk PLAN=plan JOBS=8 merge
#   make -f packaging/parallel.mk PLAN=plan SSH=--sshloginfile=nodes JOBS=8 merge
#
# Tasks that failed in passing (75, killed) are tried up to three times; run it again for the rest.
NOONMARK ?= noonmark-cli
JOBS ?= 2
THREADS ?= 1
SSH ?=

.PHONY: run merge status
run:
	seq 0 $$(( $$($(NOONMARK) tiles status $(PLAN) --json | sed -n 's/.*"tasks": \([0-9]*\),.*/\1/p') - 1 )) | \
	    parallel $(SSH) --jobs $(JOBS) --retries 3 --joblog $(PLAN)/parallel.log \
	        $(NOONMARK) tiles run $(PLAN) --task {} --threads $(THREADS)
merge: run
	$(NOONMARK) tiles merge $(PLAN)
status:
	$(NOONMARK) tiles status $(PLAN)
