# shellcheck shell=bash
# Shared by the scripts beside it: finding out what this machine lacks, and installing just that.
# Source it after `set -euo pipefail`; it changes to the project's directory.

# shellcheck disable=SC2034 # for those who source this file
invoked_from="$PWD"
cd "$(dirname "${BASH_SOURCE[0]}")/.." || exit 1

# For who builds only to test: debug information costs time and room, and nobody debugs there. What a script
# has built with it another finds built; places of panics are told all the same.
build_for_tests() {
    export CARGO_PROFILE_DEV_DEBUG=0 CARGO_PROFILE_RELEASE_DEBUG=0
    export CARGO_INCREMENTAL=0 # one build of everything: incremental files would only cost time and room
}

say() { printf '== %s\n' "$*" >&2; }

die() {
    printf 'error: %s\n' "$*" >&2
    exit 1
}

# The package manager of this system, or nothing.
package_manager() {
    local manager
    for manager in apt-get dnf pacman zypper brew; do
        if command -v "$manager" >/dev/null; then
            echo "$manager"
            return
        fi
    done
}

# package_names MANAGER THING: what the packages of a thing are called there.
package_names() {
    case "$1:$2" in
        apt-get:compiler) echo g++ ;;
        apt-get:sdl2) echo libsdl2-dev ;;
        *:valgrind) echo valgrind ;;
        brew:python) echo python ;;
        pacman:python) echo python ;;
        *:python) echo python3 ;;
        apt-get:xvfb) echo xvfb ;;
        dnf:xvfb) echo xorg-x11-server-Xvfb ;;
        pacman:xvfb) echo xorg-server-xvfb ;;
        zypper:xvfb) echo xorg-x11-server-Xvfb ;;
        *:xdotool) echo xdotool ;;
        dnf:imagemagick | zypper:imagemagick) echo ImageMagick ;;
        *:imagemagick) echo imagemagick ;;
        apt-get:opengl) echo libegl1 libgl1-mesa-dri ;;
        apt-get:blender) echo libxi6 libxxf86vm1 libxfixes3 libxrender1 libgl1 libsm6 libxkbcommon0 ;;
        dnf:compiler) echo gcc-c++ ;;
        dnf:sdl2) echo SDL2-devel ;;
        dnf:blender) echo libXi libXxf86vm libXfixes libXrender libGL libSM libxkbcommon ;;
        pacman:blender) echo libxi libxxf86vm libxfixes libxrender libgl libsm libxkbcommon ;;
        zypper:blender) echo libXi6 libXxf86vm1 libXfixes3 libXrender1 libGL1 libSM6 libxkbcommon0 ;;
        dnf:opengl) echo mesa-libEGL mesa-libGL mesa-dri-drivers ;;
        pacman:compiler) echo gcc ;;
        pacman:sdl2) echo sdl2-compat ;;
        pacman:opengl) echo mesa ;;
        zypper:compiler) echo gcc-c++ ;;
        zypper:sdl2) echo SDL2-devel ;;
        zypper:opengl) echo Mesa-libEGL1 Mesa-libGL1 Mesa-dri ;;
        brew:sdl2) echo sdl2 ;;
        brew:compiler) die "no C++ compiler: run 'xcode-select --install', then this script again" ;;
    esac
}

# Whether a thing is there. Libraries are looked for as the linker will look for them.
have() {
    case "$1" in
        compiler) have_commands cc c++ ;;
        valgrind) have_commands valgrind ;;
        python) have_commands python3 ;;
        xvfb) have_commands Xvfb xvfb-run ;;
        xdotool) have_commands xdotool ;;
        imagemagick) have_commands import ;;
        sdl2) links_with -lSDL2 ;;
        # What Blender as a module links with, even without a window.
        blender) [[ "$(uname)" == Darwin ]] || { links_with -l:libXi.so.6 && links_with -l:libSM.so.6 && links_with -l:libxkbcommon.so.0; } ;;
        opengl) [[ "$(uname)" == Darwin ]] || { links_with -l:libEGL.so.1 && have_mesa_driver; } ;;
    esac
}

have_commands() {
    local name
    for name in "$@"; do
        command -v "$name" >/dev/null || return 1
    done
}

# links_with FLAG: whether a program can be linked with a library.
links_with() {
    local program verdict=0
    program="$(mktemp)"
    echo 'int main(void) { return 0; }' | cc -x c - "$1" -o "$program" 2>/dev/null || verdict=1
    rm -f "$program"
    return $verdict
}

