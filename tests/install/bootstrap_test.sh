#!/bin/bash
# What ./bootstrap does on systems that this one is not: apt-get, dpkg-query, sudo and sleep are scripts of this test, which
# note how they are called, and /etc/os-release is a file of this test.
#   bootstrap_test.sh <repository>
set -euo pipefail
folder=$(mktemp -d "${TMPDIR:-/tmp}/orbs bootstrap-XXXXXX")
trap 'rm -rf "$folder"' EXIT
umask 077
mkdir -p "$folder/check out/cmake" "$folder/bin" "$folder/plain"
cp "$1/bootstrap" "$folder/check out/"
cp "$1"/cmake/*.sh "$folder/check out/cmake/"
export ORBS_OS_RELEASE=$folder/os-release FAKE=$folder

fail() { echo "bootstrap_test: $*; it said:" >&2; cat "$folder/said" "$folder/calls" >&2; exit 1; }
says() { grep -qF -- "$1" "$folder/said" || fail "this was not said: $1"; }
says_not() { ! grep -qF -- "$1" "$folder/said" || fail "this was said: $1"; }
calls() { grep -qE -- "$1" "$folder/calls" || fail "this was not called: $1"; }
calls_not() { ! grep -qE -- "$1" "$folder/calls" || fail "this was called: $1"; }

system() {  # <ID> <VERSION_ID> <PRETTY_NAME> [ID_LIKE]
  printf 'PRETTY_NAME="%s"\nID=%s\nVERSION_ID="%s"\nID_LIKE="%s"\n' "$3" "$1" "$2" "${4-}" >"$folder/os-release"
}

# Programs of a machine on which nothing is installed: the plain ones of this machine, and ours. `apt-get update` and
# `apt-get install` first answer with the files that a test has put there, one each time.
program() { cat >"$folder/bin/$1"; chmod +x "$folder/bin/$1"; }
for name in mktemp cut bash cat env grep sed awk sort head tail tee mkdir dirname tr uname rm printf mv; do
  ln -s "$(command -v "$name")" "$folder/plain/$name"
done
program sudo <<'TEXT'
#!/bin/bash
exec "$@"
TEXT
program sleep <<'TEXT'
#!/bin/bash
echo "sleep $*" >>"$FAKE/calls"
TEXT
program dpkg-query <<'TEXT'
#!/bin/bash
exit 1
TEXT
program apt-get <<'TEXT'
#!/bin/bash
echo "apt-get $*" >>"$FAKE/calls"
for answer in "$FAKE/answers/${2-}"*; do
  [[ -e $answer ]] || exit 0
  cat "$answer" >&2
  mv "$answer" "$FAKE/answered"
  [[ $answer == *.warn ]] && exit 0
  exit 100
done
TEXT
program apt-cache <<'TEXT'
#!/bin/bash
if (($# == 1)); then cat "$FAKE/lists"; fi
for name; do
  case " policy -- $(cat "$FAKE/unknown") " in *" $name "*) continue ;; esac
  printf '%s:\n  Installed: (none)\n  Candidate: %s\n' "$name" "$(if [[ $name == cmake ]]; then cat "$FAKE/cmake"; else echo 1:14.0-3; fi)"
done
TEXT

# fresh: no program has been called, apt-get knows each package and does what it is told.
fresh() {
  rm -rf "$folder/answers" "$folder/check out/build"
  mkdir "$folder/answers"
  : >"$folder/calls"
  : >"$folder/unknown"
  echo " 100 /var/lib/dpkg/status" >"$folder/lists"
  echo 3.25.1-1 >"$folder/cmake"
}

# bootstrap <status> <arguments...>
bootstrap() {
  local expected=$1 status=0
  PATH=$folder/bin:$folder/plain "$folder/check out/bootstrap" "${@:2}" >"$folder/said" 2>&1 || status=$?
  [[ $status == "$expected" ]] || fail "bootstrap ${*:2} ended with $status, not with $expected"
}

echo "1. it names what there is, and changes nothing"
fresh
system debian 12 "Debian GNU/Linux 12 (bookworm)"
bootstrap 0 system
says "Debian GNU/Linux 12 (bookworm)"
says "apt-get install --no-install-recommends g++ cmake"
calls_not .
bootstrap 0 packages
says libopenexr-dev
says_not blender
bootstrap 0 packages test
says python3-numpy
bootstrap 2 packages nothing
bootstrap 0 install fuzz
[[ ! -e "$folder/check out/build" ]] || fail "root has made a folder in which others cannot write"
calls "apt-get .*install .* libclang-rt-dev"
calls_not "install .*blender"

echo "2. Fedora and Arch: the names of their packages"
fresh
system fedora 43 "Fedora Linux 43"
bootstrap 2 run
says "Fedora Linux 43: install as root:  dnf install gcc-c++ cmake ninja-build fmt-devel"
calls_not .
system arch "" "Arch Linux"
bootstrap 2 run --with-peers
says "pacman -S --needed gcc cmake ninja fmt"
says python-numpy
system cachyos "" "CachyOS" "arch"
bootstrap 2 build
says "CachyOS: install as root:  pacman -S"

echo "3. other systems: what is needed"
system void "" "Void Linux"
bootstrap 2 run
says "OpenImageIO 2"
calls_not .

echo "4. Ubuntu has no package of Chromium: all others are installed"
fresh
echo "chromium clang-format-14" >"$folder/unknown"
system ubuntu 24.04 "Ubuntu 24.04.1 LTS" debian
bootstrap 2 test   # there is no CMake on this machine
says "has no package chromium: what needs it is left out"
says "has no package clang-format-14: what needs it is left out"
calls "apt-get .*install .* clang-tidy-14"
calls_not "install .*chromium"

echo "5. a needed package that there is not: nothing is installed"
fresh
echo libtinygltf-dev >"$folder/unknown"
bootstrap 2 build
says "Ubuntu 24.04.1 LTS has no package libtinygltf-dev; nothing was installed."
calls_not "apt-get .*install"

echo "6. a CMake that is too old: nothing is installed"
fresh
echo 3.22.1-1ubuntu1 >"$folder/cmake"
system ubuntu 22.04 "Ubuntu 22.04 LTS" debian
bootstrap 2 build
says "CMake 3.25 or newer is needed, and that of Ubuntu 22.04 LTS is 3.22.1"
calls_not "apt-get .*install"

echo "7. the lock of apt-get is waited for"
fresh
system debian 12 "Debian GNU/Linux 12 (bookworm)"
cat >"$folder/answers/update1" <<'TEXT'
E: Could not get lock /var/lib/apt/lists/lock. It is held by process 4711 (unattended-upgr)
E: Unable to lock directory /var/lib/apt/lists/
TEXT
cat >"$folder/answers/install1" <<'TEXT'
E: Could not get lock /var/lib/dpkg/lock-frontend. It is held by process 4712 (dpkg)
E: Unable to acquire the dpkg frontend lock (/var/lib/dpkg/lock-frontend), is another process using it?
TEXT
cp "$folder/answers/install1" "$folder/answers/install2"
bootstrap 2 build
says "waiting for unattended-upgr (process 4711), which holds apt-get's lock"
says "waiting for dpkg (process 4712), which holds apt-get's lock"
[[ $(grep -c ' update' "$folder/calls") == 2 && $(grep -c ' install ' "$folder/calls") == 3 ]] || fail "it was not tried again"
[[ $(grep -c "waiting for dpkg" "$folder/said") == 1 ]] || fail "it said twice whom it waits for"

echo "8. a lock that is never given back"
fresh
for number in $(seq 100 199); do printf 'E: Could not get lock /a. It is held by process 1 (init)\n' >"$folder/answers/install$number"; done
bootstrap 2 build
says "apt-get's lock is held by init (process 1), for 10 minutes now"

echo "9. the reason is the true one"
reason() {  # <answer of apt-get install> <what bootstrap says of it>
  fresh
  echo "$1" >"$folder/answers/install"
  bootstrap 2 build
  says "$2"
}
reason "E: Failed to fetch http://deb.debian.org/x  Temporary failure resolving 'deb.debian.org'" "is there a network"
reason "E: You don't have enough free space in /var/cache/apt/archives/." "the disk is full"
reason "E: Unable to correct problems, you have held broken packages." "what is installed contradicts"
reason "E: Could not open lock file /var/lib/dpkg/lock-frontend - open (13: Permission denied)
E: Unable to acquire the dpkg frontend lock (/var/lib/dpkg/lock-frontend), are you root?" "it was not allowed to"
reason "E: Something new" "its own words stand above"
says_not "Debian 12)"
fresh
echo g++ >"$folder/unknown"
echo "W: Failed to fetch http://deb.debian.org/x  Temporary failure resolving 'deb.debian.org'" >"$folder/answers/update.warn"
bootstrap 2 build
says "for its update failed: is there a network"

echo "10. what this system does not have is not asked for each time"
fresh
echo " 500 http://deb.debian.org/debian trixie/main amd64 Packages" >"$folder/lists"
tr '\n' ' ' <<<"$(PATH=$folder/bin:$folder/plain "$folder/check out/bootstrap" packages test)" >"$folder/unknown"
sed -i 's/ libpng-dev / /' "$folder/unknown"
bootstrap 2 test
says "has no package clang-format-14: what needs it is left out"
calls "update"   # g++ may be in a newer list
fresh
echo " 500 http://deb.debian.org/debian trixie/main amd64 Packages" >"$folder/lists"
echo "clang-format-14 clang-tidy-14" >"$folder/unknown"
printf '#!/bin/bash\nfor name in "${@:5}"; do [[ $name == clang-* ]] || echo "$name installed"; done\n' >"$folder/bin/dpkg-query"
bootstrap 2 test
says "has no package clang-tidy-14: what needs it is left out"
says "configuring"
calls_not .
printf '#!/bin/bash\nexit 1\n' >"$folder/bin/dpkg-query"

echo "11. neither root nor sudo"
if ((EUID != 0)); then
  fresh
  rm "$folder/bin/sudo"
  bootstrap 2 build
  says "to install what is missing, run as root:  apt-get update && apt-get install --no-install-recommends g++"
  calls_not .
fi
