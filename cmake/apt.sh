# Read by ./bootstrap: installs packages with apt-get, waits for its lock, and says the true reason when it fails.

# A fresh cloud machine updates itself for minutes. apt-get has a lock of its own on each of its three folders, and can
# wait for one of them alone (DPkg::Lock::Timeout), so the waiting is ours: so many times so many seconds.
apt_lock_tries=60
apt_lock_pause=10

# Runs a command as root: directly, or through sudo with the caller's proxy settings, which sudo would drop. In English,
# for its reasons are read.
as_root() {
  local settings=(DEBIAN_FRONTEND=noninteractive LC_ALL=C) name
  if ((EUID == 0)); then
    env "${settings[@]}" "$@"
    return
  fi
  for name in http_proxy https_proxy ftp_proxy no_proxy HTTP_PROXY HTTPS_PROXY NO_PROXY; do
    if [[ -v $name ]]; then settings+=("$name=${!name}"); fi
  done
  sudo env "${settings[@]}" "$@"
}

log_says() { grep -qiE "$1" "$apt_log"; }

no_network='temporary failure resolving|could not resolve|failed to fetch|unable to fetch|unable to connect|could not connect|connection (timed out|refused)'
lock_is_held='could not get lock|unable to (acquire|lock)'

# Who holds the lock, by what apt-get has said: "unattended-upgr (process 1234)".
lock_holder() {
  local found
  found=$(sed -nE 's/.*held by process ([0-9]+) \(([^)]*)\).*/\2 (process \1)/p' "$apt_log" | head -n 1)
  printf '%s\n' "${found:-another program}"
}

# Runs apt-get with these arguments; its words go to the log, too. While another program holds its lock it is tried again.
apt_get() {
  local try holder told=
  for ((try = 1; ; ++try)); do
    if as_root apt-get --quiet "$@" 2>&1 | tee "$apt_log" >&2; then return 0; fi
    if ! log_says "$lock_is_held" || log_says "permission denied"; then return 1; fi
    holder=$(lock_holder)
    if ((try == apt_lock_tries)); then
      fail "apt-get's lock is held by $holder, for $((apt_lock_tries * apt_lock_pause / 60)) minutes now: let it end, or end it, then try again"
    fi
    if [[ $holder != "$told" ]]; then say "waiting for $holder, which holds apt-get's lock"; fi
    told=$holder
    sleep "$apt_lock_pause"
  done
}

# Why the last apt-get failed, by its own words.
apt_reason() {
  if log_says "permission denied|are you root"; then
    echo "it was not allowed to: run this as root"
  elif log_says "no space left|enough free space"; then
    echo "the disk is full"
  elif log_says "$no_network"; then
    echo "it could not fetch all files: is there a network, and are the package sources right?"
  elif log_says "unable to locate package|no installation candidate"; then
    echo "$system_name lacks a package of these"
  elif log_says "unmet dependencies|held broken packages"; then
    echo "what is installed contradicts what they need"
  else
    echo "its own words stand above"
  fi
}

# Prints "<package> <version>" for those of the packages that apt-get could install.
candidates() {
  LC_ALL=C apt-cache policy -- "$@" 2>/dev/null | awk '
    /^[^ ].*:$/ { name = substr($0, 1, length($0) - 1); sub(/:[a-z0-9]+$/, "", name) }
    /^  Candidate: / && $2 != "(none)" { sub(/^[0-9]+:/, "", $2); print name, $2 }'
}

has_lists() { LC_ALL=C apt-cache policy 2>/dev/null | grep -qE '^ *-?[0-9]+ [a-z+]+:'; }

# Sorts the packages into `found`, which apt-get could install, and `unknown`, without which orbs cannot be built. Any
# other is left out.
sort_packages() {
  local known package required
  known=$(candidates "$@")
  required=" $(packages_for build fuzz | tr '\n' ' ') "
  found=() unknown=()
  for package; do
    if grep -qE "^${package//+/\\+} " <<<"$known"; then
      found+=("$package")
    elif [[ $required == *" $package "* ]]; then
      unknown+=("$package")
    else
      say "$system_name has no package $package: what needs it is left out"
    fi
  done
}

# Before anything is installed: with what apt-get has, can orbs be built?
check_packages() {  # <packages that are needed and that it does not know>
  if (($# > 0)) && [[ $update_failed == yes ]]; then
    fail "apt-get has no list with $*, for its update failed: is there a network, and are the package sources right?"
  elif (($# > 0)); then
    fail "$system_name has no package $*; nothing was installed." \
      "The Containerfile builds orbs on any system that has Podman or Docker"
  fi
  check_cmake "$(candidates cmake | cut -d ' ' -f 2)"
}

# apt_install <missing package>...
apt_install() {
  local found=("$@") unknown=() update_failed=no
  # What this system does not have at all would be missing each time.
  if has_lists; then
    sort_packages "$@"
    found+=("${unknown[@]}")
  fi
  if ((${#found[@]} == 0)); then return; fi
  if ((EUID != 0)) && ! command -v sudo >/dev/null; then
    fail "to install what is missing, run as root:  apt-get update && apt-get install --no-install-recommends ${found[*]}"
  fi
  # Not in the build folder, which a user without root must be able to write to afterwards.
  apt_log=$(mktemp "${TMPDIR:-/tmp}/orbs-apt-XXXXXX")
  trap 'rm -f "$apt_log"' EXIT
  say "installing them with apt-get"
  # With an old list, or for a source of the user's own that does not answer, it may still do.
  apt_get update || { update_failed=yes; say "apt-get update failed: $(apt_reason)"; }
  if log_says "$no_network"; then update_failed=yes; fi
  sort_packages "${found[@]}"
  check_packages "${unknown[@]}"
  if ((${#found[@]} > 0)); then
    apt_get install --yes --no-install-recommends "${found[@]}" || fail "apt-get could not install ${found[*]}: $(apt_reason)"
  fi
  rm -f "$apt_log"
}