# Mesa can draw without a graphics card: what the tests draw with where there is none.
have_mesa_driver() {
    local folder
    for folder in /usr/lib /usr/lib64 /usr/lib/*-linux-*; do
        ! compgen -G "$folder/dri/*_dri.so" >/dev/null || return 0
    done
    return 1
}

# As root: directly, or through sudo.
as_root() {
    if [[ "$(id -u)" == 0 ]]; then
        "$@"
    elif command -v sudo >/dev/null; then
        say "sudo is needed for: $*"
        sudo "$@"
    else
        die "this needs root, and there is no sudo; run as root: $*"
    fi
}

install_packages() {
    local manager="$1"
    shift
    say "installing with $manager: $*"
    case "$manager" in
        apt-get)
            as_root apt-get update
            as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends "$@"
            ;;
        dnf) as_root dnf install -y "$@" ;;
        pacman) as_root pacman -S --needed --noconfirm "$@" ;;
        zypper) as_root zypper --non-interactive install "$@" ;;
        brew) brew install "$@" ;;
    esac
}

# need THING...: installs what is missing of these things, and nothing if nothing is.
need() {
    local manager thing missing=() packages=()
    manager="$(package_manager)"
    if [[ "$manager" == brew ]]; then
        # Homebrew's libraries are not where the linker looks by itself.
        LIBRARY_PATH="$(brew --prefix)/lib${LIBRARY_PATH:+:$LIBRARY_PATH}"
        export LIBRARY_PATH
    fi
    for thing in "$@"; do
        have "$thing" || missing+=("$thing")
    done
    [[ ${#missing[@]} -gt 0 ]] || return 0
    if [[ -z "$manager" ]]; then
        die "missing: ${missing[*]}. This script knows apt-get, dnf, pacman, zypper and brew, and finds none of them." \
            "Please install a C and C++ compiler, the development files of SDL2, and for the tests Mesa's EGL and software renderer."
    fi
    for thing in "${missing[@]}"; do
        local names
        names="$(package_names "$manager" "$thing")"
        read -r -a names <<<"$names"
        packages+=("${names[@]}")
    done
    install_packages "$manager" "${packages[@]}"
    for thing in "${missing[@]}"; do
        have "$thing" || die "$thing is still not found after installing: ${packages[*]}"
    done
}

# need_rust [MANIFEST]: as new as a package wants it, this one's if none is named. Rust itself comes from rustup: the packaged
# compilers of most systems are too old.
need_rust() {
    local hint="get it from https://rustup.rs (curl --proto '=https' --tlsv1.2 -sSf https://sh.rustup.rs | sh)"
    if ! command -v cargo >/dev/null && [[ -f "$HOME/.cargo/env" ]]; then
        # shellcheck source=/dev/null
        source "$HOME/.cargo/env"
    fi
    command -v cargo >/dev/null || die "cargo, Rust's build tool, is missing: $hint"
    local wanted found
    wanted="$(sed -n 's/^rust-version *= *"\(.*\)"/\1/p' "${1:-Cargo.toml}")"
    found="$(cargo --version | cut -d ' ' -f 2)"
    if [[ "$(printf '%s\n' "$wanted" "$found" | sort -V | head -n 1)" != "$wanted" ]]; then
        die "cargo $found is too old, $wanted or newer is needed: run 'rustup update', or $hint"
    fi
}

# need_component NAME COMMAND: a part of Rust that minimal installations leave out.
need_component() {
    cargo "$2" --version >/dev/null 2>&1 && return
    command -v rustup >/dev/null || die "cargo $2 is missing: install the $1 package that belongs to your Rust"
    rustup component add "$1"
}

# with_rust VERSION COMMAND...: runs a command with a Rust of just that age: the usual one if it is, else rustup's.
with_rust() {
    local wanted="$1" toolchain
    shift
    if [[ "$(cargo --version)" == "cargo $wanted".* ]]; then
        "$@"
        return
    fi
    command -v rustup >/dev/null || die "Rust $wanted is needed for: $*. Get rustup from https://rustup.rs"
    toolchain="$(rustup toolchain list | sed -n "s/^\($wanted[.-][^ ]*\).*/\1/p" | head -n 1)"
    if [[ -z "$toolchain" ]]; then
        toolchain="$wanted"
        rustup toolchain install "$toolchain" --profile minimal --component clippy || die "no Rust $wanted for: $*"
    fi
    rustup run "$toolchain" "$@"
}

# What the checks of a script have come to.
report=()
failures=0

# step TITLE COMMAND...: runs a command; its failure is counted, and the next step runs all the same.
step() {
    local title="$1" start=$SECONDS verdict=ok
    shift
    say "$title: $*"
    "$@" || verdict=FAILED
    [[ $verdict == ok ]] || failures=$((failures + 1))
    report+=("$(printf '%-7s %4d s  %s' "$verdict" $((SECONDS - start)) "$title")")
}

# summary: says how each step went; fails if one did.
summary() {
    say "summary, after $SECONDS s"
    printf '%s\n' "${report[@]}"
    if [[ $failures -gt 0 ]]; then
        say "$failures of ${#report[@]} checks failed"
        exit 1
    fi
    say "all ${#report[@]} checks passed"
}
