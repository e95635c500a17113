# The Debian package holds what it should, and asks for what it needs: debian_package.sh BUILD_FOLDER
set -euo pipefail
command -v dpkg-shlibdeps >/dev/null || { echo "Skipped: dpkg-shlibdeps (dpkg-dev) is not installed."; exit 77; }
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT
(cd "$1" && cpack -G DEB -B "$place" >"$place/log" 2>&1) || { cat "$place/log"; exit 1; }

package=$(ls "$place"/glisson_*.deb)
failed=0
held=$(dpkg-deb --contents "$package")
for file in bin/glisson bin/glisson-cli share/glisson/resources/examples/tissue/experiment.json share/glisson/resources/devices/devices.json \
  share/glisson/resources/manual/{,de/,fr/,es/}01-start.md share/glisson/resources/manual/pictures/tour-resect.png \
  share/man/man1/glisson-cli.1.gz share/applications/io.glisson.Glisson.desktop share/metainfo/io.glisson.Glisson.metainfo.xml \
  share/mime/packages/io.glisson.Glisson.xml share/icons/hicolor/scalable/apps/io.glisson.Glisson.svg \
  share/bash-completion/completions/glisson-cli share/doc/glisson/copyright; do
  grep -q " ./usr/$file\$" <<<"$held" || { echo "The package lacks $file."; failed=1; }
done
! grep -E '\.(h|a)$' <<<"$held" || { echo "The package holds what is for developers."; failed=1; }
needed=$(dpkg-deb --field "$package" Depends)
for library in libvtk9.1 libqt6widgets6 libdcmtk17 libopenblas0-pthread libqt6svg6; do
  grep -q "$library" <<<"$needed" || { echo "The package does not ask for $library."; failed=1; }
done

# python3-glisson, where the package for Python was built.
[ -d "$1/python/glisson" ] || exit $failed
package=$(ls "$place"/python3-glisson_*.deb)
held=$(dpkg-deb --contents "$package")
for file in __init__.py __init__.pyi py.typed '_core\.cpython-.*\.so'; do
  grep -q " ./usr/lib/python3/dist-packages/glisson/$file\$" <<<"$held" || { echo "python3-glisson lacks $file."; failed=1; }
done
needed=$(dpkg-deb --field "$package" Depends)
for library in python3-numpy libvtk9.1 libdcmtk17 libopenblas0-pthread 'python3 (>= 3'; do
  grep -qF "$library" <<<"$needed" || { echo "python3-glisson does not ask for $library."; failed=1; }
done
! grep -q libqt6 <<<"$needed" || { echo "python3-glisson asks for Qt."; failed=1; }
exit $failed
