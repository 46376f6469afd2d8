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
for library in libembree libopenexr libpng libopenimageio libfmt libc6; do
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

# The renderer of a user who is not root, in a project of its own: another folder, with a space in its name, under a
# strict umask, and nothing of the checkout in sight.
project="$folder/a project"
mkdir "$project" "$project/home"
cp "$build/minimal-renderer/minimal-renderer" "$project/"
chmod a+rx "$folder" "$project"
if [ "$(id -u)" -eq 0 ]; then
  chown -R nobody "$project"
  plain() { setpriv --reuid=nobody --regid=nogroup --clear-groups "$@"; }
else
  plain() { "$@"; }
fi
cat >"$project/steps.sh" <<'STEPS'
set -eu
umask 077
fail() { echo "install_test: as a plain user: $*" >&2; exit 1; }
orbs=$1
cd "$2"
HOME=$PWD/home XDG_CONFIG_HOME=$PWD/home/.config; export HOME XDG_CONFIG_HOME
"$orbs" renderer add mine --here --executable ./minimal-renderer --declares G3/M4/L2/A1 \
  -- '{executable}' '{scene}' '{output}' --spp '{spp}' --seed '{seed}' --threads '{threads}' >added.txt 2>&1 ||
  fail "no renderer can be added: $(cat added.txt)"
grep -q '"mine"' configuration.json || fail "the entry is not in the project's file"
[ ! -e home/.config/orbs ] || fail "--here has written into the user's own file"
"$orbs" doctor -r mine >doctor.txt || fail "doctor: $(cat doctor.txt)"
head -1 doctor.txt | grep -q '^mine' || fail "doctor does not begin with what it was asked for: $(cat doctor.txt)"
"$orbs" run -r mine -s 101-depth1 --size 1/8 >run.txt 2>&1 || fail "the run: $(cat run.txt)"
"$orbs" card mine >card.txt || fail "card: $(cat card.txt)"
grep -q 'right on its target' card.txt || fail "the card does not say that it is right: $(cat card.txt)"
"$orbs" open 101-depth1 --print >images.txt || fail "open: $(cat images.txt)"
[ "$(wc -l <images.txt)" -eq 2 ] || fail "open names no two images: $(cat images.txt)"
"$orbs" render -r mine -s 101-depth1 --size 1/8 --spp 4 -o x.exr || fail "render makes no image"
"$orbs" compare x.exr "$(tail -1 images.txt)" >compare.txt 2>&1 || [ $? -eq 1 ] || fail "compare: $(cat compare.txt)"
STEPS
plain sh "$project/steps.sh" "$folder/root/usr/bin/orbs" "$project" || fail "the installed program fails for a plain user"
