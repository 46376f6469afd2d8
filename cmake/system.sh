# Read by ./bootstrap: which system this is, and what the things that orbs needs are called there.

# The tests name a file of their own, to see another system.
os_release=${ORBS_OS_RELEASE:-/etc/os-release}

# A value of that file, whose form os-release(5) gives; "" if it has none.
os_value() { sed -n "s/^$1=//p" "$os_release" 2>/dev/null | head -n 1 | tr -d "\"'" || true; }

system_name=$(os_value PRETTY_NAME)
system_name=${system_name:-this system}

# Prints apt, dnf, pacman or none.
find_manager() {
  case " $(os_value ID) $(os_value ID_LIKE) " in
    *" debian "* | *" ubuntu "*) if command -v apt-get >/dev/null && command -v dpkg-query >/dev/null; then echo apt; else echo none; fi ;;
    *" fedora "* | *" rhel "*) echo dnf ;;
    *" arch "*) echo pacman ;;
    *) echo none ;;
  esac
}
manager=$(find_manager)

# What is known of orbs on this system; docs/use/systems.md has the whole table.
experience() {
  case "$(os_value ID) $(os_value VERSION_ID)" in
    "debian 12") echo "each change is built and tested here" ;;
    "debian 13") echo "the suite is right and the tests pass here" ;;
    "ubuntu 24.04" | "ubuntu 26.04") echo "orbs should build here, by the list of packages; it was not tried" ;;
    "fedora "* | "arch "*) echo "orbs should build here; bootstrap names the packages, by these systems' lists, and installs none" ;;
    *) echo "nobody has tried orbs here" ;;
  esac
}

# use | apt | dnf | pacman | what it is. Names of dnf and pacman are by the lists of Fedora and Arch.
all_packages='
build | g++                 | gcc-c++             | gcc           | g++ 12 or newer
build | cmake               | cmake               | cmake         | CMake 3.25 or newer
build | ninja-build         | ninja-build         | ninja         | Ninja
build | libfmt-dev          | fmt-devel           | fmt           | fmt
build | nlohmann-json3-dev  | json-devel          | nlohmann-json | nlohmann-json
build | libcli11-dev        | cli11-devel         | cli11         | CLI11
build | libopenexr-dev      | openexr-devel       | openexr       | OpenEXR 3
build | libpng-dev          | libpng-devel        | libpng        | libpng
build | libopenimageio-dev  | OpenImageIO-devel   | openimageio   | OpenImageIO 2 (all other image formats)
build | libembree-dev       | embree-devel        | embree        | Embree with TBB
build | zlib1g-dev          | zlib-devel          | zlib          | zlib
build | libtinygltf-dev     | tinygltf-devel      | tinygltf      | tinygltf
build | libgtest-dev        | gtest-devel         | gtest         | GoogleTest (the tests are part of every build)
page  | nodejs              | nodejs              | nodejs        | Node.js 18 or newer (the results page)
page  | npm                 | nodejs-npm          | npm           | npm (the results page)
peers | povray              | povray              | povray        | POV-Ray 3.7
peers | blender             | blender             | blender       | Blender
peers | python3-numpy       | python3-numpy       | python-numpy  | NumPy (the glTF importer of Blender needs it)
test  | clang-format-14     | -                   | -             | clang-format 14
test  | clang-tidy-14       | -                   | -             | clang-tidy 14
test  | python3             | python3             | python        | Python 3
test  | python3-jsonschema  | python3-jsonschema  | python-jsonschema | jsonschema of Python
test  | valgrind            | valgrind            | valgrind      | Valgrind
test  | chromium            | chromium            | chromium      | Chromium (tests of the results page)
test  | dpkg-dev            | -                   | -             | dpkg-dev (test of the Debian package)
test  | debootstrap         | debootstrap         | debootstrap   | debootstrap (tests/platforms)
test  | bubblewrap          | bubblewrap          | bubblewrap    | bubblewrap (orbs run --sandbox)
test  | file                | file                | file          | file (CPack, for the Debian package)
test  | munge               | munge               | munge         | munge (test of orbs submit)
test  | slurmctld           | slurm-slurmctld     | slurm-llnl    | Slurm (test of orbs submit)
test  | slurmd              | slurm-slurmd        | slurm-llnl    | Slurm (test of orbs submit)
test  | slurm-client        | slurm               | slurm-llnl    | Slurm (test of orbs submit)
fuzz  | clang               | clang               | clang         | clang
fuzz  | libclang-rt-dev     | compiler-rt         | compiler-rt   | the sanitizers of clang
'

# packages_for <use>...: the names of this system, one a line; where its manager is unknown, what the things are.
packages_for() {
  local column=5 uses=" $* " use apt dnf pacman what
  while IFS='|' read -r use apt dnf pacman what; do
    use=${use// /}
    if [[ -z $use || $uses != *" $use "* ]]; then continue; fi
    # Only where there is none: another Node than the system's would be in the way of its npm.
    if [[ $use == page ]] && command -v node >/dev/null && command -v npm >/dev/null; then continue; fi
    case $manager in
      apt) what=$apt ;;
      dnf) what=$dnf ;;
      pacman) what=$pacman ;;
    esac
    what=${what# }
    what=${what%"${what##*[! ]}"}
    if [[ $what != - ]]; then printf '%s\n' "$what"; fi
  done <<<"$all_packages" | awk '!seen[$0]++'
}

# Prints those of the packages among the arguments that are not installed; all of them where that cannot be asked.
missing_packages() {
  local installed package
  case $manager in
    apt) installed=$(dpkg-query --show --showformat '${binary:Package} ${db:Status-Status}\n' -- "$@" 2>/dev/null || true) ;;
    dnf) installed=$(rpm --query --queryformat '%{NAME} installed\n' -- "$@" 2>/dev/null || true) ;;
    pacman) installed=$(pacman --query --quiet -- "$@" 2>/dev/null | sed 's/$/ installed/' || true) ;;
    none) installed= ;;
  esac
  for package; do
    grep -qE "^${package//+/\\+}(:[a-z0-9]+)? installed$" <<<"$installed" || printf '%s\n' "$package"
  done
}

# The oldest CMake whose presets are ours.
least_cmake=3.25

# is_older <version> <version>: is the first one older?
is_older() { [[ $1 != "$2" && $(printf '%s\n' "$1" "$2" | sort -V | head -n 1) == "$1" ]]; }

# check_cmake [<version that would be installed>]: ends where neither that nor the one on PATH will do.
check_cmake() {
  local version=${1-}
  if command -v cmake >/dev/null; then version=$(cmake --version | sed -n 's/^cmake version //p'); fi
  if [[ -z $version ]] || ! is_older "${version%%-*}" "$least_cmake"; then return; fi
  fail "CMake $least_cmake or newer is needed, and that of $system_name is $version: put a newer one on PATH," \
    "or take the Containerfile, which needs Podman or Docker alone"
}

can_compile() { command -v g++ >/dev/null && command -v cmake >/dev/null && command -v ninja >/dev/null; }
