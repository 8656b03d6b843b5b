#!/usr/bin/env bash
# The kernels for AVX-512 on a processor that has it: Bochs emulates one, Debian's kernel starts there (and so
# switches the registers on) and runs from memory
#   - the kernels of every machine against each other, operation by operation and in whole solves (unit tests),
#   - the golden hashes of double precision: three scenes in three steppers, 500 steps of five scenes.
# It shows bits, and that these kernels are what runs; of speed it shows nothing.
#   tests/emulated/run.sh BUILD...      (needs what `scripts/setup emulator` installs)
# The unit tests of all these builds are run, and the golden hashes of the first. EPODE_MINUTES: until it is stopped (90).
# EPODE_GOLDEN: a filter for other tests than all golden hashes.
set -euo pipefail
minutes="${EPODE_MINUTES:-90}"
golden="${EPODE_GOLDEN:-Determinism.gives_the_same_bits_on_every_compiler:*LongRuns*}"
builds=()
for build in "$@"; do builds+=("$(realpath "$build")"); done
work="${builds[0]}/emulated"
rm -rf "$work" && mkdir -p "$work"/{root/{bin,proc,dev,lib64},iso}
cd "$work"

# A Debian kernel as it is published, unpacked and not installed.
kernel=$(apt-cache depends linux-image-cloud-amd64 | sed -n 's/^ *Depends: \(linux-image-.*\)/\1/p')
apt-get download "$kernel" >/dev/null 2>&1
dpkg-deb --fsys-tarfile "$kernel"_*.deb | tar -x -C iso --strip-components=2 --wildcards './boot/vmlinuz-*'
mv iso/vmlinuz-* iso/linux

# The whole system: a shell, the tests and the libraries they are linked to.
cp /bin/busybox root/bin/
for i in "${!builds[@]}"; do cp "${builds[i]}/bin/unit_tests" "root/bin/unit_tests_$i"; done
cp "${builds[0]}/bin/physics_tests" root/bin/
ldd root/bin/*_tests* | grep -o '/[^ :]* ' | sort -u | while read -r library; do cp -L "$library" root/lib64/; done
cat >root/init <<INIT
#!/bin/busybox sh
/bin/busybox mount -t proc proc /proc
/bin/busybox grep -q avx512vl /proc/cpuinfo || echo "epode: this kernel sees no AVX-512"
export EPODE_KERNELS=avx512 EPODE_TEST_THREADS=1 LD_LIBRARY_PATH=/lib64
run() {
  echo "epode: \$*"
  "\$@" --gtest_color=no || failed=1
}
for tests in /bin/unit_tests_*; do
  run \$tests --gtest_filter='*Kernels.*:PackedRows.*:BlockCholesky.*'
done
run /bin/physics_tests --gtest_filter='$golden'
echo "epode: result \${failed:-0}"
/bin/busybox sleep 1
/bin/busybox poweroff -f
INIT
chmod +x root/init
(cd root && find . | cpio -o -H newc --quiet) >iso/initrd

# Bochs 2.7 tells a wrong size of the compacted state, so the kernel has to do without that.
cp /usr/lib/ISOLINUX/isolinux.bin /usr/lib/syslinux/modules/bios/ldlinux.c32 iso/
cat >iso/isolinux.cfg <<'BOOT'
default linux
label linux
 kernel linux
 append initrd=initrd console=ttyS0 quiet panic=-1 mitigations=off clearcpuid=xsaves,xsavec
BOOT
xorriso -as mkisofs -quiet -o system.iso -b isolinux.bin -c boot.cat -no-emul-boot -boot-load-size 4 -boot-info-table iso 2>/dev/null
cat >bochsrc <<'BOCHS'
cpu: model=corei7_skylake_x, ips=50000000
megs: 1024
romimage: file=/usr/share/bochs/BIOS-bochs-latest
vgaromimage: file=/usr/share/bochs/VGABIOS-lgpl-latest
plugin_ctrl: speaker=0, sb16=0, es1370=0, gameport=0, voodoo=0, usb_uhci=0, e1000=0
ata0-master: type=cdrom, path=system.iso, status=inserted
boot: cdrom
com1: enabled=1, mode=file, dev=serial.log
display_library: term
log: bochs.log
BOCHS
echo continue >commands  # Debian's Bochs starts in its debugger, and wants a terminal
TERM=vt100 timeout -k 5 "${minutes}m" script -qec 'bochs -q -f bochsrc -rc commands' /dev/null </dev/null >screen.log 2>&1 &
machine=$!
# (`script` sometimes misses that its child has ended.)
while kill -0 "$machine" 2>/dev/null && ! grep -q 'reboot: Power down' serial.log 2>/dev/null; do sleep 2; done
kill "$machine" 2>/dev/null || true

tr -d '\r' <serial.log | grep -v '^\[' >said.log || true
cat said.log
if grep -q 'no such kernels\|sees no AVX-512' said.log; then echo "emulated: AVX-512 was not used" >&2; exit 1; fi
grep -qx 'epode: result 0' said.log || { echo "emulated: a test failed, or $minutes minutes were not enough" >&2; exit 1; }
