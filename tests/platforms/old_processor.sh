#!/bin/sh
# On a processor without AVX2 each program says so, in place of ending with a signal: old_processor.sh <programs...>
# QEMU is the old processor; without its qemu-x86_64 the test is skipped.
command -v qemu-x86_64 >/dev/null || { echo "there is no qemu-x86_64: the package qemu-user is not installed"; exit 77; }
problems=0
for program; do
  for processor in Westmere IvyBridge; do
    said=$(qemu-x86_64 -cpu "$processor" "$program" --version 2>&1)
    status=$?
    case "$status $said" in
      "2 "*": this processor has no AVX"*"; expected x86-64-v3"*) ;;
      *) problems=1; echo "$program on $processor: exit status $status, expected 2 and a sentence: $said" ;;
    esac
  done
done
exit $problems
