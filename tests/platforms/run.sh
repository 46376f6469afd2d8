#!/bin/bash
# Builds and tests the commit that is checked out on other systems, each in a chroot that debootstrap makes of its
# minimal packages: a plain user clones it into a path with a space, with the umask 077.
#
#   tests/platforms/run.sh [--whole] [--folder <folder>] [--limit <seconds>] [<suite of Debian or Ubuntu>...]
#
# Without a suite: bookworm and trixie. Quick, the usual: `./bootstrap run --size 1/8`, then `./bootstrap test -L quick`.
# Whole: both commands as they are, and then the suite at 1/8 by root in a clone of root's. Root installs the packages.
# A chroot stays in the folder (default: /var/tmp/orbs-platforms) and is used again, clones are made anew; logs lie in
# <folder>/<suite>.log. It needs root, debootstrap, and a network.
# Ends with 0 if all went well; 1 if a build or a test has failed; 77 if a chroot could not be made or the limit was
# reached, which says nothing of orbs.
set -uo pipefail
here=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.." && pwd -P)
debian=${ORBS_MIRROR:-http://deb.debian.org/debian}
ubuntu=${ORBS_UBUNTU_MIRROR:-http://archive.ubuntu.com/ubuntu}
folder=/var/tmp/orbs-platforms whole=no limit=86400 suites=()
while (($# > 0)); do
  case $1 in
    --whole) whole=yes ;;
    --folder) folder=$2; shift ;;
    --limit) limit=$2; shift ;;
    -*) sed -n '2,/^set/{/^set/d;s/^# \{0,1\}//;p}' "$0"; exit 2 ;;
    *) suites+=("$1") ;;
  esac
  shift
