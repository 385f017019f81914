#!/bin/busybox sh
# shellcheck shell=dash
# The guest's first and only process: a bare system, the HID modules, then every scenario.
/bin/busybox --install -s /bin
export PATH=/bin
mount -t proc none /proc
mount -t sysfs none /sys
mount -t devtmpfs none /dev
for module in hid hid-generic uhid; do insmod /modules/$module.ko || guest_exit 2; done

# Values that guest_exit hands out: 33 passed, 3 failed. A panic ends QEMU with status 0.
failed=0
while read -r scenario; do
  hid_probe "$scenario" /bin/uhid_tracker </dev/null || failed=1
done </scenarios
if [ $failed = 0 ]; then guest_exit 33; fi
guest_exit 3
