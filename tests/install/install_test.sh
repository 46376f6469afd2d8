#!/bin/sh
# The Debian package, made of what ./bootstrap run builds and unpacked into a scratch root, renders a scene without the
# checkout, and takes a renderer into the user's own file.
#   install_test.sh <build folder> <cpack>
set -eu
build=$1 cpack=$2
folder=$(mktemp -d "${TMPDIR:-/tmp}/orbs-install-XXXXXX")
trap 'rm -rf "$folder"' EXIT
fail() { echo "install_test: $*" >&2; exit 1; }

"$cpack" -G DEB --config "$build/CPackConfig.cmake" -B "$folder/package" >"$folder/cpack.log" 2>&1 ||
  { cat "$folder/cpack.log" >&2; fail "cpack failed"; }
package=$(echo "$folder"/package/*.deb)
depends=$(dpkg-deb -f "$package" Depends)
for library in libembree3 libopenexr libpng libopenimageio libfmt libc6; do
  case $depends in *"$library"*) ;; *) fail "the package does not depend on $library: $depends" ;; esac
done
dpkg-deb -x "$package" "$folder/root"
for file in bin/orbs share/man/man1/orbs.1 share/man/man1/orbs-tracer.1 share/doc/orbs/docs/use/installed.md share/doc/orbs/examples/minimal-renderer/minimal_renderer.cpp share/bash-completion/completions/orbs share/zsh/vendor-completions/_orbs \
  share/fish/vendor_completions.d/orbs.fish lib/orbs/configuration.json lib/orbs/liborbs-image-formats.so; do
  [ -s "$folder/root/usr/$file" ] || fail "$file is missing"
done
grep -q 'compare.*runs' "$folder/root/usr/share/man/man1/orbs.1" || fail "the manual lacks a command"
bash -n "$folder/root/usr/share/bash-completion/completions/orbs" || fail "the completion is no bash script"

mkdir "$folder/work"
cd "$folder/work"
"$folder/root/usr/bin/orbs" run -r orbs -s 101 --size 1/8 -o out || fail "the installed program does not pass scene 101"
XDG_CONFIG_HOME=$folder/own; export XDG_CONFIG_HOME
before=$(cksum <"$folder/root/usr/lib/orbs/configuration.json")
"$folder/root/usr/bin/orbs" renderer add mine --executable /bin/true >added.txt || fail "no renderer can be added"
[ -s "$folder/own/orbs/configuration.json" ] || fail "the entry is not in the user's own file: $(cat added.txt)"
[ "$before" = "$(cksum <"$folder/root/usr/lib/orbs/configuration.json")" ] || fail "the installed file has changed"
"$folder/root/usr/bin/orbs" run -r mine -s 101 --size 1/8 --dry-run >plan.txt || fail "the added renderer cannot be planned"
! grep -q "$build" out/results.json || fail "the run has used the build folder"
