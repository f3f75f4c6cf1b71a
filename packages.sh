# What Debian 12 has to have, sourced by ./run and ./test.
#
# ensure_packages NAME...: installs those that are missing; without the right to, prints the line that does it
# and ends the script.

build_packages=(
    cmake g++ libbenchmark-dev libcli11-dev libegl-dev libepoxy-dev libfmt-dev libfontconfig-dev libglfw3-dev
    libglm-dev libimgui-dev libkissfft-dev libopenimageio-dev libstb-dev libtbb-dev ninja-build
    nlohmann-json3-dev pkg-config
)
window_packages=(fonts-dejavu-core libegl-mesa0 libgl1-mesa-dri)
test_packages=(
    doctest-dev imagemagick libpugixml-dev librsvg2-bin openimageio-tools x11-utils xauth xdotool xvfb
)

ensure_packages() {
    local missing=() name
    for name in "$@"; do
        if [ "$(dpkg-query -W -f='${db:Status-Status}' "$name" 2>/dev/null)" != installed ]; then
            missing+=("$name")
        fi
    done
    [ ${#missing[@]} -eq 0 ] && return

    local as_root=()
    if [ "$(id -u)" -ne 0 ]; then
        # -n: only where no password has to be typed, or where there is somebody to type it.
        if command -v sudo >/dev/null && { [ -t 0 ] || sudo -n true 2>/dev/null; }; then
            as_root=(sudo env DEBIAN_FRONTEND=noninteractive)
        else
            echo "Some packages are missing. As root, run this, then this script again:" >&2
            echo "apt-get install --no-install-recommends ${missing[*]}" >&2
            exit 1
        fi
    fi
    echo "Installing ${missing[*]}"
    export DEBIAN_FRONTEND=noninteractive
    "${as_root[@]}" apt-get update -q
    "${as_root[@]}" apt-get install -y -q --no-install-recommends "${missing[@]}"
}

# The compiler's results kept between builds, where ccache is there.
compiler_launcher() {
    if command -v ccache >/dev/null; then echo -DCMAKE_CXX_COMPILER_LAUNCHER=ccache; fi
}
