#!/bin/sh
# Is every C++ file formatted as .clang-format says?   clang_format.sh <repository>
# Version 14 only: other versions break the same lines differently. Without it the test is skipped, which 77 says to ctest.
set -eu
cd "$1"
tool=$(command -v clang-format-14 || command -v clang-format) || {
  echo "clang-format 14 is not installed, so the layout of the sources was not checked."
  exit 77
}
case $("$tool" --version) in
  *"version 14."*) ;;
  *) echo "$tool is not version 14, the one that this code is formatted with, so the layout was not checked."; exit 77 ;;
esac
find src tests data/snippets examples include plugins \( -name "*.cpp" -o -name "*.h" -o -name "*.inc" \) -exec "$tool" --dry-run -Werror {} + || {
  echo "To format them: clang-format -i <files>" >&2
  exit 1
}
