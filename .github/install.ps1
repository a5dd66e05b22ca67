# Installs the command striata for the current user, on Windows:
#   irm https://github.com/striata/striata/releases/latest/download/install.ps1 | iex
# STRIATA_RELEASE is where the archives are, STRIATA_BIN the folder that the command goes to.
$ErrorActionPreference = "Stop"

$release = if ($env:STRIATA_RELEASE) { $env:STRIATA_RELEASE } else { "https://github.com/striata/striata/releases/latest/download" }
$bin = if ($env:STRIATA_BIN) { $env:STRIATA_BIN } else { Join-Path $env:LOCALAPPDATA "striata\bin" }
$processor = if ($env:PROCESSOR_ARCHITECTURE -eq "ARM64") { "aarch64" } else { "x86_64" }
$target = "$processor-pc-windows-msvc"
$archive = "striata-$target.tar.gz"

$folder = Join-Path ([IO.Path]::GetTempPath()) ([IO.Path]::GetRandomFileName())
New-Item -ItemType Directory $folder | Out-Null
try {
    Invoke-WebRequest "$release/$archive" -OutFile "$folder\$archive"
    Invoke-WebRequest "$release/SHA256SUMS" -OutFile "$folder\SHA256SUMS"
    $line = Get-Content "$folder\SHA256SUMS" | Where-Object { $_.EndsWith(" $archive") }
    if (-not $line) { throw "SHA256SUMS does not list $archive" }
    $found = (Get-FileHash "$folder\$archive" -Algorithm SHA256).Hash
    if ($found -ne $line.Split(" ")[0]) { throw "the checksum of $archive is wrong" }
    tar -xzf "$folder\$archive" -C $folder
    if ($LASTEXITCODE -ne 0) { throw "$archive cannot be unpacked" }
    New-Item -ItemType Directory -Force $bin | Out-Null
    Copy-Item "$folder\striata-$target\striata.exe" $bin -Force
} finally {
    Remove-Item -Recurse -Force $folder
}
Write-Output "installed $(& "$bin\striata.exe" --version) in $bin"
if (-not ($env:PATH -split ";" | Where-Object { $_ -eq $bin })) {
    Write-Output "add this folder to PATH: $bin"
}
