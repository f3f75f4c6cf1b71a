# What ./run and ./test share: what Debian 12 has to have, and how a build begins.
#
# ensure_packages NAME...: installs those that are missing; where it may not or cannot, prints the line that does it
# and ends the script.
# configure PRESET: makes build/PRESET of this folder ready, once, and anew if the folder was moved since.
# configure PRESET FOLDER: the same of build/FOLDER, which another preset may have made.
# compilers_at_once: prints how many compilers may run at once.
# build_and_test PRESET [FOLDER]: builds it and runs its tests.

build_packages=(
    cmake g++ libcairo2-dev libcli11-dev libegl-dev libepoxy-dev libfmt-dev libfontconfig-dev libglfw3-dev
    libglm-dev libimgui-dev libjpeg62-turbo-dev libjxl-dev libkissfft-dev liblcms2-dev libopenimageio-dev
    libpng-dev libqpdf-dev libseccomp-dev libstb-dev libtbb-dev libtiff-dev libwebp-dev ninja-build
    nlohmann-json3-dev pkg-config zlib1g-dev
)
window_packages=(fonts-dejavu-core libegl-mesa0 libgl1-mesa-dri)
test_packages=(
    appstream clang-format doctest-dev imagemagick inkscape libjxl-tools libopenmpi-dev libpugixml-dev librsvg2-bin libtiff-tools libx11-dev
    libxml2-utils openimageio-tools openmpi-bin poppler-utils pybind11-dev python3-cssselect python3-dev python3-ezdxf python3-lxml python3-numpy
    python3-pil python3-pytest python3-tinycss2 x11-utils xauth xclip xdotool xvfb
)
compiler_packages=(clang libclang-rt-dev)
web_packages=(
    cmake emscripten imagemagick libfmt-dev libglm-dev libkissfft-dev libstb-dev ninja-build nlohmann-json3-dev nodejs
    xz-utils
)
web_test_packages=(chromium)

ensure_packages() {
    local missing=() name
    for name in "$@"; do
        if [ "$(dpkg-query -W -f='${db:Status-Status}' "$name" 2>/dev/null)" != installed ]; then
            missing+=("$name")
        fi
    done
    [ ${#missing[@]} -eq 0 ] && return

    # The lists first: a Debian that was just set up may have none. Where a source of them is broken, the others may do.
    local line="apt-get update; apt-get install -y --no-install-recommends ${missing[*]}"
    local as_root=()
    if [ "$(id -u)" -ne 0 ]; then
        # Only where no password has to be typed, or where there is somebody to type it.
        if command -v sudo >/dev/null && { sudo -n true 2>/dev/null || { [ -t 0 ] && sudo true; }; }; then
            as_root=(sudo)
        else
            echo "Some packages are missing. As root, run this, then this script again:" >&2
            echo "$line" >&2
            exit 1
        fi
    fi
    echo "Installing ${missing[*]}"
    if ! "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive sh -c "$line"; then
        echo "The packages could not be installed; apt says why above (often no network, or another apt at work)." >&2
        echo "Once that is mended, run this script again, or as root:" >&2
        echo "$line" >&2
        exit 1
    fi
}

configure() {
    local build=build/${2:-$1} launcher=() fresh=(--fresh)
    if [ -f "$build/build.ninja" ] && grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$(pwd -P)" "$build/CMakeCache.txt"; then
        [ $# -eq 1 ] && return
        fresh=()
    fi
    # Where ccache is there, the compiler's results are kept between builds.
    command -v ccache >/dev/null && launcher=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
    cmake "${fresh[@]}" --preset "$1" "${launcher[@]}"
}

# One a core, where there is the gigabyte for each that the largest files take; more, and small machines run out.
compilers_at_once() {
    awk -v cores="$(nproc)" '/^MemAvailable:/ { n = int($2 / 1e6); print n < 1 ? 1 : n < cores ? n : cores }' /proc/meminfo
}

build_and_test() {
    configure "$@"
    cmake --build --preset "$1" --parallel "$(compilers_at_once)"
    # One more than processors: those of the window often wait.
    ctest --preset "$1" --parallel "$(($(nproc) + 1))"
    # Each of these is a defect to mend.
    grep -h '^NEEDED A SECOND TRY' "build/${2:-$1}/Testing/Temporary/LastTest.log" || true
}
