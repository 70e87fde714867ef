# SPDX-License-Identifier: GPL-3.0-or-later
# Shell functions that decks/run, tests/run and .ci/run share. Source it with `top` set to the
# folder of the whole project. All of them say nothing while there is nothing to do.

say() { printf '%s\n' "$*" >&2; }
die() {
  say "$*"
  exit 1
}

# installed PACKAGE: is it there, whole?
installed() {
  [ "$(dpkg-query -W -f='${db:Status-Status}' "$1" 2>/dev/null)" = installed ]
}

# available PACKAGE: does the package index know a version to install?
available() {
  [ -n "$(apt-cache madison "$1" 2>/dev/null)" ]
}

# as_root COMMAND..: as the user is, or through sudo.
as_root() {
  if [ "$(id -u)" -eq 0 ]; then
    "$@"
  elif command -v sudo >/dev/null; then
    sudo "$@"
  else
    die "needs root to run: $*"
  fi
}

# missing_of FILE..: the packages of these lists that are not installed.
missing_of() {
  local package
  for package in $(sed 's/#.*//' "$@"); do
    installed "$package" || printf '%s ' "$package"
  done
}

apt_log() { mktemp "${TMPDIR:-/tmp}/spricka-apt.XXXXXX"; }

# How long the scripts wait in all while another process holds a lock of apt or dpkg, and how often they
# try again, in seconds.
lock_patience=600
lock_pause=3
lock_deadline=

# is_locked OUTPUT: did apt-get end because another process holds a lock of apt or dpkg?
is_locked() {
  case $1 in
    *"Could not get lock"* | *"Unable to lock directory"* | *"Unable to acquire the dpkg"* | \
      *"frontend lock was locked"* | *"status database is locked"*) true ;;
    *) false ;;
  esac
}

# apt_get LOG ARGUMENT..: apt-get as root, without questions; the output of the last attempt goes to LOG.
# While another process holds a lock of apt or dpkg it waits, says so once, and tries again.
apt_get() {
  local log=$1 output result=0
  shift
  while true; do
    result=0
    output=$(as_root env DEBIAN_FRONTEND=noninteractive LC_ALL=C apt-get -q "$@" 2>&1) || result=$?
    if [ $result -eq 0 ] || ! is_locked "$output"; then
      break
    fi
    if [ -z "$lock_deadline" ]; then
      lock_deadline=$((SECONDS + lock_patience))
      say "waiting up to $lock_patience s: another process holds a lock of apt or dpkg"
      say "$(printf '%s\n' "$output" | grep -m 1 -i 'lock')"
    fi
    if [ $SECONDS -ge $lock_deadline ]; then
      say "the lock of apt or dpkg is still held: giving up"
      break
    fi
    sleep "$lock_pause"
  done
  printf '%s\n' "$output" >>"$log"
  return $result
}

# update_index LOG: fetch the package index; a failure shows later, by the package it lacks.
update_index() {
  say "updating the package index"
  apt_get "$1" update || true
}

# install_packages FILE..: installs what is missing of these lists, without what Debian only
# recommends. Ends the script, naming the package, when one cannot be had.
install_packages() {
  local missing package log
  missing=$(missing_of "$@")
  [ -n "$missing" ] || return 0
  command -v apt-get >/dev/null ||
    die "these Debian packages are missing, and apt-get with them: $missing"
  log=$(apt_log)
  for package in $missing; do
    if ! available "$package"; then
      update_index "$log"
      break
    fi
  done
  for package in $missing; do
    if ! available "$package"; then
      rm -f "$log"
      die "package $package is not to be had from the sources of apt"
    fi
  done
  say "installing: $missing"
  # An index that has grown old names files that are gone: fetch it and try once more.
  if ! apt_install "$log" $missing; then
    update_index "$log"
    apt_install "$log" $missing || true
  fi
  missing=$(missing_of "$@")
  if [ -n "$missing" ]; then
    tail -n 30 "$log" >&2
    die "could not install: $missing"
  fi
  rm -f "$log"
}

# apt_install LOG PACKAGE..
apt_install() {
  local log=$1
  shift
  apt_get "$log" install -y --no-install-recommends "$@"
}

# quietly LOG COMMAND..: shows what the command said only if it fails.
quietly() {
  local log=$1
  shift
  if ! "$@" >"$log" 2>&1; then
    cat "$log" >&2
    return 1
  fi
}

# timed WHAT COMMAND ..: runs a command and says how long it took.
timed() {
  local TIMEFORMAT="$1 took %0R s, and of all processors %0U s + %0S s for the system"
  shift
  time "$@"
}

# build PRESET TARGET [CMAKE OPTION..]: configures once, builds what is out of date. The options
# count at the first configuration only.
build() {
  local preset=$1 target=$2 folder=$top/build/$1
  shift 2
  mkdir -p "$folder"
  if [ ! -f "$folder/build.ninja" ]; then
    say "configuring ($preset)"
    (cd "$top" && quietly "$folder/configure.log" cmake --preset "$preset" "$@") ||
      die "configuring the $preset preset failed"
  fi
  if ! ninja -C "$folder" -n "$target" 2>/dev/null | grep -q 'no work to do'; then
    say "building ($preset)"
  fi
  quietly "$folder/build.log" ninja -C "$folder" "$target" || die "building ($preset) failed"
}
