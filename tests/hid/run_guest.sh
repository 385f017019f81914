#!/usr/bin/env bash
# Boots a Linux kernel under QEMU, makes eye trackers there through /dev/uhid and reads them.
# Usage: run_guest.sh HID_PROBE UHID_TRACKER GUEST_EXIT WORK_FOLDER [SCENARIO...]
# Status 77: skipped, with the reason. The kernel is downloaded once into the work folder.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
probe=$1 tracker=$2 guest_exit=$3 work=$4
shift 4
scenarios=("$@")
((${#scenarios[@]})) || scenarios=(rate250 rate1000 replug blink garbage mute-mode mute-all denied two profile)

passed_status=67 # 2 * 33 + 1, see guest_init.sh
limit_seconds=300

skip() {
  echo "skipped: $*"
  exit 77
}

find_program() { command -v "$1" || true; }
qemu=$(find_program qemu-system-x86_64)
busybox=$(find_program busybox)
[[ $(uname -m) == x86_64 ]] || skip "the guest is x86-64 and runs this build's programs"
[[ -n $qemu ]] || skip "no qemu-system-x86_64 (package qemu-system-x86)"
[[ -n $busybox ]] || skip "no busybox (package busybox-static)"
if ldd "$busybox" >/dev/null 2>&1; then skip "busybox is not the static one (package busybox-static)"; fi

# The kernel package is unpacked, not installed: its modules are those of this guest alone.
kernel=$work/kernel
if [[ ! -f $kernel/complete ]]; then
  if ! command -v apt-get >/dev/null || ! command -v dpkg >/dev/null; then
    skip "no apt-get to get a kernel with"
  fi
  rm -rf "$kernel"
  mkdir -p "$kernel"
  package=$(apt-cache depends linux-image-cloud-amd64 2>/dev/null | sed -n 's/^ *Depends: *\(linux-image-[0-9]\S*\)$/\1/p' | head -1)
  [[ -n $package ]] || skip "no package linux-image-cloud-amd64 is known to apt (apt-get update)"
  (cd "$kernel" && apt-get download -q "$package") >"$work/download.log" 2>&1 ||
    skip "$package could not be downloaded: $(tail -1 "$work/download.log")"
  dpkg -x "$kernel"/*.deb "$kernel"
  rm -f "$kernel"/*.deb
  touch "$kernel/complete"
fi
image=$(find "$kernel/boot" -name 'vmlinuz-*' | head -1)

# The initial file system: busybox, three modules, the programs and the libraries they load.
root=$work/root
rm -rf "$root"
mkdir -p "$root"/{bin,dev,proc,sys,modules,tmp}
mkdir -p "$root/assets"
cp -r "$here/../../assets/trackers" "$root/assets/"
chmod 755 "$root"
cp "$busybox" "$root/bin/busybox"
for module in hid hid-generic uhid; do
  file=$(find "$kernel/lib/modules" -name "$module.ko" | head -1)
  [[ -n $file ]] || skip "the kernel package has no plain $module.ko"
  cp "$file" "$root/modules/"
done
for program in "$probe" "$tracker" "$guest_exit"; do
  cp "$program" "$root/bin/"
  while read -r library; do
    mkdir -p "$root$(dirname "$library")"
    cp -L "$library" "$root$library"
  done < <(ldd "$program" | grep -o '/[^ )]*')
done
cp "$here/guest_init.sh" "$root/init"
chmod 755 "$root/init"
printf '%s\n' "${scenarios[@]}" >"$root/scenarios"
(cd "$root" && find . | "$busybox" cpio -o -H newc 2>/dev/null) | gzip -1 >"$work/initrd.gz"

# TCG and not KVM: where /dev/kvm exists inside another guest, it may hang at boot. The timer check
# counts ticks against a busy loop, which fails where the machine is busy with other tests.
status=0
timeout "$limit_seconds" "$qemu" -accel tcg -smp 1 -m 512 -nodefaults -no-user-config -no-reboot \
  -display none -serial stdio -monitor none -device isa-debug-exit,iobase=0xf4,iosize=0x04 \
  -kernel "$image" -initrd "$work/initrd.gz" -append "console=ttyS0 quiet panic=-1 no_timer_check" \
  </dev/null || status=$?
if [[ $status -ne $passed_status ]]; then
  echo "hid.guest: FAILED (status $status)"
  exit 1
fi
echo "hid.guest: OK"
