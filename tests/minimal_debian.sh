# What tests/try_systems and tests/try_install share: fresh minimal Debian systems in folders of $systems, which is
# KEEP=FOLDER, or else a new one that is gone at the end. Sourced; ends the script where none can be made.
#
# enter SUITE: makes the system if it is not there, and mounts in it what programs need; its folder is then $root.
# inside COMMAND...: runs a command in it, with nothing of this system's environment.
# leave: takes apart what enter mounted.

[ "$(id -u)" -eq 0 ] || { echo "$0: only root can make a system in a folder" >&2; exit 1; }
command -v debootstrap >/dev/null || { echo "$0: needs the package debootstrap" >&2; exit 1; }

systems=${KEEP:-$(mktemp -d)}
mkdir -p "$systems"
mounted=()
leave() {
    local place
    for place in "${mounted[@]}"; do umount "$place" || true; done
    mounted=()
}
trap 'leave; [ -n "${KEEP:-}" ] || rm -rf --one-file-system "$systems"' EXIT

enter() {
    local place
    root=$systems/$1
    [ -f "$root/etc/debian_version" ] || debootstrap --variant=minbase "$1" "$root" >"$systems/$1.debootstrap.log"
    cp /etc/resolv.conf "$root/etc/resolv.conf"
    for place in proc sys dev dev/pts; do
        mount --bind "/$place" "$root/$place"
        mounted=("$root/$place" "${mounted[@]}")
    done
}

inside() {
    env -i PATH=/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LANG=C.UTF-8 DEBIAN_FRONTEND=noninteractive \
        ${http_proxy:+http_proxy="$http_proxy"} chroot "$root" "$@"
}
