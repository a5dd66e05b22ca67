#!/bin/sh
# Installs the command striata for the current user, on Linux and macOS:
#   curl -fsSL https://github.com/striata/striata/releases/latest/download/install.sh | sh
# STRIATA_RELEASE is where the archives are, STRIATA_BIN the folder that the command goes to.
set -eu

release="${STRIATA_RELEASE:-https://github.com/striata/striata/releases/latest/download}"
bin="${STRIATA_BIN:-$HOME/.local/bin}"

case "$(uname -m)" in
  x86_64 | amd64) processor=x86_64 ;;
  aarch64 | arm64) processor=aarch64 ;;
  *) echo "error: there is no binary for $(uname -m); use cargo install striata-cli" >&2; exit 1 ;;
esac
case "$(uname -s)" in
  Linux) target="$processor-unknown-linux-gnu" ;;
  Darwin) target="$processor-apple-darwin" ;;
  *) echo "error: there is no binary for $(uname -s); use cargo install striata-cli" >&2; exit 1 ;;
esac

folder="$(mktemp -d)"
trap 'rm -rf "$folder"' EXIT
archive="striata-$target.tar.gz"
curl -fsSL "$release/$archive" -o "$folder/$archive"
curl -fsSL "$release/SHA256SUMS" -o "$folder/SHA256SUMS"
(
  cd "$folder"
  grep -F " $archive" SHA256SUMS > sum
  if command -v sha256sum > /dev/null; then sha256sum -c sum > /dev/null; else shasum -a 256 -c sum > /dev/null; fi
  tar -xzf "$archive"
)
mkdir -p "$bin"
install -m 755 "$folder/striata-$target/striata" "$bin/striata"
echo "installed $("$bin/striata" --version) in $bin"
case ":$PATH:" in
  *":$bin:"*) ;;
  *) echo "add this folder to PATH: export PATH=\"$bin:\$PATH\"" ;;
esac
