# shellcheck shell=bash
# Functions shared by tools/run, tools/check, tools/test, tools/package, tools/windows and .ci/run: packages, configuring, building. Sourced, not run.
# All messages go to stderr, so that stdout contains only the results of the program.

packages_to_build=(g++ cmake ninja-build pkg-config libhdf5-dev libaec-dev zlib1g-dev libgsl-dev
  libfmt-dev libxxhash-dev libhwy-dev nlohmann-json3-dev)
packages_to_test=(libgtest-dev libgmock-dev libmpfr-dev git groff-base python3 python3-h5py python3-xarray python3-h5netcdf
  python3-jsonschema python3-xxhash locales)
packages_for_all=(clang lld libclang-rt-dev libbenchmark-dev)
# For the report page: its core is WebAssembly, its scripts are bundled with npm packages.
packages_for_page=(nodejs clang-19 lld-19 wasi-libc libc++-19-dev-wasm32 libc++abi-19-dev-wasm32
  libclang-rt-19-dev-wasm32)
# Compilers and emulators of tests/platforms, WebAssembly's too. Not g++-multilib: it conflicts with all cross compilers.
packages_for_platforms=(clang-22 g++-12-multilib qemu-user g++-aarch64-linux-gnu g++-arm-linux-gnueabihf
  g++-powerpc64le-linux-gnu g++-riscv64-linux-gnu g++-s390x-linux-gnu g++-mingw-w64-x86-64-posix wine wine64
  "${packages_for_page[@]}")
command -v npm > /dev/null || packages_for_page+=(npm) # A nodejs from elsewhere than Debian brings its own.
packages_to_browse=(chromium)
# For tests/cli/hyrax, which run hyrax.exe under Wine and compare screenshots.
packages_for_wine=(g++-mingw-w64-x86-64-posix wine wine64 xvfb picom hsetroot imagemagick xdotool librsvg2-bin)
# For tools/windows: the compiler, what builds GSL and HDF5 for it, and what runs their programs.
packages_for_windows=(g++-mingw-w64-x86-64-posix libz-mingw-w64-dev dpkg-dev make wine wine64)
# For tools/package: dependencies and file types for the Debian package, and the man page.
packages_to_package=(dpkg-dev file python3)
# For tests/package, which install the Debian package in a bare system.
packages_to_install=(debootstrap)
# For the tests of sweeps on clusters: a Slurm cluster of one node, and Open MPI's launcher.
packages_for_clusters=(slurmctld slurmd slurm-client munge openmpi-bin)
packages_for_ci=(clang-format clang-tidy shellcheck git)

readonly exit_cannot_access=3

say() { printf '%s\n' "$*" >&2; }

stop() {
  say "$*"
  exit "$exit_cannot_access"
}

# The folder of the project, whatever the current folder is and however the script was called.
project_folder() {
  local script
  script=$(readlink -f -- "${BASH_SOURCE[0]}")
  dirname -- "$(dirname -- "$script")"
}

