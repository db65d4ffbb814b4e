# Shared by inputs/quickstart.sh, tests/run.sh and .ci/run; to be sourced, with `root` set to the repository.

# Open MPI refuses root and more ranks than cores unless told otherwise, and by default binds the ranks of every
# mpirun to the same first cores.
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
export OMPI_MCA_rmaps_base_oversubscribe=1 OMPI_MCA_hwloc_base_binding_policy=none   # Open MPI 4
export PRTE_MCA_rmaps_default_mapping_policy=:oversubscribe PRTE_MCA_hwloc_default_binding_policy=none # 5

# missing_packages WHAT OPTIONAL: those of debian-packages.txt for WHAT (build, test, bench) that are not installed.
missing_packages()
{
    local package use optional
    while read -r package use optional; do
        if [ "$use" = "$1" ] && [ "$optional" = "$2" ] &&
            [ "$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null)" != installed ]; then
            echo "$package"
        fi
    done < <(grep -v '^#' "$root/cmake/debian-packages.txt")
}

as_root()
{
    if [ "$(id -u)" -eq 0 ]; then "$@"; else sudo "$@"; fi
}

# install_packages WHAT...: does nothing, and needs no rights, when all packages are there.
install_packages()
{
    if ! command -v apt-get >/dev/null; then
        echo "No apt-get here: make sure that what cmake/debian-packages.txt lists is installed." >&2
        return
    fi
    local what missing=() package
    for what; do mapfile -t -O ${#missing[@]} missing < <(missing_packages "$what" ""); done
    if [ ${#missing[@]} -gt 0 ]; then
        if [ "$(id -u)" -ne 0 ] && ! command -v sudo >/dev/null; then
            echo "Packages are missing, and there is no sudo. Install as root: apt-get install ${missing[*]}" >&2
            return 1
        fi
        echo "Installing the packages that are missing: ${missing[*]}"
        as_root apt-get update -qq || echo "apt-get update failed; trying with the lists that are there" >&2
        as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends \
            "${missing[@]}" >/dev/null
    fi
    for what; do
        for package in $(missing_packages "$what" optional); do
            [ -n "$(apt-cache madison "$package" 2>/dev/null)" ] || continue
            echo "Installing an optional package: $package"
            as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends \
                "$package" >/dev/null || echo "$package could not be installed; going on without it" >&2
        done
    done
}

# Sources of a library are compiled up to forty at a time: what they all include is read once.
together=(-DCMAKE_UNITY_BUILD=ON -DCMAKE_UNITY_BUILD_BATCH_SIZE=40)

# build TARGET OPTION...: configures the release preset with CMake's OPTIONs and builds the target.
build()
{
    local target=$1
    shift
    command -v ccache >/dev/null && export CMAKE_CXX_COMPILER_LAUNCHER=${CMAKE_CXX_COMPILER_LAUNCHER-ccache}
    mkdir -p "$root/build"
    (cd "$root" && cmake --preset release "${together[@]}" "$@" >"$root/build/configure.log" 2>&1) || {
        cat "$root/build/configure.log" >&2
        return 1
    }
    cmake --build "$root/build/release" --target "$target"
}