done
if ((${#suites[@]} == 0)); then suites=(bookworm trixie); fi
end=$((SECONDS + limit))

say() { printf 'platforms: %s\n' "$*"; }
cannot() { say "$*"; return 77; }

# within <command...>: 124 when the time of all is up. Only this command and what it has started is ended.
within() {
  local left=$((end - SECONDS))
  ((left > 0)) || return 124
  timeout --kill-after=10 "$left" "$@"
}

make_chroot() {  # <suite> <root>
  if [[ -e $2/made ]]; then return 0; fi
  rm -rf --one-file-system -- "$2"
  mkdir -p -- "$2"
  local from=("$1" "$2" "$debian")
  case $1 in
    noble | resolute)
      # The debootstrap of Debian 12 knows no Ubuntu of this age and has none of its keys. Its script of gutsy is that of
      # all later ones, and what is not checked stays in this chroot.
      from=(--components=main,universe --no-check-gpg "$1" "$2" "$ubuntu" gutsy) ;;
  esac
  within debootstrap --variant=minbase "${from[@]}" >>"$log" 2>&1 || return 1
  # What lets this machine reach the network: its name server, its certificates and its proxy, if it has one.
  cp /etc/resolv.conf /etc/hosts "$2/etc/" 2>/dev/null
  cp -r /etc/apt/apt.conf.d/*proxy* "$2/etc/apt/apt.conf.d/" 2>/dev/null
  cp /etc/ssl/certs/ca-certificates.crt "$2/etc/certificates-of-host.crt" 2>/dev/null
  touch "$2/made"
}

# in_chroot <root> <user> <command line for bash>
in_chroot() {
  local names=() name
  for name in http_proxy https_proxy no_proxy HTTP_PROXY HTTPS_PROXY NO_PROXY; do
    if [[ -v $name ]]; then names+=("$name=${!name}"); fi
  done
  if [[ -e $1/etc/certificates-of-host.crt ]]; then names+=(npm_config_cafile=/etc/certificates-of-host.crt); fi
  within unshare --mount --pid --fork --kill-child bash -c '
    set -e
    root=$1 user=$2 line=$3
    shift 3
    mount --make-rprivate /
    mount -t proc proc "$root/proc"
    mount --rbind /dev "$root/dev"
    mount --rbind /sys "$root/sys"
    mount -t tmpfs tmpfs "$root/tmp"
    exec chroot --userspec="$user" "$root" env -i HOME="/users/$user" USER="$user" PATH=/usr/sbin:/usr/bin:/sbin:/bin LANG=C.UTF-8 "$@" \
      bash -c "umask 077; $line"' platforms "$1" "$2" "$3" "${names[@]}"
}

# step <what> <user> <command line>: logs how long it took; 1 if it failed, 77 if there was no more time.
step() {
  local began=$SECONDS status=0
  in_chroot "$root" "$2" "$3" >>"$log" 2>&1 || status=$?
  printf 'platforms: %-9s %-52s %6d s%s\n' "$suite" "$1" $((SECONDS - began)) "$( ((status == 0)) || echo "   status $status")"
  if ((status == 124 || status == 137 && SECONDS >= end)); then return 77; fi
  if ((status != 0)); then tail -n 40 "$log"; return 1; fi
}

clone() {  # <user>: into its home
  local home="$root/users/$1"
  rm -rf --one-file-system -- "${home:?}"
  mkdir -p "$home"
  git -c safe.directory='*' clone --quiet --no-hardlinks "$here" "$home/check out" >>"$log" 2>&1 || return 1
  chroot "$root" chown -R "$1:" "/users/$1"
}

# use_command <command with its options>: what it needs by root, then the command by a plain user.
use_command() {
  local home="$root/users/tester/check out"
  # No fault of ours if the mirror does not answer.
  step "by root: ./bootstrap install ${1%% *}" root "dpkg --configure -a && apt-get update && '/users/root/check out/bootstrap' install ${1%% *}" || return 77
  say "$suite: $(chroot "$root" dpkg-query --show | wc -l) packages, $(du -smx --exclude=users "$root/" | cut -f1) MB, $(du -smx "$root/var/cache/apt/archives" | cut -f1) MB of which were fetched"
  step "by a plain user: ./bootstrap $1" tester "cd \"\$HOME/check out\" && ./bootstrap $1" || return
  say "$suite: build folder $(du -smx "$home/build" | cut -f1) MB"
}

test_suite() {  # <suite>
  suite=$1 root=$folder/$1 log=$folder/$1.log
  mkdir -p "$folder"
  : >"$log"
  ((EUID == 0)) || { cannot "only root can make a chroot"; return; }
  command -v debootstrap >/dev/null || { cannot "debootstrap is not installed"; return; }
  make_chroot "$suite" "$root" || { cannot "$suite: the chroot could not be made: $log"; return; }
  in_chroot "$root" root true >>"$log" 2>&1 || { cannot "$suite: nothing can be run in the chroot: $log"; return; }
  chroot "$root" id tester >/dev/null 2>&1 || chroot "$root" useradd --home-dir /users/tester tester
  clone tester && clone root || { cannot "$suite: git could not clone: $log"; return; }
  say "$suite: $(sed -n 's/^PRETTY_NAME=//p' "$root/etc/os-release"), $(chroot "$root" dpkg-query --show | wc -l) packages, $(du -smx --exclude=users "$root/" | cut -f1) MB"
  local size=' --size 1/8' label=' -L quick'
  if [[ $whole == yes ]]; then size='' label=''; fi
  use_command "run$size" && use_command "test$label" || return
  if [[ $whole == no ]]; then return 0; fi
  step "by root, anew: ./bootstrap run --size 1/8" root 'cd "$HOME/check out" && ./bootstrap run --size 1/8'
}

worst=0
for suite in "${suites[@]}"; do
  status=0
  test_suite "$suite" || status=$?
  case $status in
    0) say "$suite: all right" ;;
    77) say "$suite: not tested to its end; that says nothing of orbs"; if ((worst == 0)); then worst=77; fi ;;
    *) say "$suite: failed; the log is $folder/$suite.log"; worst=1 ;;
  esac
done
exit "$worst"