# ensure_packages PACKAGE...: installs those that are missing. If none is missing, apt is not called
# and no network is needed. Asks on a terminal, unless `assume_yes` is set to yes.
ensure_packages() {
  has_apt || stop_with_list "$@"
  local missing
  read -r -a missing <<< "$(missing_packages "$@")"
  [[ ${#missing[@]} -gt 0 ]] || return 0
  [[ $EUID -eq 0 ]] || command -v sudo > /dev/null || stop "Missing packages; install them as root:
  apt-get install --no-install-recommends ${missing[*]}"
  apt_knows "${missing[@]}" || update_lists
  apt_knows "${missing[@]}" || stop "apt cannot install the missing packages; is the network available?
$(plan_of "${missing[@]}" 2>&1 | grep '^E:')"
  agree_to "${missing[@]}"
  install_packages "${missing[@]}"
}

# The package names are those of Debian and Ubuntu; distributions derived from them are tried as well.
has_apt() {
  command -v apt-get > /dev/null && command -v dpkg-query > /dev/null && [[ -r /etc/os-release ]] &&
    grep -qE '^ID(_LIKE)?=.*(debian|ubuntu)' /etc/os-release
}

stop_with_list() {
  stop "This system is neither Debian nor Ubuntu; nothing was installed. Install the equivalents of these packages:
  $*
then build with CMake: cmake -S . -B build -G Ninja && cmake --build build
This builds build/bin/hyrax-sim; ctest --test-dir build runs the tests."
}

missing_packages() {
  local package states
  # dpkg-query fails if a package is unknown, but still prints the others.
  states=$(dpkg-query -W -f '${Package}=${db:Status-Status}\n' "$@" 2> /dev/null) || true
  for package in "$@"; do
    [[ $'\n'$states$'\n' == *$'\n'"$package=installed"$'\n'* ]] || printf '%s ' "$package"
  done
}

as_root() {
  if [[ $EUID -eq 0 ]]; then "$@"; else sudo "$@"; fi
}

# Works without root; prints the sizes that agree_to shows.
plan_of() { LC_ALL=C apt-get install --print-uris --yes --no-install-recommends "$@"; }

apt_knows() { plan_of "$@" > /dev/null 2>&1; }

update_lists() {
  timed "package lists" logged as_root apt-get -qq update ||
    stop "apt could not fetch the package lists; see the output above."
}

agree_to() {
  local sizes answer
  sizes=$(plan_of "$@" 2> /dev/null |
    sed -nE 's/^Need to get ([^\/]*\/)?(.*) of archives\.$/\2 to download/p
             s/^After this operation, (.*) of additional disk space will be used\.$/\1 on disk/p')
  say "Missing packages (with what they need: ${sizes//$'\n'/, }):" "$@"
  # Without a terminal, as in a container or a CI job, nobody can answer.
  [[ ${assume_yes:-no} == no && -t 0 && -t 2 ]] || return 0
  read -r -p "Install them? [Y/n] " answer || answer=n
  [[ ${answer:-y} == [yY]* ]] || stop "Nothing was installed."
}

install_packages() {
  local log_lines=6
  timed "packages" logged apt_install "$@" && return
  # Outdated lists name files that the servers no longer have.
  update_lists
  timed "packages" logged apt_install "$@" || stop "The packages could not be installed; see the output above. Is the network available?"
}

apt_install() {
  as_root env DEBIAN_FRONTEND=noninteractive apt-get -qq install --yes --no-install-recommends \
    -o DPkg::Lock::Timeout=300 "$@"
}

# logged COMMAND...: runs it silently; if it fails, prints the last `log_lines` lines of its output.
logged() {
  local log code=0
  log=$(mktemp)
  "$@" > "$log" 2>&1 < /dev/null || code=$?
  [[ $code -eq 0 ]] || tail -n "${log_lines:-200}" -- "$log" >&2
  rm -f -- "$log"
  return "$code"
}

# timed NAME COMMAND...: runs it, then prints how long it took and whether it failed.
timed() {
  local name=$1 begin=${EPOCHREALTIME/[.,]/} code=0
  shift
  "$@" || code=$?
  say_time "$name" "$begin" "$code"
  return "$code"
}

# say_time NAME BEGIN CODE: the time since BEGIN, in microseconds.
say_time() {
  local tenths=$(((${EPOCHREALTIME/[.,]/} - $2 + 50000) / 100000))
  say "$(printf '%-34s %4d.%d s%s' "$1" $((tenths / 10)) $((tenths % 10)) "$(failed_mark "$3")")"
}

failed_mark() { [[ $1 -eq 0 ]] || printf '   FAILED (exit %d)' "$1"; }

# configure FOLDER NAME=VALUE...: runs CMake unless the folder is already configured with these values.
# If a CMakeLists.txt changes later, ninja runs CMake itself.
configure() {
  local folder=$1
  shift
  is_configured "$folder" "$@" && return
  forget_other_source "$folder"
  timed "configure ${folder#"$project/"}" logged \
    cmake --log-level=WARNING -S "$project" -B "$folder" -G Ninja "${@/#/-D}"
}

is_configured() {
  local folder=$1 setting cache
  shift
  [[ -f $folder/build.ninja && -f $folder/CMakeCache.txt ]] || return 1
  cache=$'\n'$(< "$folder/CMakeCache.txt")$'\n'
  [[ $cache == *$'\n'"CMAKE_HOME_DIRECTORY:INTERNAL=$project"$'\n'* ]] || return 1
  for setting in "$@"; do
    [[ $cache =~ $'\n'"${setting%%=*}:"[A-Z]+"=${setting#*=}"$'\n' ]] || return 1
  done
}

# CMake refuses a build folder that was copied or moved together with the source.
forget_other_source() {
  local folder=$1
  [[ -f $folder/CMakeCache.txt ]] || return 0
  grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$project" "$folder/CMakeCache.txt" || rm -rf -- "$folder"
}

# What an object takes of one processor, in ms: the mean of a clean build. Machines differ by a factor of three, so what the
# folder's own objects took is better.
readonly object_ms=3000

# announce FOLDER NAME TARGET: how many objects of the target are to be compiled for the first time, and about how long it takes;
# prints nothing if all are there.
announce() {
  local object objects=0 about_s mean_ms
  while read -r object; do
    [[ -e $1/$object ]] || objects=$((objects + 1))
  done < <(ninja -C "$1" -t inputs "$3" | grep '\.o$')
  [[ $objects -gt 0 ]] || return 0
  mean_ms=$(awk -v n=0 -v ms=0 '$4 ~ /\.o$/ { ms += $2 - $1; n++ } END { if (n >= 20) printf "%d", ms / n }' "$1/.ninja_log" 2> /dev/null || true)
  about_s=$((objects * ${mean_ms:-$object_ms} / $(nproc) / 1000 + 1))
  say "$2: $objects objects to compile, about $((about_s / 60)) min $((about_s % 60)) s on $(nproc) processors"
}

# build FOLDER [TARGET]...: shows ninja's progress on a terminal; elsewhere silent unless it fails.
build() {
  local folder=$1
  shift
  if [[ -t 2 ]]; then
    ninja -C "$folder" "$@" >&2
  else
    ninja --quiet -C "$folder" "$@" | { grep -v '^ninja: no work to do' || true; } >&2
  fi
}

# build_page FOLDER: builds the report page with the core as it is now, from npm packages, which are fetched once. On
# failure hyrax-sim is built without it, as before.
build_page() { timed "build report page" logged build "$1" page; }

# build_program FOLDER [page]: builds hyrax-sim if a source file changed, and prints nothing if none did (with `announces` set
# to yes, that it is up to date); with `page`, the report page is built into it. The folder may be that of tools/test:
# whatever it was configured for, it can build both.
build_program() {
  local begin=${EPOCHREALTIME/[.,]/} before program=$1/bin/hyrax-sim
  hold "$1"
  is_configured "$1" || configure "$1" CMAKE_BUILD_TYPE=Release HYRAX_TESTS=OFF ||
    stop "CMake could not configure hyrax-sim; see the output above."
  if [[ ${2:-} == page ]]; then
    build_page "$1" || stop "The report page could not be built; see the output above. Is the network available?"
    configure "$1" HYRAX_PAGE=ON || stop "CMake could not configure hyrax-sim; see the output above."
  fi
  before=$(time_of_change "$program")
  [[ ${announces:-no} == no ]] || announce "$1" hyrax-sim hyrax-sim
  build "$1" hyrax-sim || stop "hyrax-sim could not be built; see the output above."
  if [[ $(time_of_change "$program") != "$before" ]]; then
    say_time "build hyrax-sim" "$begin" 0
  elif [[ ${announces:-no} == yes ]]; then
    say "hyrax-sim: up to date"
  fi
  release
}

time_of_change() { stat --format %y -- "$1" 2> /dev/null || true; }

can_write() { mkdir -p -- "$1" 2> /dev/null && [[ -w $1 ]]; }

# Between hold and release, other builds in the folder wait.
hold() {
  exec {held}< "$1"
  flock "$held"
}

release() { exec {held}<&-; }
